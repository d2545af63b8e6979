//! Conduction across the joint of two materials.
//!
//! Within one material the Kirchhoff potential makes a mean of k needless. Across a joint the potentials of the two
//! sides have nothing to do with each other, and the pair exchanges by temperature with the harmonic mean of Cleary and
//! Monaghan (1999, eq. 26), which keeps the flux continuous.

/// A pair across a joint; counted once.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointPair {
    /// One end.
    pub first: u32,
    /// The other end.
    pub second: u32,
    /// Pair weight g \[m\] (2-D: a number).
    pub weight: f64,
}

/// k = 2 k_i k_j/(k_i + k_j) \[W/(m K)\] (Cleary and Monaghan 1999).
#[inline]
pub fn joint_conductance(first: f64, second: f64) -> f64 {
    2.0 * first * second / (first + second)
}

impl JointPair {
    /// Heat \[W\] that flows from the second end to the first at the ends' (temperature \[K\], conductivity \[W/(m K)\]).
    #[inline]
    pub fn heat(&self, first: (f64, f64), second: (f64, f64)) -> f64 {
        self.weight * joint_conductance(first.1, second.1) * (second.0 - first.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_poor_conductor_rules() {
        assert_eq!(joint_conductance(10.0, 10.0), 10.0);
        assert!((joint_conductance(1.0, 1000.0) - 2.0 / 1.001).abs() < 1e-12);
        let pair = JointPair { first: 0, second: 1, weight: 0.5 };
        assert_eq!(pair.heat((300.0, 10.0), (310.0, 10.0)), 50.0);
        assert_eq!(pair.heat((310.0, 10.0), (300.0, 10.0)), -50.0);
    }
}
