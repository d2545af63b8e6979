//! The part and its regions: sizes, places, start temperatures.

use super::super::card::CardSource;
use super::super::scene::{Region, Scene};
use super::findings::Findings;
use super::plausible::{COORDINATE, PART_LENGTH, TEMPERATURE, number};

/// Checks sizes and places; says whether the lattice can be judged.
pub fn check(findings: &mut Findings, scene: &Scene) -> bool {
    let part = &scene.part;
    let sizes = findings.all_within("part.size_m", &part.size_m, &PART_LENGTH);
    let corner = findings.all_within("part.low_corner_m", &part.low_corner_m, &COORDINATE);
    let mut regions = true;
    for (index, region) in part.regions.iter().enumerate() {
        regions &= check_box(findings, &format!("part.regions.{index}"), region.low_m, region.high_m);
        check_purpose(findings, index, region);
    }
    if sizes && corner && regions {
        part.regions
            .iter()
            .enumerate()
            .for_each(|(index, region)| check_inside(findings, scene, index, region));
    }
    sizes && corner && regions
}

/// Checks that a box has plausible corners in the right order.
pub fn check_box(findings: &mut Findings, field: &str, low_m: [f64; 3], high_m: [f64; 3]) -> bool {
    let low = findings.all_within(&format!("{field}.low_m"), &low_m, &COORDINATE);
    let high = findings.all_within(&format!("{field}.high_m"), &high_m, &COORDINATE);
    let mut ordered = true;
    for axis in 0..3 {
        if low && high && low_m[axis] >= high_m[axis] {
            let reason = format!("not above low_m, which is {} on this axis", number(low_m[axis]));
            findings.refuse(
                &format!("{field}.high_m.{axis}"),
                &reason,
                "accepted: high_m above low_m on every axis",
            );
            ordered = false;
        }
    }
    low && high && ordered
}

fn check_purpose(findings: &mut Findings, index: usize, region: &Region) {
    let changes = region.material.is_some() || region.start_k.is_some();
    let remedy = "give the region a material, a start_k, or both; or leave it out";
    findings.require(changes, &format!("part.regions.{index}"), "the region changes nothing", remedy);
}

fn check_inside(findings: &mut Findings, scene: &Scene, index: usize, region: &Region) {
    let (low_m, high_m) = (scene.part.low_m(), scene.part.high_m());
    for axis in 0..3 {
        // Corners are sums of given numbers; a billionth of the part is round-off.
        let slack_m = 1e-9 * scene.part.size_m[axis];
        let accepted =
            format!("accepted: {} to {} m on this axis", number(low_m[axis]), number(high_m[axis]));
        let field = format!("part.regions.{index}");
        let low_fits = region.low_m[axis] >= low_m[axis] - slack_m;
        let high_fits = region.high_m[axis] <= high_m[axis] + slack_m;
        findings.require(low_fits, &format!("{field}.low_m.{axis}"), "outside the part", accepted.as_str());
        findings.require(high_fits, &format!("{field}.high_m.{axis}"), "outside the part", accepted);
    }
}

/// Checks the start temperatures of part and regions against their materials.
pub fn check_start(findings: &mut Findings, scene: &Scene, cards: &[CardSource], region_materials: &[usize]) {
    check_temperature(findings, scene, "part.start_k", scene.part.start_k, &cards[0]);
    for (index, (region, &material)) in scene.part.regions.iter().zip(region_materials).enumerate() {
        let field = format!("part.regions.{index}.start_k");
        if let Some(start_k) = region.start_k {
            check_temperature(findings, scene, &field, start_k, &cards[material]);
        }
    }
}

/// Melt may start with this share more volume than room: it drives itself apart.
const LARGEST_START_EXPANSION: f64 = 0.01;

fn check_temperature(findings: &mut Findings, scene: &Scene, field: &str, start_k: f64, card: &CardSource) {
    if !findings.within(field, start_k, &TEMPERATURE) {
        return;
    }
    if let Some(boiling) = &card.card.boiling_k {
        let reason = format!("above the boiling temperature of {}", card.name);
        let remedy = format!("accepted: below {} K", number(boiling.value));
        findings.require(start_k < boiling.value, field, &reason, remedy);
    }
    if let (Some(expansion), Some(_)) = (&card.card.volume_expansion_liquid_1_k, scene.flow()) {
        let liquidus_k = card.card.liquidus_k.value;
        let grown = expansion.value * (start_k - liquidus_k);
        let reason = format!(
            "{} would start as melt with {:.1} % more volume than room, and drive itself apart",
            card.name,
            100.0 * grown
        );
        let highest_k = liquidus_k + LARGEST_START_EXPANSION / expansion.value;
        let remedy = format!(
            "accepted with Flow and volume_expansion_liquid_1_k: up to {} K; let the pool melt, or leave the expansion out",
            number(highest_k)
        );
        findings.require(grown <= LARGEST_START_EXPANSION, field, &reason, remedy);
    }
}
