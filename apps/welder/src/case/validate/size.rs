//! How many particles a scene needs at least, against the budget and the memory of the machine.

use super::super::problem::Problem;
use super::super::scene::{Budget, Levels, Scene};
use super::super::source::Source;
use super::findings::Findings;
use super::plausible::number;

/// Memory of one particle with its row of neighbours, in bytes; a low estimate.
const BYTES_PER_PARTICLE: f64 = 400.0;

/// Refuses scenes that are surely too large; the exact count is known only when the particles are placed.
pub fn check(source: &Source, scene: &Scene) -> Vec<Problem> {
    let mut findings = Findings::new(source, "");
    let coarser = |factor: f64| number(scene.resolution.spacing_m * factor.cbrt());
    let other = "a smaller part, levels: Auto";
    check_count(&mut findings, "resolution.spacing_m", least_particles(scene), &scene.budget, coarser, other);
    findings.into_problems()
}

/// Refuses more particles than the budget or the memory hold. `coarser` gives the spacing that makes a factor fewer of them;
/// `other` is what else helps.
pub fn check_count(
    findings: &mut Findings,
    field: &str,
    particles: f64,
    budget: &Budget,
    coarser: impl Fn(f64) -> String,
    other: &str,
) {
    let most = budget.max_particles;
    let reason = format!("gives at least {particles:.2e} particles, beyond budget.max_particles = {most}");
    let remedy = format!(
        "accepted: about {} m or more, or a larger budget.max_particles, {other}",
        coarser(particles / most as f64)
    );
    let fits = findings.require(particles <= most as f64, field, &reason, remedy);
    if let (true, Some((bytes, origin))) = (fits, memory(budget)) {
        let wanted = particles * BYTES_PER_PARTICLE;
        let reason = format!(
            "gives at least {particles:.2e} particles and {wanted:.2e} bytes, beyond {origin} ({bytes:.2e})"
        );
        let remedy = format!("accepted: about {} m or more, or {other}", coarser(wanted / bytes));
        findings.require(wanted <= bytes, field, &reason, remedy);
    }
}

/// A lower bound of the number of particles.
pub fn least_particles(scene: &Scene) -> f64 {
    let part_m3: f64 = scene.part.size_m.iter().product();
    let fine_m3 = match scene.resolution.levels {
        Levels::Uniform => part_m3,
        Levels::FineBox { low_m, high_m } => shared_m3(scene, low_m, high_m),
        Levels::Auto => beam_m3(scene),
    };
    // Beyond the fine box spacings double several times; what they add is left out.
    fine_m3 / scene.resolution.spacing_m.powi(3)
}

fn shared_m3(scene: &Scene, low_m: [f64; 3], high_m: [f64; 3]) -> f64 {
    let (part_low_m, part_high_m) = (scene.part.low_m(), scene.part.high_m());
    let length = |axis: usize| high_m[axis].min(part_high_m[axis]) - low_m[axis].max(part_low_m[axis]);
    (0..3).map(|axis| length(axis).max(0.0)).product()
}

/// The room that the beam itself needs: one radius around its start, one radius deep.
fn beam_m3(scene: &Scene) -> f64 {
    let Some(laser) = &scene.laser else { return 0.0 };
    let Ok(track) = laser.path.track() else { return 0.0 };
    let (radius_m, start) = (laser.beam.radius_m(), track.points()[0]);
    let low_m = [start.x_m - radius_m, start.y_m - radius_m, -radius_m];
    shared_m3(scene, low_m, [start.x_m + radius_m, start.y_m + radius_m, 0.0])
}

/// The memory that may be used, in bytes, and who says so.
pub(crate) fn memory(budget: &Budget) -> Option<(f64, &'static str)> {
    match budget.max_memory_bytes {
        Some(bytes) => Some((bytes as f64, "budget.max_memory_bytes")),
        None => Some((available_bytes()?, "the free memory of this machine")),
    }
}

/// Free memory as Linux reports it; unknown elsewhere.
fn available_bytes() -> Option<f64> {
    let report = std::fs::read_to_string("/proc/meminfo").ok()?;
    let line = report.lines().find(|line| line.starts_with("MemAvailable:"))?;
    let kibibytes: f64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(kibibytes * 1024.0)
}
