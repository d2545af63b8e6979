//! Pairs and conduction weights of a workpiece at rest.

use super::{Workpiece, planes};
use crate::case::scene::{Face, Faces, Weights};
use crate::model::ModelError;
use nalgebra::Vector3;
use sph_kernel::{Kernel, KernelKind};
use sph_neighbors::{NeighborList, PairReach, Parts, SearchMethod};
use sph_thermal::conduction::{ConductionRows, FitReport, Images, PairTable, Planes};

/// Below this ratio of smoothing length to spacing, a pair of unlike sizes takes the larger one's length: with the mean
/// of both, narrow kernels would not reach across a jump of spacing.
const NARROW: f64 = 0.85;

/// Residual to which the weights are fitted; linear fields across a jump are exact to about this. A tenth of it takes
/// 3 to 20 times the iterations and moves the sizes of a pool by less than 0.1 %.
const FIT_TOLERANCE: f64 = 1e-3;

/// What the set-up of the pairs found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairReport {
    /// Smoothing length over spacing.
    pub smoothing_ratio: f64,
    /// How the fit went, where there was one.
    pub fit: Option<FitReport>,
}

/// Some particles of a workpiece, numbered from zero in rising order.
#[derive(Debug, Clone)]
pub struct Members {
    indices: Vec<u32>,
    /// The number of each particle of the workpiece among them; [`NOBODY`] of the others.
    numbers: Vec<u32>,
}

/// A number that no member has.
const NOBODY: u32 = u32::MAX;

impl Members {
    /// All `count` particles.
    pub fn all(count: usize) -> Self {
        let indices: Vec<u32> = (0..count as u32).collect();
        Self { numbers: indices.clone(), indices }
    }

    /// Those in the box from `low` to `high` \[m\].
    pub fn within(positions: &[Vector3<f64>], low: Vector3<f64>, high: Vector3<f64>) -> Self {
        let inside = |x: &Vector3<f64>| (0..3).all(|axis| x[axis] >= low[axis] && x[axis] <= high[axis]);
        let indices: Vec<u32> =
            (0..positions.len() as u32).filter(|&i| inside(&positions[i as usize])).collect();
        let mut numbers = vec![NOBODY; positions.len()];
        for (number, &i) in indices.iter().enumerate() {
            numbers[i as usize] = number as u32;
        }
        Self { indices, numbers }
    }

    /// Their indices in the workpiece.
    pub fn indices(&self) -> &[u32] {
        &self.indices
    }

    /// How many they are.
    pub fn len(&self) -> usize {
        self.indices.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.indices.is_empty()
    }

    /// The number among them of a particle of the workpiece.
    pub fn find(&self, particle: usize) -> Option<usize> {
        let number = self.numbers[particle];
        (number != NOBODY).then_some(number as usize)
    }

    /// Their entries of a column.
    pub fn gather<T: Copy>(&self, column: &[T]) -> Vec<T> {
        self.indices.iter().map(|&i| column[i as usize]).collect()
    }
}

/// Who is near whom among some particles of a workpiece, mirror images included.
pub struct Neighborhood {
    /// Positions of the particles, then of the images \[m\].
    pub positions: Vec<Vector3<f64>>,
    /// Neighbours among them.
    pub list: NeighborList,
    /// What each image mirrors.
    pub images: Images<3>,
    /// Smoothing length over spacing.
    pub ratio: f64,
}

impl Neighborhood {
    /// Finds the neighbours for the weights of a scene.
    ///
    /// # Errors
    /// [`ModelError`] when the neighbour search refuses the particles.
    pub fn new(
        workpiece: &Workpiece,
        planes: &Planes<3>,
        members: &Members,
        kernel: KernelKind,
        ratio: f64,
    ) -> Result<Self, ModelError> {
        let support = Kernel::<3>::support_radius(kernel, 1.0) * ratio;
        let spacings = members.gather(&workpiece.particles.spacing);
        let outside = image_reach(support, ratio, workpiece.disorder);
        let farthest: Vec<f64> = spacings.iter().map(|spacing| outside * spacing).collect();
        let mut positions = members.gather(&workpiece.particles.position);
        let images = Images::new(&positions, &farthest, planes);
        positions.extend_from_slice(&images.position);
        let mut reach: Vec<f64> = spacings.iter().map(|spacing| support * spacing).collect();
        reach.extend(images.source.iter().map(|&source| support * spacings[source as usize]));
        let rule = if ratio < NARROW { PairReach::Maximum(&reach) } else { PairReach::Mean(&reach) };
        let parts = Parts { owned: members.len(), copies: images.len() };
        let list = SearchMethod::default().find_for(&positions, rule, parts)?;
        Ok(Self { positions, list, images, ratio })
    }

    /// Neighbours of one of them; an image that it sees counts as its source.
    pub fn row(&self, member: usize) -> impl Iterator<Item = usize> + '_ {
        let owned = self.positions.len() - self.images.len();
        self.list.row(member).iter().filter_map(move |&end| match (end as usize).checked_sub(owned) {
            None => Some(end as usize),
            Some(image) => self.images.is_seen(image, member).then(|| self.images.source[image] as usize),
        })
    }
}

/// The pairs of a neighbourhood with their base weights; `volumes` \[m³\] are the members'.
///
/// # Errors
/// [`ModelError`] when the columns differ in length.
pub fn pair_table<'a>(
    workpiece: &Workpiece,
    members: &Members,
    neighborhood: &'a Neighborhood,
    volumes: &'a [f64],
    kernel: KernelKind,
) -> Result<PairTable<'a, 3>, ModelError> {
    let Neighborhood { positions, list, images, ratio } = neighborhood;
    let spacing = |i: usize| workpiece.particles.spacing[members.indices[i] as usize];
    let length = |i: usize, j: usize| ratio * pair_spacing(*ratio, spacing(i), spacing(j));
    let factor = |i: usize, j: usize, r: f64| Kernel::<3>::gradient_factor(kernel, r, length(i, j));
    Ok(PairTable::new(&positions[..members.len()], volumes, images, |i| list.row(i), factor)?)
}

/// Conduction rows with the weights of the scene; `Auto` weights are fitted ones.
///
/// # Errors
/// [`ModelError`] when the fit refuses the particles.
pub fn conduction_rows(
    pairs: &PairTable<'_, 3>,
    ratio: f64,
    weights: Weights,
) -> Result<(ConductionRows, PairReport), ModelError> {
    let (rows, fit) = match weights {
        Weights::Plain => (pairs.plain(), None),
        Weights::Normalized | Weights::Moving => (pairs.normalized(), None),
        Weights::Auto | Weights::Fitted => {
            let (rows, report) = pairs.fitted(FIT_TOLERANCE)?;
            (rows, Some(report))
        }
    };
    Ok((rows, PairReport { smoothing_ratio: ratio, fit }))
}

/// The planes that particles are mirrored in.
///
/// The plain sum of Cleary and Monaghan (1999) ends at a free face, so that particles there miss half their neighbours;
/// symmetry planes and faces of fixed temperature mirror for it too, because they have no other form.
pub fn mirrors(workpiece: &Workpiece, faces: &Faces, weights: Weights) -> Planes<3> {
    let mut planes = planes(workpiece.low, workpiece.high, faces);
    if weights == Weights::Plain {
        for (parity, (_, face)) in planes.parity.as_flattened_mut().iter_mut().zip(faces.named()) {
            if !matches!(face, Face::Symmetry | Face::FixedTemperature { .. }) {
                *parity = None;
            }
        }
    }
    planes
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

/// Smoothing length over spacing of a scene that names none: the cheapest that holds its error with these weights and this
/// disorder (see the book's chapter on performance).
///
/// On a lattice the narrowest fit is best and cheapest; it breaks from 5 % disorder on, where 27 pairs hold.
/// Weights without a fit need about 70 pairs unless the particles are on a lattice.
pub fn default_ratio(weights: Weights, disorder: f64) -> f64 {
    match (weights, disorder > 0.0) {
        (Weights::Auto | Weights::Fitted, false) => 0.7,
        (Weights::Auto | Weights::Fitted, true) => 1.0,
        (Weights::Normalized, false) => 1.0,
        (Weights::Normalized | Weights::Plain | Weights::Moving, _) => 1.3,
    }
}
