//! What ends a run of fluid by name.

use super::FluidFlow;
use crate::physics::Failure;
use nalgebra::SVector;

impl<const D: usize> FluidFlow<D> {
    /// Fluid that has left the domain, or whose numbers are none.
    pub(super) fn lost(&self) -> Option<Failure> {
        let bad = |x: &SVector<f64, D>| !x.iter().all(|x| x.is_finite());
        if let Some(i) = self.positions().iter().position(bad) {
            return Some(self.failure("a position is no number any more".into(), Some(i)));
        }
        let broken = |&i: &usize| {
            let density = self.densities[i];
            density.is_nan() || density <= 0.0 || bad(&self.columns.velocities[i])
        };
        if let Some(i) = (0..self.fluid).find(broken) {
            return Some(self.failure("a density or a velocity is none any more".into(), Some(i)));
        }
        let gone = |(i, x): (usize, &SVector<f64, D>)| Some((i, self.model.passed(x)?));
        let (i, (side, wall)) = self.positions().iter().enumerate().find_map(gone)?;
        let what = if wall {
            format!("fluid has gone through the wall {side}")
        } else {
            format!("fluid has left the domain by its open side {side}")
        };
        let advice = if wall {
            "try a larger fluid.sound_speed_m_s, a finer spacing_m, or more scheme.density_pull"
        } else {
            "try a larger domain, or a wall at that side"
        };
        Some(Failure { advice: advice.into(), ..self.failure(what, Some(i)) })
    }

    pub(super) fn wild(&self) -> Failure {
        let speed = |i: &usize| self.columns.velocities[*i].norm_squared();
        let fastest = (0..self.fluid).max_by(|i, j| speed(i).total_cmp(&speed(j)));
        self.failure("the fluid has become too fast, or its forces too strong, to be stepped".into(), fastest)
    }

    pub(super) fn failure(&self, what: String, particle: Option<usize>) -> Failure {
        let at = particle.map(|i| self.columns.positions[i]).filter(|x| x.iter().all(|x| x.is_finite()));
        Failure {
            physics: "fluid",
            what,
            time: self.time,
            at: at.map(|x| std::array::from_fn(|axis| if axis < D { x[axis] } else { 0.0 })),
            advice:
                "try a larger fluid.sound_speed_m_s, more scheme.artificial_viscosity, or a finer spacing_m"
                    .into(),
        }
    }
}
