//! The settings that are compared, each one change away from the defaults.

use crate::case::scene::{ConductivityMean, KernelShape, Levels, Resolution, Stepping, Weights};
use crate::model::Model;

/// Spacings over the case's own that are tried; those that divide the part into whole cells are used.
const FACTORS: [f64; 6] = [4.0, 3.0, 2.0, 1.5, 1.25, 1.0];

/// Spacings of neighbouring rungs differ by this factor at least.
const SMALLEST_RATIO: f64 = 1.3;

/// Resolutions on the ladder.
const RUNGS: usize = 3;

/// Uniform spacing is only tried up to this many particles.
const LARGEST_UNIFORM: i64 = 400_000;

/// Beams narrower than this many spacings say nothing about a setting.
const SMALLEST_BEAM: f64 = 2.0;

/// Name of the setting that changes nothing.
pub(super) const DEFAULT: &str = "default";

/// A named change of the defaults.
pub(super) struct Setting {
    pub(super) name: String,
    change: fn(&mut Model),
}

impl Setting {
    /// The model with this setting at a spacing; `None` where it would be too large.
    pub(super) fn apply(&self, base: &Model, spacing: f64) -> Option<Model> {
        let mut model = at_spacing(base, spacing);
        (self.change)(&mut model);
        let uniform = model.resolution.levels == Levels::Uniform;
        let too_large = uniform && model.counts().iter().product::<i64>() > LARGEST_UNIFORM;
        (!too_large).then_some(model)
    }
}

/// All settings, the defaults first.
pub(super) fn all() -> Vec<Setting> {
    let setting = |name: &str, change: fn(&mut Model)| Setting { name: name.into(), change };
    vec![
        setting(DEFAULT, |_| {}),
        setting("fitted 0.85", |m| weights(m, Weights::Fitted, KernelShape::WendlandC2, 0.85)),
        setting("fitted 1.0", |m| weights(m, Weights::Fitted, KernelShape::WendlandC2, 1.0)),
        setting("fitted cubic 1.0", |m| weights(m, Weights::Fitted, KernelShape::CubicSpline, 1.0)),
        setting("fitted Gauss 0.8", |m| weights(m, Weights::Fitted, KernelShape::Gaussian, 0.8)),
        setting("normalized 1.0", |m| weights(m, Weights::Normalized, KernelShape::WendlandC2, 1.0)),
        setting("normalized cubic 1.3", |m| weights(m, Weights::Normalized, KernelShape::CubicSpline, 1.3)),
        setting("moving cubic 1.3", |m| weights(m, Weights::Moving, KernelShape::CubicSpline, 1.3)),
        setting("plain cubic 1.3", |m| weights(m, Weights::Plain, KernelShape::CubicSpline, 1.3)),
        setting("harmonic mean", |m| m.heat.conductivity_mean = ConductivityMean::Harmonic),
        setting("uniform spacing", |m| m.resolution.levels = Levels::Uniform),
        setting("Euler", |m| m.heat.stepping = Stepping::Euler { factor: 0.9 }),
        setting("tolerance 0.5", |m| {
            m.heat.stepping = Stepping::SuperSteps { tolerance: Some(0.5), max_stages: 60 }
        }),
        setting("tolerance 0.005", |m| {
            m.heat.stepping = Stepping::SuperSteps { tolerance: Some(0.005), max_stages: 60 }
        }),
    ]
}

fn weights(model: &mut Model, weights: Weights, kernel: KernelShape, ratio: f64) {
    model.heat.weights = weights;
    model.heat.kernel = kernel;
    model.heat.smoothing_ratio = Some(ratio);
}

/// The spacings of the ladder, coarse to fine: the case's own and coarser ones that divide its part.
pub(super) fn spacings(model: &Model) -> Vec<f64> {
    let beam = model.laser.as_ref().map_or(f64::INFINITY, |laser| laser.beam().radius_m());
    let usable = |factor: &&f64| {
        let spacing = *factor * model.spacing();
        let whole = |size: f64| {
            ((size / spacing).round() * spacing / size - 1.0).abs() < 1e-9 && size > 2.0 * spacing
        };
        model.size.iter().all(|&size| whole(size)) && beam >= SMALLEST_BEAM * spacing
    };
    // From fine to coarse, each rung a good deal coarser than the last.
    let mut rungs: Vec<f64> = Vec::new();
    for factor in FACTORS.iter().rev().filter(usable) {
        if rungs.last().is_none_or(|last| *factor >= SMALLEST_RATIO * last) {
            rungs.push(*factor);
        }
    }
    rungs.truncate(RUNGS);
    rungs.iter().rev().map(|factor| factor * model.spacing()).collect()
}

/// The same case at half of its spacing with tighter steps.
pub(super) fn reference(model: &Model) -> Model {
    let mut fine = at_spacing(model, 0.5 * model.spacing());
    fine.heat.stepping = Stepping::SuperSteps { tolerance: Some(0.01), max_stages: 60 };
    fine
}

fn at_spacing(model: &Model, spacing: f64) -> Model {
    let mut changed = model.clone();
    changed.resolution = Resolution { spacing_m: spacing, ..model.resolution };
    changed
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::library::cases_folder;
    use crate::case::load;

    #[test]
    fn the_spot_has_a_ladder_of_three_and_every_setting_has_its_own_name() {
        let case = load(&cases_folder().unwrap().join("spot-aluminium"), &[]).unwrap();
        let model = Model::from_case(&case).unwrap();
        let spacings = spacings(&model);
        assert_eq!(spacings.len(), RUNGS, "{spacings:?}");
        assert!(spacings.windows(2).all(|w| w[0] > w[1]) && spacings[2] == model.spacing());
        let mut names: Vec<_> = all().into_iter().map(|setting| setting.name).collect();
        let count = names.len();
        names.dedup();
        assert_eq!(names.len(), count);
    }
}
