use super::*;
use crate::absorption::Absorption;
use crate::beam::{Beam, GaussianHuEberhard};
use crate::path::{Path, Pulse};
use crate::rectangle::Rectangle;
use crate::source::tests::{GAUSSIAN, TOP_HAT, seam};
use proptest::prelude::*;

const PAPER: Beam = Beam::GaussianHuEberhard(GaussianHuEberhard { radius_1e_m: 1.0 });

/// Columns of a regular plane of squares around the origin, `2 count` along each side of length `2
/// half_side_m`.
fn plane(count: i32, half_side_m: f64) -> [Vec<f64>; 3] {
    let half = 0.5 * half_side_m / f64::from(count);
    let mut columns = [Vec::new(), Vec::new(), Vec::new()];
    for i in -count..count {
        for j in -count..count {
            columns[0].push((2.0 * f64::from(i) + 1.0) * half);
            columns[1].push((2.0 * f64::from(j) + 1.0) * half);
            columns[2].push(half);
        }
    }
    columns
}

fn patches(columns: &[Vec<f64>; 3]) -> SurfacePatches {
    SurfacePatches::new(&columns[0], &columns[1], &columns[2]).unwrap()
}

/// Holds the batch against one square at a time.
fn worst_difference(source: &LaserSource, columns: &[Vec<f64>; 3], t0_s: f64, t1_s: f64) -> f64 {
    let mut out = vec![0.0; columns[0].len()];
    patches(columns).accumulate(source, t0_s, t1_s, 1.0, &mut out);
    let difference = |i: usize| {
        let square = Rectangle::square(columns[0][i], columns[1][i], columns[2][i]);
        (out[i] - source.mean_absorbed_power(t0_s, t1_s, &square)).abs()
    };
    (0..out.len()).map(difference).fold(0.0, f64::max)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]
    #[test]
    fn batch_equals_one_at_a_time_on_scattered_squares_of_all_sizes(
        kind in 0..3_usize, start in 0.5..3.0_f64, step in 1e-3..1.0_f64,
        squares in proptest::collection::vec((-9.0..9.0_f64, -9.0..9.0_f64, 1e-3..9.0_f64), 1..60),
    ) {
        let columns = [0, 1, 2].map(|k| squares.iter().map(|s| [s.0, s.1, s.2][k]).collect::<Vec<f64>>());
        let source = seam([GAUSSIAN, TOP_HAT, PAPER][kind]);
        let worst = worst_difference(&source, &columns, start, start + step);
        prop_assert!(worst < 1e-9, "{worst}");
    }
}

#[test]
fn batch_equals_one_at_a_time_on_a_plane_to_round_off() {
    for beam in [GAUSSIAN, TOP_HAT, PAPER] {
        let worst = worst_difference(&seam(beam), &plane(20, 8.0), 1.3, 1.9);
        assert!(worst < 1e-11, "{worst}");
    }
}

#[test]
fn plane_receives_all_that_is_absorbed() {
    for beam in [GAUSSIAN, TOP_HAT, PAPER] {
        let source = seam(beam);
        let columns = plane(30, 12.0);
        let mut out = vec![0.0; columns[0].len()];
        patches(&columns).accumulate(&source, 0.0, 4.0, 1.0, &mut out);
        let sum: f64 = out.iter().sum();
        let absorbed_w = source.absorbed_energy(0.0, 4.0) / 4.0;
        assert!((sum / absorbed_w - 1.0).abs() < 1e-13, "{sum} {absorbed_w}");
    }
}

#[test]
fn squares_of_two_sizes_tile_without_gap() {
    // A fine block in the middle of a coarse plane, as nested levels of particles have it.
    let (coarse, fine) = (plane(10, 10.0), plane(6, 3.0));
    let outside = |i: usize| coarse[0][i].abs() > 3.0 || coarse[1][i].abs() > 3.0;
    let columns = [0, 1, 2].map(|k| {
        let kept = (0..coarse[k].len()).filter(|&i| outside(i)).map(|i| coarse[k][i]);
        kept.chain(fine[k].iter().copied()).collect::<Vec<f64>>()
    });
    let pulse = Pulse::Constant { start_s: 0.0, duration_s: 1.0, power_w: 100.0 };
    let path = Path::Spot { position_m: [0.1, 0.2], pulse };
    let source = LaserSource::new(GAUSSIAN, path, Absorption::Surface { absorptivity: 0.5 }).unwrap();
    let mut out = vec![0.0; columns[0].len()];
    patches(&columns).accumulate(&source, 0.0, 1.0, 1.0, &mut out);
    assert!((out.iter().sum::<f64>() - 50.0).abs() < 1e-12);
}

#[test]
fn adds_with_scale_and_nothing_without_duration() {
    let (source, columns) = (seam(GAUSSIAN), plane(4, 2.0));
    let (mut once, mut twice) = (vec![0.0; 64], vec![1.0; 64]);
    let mut patches = patches(&columns);
    patches.accumulate(&source, 1.0, 1.5, 1.0, &mut once);
    patches.accumulate(&source, 1.0, 1.5, 2.0, &mut twice);
    assert!((0..64).all(|i| once[i] > 0.0 && (twice[i] - 1.0 - 2.0 * once[i]).abs() < 1e-14));
    patches.accumulate(&source, 1.5, 1.5, 1.0, &mut once);
    patches.accumulate(&source, 9.0, 9.5, 1.0, &mut once);
    assert!((0..64).all(|i| (twice[i] - 1.0 - 2.0 * once[i]).abs() < 1e-14));
}

#[test]
fn bad_columns_are_named() {
    let message = |x: &[f64], y: &[f64], h: &[f64]| SurfacePatches::new(x, y, h).unwrap_err().to_string();
    assert_eq!(message(&[0.0], &[], &[1.0]), "column y_m has 0 entries, but column x_m has 1");
    assert!(message(&[0.0, 1.0], &[0.0; 2], &[1.0, 0.0]).starts_with("half_width_m[1] is 0"));
    assert!(message(&[0.0, f64::NAN], &[0.0; 2], &[1.0; 2]).starts_with("x_m[1] is NaN"));
    assert!(SurfacePatches::new(&[], &[], &[]).unwrap().is_empty());
}
