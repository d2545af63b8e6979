//! Where to be fine: a coarse run of the scene itself finds out how large the pool gets.

use super::Simulation;
use crate::build::{CellBox, LevelPlan, fine_box_around, largest_melt_radius, lit_box, margin};
use crate::case::scene::{Face, Levels, Resolution, Stepping};
use crate::model::{Model, ModelError};

/// Beam radii (1/e) to a spacing of the pilot.
const PILOT_BEAM_RADII: f64 = 2.2;

/// A pilot runs until this share of the time at which the laser goes off.
const PILOT_TIME: f64 = 1.03;

/// Tolerance of the pilot's steps.
const PILOT_TOLERANCE: f64 = 0.2;

/// A pilot is worth its cost only if it is this many times coarser than the run.
const SMALLEST_COARSENING: i64 = 2;

/// The levels of spacing of a scene.
///
/// `grown` \[m\] is added to the fine box on all sides when an earlier one turned out too small.
///
/// # Errors
/// [`ModelError`] when the pilot cannot be built.
pub fn level_plan(model: &Model, grown: f64) -> Result<LevelPlan<3>, ModelError> {
    level_plan_on(model, model, grown)
}

/// The levels of `model`, in whole cells of `lattice`: the same part at another spacing.
///
/// # Errors
/// Those of [`level_plan`].
pub fn level_plan_on(lattice: &Model, model: &Model, grown: f64) -> Result<LevelPlan<3>, ModelError> {
    let counts = lattice.counts();
    match model.resolution.levels {
        Levels::Uniform => Ok(LevelPlan::uniform(counts)),
        Levels::FineBox { low_m, high_m } => {
            Ok(LevelPlan::around(counts, explicit_box(lattice, low_m, high_m)))
        }
        // A stressed body takes one spacing.
        Levels::Auto if model.laser.is_none() || model.stress.is_some() => Ok(LevelPlan::uniform(counts)),
        Levels::Auto => {
            let fine = fine_box_around(lattice, pool_bounds(model)?, margin(model) + grown);
            Ok(LevelPlan::around(counts, fine))
        }
    }
}

/// The box that the pool and the lit path cover over the whole run \[m\].
fn pool_bounds(model: &Model) -> Result<[[f64; 3]; 2], ModelError> {
    let lit = lit_box(model);
    let Some(pilot) = pilot_model(model) else {
        return Ok(widened(lit, largest_melt_radius(model)));
    };
    // An upper bound needs no margin, least of all for an estimate.
    let fine = fine_box_around(&pilot, lit_box(&pilot), largest_melt_radius(&pilot));
    let plan = LevelPlan::around(pilot.counts(), fine);
    // A pilot that cannot be built or fails says nothing; the upper bound is right without it.
    let mut simulation = match Simulation::with_plan(pilot, &plan) {
        Ok(simulation) => simulation,
        Err(_) => return Ok(widened(lit, largest_melt_radius(model))),
    };
    if simulation.run_quietly().is_err() {
        return Ok(widened(lit, largest_melt_radius(model)));
    }
    let pool = simulation.records().solidus.bounds;
    let half = 0.5 * simulation.model().spacing();
    Ok(match pool {
        None => lit,
        Some([low, high]) => [
            std::array::from_fn(|axis| lit[0][axis].min(low[axis] - half)),
            std::array::from_fn(|axis| lit[1][axis].max(high[axis] + half)),
        ],
    })
}

fn widened([low, high]: [[f64; 3]; 2], by: f64) -> [[f64; 3]; 2] {
    [low.map(|x| x - by), high.map(|x| x + by)]
}

/// Conduction alone over the whole run, at the coarsest spacing that still shows the pool: what an estimate is made with.
pub(crate) fn coarse_conduction(model: &Model) -> Model {
    let coarse = pilot_model(model).map(|pilot| Model { end: model.end, ..pilot });
    Model { flow: None, stress: None, ..coarse.unwrap_or_else(|| model.clone()) }
}

/// The same scene with a coarser spacing, on a part cut down to whole coarse cells; `None` where that is no gain.
fn pilot_model(model: &Model) -> Option<Model> {
    let radius = model.laser.as_ref()?.beam().radius_m();
    let thinnest = model.counts().into_iter().min()?;
    let factor = (radius / PILOT_BEAM_RADII / model.spacing()).round() as i64;
    let factor = factor.min(thinnest / 2);
    if factor < SMALLEST_COARSENING {
        return None;
    }
    let mut pilot = model.clone();
    // What flow adds to the pool, the margin holds; where it does not, the run starts anew with a larger box.
    pilot.flow = None;
    // Sizes are largest when the light goes out, or very soon after; loose steps find them well enough.
    let lit = model.laser.as_ref()?.track().end_time();
    pilot.end = model.end.min(PILOT_TIME * lit);
    if let Stepping::SuperSteps { max_stages, .. } = model.heat.stepping {
        pilot.heat.stepping = Stepping::SuperSteps { tolerance: Some(PILOT_TOLERANCE), max_stages };
    }
    let spacing = model.spacing() * factor as f64;
    pilot.resolution =
        Resolution { spacing_m: spacing, disorder: 0.0, levels: Levels::Auto, ..model.resolution };
    pilot.size = model.counts().map(|count| (count / factor) as f64 * spacing);
    // What is cut off is cut off opposite to a symmetry plane.
    let faces = [[model.faces.x_min, model.faces.x_max], [model.faces.y_min, model.faces.y_max]];
    for (axis, [low, high]) in faces.into_iter().enumerate() {
        let cut = model.size[axis] - pilot.size[axis];
        match (low == Face::Symmetry, high == Face::Symmetry) {
            (true, true) if cut > 0.5 * model.spacing() => return None,
            (false, true) => pilot.low_corner[axis] += cut,
            _ => {}
        }
    }
    Some(pilot)
}

/// A box of the scene in cells; the third axis counts down from the top face.
fn explicit_box(model: &Model, low: [f64; 3], high: [f64; 3]) -> CellBox<3> {
    let (part, counts) = (model.bounds().0, model.counts());
    let cell =
        |x: f64, axis: usize| (((x - part[axis]) / model.spacing()).round() as i64).clamp(0, counts[axis]);
    let down = |z: f64| ((-z / model.spacing()).round() as i64).clamp(0, counts[2]);
    CellBox {
        low: [cell(low[0], 0), cell(low[1], 1), down(high[2])],
        high: [cell(high[0], 0), cell(high[1], 1), down(low[2])],
    }
}
