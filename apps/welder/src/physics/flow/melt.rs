//! The melt and the solid around it over one step of heat: columns of their own, kick-drift-kick.

use super::state::State;
use crate::particles::Particles;
use nalgebra::Vector3;
use sph_fluid::{
    FluidControls, FluidFields, FluidSweep, acoustic_step, capillary_step, force_step, viscous_step,
};
use sph_neighbors::{NeighborList, PairReach, SearchMethod};

/// Share of the spacing that two particles may close in by before the list is made anew.
const SKIN: f64 = 0.4;

/// A melt that asks for steps below this share of what its sound allows at rest has run wild.
const SHORTEST_STEP: f64 = 1e-3;

/// Melt, and the solid that it can reach.
pub(super) struct Melt {
    controls: FluidControls<3>,
    spacing: f64,
    /// A sweep that has seen no particles, to begin a step of heat with.
    fresh: FluidSweep<3>,
    sweep: FluidSweep<3>,
    /// The particles of the scene: melt, then walls.
    members: Vec<u32>,
    fluid: usize,
    positions: Vec<Vector3<f64>>,
    velocities: Vec<Vector3<f64>>,
    densities: Vec<f64>,
    masses: Vec<f64>,
    temperatures: Vec<f64>,
    accelerations: Vec<Vector3<f64>>,
    listed: Vec<Vector3<f64>>,
}

impl Melt {
    pub fn new(controls: FluidControls<3>, spacing: f64) -> Result<Self, sph_fluid::Error> {
        let fresh = FluidSweep::new(controls)?;
        Ok(Self {
            sweep: fresh.clone(),
            fresh,
            controls,
            spacing,
            members: Vec::new(),
            fluid: 0,
            positions: Vec::new(),
            velocities: Vec::new(),
            densities: Vec::new(),
            masses: Vec::new(),
            temperatures: Vec::new(),
            accelerations: Vec::new(),
            listed: Vec::new(),
        })
    }

    /// Density of the melt without pressure \[kg/m³\].
    pub fn reference_density(&self) -> f64 {
        self.controls.state.reference_density()
    }

    /// Moves the melt of `particles` over `step` \[s\] at the given temperatures \[K\]; says whether it got there.
    pub fn advance(
        &mut self,
        particles: &mut Particles<3>,
        state: &mut State,
        temperatures: &[f64],
        step: f64,
    ) -> bool {
        if !state.any_molten() {
            return true;
        }
        self.gather(particles, state, temperatures);
        // A sweep remembers the surface of its last evaluation: a fresh one begins with none, in a resumed run as in a whole one.
        self.sweep = self.fresh.clone();
        let mut list = self.list();
        self.evaluate(&list, 0.0, state);
        let mut left = step;
        while left > 0.0 {
            let longest = self.longest_step();
            if longest < self.shortest_step() {
                break;
            }
            let count = (left / longest).ceil();
            let dt = left / count;
            self.kick(0.5 * dt);
            self.drift(dt);
            if self.moved_far() {
                list = self.list();
            }
            self.evaluate(&list, dt, state);
            self.kick(0.5 * dt);
            left = if count > 1.0 { left - dt } else { 0.0 };
        }
        self.scatter(particles, state);
        left == 0.0
    }

    /// Takes melt, and solid in its reach, out of the scene.
    fn gather(&mut self, particles: &Particles<3>, state: &State, temperatures: &[f64]) {
        let reach = self.controls.kernel.support_radius() + 2.0 * self.spacing;
        let (mut low, mut high) = (Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY));
        self.members.clear();
        for i in 0..particles.len() {
            if state.molten[i] {
                self.members.push(i as u32);
                low = low.inf(&particles.position[i]);
                high = high.sup(&particles.position[i]);
            }
        }
        self.fluid = self.members.len();
        // Melt keeps its reach away from coarser particles: the gauge sees to that.
        let near = |i: &u32| {
            let x = particles.position[*i as usize];
            particles.spacing[*i as usize] < 1.5 * self.spacing
                && (0..3).all(|axis| x[axis] > low[axis] - reach && x[axis] < high[axis] + reach)
        };
        let solid = (0..particles.len() as u32).filter(|&i| !state.molten[i as usize]);
        self.members.extend(solid.filter(near));
        let members = &self.members;
        let of = |column: &[f64]| -> Vec<f64> { members.iter().map(|&i| column[i as usize]).collect() };
        let vectors = |column: &[Vector3<f64>]| -> Vec<Vector3<f64>> {
            members.iter().map(|&i| column[i as usize]).collect()
        };
        self.positions = vectors(&particles.position);
        self.velocities = vectors(&state.velocities);
        self.densities = of(&state.densities);
        self.masses = of(&particles.mass);
        self.temperatures = of(temperatures);
        self.accelerations = vec![Vector3::zeros(); self.fluid];
    }

    fn scatter(&self, particles: &mut Particles<3>, state: &mut State) {
        state.pressures.fill(0.0);
        for (k, &i) in self.members[..self.fluid].iter().enumerate() {
            let i = i as usize;
            particles.position[i] = self.positions[k];
            state.velocities[i] = self.velocities[k];
            state.densities[i] = self.densities[k];
            state.pressures[i] = self.sweep.pressures()[k];
        }
    }

    fn list(&mut self) -> NeighborList {
        self.listed.clear();
        self.listed.extend_from_slice(&self.positions[..self.fluid]);
        let reach = self.controls.kernel.support_radius() + SKIN * self.spacing;
        // Positions that are no numbers any more find nobody; the run is stopped after this step.
        SearchMethod::default()
            .find(&self.positions, PairReach::Uniform(reach))
            .unwrap_or_else(|_| NeighborList::default())
    }

    fn moved_far(&self) -> bool {
        let far = 0.5 * SKIN * self.spacing;
        self.positions[..self.fluid].iter().zip(&self.listed).any(|(now, then)| (now - then).norm() > far)
    }

    fn evaluate(&mut self, list: &NeighborList, dt: f64, state: &mut State) {
        if list.starts().len() != self.positions.len() + 1 {
            return;
        }
        let fields = FluidFields {
            positions: &self.positions,
            velocities: &self.velocities,
            masses: &self.masses,
            temperatures: &self.temperatures,
            copies: &[],
            list_starts: list.starts(),
            list_neighbors: list.indices(),
        };
        self.sweep.accelerations(&fields, &mut self.densities, dt, &mut self.accelerations);
        state.cost.sweeps += 2;
        state.cost.pair_visits += 2 * list.starts()[self.fluid] as u64;
    }

    fn shortest_step(&self) -> f64 {
        let (kernel, sound) = (&self.controls.kernel, self.controls.state.reference_sound_speed());
        SHORTEST_STEP * acoustic_step(kernel.smoothing_length(), sound, 0.0)
    }

    /// The shortest of the limits of sound, viscosity, tension and force \[s\].
    fn longest_step(&self) -> f64 {
        let length = self.controls.kernel.smoothing_length();
        let density = self.reference_density();
        let fastest = self.velocities[..self.fluid].iter().map(Vector3::norm).fold(0.0, f64::max);
        let strongest = self.accelerations.iter().map(Vector3::norm).fold(0.0, f64::max);
        let tension = self.controls.surface_tension.map_or(0.0, |tension| tension.reference());
        // Kick-drift-kick is stable to twice the acoustic limit, and as accurate there.
        [
            2.0 * acoustic_step(length, self.controls.state.reference_sound_speed(), fastest),
            viscous_step(length, self.controls.dynamic_viscosity / density),
            capillary_step(length, density, tension),
            force_step(length, strongest),
        ]
        .into_iter()
        .fold(f64::INFINITY, f64::min)
    }

    fn kick(&mut self, dt: f64) {
        for (velocity, acceleration) in self.velocities.iter_mut().zip(&self.accelerations) {
            *velocity += acceleration * dt;
        }
    }

    fn drift(&mut self, dt: f64) {
        for i in 0..self.fluid {
            self.positions[i] += self.velocities[i] * dt;
        }
        for (position, shift) in self.positions.iter_mut().zip(self.sweep.shift_velocities()) {
            *position += shift * dt;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use sph_fluid::Tait;
    use sph_kernel::KernelKind;

    /// Whether a small cube of melt, all at the `speed` \[m/s\] along x, gets through a step.
    fn gets_there(speed: f64) -> bool {
        let spacing = 1e-4;
        let kernel = KernelKind::WendlandC2.with_smoothing_length(1.5 * spacing);
        let controls = FluidControls::new(kernel, Tait::new(2500.0, 10.0, 7.0).unwrap());
        let place = |k: usize| Vector3::new(k % 4, k / 4 % 4, k / 16).map(|x| x as f64 * spacing);
        let mut particles = Particles::<3> {
            position: (0..64).map(place).collect(),
            mass: vec![2500.0 * spacing.powi(3); 64],
            ..Particles::default()
        };
        let mut state = State::at_rest(64, 2500.0);
        state.molten.fill(true);
        state.velocities.fill(Vector3::new(speed, 0.0, 0.0));
        Melt::new(controls, spacing).unwrap().advance(&mut particles, &mut state, &[1000.0; 64], 1e-5)
    }

    #[test]
    fn melt_that_has_run_wild_is_not_stepped_for_ever() {
        assert!(gets_there(1.0));
        assert!(!gets_there(1e6) && !gets_there(f64::INFINITY));
    }
}
