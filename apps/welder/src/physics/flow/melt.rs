//! The melt and the solid around it over one step of heat: columns of their own, kick-drift-kick.

use super::TAIT_EXPONENT;
use super::state::State;
use crate::particles::Particles;
use crate::physics::Work;
use nalgebra::Vector3;
use sph_fluid::{FluidControls, FluidFields, FluidSweep, Tait};
use sph_neighbors::{NeighborList, PairReach, Parts, SearchMethod};
use sph_thermal::conduction::{Images, Planes};
use std::collections::HashSet;

/// Share of the spacing that two particles may close in by before the list is made anew.
const SKIN: f64 = 0.4;

/// What the melt takes of each particle of the scene; the last two are empty where they are the same for all.
#[derive(Debug, Default)]
pub(super) struct Columns {
    /// Temperatures \[K\].
    pub temperatures: Vec<f64>,
    /// Viscosities at these \[Pa s\].
    pub viscosities: Vec<f64>,
    /// Surface tensions at these \[N/m\].
    pub tensions: Vec<f64>,
}

impl Columns {
    fn each(&mut self) -> [&mut Vec<f64>; 3] {
        [&mut self.temperatures, &mut self.viscosities, &mut self.tensions]
    }

    /// Those of some particles, in their order.
    fn of(&self, particles: impl Iterator<Item = usize> + Clone) -> Self {
        let pick = |column: &Vec<f64>| {
            if column.is_empty() { Vec::new() } else { particles.clone().map(|i| column[i]).collect() }
        };
        Self {
            temperatures: pick(&self.temperatures),
            viscosities: pick(&self.viscosities),
            tensions: pick(&self.tensions),
        }
    }

    /// Appends those of `others`, in their order.
    fn extend(&mut self, others: &Self) {
        self.temperatures.extend_from_slice(&others.temperatures);
        self.viscosities.extend_from_slice(&others.viscosities);
        self.tensions.extend_from_slice(&others.tensions);
    }

    /// Appends images of their own particles.
    fn show(&mut self, sources: &[u32]) {
        for column in self.each().into_iter().filter(|column| !column.is_empty()) {
            for &source in sources {
                column.push(column[source as usize]);
            }
        }
    }

    fn truncate(&mut self, length: usize) {
        self.each().into_iter().for_each(|column| column.truncate(length));
    }
}

/// Melt, and the solid that it can reach.
pub(super) struct Melt {
    controls: FluidControls<3>,
    spacing: f64,
    /// The symmetry planes.
    planes: Planes<3>,
    /// Mass of a particle \[kg\]: one material and one spacing.
    mass: f64,
    /// A sweep that has seen no particles, to begin a step of heat with.
    fresh: FluidSweep<3>,
    sweep: FluidSweep<3>,
    /// The particles of the scene that flow.
    members: Vec<u32>,
    /// Solid that melt can reach in this step of heat, images of it included.
    walls: Walls,
    /// Images of melt in the symmetry planes.
    images: Images<3>,
    /// Columns of melt, its images, and walls.
    positions: Vec<Vector3<f64>>,
    velocities: Vec<Vector3<f64>>,
    densities: Vec<f64>,
    masses: Vec<f64>,
    columns: Columns,
    accelerations: Vec<Vector3<f64>>,
    /// Heat that friction has made in each particle of melt in this step of heat, and that its expansion has taken
    /// \[J/kg\].
    warmth: Vec<f64>,
    expanded: Vec<f64>,
    /// Temperatures of the melt at the start of this step of heat and at its end \[K\].
    warming: [Vec<f64>; 2],
    listed: Vec<Vector3<f64>>,
}

/// Solid at rest around the melt.
#[derive(Default)]
struct Walls {
    positions: Vec<Vector3<f64>>,
    columns: Columns,
}

impl Melt {
    pub fn new(
        controls: FluidControls<3>,
        spacing: f64,
        planes: Planes<3>,
    ) -> Result<Self, sph_fluid::Error> {
        let fresh = FluidSweep::new(controls)?;
        Ok(Self {
            sweep: fresh.clone(),
            fresh,
            mass: controls.state.reference_density() * spacing.powi(3),
            controls,
            spacing,
            images: Images::new(&[], &[], &planes),
            planes,
            members: Vec::new(),
            walls: Walls::default(),
            positions: Vec::new(),
            velocities: Vec::new(),
            densities: Vec::new(),
            masses: Vec::new(),
            columns: Columns::default(),
            accelerations: Vec::new(),
            warmth: Vec::new(),
            expanded: Vec::new(),
            warming: [Vec::new(), Vec::new()],
            listed: Vec::new(),
        })
    }

    /// Density of the melt without pressure at the liquidus \[kg/m³\].
    fn reference_density(&self) -> f64 {
        self.controls.state.reference_density()
    }

    /// The same at a temperature \[K\].
    pub fn density_at(&self, temperature: f64) -> f64 {
        self.reference_density() / self.controls.stretch(temperature)
    }

    /// Mass of a particle \[kg\].
    pub fn mass(&self) -> f64 {
        self.mass
    }

    /// Energy of compression at a density \[kg/m³\] and a temperature \[K\] \[J/kg\].
    pub fn compression(&self, density: f64, temperature: f64) -> f64 {
        self.controls.compression(density, temperature)
    }

    /// Gives the melt this speed of sound \[m/s\], and `densities`, each with its temperature \[K\], that keep their
    /// pressures.
    ///
    /// # Errors
    /// What the fluid crate refuses.
    pub fn set_sound_speed<'a>(
        &mut self,
        sound_speed: f64,
        densities: impl Iterator<Item = (&'a mut f64, &'a f64)>,
    ) -> Result<(), sph_fluid::Error> {
        let before = self.controls.state;
        if sound_speed == before.reference_sound_speed() {
            return Ok(());
        }
        let after = Tait::new(before.reference_density(), sound_speed, TAIT_EXPONENT)?;
        for (density, &temperature) in densities {
            let stretch = self.controls.stretch(temperature);
            *density = after.density(before.pressure(*density * stretch)) / stretch;
        }
        self.controls.state = after;
        self.fresh = FluidSweep::new(self.controls)?;
        Ok(())
    }

    /// Moves the melt of `particles` over `step` \[s\] with the given columns; says whether it got there.
    pub fn advance(
        &mut self,
        particles: &mut Particles<3>,
        state: &mut State,
        columns: &Columns,
        step: f64,
    ) -> bool {
        if !state.any_molten() {
            return true;
        }
        self.gather(particles, state, columns);
        // A sweep remembers the surface of its last evaluation: a fresh one begins with none, in a resumed run as in a whole one.
        self.sweep = self.fresh.clone();
        let mut list = self.list();
        self.evaluate(&list, 0.0, state);
        let mut left = step;
        while left > 0.0 {
            let longest = self.longest_step();
            if longest < self.controls.wild_step() {
                break;
            }
            let count = (left / longest).ceil();
            let dt = left / count;
            self.kick(0.5 * dt, &mut state.work);
            self.drift(dt);
            self.warm(1.0 - (count - 1.0) * dt / step);
            if self.moved_far() {
                list = self.list();
            }
            self.evaluate(&list, dt, state);
            self.kick(0.5 * dt, &mut state.work);
            state.cost.melt_steps += 1;
            left = if count > 1.0 { left - dt } else { 0.0 };
        }
        self.scatter(particles, state);
        left == 0.0
    }

    /// Takes melt, and solid in its reach, out of the scene.
    fn gather(&mut self, particles: &Particles<3>, state: &State, columns: &Columns) {
        let molten = (0..particles.len() as u32).filter(|&i| state.molten[i as usize]);
        self.members.clear();
        self.members.extend(molten);
        let members = self.members.iter().map(|&i| i as usize);
        let vectors = |column: &[Vector3<f64>]| -> Vec<Vector3<f64>> {
            self.members.iter().map(|&i| column[i as usize]).collect()
        };
        self.positions = vectors(&particles.position);
        self.velocities = vectors(&state.velocities);
        self.densities = members.clone().map(|i| state.densities[i]).collect();
        self.columns = columns.of(members.clone());
        self.warming = [members.map(|i| state.temperatures[i]).collect(), self.columns.temperatures.clone()];
        if self.controls.thermal_expansion.is_some() {
            self.columns.temperatures.clone_from(&self.warming[0]);
        }
        self.accelerations = vec![Vector3::zeros(); self.members.len()];
        self.warmth = vec![0.0; self.members.len()];
        self.expanded = vec![0.0; self.members.len()];
        // Melt moves by a part of a spacing in a step of heat.
        let reach = self.controls.kernel.support_radius() + self.spacing;
        let near = Nearby::new(&self.positions, reach);
        let is_wall = |&i: &usize| {
            // Melt keeps its reach away from coarser particles: the gauge sees to that.
            !state.molten[i]
                && particles.spacing[i] < 1.5 * self.spacing
                && near.holds(&particles.position[i])
        };
        let walls: Vec<usize> = (0..particles.len()).filter(is_wall).collect();
        self.walls.positions = walls.iter().map(|&i| particles.position[i]).collect();
        self.walls.columns = columns.of(walls.iter().copied());
        let images = Images::new(&self.walls.positions, &vec![reach; walls.len()], &self.planes);
        self.walls.positions.extend_from_slice(&images.position);
        self.walls.columns.show(&images.source);
    }

    fn scatter(&self, particles: &mut Particles<3>, state: &mut State) {
        state.pressures.fill(0.0);
        state.marangoni.fill(Vector3::zeros());
        for (k, &i) in self.members.iter().enumerate() {
            let i = i as usize;
            particles.position[i] = self.positions[k];
            particles.enthalpy[i] += self.warmth[k] - self.expanded[k];
            state.work.dissipated += particles.mass[i] * self.warmth[k];
            state.work.expansion += particles.mass[i] * self.expanded[k];
            state.temperatures[i] = self.columns.temperatures[k];
            state.velocities[i] = self.velocities[k];
            state.densities[i] = self.densities[k];
            state.pressures[i] = self.sweep.pressures()[k];
            if let Some(force) = self.sweep.marangoni_forces().get(k) {
                state.marangoni[i] = force * (self.mass / self.densities[k]);
            }
        }
    }

    /// Images and neighbours where the melt is now; the columns take images and walls behind the melt.
    fn list(&mut self) -> NeighborList {
        let fluid = self.members.len();
        let reach = self.controls.kernel.support_radius() + SKIN * self.spacing;
        self.listed.clear();
        self.listed.extend_from_slice(&self.positions[..fluid]);
        // Melt sees a wall's image at the list's reach, and that sees melt as far again.
        self.images = Images::new(&self.listed, &vec![2.0 * reach; fluid], &self.planes);
        let (mobile, all) =
            (fluid + self.images.len(), fluid + self.images.len() + self.walls.positions.len());
        self.positions.truncate(fluid);
        self.positions.resize(mobile, Vector3::zeros());
        self.positions.extend_from_slice(&self.walls.positions);
        self.velocities.truncate(fluid);
        self.velocities.resize(all, Vector3::zeros());
        self.densities.truncate(fluid);
        self.densities.resize(all, self.reference_density());
        self.columns.truncate(fluid);
        self.columns.show(&self.images.source);
        self.columns.extend(&self.walls.columns);
        self.masses.clear();
        self.masses.resize(all, self.mass);
        self.move_images();
        // Positions that are no numbers any more find nobody; the run is stopped after this step.
        SearchMethod::default()
            .find_for(
                &self.positions,
                PairReach::Uniform(reach),
                Parts { owned: fluid, copies: self.images.len() },
            )
            .unwrap_or_else(|_| NeighborList::default())
    }

    /// Where warmth expands the melt, takes it a `share` of the way from the temperatures of the step's start to
    /// those of its end, so that it grows evenly and without a blow. What that does to the energy of compression
    /// comes out of the heat.
    fn warm(&mut self, share: f64) {
        if self.controls.thermal_expansion.is_none() {
            return;
        }
        for (k, expanded) in self.expanded.iter_mut().enumerate() {
            let [start, end] = [self.warming[0][k], self.warming[1][k]];
            let (density, temperature) = (self.densities[k], &mut self.columns.temperatures[k]);
            let before = *temperature;
            *temperature = start + share * (end - start);
            *expanded +=
                self.controls.compression(density, *temperature) - self.controls.compression(density, before);
        }
    }

    /// Images follow what they show.
    fn move_images(&mut self) {
        let fluid = self.members.len();
        for (image, &source) in self.images.source.iter().enumerate() {
            let (source, mirror) = (source as usize, Vector3::from(self.images.mirror[image]));
            self.positions[fluid + image] = self.images.place(image, &self.positions[source]);
            self.velocities[fluid + image] = self.velocities[source].component_mul(&mirror);
            self.columns.temperatures[fluid + image] = self.columns.temperatures[source];
        }
    }

    fn moved_far(&self) -> bool {
        let far = 0.5 * SKIN * self.spacing;
        self.positions.iter().zip(&self.listed).any(|(now, then)| (now - then).norm() > far)
    }

    fn evaluate(&mut self, list: &NeighborList, dt: f64, state: &mut State) {
        if list.starts().len() != self.positions.len() + 1 {
            return;
        }
        self.move_images();
        let fields = FluidFields {
            positions: &self.positions,
            velocities: &self.velocities,
            masses: &self.masses,
            temperatures: &self.columns.temperatures,
            viscosities: &self.columns.viscosities,
            tensions: &self.columns.tensions,
            copies: &self.images.source,
            mirrors: &self.images.mirror,
            list_starts: list.starts(),
            list_neighbors: list.indices(),
            ..FluidFields::default()
        };
        self.sweep.accelerations(&fields, &mut self.densities, dt, &mut self.accelerations);
        state.cost.sweeps += 2;
        state.cost.pair_visits += 2 * list.starts()[self.members.len()] as u64;
    }

    /// The shortest of the limits of sound, friction, tension and force \[s\].
    fn longest_step(&self) -> f64 {
        let fastest = self.velocities[..self.members.len()].iter().map(Vector3::norm).fold(0.0, f64::max);
        let strongest = self.accelerations.iter().map(Vector3::norm).fold(0.0, f64::max);
        self.step_of(fastest, strongest)
    }

    /// The same without forces, for melt whose fastest particle goes at `fastest` \[m/s\].
    pub fn steady_step(&self, fastest: f64) -> f64 {
        self.step_of(fastest, 0.0)
    }

    fn step_of(&self, fastest: f64, strongest: f64) -> f64 {
        self.controls
            .longest_steps(fastest, strongest)
            .into_iter()
            .map(|limit| limit.1)
            .fold(f64::INFINITY, f64::min)
    }

    /// Kicks the melt for `dt` \[s\], and counts what its forces do on the way, which is their power at the velocities of the middle.
    fn kick(&mut self, dt: f64, work: &mut Work) {
        self.accelerate(0.5 * dt);
        let powers = self.sweep.powers(&self.masses, &self.velocities);
        let momentum: Vector3<f64> =
            self.velocities[..self.members.len()].iter().sum::<Vector3<f64>>() * self.mass;
        work.tension += powers.tension * dt;
        work.marangoni += powers.marangoni * dt;
        work.gravity += momentum.dot(&self.controls.body_acceleration) * dt;
        for (warmth, heating) in self.warmth.iter_mut().zip(self.sweep.heating()) {
            *warmth += heating * dt;
        }
        self.accelerate(0.5 * dt);
    }

    fn accelerate(&mut self, dt: f64) {
        for (velocity, acceleration) in self.velocities.iter_mut().zip(&self.accelerations) {
            *velocity += acceleration * dt;
        }
    }

    fn drift(&mut self, dt: f64) {
        for i in 0..self.members.len() {
            self.positions[i] += self.velocities[i] * dt;
        }
        for (position, shift) in self.positions.iter_mut().zip(self.sweep.shift_velocities()) {
            *position += shift * dt;
        }
        self.stay_inside();
    }

    /// A particle that crosses a symmetry plane meets its image there, which comes in as it goes out: it takes the image's place.
    fn stay_inside(&mut self) {
        let melt = self.positions.iter_mut().zip(&mut self.velocities).take(self.members.len());
        for (position, velocity) in melt {
            for axis in 0..3 {
                for (side, outwards) in [(0, -1.0), (1, 1.0)] {
                    let beyond = outwards * (position[axis] - self.planes.position[axis][side]);
                    if self.planes.parity[axis][side].is_some() && beyond > 0.0 {
                        position[axis] -= 2.0 * outwards * beyond;
                        velocity[axis] = -velocity[axis];
                    }
                }
            }
        }
    }
}

/// Cells of the edge `reach` that melt is in or next to: who is in none of them is farther than `reach` from all of it.
struct Nearby {
    reach: f64,
    cells: HashSet<[i64; 3]>,
}

impl Nearby {
    fn new(melt: &[Vector3<f64>], reach: f64) -> Self {
        let mut nearby = Self { reach, cells: HashSet::new() };
        let homes: HashSet<[i64; 3]> = melt.iter().map(|x| nearby.cell(x)).collect();
        for home in homes {
            for n in 0..27 {
                nearby.cells.insert([home[0] + n % 3 - 1, home[1] + n / 3 % 3 - 1, home[2] + n / 9 - 1]);
            }
        }
        nearby
    }

    fn cell(&self, x: &Vector3<f64>) -> [i64; 3] {
        std::array::from_fn(|axis| (x[axis] / self.reach).floor() as i64)
    }

    fn holds(&self, x: &Vector3<f64>) -> bool {
        self.cells.contains(&self.cell(x))
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
            enthalpy: vec![1e6; 64],
            spacing: vec![spacing; 64],
            ..Particles::default()
        };
        let mut state = State::at_rest(64, 2500.0, 10.0);
        state.molten.fill(true);
        state.velocities.fill(Vector3::new(speed, 0.0, 0.0));
        Melt::new(controls, spacing, Planes::adiabatic_box([-1.0; 3], [1.0; 3])).unwrap().advance(
            &mut particles,
            &mut state,
            &Columns { temperatures: vec![1000.0; 64], ..Columns::default() },
            1e-5,
        )
    }

    #[test]
    fn melt_that_has_run_wild_is_not_stepped_for_ever() {
        assert!(gets_there(1.0));
        assert!(!gets_there(1e6) && !gets_there(f64::INFINITY));
    }

    #[test]
    fn melt_that_crosses_a_symmetry_plane_comes_back_as_its_image() {
        let spacing = 1e-4;
        let kernel = KernelKind::WendlandC2.with_smoothing_length(1.5 * spacing);
        let controls = FluidControls::new(kernel, Tait::new(2500.0, 10.0, 7.0).unwrap());
        let planes = Planes::adiabatic_box([0.0, -1.0, -1.0], [1.0; 3]);
        let mut melt = Melt::new(controls, spacing, planes).unwrap();
        melt.members = vec![0, 1];
        melt.positions = vec![Vector3::new(-2e-6, 0.1, 0.2), Vector3::new(3e-6, 0.1, 0.2)];
        melt.velocities = vec![Vector3::new(-0.5, 1.0, 2.0); 2];
        melt.stay_inside();
        assert_eq!(melt.positions, [Vector3::new(2e-6, 0.1, 0.2), Vector3::new(3e-6, 0.1, 0.2)]);
        assert_eq!(melt.velocities, [Vector3::new(0.5, 1.0, 2.0), Vector3::new(-0.5, 1.0, 2.0)]);
    }
}
