//! The settings that are compared, each one change away from the defaults.

use crate::case::scene::{ConductivityMean, KernelShape, Levels, Stepping, Weights};
use crate::model::Model;

/// Uniform spacing is only tried up to this many particles.
const LARGEST_UNIFORM: i64 = 400_000;

/// Name of the setting that changes nothing.
pub(super) const DEFAULT: &str = "default";

/// Name of the setting whose steps are those of the reference: its runs and the reference differ in the spacing alone.
pub(super) const TIGHT: &str = "tight steps";

/// Steps of the reference.
const TIGHT_STEPPING: Stepping = Stepping::SuperSteps { tolerance: Some(0.01), max_stages: 60 };

/// Which levels of spacing a setting has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Boxes {
    /// Those of the ladder, at the same places for all spacings.
    Ladder,
    /// Those that a run of the case would have at the spacing.
    Own,
}

/// A named change of the defaults.
pub(super) struct Setting {
    pub(super) name: String,
    pub(super) boxes: Boxes,
    /// The case with that change, at its own spacing.
    model: Model,
}

impl Setting {
    pub(super) fn new(name: &str, model: Model) -> Self {
        Self { name: name.into(), boxes: Boxes::Ladder, model }
    }

    /// The model with this setting at a spacing; `None` where it would be too large.
    pub(super) fn at(&self, spacing: f64) -> Option<Model> {
        let model = at_spacing(&self.model, spacing);
        let uniform = model.resolution.levels == Levels::Uniform && self.boxes == Boxes::Own;
        let too_large = uniform && model.counts().iter().product::<i64>() > LARGEST_UNIFORM;
        (!too_large).then_some(model)
    }
}

/// The defaults, and with the steps of the reference.
pub(super) fn plain(base: &Model) -> Vec<Setting> {
    let mut tight = base.clone();
    tight.heat.stepping = TIGHT_STEPPING;
    vec![Setting::new(DEFAULT, base.clone()), Setting::new(TIGHT, tight)]
}

/// All settings that go with the physics of the case, the plain ones first.
pub(super) fn all(base: &Model) -> Vec<Setting> {
    let setting = |name: &str, change: fn(&mut Model)| {
        let mut model = base.clone();
        change(&mut model);
        Setting::new(name, model)
    };
    let mut all = plain(base);
    all.extend([
        setting("Euler", |m| m.heat.stepping = Stepping::Euler { factor: 0.9 }),
        setting("tolerance 0.5", |m| m.heat.stepping = tolerance(0.5)),
        setting("tolerance 0.005", |m| m.heat.stepping = tolerance(0.005)),
    ]);
    if base.flow.is_some() {
        // Melt that flows takes one spacing and one kind of weights.
        return all;
    }
    all.extend([
        setting("fitted 0.85", |m| weights(m, Weights::Fitted, KernelShape::WendlandC2, 0.85)),
        setting("fitted 1.0", |m| weights(m, Weights::Fitted, KernelShape::WendlandC2, 1.0)),
        setting("fitted cubic 1.0", |m| weights(m, Weights::Fitted, KernelShape::CubicSpline, 1.0)),
        setting("fitted Gauss 0.8", |m| weights(m, Weights::Fitted, KernelShape::Gaussian, 0.8)),
        setting("normalized 1.0", |m| weights(m, Weights::Normalized, KernelShape::WendlandC2, 1.0)),
        setting("normalized cubic 1.3", |m| weights(m, Weights::Normalized, KernelShape::CubicSpline, 1.3)),
        setting("moving cubic 1.3", |m| weights(m, Weights::Moving, KernelShape::CubicSpline, 1.3)),
        setting("plain cubic 1.3", |m| weights(m, Weights::Plain, KernelShape::CubicSpline, 1.3)),
        setting("harmonic mean", |m| m.heat.conductivity_mean = ConductivityMean::Harmonic),
    ]);
    if base.resolution.levels != Levels::Uniform && base.stress.is_none() {
        let own = |setting: Setting| Setting { boxes: Boxes::Own, ..setting };
        all.push(own(setting("own levels", |_| {})));
        all.push(own(setting("uniform spacing", |m| m.resolution.levels = Levels::Uniform)));
    }
    all
}

fn tolerance(tolerance: f64) -> Stepping {
    Stepping::SuperSteps { tolerance: Some(tolerance), max_stages: 60 }
}

fn weights(model: &mut Model, weights: Weights, kernel: KernelShape, ratio: f64) {
    model.heat.weights = weights;
    model.heat.kernel = kernel;
    model.heat.smoothing_ratio = Some(ratio);
}

/// The same model at another spacing.
pub(super) fn at_spacing(base: &Model, spacing: f64) -> Model {
    let mut changed = base.clone();
    changed.resolution.spacing_m = spacing;
    changed
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::library::cases_folder;
    use crate::case::load;

    fn names(case: &str) -> Vec<String> {
        let case = load(&cases_folder().unwrap().join(case), &[]).unwrap();
        all(&Model::from_case(&case).unwrap()).into_iter().map(|setting| setting.name).collect()
    }

    #[test]
    fn every_setting_has_its_own_name() {
        let mut names = names("spot-aluminium");
        assert_eq!(names[..2], [DEFAULT, TIGHT]);
        let count = names.len();
        names.sort();
        names.dedup();
        assert_eq!(names.len(), count);
    }

    #[test]
    fn melt_that_flows_keeps_its_weights() {
        let names = names("flow-spot-aluminium");
        assert!(names.iter().all(|name| !name.contains("fitted") && !name.contains("levels")), "{names:?}");
        assert!(names.contains(&"Euler".to_string()));
    }
}
