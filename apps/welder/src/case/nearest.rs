//! The known name that is most like a mistyped one.

/// The candidate nearest to `found`, when one is near enough to be meant.
pub fn nearest<'a>(found: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let simple = |name: &str| name.to_lowercase().replace(['-', '_', ' '], "");
    let target = simple(found);
    candidates
        .into_iter()
        .map(|candidate| (distance(&target, &simple(candidate)), candidate))
        .filter(|(distance, candidate)| *distance <= candidate.len().max(found.len()).div_ceil(3))
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate)
}

/// Edits between two names; a name that begins with the other is one edit away (`power` for `power_w`).
fn distance(found: &str, candidate: &str) -> usize {
    let long_enough = found.len().min(candidate.len()) >= 3;
    if long_enough && found != candidate && (candidate.starts_with(found) || found.starts_with(candidate)) {
        return 1;
    }
    strsim::damerau_levenshtein(found, candidate)
}

/// `did you mean X? ` when a name is near, nothing otherwise; then `accepted: ...` with all names.
pub fn suggestion(found: &str, candidates: &[&str]) -> String {
    let guess = nearest(found, candidates.iter().copied());
    let guess = guess.map_or(String::new(), |name| format!("did you mean `{name}`? "));
    format!("{guess}accepted: {}", candidates.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_find_their_name() {
        let names = ["spacing_m", "levels", "disorder", "seed"];
        assert_eq!(nearest("spacing", names), Some("spacing_m"));
        assert_eq!(nearest("spacing_mm", names), Some("spacing_m"));
        assert_eq!(nearest("dissorder", names), Some("disorder"));
        assert_eq!(nearest("Seeds", names), Some("seed"));
    }

    #[test]
    fn strangers_find_none() {
        assert_eq!(nearest("viscosity", ["spacing_m", "levels"]), None);
        assert_eq!(nearest("x", ["seed"]), None);
    }

    #[test]
    fn all_names_are_listed() {
        assert_eq!(suggestion("sed", &["seed", "size"]), "did you mean `seed`? accepted: seed, size");
    }
}
