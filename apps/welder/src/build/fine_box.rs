//! Where fine particles are needed: the pool and a margin around it.
//!
//! The anisotropic error at a jump of spacing is a tenth of a second derivative, so the fine box must end well outside the
//! pool: a beam radius beyond it (trials: 0.4 to 0.5 mm for r_s = 0.42 mm). How large the pool gets is found by a coarse
//! run of the scene itself (see `run::pilot`); that run takes an upper bound from the energy of the beam.

use super::CellBox;
use crate::model::Model;

/// The fine box ends this many beam radii (1/e) beyond the pool and beyond the beam's path.
const MARGIN_BEAM_RADII: f64 = 1.1;

/// And at least this many finest cells beyond it.
const MARGIN_CELLS: f64 = 5.0;

/// Points along each axis at which start temperatures are looked up.
const SAMPLES: usize = 9;

/// No pool can be larger than this radius \[m\]: all absorbed energy melts a half sphere around a beam at rest, or a half
/// cylinder along a path; zero without a laser.
pub fn largest_melt_radius(model: &Model) -> f64 {
    let Some(laser) = &model.laser else { return 0.0 };
    let track = laser.track();
    let per_volume = cheapest_melt(model);
    let energy = laser.absorbed_energy(0.0, track.end_time());
    let sphere = (3.0 * energy / per_volume / std::f64::consts::TAU).cbrt();
    let speed = track.max_speed();
    if speed == 0.0 {
        return sphere;
    }
    let largest_power = track.points().iter().map(|point| point.power_w).fold(0.0, f64::max);
    let absorbed = largest_power * laser.absorption().absorptivity() * laser.beam().total();
    let cylinder = (2.0 * absorbed / speed / per_volume / std::f64::consts::PI).sqrt();
    sphere.min(cylinder)
}

/// Least energy that melts a volume of the part \[J/m³\], over a coarse grid of points.
fn cheapest_melt(model: &Model) -> f64 {
    let (low, high) = model.bounds();
    let at = |n: usize| {
        let place = [n % SAMPLES, n / SAMPLES % SAMPLES, n / SAMPLES / SAMPLES];
        let share = |axis: usize| (place[axis] as f64 + 0.5) / SAMPLES as f64;
        std::array::from_fn(|axis| low[axis] + share(axis) * (high[axis] - low[axis]))
    };
    let needed = |n: usize| {
        let (material, temperature) = (model.start)(at(n));
        let (material, curve) = (&model.materials[material as usize], &model.curves[material as usize]);
        material.density * (curve.enthalpy_solidus() - curve.enthalpy_at(temperature)).max(1.0)
    };
    (0..SAMPLES.pow(3)).map(needed).fold(f64::INFINITY, f64::min)
}

/// The box \[m\] that the lit part of the beam's path covers, a beam radius around it; the whole part without a laser.
pub fn lit_box(model: &Model) -> [[f64; 3]; 2] {
    let (low, high) = model.bounds();
    let Some(laser) = &model.laser else { return [low, high] };
    let radius = laser.beam().radius_m();
    let ends = laser.track().points().windows(2).filter(|ends| ends[0].power_w + ends[1].power_w > 0.0);
    let mut lit = [[f64::INFINITY, f64::INFINITY, 0.0], [f64::NEG_INFINITY, f64::NEG_INFINITY, 0.0]];
    for point in ends.flatten() {
        for (axis, x) in [point.x_m, point.y_m].into_iter().enumerate() {
            lit[0][axis] = lit[0][axis].min(x - radius);
            lit[1][axis] = lit[1][axis].max(x + radius);
        }
    }
    lit
}

/// How far the fine box ends beyond the pool \[m\].
pub fn margin(model: &Model) -> f64 {
    let beam = model.laser.as_ref().map_or(0.0, |laser| laser.beam().radius_m());
    (MARGIN_BEAM_RADII * beam).max(MARGIN_CELLS * model.spacing())
}

/// The box of finest cells around a pool that reaches from `low` to `high` \[m\], with a margin \[m\] on all sides.
pub fn fine_box_around(model: &Model, [low, high]: [[f64; 3]; 2], margin: f64) -> CellBox<3> {
    let spacing = model.spacing();
    let (part_low, _) = model.bounds();
    let counts = model.counts();
    let down = |x: f64, axis: usize| {
        (((x - part_low[axis] - margin) / spacing).floor() as i64).clamp(0, counts[axis])
    };
    let up = |x: f64, axis: usize| {
        (((x - part_low[axis] + margin) / spacing).ceil() as i64).clamp(0, counts[axis])
    };
    // The third axis counts cells down from the top face.
    let deepest = (((-low[2] + margin) / spacing).ceil() as i64).clamp(1, counts[2]);
    CellBox { low: [down(low[0], 0), down(low[1], 1), 0], high: [up(high[0], 0), up(high[1], 1), deepest] }
}
