//! What a step of an elastic bar costs in 3-D in the total-Lagrangian form and in both updated-Lagrangian ones, with the
//! same neighbours: `solid_cost [LENGTH] [WIDTH] [STEPS] [SUPPORT]`.
//!
//! A bar of LENGTH x WIDTH x WIDTH particles (default 40 x 12 x 12) in Morton order, Wendland C2 with a support of SUPPORT
//! spacings (2.6), swings along its length. Steps are whole ones: kick, drift, forces, and lists as they are needed.
//! Directed pairs are those inside the support at the start, counted once a step, however often they are visited.
//! Threads as RAYON_NUM_THREADS says. Lines that begin with RESULT are for programs: seconds of the clock and of the
//! processor for all steps.

mod processor;

use nalgebra::{SVector, Vector3};
use processor::processor_seconds;
use rayon::prelude::*;
use sph_kernel::KernelKind;
use sph_neighbors::{NeighborList, PairReach, SearchMethod, SkinnedList, spatial_order};
use sph_solid::{
    Controls, Inelastic, IsotropicModuli, Material, Motion, ReferenceColumns, SymmetricTensor,
    TotalLagrangian, UpdatedControls, UpdatedFields, UpdatedLagrangian, UpdatedState,
};
use std::time::Instant;

/// Distance between particles \[m\].
const SPACING: f64 = 1e-3;
const DENSITY: f64 = 2700.0;
const MASS: f64 = DENSITY * SPACING * SPACING * SPACING;
const TEMPERATURE: f64 = 293.0;
/// How far pairs of the updated forms may close in before their list is made anew \[spacings\].
const SKIN: f64 = 0.3;
/// Courant number of the pressure wave.
const COURANT: f64 = 0.3;
/// Largest speed \[m/s\], small beside the sound's.
const SPEED: f64 = 10.0;
/// Particles that one task takes where nothing but columns is read.
const TASK: usize = 4096;

type Error = Box<dyn std::error::Error>;

/// The bar at rest.
struct Bar {
    positions: Vec<Vector3<f64>>,
    /// At the start \[m/s\].
    velocities: Vec<Vector3<f64>>,
    list: NeighborList,
    material: Material,
    smoothing_length: f64,
    steps: usize,
}

impl Bar {
    fn new(length: usize, width: usize, steps: usize, support: f64) -> Result<Self, Error> {
        let site = |k: usize| Vector3::new(k % length, k / length % width, k / length / width);
        let sites = (0..length * width * width).map(|k| site(k).map(|index| index as f64 * SPACING));
        let mut positions: Vec<_> = sites.collect();
        spatial_order(&positions, SPACING)?.apply(&mut positions);
        let phase = std::f64::consts::PI / (length as f64 * SPACING);
        let reach = PairReach::Uniform(support * SPACING);
        Ok(Self {
            velocities: positions
                .iter()
                .map(|x| Vector3::new(SPEED * (phase * x.x).sin(), 0.0, 0.0))
                .collect(),
            list: SearchMethod::default().find(&positions, reach)?,
            material: Material::elastic(IsotropicModuli::from_young_and_poisson(70e9, 0.33)?, DENSITY)?,
            smoothing_length: 0.5 * support * SPACING,
            positions,
            steps,
        })
    }

    /// Takes one step to warm up and then times the rest.
    fn report(&self, form: &str, mut step: impl FnMut()) {
        step();
        let (start, processor) = (Instant::now(), processor_seconds());
        (0..self.steps).for_each(|_| step());
        let (seconds, processor) = (start.elapsed().as_secs_f64(), processor_seconds() - processor);
        let (particles, pairs, steps) = (self.positions.len(), self.list.pairs(), self.steps);
        let rate = 1e-6 * steps as f64 / seconds;
        println!(
            "{form:18} {:7.3} million particle-steps, {:6.1} million directed pairs a second",
            rate * particles as f64,
            rate * pairs as f64
        );
        println!(
            "RESULT scene=elastic form={form} particles={particles} pairs={pairs} steps={steps} \
             seconds={seconds:.4} processor_seconds={processor:.2} threads={}",
            rayon::current_num_threads()
        );
    }

    fn total(&self) -> Result<(), Error> {
        let particles = self.positions.len();
        let temperatures = vec![TEMPERATURE; particles];
        let columns = ReferenceColumns {
            positions: &self.positions,
            volumes: &vec![SPACING.powi(3); particles],
            masses: &vec![MASS; particles],
            temperatures: &temperatures,
            smoothing_lengths: &vec![self.smoothing_length; particles],
            list_starts: self.list.starts(),
            list_neighbors: self.list.indices(),
        };
        let material = self.material.clone();
        let mut body = TotalLagrangian::new(&columns, KernelKind::WendlandC2, material, Controls::default())?;
        let mut displacements = vec![SVector::zeros(); particles];
        let mut velocities = self.velocities.clone();
        let mut accelerations = vec![SVector::zeros(); particles];
        let (mut strains, mut equivalents) = (vec![SymmetricTensor::zero(); particles], vec![0.0; particles]);
        let dt = body.stable_step(COURANT);
        self.report("total", || {
            kick_and_drift(&mut velocities, &mut displacements, &accelerations, dt);
            let motion =
                Motion { displacements: &displacements, velocities: &[], temperatures: &temperatures };
            let mut inelastic = Inelastic { strains: &mut strains, equivalents: &mut equivalents };
            body.accelerations(&motion, &mut inelastic, &mut accelerations);
        });
        Ok(())
    }

    fn updated(&self, form: &str, controls: UpdatedControls<3>) -> Result<(), Error> {
        let particles = self.positions.len();
        let temperatures = vec![TEMPERATURE; particles];
        let masses = vec![MASS; particles];
        let mut body = UpdatedLagrangian::new(particles, self.material.clone(), controls)?;
        let (mut positions, mut velocities) = (self.positions.clone(), self.velocities.clone());
        let mut accelerations = vec![SVector::zeros(); particles];
        let mut densities = vec![DENSITY; particles];
        let mut deviators = vec![SymmetricTensor::zero(); particles];
        let mut equivalents = vec![0.0; particles];
        let support = PairReach::Uniform(controls.kernel.support_radius());
        let mut list = SkinnedList::new(SearchMethod::default(), &positions, support, SKIN * SPACING)?;
        let modulus = self.material.solver_moduli();
        let wave = sph_solid::pressure_wave_speed(modulus, DENSITY);
        let dt = sph_solid::stable_step(self.smoothing_length, wave, COURANT);
        self.report(form, || {
            kick_and_drift(&mut velocities, &mut positions, &accelerations, dt);
            list.update(&positions).expect("finite positions");
            let fields = UpdatedFields {
                positions: &positions,
                velocities: &velocities,
                masses: &masses,
                temperatures: &temperatures,
                list_starts: list.list().starts(),
                list_neighbors: list.list().indices(),
            };
            let mut state = UpdatedState {
                densities: &mut densities,
                deviators: &mut deviators,
                equivalents: &mut equivalents,
            };
            body.accelerations(&fields, &mut state, dt, &mut accelerations);
        });
        Ok(())
    }
}

/// Velocities by a whole kick \[m/s\] and places by a drift \[m\].
fn kick_and_drift(
    velocities: &mut [Vector3<f64>],
    places: &mut [Vector3<f64>],
    accelerations: &[Vector3<f64>],
    dt: f64,
) {
    let columns = velocities.par_iter_mut().zip(places).zip(accelerations).with_min_len(TASK);
    columns.for_each(|((velocity, place), acceleration)| {
        *velocity += acceleration * dt;
        *place += *velocity * dt;
    });
}

fn main() -> Result<(), Error> {
    let argument = |k: usize| std::env::args().nth(k);
    let length: usize = argument(1).map_or(Ok(40), |text| text.parse())?;
    let width: usize = argument(2).map_or(Ok(12), |text| text.parse())?;
    let steps: usize = argument(3).map_or(Ok(10), |text| text.parse())?;
    let support: f64 = argument(4).map_or(Ok(2.6), |text| text.parse())?;
    let bar = Bar::new(length, width, steps, support)?;
    let particles = bar.positions.len();
    println!("{particles} particles, {:.1} neighbours", bar.list.pairs() as f64 / particles as f64);
    let kernel = KernelKind::WendlandC2.with_smoothing_length(bar.smoothing_length);
    bar.total()?;
    bar.updated("updated-corrected", UpdatedControls::corrected(kernel, SPACING))?;
    bar.updated("updated-paper", UpdatedControls::paper(kernel, SPACING))
}
