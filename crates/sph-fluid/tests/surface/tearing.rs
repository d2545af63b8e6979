//! Fluid that is pulled from all sides: it must not tear, as liquid does not under the tension of a hollow surface.

use crate::patch::find;
use nalgebra::Vector3;
use sph_fluid::{FluidControls, FluidPatch, PatchStart, Renewal, SurfaceTension, Tait};
use sph_kernel::KernelKind;

/// Particles along each edge of a box that repeats.
const EDGE: usize = 8;

#[test]
fn fluid_under_negative_pressure_does_not_tear() {
    // Measured 0.93, that of its mean density. Where shifting goes by the fluid's own speed alone, voids open: 0.41,
    // later 0.26.
    let kernel = KernelKind::WendlandC2.with_smoothing_length(1.5);
    let controls = FluidControls {
        dynamic_viscosity: 0.2,
        density_diffusion: 0.1,
        surface_tension: Some(SurfaceTension::new(1.0, 0.0, 0.0).unwrap()),
        renewal: Some(Renewal::default()),
        ..FluidControls::new(kernel, Tait::new(1.0, 12.0, 7.0).unwrap())
    };
    let along = |k: usize| Vector3::new(k % EDGE, k / EDGE % EDGE, k / EDGE / EDGE).map(|x| x as f64);
    // Off the lattice by golden turns, a tenth of a spacing at most.
    let off = |k: usize| {
        Vector3::new(0.618_034, 0.754_878, 0.569_840).map(|turn| 0.2 * ((k as f64 * turn).fract() - 0.5))
    };
    let positions: Vec<_> = (0..EDGE.pow(3)).map(|k| along(k) + off(k)).collect();
    let start = PatchStart {
        periods: [Some(EDGE as f64); 3],
        pressure: |_| -8.0,
        ..PatchStart::free(positions, vec![1.0; EDGE.pow(3)], 1.0)
    };
    let mut patch = FluidPatch::new(start, controls, find).unwrap();
    patch.run_to(10.0, 0.05);
    let emptiest = patch.colours().into_iter().fold(f64::INFINITY, f64::min);
    println!("pulled box: lowest colour {emptiest:.3}, largest speed {:.3}", patch.largest_speed());
    assert!(emptiest > 0.85, "{emptiest}");
}
