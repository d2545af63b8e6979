//! What the forces of a fluid do to its energy.

use super::FluidSweep;
use nalgebra::SVector;

/// Powers of forces on a fluid, sum m v.a over its particles \[W; W/m in 2-D\].
///
/// Pressure is not among them: with continuity it only moves energy between motion and compression (see
/// [`volume_pressure_acceleration`](crate::volume_pressure_acceleration)).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Powers {
    /// Of viscosity, artificial viscosity included; negative but where moving walls drive the fluid.
    pub friction: f64,
    /// Of surface tension: positive where the surface shrinks.
    pub tension: f64,
    /// Of the change of tension with temperature.
    pub marangoni: f64,
}

impl<const D: usize> FluidSweep<D> {
    /// Powers of the forces of the last evaluation on fluid that moves with `velocities` \[m/s\]; over two half kicks with these
    /// forces, those of the middle make it the change of kinetic energy, to round-off. Sums run in the order of the particles.
    ///
    /// # Panics
    /// If columns are shorter than at the last evaluation.
    #[must_use]
    pub fn powers(&self, masses: &[f64], velocities: &[SVector<f64, D>]) -> Powers {
        let mut sum = Powers::default();
        for (i, friction) in self.friction.iter().enumerate() {
            let momentum = velocities[i] * masses[i];
            sum.friction += momentum.dot(friction);
            sum.tension += self.tension.get(i).map_or(0.0, |tension| momentum.dot(tension));
            sum.marangoni +=
                self.marangoni.get(i).map_or(0.0, |force| velocities[i].dot(force) * self.volumes[i]);
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{FluidControls, FluidFields, SurfaceTension, Tait};
    use nalgebra::Vector2;
    use sph_kernel::KernelKind;
    use sph_neighbors::{PairReach, SearchMethod};

    /// Powers on a square of 16 x 16 particles of unit density and side, at the given velocities and temperatures.
    fn powers(
        controls: impl FnOnce(FluidControls<2>) -> FluidControls<2>,
        velocity: fn(&Vector2<f64>) -> Vector2<f64>,
        temperature: fn(&Vector2<f64>) -> f64,
    ) -> Powers {
        let spacing = 1.0 / 16.0;
        let place = |k: usize| Vector2::new((k % 16) as f64 + 0.5, (k / 16) as f64 + 0.5) * spacing;
        let positions: Vec<_> = (0..256).map(place).collect();
        let velocities: Vec<_> = positions.iter().map(velocity).collect();
        let temperatures: Vec<_> = positions.iter().map(temperature).collect();
        let (masses, mut densities) = (vec![spacing * spacing; 256], vec![1.0; 256]);
        let kernel = KernelKind::WendlandC2.with_smoothing_length(1.5 * spacing);
        let controls = controls(FluidControls::new(kernel, Tait::new(1.0, 10.0, 7.0).unwrap()));
        let list =
            SearchMethod::default().find(&positions, PairReach::Uniform(kernel.support_radius())).unwrap();
        let fields = FluidFields {
            positions: &positions,
            velocities: &velocities,
            masses: &masses,
            temperatures: &temperatures,
            list_starts: list.starts(),
            list_neighbors: list.indices(),
            ..FluidFields::default()
        };
        let mut sweep = FluidSweep::new(controls).unwrap();
        let mut accelerations = vec![Vector2::zeros(); 256];
        sweep.accelerations(&fields, &mut densities, 0.0, &mut accelerations);
        let powers = sweep.powers(&masses, &velocities);
        // Without pressure (all densities are that of rest) the three are all that acts.
        let all: f64 = (0..256).map(|i| masses[i] * velocities[i].dot(&accelerations[i])).sum();
        let sum = powers.friction + powers.tension + powers.marangoni;
        assert!((all - sum).abs() < 1e-12 * (1.0 + sum.abs()), "{all} {powers:?}");
        powers
    }

    #[test]
    fn shear_takes_viscosity_times_the_square_of_its_rate() {
        let found = powers(
            |controls| FluidControls { dynamic_viscosity: 0.3, ..controls },
            |r| Vector2::new(2.0 * r.y, 0.0),
            |_| 0.0,
        );
        // eta (du/dy)^2 of the area; rows at the faces lack partners.
        assert!((found.friction / (-0.3 * 4.0) - 1.0).abs() < 0.15, "{found:?}");
    }

    #[test]
    fn tension_gives_what_a_shrinking_surface_sets_free_and_takes_it_back() {
        let tense = |controls| {
            let tension = SurfaceTension::new(0.7, 0.0, 0.0).unwrap();
            FluidControls { surface_tension: Some(tension), ..controls }
        };
        let shrinking = powers(tense, |r| Vector2::repeat(0.5) - r, |_| 0.0).tension;
        let growing = powers(tense, |r| r - Vector2::repeat(0.5), |_| 0.0).tension;
        // tau d(4 side)/dt = 4 tau for a rate of one; the corners are round to the curvature.
        assert!((shrinking / (4.0 * 0.7) - 1.0).abs() < 0.4, "{shrinking}");
        assert!((growing + shrinking).abs() < 1e-12);
    }

    #[test]
    fn marangoni_force_works_along_the_faces() {
        let driven = |controls| {
            let tension = SurfaceTension::new(0.0, -0.2, 0.0).unwrap();
            FluidControls { surface_tension: Some(tension), ..controls }
        };
        let found = powers(driven, |_| Vector2::new(3.0, 0.0), |r| 5.0 * r.x).marangoni;
        // tau_T dT/dx times the speed along two faces of length one.
        assert!((found / (-0.2 * 5.0 * 3.0 * 2.0) - 1.0).abs() < 0.15, "{found}");
    }
}
