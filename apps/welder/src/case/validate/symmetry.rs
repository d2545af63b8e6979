//! Mirror planes and the laser: a beam beside a plane would be mirrored into a second laser.

use laser_source::{Beam, Path, Track};

use super::super::scene::{Face, Scene};
use super::findings::Findings;
use super::plausible::number;

/// Checks that the path lies in each mirror plane, or so far from it that the mirrored beam does not matter.
pub fn check(findings: &mut Findings, scene: &Scene, beam: &Beam, track: &Track) {
    let (low_m, high_m) = (scene.part.low_m(), scene.part.high_m());
    let hull = track.bounding_box();
    let planes = [
        ("x_min", low_m[0], hull.x_min_m, hull.x_max_m),
        ("x_max", high_m[0], hull.x_min_m, hull.x_max_m),
        ("y_min", low_m[1], hull.y_min_m, hull.y_max_m),
        ("y_max", high_m[1], hull.y_min_m, hull.y_max_m),
    ];
    let named = scene.part.faces.named();
    for (name, plane_m, least_m, most_m) in planes {
        let mirrors = named.iter().any(|(face, kind)| *face == name && *kind == Face::Symmetry);
        if mirrors {
            check_plane(findings, scene, beam, (name, plane_m), (least_m, most_m));
        }
    }
}

fn check_plane(findings: &mut Findings, scene: &Scene, beam: &Beam, plane: (&str, f64), path: (f64, f64)) {
    let ((name, plane_m), (least_m, most_m)) = (plane, path);
    let inner_m = if name.ends_with("min") { least_m - plane_m } else { plane_m - most_m };
    let in_plane = (least_m - plane_m).abs().max((most_m - plane_m).abs()) < 1e-9;
    let axis = &name[..1];
    let reason = format!(
        "part.faces.{name} is a mirror plane at {axis} = {} m, and the beam's centre leaves it: its mirror image would \
         be a second laser",
        number(plane_m)
    );
    let remedy = format!(
        "keep the path at {axis} = {}, or at least {} m inside the part (the reach of the beam), or make the face Adiabatic",
        number(plane_m),
        number(beam.reach_m())
    );
    findings.require(in_plane || inner_m >= beam.reach_m(), place_field(scene), &reason, remedy);
}

fn place_field(scene: &Scene) -> &'static str {
    match scene.laser.as_ref().map(|laser| &laser.path) {
        Some(Path::Spot { .. }) => "laser.path.position_m",
        Some(Path::Straight { .. }) => "laser.path.from_m",
        _ => "laser.path.points",
    }
}
