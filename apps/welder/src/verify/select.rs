//! Which benchmarks names and beginnings of names stand for.

use super::{Benchmark, benchmarks};
use crate::case::suggestion;

/// A name that no benchmark has.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("no benchmark `{name}`: {suggestion}")]
pub struct UnknownName {
    /// The name.
    pub name: String,
    /// The nearest one, and all there are.
    pub suggestion: String,
}

/// The benchmarks whose name, or the name of one of whose entries, begins with one of `names`; all without names.
///
/// # Errors
/// [`UnknownName`] for the first name that stands for none.
pub fn select(names: &[String]) -> Result<Vec<&'static Benchmark>, UnknownName> {
    let meant = |benchmark: &Benchmark, name: &str| {
        benchmark.name.starts_with(name) || benchmark.entry_names().any(|entry| entry.starts_with(name))
    };
    if let Some(stranger) = names.iter().find(|name| !benchmarks().iter().any(|one| meant(one, name))) {
        let known: Vec<&str> = benchmarks().iter().map(|benchmark| benchmark.name).collect();
        return Err(UnknownName { name: stranger.clone(), suggestion: suggestion(stranger, &known) });
    }
    let chosen = |benchmark: &&Benchmark| names.is_empty() || names.iter().any(|name| meant(benchmark, name));
    Ok(benchmarks().iter().filter(chosen).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(wanted: &[&str]) -> Result<Vec<&'static str>, UnknownName> {
        let wanted: Vec<String> = wanted.iter().map(ToString::to_string).collect();
        select(&wanted).map(|found| found.into_iter().map(|benchmark| benchmark.name).collect())
    }

    #[test]
    fn names_and_beginnings_select() {
        assert_eq!(names(&[]).unwrap().len(), benchmarks().len());
        assert_eq!(names(&["heat/stefan"]).unwrap(), ["heat/stefan"]);
        assert_eq!(names(&["heat/gaussian"]).unwrap(), ["heat/gaussian-spot", "heat/gaussian-field"]);
        assert_eq!(names(&["weld/spot-aluminium/width"]).unwrap(), ["weld/spot-aluminium"]);
        assert!(names(&["round-off"]).unwrap().len() >= 2);
    }

    #[test]
    fn strangers_are_refused_with_the_nearest_name() {
        let refused = names(&["heat/stefan", "heat/gausian-spot"]).unwrap_err();
        assert_eq!(refused.name, "heat/gausian-spot");
        assert!(refused.to_string().contains("did you mean `heat/gaussian-spot`?"), "{refused}");
    }
}
