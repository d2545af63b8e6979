//! What is wrong with a case, where, and what would be right.

use std::fmt;
use std::sync::Arc;

use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme, NamedSource, SourceSpan};
use thiserror::Error;

/// One thing that is wrong, with its place in a file.
#[derive(Debug, Clone, Error, Diagnostic)]
#[error("{place}: {message}")]
pub struct Problem {
    /// file:line:column, or the file alone, or the argument of the command line.
    pub place: String,
    /// The field, what was found, and why it cannot be.
    pub message: String,
    /// What is accepted, and what to try.
    #[help]
    pub remedy: String,
    /// The file, for the excerpt.
    #[source_code]
    pub text: Arc<NamedSource<String>>,
    /// The bytes of the value in the file.
    #[label("here")]
    pub span: Option<SourceSpan>,
}

impl Problem {
    /// A problem that has no place inside a text: a missing file, an argument.
    pub fn without_text(place: &str, message: String, remedy: String) -> Problem {
        Problem {
            place: place.to_string(),
            message,
            remedy,
            text: Arc::new(NamedSource::new(place, String::new())),
            span: None,
        }
    }
}

/// Findings that are told in full; a file can hold thousands.
const MOST_TOLD: usize = 50;

/// Why a case cannot be run: all that was found wrong.
#[derive(Debug, Clone)]
pub struct CaseError {
    /// At least one problem, in the order of the checks.
    pub problems: Vec<Problem>,
}

impl std::error::Error for CaseError {}

impl fmt::Display for CaseError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.told().try_for_each(|problem| writeln!(formatter, "{problem}\n  help: {}", problem.remedy))?;
        self.untold().map_or(Ok(()), |untold| writeln!(formatter, "{untold}"))
    }
}

impl From<Problem> for CaseError {
    fn from(problem: Problem) -> Self {
        CaseError { problems: vec![problem] }
    }
}

impl CaseError {
    /// The problems with excerpts of the file, for a terminal; plain characters unless `coloured`.
    pub fn report(&self, coloured: bool) -> String {
        let theme = if coloured { GraphicalTheme::unicode() } else { GraphicalTheme::none() };
        // Places must stay in one piece for people and programs that search for them.
        let handler = GraphicalReportHandler::new_themed(theme).with_width(100).with_wrap_lines(false);
        let mut report = String::new();
        for problem in self.told() {
            if handler.render_report(&mut report, problem).is_err() {
                report.push_str(&problem.to_string());
            }
            report.push('\n');
        }
        report.extend(self.untold().map(|untold| untold + "\n"));
        report
    }

    fn told(&self) -> impl Iterator<Item = &Problem> {
        self.problems.iter().take(MOST_TOLD)
    }

    /// Says how many findings are not told.
    fn untold(&self) -> Option<String> {
        let more = self.problems.len().checked_sub(MOST_TOLD).filter(|&more| more > 0)?;
        Some(format!("and {more} findings more"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_report_keeps_long_places_in_one_piece() {
        let place = format!("/{}/scene.ron:3:7", "long-folder-name".repeat(12));
        let problem = Problem::without_text(&place, "part.start_k is negative".into(), "above 1 K".into());
        let report = CaseError::from(problem).report(false);
        assert!(report.contains(&place), "{report}");
        assert!(report.contains("above 1 K"), "{report}");
    }

    #[test]
    fn thousands_of_findings_are_counted_not_told() {
        let problem = Problem::without_text("scene.ron:1:1", "too cold".into(), "above 1 K".into());
        let error = CaseError { problems: vec![problem; 3000] };
        for text in [error.report(false), error.to_string()] {
            assert!(text.contains("and 2950 findings more"), "{text}");
            assert_eq!(text.matches("too cold").count(), MOST_TOLD);
        }
    }
}
