//! What lets the rows of a surface exchange their particles: shifting with a normal part, and a density that follows the
//! particles.
//!
//! Continuity alone does not know where the particles are, the pair force does: rows crowd at the rim of a closed
//! thermocapillary flow, build no pressure and stall (trial of this project: 5 % of the exact speed). These two cure it.

use nalgebra::SVector;

/// Strength of both parts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Renewal {
    /// Shifting S \[-\]; 3.
    pub shifting: f64,
    /// Rate k of the density's pull towards the particles \[-\], in units of c0/h; 0.005.
    pub density_pull: f64,
}

impl Default for Renewal {
    /// The constants of the trials, the same in 2-D and 3-D.
    fn default() -> Self {
        Self { shifting: 3.0, density_pull: 0.005 }
    }
}

/// Largest shift over S u dt \[-\].
const LARGEST_SHARE: f64 = 0.25;
/// Agreement of the normals up to which a shift runs along the surface only \[-\]: about that on a circle of 1.2 smoothing lengths.
const BENT: f64 = 0.9;
/// Lowest colour that the pull divides by \[-\]: a particle in the air is not pulled to the density of a body.
const LOWEST_COLOUR: f64 = 0.4;

impl Renewal {
    /// -S h u (sum V grad W + N w1(s)) \[m/s\], at most 0.25 S u: what is added to the speed of the drift.
    ///
    /// `speed` u \[m/s\] is what disorders the particles: that of the fastest one, or [`tearing_speed`](crate::tearing_speed).
    /// `concentration_gradient` \[1/m\] of all condensed particles with the volumes m/rho_0; `flat_gradient` N w1(s) \[1/m\] is
    /// what a flat surface would show at the particle's depth (zero inside), so that an even surface is left alone. After Lind,
    /// Xu, Stansby and Rogers (2012), with a normal part.
    #[inline]
    #[must_use]
    pub fn shift_velocity<const D: usize>(
        &self,
        concentration_gradient: &SVector<f64, D>,
        flat_gradient: &SVector<f64, D>,
        smoothing_length: f64,
        speed: f64,
    ) -> SVector<f64, D> {
        let wanted = (concentration_gradient + flat_gradient) * (-smoothing_length);
        let length = wanted.norm();
        let share = if length > LARGEST_SHARE { LARGEST_SHARE / length } else { 1.0 };
        wanted * (share * self.shifting * speed)
    }

    /// (k c0/h)(sum m W / C(s) - rho) \[kg/(m^3 s)\], the pull of a density towards that of the particles.
    ///
    /// `summed_density` is sum m W with the particle itself, `flat_colour` C(s) that of a flat surface at its depth.
    #[inline]
    #[must_use]
    pub fn density_rate(
        &self,
        summed_density: f64,
        flat_colour: f64,
        density: f64,
        sound_speed: f64,
        smoothing_length: f64,
    ) -> f64 {
        let target = summed_density / flat_colour.max(LOWEST_COLOUR);
        self.density_pull * sound_speed / smoothing_length * (target - density)
    }
}

/// A shift velocity \[m/s\] near a surface, without the part across it where the surface is not flat.
///
/// `agreement` of the normals near the particle is one under a plane ([`SurfaceBand::agreements`](crate::SurfaceBand::agreements)). What a
/// flat surface would show is all that [`Renewal::shift_velocity`] subtracts: at a corner, or between the two faces of a thin sheet, the
/// rest drives particles inwards, and continuity does not see it. Corners then retract as if by surface tension, and arms pinch off into
/// drops of twice the density (a square patch that turns, trial of this project). Sun, Colagrossi, Marrone and Zhang (2017) leave out the
/// part across at every free surface; the rows of a flat one need it.
#[inline]
#[must_use]
pub fn shift_beside_surface<const D: usize>(
    shift: &SVector<f64, D>,
    normal: &SVector<f64, D>,
    agreement: f64,
) -> SVector<f64, D> {
    let kept = ((agreement - BENT) / (1.0 - BENT)).max(0.0);
    shift - normal * (normal.dot(shift) * (1.0 - kept))
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector2;

    #[test]
    fn shifts_run_from_crowds_are_bounded_and_leave_a_flat_surface_alone() {
        let renewal = Renewal::default();
        let crowd = Vector2::new(0.02, 0.0);
        let shift = renewal.shift_velocity(&crowd, &Vector2::zeros(), 2.0, 5.0);
        assert!((shift - Vector2::new(-0.6, 0.0)).norm() < 1e-15);
        let large = renewal.shift_velocity(&(crowd * 100.0), &Vector2::zeros(), 2.0, 5.0);
        assert!((large.norm() - 0.25 * 3.0 * 5.0).abs() < 1e-12);
        assert_eq!(renewal.shift_velocity(&crowd, &-crowd, 2.0, 5.0), Vector2::zeros());
    }

    #[test]
    fn a_shift_crosses_a_flat_surface_and_runs_along_a_bent_one() {
        let (shift, normal) = (Vector2::new(0.3, -0.2), Vector2::new(0.0, 1.0));
        assert_eq!(shift_beside_surface(&shift, &normal, 1.0), shift);
        assert_eq!(shift_beside_surface(&shift, &normal, 0.5), Vector2::new(0.3, 0.0));
        let half = shift_beside_surface(&shift, &normal, 0.95);
        assert!((half - Vector2::new(0.3, -0.1)).norm() < 1e-15, "{half}");
    }

    #[test]
    fn density_is_pulled_towards_the_particles() {
        let renewal = Renewal::default();
        let rate = |summed, colour| renewal.density_rate(summed, colour, 1000.0, 20.0, 0.01);
        assert!((rate(750.0, 0.75)).abs() < 1e-9);
        assert!((rate(825.0, 0.75) - 0.005 * 20.0 / 0.01 * 100.0).abs() < 1e-9);
        assert!(rate(300.0, 0.1) < 0.0);
    }
}
