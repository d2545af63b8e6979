//! How fast a fluid of particles tears where it is pulled.

/// Wave number of the shortest wave that particles show, times the smoothing length \[-\]: pi over the spacing at h =
/// 1.3 spacings.
const SHORTEST_WAVE: f64 = 4.0;

/// Speed \[m/s\] at which particles under a negative pressure draw apart, zero under a positive one.
///
/// The surface of a melt that is hollow pulls at it from all sides. Liquid bears that, particles do not: between them
/// voids open, by the tensile instability (Swegle, Hicks and Attaway 1995). For its fastest growth, sigma^2 + nu k^2
/// sigma + (p/rho) k^2 = 0, this is sigma/k at the shortest wave k. Shifting must keep up with it: where the fluid
/// rests, its own speed is no measure.
///
/// `pressure` p \[Pa\], `density` rho \[kg/m^3\], `kinematic_viscosity` nu \[m^2/s\] with that of the scheme,
/// `smoothing_length` \[m\].
#[inline]
#[must_use]
pub fn tearing_speed(pressure: f64, density: f64, kinematic_viscosity: f64, smoothing_length: f64) -> f64 {
    let pull = (-pressure).max(0.0) / density;
    let damping = 0.5 * kinematic_viscosity * SHORTEST_WAVE / smoothing_length;
    let sum = damping + (damping * damping + pull).sqrt();
    if pull > 0.0 { pull / sum } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_thin_fluid_tears_with_its_inertia_and_a_thick_one_against_its_friction() {
        assert_eq!(tearing_speed(-8.0, 2.0, 0.0, 0.1), 2.0);
        // (|p|/rho)/(nu k), k = 40.
        let thick = tearing_speed(-8.0, 2.0, 100.0, 0.1);
        assert!((thick / (4.0 / 4000.0) - 1.0).abs() < 1e-6, "{thick}");
        assert_eq!(tearing_speed(8.0, 2.0, 0.0, 0.1), 0.0);
    }

    #[test]
    fn it_is_the_growth_of_the_shortest_wave() {
        let (pull, viscosity, wave): (f64, f64, f64) = (3.0, 0.7, 40.0);
        let sigma = wave * tearing_speed(-pull, 1.0, viscosity, 0.1);
        let rest = sigma * sigma + viscosity * wave * wave * sigma - pull * wave * wave;
        assert!(rest.abs() < 1e-9 * pull * wave * wave, "{rest}");
    }
}
