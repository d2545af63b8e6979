//! Faces that meet: a repulsion of particles that are no neighbours in the reference.

use nalgebra::SVector;

/// Two particles that have come nearer than a spacing push each other apart, as the cell of material between them would.
///
/// A row of cells under the strain e pulls with M e times the face of a cell, M the modulus of pressure waves: a linear
/// spring M dx^(D-2) along the line of centres, unstressed at one spacing. It has an energy, so contact takes none and gives
/// none, and acts along the line of centres, so both momenta stay. There is no friction but that of rows that interlock.
/// (Penalty springs as in Campbell, Vignjevic and Libersky 2000, with the stiffness taken from the material.)
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// Modulus M = K + 4 mu/3 \[Pa\].
    pub modulus_pa: f64,
    /// Edge of a cell dx \[m\], the distance of particles on two faces that touch.
    pub spacing: f64,
}

impl Contact {
    /// Force on a particle \[N; N/m in plane strain\] whose position less that of the other is `separation` \[m\]; zero where
    /// they are a spacing apart or more, and where they stand in the same place.
    #[inline]
    #[must_use]
    pub fn force<const D: usize>(&self, separation: &SVector<f64, D>) -> SVector<f64, D> {
        let distance = separation.norm();
        if distance >= self.spacing || distance == 0.0 {
            return SVector::zeros();
        }
        separation * (self.stiffness::<D>() * (self.spacing - distance) / distance)
    }

    /// Energy of the pair \[J; J/m in plane strain\] at a `distance` \[m\].
    #[inline]
    #[must_use]
    pub fn energy<const D: usize>(&self, distance: f64) -> f64 {
        let overlap = (self.spacing - distance).max(0.0);
        0.5 * self.stiffness::<D>() * overlap * overlap
    }

    /// \[N/m; N/m^2 in plane strain\]
    fn stiffness<const D: usize>(&self) -> f64 {
        self.modulus_pa * self.spacing.powi(D as i32 - 2)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Vector2, Vector3};

    const LAW: Contact = Contact { modulus_pa: 2e6, spacing: 0.01 };

    #[test]
    fn pushes_apart_with_the_derivative_of_its_energy() {
        let (here, small) = (Vector3::new(3e-3, -4e-3, 2e-3), 1e-8);
        for axis in 0..3 {
            let mut step = Vector3::zeros();
            step[axis] = small;
            let change = LAW.energy::<3>((here + step).norm()) - LAW.energy::<3>((here - step).norm());
            let force = LAW.force(&here);
            assert!((force[axis] + change / (2.0 * small)).abs() < 1e-6 * force.norm(), "{force:?}");
        }
        assert!(LAW.force(&here).dot(&here) > 0.0);
    }

    #[test]
    fn is_as_stiff_as_a_row_of_cells() {
        // Strain 0.1: M e over the face of a cell, 1e-4 m2 in space, 1e-2 m in the plane.
        assert!((LAW.force(&Vector3::new(9e-3, 0.0, 0.0)).x / (2e5 * 1e-4) - 1.0).abs() < 1e-12);
        assert!((LAW.force(&Vector2::new(-9e-3, 0.0)).x / (-2e5 * 1e-2) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn faces_that_touch_feel_nothing() {
        assert_eq!(LAW.force(&Vector2::new(0.01, 0.0)), Vector2::zeros());
        assert_eq!(LAW.force(&Vector2::<f64>::zeros()), Vector2::zeros());
        assert_eq!(LAW.energy::<2>(0.02), 0.0);
    }
}
