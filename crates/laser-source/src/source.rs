//! A laser source: beam, path and absorption together, integrated over time steps.

use serde::{Deserialize, Serialize};

use crate::absorption::Absorption;
use crate::audit::PowerAudit;
use crate::beam::Beam;
use crate::error::Error;
use crate::path::{Path, Track};
use crate::quadrature::{QuadraturePoint, for_each_point};
use crate::rectangle::Rectangle;

/// A beam that moves along a path over a plane surface and is partly absorbed; valid by construction.
///
/// Means over a step are integrated in time by Gauss-Legendre quadrature, piece by piece between the events
/// of the path, because a source held at mid-step leaves an error that no finer grid removes. For a Gaussian
/// the error is below 1e-6 of what a square of the same size receives in the middle of the beam. A top-hat
/// has a sharp rim: below 1e-3 for squares on the rim with sides of 1/25 of its radius or more. Sums over a
/// tiling are exact to round-off for both.
///
/// In a case file:
///
/// ```text
/// (beam: Gaussian(radius_1e2_m: 0.6e-3), path: Spot(..), absorption: Surface(absorptivity: 0.35))
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "LaserSourceInput", into = "LaserSourceInput")]
pub struct LaserSource {
    beam: Beam,
    path: Path,
    absorption: Absorption,
    track: Track,
}

/// The written form of a [`LaserSource`].
#[derive(Clone, Serialize, Deserialize)]
#[serde(rename = "LaserSource", deny_unknown_fields)]
struct LaserSourceInput {
    beam: Beam,
    path: Path,
    absorption: Absorption,
}

impl LaserSource {
    /// The source of a beam on a path.
    ///
    /// # Errors
    /// Those of [`Beam::validate`], [`Path::track`] and [`Absorption::validate`].
    pub fn new(beam: Beam, path: Path, absorption: Absorption) -> Result<Self, Error> {
        beam.validate()?;
        absorption.validate()?;
        let track = path.track()?;
        Ok(Self { beam, path, absorption, track })
    }

    /// The beam's profile.
    #[must_use]
    pub fn beam(&self) -> &Beam {
        &self.beam
    }

    /// The beam's path as it was given.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The beam's path as it is evaluated: position, power, energy and events over time.
    #[must_use]
    pub fn track(&self) -> &Track {
        &self.track
    }

    /// How the light is absorbed.
    #[must_use]
    pub fn absorption(&self) -> &Absorption {
        &self.absorption
    }

    /// Absorbed intensity at one time and place (W/m^2).
    #[must_use]
    pub fn absorbed_intensity(&self, time_s: f64, x_m: f64, y_m: f64) -> f64 {
        let [beam_x_m, beam_y_m] = self.track.position(time_s);
        let power_w = self.absorption.absorptivity() * self.track.power(time_s);
        power_w * self.beam.intensity_per_watt(x_m - beam_x_m, y_m - beam_y_m)
    }

    /// Energy absorbed in the whole plane from `t0_s` to `t1_s` (J), exact.
    #[must_use]
    pub fn absorbed_energy(&self, t0_s: f64, t1_s: f64) -> f64 {
        self.absorption.absorptivity() * self.beam.total() * self.track.energy(t0_s, t1_s)
    }

    /// Absorbed power in a rectangle, mean over the step from `t0_s` to a later `t1_s` (W).
    #[must_use]
    pub fn mean_absorbed_power(&self, t0_s: f64, t1_s: f64, rectangle: &Rectangle) -> f64 {
        let mut energy_j = 0.0;
        self.for_each_point(t0_s, t1_s, |point| {
            energy_j += point.energy_j * self.fraction(&point, rectangle)
        });
        self.absorption.absorptivity() * energy_j / (t1_s - t0_s)
    }

    /// Where the energy commanded from `t0_s` to `t1_s` goes if `face` is all there is to hit.
    #[must_use]
    pub fn audit(&self, t0_s: f64, t1_s: f64, face: &Rectangle) -> PowerAudit {
        let mut hit_j = 0.0;
        self.for_each_point(t0_s, t1_s, |point| hit_j += point.energy_j * self.fraction(&point, face));
        let commanded_j = self.track.energy(t0_s, t1_s);
        let emitted_j = self.beam.total() * commanded_j;
        PowerAudit {
            commanded_j,
            emitted_j,
            absorbed_j: self.absorption.absorptivity() * hit_j,
            reflected_j: self.absorption.reflectivity() * hit_j,
            missed_j: (emitted_j - hit_j).max(0.0),
        }
    }

    /// Calls `visit` for each quadrature point of the step.
    pub(crate) fn for_each_point(&self, t0_s: f64, t1_s: f64, visit: impl FnMut(QuadraturePoint)) {
        for_each_point(&self.track, self.beam.smooth_length_m(), t0_s, t1_s, visit);
    }

    /// Share of the beam of one quadrature point in a rectangle.
    fn fraction(&self, point: &QuadraturePoint, rectangle: &Rectangle) -> f64 {
        self.beam.fraction_in_rectangle(
            rectangle.x_min_m - point.x_m,
            rectangle.x_max_m - point.x_m,
            rectangle.y_min_m - point.y_m,
            rectangle.y_max_m - point.y_m,
        )
    }
}

impl TryFrom<LaserSourceInput> for LaserSource {
    type Error = Error;

    fn try_from(input: LaserSourceInput) -> Result<Self, Error> {
        Self::new(input.beam, input.path, input.absorption)
    }
}

impl From<LaserSource> for LaserSourceInput {
    fn from(source: LaserSource) -> Self {
        Self { beam: source.beam, path: source.path, absorption: source.absorption }
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::beam::{Gaussian, GaussianHuEberhard, TopHat};
    use proptest::prelude::*;

    pub(crate) const GAUSSIAN: Beam = Beam::Gaussian(Gaussian { radius_1e_m: 1.0 });
    pub(crate) const TOP_HAT: Beam = Beam::TopHat(TopHat { radius_m: 1.0 });

    /// A seam along the diagonal, 2 m/s for 2.5 s from t = 1, 500 W, absorptivity 0.4.
    pub(crate) fn seam(beam: Beam) -> LaserSource {
        let path = Path::Straight {
            from_m: [0.0; 2],
            to_m: [3.0, 4.0],
            speed_m_s: 2.0,
            power_w: 500.0,
            start_s: 1.0,
        };
        LaserSource::new(beam, path, Absorption::Surface { absorptivity: 0.4 }).unwrap()
    }

    /// Mean absorbed power by many midpoints in time: slow, but knows nothing of the quadrature.
    pub(crate) fn reference(
        source: &LaserSource,
        t0_s: f64,
        t1_s: f64,
        rectangle: &Rectangle,
        count: i32,
    ) -> f64 {
        let step = (t1_s - t0_s) / f64::from(count);
        let power = |i: i32| {
            let time = t0_s + (f64::from(i) + 0.5) * step;
            let [x, y] = source.track().position(time);
            let fraction = source.beam().fraction_in_rectangle(
                rectangle.x_min_m - x,
                rectangle.x_max_m - x,
                rectangle.y_min_m - y,
                rectangle.y_max_m - y,
            );
            0.4 * source.track().power(time) * fraction
        };
        (0..count).map(power).sum::<f64>() / f64::from(count)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        #[test]
        fn mean_over_a_step_is_exact_to_1e_6_of_the_peak(
            start in 1.0..3.0_f64, step in 1e-3..0.5_f64,
            x in -1.0..4.0_f64, y in -1.0..4.0_f64, half in 0.02..0.5_f64,
        ) {
            let source = seam(GAUSSIAN);
            let rectangle = Rectangle::square(x, y, half);
            let mean = source.mean_absorbed_power(start, start + step, &rectangle);
            let expected = reference(&source, start, start + step, &rectangle, 20_000);
            let peak = 200.0 * source.beam().fraction_in_rectangle(-half, half, -half, half);
            prop_assert!((mean - expected).abs() < 1e-6 * peak, "{mean} {expected}");
        }

        #[test]
        fn top_hat_is_within_its_stated_error(
            start in 1.0..3.0_f64, step in 1e-3..0.5_f64,
            x in -1.0..4.0_f64, y in -1.0..4.0_f64, half in 0.02..0.5_f64,
        ) {
            let source = seam(TOP_HAT);
            let rectangle = Rectangle::square(x, y, half);
            let mean = source.mean_absorbed_power(start, start + step, &rectangle);
            let expected = reference(&source, start, start + step, &rectangle, 20_000);
            let peak = 200.0 * source.beam().fraction_in_rectangle(-half, half, -half, half);
            prop_assert!((mean - expected).abs() < 1e-3 * peak, "{mean} {expected} {peak}");
        }
    }

    #[test]
    fn plane_receives_all_that_is_absorbed() {
        for beam in [GAUSSIAN, TOP_HAT, Beam::GaussianHuEberhard(GaussianHuEberhard { radius_1e_m: 1.0 })] {
            let source = seam(beam);
            let energy_j = 5.0 * source.mean_absorbed_power(0.0, 5.0, &Rectangle::PLANE);
            assert!((energy_j / (0.4 * 500.0 * 2.5 * beam.total()) - 1.0).abs() < 1e-14);
            assert!((source.absorbed_energy(0.0, 5.0) / energy_j - 1.0).abs() < 1e-14);
        }
    }

    #[test]
    fn swept_strip_of_a_long_seam_has_the_closed_form() {
        // A beam that crosses a strip a <= x <= b completely leaves it P (b - a) / v of energy.
        let path = Path::Straight {
            from_m: [-20.0, 0.0],
            to_m: [20.0, 0.0],
            speed_m_s: 4.0,
            power_w: 1000.0,
            start_s: 0.0,
        };
        let source = LaserSource::new(GAUSSIAN, path, Absorption::Surface { absorptivity: 1.0 }).unwrap();
        let strip = Rectangle { x_min_m: -0.3, x_max_m: 0.2, ..Rectangle::PLANE };
        let energy_j = 10.0 * source.mean_absorbed_power(0.0, 10.0, &strip);
        assert!((energy_j / 125.0 - 1.0).abs() < 1e-8, "{energy_j}");
    }

    #[test]
    fn intensity_follows_the_beam() {
        let source = seam(GAUSSIAN);
        let intensity = source.absorbed_intensity(2.25, 1.5, 2.0);
        assert!((intensity * std::f64::consts::PI - 200.0).abs() < 1e-12);
        assert_eq!(source.absorbed_intensity(0.5, 0.0, 0.0), 0.0);
    }

    #[test]
    fn reads_from_a_case_file_and_refuses_bad_numbers_there() {
        let text = "(beam: Gaussian(radius_1e2_m: 0.6e-3), \
            path: Straight(from_m: (0, 0), to_m: (0.01, 0), speed_m_s: 0.1, power_w: 900, start_s: 0), \
            absorption: Surface(absorptivity: 0.35))";
        let source: LaserSource = ron::from_str(text).unwrap();
        assert!((source.absorbed_energy(0.0, 1.0) - 0.35 * 90.0).abs() < 1e-12);
        let again: LaserSource = ron::from_str(&ron::to_string(&source).unwrap()).unwrap();
        assert_eq!(again, source);
        let message =
            ron::from_str::<LaserSource>(&text.replace("0.6e-3", "-0.6e-3")).unwrap_err().to_string();
        assert!(message.contains("radius_1e_m is -0.0004"), "{message}");
        assert!(ron::from_str::<LaserSource>(&text.replace("beam:", "beams:")).is_err());
    }
}
