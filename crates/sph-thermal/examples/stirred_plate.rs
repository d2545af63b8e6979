//! Heat in particles that move: a plate (in two dimensions) that is stirred while it conducts.
//!
//! The motion is given; what is shown is conduction by `conduction::moving`, whose weights are computed anew from each
//! row as it is met. Images continue the plate across its four faces. `cargo run -p sph-thermal --example stirred_plate`

use nalgebra::Vector2;
use sph_kernel::{KernelKind, ScaledKernel};
use sph_thermal::conduction::moving::{Fields, heat, moments};
use sph_thermal::conduction::{Images, Planes};
use std::f64::consts::PI;

/// Particles along a side of the unit plate.
const SIDE: usize = 20;
const SPACING: f64 = 1.0 / SIDE as f64;

/// Diffusivity and largest speed: a Peclet number of 20 on the plate.
const DIFFUSIVITY: f64 = 0.05;
const SPEED: f64 = 1.0;

fn main() {
    let kernel = KernelKind::CubicSpline.with_smoothing_length::<2>(1.3 * SPACING);
    let cell = |n: usize| Vector2::new((n % SIDE) as f64 + 0.5, (n / SIDE) as f64 + 0.5);
    let mut positions: Vec<_> = (0..SIDE * SIDE).map(|n| SPACING * cell(n)).collect();
    let mut temperature: Vec<f64> = positions.iter().map(|p| f64::from(u8::from(p.x < 0.5))).collect();
    let volume = SPACING * SPACING;
    let step = 0.1 * SPACING * SPACING / DIFFUSIVITY;

    println!("  time   hottest   coldest   heat of the plate");
    for number in 0..=400 {
        if number % 80 == 0 {
            let hottest = temperature.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let coldest = temperature.iter().copied().fold(f64::INFINITY, f64::min);
            let total = volume * temperature.iter().sum::<f64>();
            println!("{:6.3} {hottest:9.4} {coldest:9.4} {total:19.15}", number as f64 * step);
        }
        let potential: Vec<f64> = temperature.iter().map(|t| DIFFUSIVITY * t).collect();
        let heat = conduct(&positions, &potential, volume, &kernel);
        temperature.iter_mut().zip(heat).for_each(|(t, heat)| *t += step * heat / volume);
        positions.iter_mut().for_each(|p| *p = stirred(*p, step));
    }
    let total = volume * temperature.iter().sum::<f64>();
    assert!((total - 0.5).abs() < 1e-12, "heat was made or lost: {total}");
}

// ANCHOR: conduct
/// Heat that each particle receives at potentials k T.
fn conduct(positions: &[Vector2<f64>], potential: &[f64], volume: f64, kernel: &ScaledKernel<2>) -> Vec<f64> {
    // Particles first, images after them; an image carries what its source carries.
    let count = positions.len();
    let reach = vec![kernel.support_radius(); count];
    let images = Images::new(positions, &reach, &Planes::adiabatic_box([0.0; 2], [1.0; 2]));
    let everything: Vec<_> = positions.iter().chain(&images.position).copied().collect();
    let volumes = vec![volume; everything.len()];
    let near = |i: usize| {
        let within = |&j: &u32| {
            j as usize != i && (positions[i] - everything[j as usize]).norm() < kernel.support_radius()
        };
        (0..everything.len() as u32).filter(within).collect()
    };
    let rows: Vec<Vec<u32>> = (0..count).map(near).collect();

    let own = moments(count, &everything, &volumes, |i| &rows[i], kernel);
    let of_source = |column: &[f64]| -> Vec<f64> {
        column.iter().copied().chain(images.source.iter().map(|&source| column[source as usize])).collect()
    };
    let (moment, potential) = (of_source(&own), of_source(potential));
    let fields = Fields { volume: &volumes, moment: &moment, potential: &potential };
    heat(count, &everything, &fields, |i| &rows[i], kernel)
}
// ANCHOR_END: conduct

/// Where a particle is after `step` in the vortex u = (sin pi x cos pi y, -cos pi x sin pi y), by the midpoint rule.
fn stirred(p: Vector2<f64>, step: f64) -> Vector2<f64> {
    let velocity = |p: Vector2<f64>| {
        let (x, y) = (PI * p.x, PI * p.y);
        SPEED * Vector2::new(x.sin() * y.cos(), -x.cos() * y.sin())
    };
    p + step * velocity(p + 0.5 * step * velocity(p))
}
