//! What `--json` writes.

use super::LevelResult;
use crate::observe::Machine;
use serde::{Deserialize, Serialize};

/// The answers of all benchmarks that ran.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// Version of the program.
    pub version: String,
    /// The commit that it was built from.
    pub commit: String,
    /// Where it ran.
    pub machine: Machine,
    /// The answers.
    pub entries: Vec<Entry>,
}

/// One quantity of one benchmark.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Entry {
    /// Stable name.
    pub name: String,
    /// Crate whose law is tested.
    #[serde(rename = "crate")]
    pub tested_crate: String,
    /// What the answer is compared with.
    pub reference: String,
    /// What is compared.
    pub quantity: String,
    /// Errors and cost, rising resolutions.
    pub levels: Vec<LevelResult>,
    /// Order of convergence over the levels, if they show one.
    pub observed_order: Option<f64>,
    /// Largest error accepted; of several marks, the one that was hardest to meet.
    pub pass_mark: f64,
    /// The resolution of that mark.
    pub at_resolution: f64,
    /// Whether all marks hold.
    pub passed: bool,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_keys_are_those_of_the_contract() {
        let level = LevelResult {
            resolution: 5.0,
            particles: 10,
            error: 0.01,
            pair_visits: 9,
            cpu_s: Some(0.1),
            wall_s: 0.2,
        };
        let entry = Entry {
            name: "heat/x".into(),
            tested_crate: "sph-thermal".into(),
            reference: "exact".into(),
            quantity: "T".into(),
            levels: vec![level],
            observed_order: None,
            pass_mark: 0.02,
            at_resolution: 5.0,
            passed: true,
        };
        let (version, commit) = ("1".into(), "0123456789ab".into());
        let report = Report { version, commit, machine: Machine::here(), entries: vec![entry] };
        let value = serde_json::to_value(&report).unwrap();
        let keys = |value: &serde_json::Value| {
            let mut keys: Vec<String> = value.as_object().unwrap().keys().cloned().collect();
            keys.sort();
            keys.join(" ")
        };
        assert_eq!(keys(&value), "commit entries machine version");
        let entry = &value["entries"][0];
        let expected = "at_resolution crate levels name observed_order pass_mark passed quantity reference";
        assert_eq!(keys(entry), expected);
        assert_eq!(keys(&entry["levels"][0]), "cpu_s error pair_visits particles resolution wall_s");
    }
}
