//! The reference configuration: what of a body never changes while its particles move.

use super::links::Links;
use crate::error::{Error, require, require_length};
use nalgebra::{SMatrix, SVector};
use sph_kernel::operators::{moment, regularised_inverse};
use sph_kernel::{KernelKind, RowBuffer};

/// Columns of the unstressed body, borrowed from the caller.
#[derive(Clone, Copy, Debug)]
pub struct ReferenceColumns<'a, const D: usize> {
    /// Reference positions X \[m\].
    pub positions: &'a [SVector<f64, D>],
    /// Reference volumes V_0 \[m^D\].
    pub volumes: &'a [f64],
    /// Masses m \[kg; kg/m in plane strain\]: of an unstressed body V_0 rho_ref(T). They stay when a body that is under
    /// stress gets a new reference, where m/V_0 is the present density.
    pub masses: &'a [f64],
    /// Temperatures \[K\] at which the body has these positions.
    pub temperatures: &'a [f64],
    /// Smoothing lengths h \[m\]; a pair takes the mean of its two.
    pub smoothing_lengths: &'a [f64],
    /// Where each particle's row starts in `list_neighbors`; one entry more than particles.
    pub list_starts: &'a [usize],
    /// All rows one after the other; every pair in both of its rows, no particle in its own.
    pub list_neighbors: &'a [u32],
}

impl<const D: usize> ReferenceColumns<'_, D> {
    fn check(&self) -> Result<(), Error> {
        let particles = self.positions.len();
        require_length("volumes", self.volumes.len(), particles)?;
        require_length("masses", self.masses.len(), particles)?;
        require_length("temperatures", self.temperatures.len(), particles)?;
        require_length("smoothing_lengths", self.smoothing_lengths.len(), particles)?;
        require_length("list_starts", self.list_starts.len(), particles + 1)?;
        require_length("list_neighbors", self.list_neighbors.len(), self.list_starts[particles])?;
        for i in 0..particles {
            require(self.volumes[i] > 0.0, "a volume", self.volumes[i], "positive")?;
            require(self.masses[i] > 0.0, "a mass", self.masses[i], "positive")?;
            let length = self.smoothing_lengths[i];
            require(length > 0.0, "a smoothing length", length, "positive, in metres")?;
            self.check_row(i)?;
        }
        Ok(())
    }

    fn check_row(&self, particle: usize) -> Result<(), Error> {
        let wrong = |reason| Err(Error::List { particle, reason });
        if self.list_starts[particle] > self.list_starts[particle + 1] {
            return wrong("ends before it starts");
        }
        for &neighbor in self.row(particle) {
            let other = neighbor as usize;
            if other >= self.positions.len() {
                return wrong("names a particle that does not exist");
            }
            if other == particle {
                return wrong("names the particle itself");
            }
            let mutual = self.list_starts[other] <= self.list_starts[other + 1]
                && holds(self.row(other), particle as u32);
            if !mutual {
                return wrong("holds a pair that stands in one of its two rows only");
            }
        }
        Ok(())
    }

    fn row(&self, particle: usize) -> &[u32] {
        &self.list_neighbors[self.list_starts[particle]..self.list_starts[particle + 1]]
    }
}

/// Whether a row, usually an ascending one, names a particle.
fn holds(row: &[u32], particle: u32) -> bool {
    row.binary_search(&particle).is_ok() || row.contains(&particle)
}

/// Fixed pairs and corrections of a body.
#[derive(Clone, Debug)]
pub(crate) struct Reference<const D: usize> {
    pub links: Links,
    /// B_i \[-\].
    pub corrections: Vec<SMatrix<f64, D, D>>,
    /// 1/V_i \[m^-D\].
    pub inverse_volumes: Vec<f64>,
    /// h_i \[m\].
    pub smoothing_lengths: Vec<f64>,
}

impl<const D: usize> Reference<D> {
    pub fn new(columns: &ReferenceColumns<'_, D>, kernel: KernelKind) -> Result<Self, Error> {
        columns.check()?;
        let particles = columns.positions.len();
        let mut links = Links::new(0, particles);
        let mut corrections = Vec::with_capacity(particles);
        let mut buffer = RowBuffer::default();
        for i in 0..particles {
            let row = buffer.fill_with_mean_lengths(
                i,
                columns.row(i),
                columns.positions,
                columns.smoothing_lengths,
                kernel,
            );
            corrections.push(regularised_inverse(&moment(&row, columns.volumes)));
            links.push(&row, columns.volumes);
        }
        let inverse_volumes = columns.volumes.iter().map(|volume| 1.0 / volume).collect();
        let smoothing_lengths = columns.smoothing_lengths.to_vec();
        Ok(Self { links, corrections, inverse_volumes, smoothing_lengths })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector2;

    fn refusal(starts: &[usize], neighbors: &[u32], volumes: &[f64]) -> String {
        let positions = [Vector2::new(0.0, 0.0), Vector2::new(1.0, 0.0)];
        let columns = ReferenceColumns {
            positions: &positions,
            volumes,
            masses: &[1.0; 2],
            temperatures: &[293.0; 2],
            smoothing_lengths: &[1.0; 2],
            list_starts: starts,
            list_neighbors: neighbors,
        };
        Reference::new(&columns, KernelKind::WendlandC2).unwrap_err().to_string()
    }

    #[test]
    fn bad_columns_are_named() {
        assert_eq!(refusal(&[0, 1, 2], &[1, 0], &[1.0]), "volumes has 1 entries, but 2 are needed");
        assert_eq!(refusal(&[0, 1, 2], &[1, 0], &[1.0, 0.0]), "a volume is 0, but must be positive");
        let row = "the neighbour list of particle ";
        assert_eq!(
            refusal(&[0, 1, 2], &[2, 0], &[1.0; 2]),
            format!("{row}0 names a particle that does not exist")
        );
        assert_eq!(refusal(&[0, 1, 2], &[0, 0], &[1.0; 2]), format!("{row}0 names the particle itself"));
        let once = format!("{row}0 holds a pair that stands in one of its two rows only");
        assert_eq!(refusal(&[0, 1, 1], &[1], &[1.0; 2]), once);
    }
}
