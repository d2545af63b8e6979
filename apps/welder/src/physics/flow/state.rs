//! What changes in a melt, and its place in a checkpoint.

use crate::physics::{Cost, Work};
use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

/// Columns of all particles of the scene; those that have not melted stand still.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct State {
    /// Who flows.
    pub molten: Vec<bool>,
    /// Velocities \[m/s\].
    pub velocities: Vec<Vector3<f64>>,
    /// Densities of the weakly compressible melt \[kg/m³\].
    pub densities: Vec<f64>,
    /// Temperatures that the melt last had \[K\]: those that its energy of compression is of.
    pub temperatures: Vec<f64>,
    /// Pressures at the last step; zero where nothing flows \[Pa\].
    pub pressures: Vec<f64>,
    /// Marangoni force on each particle at the last step \[N\].
    pub marangoni: Vec<Vector3<f64>>,
    /// Artificial speed of sound, which follows the flow \[m/s\].
    pub sound_speed: f64,
    /// What forces have done so far.
    pub work: Work,
    /// Cost so far.
    pub cost: Cost,
}

/// The state in numbers.
#[derive(Serialize, Deserialize)]
struct Saved {
    molten: Vec<bool>,
    velocities: Vec<[f64; 3]>,
    densities: Vec<f64>,
    temperatures: Vec<f64>,
    pressures: Vec<f64>,
    marangoni: Vec<[f64; 3]>,
    sound_speed: f64,
    work: Work,
    cost: Cost,
}

impl State {
    /// `count` particles, none molten, in which sound will have this speed \[m/s\].
    pub fn at_rest(count: usize, density: f64, sound_speed: f64) -> Self {
        Self {
            molten: vec![false; count],
            velocities: vec![Vector3::zeros(); count],
            densities: vec![density; count],
            temperatures: vec![0.0; count],
            pressures: vec![0.0; count],
            marangoni: vec![Vector3::zeros(); count],
            sound_speed,
            work: Work::default(),
            cost: Cost::default(),
        }
    }

    /// Whether anything flows.
    pub fn any_molten(&self) -> bool {
        self.molten.contains(&true)
    }

    /// Speed of the fastest particle \[m/s\].
    pub fn largest_speed(&self) -> f64 {
        self.velocities.iter().map(Vector3::norm_squared).fold(0.0, f64::max).sqrt()
    }

    /// Speed that all but a `share` of the melt do not exceed \[m/s\]; zero without melt.
    pub fn flow_speed(&self, share: f64) -> f64 {
        let melt = self.velocities.iter().zip(&self.molten).filter(|(_, molten)| **molten);
        let mut squares: Vec<f64> = melt.map(|(velocity, _)| velocity.norm_squared()).collect();
        let beyond = (share * squares.len() as f64) as usize;
        let Some(at) = squares.len().checked_sub(1 + beyond) else { return 0.0 };
        squares.select_nth_unstable_by(at, f64::total_cmp).1.sqrt()
    }

    /// Bytes for a checkpoint.
    pub fn save(&self) -> Vec<u8> {
        let saved = Saved {
            molten: self.molten.clone(),
            velocities: self.velocities.iter().map(|&velocity| velocity.into()).collect(),
            densities: self.densities.clone(),
            temperatures: self.temperatures.clone(),
            pressures: self.pressures.clone(),
            marangoni: self.marangoni.iter().map(|&force| force.into()).collect(),
            sound_speed: self.sound_speed,
            work: self.work,
            cost: self.cost,
        };
        postcard::to_stdvec(&saved).expect("numbers and columns always serialise")
    }

    /// The state that [`save`](Self::save) gave, of the same particles as `like`.
    ///
    /// # Errors
    /// A message when the bytes are of no such state.
    pub fn restore(saved: &[u8], like: &Self) -> Result<Self, String> {
        let saved: Saved = postcard::from_bytes(saved).map_err(|error| format!("flow: {error}"))?;
        let count = like.molten.len();
        let lengths = [
            saved.molten.len(),
            saved.velocities.len(),
            saved.densities.len(),
            saved.temperatures.len(),
            saved.pressures.len(),
            saved.marangoni.len(),
        ];
        if lengths.iter().any(|&length| length != count) {
            return Err(format!("flow: it is of {} particles; the case has {count}", saved.molten.len()));
        }
        Ok(Self {
            molten: saved.molten,
            velocities: saved.velocities.into_iter().map(Vector3::from).collect(),
            densities: saved.densities,
            temperatures: saved.temperatures,
            pressures: saved.pressures,
            marangoni: saved.marangoni.into_iter().map(Vector3::from).collect(),
            sound_speed: saved.sound_speed,
            work: saved.work,
            cost: saved.cost,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_splash_is_no_flow() {
        let mut state = State::at_rest(101, 2500.0, 10.0);
        assert_eq!(state.flow_speed(0.05), 0.0);
        state.molten[..100].fill(true);
        let speeds = (0..101).map(|i| Vector3::new(0.0, -(f64::from(i) + 1.0), 0.0));
        state.velocities = speeds.collect();
        assert_eq!(state.flow_speed(0.05), 95.0);
        assert_eq!(state.flow_speed(0.0), 100.0);
    }
}
