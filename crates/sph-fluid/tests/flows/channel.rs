//! A channel between two walls, periodic along x by copies.

use nalgebra::Vector2;
use sph_fluid::{
    FluidControls, FluidFields, FluidSweep, Tait, acoustic_step, artificial_sound_speed, viscous_step,
};
use sph_kernel::KernelKind;
use sph_neighbors::{NeighborList, PairReach, SearchMethod};

/// Density of water \[kg/m^3\].
const DENSITY: f64 = 1000.0;
/// Kinematic viscosity of water \[m^2/s\].
pub const VISCOSITY: f64 = 1e-6;
/// Height of the channel \[m\].
pub const HEIGHT: f64 = 1e-3;
/// Particles in one period along x; more than the support of 3 spacings.
const COLUMNS: usize = 8;
/// Copies and rows of wall on each side: the support of 2 h = 3 spacings and one more for the skin.
const MARGIN: usize = 4;
/// Share of the spacing that a pair may close in before the list is stale.
const SKIN: f64 = 0.9;

pub struct Channel {
    pub positions: Vec<Vector2<f64>>,
    velocities: Vec<Vector2<f64>>,
    densities: Vec<f64>,
    masses: Vec<f64>,
    copies: Vec<u32>,
    shifts: Vec<f64>,
    accelerations: Vec<Vector2<f64>>,
    list: NeighborList,
    pub sweep: FluidSweep<2>,
    dt: f64,
    time: f64,
}

impl Channel {
    /// At rest: `across` particles over the height, driven by a body force \[m/s^2\] or by the upper wall \[m/s\].
    pub fn new(across: usize, force: [f64; 2], upper_wall_speed: f64, largest_speed: f64) -> Self {
        let spacing = HEIGHT / across as f64;
        let length = 1.5 * spacing;
        let sound_speed = artificial_sound_speed(largest_speed, DENSITY, 0.0, 0.0, 0.0);
        let kernel = KernelKind::WendlandC2.with_smoothing_length(length);
        let controls = FluidControls {
            dynamic_viscosity: DENSITY * VISCOSITY,
            density_diffusion: 0.1,
            body_acceleration: Vector2::from(force),
            ..FluidControls::new(kernel, Tait::new(DENSITY, sound_speed, 7.0).unwrap())
        };
        let fluid = across * COLUMNS;
        let (copies, shifts) = images(across, COLUMNS as f64 * spacing);
        let positions = lattice(across, spacing, &copies, &shifts);
        let mut velocities = vec![Vector2::zeros(); positions.len()];
        for k in fluid + copies.len()..positions.len() {
            velocities[k].x = if positions[k].y > 0.5 * HEIGHT { upper_wall_speed } else { 0.0 };
        }
        let reach = PairReach::Uniform(2.0 * length + SKIN * spacing);
        let dt = acoustic_step(length, sound_speed, largest_speed).min(viscous_step(length, VISCOSITY));
        Self {
            list: SearchMethod::default().find(&positions, reach).unwrap(),
            densities: vec![DENSITY; positions.len()],
            masses: vec![DENSITY * spacing * spacing; positions.len()],
            accelerations: vec![Vector2::zeros(); fluid],
            sweep: FluidSweep::new(controls).unwrap(),
            time: 0.0,
            positions,
            velocities,
            copies,
            shifts,
            dt,
        }
    }

    /// Steps by kick-drift-kick until exactly `time` \[s\].
    pub fn run_to(&mut self, time: f64) {
        let steps = ((time - self.time) / self.dt).ceil();
        let dt = (time - self.time) / steps;
        self.evaluate(0.0);
        for _ in 0..steps as usize {
            self.kick(0.5 * dt);
            for i in 0..self.accelerations.len() {
                self.positions[i] += self.velocities[i] * dt;
            }
            self.evaluate(dt);
            self.kick(0.5 * dt);
        }
        self.time = time;
    }

    fn kick(&mut self, dt: f64) {
        for (velocity, acceleration) in self.velocities.iter_mut().zip(&self.accelerations) {
            *velocity += acceleration * dt;
        }
    }

    fn evaluate(&mut self, dt: f64) {
        let fluid = self.accelerations.len();
        for (k, &source) in self.copies.iter().enumerate() {
            self.positions[fluid + k] = self.positions[source as usize] + Vector2::new(self.shifts[k], 0.0);
            self.velocities[fluid + k] = self.velocities[source as usize];
        }
        let fields = FluidFields {
            positions: &self.positions,
            velocities: &self.velocities,
            masses: &self.masses,
            temperatures: &[],
            copies: &self.copies,
            list_starts: self.list.starts(),
            list_neighbors: self.list.indices(),
        };
        self.sweep.accelerations(&fields, &mut self.densities, dt, &mut self.accelerations);
    }

    /// Largest difference of a fluid particle's velocity from a profile u(y, t) along x \[m/s\].
    pub fn largest_error(&self, profile: impl Fn(f64, f64) -> f64) -> f64 {
        (0..self.accelerations.len())
            .map(|i| (self.velocities[i] - Vector2::new(profile(self.positions[i].y, self.time), 0.0)).norm())
            .fold(0.0, f64::max)
    }
}

/// Fluid, its copies, then both walls.
fn lattice(across: usize, spacing: f64, copies: &[u32], shifts: &[f64]) -> Vec<Vector2<f64>> {
    let site = |column: f64, row: f64| Vector2::new(column + 0.5, row + 0.5) * spacing;
    let mut positions: Vec<_> =
        (0..across * COLUMNS).map(|k| site((k % COLUMNS) as f64, (k / COLUMNS) as f64)).collect();
    for (&source, &shift) in copies.iter().zip(shifts) {
        positions.push(positions[source as usize] + Vector2::new(shift, 0.0));
    }
    for row in 0..MARGIN {
        for column in 0..COLUMNS + 2 * MARGIN {
            let column = column as f64 - MARGIN as f64;
            positions.push(site(column, -1.0 - row as f64));
            positions.push(site(column, (across + row) as f64));
        }
    }
    positions
}

/// Sources and shifts along x of the copies on both sides.
fn images(across: usize, period: f64) -> (Vec<u32>, Vec<f64>) {
    let particles = 0..(across * COLUMNS) as u32;
    let right = particles.clone().filter(|k| (*k as usize % COLUMNS) < MARGIN).map(|k| (k, period));
    let left = particles.filter(|k| *k as usize % COLUMNS >= COLUMNS - MARGIN).map(|k| (k, -period));
    right.chain(left).unzip()
}
