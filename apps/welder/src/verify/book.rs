//! Pages for the book: a table and plots for each group of benchmarks, all from one run.
//!
//! A group is the first part of the names, as `heat`. Pages hold no date: a second run of the same program on the same machine
//! changes only what it measures anew.

use super::order::ROUND_OFF;
use super::{Entry, LevelResult, Report};
use crate::observe::scatter_picture::{Series, draw_scatter};
use crate::observe::{ObserveError, whole_file};
use std::fmt::Write;
use std::path::Path;

/// Lines of one picture; more of them cannot be told apart.
const LINES: usize = 8;

/// How the program was built.
pub(super) const BUILD: &str = env!("WELDER_BUILD");

/// Writes a page and pictures for each group of the report into a folder; `command` is what was run.
///
/// # Errors
/// [`ObserveError`] when a file cannot be written.
pub(super) fn write(folder: &Path, report: &Report, command: &str) -> Result<(), ObserveError> {
    std::fs::create_dir_all(folder).map_err(ObserveError::file("create", folder))?;
    for group in report.entries.chunk_by(|one, other| group_of(one) == group_of(other)) {
        let pictures = draw(folder, group)?;
        let path = folder.join(format!("{}.md", group_of(&group[0])));
        whole_file::replace(&path, page(report, group, command, &pictures).as_bytes())
            .map_err(ObserveError::file("write", &path))?;
    }
    Ok(())
}

fn group_of(entry: &Entry) -> &str {
    entry.name.split('/').next().unwrap_or(&entry.name)
}

fn page(report: &Report, group: &[Entry], command: &str, pictures: &[String]) -> String {
    let name = group_of(&group[0]);
    let held = group.iter().filter(|entry| entry.passed).count();
    let mut text = format!(
        "# Benchmarks: {name}\n\n\
         Written by `{command}`, welder {} (commit {}), on {}; built with {BUILD}. {held} of {} entries hold their marks. Errors are \
         relative where the answer is not zero; cost is that of the finest resolution.\n\n\
         | entry | resolution: error | order | mark | pair visits | cpu s | holds |\n|---|---|---|---|---|---|---|\n",
        report.version,
        report.commit,
        report.machine,
        group.len()
    );
    let mut say = |line: String| text.write_str(&line).expect("a string takes any text");
    group.iter().for_each(|entry| say(numbers(entry)));
    say("\n| entry | crate | what is compared | with |\n|---|---|---|---|\n".into());
    for entry in group {
        let cells =
            [&entry.tested_crate, &entry.quantity, &entry.reference].map(|text| text.replace('|', "\\|"));
        say(format!("| `{}` | {} |\n", entry.name, cells.join(" | ")));
    }
    pictures.iter().for_each(|picture| say(format!("\n![{name}: error against resolution]({picture})\n")));
    text
}

/// What was measured, as a row.
fn numbers(entry: &Entry) -> String {
    let errors: Vec<_> =
        entry.levels.iter().map(|level| format!("{}: {:.2e}", level.resolution, level.error)).collect();
    let finest = entry.levels.last();
    format!(
        "| `{}` | {} | {} | {} at {} | {} | {} | {} |\n",
        entry.name,
        errors.join("; "),
        entry.observed_order.map_or_else(String::new, |order| format!("{order:.2}")),
        entry.pass_mark,
        entry.at_resolution,
        finest.map_or_else(String::new, |level| format!("{:.1e}", level.pair_visits as f64)),
        finest.and_then(|level| level.cpu_s).map_or_else(String::new, |cpu_s| format!("{cpu_s:.2}")),
        if entry.passed { "yes" } else { "**no**" }
    )
}

/// Draws the entries of a group whose errors are more than round-off; gives the names of the pictures.
fn draw(folder: &Path, group: &[Entry]) -> Result<Vec<String>, ObserveError> {
    let name = group_of(&group[0]);
    let shown = |entry: &&Entry| entry.levels.iter().any(|level| level.error > ROUND_OFF);
    let lines: Vec<Series> = group.iter().filter(shown).map(line).collect();
    let mut pictures = Vec::new();
    for (number, chunk) in lines.chunks(LINES).enumerate() {
        let picture = format!("{name}-{}.png", number + 1);
        let labels = ("resolution", "error");
        draw_scatter(&folder.join(&picture), &format!("{name}: error against resolution"), labels, chunk)?;
        pictures.push(picture);
    }
    Ok(pictures)
}

fn line(entry: &Entry) -> Series {
    let name = entry.name.split_once('/').map_or(entry.name.as_str(), |(_, rest)| rest).to_string();
    let point = |level: &LevelResult| (level.resolution, level.error);
    Series { name, points: entry.levels.iter().map(point).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::observe::Machine;

    fn entry(name: &str, errors: [f64; 3], passed: bool) -> Entry {
        let level = |(k, &error): (usize, &f64)| LevelResult {
            resolution: 5.0 * 2f64.powi(k as i32),
            particles: 10,
            error,
            pair_visits: 123_456,
            cpu_s: Some(0.25),
            wall_s: 0.3,
        };
        Entry {
            name: name.into(),
            tested_crate: "sph-thermal".into(),
            reference: "exact".into(),
            quantity: "largest |T - exact|".into(),
            levels: errors.iter().enumerate().map(level).collect(),
            observed_order: passed.then_some(2.0),
            pass_mark: 0.01,
            at_resolution: 10.0,
            passed,
        }
    }

    #[test]
    fn each_group_has_a_page_with_its_numbers_and_its_pictures() {
        let folder = tempfile::tempdir().unwrap();
        let mut entries: Vec<_> =
            (0..9).map(|k| entry(&format!("heat/number-{k}"), [0.04, 0.01, 0.0025], true)).collect();
        entries.push(entry("melt/lost", [0.04, 0.05, 0.06], false));
        entries.push(entry("melt/kept", [0.0, 1e-15, 0.0], true));
        let (version, commit) = ("9.8.7".into(), "0123456789ab".into());
        let report = Report { version, commit, machine: Machine::here(), entries };
        let book = folder.path().join("validation");
        write(&book, &report, "welder verify --level full").unwrap();
        let [heat, melt] =
            ["heat", "melt"].map(|name| std::fs::read_to_string(book.join(format!("{name}.md"))).unwrap());
        for part in [
            "welder 9.8.7 (commit 0123456789ab)",
            BUILD,
            "`welder verify --level full`",
            "9 of 9 entries",
            "| `heat/number-3` | 5: 4.00e-2; 10: 1.00e-2; 20: 2.50e-3 | 2.00 | 0.01 at 10 | 1.2e5 | 0.25 | yes |",
            "| `heat/number-3` | sph-thermal | largest \\|T - exact\\| | exact |",
            "(heat-1.png)",
            "(heat-2.png)",
        ] {
            assert!(heat.contains(part), "{part} is not in:\n{heat}");
        }
        assert!(melt.contains("1 of 2 entries") && melt.contains("| **no** |"), "{melt}");
        let pictures = ["heat-1.png", "heat-2.png", "melt-1.png"];
        assert!(pictures.iter().all(|name| book.join(name).is_file()));
        assert_eq!(std::fs::read_dir(&book).unwrap().count(), pictures.len() + 2);
    }

    #[test]
    fn the_build_names_compiler_profile_and_flags() {
        assert!(
            BUILD.starts_with("rustc 1.") && BUILD.contains("opt-level") && BUILD.contains("rustflags"),
            "{BUILD}"
        );
    }
}
