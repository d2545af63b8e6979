//! `--vary path=value,value,...`: a ladder over one field of the scene instead of the program's own settings.

use super::PrecisionError;
use super::settings::Setting;
use crate::case::{self, CaseError, Problem};
use crate::cli::PrecisionArguments;
use crate::model::Model;

/// Most values of a ladder: each is run at every spacing.
const MOST_VALUES: usize = 32;

/// Fields that change how a case is computed and not what it is.
const ACCEPTED: [&str; 3] = ["physics.", "resolution.disorder", "resolution.seed"];

/// The settings that `argument` asks for, each checked like a scene.
///
/// # Errors
/// [`PrecisionError::Case`] for an argument that is no list of values of an accepted field, and for a value that the field refuses.
pub(super) fn settings(
    arguments: &PrecisionArguments,
    argument: &str,
) -> Result<Vec<Setting>, PrecisionError> {
    let (field, values) = split(argument).map_err(CaseError::from)?;
    let setting = |value: &str| {
        let mut overrides = arguments.overrides.clone();
        overrides.push(format!("{field}={value}"));
        let case = case::load(&arguments.case, &overrides)?;
        Ok(Setting::new(&format!("{} {value}", last_name(field)), Model::from_case(&case)?))
    };
    values.into_iter().map(setting).collect()
}

fn last_name(field: &str) -> &str {
    field.rsplit('.').next().unwrap_or(field)
}

fn split(argument: &str) -> Result<(&str, Vec<&str>), Problem> {
    let refuse = |reason: &str, remedy: &str| {
        Problem::without_text(&format!("--vary {argument}"), reason.to_string(), remedy.to_string())
    };
    let example =
        "accepted: --vary path=value,value,..., as in --vary physics.0.smoothing_ratio=0.7,0.85,1.0";
    let (field, list) = argument.split_once('=').ok_or_else(|| refuse("found no `path=value`", example))?;
    let field = field.trim();
    if !ACCEPTED.iter().any(|accepted| field.starts_with(accepted)) {
        let remedy = "accepted: a field of physics (as physics.0.kernel), resolution.disorder, resolution.seed; spacings are \
                      varied anyway, and --set changes the case itself";
        return Err(refuse(&format!("`{field}` changes the weld or the ladder"), remedy));
    }
    let values = at_top_level(list);
    if values.iter().any(|value| value.is_empty()) {
        return Err(refuse("a value is missing", example));
    }
    if values.len() > MOST_VALUES {
        let remedy = format!("accepted: 1 to {MOST_VALUES}; each is run at every spacing");
        // The list itself would fill the screen.
        let place = format!("--vary {field}=...");
        return Err(Problem::without_text(&place, format!("found {} values", values.len()), remedy));
    }
    Ok((field, values))
}

/// The pieces between commas that stand in no brackets.
fn at_top_level(list: &str) -> Vec<&str> {
    let mut depth = 0i32;
    let outside = |letter: char| {
        depth += i32::from("([{".contains(letter)) - i32::from(")]}".contains(letter));
        letter == ',' && depth == 0
    };
    list.split(outside).map(str::trim).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_keep_their_brackets() {
        let (field, values) =
            split("physics.0.stepping=Euler(factor: 0.5), SuperSteps(tolerance: 1, max_stages: 9)").unwrap();
        assert_eq!(field, "physics.0.stepping");
        assert_eq!(values, ["Euler(factor: 0.5)", "SuperSteps(tolerance: 1, max_stages: 9)"]);
    }

    #[test]
    fn lists_that_are_none_are_refused() {
        let many = format!("physics.0.smoothing_ratio={}", vec!["1.0"; 5000].join(","));
        for (argument, words) in [
            ("physics.0.kernel", "no `path=value`"),
            ("physics.0.smoothing_ratio=", "a value is missing"),
            ("physics.0.smoothing_ratio=0.7,,1.0", "a value is missing"),
            ("resolution.spacing_m=1e-5,2e-5", "changes the weld or the ladder"),
            ("laser.path.pulse.power_w=100,200", "changes the weld or the ladder"),
            (many.as_str(), "found 5000 values"),
        ] {
            let problem = split(argument).unwrap_err().to_string();
            assert!(problem.contains(words) && problem.len() < 300, "{problem}");
        }
    }
}
