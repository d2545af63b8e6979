//! How fast a scene of fluid is expected to flow, and on which length, before it is run.

use crate::case::fluid::{Body, FluidScene, Side, Temperature};
use std::f64::consts::PI;

/// What a scene lets expect.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Expected {
    /// Largest speed \[m/s\].
    pub speed: f64,
    /// Speed that the artificial sound must be fast against \[m/s\]: the largest of the flow's, of capillary waves, and of
    /// what friction demands.
    pub sound_needs: f64,
    /// Smallest thickness of a block or radius of a ball \[m\].
    pub length: f64,
}

/// The largest of what bodies and walls start with, of a fall over the height that there is, and of what changes of tension drive.
/// Sound must besides be fast against capillary waves, sqrt(tau/(rho L)), and, where friction rules, against sqrt(nu v/L) (Morris, Fox and
/// Zhu 1997, eq. 7). Periodic axes do not count for the length L.
pub fn expected(scene: &FluidScene) -> Expected {
    let (density, viscosity) = (scene.fluid.density_kg_m3, scene.fluid.viscosity_pa_s);
    let length = scene.bodies.iter().map(|body| thickness(scene, body)).fold(f64::INFINITY, f64::min);
    let speed = [given(scene), fall(scene), driven(scene, length)].into_iter().fold(0.0, f64::max);
    let capillary = (scene.fluid.surface_tension_n_m / (density * length)).sqrt();
    let viscous = (viscosity / density * speed / length).sqrt();
    Expected { speed, sound_needs: speed.max(capillary).max(viscous), length }
}

fn norm(values: &[f64]) -> f64 {
    values.iter().map(|value| value * value).sum::<f64>().sqrt()
}

fn periodic(scene: &FluidScene, axis: usize) -> bool {
    *scene.domain.sides.named()[axis][0].1 == Side::Periodic
}

fn thickness(scene: &FluidScene, body: &Body) -> f64 {
    match body {
        Body::Ball { radius_m, .. } => *radius_m,
        Body::Block { low_m, high_m, .. } => {
            let along = |axis: &usize| high_m.values()[*axis] - low_m.values()[*axis];
            let all = || 0..scene.dimension();
            let free = all().filter(|&axis| !periodic(scene, axis)).collect::<Vec<_>>();
            let axes = if free.is_empty() { all().collect() } else { free };
            axes.iter().map(along).fold(f64::INFINITY, f64::min)
        }
    }
}

/// The fastest body or wall at the start.
fn given(scene: &FluidScene) -> f64 {
    let bodies = scene.bodies.iter().filter_map(Body::velocity_m_s);
    let spins = scene.bodies.iter().map(|body| match body {
        Body::Block { low_m, high_m, spin_rad_s, .. } => {
            let sides: Vec<f64> =
                low_m.values().iter().zip(high_m.values()).map(|(low, high)| high - low).collect();
            0.5 * norm(&sides) * spin_rad_s.abs()
        }
        Body::Ball { .. } => 0.0,
    });
    let sides = scene.domain.sides.named();
    let walls = sides.iter().flatten().filter_map(|(_, side)| match side {
        Side::Wall { velocity_m_s } => velocity_m_s.as_ref(),
        _ => None,
    });
    bodies.chain(walls).map(|velocity| norm(velocity.values())).chain(spins).fold(0.0, f64::max)
}

/// sqrt(2 g H) over the height H between the highest fluid and the end of the domain below it. Along a periodic axis gravity
/// drives for as long as friction lets it: there the speed is that of a film of the length of the scene, g L^2/(2 nu).
fn fall(scene: &FluidScene) -> f64 {
    let Some(gravity) = &scene.gravity_m_s2 else { return 0.0 };
    let low = scene.domain.low_m.as_ref().map(|low| low.values());
    let along = |axis: usize| {
        let (g, origin) = (gravity.values()[axis], low.map_or(0.0, |low| low[axis]));
        let end = if g < 0.0 { origin } else { origin + scene.domain.size_m.values()[axis] };
        let farthest = |body: &Body| match body {
            Body::Block { low_m, high_m, .. } => {
                (low_m.values()[axis] - end).abs().max((high_m.values()[axis] - end).abs())
            }
            Body::Ball { centre_m, radius_m, .. } => (centre_m.values()[axis] - end).abs() + radius_m,
        };
        if periodic(scene, axis) {
            let length = scene.bodies.iter().map(|body| thickness(scene, body)).fold(f64::INFINITY, f64::min);
            let steady = g.abs() * length * length * scene.fluid.density_kg_m3;
            return (0.5 * steady / scene.fluid.viscosity_pa_s).min(g.abs() * scene.time.end_s).powi(2);
        }
        2.0 * g.abs() * scene.bodies.iter().map(farthest).fold(0.0, f64::max)
    };
    (0..scene.dimension()).filter(|&axis| gravity.values()[axis] != 0.0).map(along).sum::<f64>().sqrt()
}

/// Surface speed that a slope of tension drives: at most that of a steady film, and of one whose start-up has come as far as the
/// run lasts, 2 tau_T G sqrt(t/(pi rho eta)); between ends, of a boundary layer, (pull^2/(rho eta L))^(1/3) (Ostrach 1982).
fn driven(scene: &FluidScene, length: f64) -> f64 {
    let Some(Temperature::Linear { slope_k_m, .. }) = &scene.temperature else { return 0.0 };
    let pull = scene.fluid.surface_tension_slope_n_m_k.abs() * norm(slope_k_m.values()) * length;
    if pull == 0.0 {
        return 0.0;
    }
    let (density, viscosity) = (scene.fluid.density_kg_m3, scene.fluid.viscosity_pa_s);
    let started = 2.0 * pull / length * (scene.time.end_s / (PI * density * viscosity)).sqrt();
    let layered = (pull * pull / (density * viscosity * length)).cbrt();
    let endless = (0..scene.dimension()).any(|axis| periodic(scene, axis));
    (pull / viscosity).min(started).min(if endless { f64::INFINITY } else { layered })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::Loaded;

    fn scene(body: &str, more: &str) -> FluidScene {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("scene.ron");
        let text = format!(
            "Fluid(domain: (size_m: (4.0, 3.0), sides: (x_min: Wall(), x_max: Wall(), y_min: Wall())), \
             fluid: (density_kg_m3: 1000.0, viscosity_pa_s: 0.1, surface_tension_n_m: 0.09), bodies: [{body}], \
             spacing_m: 0.05, time: (end_s: 1.0), {more})"
        );
        std::fs::write(&path, text).unwrap();
        match crate::case::load_any(&path, &[]) {
            Ok(Loaded::Fluid(case)) => case.scene,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn a_column_falls_from_its_top_to_the_floor() {
        let found = expected(&scene("Block(low_m: (0, 0), high_m: (1, 2))", "gravity_m_s2: (0, -9.81)"));
        assert!((found.speed - (2.0_f64 * 9.81 * 2.0).sqrt()).abs() < 1e-12);
        assert_eq!((found.length, found.sound_needs), (1.0, found.speed));
    }

    #[test]
    fn a_ball_falls_with_its_top_and_starts_with_its_velocity() {
        let ball = "Ball(centre_m: (2, 1.5), radius_m: 0.5, velocity_m_s: (3, -4))";
        assert_eq!(expected(&scene(ball, "")).speed, 5.0);
        let falling = expected(&scene(ball, "gravity_m_s2: (0, -10)"));
        assert!((falling.speed - 40.0_f64.sqrt()).abs() < 1e-12 && falling.length == 0.5);
    }

    #[test]
    fn a_drop_at_rest_needs_sound_against_its_capillary_waves() {
        let found = expected(&scene("Ball(centre_m: (2, 1.5), radius_m: 0.5)", ""));
        assert_eq!(found.speed, 0.0);
        assert!((found.sound_needs - (0.09_f64 / 500.0).sqrt()).abs() < 1e-15);
    }
}
