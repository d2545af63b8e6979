//! Heat of deformation: a solid warms when it is pressed and where it yields, and cools when it is stretched.
//!
//! With the heat capacity at constant pressure, which cards give, the heat that a change of stress makes is
//! -alpha T d tr(sigma) for each volume (Kelvin 1855; Landau and Lifshitz, Theory of Elasticity, section 6), and free expansion makes none.
//! The body holds alpha T tr(sigma) beside its elastic energy and its heat; taken in the middle of a step, heat, elastic energy and that
//! keep their sum, to the square of the step, while the work of yield is heat.

use crate::model::StressModel;
use crate::particles::Particles;
use sph_solid::ThermalExpansion;

/// The heat of deformation of a step.
pub(super) struct HeatOfDeformation {
    expansion: ThermalExpansion,
    volumes: Vec<f64>,
    /// Work of yield of each particle in this step \[J\].
    yielded: Vec<f64>,
}

impl HeatOfDeformation {
    pub fn new(stress: &StressModel, particles: &Particles<3>) -> Self {
        Self {
            expansion: stress.expansion.clone(),
            volumes: particles.volume.clone(),
            yielded: vec![0.0; particles.len()],
        }
    }

    /// Adds the work of yield \[J\] of an evaluation; copies behind the particles do not count.
    pub fn add_yield(&mut self, works: &[f64]) {
        self.yielded.iter_mut().zip(works).for_each(|(sum, work)| *sum += work);
    }

    /// Heat \[J\] of each particle of the body in a step, with temperatures \[K\] and tr(sigma) \[Pa\] at its start
    /// and its end.
    pub fn of_step(&mut self, temperatures: [&[f64]; 2], traces: [&[f64]; 2]) -> Vec<f64> {
        let heat = |i: usize| {
            let middle = 0.5 * (temperatures[0][i] + temperatures[1][i]);
            let pressed = self.expansion.coefficient(middle) * middle * (traces[1][i] - traces[0][i]);
            self.yielded[i] - self.volumes[i] * pressed
        };
        let heats = (0..self.volumes.len()).map(heat).collect();
        self.yielded.fill(0.0);
        heats
    }

    /// sum V alpha T tr(sigma) \[J\].
    pub fn stored(&self, temperatures: &[f64], traces: &[f64]) -> f64 {
        let of = |i: usize| {
            self.volumes[i] * self.expansion.coefficient(temperatures[i]) * temperatures[i] * traces[i]
        };
        (0..traces.len()).map(of).sum()
    }
}
