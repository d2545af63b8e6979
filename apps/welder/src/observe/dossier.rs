//! What a run that went wrong leaves behind: `dossier.json`, and the particles around the place as `dossier.vtu`.

use super::vtu::{self, Precision};
use super::{Field, ObserveError, Values, View, summary, whole_file};
use nalgebra::SVector;
use serde::Serialize;
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The neighbourhood reaches this many spacings of the particle that failed.
const REACH_SPACINGS: f64 = 6.0;

/// What went wrong, as the run loop or a physics tells it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Failure {
    /// What was found, such as "the temperature is not a number".
    pub what: String,
    /// The particle it was found at, if it was at one.
    pub particle: Option<usize>,
    /// What the user can try, most promising first.
    pub try_next: Vec<String>,
}

#[derive(Serialize)]
struct Dossier<'a> {
    what: &'a str,
    time_s: f64,
    step: u64,
    dt_s: f64,
    dt_limit: &'a str,
    particle: Option<usize>,
    position_m: Option<Vec<Value>>,
    values: BTreeMap<&'static str, Value>,
    neighbourhood: Option<&'static str>,
    particles_in_neighbourhood: usize,
    try_next: &'a [String],
}

/// Writes the dossier of a failure into `run_folder`; gives back the path of its JSON file.
pub fn write_dossier<const D: usize>(
    run_folder: &Path,
    failure: &Failure,
    view: &View<D>,
) -> Result<PathBuf, ObserveError> {
    let particle = failure.particle.filter(|&particle| particle < view.positions_m.len());
    let near = particle.map_or_else(Vec::new, |particle| neighbourhood(particle, view));
    if !near.is_empty() {
        write_neighbourhood(&run_folder.join("dossier.vtu"), &near, view)?;
    }
    let dossier = Dossier {
        what: &failure.what,
        time_s: view.time_s,
        step: view.step,
        dt_s: view.dt_s,
        dt_limit: view.dt_limit,
        particle,
        position_m: particle.map(|particle| numbers(&view.positions_m[particle])),
        values: particle.map_or_else(BTreeMap::new, |particle| values_at(particle, &view.fields)),
        neighbourhood: (!near.is_empty()).then_some("dossier.vtu"),
        particles_in_neighbourhood: near.len(),
        try_next: &failure.try_next,
    };
    let path = run_folder.join("dossier.json");
    summary::write_json(&path, &dossier)?;
    Ok(path)
}

/// The particles around one, itself among them even if its position is not a number.
fn neighbourhood<const D: usize>(particle: usize, view: &View<D>) -> Vec<usize> {
    let reach_m = REACH_SPACINGS * view.spacing_m[particle];
    let centre_m = view.positions_m[particle];
    let is_near =
        |&other: &usize| other == particle || (view.positions_m[other] - centre_m).norm() <= reach_m;
    (0..view.positions_m.len()).filter(is_near).collect()
}

fn write_neighbourhood<const D: usize>(
    path: &Path,
    near: &[usize],
    view: &View<D>,
) -> Result<(), ObserveError> {
    let positions_m: Vec<_> = near.iter().map(|&particle| view.positions_m[particle]).collect();
    let columns: Vec<(&'static str, Column<D>)> =
        view.fields.iter().map(|field| (field.name, Column::of(near, &field.values))).collect();
    let numbers: Vec<f64> = near.iter().map(|&particle| particle as f64).collect();
    let mut fields = vec![Field { name: "particle", values: Values::Scalar(&numbers) }];
    fields.extend(columns.iter().map(|(name, column)| Field { name, values: column.values() }));
    vtu::encode_points(&positions_m, &fields, Precision::Float64)
        .and_then(|bytes| whole_file::replace(path, &bytes))
        .map_err(ObserveError::file("write", path))
}

/// The values of some of the particles.
enum Column<const D: usize> {
    Scalar(Vec<f64>),
    Vector(Vec<SVector<f64, D>>),
    Triple(Vec<[f64; 3]>),
    Byte(Vec<u8>),
}

impl<const D: usize> Column<D> {
    fn of(particles: &[usize], values: &Values<D>) -> Self {
        match values {
            Values::Scalar(all) => Column::Scalar(particles.iter().map(|&particle| all[particle]).collect()),
            Values::Vector(all) => Column::Vector(particles.iter().map(|&particle| all[particle]).collect()),
            Values::Triple(all) => Column::Triple(particles.iter().map(|&particle| all[particle]).collect()),
            Values::Byte(all) => Column::Byte(particles.iter().map(|&particle| all[particle]).collect()),
        }
    }

    fn values(&self) -> Values<'_, D> {
        match self {
            Column::Scalar(values) => Values::Scalar(values),
            Column::Vector(values) => Values::Vector(values),
            Column::Triple(values) => Values::Triple(values),
            Column::Byte(values) => Values::Byte(values),
        }
    }
}

fn values_at<const D: usize>(particle: usize, fields: &[Field<D>]) -> BTreeMap<&'static str, Value> {
    let value = |values: &Values<D>| match values {
        Values::Scalar(values) => number(values[particle]),
        Values::Vector(values) => Value::from(numbers(&values[particle])),
        Values::Triple(values) => Value::from(numbers(&values[particle])),
        Values::Byte(values) => Value::from(values[particle]),
    };
    fields.iter().map(|field| (field.name, value(&field.values))).collect()
}

fn numbers<'a>(components: impl IntoIterator<Item = &'a f64>) -> Vec<Value> {
    components.into_iter().map(|&component| number(component)).collect()
}

/// A number for JSON; one that is not finite, the very thing to look for here, as text.
fn number(value: f64) -> Value {
    if value.is_finite() { Value::from(value) } else { Value::from(value.to_string()) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector2;

    fn written(failure: &Failure, hurt: usize) -> (Value, Option<String>) {
        let folder = tempfile::tempdir().unwrap();
        let positions_m: Vec<_> = (0..100).map(|index| Vector2::new(index as f64, 0.0)).collect();
        let temperatures_k: Vec<f64> =
            (0..100).map(|index| if index == hurt { f64::NAN } else { 300.0 }).collect();
        let view = View {
            dt_limit: "sound",
            positions_m: &positions_m,
            spacing_m: &[1.0; 100],
            fields: vec![
                Field { name: "temperature_k", values: Values::Scalar(&temperatures_k) },
                Field { name: "velocity_m_s", values: Values::Vector(&positions_m) },
                Field { name: "phase", values: Values::Byte(&[2; 100]) },
            ],
            ..View::bare(1.5e-3, 77)
        };
        let path = write_dossier(folder.path(), failure, &view).unwrap();
        let neighbourhood = std::fs::read_to_string(folder.path().join("dossier.vtu")).ok();
        (serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap(), neighbourhood)
    }

    #[test]
    fn it_says_what_where_when_which_limit_and_what_to_try() {
        let failure = Failure {
            what: "the temperature is not a number".into(),
            particle: Some(50),
            try_next: vec!["a smaller spacing_m".into()],
        };
        let (dossier, neighbourhood) = written(&failure, 50);
        assert_eq!(dossier["what"], "the temperature is not a number");
        assert_eq!(dossier["position_m"], serde_json::json!([50.0, 0.0]));
        assert_eq!(dossier["values"]["temperature_k"], "NaN");
        assert_eq!(dossier["values"]["velocity_m_s"], serde_json::json!([50.0, 0.0]));
        assert_eq!(dossier["values"]["phase"], 2);
        assert_eq!((&dossier["time_s"], &dossier["step"]), (&Value::from(1.5e-3), &Value::from(77)));
        assert_eq!(dossier["dt_limit"], "sound");
        assert_eq!(dossier["try_next"][0], "a smaller spacing_m");
        assert_eq!(dossier["particles_in_neighbourhood"], 13);
        let neighbourhood = neighbourhood.unwrap();
        assert!(neighbourhood.contains("NumberOfPoints=\"13\""));
        for name in ["particle", "temperature_k", "velocity_m_s", "phase"] {
            assert!(neighbourhood.contains(&format!("Name=\"{name}\"")), "{name}");
        }
    }

    #[test]
    fn a_failure_at_no_particle_has_no_neighbourhood() {
        for particle in [None, Some(1000)] {
            let failure = Failure { what: "too many steps".into(), particle, ..Failure::default() };
            let (dossier, neighbourhood) = written(&failure, 0);
            assert!(dossier["position_m"].is_null() && dossier["neighbourhood"].is_null());
            assert!(neighbourhood.is_none());
        }
    }

    #[test]
    fn a_particle_that_is_nowhere_still_has_its_dossier() {
        let positions_m = [Vector2::new(f64::NAN, 0.0), Vector2::new(0.0, 0.0)];
        assert_eq!(numbers(&positions_m[0])[0], "NaN");
        let view = View { positions_m: &positions_m, spacing_m: &[1.0, 1.0], ..View::bare(0.0, 1) };
        assert_eq!(neighbourhood(0, &view), [0]);
        assert_eq!(neighbourhood(1, &view), [1]);
    }
}
