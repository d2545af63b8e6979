//! The packed sweep against the plain laws it stands for.

use nalgebra::SVector;
use sph_fluid::{
    Fields, FluidControls, FluidFields, FluidSweep, PackedFields, PackedParticle, PackedRates, PackedRows,
    PackedSweep, Tait, Viscosity, artificial_acceleration, corrected_diffusion, density_rate, leading_part,
    viscous_acceleration, volume_pressure_acceleration,
};
use sph_kernel::{KernelKind, RowBuffer};
use sph_neighbors::{BlockedPairs, PairReach, SearchMethod};

const SMOOTHING_LENGTH: f64 = 1.3;

/// Gives the rows of a block.
type Rows<'a> = &'a (dyn Fn(usize) -> PackedRows<'a> + Sync);

/// A disordered cube at unit spacing: fluid, copies of fluid, walls, in this order.
struct Cloud<const D: usize> {
    particles: Vec<PackedParticle<D>>,
    /// Velocities that friction sees of the walls.
    wall_velocities: Vec<SVector<f64, D>>,
    fluid: usize,
    controls: FluidControls<D>,
    pairs: BlockedPairs<D>,
}

impl<const D: usize> Cloud<D> {
    /// Particles below `walls` on the last axis are walls; of the others, those below `copies` on the first are copies.
    fn new(count: usize, kernel: KernelKind, [copies, walls]: [f64; 2]) -> Self {
        let mut state = 0x9e37_79b9_7f4a_7c15_u64;
        let mut random = move || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            2.0 * (state >> 11) as f64 / (1_u64 << 53) as f64 - 1.0
        };
        let kernel = kernel.with_smoothing_length::<D>(SMOOTHING_LENGTH);
        let controls = FluidControls {
            dynamic_viscosity: 0.3,
            artificial_viscosity: 0.2,
            density_diffusion: 0.1,
            body_acceleration: SVector::from_fn(|axis, _| 0.4 - 5.0 * axis as f64),
            ..FluidControls::new(kernel, Tait::new(2.0, 20.0, 7.0).unwrap())
        };
        let site = |k: usize, axis: usize| (k / count.pow(axis as u32) % count) as f64;
        let mut particles: Vec<_> = (0..count.pow(D as u32))
            .map(|k| {
                let (mass, density) = (2.0 + 0.1 * random(), 2.0 + 0.02 * random());
                PackedParticle {
                    position: SVector::from_fn(|axis, _| site(k, axis) + 0.25 * random()),
                    volume: mass / density,
                    velocity: SVector::from_fn(|_, _| random()),
                    density,
                    pressure: 10.0 * random(),
                    mass,
                }
            })
            .collect();
        let group = |particle: &PackedParticle<D>| match particle.position {
            position if position[D - 1] < walls => 2,
            position if position[0] < copies => 1,
            _ => 0,
        };
        particles.sort_by_key(group);
        let fluid = particles.partition_point(|particle| group(particle) == 0);
        let mobile = particles.partition_point(|particle| group(particle) < 2);
        let wall_velocities = particles[mobile..].iter().map(|_| SVector::from_fn(|_, _| random())).collect();

        let positions: Vec<_> = particles.iter().map(|particle| particle.position).collect();
        let mut pairs = BlockedPairs::new(kernel.support_radius() + 0.3, 6.0).unwrap();
        pairs.update(&positions, fluid).unwrap();
        let sorted = pairs.order().gather(&particles[..fluid]);
        particles[..fluid].copy_from_slice(&sorted);
        Self { particles, wall_velocities, fluid, controls, pairs }
    }

    fn packed(&self) -> Vec<PackedRates<D>> {
        self.packed_by(|sweep, fields, rates| sweep.rates(fields, rates))
    }

    /// What one of the sweep's methods gives.
    fn packed_by(
        &self,
        evaluate: impl Fn(&PackedSweep<D>, &PackedFields<'_, D, Rows<'_>>, &mut [PackedRates<D>]),
    ) -> Vec<PackedRates<D>> {
        let mut rates = vec![PackedRates::zero(); self.fluid];
        let rows: Rows<'_> = &|block| {
            let rows = self.pairs.rows(block);
            PackedRows { first: rows.first, starts: rows.starts, neighbors: rows.neighbors }
        };
        let fields = PackedFields {
            particles: &self.particles,
            wall_velocities: &self.wall_velocities,
            blocks: self.pairs.blocks(),
            rows,
        };
        evaluate(&PackedSweep::new(self.controls).unwrap(), &fields, &mut rates);
        rates
    }

    /// The same, one law after the other.
    fn plain(&self) -> Vec<PackedRates<D>> {
        let column =
            |value: fn(&PackedParticle<D>) -> f64| self.particles.iter().map(value).collect::<Vec<_>>();
        let (masses, densities) = (column(|particle| particle.mass), column(|particle| particle.density));
        let (volumes, pressures) = (column(|particle| particle.volume), column(|particle| particle.pressure));
        let positions: Vec<_> = self.particles.iter().map(|particle| particle.position).collect();
        let velocities: Vec<_> = self.particles.iter().map(|particle| particle.velocity).collect();
        let mobile = self.particles.len() - self.wall_velocities.len();
        let seen = [&velocities[..mobile], &self.wall_velocities].concat();
        let fields = Fields {
            masses: &masses,
            densities: &densities,
            volumes: &volumes,
            pressures: &pressures,
            velocities: &velocities,
        };
        let FluidControls { kernel, state, body_acceleration, .. } = self.controls;
        let sound_speed = state.reference_sound_speed();
        let rest_gradient = body_acceleration * (state.reference_density() / (sound_speed * sound_speed));
        let gradients = vec![rest_gradient; positions.len()];
        let diffusivity = self.controls.density_diffusion * kernel.smoothing_length() * sound_speed;

        let list =
            SearchMethod::default().find(&positions, PairReach::Uniform(kernel.support_radius())).unwrap();
        let mut buffer = RowBuffer::default();
        (0..self.fluid)
            .map(|i| {
                let row = buffer.fill(i, list.row(i), &positions, &kernel);
                let diffusion = corrected_diffusion(&leading_part(&row, mobile), &fields, &gradients);
                let viscosity = self.controls.dynamic_viscosity;
                let artificial = self.controls.artificial_viscosity;
                PackedRates {
                    acceleration: body_acceleration
                        + volume_pressure_acceleration(&row, &fields)
                        + viscous_acceleration(&row, &fields, &seen, Viscosity::Even(viscosity))
                        + artificial_acceleration(&row, &fields, &kernel, sound_speed, artificial),
                    density_rate: density_rate(&row, &fields) + diffusivity * diffusion,
                }
            })
            .collect()
    }

    /// Largest differences of the two forms over the largest acceleration and rate.
    fn largest_error(&self) -> f64 {
        let (fast, slow) = (self.packed(), self.plain());
        let accelerations = fast.iter().zip(&slow).map(|(a, b)| (a.acceleration - b.acceleration).norm());
        let rates = fast.iter().zip(&slow).map(|(a, b)| (a.density_rate - b.density_rate).abs());
        let acceleration_scale = slow.iter().map(|rates| rates.acceleration.norm()).fold(0.0, f64::max);
        let rate_scale = slow.iter().map(|rates| rates.density_rate.abs()).fold(0.0, f64::max);
        assert!(acceleration_scale > 1.0 && rate_scale > 1.0);
        (accelerations.fold(0.0, f64::max) / acceleration_scale).max(rates.fold(0.0, f64::max) / rate_scale)
    }
}

#[test]
fn equals_the_plain_laws_between_walls_and_copies() {
    for kernel in KernelKind::ALL {
        let cloud = Cloud::<3>::new(13, kernel, [1.5, 2.5]);
        assert!(cloud.pairs.blocks() > 4 && cloud.wall_velocities.len() > 300);
        assert!(cloud.largest_error() < 1e-13, "{kernel} 3-D");
        assert!(Cloud::<2>::new(30, kernel, [1.5, 2.5]).largest_error() < 1e-13, "{kernel} 2-D");
    }
}

#[test]
fn equals_the_plain_laws_where_terms_are_absent() {
    let mut cloud = Cloud::<3>::new(11, KernelKind::WendlandC2, [f64::NEG_INFINITY; 2]);
    cloud.controls.artificial_viscosity = 0.0;
    assert_eq!(cloud.fluid, 11 * 11 * 11);
    assert!(cloud.largest_error() < 1e-13);
    let FluidControls { kernel, state, .. } = cloud.controls;
    cloud.controls = FluidControls::new(kernel, state);
    assert!(cloud.largest_error() < 1e-13);
}

#[test]
fn is_bit_identical_on_one_and_two_threads() {
    let cloud = Cloud::<3>::new(16, KernelKind::WendlandC2, [1.5, 2.5]);
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| cloud.packed())
    };
    assert_eq!(on(1), on(2));
}

#[test]
fn density_and_force_apart_are_the_same_as_together() {
    let cloud = Cloud::<3>::new(12, KernelKind::WendlandC2, [1.5, 2.5]);
    let together = cloud.packed();
    let densities = cloud.packed_by(|sweep, fields, rates| sweep.density_rates(fields, rates));
    let forces = cloud.packed_by(|sweep, fields, rates| sweep.accelerations(fields, rates));
    for (i, both) in together.iter().enumerate() {
        assert_eq!(
            (densities[i].density_rate, densities[i].acceleration),
            (both.density_rate, SVector::zeros())
        );
        assert_eq!((forces[i].density_rate, forces[i].acceleration), (0.0, both.acceleration));
    }
}

#[test]
fn density_first_is_the_step_of_the_plain_sweep() {
    let mut cloud = Cloud::<3>::new(12, KernelKind::WendlandC2, [f64::NEG_INFINITY; 2]);
    cloud.controls.density_diffusion = 0.0;
    let column = |value: fn(&PackedParticle<3>) -> f64| cloud.particles.iter().map(value).collect::<Vec<_>>();
    let (masses, mut densities) = (column(|particle| particle.mass), column(|particle| particle.density));
    let positions: Vec<_> = cloud.particles.iter().map(|particle| particle.position).collect();
    let velocities: Vec<_> = cloud.particles.iter().map(|particle| particle.velocity).collect();
    let reach = PairReach::Uniform(cloud.controls.kernel.support_radius());
    let list = SearchMethod::default().find(&positions, reach).unwrap();
    let fields = FluidFields {
        positions: &positions,
        velocities: &velocities,
        masses: &masses,
        list_starts: list.starts(),
        list_neighbors: list.indices(),
        ..FluidFields::default()
    };
    let (dt, mut accelerations) = (1e-3, vec![SVector::zeros(); positions.len()]);
    FluidSweep::new(cloud.controls).unwrap().accelerations(&fields, &mut densities, dt, &mut accelerations);

    let rates = cloud.packed_by(|sweep, fields, rates| sweep.density_rates(fields, rates));
    for (particle, rates) in cloud.particles.iter_mut().zip(&rates) {
        particle.density += rates.density_rate * dt;
    }
    PackedSweep::new(cloud.controls).unwrap().update_states(&mut cloud.particles);
    let rates = cloud.packed_by(|sweep, fields, rates| sweep.accelerations(fields, rates));
    let scale = accelerations.iter().map(SVector::norm).fold(0.0, f64::max);
    for (i, particle) in cloud.particles.iter().enumerate() {
        assert!((particle.density - densities[i]).abs() < 1e-14 * densities[i]);
        assert!((rates[i].acceleration - accelerations[i]).norm() < 1e-12 * scale);
    }
}

#[test]
fn inner_forces_keep_momentum_and_diffusion_keeps_mass() {
    let mut cloud = Cloud::<3>::new(13, KernelKind::WendlandC2, [f64::NEG_INFINITY; 2]);
    cloud.controls.body_acceleration = SVector::zeros();
    let force = |(rates, particle): (&PackedRates<3>, &PackedParticle<3>)| rates.acceleration * particle.mass;
    let found = cloud.packed();
    let sum: SVector<f64, 3> = found.iter().zip(&cloud.particles).map(force).sum();
    let scale: f64 = found.iter().zip(&cloud.particles).map(|pair| force(pair).norm()).sum();
    assert!(sum.norm() < 1e-15 * scale, "{}", sum.norm() / scale);

    cloud.particles.iter_mut().for_each(|particle| particle.velocity = SVector::zeros());
    let gained: Vec<f64> = cloud
        .packed()
        .iter()
        .zip(&cloud.particles)
        .map(|(rates, particle)| rates.density_rate * particle.volume)
        .collect();
    let scale: f64 = gained.iter().map(|gain| gain.abs()).sum();
    assert!(scale > 1.0 && gained.iter().sum::<f64>().abs() < 1e-14 * scale);
}

#[test]
fn states_follow_from_densities() {
    let mut cloud = Cloud::<2>::new(5, KernelKind::WendlandC2, [f64::NEG_INFINITY; 2]);
    PackedSweep::new(cloud.controls).unwrap().update_states(&mut cloud.particles);
    for particle in &cloud.particles {
        assert_eq!(particle.volume, particle.mass / particle.density);
        assert_eq!(particle.pressure, cloud.controls.state.pressure(particle.density));
    }
}

#[test]
fn what_has_no_fast_form_is_refused() {
    let controls = Cloud::<2>::new(3, KernelKind::WendlandC2, [f64::NEG_INFINITY; 2]).controls;
    let message = |controls| PackedSweep::new(controls).map(|_| ()).unwrap_err().to_string();
    let corrected = FluidControls { corrected_gradients: true, ..controls };
    assert!(message(corrected).contains("corrected_gradients"));
    let negative = FluidControls { dynamic_viscosity: -1.0, ..controls };
    assert_eq!(message(negative), "dynamic_viscosity is -1, but must be zero or above");
}
