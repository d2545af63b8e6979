//! What the pull of a surface that is warm in places does to its shape.

use crate::patch::find;
use nalgebra::{Matrix3, Vector2, Vector3};
use sph_fluid::{FluidControls, FluidPatch, PatchStart, Renewal, SurfaceTension, Tait};
use sph_kernel::KernelKind;
use std::f64::consts::TAU;

/// Length of the wave, rows over the height 1, tension and what it loses where it is warmest.
const LENGTH: usize = 6;
const ROWS: usize = 8;
const TENSION: f64 = 2.0;
const LOSS: f64 = 0.1;
const WALL_ROWS: usize = 4;

/// Height of the cold places over the mean for viscosity and depth 1 and tau = TENSION - LOSS cos(k x): Stokes flow
/// with the stream function f(y) sin(k x), f = a (sinh ky - ky cosh ky) + b ky sinh ky, f(1) = 0, f''(1) = k LOSS, and
/// p - 2 v_y = -tau h''. For a shallow layer, k << 1, that is 3 LOSS/(2 tau k^2): Marangoni's pull is spread over the
/// length and bends the surface over its square.
fn exact_height() -> f64 {
    let k = TAU / LENGTH as f64;
    let (s, c) = (k.sinh(), k.cosh());
    // Rows: f, f'' and what is asked for, f' and f''' of both parts.
    let (value, second) = ([s - k * c, k * s], [-k * k * (s + k * c), k * k * (2.0 * c + k * s)]);
    let (first, third) =
        ([-k * k * s, k * (s + k * c)], [-k.powi(3) * (2.0 * c + k * s), k.powi(3) * (3.0 * s + k * c)]);
    let scale = k * LOSS / (second[1] - second[0] * value[1] / value[0]);
    let parts = [-value[1] / value[0] * scale, scale];
    let of = |row: [f64; 2]| row[0] * parts[0] + row[1] * parts[1];
    (of(third) / k - 3.0 * k * of(first)) / (TENSION * k * k)
}

/// Mean height and amplitudes of cos(k x) and sin(k x) of the upper ends of all columns.
fn waves(patch: &FluidPatch<2>) -> Vector3<f64> {
    let (spacing, columns) = (patch.spacing(), LENGTH * ROWS);
    let mut tops = vec![0.0_f64; columns];
    for position in patch.positions() {
        let column = (position.x / spacing) as usize % columns;
        tops[column] = tops[column].max(position.y + 0.5 * spacing);
    }
    let (mut matrix, mut right) = (Matrix3::zeros(), Vector3::zeros());
    for (column, top) in tops.into_iter().enumerate() {
        let angle = TAU * (column as f64 + 0.5) / columns as f64;
        let basis = Vector3::new(1.0, angle.cos(), angle.sin());
        matrix += basis * basis.transpose();
        right += basis * top;
    }
    matrix.try_inverse().unwrap() * right
}

#[test]
fn a_layer_stands_as_high_where_it_is_cold_as_its_tension_asks_for() {
    let spacing = 1.0 / ROWS as f64;
    let columns = LENGTH * ROWS;
    let site = |k: usize| {
        Vector2::new((k % columns) as f64 + 0.5, (k / columns) as f64 + 0.5 - WALL_ROWS as f64) * spacing
    };
    let (walls, fluid): (Vec<_>, Vec<_>) =
        (0..columns * (ROWS + WALL_ROWS)).map(site).partition(|x| x.y < 0.0);
    let volumes = vec![spacing * spacing; fluid.len()];
    let controls = FluidControls {
        dynamic_viscosity: 1.0,
        density_diffusion: 0.1,
        surface_tension: Some(SurfaceTension::new(TENSION, -LOSS, 0.0).unwrap()),
        renewal: Some(Renewal::default()),
        ..FluidControls::new(
            KernelKind::WendlandC2.with_smoothing_length(1.5 * spacing),
            Tait::new(1.0, 15.0, 7.0).unwrap(),
        )
    };
    // Walls do not repeat: they reach a support beyond both ends.
    let beside = |shift: f64| walls.iter().map(move |x| x + Vector2::new(shift * LENGTH as f64, 0.0));
    let reached = |x: &Vector2<f64>| x.x > -0.5 && x.x < LENGTH as f64 + 0.5;
    let walls: Vec<_> = beside(-1.0).chain(beside(0.0)).chain(beside(1.0)).filter(reached).collect();
    let start = PatchStart {
        wall_velocities: vec![Vector2::zeros(); walls.len()],
        walls,
        periods: [Some(LENGTH as f64), None],
        temperature: |position: &Vector2<f64>| (TAU * position.x / LENGTH as f64).cos(),
        ..PatchStart::free(fluid, volumes, spacing)
    };
    let mut patch = FluidPatch::new(start, controls, find).unwrap();
    let dt = 0.5 * 1.5 * spacing / 15.0;
    // After five times the 1.2 in which the wave levels; single looks scatter by 5 %.
    patch.run_to(6.0, dt);
    let looks = [8.0, 10.0, 12.0, 14.0, 16.0].map(|time| {
        patch.run_to(time, dt);
        -waves(&patch).y
    });
    let ratio = looks.iter().sum::<f64>() / looks.len() as f64 / exact_height();
    println!(
        "bulge of a driven layer, {ROWS} rows: {ratio:.3} of that of Stokes flow; single looks {looks:.4?}"
    );
    assert!((ratio - 1.0).abs() < 0.15, "{ratio}");
}
