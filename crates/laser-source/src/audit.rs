//! The account of the light: what was commanded, and where it went.

use std::ops::AddAssign;

use serde::{Deserialize, Serialize};

/// Where the energy of a beam goes (J). Closed: emitted = absorbed + reflected + missed.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PowerAudit {
    /// Energy that the path commands (J).
    pub commanded_j: f64,
    /// Energy that the profile spreads over the plane (J): commanded, times e^0.5 for the paper's
    /// normalisation.
    pub emitted_j: f64,
    /// Energy that hits the face and enters the material (J).
    pub absorbed_j: f64,
    /// Energy that hits the face and is reflected (J).
    pub reflected_j: f64,
    /// Energy that passes beside the face (J).
    pub missed_j: f64,
}

impl PowerAudit {
    /// Emitted energy that is in none of the accounts (J); zero to round-off.
    #[must_use]
    pub fn residual_j(&self) -> f64 {
        self.emitted_j - self.absorbed_j - self.reflected_j - self.missed_j
    }
}

impl AddAssign for PowerAudit {
    fn add_assign(&mut self, other: Self) {
        self.commanded_j += other.commanded_j;
        self.emitted_j += other.emitted_j;
        self.absorbed_j += other.absorbed_j;
        self.reflected_j += other.reflected_j;
        self.missed_j += other.missed_j;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::beam::{Beam, GaussianHuEberhard};
    use crate::rectangle::Rectangle;
    use crate::source::tests::{GAUSSIAN, TOP_HAT, seam};
    use proptest::prelude::*;

    const PAPER: Beam = Beam::GaussianHuEberhard(GaussianHuEberhard { radius_1e_m: 1.0 });

    proptest! {
        #[test]
        fn closes_for_every_beam_and_face(
            kind in 0..3_usize, start in 0.0..4.0_f64, step in 1e-3..2.0_f64,
            x in -3.0..6.0_f64, y in -3.0..6.0_f64, half in 0.1..5.0_f64,
        ) {
            let source = seam([GAUSSIAN, TOP_HAT, PAPER][kind]);
            let audit = source.audit(start, start + step, &Rectangle::square(x, y, half));
            prop_assert!(audit.residual_j().abs() <= 1e-14 * audit.emitted_j);
            let emitted_j = source.beam().total() * audit.commanded_j;
            prop_assert!((audit.emitted_j - emitted_j).abs() <= 1e-15 * audit.emitted_j);
            prop_assert!((audit.reflected_j * 0.4 - audit.absorbed_j * 0.6).abs() <= 1e-14 * audit.emitted_j);
        }
    }

    #[test]
    fn half_plane_beside_the_seam_misses_half() {
        // The seam runs along y = 4 x / 3 from the origin; by symmetry about its middle (1.5, 2) half of the
        // light falls beyond x = 1.5.
        let face = Rectangle { x_min_m: 1.5, ..Rectangle::PLANE };
        let audit = seam(GAUSSIAN).audit(0.0, 9.0, &face);
        assert!((audit.commanded_j - 1250.0).abs() < 1e-12);
        assert!((audit.missed_j - 625.0).abs() < 1e-10);
        assert!((audit.absorbed_j - 250.0).abs() < 1e-10);
        assert!((audit.reflected_j - 375.0).abs() < 1e-10);
    }

    #[test]
    fn audits_of_steps_add_up() {
        let (source, face) = (seam(PAPER), Rectangle::square(1.0, 1.0, 1.5));
        let mut sum = PowerAudit::default();
        for i in 0..40 {
            sum += source.audit(0.1 * f64::from(i), 0.1 * f64::from(i + 1), &face);
        }
        let whole = source.audit(0.0, 4.0, &face);
        assert!((sum.emitted_j - whole.emitted_j).abs() < 1e-11);
        assert!((sum.absorbed_j - whole.absorbed_j).abs() < 1e-3);
        assert!(sum.missed_j > 100.0 && sum.residual_j().abs() < 1e-11);
    }
}
