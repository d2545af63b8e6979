//! A fluid among walls that others move: the columns of a [`FluidSweep`], kick-drift-kick, and what the fluid does to its walls.

use super::super::neighbors::find;
use super::own_stress::own_stress_force;
use nalgebra::{SMatrix, SVector};
use sph_fluid::{
    Fields, FluidControls, FluidFields, FluidSweep, artificial_acceleration, leading_part,
    volume_pressure_acceleration,
};
use sph_kernel::RowBuffer;
use sph_solid::SolidPatch;

/// Share of the spacing that two particles may close in by before the list is made anew.
const SKIN: f64 = 0.4;

/// What fluid and walls start from: fluid first.
pub(super) struct Columns<const D: usize> {
    /// Places \[m\].
    pub positions: Vec<SVector<f64, D>>,
    /// Velocities \[m/s\].
    pub velocities: Vec<SVector<f64, D>>,
    /// Densities \[kg/m^3\].
    pub densities: Vec<f64>,
    /// Masses \[kg; kg/m in 2-D\].
    pub masses: Vec<f64>,
}

/// Fluid particles, then those of walls.
pub(super) struct Fluid<const D: usize> {
    pub columns: Columns<D>,
    /// What accelerates each particle of the fluid besides the sweep \[m/s^2\].
    pub pushes: Vec<SVector<f64, D>>,
    pub sweep: FluidSweep<D>,
    /// Pressures of the walls, where they have their own \[Pa\]; empty where that of the fluid is carried to them.
    pub wall_pressures: Vec<f64>,
    pub pair_visits: u64,
    accelerations: Vec<SVector<f64, D>>,
    controls: FluidControls<D>,
    spacing: f64,
    list: (Vec<usize>, Vec<u32>),
    listed: Vec<SVector<f64, D>>,
}

impl<const D: usize> Fluid<D> {
    /// The first `fluid` particles are fluid; `spacing` \[m\] is that of the fluid.
    pub fn new(
        controls: FluidControls<D>,
        spacing: f64,
        columns: Columns<D>,
        fluid: usize,
    ) -> Result<Self, sph_fluid::Error> {
        let mut made = Self {
            accelerations: vec![SVector::zeros(); fluid],
            pushes: vec![SVector::zeros(); fluid],
            sweep: FluidSweep::new(controls)?,
            wall_pressures: Vec::new(),
            list: (Vec::new(), Vec::new()),
            listed: Vec::new(),
            pair_visits: 0,
            controls,
            spacing,
            columns,
        };
        made.find_neighbors();
        made.evaluate(0.0);
        Ok(made)
    }

    /// Fluid of one particle a cell of edge `spacing` \[m\] with a `pressure` \[Pa\], and walls of the given `(place, volume)`, all
    /// at rest.
    pub fn at_rest(
        controls: FluidControls<D>,
        spacing: f64,
        places: Vec<SVector<f64, D>>,
        pressure: impl Fn(&SVector<f64, D>) -> f64,
        walls: &[(SVector<f64, D>, f64)],
    ) -> Result<Self, sph_fluid::Error> {
        let (state, cell, fluid) = (controls.state, spacing.powi(D as i32), places.len());
        let mut densities: Vec<f64> = places.iter().map(|place| state.density(pressure(place))).collect();
        let mut masses: Vec<f64> = densities.iter().map(|density| density * cell).collect();
        let mut positions = places;
        for (place, volume) in walls {
            positions.push(*place);
            densities.push(state.reference_density());
            masses.push(state.reference_density() * volume);
        }
        let velocities = vec![SVector::zeros(); positions.len()];
        Self::new(controls, spacing, Columns { positions, velocities, densities, masses }, fluid)
    }

    /// How many particles are fluid.
    pub fn len(&self) -> usize {
        self.accelerations.len()
    }

    /// One kick-drift-kick step of `dt` \[s\]; `move_walls` gives walls their places at its end and their mean velocities in it.
    pub fn step(&mut self, dt: f64, move_walls: impl FnOnce(&mut [SVector<f64, D>], &mut [SVector<f64, D>])) {
        self.kick(0.5 * dt);
        let fluid = self.len();
        let Columns { positions, velocities, .. } = &mut self.columns;
        for i in 0..fluid {
            positions[i] += velocities[i] * dt;
        }
        for (position, shift) in positions.iter_mut().zip(self.sweep.shift_velocities()) {
            *position += shift * dt;
        }
        move_walls(&mut positions[fluid..], &mut velocities[fluid..]);
        let far = 0.5 * SKIN * self.spacing;
        if positions.iter().zip(&self.listed).any(|(now, then)| (now - then).norm() > far) {
            self.find_neighbors();
        }
        self.evaluate(dt);
        self.kick(0.5 * dt);
    }

    /// The same around a body, whose particles are the first walls.
    pub fn step_around(&mut self, body: &SolidPatch<D>, dt: f64) {
        self.step(dt, |places, velocities| {
            let now = body.positions().iter().zip(&body.displacements).map(|(place, u)| place + u);
            for ((place, velocity), now) in places.iter_mut().zip(velocities).zip(now) {
                *velocity = (now - *place) / dt;
                *place = now;
            }
        });
    }

    /// Forces of the fluid on the first `count` particles of the walls \[N; N/m in 2-D\]: pair by pair the opposite of what
    /// pressure and artificial viscosity do to the fluid. Friction is left out, so that the controls must have none.
    pub fn forces_on_walls(&self, count: usize) -> Vec<SVector<f64, D>> {
        let Columns { positions, velocities, densities, masses } = &self.columns;
        let (volumes, pressures) = (self.sweep.volumes(), self.sweep.pressures());
        let columns = Fields { masses, densities, volumes, pressures, velocities };
        // Under pressure a wall is smaller than its density says: its force is that on its volume.
        let squeezed: Vec<f64> = masses.iter().zip(volumes).map(|(mass, volume)| mass / volume).collect();
        let pressed = Fields { densities: &squeezed, ..columns };
        let kernel = &self.controls.kernel;
        let sound_speed = self.controls.state.reference_sound_speed();
        let mut buffer = RowBuffer::default();
        let mut force = |particle: usize| {
            let neighbors = &self.list.1[self.list.0[particle]..self.list.0[particle + 1]];
            let row = buffer.fill(particle, neighbors, positions, kernel);
            let wet = leading_part(&row, self.len());
            let damped = artificial_acceleration(
                &wet,
                &columns,
                kernel,
                sound_speed,
                self.controls.artificial_viscosity,
            );
            (volume_pressure_acceleration(&wet, &pressed) + damped) * masses[particle]
        };
        (self.len()..self.len() + count).map(&mut force).collect()
    }

    /// Lets the stress \[Pa\] of the first walls push the fluid until this is called again, and adds the opposite to their `loads`.
    pub fn push_by_own_stress(&mut self, stresses: &[SMatrix<f64, D, D>], loads: &mut [SVector<f64, D>]) {
        let Columns { positions, densities, masses, .. } = &self.columns;
        let volumes: Vec<f64> = masses.iter().zip(densities).map(|(mass, density)| mass / density).collect();
        let (fluid, mut buffer) = (self.accelerations.len(), RowBuffer::default());
        for (i, push) in self.pushes.iter_mut().enumerate() {
            let neighbors = &self.list.1[self.list.0[i]..self.list.0[i + 1]];
            let solid = &neighbors[neighbors.partition_point(|&b| (b as usize) < fluid)..];
            let row = buffer.fill(i, solid, positions, &self.controls.kernel);
            *push = own_stress_force(&row, &volumes, fluid, stresses, loads) / masses[i];
        }
    }

    fn kick(&mut self, dt: f64) {
        for (velocity, acceleration) in self.columns.velocities.iter_mut().zip(&self.accelerations) {
            *velocity += acceleration * dt;
        }
    }

    fn find_neighbors(&mut self) {
        let reach = self.controls.kernel.support_radius() + SKIN * self.spacing;
        self.list = find(&self.columns.positions, reach);
        self.listed.clone_from(&self.columns.positions);
    }

    fn evaluate(&mut self, dt: f64) {
        let Columns { positions, velocities, densities, masses } = &mut self.columns;
        let fields = FluidFields {
            positions,
            velocities,
            masses,
            wall_pressures: &self.wall_pressures,
            list_starts: &self.list.0,
            list_neighbors: &self.list.1,
            ..FluidFields::default()
        };
        self.sweep.accelerations(&fields, densities, dt, &mut self.accelerations);
        for (acceleration, push) in self.accelerations.iter_mut().zip(&self.pushes) {
            *acceleration += push;
        }
        self.pair_visits += 2 * self.list.0[self.accelerations.len()] as u64;
    }
}

/// Takes `steps` steps of a body over `dt` \[s\] at standing `loads` \[N; N/m in 2-D\] on its particles.
pub(super) fn load<const D: usize>(
    body: &mut SolidPatch<D>,
    loads: &[SVector<f64, D>],
    steps: usize,
    dt: f64,
) {
    let short = dt / steps as f64;
    let kick = |body: &mut SolidPatch<D>| {
        for i in 0..loads.len() {
            let gained = loads[i] * (0.5 * short / body.body().masses()[i]);
            body.velocities[i] += gained.component_mul(&body.free[i]);
        }
    };
    for _ in 0..steps {
        kick(body);
        body.step(short);
        kick(body);
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
        let mut fluid = Fluid::at_rest(controls, 0.1, (0..36).map(place).collect(), depth, &walls).unwrap();
        fluid.columns.velocities.iter_mut().enumerate().for_each(|(i, v)| v.y = 0.1 * (i as f64).sin());
        fluid.evaluate(0.0);
        let given: Vector2<f64> = fluid.forces_on_walls(24).into_iter().sum();
        let taken: Vector2<f64> = (0..36).map(|i| fluid.accelerations[i] * fluid.columns.masses[i]).sum();
        assert!(given.y < -100.0, "the fluid presses down: {given}");
        assert!((given + taken).norm() < 1e-11 * given.norm(), "{given} {taken}");
    }
}
