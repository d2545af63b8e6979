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

/// Residual to which the weights are fitted; linear fields across a jump are exact to about this. A tenth of it takes
/// seven times the iterations and moves the sizes of a pool by 0.03 %.
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
    let outside = image_reach(support, ratio, workpiece.disorder);
    let farthest: Vec<f64> = particles.spacing.iter().map(|spacing| outside * spacing).collect();
    let images = Images::new(&particles.position, &farthest, &planes(workpiece.low, workpiece.high, faces));
    let mut everything = particles.position.clone();
    everything.extend_from_slice(&images.position);
    let mut reach: Vec<f64> = particles.spacing.iter().map(reach_of).collect();
    reach.extend(images.source.iter().map(|&source| reach_of(&particles.spacing[source as usize])));
    let rule = if ratio < NARROW { PairReach::Maximum(&reach) } else { PairReach::Mean(&reach) };
    let list = SearchMethod::default().find(&everything, rule)?;
    let length = |i: usize, j: usize| ratio * pair_spacing(ratio, particles.spacing[i], particles.spacing[j]);
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

/// The spacing that the smoothing length of a pair goes by.
fn pair_spacing(ratio: f64, own: f64, other: f64) -> f64 {
    if ratio < NARROW { own.max(other) } else { 0.5 * (own + other) }
}

/// How far outside a face, in its own spacings, an image can stand and still be a neighbour of a particle inside.
///
/// A particle of spacing f stands at least half of it, less the disorder, inside the face. Spacings jump by two, and a
/// level has two layers of its own: one of four times the spacing is at least 6.5 spacings away, less both disorders.
fn image_reach(support: f64, ratio: f64, disorder: f64) -> f64 {
    let reach = |f: f64| support * pair_spacing(ratio, 1.0, f);
    let near =
        [0.25, 0.5, 1.0, 2.0, 4.0].into_iter().filter(|&f| f <= 2.0 || reach(f) > 6.5 - 5.0 * disorder);
    near.map(|f| reach(f) - (0.5 - disorder).max(0.0) * f).fold(0.0, f64::max)
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
