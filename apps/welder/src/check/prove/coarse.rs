//! The coarse copy of a case: the largest spacing that still resolves the beam and divides the part.

use crate::case::Case;

/// Spacings over the case's own that are tried.
const FACTORS: [f64; 5] = [4.0, 3.0, 2.0, 1.5, 1.25];

/// Spacings that the beam's radius (1/e) keeps.
const SMALLEST_BEAM: f64 = 3.0;

/// Spacings that each side of the part keeps.
const SMALLEST_SIDE: f64 = 5.0;

/// The case at the largest usable spacing, its own where none is.
pub(super) fn coarse(case: &Case) -> Case {
    let mut copy = case.clone();
    let own = case.scene.resolution.spacing_m;
    let coarser = FACTORS.into_iter().map(|factor| factor * own).find(|&spacing| usable(case, spacing));
    copy.scene.resolution.spacing_m = coarser.unwrap_or(own);
    copy
}

fn usable(case: &Case, spacing: f64) -> bool {
    let (part, whole) =
        (&case.scene.part, |length: f64| (length / spacing - (length / spacing).round()).abs() < 1e-6);
    let sides = part.size_m.iter().all(|&size| whole(size) && size >= (SMALLEST_SIDE - 1e-6) * spacing);
    let corners = part.regions.iter().flat_map(|region| [region.low_m, region.high_m]);
    let low = part.low_m();
    let regions = corners.into_iter().all(|corner| (0..3).all(|axis| whole(corner[axis] - low[axis])));
    let Some(laser) = &case.scene.laser else { return sides && regions };
    let depth = match laser.absorption {
        laser_source::Absorption::BeerLambert { absorption_coefficient_per_m, .. } => {
            absorption_coefficient_per_m.recip()
        }
        laser_source::Absorption::Surface { .. } => f64::INFINITY,
    };
    sides && regions && depth >= 2.0 * spacing && laser.beam.radius_m() >= SMALLEST_BEAM * spacing
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::{library::cases_folder, load};

    fn spacing(overrides: &[&str]) -> f64 {
        let overrides: Vec<_> = overrides.iter().map(|text| text.to_string()).collect();
        let case = load(&cases_folder().unwrap().join("spot-aluminium"), &overrides).unwrap();
        coarse(&case).scene.resolution.spacing_m
    }

    #[test]
    fn beam_part_and_regions_keep_their_shape() {
        // 1/e radius 424 um: 4.2 spacings of 100 um, 2.8 of 150 um.
        assert!((spacing(&[]) - 100e-6).abs() < 1e-12);
        assert!((spacing(&["resolution.spacing_m=25e-6"]) - 100e-6).abs() < 1e-12);
        // 81 spacings are no multiple of two, but 54 of 75 um.
        assert!((spacing(&["part.size_m=(4.05e-3,4.05e-3,4.05e-3)"]) - 75e-6).abs() < 1e-12);
        let region =
            "part.regions=[(low_m: (0.0, 0.0, -0.15e-3), high_m: (1.0e-3, 1.0e-3, 0.0), start_k: 400.0)]";
        assert!((spacing(&[region]) - 50e-6).abs() < 1e-12);
    }
}
