//! Collects what is wrong in one file.

use super::super::problem::Problem;
use super::super::source::Source;
use super::plausible::Range;

/// The findings in one file, in the order in which they were made.
pub struct Findings<'a> {
    /// The file.
    pub source: &'a Source,
    prefix: &'a str,
    problems: Vec<Problem>,
}

impl<'a> Findings<'a> {
    /// No findings yet; `prefix` stands before the path of every field.
    pub fn new(source: &'a Source, prefix: &'a str) -> Self {
        Findings { source, prefix, problems: Vec::new() }
    }

    /// Notes that a field is wrong.
    pub fn refuse(&mut self, field: &str, reason: &str, remedy: impl Into<String>) {
        self.problems.push(self.source.problem(&format!("{}{field}", self.prefix), reason, remedy));
    }

    /// Notes that a field is wrong unless `holds`; says whether it holds.
    pub fn require(&mut self, holds: bool, field: &str, reason: &str, remedy: impl Into<String>) -> bool {
        if !holds {
            self.refuse(field, reason, remedy);
        }
        holds
    }

    /// Notes that a value lies outside its range; says whether it lies inside.
    pub fn within(&mut self, field: &str, value: f64, range: &Range) -> bool {
        let refusal = range.refuse(value);
        if let Some((reason, remedy)) = &refusal {
            self.refuse(field, reason, remedy.as_str());
        }
        refusal.is_none()
    }

    /// [`Findings::within`] for the entries of a tuple or list.
    pub fn all_within(&mut self, field: &str, values: &[f64], range: &Range) -> bool {
        let entries = values.iter().enumerate();
        entries.fold(true, |fine, (index, &value)| {
            self.within(&format!("{field}.{index}"), value, range) && fine
        })
    }

    /// Whether nothing is wrong so far.
    pub fn is_empty(&self) -> bool {
        self.problems.is_empty()
    }

    /// What was found.
    pub fn into_problems(self) -> Vec<Problem> {
        self.problems
    }
}
