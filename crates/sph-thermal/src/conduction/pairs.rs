//! Every pair of a body at rest, images included, with its base weight w = -2 V_i V_j f_ij.

use super::fit::{FitReport, fitted_weights};
use super::{ConductionRows, Images};
use crate::error::Error;
use nalgebra::SVector;

/// Pairs of particles at rest, a row a particle, with mirrored images as entries of their own.
#[derive(Debug, Clone)]
pub struct PairTable<'a, const D: usize> {
    /// Start of each particle's row in the entry columns; one longer than there are particles.
    pub(crate) starts: Vec<usize>,
    /// The particle at the other end (an image's source).
    pub(crate) other: Vec<u32>,
    /// The image at the other end, or [`NO_IMAGE`].
    pub(crate) image: Vec<u32>,
    /// r_i - r_j \[m\].
    pub(crate) separation: Vec<SVector<f64, D>>,
    /// Base weight \[m\] (2-D: a number).
    pub(crate) weight: Vec<f64>,
    pub(crate) volume: &'a [f64],
    pub(crate) images: &'a Images<D>,
}

/// Marks an entry whose other end is a particle, not an image.
pub(crate) const NO_IMAGE: u32 = u32::MAX;

impl<'a, const D: usize> PairTable<'a, D> {
    /// Collects the pairs from neighbour rows over particles followed by images.
    ///
    /// `positions` \[m\] and `volume` (\[m³\], 2-D: \[m²\]) are columns of the particles; `row(i)` gives the
    /// neighbours of particle i as indices into particles followed by `images` (the order in which they were searched);
    /// `gradient_factor(i, j, distance)` is f = W'(r)/r of the pair's kernel, j being a particle (an image's source).
    ///
    /// # Errors
    /// [`Error::Length`] when the columns differ in length.
    pub fn new<'r>(
        positions: &[SVector<f64, D>],
        volume: &'a [f64],
        images: &'a Images<D>,
        row: impl Fn(usize) -> &'r [u32],
        gradient_factor: impl Fn(usize, usize, f64) -> f64,
    ) -> Result<Self, Error> {
        let particles = positions.len();
        if volume.len() != particles {
            return Err(Error::Length { what: "volume", found: volume.len(), expected: particles });
        }
        let expected = (0..particles).map(|i| row(i).len()).sum();
        let mut table = Self {
            starts: Vec::with_capacity(particles + 1),
            other: Vec::with_capacity(expected),
            image: Vec::with_capacity(expected),
            separation: Vec::with_capacity(expected),
            weight: Vec::with_capacity(expected),
            volume,
            images,
        };
        table.starts.push(0);
        for i in 0..particles {
            for &end in row(i) {
                let (other, image, position) = match (end as usize).checked_sub(particles) {
                    None => (end, NO_IMAGE, positions[end as usize]),
                    Some(k) if !images.is_seen(k, i) => continue,
                    Some(k) => (images.source[k], k as u32, images.position[k]),
                };
                let separation = positions[i] - position;
                let factor = gradient_factor(i, other as usize, separation.norm());
                if factor < 0.0 {
                    table.other.push(other);
                    table.image.push(image);
                    table.separation.push(separation);
                    table.weight.push(-2.0 * volume[i] * volume[other as usize] * factor);
                }
            }
            table.starts.push(table.other.len());
        }
        Ok(table)
    }

    /// Number of particles.
    pub fn particles(&self) -> usize {
        self.volume.len()
    }

    /// Number of entries, images counted.
    pub fn entries(&self) -> usize {
        self.other.len()
    }

    /// M_i = sum_j w_ij r_ij² / (2 D V_i): one where the plain sum has the exact second moment.
    pub fn moments(&self) -> Vec<f64> {
        let row = |i: usize| self.starts[i]..self.starts[i + 1];
        let second = |i| row(i).map(|e| self.weight[e] * self.separation[e].norm_squared()).sum::<f64>();
        (0..self.particles()).map(|i| second(i) / (2.0 * D as f64 * self.volume[i])).collect()
    }

    /// Rows with the base weights as they are (Cleary and Monaghan 1999): for comparison.
    pub fn plain(&self) -> ConductionRows {
        ConductionRows::fold(self, &self.weight)
    }

    /// Rows with g = w (1/M_i + 1/M_j)/2: second order on a lattice with images, any kernel.
    pub fn normalized(&self) -> ConductionRows {
        self.normalized_by(&self.moments())
    }

    /// The same with the moments M that are given, one a particle: where some of the particles have neighbours that are not in
    /// the table.
    pub fn normalized_by(&self, moments: &[f64]) -> ConductionRows {
        let mut weights = self.weight.clone();
        for i in 0..self.particles() {
            for e in self.starts[i]..self.starts[i + 1] {
                weights[e] *= 0.5 * (1.0 / moments[i] + 1.0 / moments[self.other[e] as usize]);
            }
        }
        ConductionRows::fold(self, &weights)
    }

    /// Rows with fitted weights: linear fields exact, also where particle sizes jump (see [`fitted_weights`]).
    ///
    /// # Errors
    /// [`Error::FitDidNotConverge`] when the system stalls above `tolerance`.
    pub fn fitted(&self, tolerance: f64) -> Result<(ConductionRows, FitReport), Error> {
        let (weights, report) = fitted_weights(self, tolerance)?;
        Ok((ConductionRows::fold(self, &weights), report))
    }
}
