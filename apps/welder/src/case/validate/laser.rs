//! The laser: beam against spacing, path against part and time, absorption.

use laser_source::{Absorption, Beam, Error, Path, Pulse, Track};

use super::super::scene::{Laser, Scene};
use super::findings::Findings;
use super::plausible::{
    ABSORPTION_COEFFICIENT, BEAM_RADIUS, COORDINATE, DURATION, POWER, POWER_AT_A_TIME, SHARE, SPEED, number,
};
use super::symmetry;

/// Checks the laser; the geometry only where spacing and part are usable.
pub fn check(findings: &mut Findings, scene: &Scene, laser: &Laser, lattice_is_fine: bool) {
    let beam_is_fine = check_beam(findings, scene, &laser.beam, lattice_is_fine);
    check_absorption(findings, scene, &laser.absorption, lattice_is_fine);
    let Some(track) = check_path(findings, &laser.path) else { return };
    check_start(findings, scene, &laser.path, &track);
    if lattice_is_fine {
        check_place(findings, scene, &laser.path, &track);
    }
    if lattice_is_fine && beam_is_fine {
        symmetry::check(findings, scene, &laser.beam, &track);
    }
}

fn check_beam(findings: &mut Findings, scene: &Scene, beam: &Beam, lattice_is_fine: bool) -> bool {
    let (name, per_radius) = written_radius(findings);
    let field = format!("laser.beam.{name}");
    if !findings.within(&field, beam.radius_m() * per_radius, &BEAM_RADIUS) {
        return false;
    }
    let (radius_m, spacing_m) = (beam.radius_m(), scene.resolution.spacing_m);
    if lattice_is_fine {
        let reason = format!(
            "the beam's radius {} m (1/e) is below two spacings of {} m, too narrow for the particles",
            number(radius_m),
            number(spacing_m)
        );
        let remedy = format!(
            "accepted: resolution.spacing_m at most {}, or {name} at least {}",
            number(radius_m / 2.0),
            number(2.0 * spacing_m * per_radius)
        );
        findings.require(radius_m >= 2.0 * spacing_m * (1.0 - 1e-9), &field, &reason, remedy);
    }
    true
}

/// The name under which the file gives the radius, and that radius over the one that the beam keeps.
fn written_radius(findings: &Findings) -> (&'static str, f64) {
    let given = |name: &str| findings.source.locate(&format!("laser.beam.{name}")).missing.is_empty();
    match (given("radius_1e2_m"), given("radius_1e_m")) {
        (true, _) => ("radius_1e2_m", std::f64::consts::SQRT_2),
        (_, true) => ("radius_1e_m", 1.0),
        _ => ("radius_m", 1.0),
    }
}

fn check_absorption(findings: &mut Findings, scene: &Scene, absorption: &Absorption, lattice_is_fine: bool) {
    findings.within("laser.absorption.absorptivity", absorption.absorptivity(), &SHARE);
    let Absorption::BeerLambert { absorption_coefficient_per_m, .. } = *absorption else { return };
    let field = "laser.absorption.absorption_coefficient_per_m";
    if !findings.within(field, absorption_coefficient_per_m, &ABSORPTION_COEFFICIENT) || !lattice_is_fine {
        return;
    }
    let (depth_m, spacing_m) = (1.0 / absorption_coefficient_per_m, scene.resolution.spacing_m);
    let reason = format!(
        "the absorption depth {} m is below two spacings of {} m, which particles cannot resolve",
        number(depth_m),
        number(spacing_m)
    );
    let remedy = format!(
        "use Surface(absorptivity: ..), right for metals; or resolution.spacing_m at most {}",
        number(depth_m / 2.0)
    );
    findings.require(depth_m >= 2.0 * spacing_m, field, &reason, remedy);
}

fn check_path(findings: &mut Findings, path: &Path) -> Option<Track> {
    if !check_numbers(findings, path) {
        return None;
    }
    match path.track() {
        Ok(track) => Some(track),
        Err(error) => {
            let remedy = "accepted: times that run forward, two points or more, one place at each time";
            findings.refuse(&field_of(findings, &error), &error.to_string(), remedy);
            None
        }
    }
}

fn check_numbers(findings: &mut Findings, path: &Path) -> bool {
    match path {
        Path::Spot { position_m, pulse } => {
            let place = findings.all_within("laser.path.position_m", position_m, &COORDINATE);
            check_pulse(findings, pulse) && place
        }
        Path::Straight { from_m, to_m, speed_m_s, power_w, .. } => {
            let from = findings.all_within("laser.path.from_m", from_m, &COORDINATE);
            let to = findings.all_within("laser.path.to_m", to_m, &COORDINATE);
            let speed = findings.within("laser.path.speed_m_s", *speed_m_s, &SPEED);
            findings.within("laser.path.power_w", *power_w, &POWER) && from && to && speed
        }
        Path::Polyline { points } => {
            let powers: Vec<f64> = points.iter().map(|point| point.power_w).collect();
            let places = points.iter().enumerate().fold(true, |fine, (index, point)| {
                let field = format!("laser.path.points.{index}");
                let x = findings.within(&format!("{field}.x_m"), point.x_m, &COORDINATE);
                findings.within(&format!("{field}.y_m"), point.y_m, &COORDINATE) && x && fine
            });
            check_powers(findings, "laser.path.points", &powers) && places
        }
    }
}

fn check_pulse(findings: &mut Findings, pulse: &Pulse) -> bool {
    match pulse {
        Pulse::Constant { duration_s, power_w, .. } => {
            let duration = findings.within("laser.path.pulse.duration_s", *duration_s, &DURATION);
            findings.within("laser.path.pulse.power_w", *power_w, &POWER) && duration
        }
        Pulse::Table { points, .. } => {
            let powers: Vec<f64> = points.iter().map(|point| point.power_w).collect();
            check_powers(findings, "laser.path.pulse.points", &powers)
        }
    }
}

fn check_powers(findings: &mut Findings, field: &str, powers_w: &[f64]) -> bool {
    let fine = powers_w.iter().enumerate().fold(true, |fine, (index, &power_w)| {
        findings.within(&format!("{field}.{index}.power_w"), power_w, &POWER_AT_A_TIME) && fine
    });
    let lit = powers_w.is_empty() || powers_w.iter().any(|&power_w| power_w != 0.0);
    findings.require(
        lit,
        field,
        "the laser is never on",
        "give at least one point a power, or leave `laser` out",
    ) && fine
}

fn check_start(findings: &mut Findings, scene: &Scene, path: &Path, track: &Track) {
    let start_s = track.points()[0].time_s;
    let field = match path {
        Path::Spot { .. } => "laser.path.pulse.start_s",
        Path::Straight { .. } => "laser.path.start_s",
        Path::Polyline { .. } => "laser.path.points.0.time_s",
    };
    findings.require(start_s >= 0.0, field, "before the run, which starts at 0 s", "accepted: 0 s or later");
    let reason = format!("the run ends before the laser starts at {} s", number(start_s));
    findings.require(
        scene.time.end_s > start_s,
        "time.end_s",
        &reason,
        "end the run after the laser has worked",
    );
}

/// The path in the scene of a field that laser-source names, as `points[2].time_s`.
fn field_of(findings: &Findings, error: &Error) -> String {
    let name = match error {
        Error::OutOfRange { field, .. } if field.starts_with("distance") => "to_m".to_string(),
        Error::OutOfRange { field, .. } => field.replace('[', ".").replace(']', ""),
        Error::TooFew { field, .. } => (*field).to_string(),
        _ => String::new(),
    };
    let inside = |section: &str| format!("laser.path{section}.{name}");
    let in_pulse = findings.source.locate(&inside(".pulse")).missing.is_empty();
    if in_pulse { inside(".pulse") } else { inside("") }
}

/// A spot must stand on the part; a moving beam must meet it somewhere, and may run in and out over the rim.
fn check_place(findings: &mut Findings, scene: &Scene, path: &Path, track: &Track) {
    let (low_m, high_m) = (scene.part.low_m(), scene.part.high_m());
    let hull = track.bounding_box();
    let slack_m = 1e-9;
    let meets_x = hull.x_max_m >= low_m[0] - slack_m && hull.x_min_m <= high_m[0] + slack_m;
    let meets_y = hull.y_max_m >= low_m[1] - slack_m && hull.y_min_m <= high_m[1] + slack_m;
    let remedy = format!(
        "accepted: x from {} to {} m, y from {} to {} m",
        number(low_m[0]),
        number(high_m[0]),
        number(low_m[1]),
        number(high_m[1])
    );
    let (field, reason) = match path {
        Path::Spot { .. } => ("laser.path.position_m", "the beam's centre lies off the part"),
        Path::Straight { .. } => ("laser.path.from_m", "the beam passes beside the part"),
        Path::Polyline { .. } => ("laser.path.points", "the beam passes beside the part"),
    };
    findings.require(meets_x && meets_y, field, reason, remedy);
}
