//! What a step of a weakly compressible fluid costs: the plain `FluidSweep` against the packed one, on one thread and
//! on two.
//!
//! `cargo run --release -p sph-fluid --example fluid_cost -- 200000` takes 200 000 particles (20 000 without an argument):
//! a swirl in a cube, Wendland C2, h = 1.3 spacings, step 0.25 h/c. Directed pairs are those inside the support, counted
//! once an evaluation, however often they are visited. Sweeps: median of some runs, best in brackets; steps: mean with
//! lists. A second argument leaves only the packed steps, on that many threads. Lines that begin with RESULT are for
//! programs: seconds of the clock and of the processor for all steps.

mod processor;

use nalgebra::Vector3;
use processor::processor_seconds;
use rayon::prelude::*;
use sph_fluid::{
    FluidControls, FluidFields, FluidSweep, PackedFields, PackedParticle, PackedRates, PackedRows,
    PackedSweep, Tait,
};
use sph_kernel::KernelKind;
use sph_neighbors::{BlockedPairs, PairReach, SearchMethod, SkinnedList, spatial_order};
use std::time::Instant;

/// Lengths in spacings, the density of the fluid at rest is 1, the swirl turns with a speed of 1.
const SMOOTHING_LENGTH: f64 = 1.3;
/// Of the packed steps: measured best of 0.1, 0.15, 0.2, 0.3 for a list that lives as long as neighbours move together.
const SKIN: f64 = 0.2;
/// Of the plain step, whose list lives until some particle has moved by half of it.
const PLAIN_SKIN: f64 = 0.3;
const BLOCK_EDGE: f64 = 15.0;
const SOUND_SPEED: f64 = 10.0;
const STEP: f64 = 0.25 * SMOOTHING_LENGTH / SOUND_SPEED;

const PLAIN_RUNS: usize = 3;
const PACKED_RUNS: usize = 15;
const PLAIN_STEPS: usize = 6;
const PACKED_STEPS: usize = 60;

fn controls(density_diffusion: f64) -> FluidControls<3> {
    let kernel = KernelKind::WendlandC2.with_smoothing_length(SMOOTHING_LENGTH);
    let state = Tait::new(1.0, SOUND_SPEED, 7.0).expect("valid constants");
    FluidControls { dynamic_viscosity: 0.05, density_diffusion, ..FluidControls::new(kernel, state) }
}

/// Positions of a disordered cube, in an order that is near in memory where it is near in space.
fn cube(side: usize) -> Vec<Vector3<f64>> {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut offset = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        0.1 * (2.0 * (state >> 11) as f64 / (1_u64 << 53) as f64 - 1.0)
    };
    let site = |k: usize| Vector3::new(k % side, k / side % side, k / (side * side)).map(|site| site as f64);
    let positions: Vec<_> = (0..side.pow(3)).map(|k| site(k) + Vector3::from_fn(|_, _| offset())).collect();
    spatial_order(&positions, 2.0).expect("finite positions").gather(&positions)
}

/// A swirl about the axis of a cube.
fn swirl(position: &Vector3<f64>, side: usize) -> Vector3<f64> {
    let from_axis = (position.xy() * 2.0).add_scalar(-(side as f64)) / side as f64;
    Vector3::new(-from_axis.y, from_axis.x, 0.0) / from_axis.norm().max(1.0)
}

/// Median and least time of some runs \[s\].
fn timed(runs: usize, mut work: impl FnMut()) -> [f64; 2] {
    let once = |_| {
        let start = Instant::now();
        work();
        start.elapsed().as_secs_f64()
    };
    let mut times: Vec<f64> = (0..runs).map(once).collect();
    times.sort_unstable_by(f64::total_cmp);
    [times[runs / 2], times[0]]
}

fn report_sweep(name: &str, pairs: usize, times: [f64; 2]) {
    let [median, best] = times.map(|time| 1e-6 * pairs as f64 / time);
    println!("  {name:40} {median:6.1} ({best:6.1}) million directed pairs a second");
}

/// Takes `steps` steps and returns their time \[s\].
fn report_steps(name: &str, particles: usize, pairs: usize, steps: usize, mut step: impl FnMut()) -> f64 {
    let (start, processor) = (Instant::now(), processor_seconds());
    (0..steps).for_each(|_| step());
    let (whole, processor) = (start.elapsed().as_secs_f64(), processor_seconds() - processor);
    let [pair_rate, particle_rate] = [pairs, particles].map(|count| 1e-6 * (count * steps) as f64 / whole);
    println!(
        "  {name:40} {pair_rate:6.1} million directed pairs, {particle_rate:.2} million particles a second"
    );
    println!(
        "RESULT scene=dam-break form={} particles={particles} pairs={pairs} steps={steps} seconds={whole:.4} \
         processor_seconds={processor:.2} threads={}",
        name.replace(", ", "-").replace(' ', "-"),
        rayon::current_num_threads()
    );
    whole
}

/// The plain sweep with a kept list.
struct Plain {
    sweep: FluidSweep<3>,
    list: SkinnedList<3>,
    positions: Vec<Vector3<f64>>,
    velocities: Vec<Vector3<f64>>,
    masses: Vec<f64>,
    densities: Vec<f64>,
    accelerations: Vec<Vector3<f64>>,
}

impl Plain {
    fn new(positions: &[Vector3<f64>], side: usize, diffusion: f64) -> Self {
        let controls = controls(diffusion);
        let reach = PairReach::Uniform(controls.kernel.support_radius());
        let list =
            SkinnedList::new(SearchMethod::default(), positions, reach, PLAIN_SKIN).expect("valid input");
        Self {
            sweep: FluidSweep::new(controls).expect("valid controls"),
            list,
            positions: positions.to_vec(),
            velocities: positions.iter().map(|position| swirl(position, side)).collect(),
            masses: vec![1.0; positions.len()],
            densities: vec![1.0; positions.len()],
            accelerations: vec![Vector3::zeros(); positions.len()],
        }
    }

    fn evaluate(&mut self, dt: f64) {
        let fields = FluidFields {
            positions: &self.positions,
            velocities: &self.velocities,
            masses: &self.masses,
            list_starts: self.list.list().starts(),
            list_neighbors: self.list.list().indices(),
            ..FluidFields::default()
        };
        self.sweep.accelerations(&fields, &mut self.densities, dt, &mut self.accelerations);
    }

    fn kick(&mut self) {
        for (velocity, acceleration) in self.velocities.iter_mut().zip(&self.accelerations) {
            *velocity += acceleration * (0.5 * STEP);
        }
    }

    fn step(&mut self) {
        self.kick();
        for (position, velocity) in self.positions.iter_mut().zip(&self.velocities) {
            *position += velocity * STEP;
        }
        self.list.update(&self.positions).expect("finite positions");
        self.evaluate(STEP);
        self.kick();
    }
}

/// The packed sweep with blocks of particles that are sorted anew with each list.
struct Packed {
    sweep: PackedSweep<3>,
    pairs: BlockedPairs<3>,
    particles: Vec<PackedParticle<3>>,
    rates: Vec<PackedRates<3>>,
    /// Rates of the step before.
    earlier: Vec<PackedRates<3>>,
    /// Positions, for the list.
    listed: Vec<Vector3<f64>>,
    sorted_particles: Vec<PackedParticle<3>>,
    sorted_rates: Vec<PackedRates<3>>,
    /// Time spent on lists and sorting \[s\].
    listing: f64,
    lists: usize,
}

impl Packed {
    fn new(positions: &[Vector3<f64>], side: usize, diffusion: f64) -> Self {
        let controls = controls(diffusion);
        let reach = controls.kernel.support_radius() + SKIN;
        let particle = |position: &Vector3<f64>| PackedParticle {
            position: *position,
            volume: 1.0,
            velocity: swirl(position, side),
            density: 1.0,
            pressure: 0.0,
            mass: 1.0,
        };
        let mut packed = Self {
            sweep: PackedSweep::new(controls).expect("valid controls"),
            pairs: BlockedPairs::new(reach, BLOCK_EDGE).expect("valid lengths"),
            particles: positions.iter().map(particle).collect(),
            rates: vec![PackedRates::zero(); positions.len()],
            earlier: vec![PackedRates::zero(); positions.len()],
            listed: Vec::new(),
            sorted_particles: Vec::new(),
            sorted_rates: Vec::new(),
            listing: 0.0,
            lists: 0,
        };
        packed.list();
        packed.sweep.update_states(&mut packed.particles);
        packed.evaluate(Terms::Both);
        packed.earlier.copy_from_slice(&packed.rates);
        packed
    }

    fn evaluate(&mut self, terms: Terms) {
        let Self { sweep, pairs, particles, rates, .. } = self;
        let rows = |block| {
            let rows = pairs.rows(block);
            PackedRows { first: rows.first, starts: rows.starts, neighbors: rows.neighbors }
        };
        let fields = PackedFields { particles, wall_velocities: &[], blocks: pairs.blocks(), rows };
        match terms {
            Terms::Both => sweep.rates(&fields, rates),
            Terms::Density => sweep.density_rates(&fields, rates),
            Terms::Force => sweep.accelerations(&fields, rates),
        }
    }

    /// Changes each particle by what it has received now and the step before.
    fn advance(&mut self, change: impl Fn(&mut PackedParticle<3>, &PackedRates<3>, &PackedRates<3>) + Sync) {
        let Self { particles, rates, earlier, .. } = self;
        let all = particles.par_iter_mut().zip(rates).zip(earlier).with_min_len(4096);
        all.for_each(|((particle, rates), earlier)| change(particle, rates, earlier));
    }

    fn list(&mut self) {
        self.listed.clear();
        self.listed.extend(self.particles.iter().map(|particle| particle.position));
        self.pairs.update(&self.listed, self.particles.len()).expect("finite positions");
        let order = self.pairs.order();
        order.gather_into(&self.particles, &mut self.sorted_particles);
        std::mem::swap(&mut self.particles, &mut self.sorted_particles);
        order.gather_into(&self.rates, &mut self.sorted_rates);
        std::mem::swap(&mut self.rates, &mut self.sorted_rates);
        self.lists += 1;
    }

    fn list_if_moved(&mut self) {
        let start = Instant::now();
        let Self { pairs, particles, .. } = self;
        if !pairs.holds(SKIN, |k| particles[k].position) {
            self.list();
        }
        self.listing += start.elapsed().as_secs_f64();
    }

    /// The step of the plain sweep: kick and drift, density, force, kick.
    fn step_density_first(&mut self) {
        self.advance(|particle, rates, _| {
            particle.velocity += rates.acceleration * (0.5 * STEP);
            particle.position += particle.velocity * STEP;
        });
        self.list_if_moved();
        self.evaluate(Terms::Density);
        self.advance(|particle, rates, _| particle.density += rates.density_rate * STEP);
        self.sweep.update_states(&mut self.particles);
        self.evaluate(Terms::Force);
        self.advance(|particle, rates, _| particle.velocity += rates.acceleration * (0.5 * STEP));
    }

    /// A step with one visit of each pair: velocity and density are extrapolated to the middle of the next step (Adams
    /// and Bashforth, second order), where the positions are as well.
    fn step_one_visit(&mut self) {
        self.advance(|particle, rates, earlier| {
            particle.velocity += (rates.acceleration * 1.5 - earlier.acceleration * 0.5) * STEP;
            particle.density += (rates.density_rate * 1.5 - earlier.density_rate * 0.5) * STEP;
            // The velocity between two evaluations moves the particle from one to the next.
            particle.position += (particle.velocity - rates.acceleration * (0.5 * STEP)) * STEP;
        });
        self.list_if_moved();
        std::mem::swap(&mut self.rates, &mut self.earlier);
        self.sweep.update_states(&mut self.particles);
        self.evaluate(Terms::Both);
    }

    fn run(&mut self, name: &str, pairs: usize, step: fn(&mut Self)) {
        (self.listing, self.lists) = (0.0, 0);
        let whole = report_steps(name, self.particles.len(), pairs, PACKED_STEPS, || step(self));
        let share = 100.0 * self.listing / whole;
        println!("    of it {share:.1} % for {} lists, with sorting", self.lists);
        let fastest = self.particles.iter().map(|particle| particle.velocity.norm()).fold(0.0, f64::max);
        assert!(fastest < 1.5, "the flow has exploded: a speed of {fastest}");
    }
}

#[derive(Clone, Copy)]
enum Terms {
    Both,
    Density,
    Force,
}

fn compare(positions: &[Vector3<f64>], side: usize, pairs: usize) {
    let mut plain = Plain::new(positions, side, 0.0);
    report_sweep("plain sweep without diffusion", pairs, timed(PLAIN_RUNS, || plain.evaluate(0.0)));
    let mut plain = Plain::new(positions, side, 0.1);
    report_sweep("plain sweep, corrected diffusion", pairs, timed(PLAIN_RUNS, || plain.evaluate(0.0)));
    let mut packed = Packed::new(positions, side, 0.1);
    let both = timed(PACKED_RUNS, || packed.evaluate(Terms::Both));
    report_sweep("packed sweep, one visit", pairs, both);
    let apart = timed(PACKED_RUNS, || {
        packed.evaluate(Terms::Density);
        packed.evaluate(Terms::Force);
    });
    report_sweep("packed sweep, density and force apart", pairs, apart);
    report_steps("plain step", positions.len(), pairs, PLAIN_STEPS, || plain.step());
}

fn packed_steps(positions: &[Vector3<f64>], side: usize, pairs: usize) {
    let mut packed = Packed::new(positions, side, 0.1);
    packed.run("packed step, one visit", pairs, Packed::step_one_visit);
    let mut packed = Packed::new(positions, side, 0.1);
    packed.run("packed step, density first", pairs, Packed::step_density_first);
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let particles: usize = std::env::args().nth(1).map_or(Ok(20_000), |text| text.parse())?;
    let only_threads: Option<usize> = std::env::args().nth(2).map(|text| text.parse()).transpose()?;
    let side = (particles as f64).cbrt().round() as usize;
    let positions = cube(side);
    let reach = PairReach::Uniform(controls(0.0).kernel.support_radius());
    let pairs = SearchMethod::default().find(&positions, reach)?.pairs();
    let each = pairs as f64 / positions.len() as f64;
    println!("{} particles with {each:.1} neighbours inside the support", positions.len());
    let threads = only_threads.map_or(vec![1, 2], |threads| vec![threads]);
    for threads in threads {
        println!("{threads} thread(s)");
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
        pool.install(|| {
            if only_threads.is_none() {
                compare(&positions, side, pairs);
            }
            packed_steps(&positions, side, pairs);
        });
    }
    Ok(())
}
