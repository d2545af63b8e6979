//! Spacing against part: every box must be a whole number of spacings, and at least two.

use super::super::scene::{Levels, Scene};
use super::findings::Findings;
use super::part::check_box;
use super::plausible::{DISORDER, SPACING, number};

/// Most distance from a whole number of spacings that counts as round-off, in spacings.
const ROUND_OFF: f64 = 1e-6;

/// Checks the resolution; says whether spacing and part are usable together.
pub fn check(findings: &mut Findings, scene: &Scene, part_is_fine: bool) -> bool {
    let resolution = &scene.resolution;
    findings.within("resolution.disorder", resolution.disorder, &DISORDER);
    check_fine_box(findings, scene);
    if !findings.within("resolution.spacing_m", resolution.spacing_m, &SPACING) || !part_is_fine {
        return false;
    }
    let sizes = [0, 1, 2].map(|axis| check_size(findings, scene, axis)) == [true; 3];
    if sizes {
        (0..scene.part.regions.len()).for_each(|index| check_region(findings, scene, index));
    }
    sizes
}

fn check_size(findings: &mut Findings, scene: &Scene, axis: usize) -> bool {
    let (size_m, spacing_m) = (scene.part.size_m[axis], scene.resolution.spacing_m);
    let field = format!("part.size_m.{axis}");
    let count = size_m / spacing_m;
    if count < 2.0 - ROUND_OFF {
        let reason =
            format!("thinner than two spacings of {} m, so hardly a particle fits", number(spacing_m));
        let remedy = format!(
            "accepted: at least {} m, or resolution.spacing_m at most {}",
            number(2.0 * spacing_m),
            number(size_m / 2.0)
        );
        findings.refuse(&field, &reason, remedy);
        return false;
    }
    let reason = format!("{} spacings of {} m, not a whole number", number(count), number(spacing_m));
    let (below, above) = (count.floor() * spacing_m, count.ceil() * spacing_m);
    let remedy = format!(
        "nearest accepted: {} or {} m; or resolution.spacing_m: {}",
        number(below),
        number(above),
        exact(fitting_spacing(scene.part.size_m, size_m, count))
    );
    findings.require(is_whole(count), &field, &reason, remedy)
}

/// Whether a number of spacings is whole but for round-off.
pub fn is_whole(count: f64) -> bool {
    (count - count.round()).abs() < ROUND_OFF * count.max(1.0)
}

/// The spacing nearest to the wanted one that divides all three sizes, else this one alone.
fn fitting_spacing(sizes_m: [f64; 3], size_m: f64, count: f64) -> f64 {
    let counts = (0..200).flat_map(|step| [count.floor() - f64::from(step), count.ceil() + f64::from(step)]);
    let candidates = counts.filter(|&whole| whole >= 2.0).map(|whole| size_m / whole);
    let mut fitting =
        candidates.filter(|spacing_m| sizes_m.iter().all(|size_m| is_whole(size_m / spacing_m)));
    fitting.next().unwrap_or(size_m / count.round())
}

/// A suggested spacing must divide the part when it is copied, so it keeps its digits.
fn exact(spacing_m: f64) -> String {
    let short = number(spacing_m);
    let same = short.parse::<f64>().is_ok_and(|read| (read / spacing_m - 1.0).abs() < 1e-12);
    if same { short } else { format!("{spacing_m:e}") }
}

fn check_region(findings: &mut Findings, scene: &Scene, index: usize) {
    let (region, low_m) = (&scene.part.regions[index], scene.part.low_m());
    let spacing_m = scene.resolution.spacing_m;
    for (name, corner_m) in [("low_m", region.low_m), ("high_m", region.high_m)] {
        for axis in 0..3 {
            let count = (corner_m[axis] - low_m[axis]) / spacing_m;
            let near = |count: f64| number(low_m[axis] + count * spacing_m);
            let reason = format!("cuts through particles: {} spacings from the part's corner", number(count));
            let remedy = format!("nearest accepted: {} or {} m", near(count.floor()), near(count.ceil()));
            findings.require(
                is_whole(count),
                &format!("part.regions.{index}.{name}.{axis}"),
                &reason,
                remedy,
            );
        }
    }
}

fn check_fine_box(findings: &mut Findings, scene: &Scene) {
    let Levels::FineBox { low_m, high_m } = scene.resolution.levels else { return };
    if !check_box(findings, "resolution.levels", low_m, high_m) {
        return;
    }
    let (part_low_m, part_high_m) = (scene.part.low_m(), scene.part.high_m());
    let meets = (0..3).all(|axis| low_m[axis] < part_high_m[axis] && high_m[axis] > part_low_m[axis]);
    let remedy = format!(
        "accepted: a box that shares room with the part, {part_low_m:?} to {part_high_m:?} m; z is negative below the top face"
    );
    findings.require(meets, "resolution.levels", "the fine box lies outside the part", remedy);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_suggested_spacing_divides_all_sizes() {
        let sizes_m = [6.0e-3, 4.0e-3, 3.0e-3];
        let spacing_m = fitting_spacing(sizes_m, 6.0e-3, 6.0e-3 / 70.0e-6);
        assert!(sizes_m.iter().all(|size_m| is_whole(size_m / spacing_m)), "{spacing_m}");
        assert!((spacing_m / 70.0e-6 - 1.0).abs() < 0.05, "{spacing_m}");
    }

    #[test]
    fn round_off_is_whole() {
        assert!(is_whole(6.0e-3 / 50.0e-6) && is_whole(0.3 / 0.1));
        assert!(!is_whole(119.99) && !is_whole(0.5));
    }

    #[test]
    fn suggestions_keep_the_digits_that_they_need() {
        assert_eq!(exact(5.0e-5), "5e-5");
        assert_eq!(exact(6.0e-3 / 7.0).parse::<f64>().unwrap(), 6.0e-3 / 7.0);
    }
}
