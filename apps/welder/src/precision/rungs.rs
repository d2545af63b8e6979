//! The spacings of a ladder, and its levels of spacing: the same boxes at all of them, so that one run is another with every
//! cell cut finer, and what changes from one to the next is the spacing alone.

use super::settings::at_spacing;
use crate::build::LevelPlan;
use crate::model::{Model, ModelError};
use crate::run::level_plan_on;

/// The coarsest spacing over the case's own. The case's own is the next rung, the reference has half of that.
const COARSEST: i64 = 2;

/// Beams narrower than this many spacings say nothing.
const SMALLEST_BEAM: f64 = 2.0;

/// A ladder of spacings over the case's own.
pub(super) struct Rungs {
    own_spacing: f64,
    coarsest: LevelPlan<3>,
}

impl Rungs {
    /// How often the coarsest spacing is cut on each rung, coarse to fine.
    pub(super) const CUTS: [i64; 2] = [1, COARSEST];

    /// How often it is cut for the reference.
    pub(super) const REFERENCE: i64 = 2 * COARSEST;

    /// The ladder of a model; `None` where the coarsest spacing does not divide the part or resolve the beam.
    ///
    /// # Errors
    /// What the pilot run refuses.
    pub(super) fn new(model: &Model) -> Result<Option<Self>, ModelError> {
        let spacing = COARSEST as f64 * model.spacing();
        let beam = model.laser.as_ref().map_or(f64::INFINITY, |laser| laser.beam().radius_m());
        let whole = model.counts().iter().all(|count| count % COARSEST == 0 && count / COARSEST > 2);
        if !whole || beam < SMALLEST_BEAM * spacing {
            return Ok(None);
        }
        let coarsest = level_plan_on(&at_spacing(model, spacing), model, 0.0)?;
        Ok(Some(Self { own_spacing: model.spacing(), coarsest }))
    }

    /// The spacing of a rung \[m\].
    pub(super) fn spacing(&self, cut: i64) -> f64 {
        self.own_spacing * COARSEST as f64 / cut as f64
    }

    /// Its levels.
    pub(super) fn plan(&self, cut: i64) -> LevelPlan<3> {
        self.coarsest.refined(cut)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::{library::cases_folder, load};

    fn rungs(overrides: &[&str]) -> Option<Rungs> {
        let overrides: Vec<_> = overrides.iter().map(|text| text.to_string()).collect();
        let case = load(&cases_folder().unwrap().join("spot-aluminium"), &overrides).unwrap();
        Rungs::new(&Model::from_case(&case).unwrap()).unwrap()
    }

    #[test]
    fn each_rung_halves_the_spacing_in_the_same_boxes() {
        let ladder = rungs(&[]).unwrap();
        let all = [Rungs::CUTS[0], Rungs::CUTS[1], Rungs::REFERENCE];
        assert_eq!(all.map(|cut| (1e6 * ladder.spacing(cut)).round()), [100.0, 50.0, 25.0]);
        let counts = all.map(|cut| ladder.plan(cut).count());
        assert!(counts.windows(2).all(|pair| pair[1] == 8 * pair[0]), "{counts:?}");
        assert!(ladder.plan(1).levels() > 1);
    }

    #[test]
    fn beam_and_part_set_the_coarsest() {
        assert!(rungs(&["resolution.spacing_m=100e-6"]).is_some());
        assert!(rungs(&["part.size_m=(3.05e-3,3.05e-3,3.05e-3)"]).is_none(), "61 spacings");
        assert!(rungs(&["resolution.spacing_m=200e-6"]).is_none(), "the beam");
    }
}
