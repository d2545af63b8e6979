//! A fluid among walls that others move: the columns of a [`FluidSweep`], kick-drift-kick, and what the fluid does to its walls.

use super::super::neighbors::find;
use nalgebra::SVector;
use sph_fluid::{
    Fields, FluidControls, FluidFields, FluidSweep, artificial_acceleration, leading_part,
    volume_pressure_acceleration,
};
use sph_kernel::RowBuffer;

/// Share of the spacing that two particles may close in by before the list is made anew.
const SKIN: f64 = 0.4;

/// Fluid particles, then those of walls.
pub(super) struct Fluid<const D: usize> {
    pub positions: Vec<SVector<f64, D>>,
    pub velocities: Vec<SVector<f64, D>>,
    pub accelerations: Vec<SVector<f64, D>>,
    controls: FluidControls<D>,
    sweep: FluidSweep<D>,
    spacing: f64,
    densities: Vec<f64>,
    masses: Vec<f64>,
    list: (Vec<usize>, Vec<u32>),
    listed: Vec<SVector<f64, D>>,
    pub pair_visits: u64,
}

impl<const D: usize> Fluid<D> {
    /// Fluid of one particle a cell of edge `spacing` \[m\] with a `pressure` \[Pa\], and walls of the given `(place, volume)`, all
    /// at rest.
    pub fn new(
        controls: FluidControls<D>,
        spacing: f64,
        places: Vec<SVector<f64, D>>,
        pressure: impl Fn(&SVector<f64, D>) -> f64,
        walls: &[(SVector<f64, D>, f64)],
    ) -> Result<Self, sph_fluid::Error> {
        let (state, cell) = (controls.state, spacing.powi(D as i32));
        let mut densities: Vec<f64> = places.iter().map(|place| state.density(pressure(place))).collect();
        let mut masses: Vec<f64> = densities.iter().map(|density| density * cell).collect();
        let fluid = places.len();
        let mut positions = places;
        for (place, volume) in walls {
            positions.push(*place);
            densities.push(state.reference_density());
            masses.push(state.reference_density() * volume);
        }
        let mut made = Self {
            velocities: vec![SVector::zeros(); positions.len()],
            accelerations: vec![SVector::zeros(); fluid],
            sweep: FluidSweep::new(controls)?,
            list: (Vec::new(), Vec::new()),
            listed: Vec::new(),
            pair_visits: 0,
            controls,
            spacing,
            densities,
            masses,
            positions,
        };
        made.find_neighbors();
        made.evaluate(0.0);
        Ok(made)
    }

    /// How many particles are fluid.
    pub fn len(&self) -> usize {
        self.accelerations.len()
    }

    /// One kick-drift-kick step of `dt` \[s\]; `move_walls` gives walls their places at its end and their mean velocities in it.
    pub fn step(&mut self, dt: f64, move_walls: impl FnOnce(&mut [SVector<f64, D>], &mut [SVector<f64, D>])) {
        self.kick(0.5 * dt);
        let fluid = self.len();
        for i in 0..fluid {
            self.positions[i] += self.velocities[i] * dt;
        }
        for (position, shift) in self.positions.iter_mut().zip(self.sweep.shift_velocities()) {
            *position += shift * dt;
        }
        move_walls(&mut self.positions[fluid..], &mut self.velocities[fluid..]);
        let far = 0.5 * SKIN * self.spacing;
        if self.positions.iter().zip(&self.listed).any(|(now, then)| (now - then).norm() > far) {
            self.find_neighbors();
        }
        self.evaluate(dt);
        self.kick(0.5 * dt);
    }

    /// Forces of the fluid on the first `count` particles of the walls \[N; N/m in 2-D\]: pair by pair the opposite of what
    /// pressure and artificial viscosity do to the fluid. Friction is left out, so that the controls must have none.
    pub fn forces_on_walls(&self, count: usize) -> Vec<SVector<f64, D>> {
        let volumes: Vec<f64> =
            self.masses.iter().zip(&self.densities).map(|(mass, density)| mass / density).collect();
        let columns = Fields {
            masses: &self.masses,
            densities: &self.densities,
            volumes: &volumes,
            pressures: self.sweep.pressures(),
            velocities: &self.velocities,
        };
        let kernel = &self.controls.kernel;
        let sound_speed = self.controls.state.reference_sound_speed();
        let mut buffer = RowBuffer::default();
        let mut force = |particle: usize| {
            let neighbors = &self.list.1[self.list.0[particle]..self.list.0[particle + 1]];
            let row = buffer.fill(particle, neighbors, &self.positions, kernel);
            let wet = leading_part(&row, self.len());
            let damped = artificial_acceleration(
                &wet,
                &columns,
                kernel,
                sound_speed,
                self.controls.artificial_viscosity,
            );
            (volume_pressure_acceleration(&wet, &columns) + damped) * self.masses[particle]
        };
        (self.len()..self.len() + count).map(&mut force).collect()
    }

    fn kick(&mut self, dt: f64) {
        for (velocity, acceleration) in self.velocities.iter_mut().zip(&self.accelerations) {
            *velocity += acceleration * dt;
        }
    }

    fn find_neighbors(&mut self) {
        let reach = self.controls.kernel.support_radius() + SKIN * self.spacing;
        self.list = find(&self.positions, reach);
        self.listed.clone_from(&self.positions);
    }

    fn evaluate(&mut self, dt: f64) {
        let fields = FluidFields {
            positions: &self.positions,
            velocities: &self.velocities,
            masses: &self.masses,
            temperatures: &[],
            copies: &[],
            mirrors: &[],
            list_starts: &self.list.0,
            list_neighbors: &self.list.1,
        };
        self.sweep.accelerations(&fields, &mut self.densities, dt, &mut self.accelerations);
        self.pair_visits += 2 * self.list.0[self.accelerations.len()] as u64;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector2;
    use sph_fluid::Tait;
    use sph_kernel::KernelKind;

    #[test]
    fn what_fluid_does_to_walls_they_do_to_the_fluid() {
        let kernel = KernelKind::WendlandC2.with_smoothing_length(0.15);
        let controls = FluidControls {
            artificial_viscosity: 0.3,
            ..FluidControls::new(kernel, Tait::new(1000.0, 10.0, 7.0).unwrap())
        };
        let place = |k: i32| Vector2::new(f64::from(k % 6) + 0.5, f64::from(k / 6) + 0.5) * 0.1;
        let walls: Vec<_> = (0..24).map(|k| (place(k) - Vector2::new(0.0, 0.4), 0.01)).collect();
        let depth = |place: &Vector2<f64>| 500.0 + 300.0 * place.x - 200.0 * place.y;
        let mut fluid = Fluid::new(controls, 0.1, (0..36).map(place).collect(), depth, &walls).unwrap();
        fluid.velocities.iter_mut().enumerate().for_each(|(i, v)| v.y = 0.1 * (i as f64).sin());
        fluid.evaluate(0.0);
        let given: Vector2<f64> = fluid.forces_on_walls(24).into_iter().sum();
        let taken: Vector2<f64> = (0..36).map(|i| fluid.accelerations[i] * fluid.masses[i]).sum();
        assert!(given.y < -100.0, "the fluid presses down: {given}");
        assert!((given + taken).norm() < 1e-11 * given.norm(), "{given} {taken}");
    }
}
