//! Two half spaces of unlike temperature in contact (Carslaw and Jaeger, Conduction of Heat in Solids, 2.15).

use libm::{erf, erfc};

/// Two half spaces, brought into contact at x = 0 at time zero; side 0 is x < 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HalfSpaces {
    /// Temperature of each side at the start.
    pub start: [f64; 2],
    /// Conductivity of each side.
    pub conductivity: [f64; 2],
    /// Density times heat capacity of each side.
    pub capacity: [f64; 2],
}

impl HalfSpaces {
    /// Temperature of the joint: T_i = (b_1 T_1 + b_2 T_2)/(b_1 + b_2), b = sqrt(k rho c); the same at all times.
    pub fn joint_temperature(&self) -> f64 {
        let effusivity = |side: usize| (self.conductivity[side] * self.capacity[side]).sqrt();
        let (first, second) = (effusivity(0), effusivity(1));
        (first * self.start[0] + second * self.start[1]) / (first + second)
    }

    /// Temperature at a place and a time above zero.
    pub fn temperature(&self, x: f64, time: f64) -> f64 {
        let side = usize::from(x > 0.0);
        let diffusivity = self.conductivity[side] / self.capacity[side];
        let depth = x.abs() / (4.0 * diffusivity * time).sqrt();
        self.start[side] * erf(depth) + self.joint_temperature() * erfc(depth)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn printed_values() {
        let ten = HalfSpaces { start: [1.0, 0.0], conductivity: [1.0, 10.0], capacity: [1.0; 2] };
        assert!((ten.joint_temperature() - 0.24025307).abs() < 5e-9);
        let printed = [
            (-1.0, 0.998811),
            (-0.5, 0.913506),
            (-0.1, 0.428800),
            (0.1, 0.221116),
            (0.5, 0.148254),
            (1.0, 0.076235),
        ];
        for (x, value) in printed {
            assert!((ten.temperature(x, 0.05) - value).abs() < 6e-7, "{x}: {}", ten.temperature(x, 0.05));
        }
        let thousand = HalfSpaces { conductivity: [1.0, 1000.0], ..ten };
        assert!((thousand.joint_temperature() - 0.03065343).abs() < 5e-9);
    }

    #[test]
    fn the_flux_is_continuous() {
        let half_spaces = HalfSpaces { start: [500.0, 300.0], conductivity: [20.0, 200.0], capacity: [3e6, 2e6] };
        let (step, time) = (1e-7, 1e-3);
        let joint = half_spaces.joint_temperature();
        let left = 20.0 * (joint - half_spaces.temperature(-step, time)) / step;
        let right = 200.0 * (half_spaces.temperature(step, time) - joint) / step;
        assert!((left / right - 1.0).abs() < 1e-3, "{left} {right}");
    }
}
