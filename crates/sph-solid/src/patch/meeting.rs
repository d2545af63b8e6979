//! Contact of the particles of a patch in the total-Lagrangian form.

use super::FindNeighbors;
use crate::Contact;
use nalgebra::SVector;

/// Particles nearer than this many spacings in the reference are one material: only stress acts between them, however much
/// they are compressed.
const ONE_MATERIAL: f64 = 4.0;

/// Room of the list over a spacing, in spacings.
const SKIN: f64 = 1.0;

/// Which particles may meet, and how they push each other.
///
/// Pairs stand in ascending order and those that do not touch add nothing: forces do not depend on when the list was made.
#[derive(Debug)]
pub(super) struct Meeting<const D: usize> {
    law: Contact,
    find: FindNeighbors<D>,
    pairs: Vec<[u32; 2]>,
    /// Positions when the list was made.
    listed: Vec<SVector<f64, D>>,
}

impl<const D: usize> Meeting<D> {
    pub fn new(law: Contact, find: FindNeighbors<D>) -> Self {
        Self { law, find, pairs: Vec::new(), listed: Vec::new() }
    }

    /// Adds what contact gives to the accelerations of particles now at `places`.
    pub fn accelerate(
        &mut self,
        places: &[SVector<f64, D>],
        reference: &[SVector<f64, D>],
        masses: &[f64],
        accelerations: &mut [SVector<f64, D>],
    ) {
        self.renew(places, reference);
        for [i, j] in self.touching() {
            let force = self.law.force(&(places[i] - places[j]));
            accelerations[i] += force / masses[i];
            accelerations[j] -= force / masses[j];
        }
    }

    /// Energy of all pairs at the places of the last call of [`Meeting::accelerate`] \[J; J/m in plane strain\].
    pub fn energy(&self, places: &[SVector<f64, D>]) -> f64 {
        self.touching().map(|[i, j]| self.law.energy::<D>((places[i] - places[j]).norm())).sum()
    }

    fn touching(&self) -> impl Iterator<Item = [usize; 2]> {
        self.pairs.iter().map(|pair| pair.map(|index| index as usize))
    }

    fn renew(&mut self, places: &[SVector<f64, D>], reference: &[SVector<f64, D>]) {
        let spacing = self.law.spacing;
        let near =
            |(now, then): (&SVector<f64, D>, &SVector<f64, D>)| (now - then).norm() < 0.5 * SKIN * spacing;
        if self.listed.len() == places.len() && places.iter().zip(&self.listed).all(near) {
            return;
        }
        let (starts, neighbors) = (self.find)(places, (1.0 + SKIN) * spacing);
        let apart = |i: usize, j: usize| (reference[i] - reference[j]).norm() > ONE_MATERIAL * spacing;
        self.pairs.clear();
        for i in 0..places.len() {
            let row = neighbors[starts[i]..starts[i + 1]].iter().copied();
            let later = row.filter(|&j| j as usize > i && apart(i, j as usize));
            self.pairs.extend(later.map(|j| [i as u32, j]));
        }
        self.listed.clear();
        self.listed.extend_from_slice(places);
    }
}
