//! The pairs of runs that the advice is held against: each with an effect and without it.

use super::super::advice::{Effect, ROOM_K, lit};
use crate::case::Case;
use crate::case::scene::{Face, Levels, Physics};
use crate::model::Model;
use crate::run::solid_scales;
use laser_source::{Path, PowerPoint, Pulse};

/// Uniform spacing is only tried up to this many particles.
const LARGEST_UNIFORM: f64 = 400_000.0;

/// Diffusion lengths sqrt(a t) after which a face is too far to be felt.
const OUT_OF_REACH: f64 = 4.0;

/// Two cases that differ in one effect.
pub(super) struct Twins {
    /// Its name, that of the advice where there is one.
    pub(super) effect: &'static str,
    /// What the two differ in.
    pub(super) change: String,
    /// The two, or why they cannot be.
    pub(super) pair: Result<Pair, String>,
}

/// The case with the effect and that without it; `None` is the base.
pub(super) struct Pair {
    pub(super) with: Option<Case>,
    pub(super) without: Option<Case>,
}

/// What all but stress are compared on: stress follows the temperatures, and its own pair shows that it leaves them alone.
pub(super) fn base(case: &Case) -> Case {
    let mut base = case.clone();
    base.scene.physics.retain(|physics| !matches!(physics, Physics::Stress(_)));
    base
}

/// All pairs of a case and its model.
pub(super) fn all(case: &Case, model: &Model) -> Vec<Twins> {
    let base = base(case);
    let mut twins = vec![latent_heat(&base), bottom(&base, model), losses(&base)];
    twins.extend(evaporation(&base, model));
    twins.extend(movement(&base, model));
    twins.push(stress(case));
    twins.push(flow(&base));
    twins.push(levels(&base));
    twins
}

fn one_less(base: &Case, effect: Effect, change: &str, edit: impl FnOnce(&mut Case)) -> Twins {
    let mut changed = base.clone();
    edit(&mut changed);
    let pair = Ok(Pair { with: None, without: Some(changed) });
    Twins { effect: effect.name(), change: change.into(), pair }
}

fn not_run(effect: &'static str, reason: &str) -> Twins {
    Twins { effect, change: String::new(), pair: Err(reason.into()) }
}

fn latent_heat(base: &Case) -> Twins {
    one_less(base, Effect::LatentHeat, "without: latent_heat_j_kg 0", |case| {
        case.materials.iter_mut().for_each(|material| material.card.latent_heat_j_kg.value = 0.0);
    })
}

/// Without a bottom the part goes on until heat does not reach its end.
fn bottom(base: &Case, model: &Model) -> Twins {
    let (_, _, diffusivity) = solid_scales(model);
    let reach = OUT_OF_REACH * (diffusivity * lit(model)).sqrt();
    let thickness = base.scene.part.size_m[2];
    let times = (reach / thickness).ceil().max(2.0);
    if times * uniform_particles(base) > LARGEST_UNIFORM && is_uniform(base) {
        return not_run(
            Effect::BottomFace.name(),
            "a part of one spacing that is thick enough has too many particles",
        );
    }
    let change = format!("without: part.size_m.2 {:.3e}", times * thickness);
    one_less(base, Effect::BottomFace, &change, |case| case.scene.part.size_m[2] = times * thickness)
}

/// A top face without losses is compared with a black one, as the advice does.
fn losses(base: &Case) -> Twins {
    let effect = Effect::Losses;
    match base.scene.part.faces.top {
        Face::Losses { ambient_k, evaporation, .. } => {
            let change = "without: top convection_w_m2_k 0, emissivity 0";
            one_less(base, effect, change, |case| {
                let (convection_w_m2_k, emissivity) = (0.0, 0.0);
                case.scene.part.faces.top =
                    Face::Losses { convection_w_m2_k, emissivity, ambient_k, evaporation };
            })
        }
        Face::Adiabatic => {
            let mut black = base.clone();
            let face = Face::Losses {
                convection_w_m2_k: 0.0,
                emissivity: 1.0,
                ambient_k: ROOM_K,
                evaporation: false,
            };
            black.scene.part.faces.top = face;
            let pair = Ok(Pair { with: Some(black), without: None });
            Twins { effect: effect.name(), change: "with: top Losses(emissivity: 1)".into(), pair }
        }
        _ => not_run(effect.name(), "the top face takes up a flux"),
    }
}

/// With and without evaporation of the top face, where the card tells how the melt evaporates.
fn evaporation(base: &Case, model: &Model) -> Option<Twins> {
    model.evaporation[0]?;
    let effect = Effect::Evaporation;
    let mut changed = base.clone();
    let top = &mut changed.scene.part.faces.top;
    let was = match top {
        Face::Losses { evaporation, .. } => std::mem::replace(evaporation, !*evaporation),
        Face::Adiabatic => {
            let dry = Face::Losses {
                convection_w_m2_k: 0.0,
                emissivity: 0.0,
                ambient_k: ROOM_K,
                evaporation: true,
            };
            *top = dry;
            false
        }
        _ => return Some(not_run(effect.name(), "the top face takes up a flux")),
    };
    let (change, pair) = if was {
        ("without: top evaporation: false", Pair { with: None, without: Some(changed) })
    } else {
        ("with: top evaporation: true", Pair { with: Some(changed), without: None })
    };
    Some(Twins { effect: effect.name(), change: change.into(), pair: Ok(pair) })
}

/// The same power over time, at the place where the beam is at half of its time.
fn movement(base: &Case, model: &Model) -> Option<Twins> {
    let track = model.laser.as_ref()?.track();
    if track.max_speed() == 0.0 {
        return None;
    }
    let points = track.points();
    let middle = 0.5 * (points[0].time_s + track.end_time());
    let powers = points.iter().map(|point| PowerPoint { time_s: point.time_s, power_w: point.power_w });
    let pulse = Pulse::Table { start_s: 0.0, points: powers.collect() };
    let spot = Path::Spot { position_m: track.position(middle), pulse };
    Some(one_less(base, Effect::Movement, "without: a beam that rests half-way", |case| {
        case.scene.laser.iter_mut().for_each(|laser| laser.path = spot.clone());
    }))
}

/// Stress takes one spacing, and so does what it is compared with.
fn stress(case: &Case) -> Twins {
    let effect = Effect::Stress.name();
    if case.scene.stress().is_none() {
        return not_run(effect, "the case does not list Stress()");
    }
    let mut heat = base(case);
    heat.scene.resolution.levels = Levels::Uniform;
    let pair = Ok(Pair { with: Some(case.clone()), without: Some(heat) });
    Twins { effect, change: "without: Stress not listed".into(), pair }
}

fn flow(base: &Case) -> Twins {
    if base.scene.flow().is_none() {
        return not_run(Effect::Flow.name(), "the case does not list Flow()");
    }
    one_less(base, Effect::Flow, "without: Flow not listed", |case| {
        case.scene.physics.retain(|physics| !matches!(physics, Physics::Flow(_)));
    })
}

fn levels(base: &Case) -> Twins {
    let effect = "levels";
    if is_uniform(base) {
        return not_run(effect, "the case has one spacing");
    }
    if uniform_particles(base) > LARGEST_UNIFORM {
        return not_run(effect, "one spacing would take too many particles");
    }
    let mut uniform = base.clone();
    uniform.scene.resolution.levels = Levels::Uniform;
    let pair = Ok(Pair { with: None, without: Some(uniform) });
    Twins { effect, change: "without: levels Uniform".into(), pair }
}

fn is_uniform(case: &Case) -> bool {
    let levels = case.scene.resolution.levels;
    levels == Levels::Uniform || (levels == Levels::Auto && case.scene.flow().is_some())
}

fn uniform_particles(case: &Case) -> f64 {
    case.scene.part.size_m.iter().product::<f64>() / case.scene.resolution.spacing_m.powi(3)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::{library::cases_folder, load};

    fn twins(name: &str, overrides: &[&str]) -> Vec<Twins> {
        let overrides: Vec<_> = overrides.iter().map(|text| text.to_string()).collect();
        let case = load(&cases_folder().unwrap().join(name), &overrides).unwrap();
        all(&case, &Model::from_case(&case).unwrap())
    }

    fn find<'a>(twins: &'a [Twins], effect: &str) -> &'a Pair {
        twins.iter().find(|twins| twins.effect == effect).unwrap().pair.as_ref().unwrap()
    }

    #[test]
    fn each_pair_differs_in_its_effect_alone() {
        let losses = "part.faces.top=Losses(convection_w_m2_k: 20.0)";
        let spot = twins("spot-aluminium", &[losses, "resolution.spacing_m=100e-6"]);
        let changed = |effect| find(&spot, effect).without.clone().unwrap();
        assert_eq!(changed("latent heat").materials[0].card.latent_heat_j_kg.value, 0.0);
        assert!(matches!(
            changed("losses").scene.part.faces.top,
            Face::Losses { convection_w_m2_k: 0.0, emissivity: 0.0, evaporation: false, .. }
        ));
        assert_eq!(changed("levels").scene.resolution.levels, Levels::Uniform);
        // sqrt(a t) is 1.1 mm: twice the 3 mm is out of reach.
        assert!((changed("bottom face").scene.part.size_m[2] - 6e-3).abs() < 1e-12);
        assert!(spot.iter().all(|twins| twins.effect != "movement"));
        for effect in ["stress", "flow"] {
            assert!(spot.iter().find(|twins| twins.effect == effect).unwrap().pair.is_err(), "{effect}");
        }
        let black = find(&twins("spot-aluminium", &[]), "losses").with.clone().unwrap();
        assert!(matches!(black.scene.part.faces.top, Face::Losses { emissivity: 1.0, .. }));
    }

    #[test]
    fn a_seam_rests_half_way_with_all_its_energy() {
        let seam = twins("seam-aluminium", &[]);
        let still = find(&seam, "movement").without.clone().unwrap();
        let laser = still.scene.laser.unwrap();
        assert!(matches!(laser.path, Path::Spot { position_m: [x, 0.0], .. } if (x - 6e-3).abs() < 1e-12));
        assert!((laser.path.track().unwrap().energy(0.0, 1.0) / (1250.0 * 0.24) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn stress_is_compared_on_its_own_spacing() {
        let twins = twins("stress-spot-aluminium", &[]);
        let pair = find(&twins, "stress");
        let (with, without) = (pair.with.as_ref().unwrap(), pair.without.as_ref().unwrap());
        assert!(with.scene.stress().is_some() && without.scene.stress().is_none());
        assert_eq!(without.scene.resolution.levels, Levels::Uniform);
        assert!(find(&twins, "latent heat").without.as_ref().unwrap().scene.stress().is_none());
    }
}
