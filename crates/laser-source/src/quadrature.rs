//! Integration of a moving beam over a time step by Gauss-Legendre rules.

use crate::path::{Piece, Track};

/// What one quadrature point stands for: the beam's centre there, and the commanded energy of its share of
/// the step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct QuadraturePoint {
    pub(crate) x_m: f64,
    pub(crate) y_m: f64,
    pub(crate) energy_j: f64,
}

/// A Gauss-Legendre rule on 0..1: the pairs (position, weight), and the longest travel of the beam for which
/// it serves, in lengths over which the profile changes.
struct Rule {
    longest_travel: f64,
    nodes: &'static [(f64, f64)],
}

/// The rules in order of travel (Abramowitz and Stegun 1964, table 25.4).
///
/// The remainder of the n-point rule over a travel L is L^2n (n!)^4 / ((2n + 1) (2n)!^3) times the 2n-th
/// derivative of the integrand (25.4.30), at most (2n)!/n! for exp(-x^2). The longest travels keep it below
/// 6e-7 of the peak.
const RULES: [Rule; 5] = [
    Rule { longest_travel: 0.0, nodes: &[(0.5, 1.0)] },
    Rule { longest_travel: 0.12, nodes: &[(0.211_324_865_405_187_1, 0.5), (0.788_675_134_594_812_9, 0.5)] },
    Rule {
        longest_travel: 0.45,
        nodes: &[
            (0.112_701_665_379_258_31, 0.277_777_777_777_777_8),
            (0.5, 0.444_444_444_444_444_4),
            (0.887_298_334_620_741_7, 0.277_777_777_777_777_8),
        ],
    },
    Rule {
        longest_travel: 0.9,
        nodes: &[
            (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
            (0.330_009_478_207_571_87, 0.326_072_577_431_273_07),
            (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
            (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
        ],
    },
    Rule {
        longest_travel: 2.0,
        nodes: &[
            (0.033_765_242_898_423_99, 0.085_662_246_189_585_18),
            (0.169_395_306_766_867_74, 0.180_380_786_524_069_3),
            (0.380_690_406_958_401_55, 0.233_956_967_286_345_52),
            (0.619_309_593_041_598_5, 0.233_956_967_286_345_52),
            (0.830_604_693_233_132_3, 0.180_380_786_524_069_3),
            (0.966_234_757_101_576, 0.085_662_246_189_585_18),
        ],
    },
];

/// Calls `visit` for each quadrature point of the lit parts of the track between `t0_s` and `t1_s`.
///
/// `smooth_length_m` is the length over which the profile changes: it decides how many points a travel needs.
/// Energies of the points add up to [`Track::energy`] to round-off.
pub(crate) fn for_each_point(
    track: &Track,
    smooth_length_m: f64,
    t0_s: f64,
    t1_s: f64,
    mut visit: impl FnMut(QuadraturePoint),
) {
    let longest = &RULES[RULES.len() - 1];
    for piece in track.pieces(t0_s, t1_s) {
        let travel = piece.travel_m() / smooth_length_m;
        let parts = (travel / longest.longest_travel).ceil().max(1.0);
        let rule = RULES.iter().find(|rule| travel / parts <= rule.longest_travel).unwrap_or(longest);
        visit_parts(&piece, rule, parts, &mut visit);
    }
}

/// Applies `rule` to each of `parts` equal parts of a piece.
fn visit_parts(piece: &Piece, rule: &Rule, parts: f64, visit: &mut impl FnMut(QuadraturePoint)) {
    let duration_s = piece.duration_s() / parts;
    let mut part = 0.0;
    while part < parts {
        for &(position, weight) in rule.nodes {
            let point = piece.at((part + position) / parts);
            visit(QuadraturePoint {
                x_m: point.x_m,
                y_m: point.y_m,
                energy_j: weight * duration_s * point.power_w,
            });
        }
        part += 1.0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::TrackPoint;

    /// A ramp from 0 to 3 W over 2 s along x, from 0 to `length_m`.
    fn ramp(length_m: f64) -> Track {
        let point = |time_s, x_m, power_w| TrackPoint { time_s, x_m, y_m: 0.0, power_w };
        Track::new(vec![point(0.0, 0.0, 0.0), point(2.0, length_m, 3.0)]).unwrap()
    }

    #[test]
    fn rules_are_exact_for_polynomials_of_their_degree() {
        for rule in &RULES {
            for degree in 0..2 * rule.nodes.len() as i32 {
                let sum: f64 =
                    rule.nodes.iter().map(|(position, weight)| weight * position.powi(degree)).sum();
                assert!((sum * f64::from(degree + 1) - 1.0).abs() < 1e-15, "{} {degree}", rule.nodes.len());
            }
        }
    }

    #[test]
    fn energies_add_up_and_points_lie_on_the_way() {
        for length_m in [0.0, 0.1, 0.4, 0.8, 1.9, 17.3] {
            let (mut energy_j, mut moment) = (0.0, 0.0);
            for_each_point(&ramp(length_m), 1.0, 0.0, 2.0, |point| {
                energy_j += point.energy_j;
                moment += point.energy_j * point.x_m;
            });
            assert!((energy_j - 3.0).abs() < 1e-14);
            // Integral of P x = (3 t / 2) (L t / 2) over 0..2 is 2 L.
            assert!((moment - 2.0 * length_m).abs() < 1e-13 * (1.0 + length_m));
        }
    }

    #[test]
    fn a_longer_travel_takes_more_points() {
        let count = |length_m: f64| {
            let mut count = 0;
            for_each_point(&ramp(length_m), 1.0, 0.0, 2.0, |_| count += 1);
            count
        };
        assert_eq!([0.0, 0.08, 0.3, 0.5, 1.5, 2.0, 2.1, 10.0].map(count), [1, 2, 3, 4, 6, 6, 12, 30]);
    }

    #[test]
    fn error_of_a_gaussian_over_any_travel_is_below_1e_6_of_its_peak() {
        // Mean over the travel L of exp(-(x - c)^2): sqrt(pi)/2 (erf(L - c) + erf(c)) / L.
        let point = |time_s, x_m| TrackPoint { time_s, x_m, y_m: 0.0, power_w: 1.0 };
        let mut worst = 0.0_f64;
        for i in 1..200 {
            let travel = 0.02 * f64::from(i);
            let track = Track::new(vec![point(0.0, 0.0), point(1.0, travel)]).unwrap();
            for j in -20..60 {
                let centre = 0.1 * f64::from(j);
                let mut mean = 0.0;
                for_each_point(&track, 1.0, 0.0, 1.0, |at| {
                    mean += at.energy_j * (-(at.x_m - centre).powi(2)).exp()
                });
                let primitive = libm::erf(travel - centre) + libm::erf(centre);
                let exact = 0.5 * std::f64::consts::PI.sqrt() * primitive / travel;
                worst = worst.max((mean - exact).abs());
            }
        }
        assert!(worst < 1e-6 && worst > 1e-9, "{worst}");
    }
}
