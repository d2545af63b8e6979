//! Fluid that is stepped by itself: columns, periodic copies, walls, and kick-drift-kick.

mod conduction;

pub use conduction::Conduction;

use crate::benchmarks::largest;
use crate::error::{Error, require};
use crate::sweep::{FluidControls, FluidFields, FluidSweep};
use conduction::{ConductionSweep, Rows};
use nalgebra::SVector;
use sph_kernel::RowBuffer;
use sph_kernel::operators::summation;

/// Share of the spacing that two particles may close in by before the list is made anew.
const SKIN: f64 = 0.4;

/// Neighbours of all positions \[m\] nearer than a reach \[m\]: where each row starts (one entry more than positions), and a full
/// list with ascending rows. `sph-neighbors` gives both.
pub type FindNeighbors<const D: usize> = fn(&[SVector<f64, D>], f64) -> (Vec<usize>, Vec<u32>);

/// What a patch starts from.
#[derive(Clone, Debug)]
pub struct PatchStart<const D: usize> {
    /// Positions of the fluid \[m\].
    pub positions: Vec<SVector<f64, D>>,
    /// Volumes of the fluid \[m^D\].
    pub volumes: Vec<f64>,
    /// Positions of particles of the walls \[m\]; each has the volume of a cell.
    pub walls: Vec<SVector<f64, D>>,
    /// Velocities of the walls' particles \[m/s\]; they stay where they are.
    pub wall_velocities: Vec<SVector<f64, D>>,
    /// Edge of a cell \[m\].
    pub spacing: f64,
    /// Period along each axis \[m\]; `None` where the patch does not repeat.
    pub periods: [Option<f64>; D],
    /// Pressure of the fluid at a place \[Pa\]: the density follows from it.
    pub pressure: fn(&SVector<f64, D>) -> f64,
    /// Temperature at a place \[K\], which the fluid moves through; with conduction, that of the start.
    pub temperature: fn(&SVector<f64, D>) -> f64,
    /// Where the fluid carries its temperature: how heat spreads.
    pub conduction: Option<Conduction<D>>,
}

impl<const D: usize> PatchStart<D> {
    /// Fluid without walls, pressure and temperature.
    #[must_use]
    pub fn free(positions: Vec<SVector<f64, D>>, volumes: Vec<f64>, spacing: f64) -> Self {
        Self {
            positions,
            volumes,
            walls: Vec::new(),
            wall_velocities: Vec::new(),
            spacing,
            periods: [None; D],
            pressure: |_| 0.0,
            temperature: |_| 0.0,
            conduction: None,
        }
    }
}

/// A fluid with the sweep that drives it. For tests, examples and benchmarks of the crate's own laws.
#[derive(Debug)]
pub struct FluidPatch<const D: usize> {
    start: PatchStart<D>,
    find: FindNeighbors<D>,
    reach: f64,
    reference_density: f64,
    fluid: usize,
    /// Fluid, copies, walls.
    positions: Vec<SVector<f64, D>>,
    velocities: Vec<SVector<f64, D>>,
    densities: Vec<f64>,
    masses: Vec<f64>,
    temperatures: Vec<f64>,
    copies: Vec<u32>,
    shifts: Vec<SVector<f64, D>>,
    accelerations: Vec<SVector<f64, D>>,
    list: (Vec<usize>, Vec<u32>),
    /// Positions of the fluid when the list was made.
    listed: Vec<SVector<f64, D>>,
    sweep: FluidSweep<D>,
    conduction: Option<ConductionSweep<D>>,
    time: f64,
    steps: u64,
    pair_visits: u64,
}

impl<const D: usize> FluidPatch<D> {
    /// Places the fluid at rest and evaluates it.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a spacing, period, diffusivity or heat capacity that is not positive, and what [`FluidSweep::new`] refuses.
    ///
    /// # Panics
    /// If columns of `start` differ in length.
    pub fn new(
        start: PatchStart<D>,
        controls: FluidControls<D>,
        find: FindNeighbors<D>,
    ) -> Result<Self, Error> {
        require(start.spacing > 0.0, "spacing", start.spacing, "a positive length in metres")?;
        for period in start.periods.into_iter().flatten() {
            require(period > 0.0, "period", period, "a positive length in metres")?;
        }
        if let Some(Conduction { diffusivity, heat_capacity, .. }) = start.conduction {
            require(diffusivity > 0.0, "diffusivity", diffusivity, "positive, in square metres per second")?;
            let accepted = "positive, in joules per kilogram and kelvin";
            require(heat_capacity > 0.0, "heat_capacity", heat_capacity, accepted)?;
        }
        assert_eq!(start.positions.len(), start.volumes.len(), "volumes");
        assert_eq!(start.walls.len(), start.wall_velocities.len(), "velocities of walls");
        let densities: Vec<f64> = start
            .positions
            .iter()
            .map(|position| {
                let temperature = (start.temperature)(position);
                let stretch = controls.thermal_expansion.map_or(1.0, |law| law.stretch(temperature));
                controls.state.density((start.pressure)(position)) / stretch
            })
            .collect();
        let masses = densities.iter().zip(&start.volumes).map(|(density, volume)| density * volume).collect();
        let fluid = start.positions.len();
        let mut patch = Self {
            reach: controls.kernel.support_radius() + SKIN * start.spacing,
            reference_density: controls.state.reference_density(),
            positions: start.positions.clone(),
            velocities: vec![SVector::zeros(); fluid],
            accelerations: vec![SVector::zeros(); fluid],
            sweep: FluidSweep::new(controls)?,
            temperatures: start.positions.iter().map(start.temperature).collect(),
            conduction: start.conduction.map(ConductionSweep::new),
            copies: Vec::new(),
            shifts: Vec::new(),
            list: (Vec::new(), Vec::new()),
            listed: Vec::new(),
            time: 0.0,
            steps: 0,
            pair_visits: 0,
            start,
            find,
            fluid,
            densities,
            masses,
        };
        patch.rebuild();
        patch.evaluate(0.0);
        Ok(patch)
    }

    /// Positions of the fluid \[m\].
    #[must_use]
    pub fn positions(&self) -> &[SVector<f64, D>] {
        &self.positions[..self.fluid]
    }

    /// Velocities of the fluid \[m/s\].
    #[must_use]
    pub fn velocities(&self) -> &[SVector<f64, D>] {
        &self.velocities[..self.fluid]
    }

    /// Velocities of the fluid, to set them \[m/s\].
    pub fn velocities_mut(&mut self) -> &mut [SVector<f64, D>] {
        &mut self.velocities[..self.fluid]
    }

    /// Accelerations of the fluid at the last evaluation \[m/s^2\].
    #[must_use]
    pub fn accelerations(&self) -> &[SVector<f64, D>] {
        &self.accelerations
    }

    /// Densities of the fluid \[kg/m^3\].
    #[must_use]
    pub fn densities(&self) -> &[f64] {
        &self.densities[..self.fluid]
    }

    /// Masses of the fluid \[kg; kg/m in 2-D\].
    #[must_use]
    pub fn masses(&self) -> &[f64] {
        &self.masses[..self.fluid]
    }

    /// Temperatures of the fluid \[K\].
    #[must_use]
    pub fn temperatures(&self) -> &[f64] {
        &self.temperatures[..self.fluid]
    }

    /// Heat over rho c \[K m^D/s\] that the fluid takes from the particles of walls that `chosen` picks; zero without conduction.
    #[must_use]
    pub fn heat_taken_from(&self, chosen: impl Fn(&SVector<f64, D>) -> bool) -> f64 {
        let Some(conduction) = &self.conduction else { return 0.0 };
        let rows = Rows {
            kernel: self.sweep.kernel(),
            positions: &self.positions,
            copies: &self.copies,
            list: &self.list,
            fluid: self.fluid,
        };
        conduction.taken_from(&rows, &self.temperatures, chosen)
    }

    /// The sweep, with pressures and surface of the last evaluation.
    #[must_use]
    pub fn sweep(&self) -> &FluidSweep<D> {
        &self.sweep
    }

    /// Edge of a cell \[m\].
    #[must_use]
    pub fn spacing(&self) -> f64 {
        self.start.spacing
    }

    /// Time \[s\].
    #[must_use]
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Steps taken.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Directed pairs of the lists that the passes of density and of forces have visited.
    #[must_use]
    pub fn pair_visits(&self) -> u64 {
        self.pair_visits
    }

    /// sum m/rho \[m^D\].
    #[must_use]
    pub fn volume(&self) -> f64 {
        self.masses().iter().zip(self.densities()).map(|(mass, density)| mass / density).sum()
    }

    /// sum m W over the density without pressure, of each particle of fluid \[-\]: one in an even body, less where there is a void
    /// or a surface, more where particles clump.
    #[must_use]
    pub fn colours(&self) -> Vec<f64> {
        let (kernel, mut buffer) = (self.sweep.kernel(), RowBuffer::default());
        let colour = |i: usize| {
            let neighbors = &self.list.1[self.list.0[i]..self.list.0[i + 1]];
            let row = buffer.fill(i, neighbors, &self.positions, kernel);
            summation(&row, &self.masses, kernel.value(0.0)) / self.reference_density
        };
        (0..self.fluid).map(colour).collect()
    }

    /// Largest speed of the fluid \[m/s\]; no number where a velocity is none.
    #[must_use]
    pub fn largest_speed(&self) -> f64 {
        largest(self.velocities().iter().map(SVector::norm))
    }

    /// One kick-drift-kick step \[s\].
    pub fn step(&mut self, dt: f64) {
        self.kick(0.5 * dt);
        for i in 0..self.fluid {
            self.positions[i] += self.velocities[i] * dt;
        }
        for (position, shift) in self.positions.iter_mut().zip(self.sweep.shift_velocities()) {
            *position += shift * dt;
        }
        self.evaluate(dt);
        self.kick(0.5 * dt);
        self.time += dt;
        self.steps += 1;
    }

    /// Equal steps of at most `dt` \[s\] that end on `time` \[s\].
    pub fn run_to(&mut self, time: f64, dt: f64) {
        let steps = ((time - self.time) / dt).ceil();
        let dt = (time - self.time) / steps;
        (0..steps as usize).for_each(|_| self.step(dt));
        self.time = time;
    }

    fn kick(&mut self, dt: f64) {
        for (velocity, acceleration) in self.velocities.iter_mut().zip(&self.accelerations) {
            *velocity += acceleration * dt;
        }
    }

    fn evaluate(&mut self, dt: f64) {
        let far = 0.5 * SKIN * self.start.spacing;
        if self.positions().iter().zip(&self.listed).any(|(now, then)| (now - then).norm() > far) {
            self.rebuild();
        }
        self.move_copies();
        self.update_temperatures(dt);
        let fields = FluidFields {
            positions: &self.positions,
            velocities: &self.velocities,
            masses: &self.masses,
            temperatures: &self.temperatures,
            copies: &self.copies,
            list_starts: &self.list.0,
            list_neighbors: &self.list.1,
            ..FluidFields::default()
        };
        self.sweep.accelerations(&fields, &mut self.densities, dt, &mut self.accelerations);
        self.pair_visits += 2 * self.list.0[self.fluid] as u64;
    }

    /// Heat moves for `dt` at the rates found last, then finds new ones; without conduction the temperature is that of the place.
    fn update_temperatures(&mut self, dt: f64) {
        let Some(conduction) = &mut self.conduction else {
            self.temperatures.clear();
            self.temperatures.extend(self.positions.iter().map(self.start.temperature));
            return;
        };
        conduction.advance(self.sweep.heating(), &mut self.temperatures, dt);
        self.temperatures.resize(self.positions.len(), 0.0);
        let rows = Rows {
            kernel: self.sweep.kernel(),
            positions: &self.positions,
            copies: &self.copies,
            list: &self.list,
            fluid: self.fluid,
        };
        let volumes = self.masses.iter().zip(&self.densities).map(|(mass, density)| mass / density);
        conduction.measure(&rows, volumes, &mut self.temperatures);
        self.pair_visits += 2 * self.list.0[self.fluid] as u64;
    }

    /// Copies, walls and the list anew.
    fn rebuild(&mut self) {
        self.positions.truncate(self.fluid);
        self.velocities.truncate(self.fluid);
        self.densities.truncate(self.fluid);
        self.masses.truncate(self.fluid);
        self.find_copies();
        for &source in &self.copies {
            self.positions.push(self.positions[source as usize]);
            self.velocities.push(self.velocities[source as usize]);
            self.masses.push(self.masses[source as usize]);
        }
        self.positions.extend_from_slice(&self.start.walls);
        self.velocities.extend_from_slice(&self.start.wall_velocities);
        let cell = self.reference_density * self.start.spacing.powi(D as i32);
        self.masses.resize(self.positions.len(), cell);
        self.densities.resize(self.positions.len(), self.reference_density);
        self.move_copies();
        self.list = (self.find)(&self.positions, self.reach);
        self.listed.clear();
        self.listed.extend_from_slice(&self.positions[..self.fluid]);
    }

    /// Puts the fluid into its periods, and finds who is seen across their ends until the list is made anew.
    fn find_copies(&mut self) {
        self.copies.clear();
        self.shifts.clear();
        // What walls see counts as well: fluid sees a wall at a support's distance, which sees as far again.
        let walls = if self.start.walls.is_empty() { 0.0 } else { self.reach };
        let margin = self.reach + walls + SKIN * self.start.spacing;
        for axis in 0..D {
            let Some(period) = self.start.periods[axis] else { continue };
            for position in &mut self.positions {
                position[axis] = position[axis].rem_euclid(period);
            }
            // Copies along the axes before have copies too: the corners.
            let found = self.copies.len();
            for k in 0..self.fluid + found {
                let (source, moved) = match k.checked_sub(self.fluid) {
                    Some(copy) => (self.copies[copy], self.shifts[copy]),
                    None => (k as u32, SVector::zeros()),
                };
                let x = self.positions[source as usize][axis];
                for shift in [(x < margin).then_some(period), (x > period - margin).then_some(-period)] {
                    let Some(shift) = shift else { continue };
                    let mut moved = moved;
                    moved[axis] += shift;
                    self.copies.push(source);
                    self.shifts.push(moved);
                }
            }
        }
    }

    fn move_copies(&mut self) {
        for (k, &source) in self.copies.iter().enumerate() {
            self.positions[self.fluid + k] = self.positions[source as usize] + self.shifts[k];
            self.velocities[self.fluid + k] = self.velocities[source as usize];
        }
    }
}
