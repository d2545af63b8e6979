//! Monaghan's artificial viscosity.

use nalgebra::SVector;

/// Coefficients of the artificial viscosity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArtificialViscosity {
    /// Linear coefficient alpha \[-\]; 0.2 to 0.5 in elastic bodies, 1 for impacts.
    pub alpha: f64,
    /// Quadratic coefficient beta \[-\]; 0, or 2 for impacts.
    pub beta: f64,
}

impl ArtificialViscosity {
    /// Pi = (-alpha c nu + beta nu^2)/rho with nu = h v.r/(r^2 + 0.01 h^2) for approaching particles, zero for receding ones
    /// \[Pa m^6/kg^2 = m^5/(kg s^2)\] (Monaghan 1992, eq. 4.1; Hu and Eberhard 2015, eq. 4).
    ///
    /// `separation` r_i - r_j \[m\], `relative_velocity` v_i - v_j \[m/s\], `smoothing_length` h \[m\], and the pair's
    /// mean `sound_speed` c \[m/s\] and `density` rho \[kg/m^3\]. The acceleration of i is -m_j Pi grad_i W.
    #[inline]
    #[must_use]
    pub fn pair<const D: usize>(
        &self,
        separation: &SVector<f64, D>,
        relative_velocity: &SVector<f64, D>,
        smoothing_length: f64,
        sound_speed: f64,
        density: f64,
    ) -> f64 {
        let closing = relative_velocity.dot(separation).min(0.0);
        let distance_squared = separation.norm_squared() + 0.01 * smoothing_length * smoothing_length;
        let rate = smoothing_length * closing / distance_squared;
        (-self.alpha * sound_speed * rate + self.beta * rate * rate) / density
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector2;

    const LAW: ArtificialViscosity = ArtificialViscosity { alpha: 1.0, beta: 2.0 };

    #[test]
    fn acts_on_approach_only() {
        let separation = Vector2::new(1e-3, 0.0);
        let pair = |speed: f64| LAW.pair(&separation, &Vector2::new(speed, 7.0), 1.2e-3, 100.0, 1000.0);
        assert_eq!((pair(0.0), pair(3.0)), (0.0, 0.0));
        let rate = 1.2e-3 * -3e-3 / (1e-6 + 0.01 * 1.44e-6);
        let expected = (100.0 * -rate + 2.0 * rate * rate) / 1000.0;
        assert!((pair(-3.0) / expected - 1.0).abs() < 1e-14 && expected > 0.0);
    }

    #[test]
    fn is_symmetric_in_the_two_particles() {
        let (separation, velocity) = (Vector2::new(1e-3, 2e-4), Vector2::new(-3.0, 1.0));
        let forth = LAW.pair(&separation, &velocity, 1e-3, 100.0, 1000.0);
        assert_eq!(forth, LAW.pair(&-separation, &-velocity, 1e-3, 100.0, 1000.0));
    }
}
