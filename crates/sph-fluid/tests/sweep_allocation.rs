//! An evaluation of the plain sweep with all its passes allocates nothing once its columns have their size.

mod counting;

use counting::allocations_of;
use nalgebra::Vector3;
use sph_fluid::{FluidControls, FluidFields, FluidSweep, Renewal, SurfaceTension, Tait, ThermalExpansion};
use sph_kernel::KernelKind;
use sph_neighbors::{PairReach, SearchMethod};

/// Fluid in a corner of a block whose other particles are walls.
const COUNT: usize = 11;
const FLUID: usize = 700;

#[test]
fn an_evaluation_allocates_nothing() {
    let place = |k: usize| Vector3::new(k % COUNT, k / COUNT % COUNT, k / (COUNT * COUNT)).map(|x| x as f64);
    let positions: Vec<_> = (0..COUNT.pow(3)).map(place).collect();
    let velocities: Vec<_> = positions.iter().map(|r| Vector3::new(0.1 * r.y, -0.1 * r.x, 0.0)).collect();
    let temperatures: Vec<f64> = positions.iter().map(|r| 1000.0 + r.x).collect();
    let (masses, mut densities) = (vec![1.0; positions.len()], vec![1.0; positions.len()]);
    let kernel = KernelKind::WendlandC2.with_smoothing_length(1.3);
    let controls = FluidControls {
        dynamic_viscosity: 0.1,
        artificial_viscosity: 0.1,
        density_diffusion: 0.1,
        surface_tension: Some(SurfaceTension::new(1.0, -1e-3, 1000.0).unwrap()),
        renewal: Some(Renewal::default()),
        thermal_expansion: Some(ThermalExpansion::new(1e-5, 1000.0).unwrap()),
        viscous_heating: true,
        corrected_gradients: true,
        ..FluidControls::new(kernel, Tait::new(1.0, 10.0, 7.0).unwrap())
    };
    let list = SearchMethod::default().find(&positions, PairReach::Uniform(3.0)).unwrap();
    let fields = FluidFields {
        positions: &positions,
        velocities: &velocities,
        masses: &masses,
        temperatures: &temperatures,
        list_starts: list.starts(),
        list_neighbors: list.indices(),
        ..FluidFields::default()
    };
    let mut sweep = FluidSweep::new(controls).unwrap();
    let mut accelerations = vec![Vector3::zeros(); FLUID];
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let mut evaluate = |times: usize| {
        let run = || {
            (0..times).for_each(|_| sweep.accelerations(&fields, &mut densities, 1e-3, &mut accelerations))
        };
        pool.install(|| allocations_of(run))
    };
    assert!(evaluate(2) > 0, "the first columns allocate, or nothing is counted");
    assert_eq!(evaluate(5), 0);
}
