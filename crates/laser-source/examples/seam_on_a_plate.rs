//! A seam over the edge of a plate: where its energy goes, and what one evaluation of the surface costs.

use std::time::Instant;

use laser_source::{Absorption, Beam, Error, Gaussian, LaserSource, Path, Rectangle, SurfacePatches};

/// Side of a square (m).
const SIDE_M: f64 = 50e-6;
/// Squares along and across the plate.
const COUNT: [usize; 2] = [240, 80];

fn main() -> Result<(), Error> {
    let source = LaserSource::new(
        Beam::Gaussian(Gaussian::from_radius_1e2(0.6e-3)),
        // It leaves the plate of 12 mm half a beam radius beyond its end.
        Path::Straight {
            from_m: [2e-3, 0.0],
            to_m: [12.3e-3, 0.0],
            speed_m_s: 0.1,
            power_w: 900.0,
            start_s: 0.0,
        },
        Absorption::Surface { absorptivity: 0.35 },
    )?;
    let face = Rectangle { x_min_m: 0.0, x_max_m: 12e-3, y_min_m: -2e-3, y_max_m: 2e-3 };
    let end_s = source.track().end_time();
    println!("{:#?}", source.audit(0.0, end_s, &face));

    let mut plate = squares()?;
    let mut absorbed_w = vec![0.0; plate.len()];
    let (steps, start) = (400, Instant::now());
    let dt_s = end_s / f64::from(steps);
    for step in 0..steps {
        plate.accumulate(&source, dt_s * f64::from(step), dt_s * f64::from(step + 1), 1.0, &mut absorbed_w);
    }
    let cost_us = start.elapsed().as_secs_f64() * 1e6 / f64::from(steps);
    let energy_j: f64 = absorbed_w.iter().sum::<f64>() * dt_s;
    println!("{} squares took {cost_us:.1} us a step and {energy_j:.9} J in all", plate.len());

    let start = Instant::now();
    let one_by_one_w: f64 = (0..COUNT[0] * COUNT[1])
        .map(|k| Rectangle::square(centre(k)[0], centre(k)[1], 0.5 * SIDE_M))
        .map(|square| source.mean_absorbed_power(0.0, dt_s, &square))
        .sum();
    let cost_us = start.elapsed().as_secs_f64() * 1e6;
    println!("one by one the first step takes {cost_us:.1} us and gives {one_by_one_w:.6} W");
    Ok(())
}

/// Centre of square k (m).
fn centre(k: usize) -> [f64; 2] {
    let (i, j) = (k / COUNT[1], k % COUNT[1]);
    [(i as f64 + 0.5) * SIDE_M, (j as f64 + 0.5 - 0.5 * COUNT[1] as f64) * SIDE_M]
}

/// The plate in squares.
fn squares() -> Result<SurfacePatches, Error> {
    let (x_m, y_m): (Vec<f64>, Vec<f64>) =
        (0..COUNT[0] * COUNT[1]).map(|k| (centre(k)[0], centre(k)[1])).unzip();
    let half_width_m = vec![0.5 * SIDE_M; x_m.len()];
    SurfacePatches::new(&x_m, &y_m, &half_width_m)
}
