//! `welder list`: the cases, materials and benchmarks that come with the program.

use std::path::Path;

use crate::case::{MaterialCard, library, load_any, read_card};
use crate::cli::ExitStatus;
use crate::verify::{Benchmark, benchmarks};

/// Prints the lists to standard output.
pub fn command() -> ExitStatus {
    match library::cases_folder() {
        Some(cases) => println!("{}\n{}", cases_list(&cases), materials_list(&cases.join("materials"))),
        None => println!("no folder `cases` was found here or where the program was built"),
    }
    println!("\n{}", benchmarks_list());
    ExitStatus::Done
}

fn benchmarks_list() -> String {
    let line = |benchmark: &Benchmark| format!("  {:<36} {}\n", benchmark.name, benchmark.reference);
    "Benchmarks\n".to_string() + &benchmarks().iter().map(line).collect::<String>()
}

fn cases_list(cases: &Path) -> String {
    let mut text = "Cases\n".to_string();
    for folder in library::case_folders(cases) {
        let title = match load_any(&folder, &[]) {
            Ok(case) => case.title().to_string(),
            Err(_) => "cannot be read; `welder check` says why".to_string(),
        };
        text += &format!("  {:<36} {title}\n", folder.display().to_string());
    }
    text
}

fn materials_list(folder: &Path) -> String {
    let mut text = "Materials\n".to_string();
    for name in library::material_names(folder) {
        let summary = match read_card(&folder.join(format!("{name}.ron"))) {
            Ok(read) => summary(&read.card),
            Err(_) => "cannot be read; `welder check` of a case that uses it says why".to_string(),
        };
        text += &format!("  {name:<36} {summary}\n");
    }
    text
}

fn summary(card: &MaterialCard) -> String {
    format!("{}; solidus {} K, liquidus {} K", card.title, card.solidus_k.value, card.liquidus_k.value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_case_and_material_can_be_read() {
        let cases = library::cases_folder().unwrap();
        let (case_text, material_text) = (cases_list(&cases), materials_list(&cases.join("materials")));
        assert!(case_text.contains("spot-aluminium") && case_text.contains("seam-aluminium"), "{case_text}");
        assert!(material_text.contains("solidus 1410 K, liquidus 1620 K"), "{material_text}");
        assert!(benchmarks_list().contains("heat/gaussian-spot"));
        assert!(!(case_text + &material_text).contains("cannot be read"));
    }
}
