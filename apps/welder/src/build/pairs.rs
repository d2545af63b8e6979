//! Pairs and conduction weights of a workpiece at rest.

use super::{Workpiece, planes};
use crate::case::scene::{Faces, Weights};
use crate::model::ModelError;
use sph_kernel::{Kernel, KernelKind};
use sph_neighbors::{PairReach, SearchMethod};
use sph_thermal::conduction::{ConductionRows, FitReport, Images, PairTable};

/// Below this ratio of smoothing length to spacing, a pair of unlike sizes takes the larger one's length: with the mean
/// of both, narrow kernels would not reach across a jump of spacing.
const NARROW: f64 = 0.85;

/// Residual to which the weights are fitted; linear fields across a jump are exact to about this. Spots are the same with
/// 1e-4 to 0.1 %, but that takes 3 to 20 times the iterations where the cells across the part are odd in number.
const FIT_TOLERANCE: f64 = 1e-3;

/// What the set-up of the pairs found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairReport {
    /// Smoothing length over spacing.
    pub smoothing_ratio: f64,
    /// How the fit went, where there was one.
    pub fit: Option<FitReport>,
}

/// Conduction rows of `workpiece` with the weights of the scene.
///
/// `Auto` weights are fitted ones; an open `smoothing_ratio` is the default of `weights` and disorder: the cheapest that
/// holds its error (see the book's chapter on work and precision).
///
/// # Errors
/// [`ModelError`] when the neighbour search or the fit refuses the particles.
pub fn conduction_rows(
    workpiece: &Workpiece,
    faces: &Faces,
    weights: Weights,
    kernel: KernelKind,
    smoothing_ratio: Option<f64>,
) -> Result<(ConductionRows, PairReport), ModelError> {
    let ratio = smoothing_ratio.unwrap_or_else(|| default_ratio(weights, workpiece.disorder));
    let particles = &workpiece.particles;
    let support = Kernel::<3>::support_radius(kernel, 1.0) * ratio;
    let reach_of = |spacing: &f64| support * spacing;
    let widest: Vec<f64> = particles.spacing.iter().map(|spacing| 2.0 * reach_of(spacing)).collect();
    let images = Images::new(&particles.position, &widest, &planes(workpiece.low, workpiece.high, faces));
    let mut everything = particles.position.clone();
    everything.extend_from_slice(&images.position);
    let mut reach: Vec<f64> = particles.spacing.iter().map(reach_of).collect();
    reach.extend(images.source.iter().map(|&source| reach_of(&particles.spacing[source as usize])));
    let rule = if ratio < NARROW { PairReach::Maximum(&reach) } else { PairReach::Mean(&reach) };
    let list = SearchMethod::default().find(&everything, rule)?;
    let length = |i: usize, j: usize| {
        let (own, other) = (particles.spacing[i], particles.spacing[j]);
        ratio * if ratio < NARROW { own.max(other) } else { 0.5 * (own + other) }
    };
    let factor = |i: usize, j: usize, r: f64| Kernel::<3>::gradient_factor(kernel, r, length(i, j));
    let pairs = PairTable::new(&particles.position, &particles.volume, &images, |i| list.row(i), factor)?;
    let (rows, fit) = match weights {
        Weights::Plain => (pairs.plain(), None),
        Weights::Normalized => (pairs.normalized(), None),
        Weights::Auto | Weights::Fitted => {
            let (rows, report) = pairs.fitted(FIT_TOLERANCE)?;
            (rows, Some(report))
        }
    };
    Ok((rows, PairReport { smoothing_ratio: ratio, fit }))
}

/// On a lattice the narrowest fit is best and cheapest; it breaks from 5 % disorder on, where 27 pairs hold.
/// Weights without a fit need about 70 pairs unless the particles are on a lattice.
fn default_ratio(weights: Weights, disorder: f64) -> f64 {
    match (weights, disorder > 0.0) {
        (Weights::Auto | Weights::Fitted, false) => 0.7,
        (Weights::Auto | Weights::Fitted, true) => 1.0,
        (Weights::Normalized, false) => 1.0,
        (Weights::Normalized | Weights::Plain, _) => 1.3,
    }
}
