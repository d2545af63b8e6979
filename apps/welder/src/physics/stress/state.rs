//! What changes in a stressed body, and its place in a checkpoint.

use crate::physics::Cost;
use nalgebra::{Matrix3, Vector3};
use serde::{Deserialize, Serialize};
use sph_solid::SymmetricTensor;

/// Motion and inelastic strain; columns of particles and copies, velocities of particles alone.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct State {
    /// Displacements from the start \[m\].
    pub displacements: Vec<Vector3<f64>>,
    /// Velocities \[m/s\].
    pub velocities: Vec<Vector3<f64>>,
    /// Plastic strains \[-\].
    pub strains: Vec<SymmetricTensor<3>>,
    /// Equivalent plastic strains \[-\].
    pub equivalents: Vec<f64>,
    /// Temperatures at the end of the last step \[K\].
    pub temperatures: Vec<f64>,
    /// tr(sigma) of particles at the end of the last step \[Pa\]; empty where deformation makes no heat.
    pub traces: Vec<f64>,
    /// Heat that deformation has made so far \[J\].
    pub deformed: f64,
    /// Work so far.
    pub cost: Cost,
}

/// The state in numbers.
#[derive(Serialize, Deserialize)]
struct Saved {
    displacements: Vec<[f64; 3]>,
    velocities: Vec<[f64; 3]>,
    strains: Vec<[f64; 9]>,
    equivalents: Vec<f64>,
    temperatures: Vec<f64>,
    accelerations: Vec<[f64; 3]>,
    traces: Vec<f64>,
    deformed: f64,
    cost: Cost,
}

impl State {
    /// `owned` particles of `count` with copies, at rest and without strain.
    pub fn at_rest(owned: usize, count: usize, temperatures: Vec<f64>) -> Self {
        Self {
            displacements: vec![Vector3::zeros(); count],
            velocities: vec![Vector3::zeros(); owned],
            strains: vec![SymmetricTensor::zero(); count],
            equivalents: vec![0.0; count],
            temperatures,
            traces: Vec::new(),
            deformed: 0.0,
            cost: Cost::default(),
        }
    }

    /// Bytes for a checkpoint, with the accelerations of the moment.
    pub fn save(&self, accelerations: &[Vector3<f64>]) -> Vec<u8> {
        let arrays = |column: &[Vector3<f64>]| column.iter().map(|&vector| vector.into()).collect();
        let numbers = |strain: &SymmetricTensor<3>| std::array::from_fn(|k| strain.in_plane[k]);
        let saved = Saved {
            displacements: arrays(&self.displacements),
            velocities: arrays(&self.velocities),
            strains: self.strains.iter().map(numbers).collect(),
            equivalents: self.equivalents.clone(),
            temperatures: self.temperatures.clone(),
            accelerations: arrays(accelerations),
            traces: self.traces.clone(),
            deformed: self.deformed,
            cost: self.cost,
        };
        postcard::to_stdvec(&saved).expect("numbers and columns always serialise")
    }

    /// State and accelerations that [`save`](Self::save) gave, of the same particles as `like`.
    ///
    /// # Errors
    /// A message when the bytes are of no such state.
    pub fn restore(saved: &[u8], like: &Self) -> Result<(Self, Vec<Vector3<f64>>), String> {
        let saved: Saved = postcard::from_bytes(saved).map_err(|error| format!("stress: {error}"))?;
        let vectors = |column: Vec<[f64; 3]>| column.into_iter().map(Vector3::from).collect::<Vec<_>>();
        let strain = |numbers: [f64; 9]| SymmetricTensor {
            in_plane: Matrix3::from_column_slice(&numbers),
            out_of_plane: 0.0,
        };
        let accelerations = vectors(saved.accelerations);
        let state = Self {
            displacements: vectors(saved.displacements),
            velocities: vectors(saved.velocities),
            strains: saved.strains.into_iter().map(strain).collect(),
            equivalents: saved.equivalents,
            temperatures: saved.temperatures,
            traces: saved.traces,
            deformed: saved.deformed,
            cost: saved.cost,
        };
        let (count, owned) = (like.displacements.len(), like.velocities.len());
        let fits = [
            state.displacements.len() == count,
            state.velocities.len() == owned,
            state.strains.len() == count,
            state.equivalents.len() == count,
            state.temperatures.len() == count,
            accelerations.len() == count,
            state.traces.len() == like.traces.len(),
        ];
        if fits.contains(&false) {
            return Err(format!(
                "stress: it is of {} particles; the case has {owned}",
                state.velocities.len()
            ));
        }
        Ok((state, accelerations))
    }
}
