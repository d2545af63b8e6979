//! A step of the packed sweep allocates nothing, with and without new lists.

mod counting;

use counting::allocations_of;
use nalgebra::{SVector, Vector3};
use sph_fluid::{FluidControls, PackedFields, PackedParticle, PackedRates, PackedRows, PackedSweep, Tait};
use sph_kernel::KernelKind;
use sph_neighbors::BlockedPairs;

struct Fluid {
    sweep: PackedSweep<3>,
    pairs: BlockedPairs<3>,
    particles: Vec<PackedParticle<3>>,
    sorted: Vec<PackedParticle<3>>,
    positions: Vec<Vector3<f64>>,
    rates: Vec<PackedRates<3>>,
}

impl Fluid {
    fn new(count: usize) -> Self {
        let kernel = KernelKind::WendlandC2.with_smoothing_length(1.3);
        let controls = FluidControls {
            dynamic_viscosity: 0.1,
            density_diffusion: 0.1,
            ..FluidControls::new(kernel, Tait::new(1.0, 10.0, 7.0).unwrap())
        };
        let site = |k: usize| Vector3::new(k % count, k / count % count, k / (count * count));
        let particle = |k| PackedParticle {
            position: site(k).map(|coordinate| coordinate as f64),
            volume: 1.0,
            velocity: SVector::from_fn(|axis, _| ((k * (axis + 3)) % 7) as f64 - 3.0),
            density: 1.0 + 1e-3 * (k % 5) as f64,
            pressure: 0.0,
            mass: 1.0,
        };
        Self {
            sweep: PackedSweep::new(controls).unwrap(),
            pairs: BlockedPairs::new(2.9, 8.0).unwrap(),
            particles: (0..count.pow(3)).map(particle).collect(),
            sorted: Vec::new(),
            positions: Vec::new(),
            rates: vec![PackedRates::zero(); count.pow(3)],
        }
    }

    fn list(&mut self) {
        self.positions.clear();
        self.positions.extend(self.particles.iter().map(|particle| particle.position));
        self.pairs.update(&self.positions, self.particles.len()).unwrap();
        self.pairs.order().gather_into(&self.particles, &mut self.sorted);
        std::mem::swap(&mut self.particles, &mut self.sorted);
    }

    fn step(&mut self) {
        let Self { sweep, pairs, particles, rates, .. } = self;
        sweep.update_states(particles);
        let rows = |block| {
            let rows = pairs.rows(block);
            PackedRows { first: rows.first, starts: rows.starts, neighbors: rows.neighbors }
        };
        let blocks = pairs.blocks();
        sweep.rates(&PackedFields { particles, wall_velocities: &[], blocks, rows }, rates);
        for (particle, rates) in particles.iter_mut().zip(rates) {
            particle.density += 1e-6 * rates.density_rate;
            particle.velocity += 1e-6 * rates.acceleration;
        }
    }
}

#[test]
fn a_step_allocates_nothing() {
    for threads in [1, 2] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let mut fluid = Fluid::new(20);
        let mut run = |steps| {
            let run = || {
                for _ in 0..steps {
                    fluid.list();
                    (0..3).for_each(|_| fluid.step());
                }
            };
            pool.install(|| allocations_of(run))
        };
        assert!(run(3) > 0, "the first lists allocate, or nothing is counted");
        assert_eq!(run(5), 0, "{threads} threads");
    }
}
