//! A symmetric tensor in 3-D, or in plane strain with its out-of-plane component.

use nalgebra::{Matrix3, SMatrix};
use std::ops::{Add, AddAssign, Mul, Sub};

/// A symmetric stress or strain \[Pa or -\].
///
/// In 3-D (`D` = 3) `in_plane` is the whole tensor and `out_of_plane` is zero. In plane strain (`D` = 2) the zz
/// component stands beside the plane ones; it enters traces and norms, not forces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SymmetricTensor<const D: usize> {
    /// Components among the D axes of the computation.
    pub in_plane: SMatrix<f64, D, D>,
    /// The zz component of plane strain; zero in 3-D.
    pub out_of_plane: f64,
}

impl<const D: usize> SymmetricTensor<D> {
    /// The tensor without any component.
    #[inline]
    #[must_use]
    pub fn zero() -> Self {
        Self { in_plane: SMatrix::zeros(), out_of_plane: 0.0 }
    }

    /// `value` times the identity of three-dimensional space.
    #[inline]
    #[must_use]
    pub fn isotropic(value: f64) -> Self {
        let out_of_plane = if D == 2 { value } else { 0.0 };
        Self { in_plane: SMatrix::identity() * value, out_of_plane }
    }

    /// Sum of the three normal components.
    #[inline]
    #[must_use]
    pub fn trace(&self) -> f64 {
        self.in_plane.trace() + self.out_of_plane
    }

    /// The tensor less its mean: trace zero.
    #[inline]
    #[must_use]
    pub fn deviator(&self) -> Self {
        *self - Self::isotropic(self.trace() / 3.0)
    }

    /// A : A, the sum of the squares of all components.
    #[inline]
    #[must_use]
    pub fn norm_squared(&self) -> f64 {
        self.product(self)
    }

    /// A : B, the sum of the products of all components.
    #[inline]
    #[must_use]
    pub fn product(&self, other: &Self) -> f64 {
        self.in_plane.dot(&other.in_plane) + self.out_of_plane * other.out_of_plane
    }

    /// Von Mises stress sqrt(3/2 S : S) of a stress, S its deviator \[Pa\] (von Mises 1913).
    #[inline]
    #[must_use]
    pub fn von_mises(&self) -> f64 {
        (1.5 * self.deviator().norm_squared()).sqrt()
    }

    /// Principal values, the largest first: eigenvalues of the whole tensor, so that that of plane strain's third axis is
    /// among them. Of a tensor that is not finite they are no numbers either.
    #[must_use]
    pub fn principal(&self) -> [f64; 3] {
        let mut whole = Matrix3::zeros();
        whole.view_mut((0, 0), (D, D)).copy_from(&self.in_plane);
        if D < 3 {
            whole[(2, 2)] = self.out_of_plane;
        }
        if !whole.iter().all(|component| component.is_finite()) {
            return [f64::NAN; 3];
        }
        let mut values: [f64; 3] = whole.symmetric_eigenvalues().into();
        values.sort_by(|a, b| b.total_cmp(a));
        values
    }
}

impl<const D: usize> Add for SymmetricTensor<D> {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self {
            in_plane: self.in_plane + other.in_plane,
            out_of_plane: self.out_of_plane + other.out_of_plane,
        }
    }
}

impl<const D: usize> AddAssign for SymmetricTensor<D> {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<const D: usize> Sub for SymmetricTensor<D> {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        self + other * -1.0
    }
}

impl<const D: usize> Mul<f64> for SymmetricTensor<D> {
    type Output = Self;

    #[inline]
    fn mul(self, factor: f64) -> Self {
        Self { in_plane: self.in_plane * factor, out_of_plane: self.out_of_plane * factor }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Matrix2, Matrix3};

    #[test]
    fn plane_strain_agrees_with_the_same_tensor_in_three_dimensions() {
        let plane = SymmetricTensor { in_plane: Matrix2::new(5.0, 2.0, 2.0, -1.0), out_of_plane: 3.0 };
        let full = Matrix3::new(5.0, 2.0, 0.0, 2.0, -1.0, 0.0, 0.0, 0.0, 3.0);
        let full = SymmetricTensor { in_plane: full, out_of_plane: 0.0 };
        assert_eq!(plane.trace(), full.trace());
        assert_eq!(plane.norm_squared(), full.norm_squared());
        assert_eq!(plane.product(&plane), full.norm_squared());
        assert!((plane.von_mises() / full.von_mises() - 1.0).abs() < 1e-15);
        assert!(plane.deviator().trace().abs() < 1e-15 && full.deviator().trace().abs() < 1e-15);
    }

    #[test]
    fn principal_values_of_simple_states() {
        let near = |found: [f64; 3], exact: [f64; 3]| {
            assert!(found.iter().zip(exact).all(|(found, exact)| (found - exact).abs() < 1e-14), "{found:?}");
        };
        let shear = Matrix2::new(1.0, 2.0, 2.0, 1.0);
        near(SymmetricTensor { in_plane: shear, out_of_plane: 0.5 }.principal(), [3.0, 0.5, -1.0]);
        near(SymmetricTensor { in_plane: shear, out_of_plane: -7.0 }.principal(), [3.0, -1.0, -7.0]);
        // A bar along (1, 1, 1) that is pulled by 6.
        let pulled = Matrix3::repeat(2.0);
        near(SymmetricTensor { in_plane: pulled, out_of_plane: 0.0 }.principal(), [6.0, 0.0, 0.0]);
        let lost = SymmetricTensor { in_plane: shear * f64::NAN, out_of_plane: 0.5 }.principal();
        assert!(lost.iter().all(|value| value.is_nan()));
    }

    #[test]
    fn von_mises_of_simple_states() {
        assert_eq!(SymmetricTensor::<2>::isotropic(-7.0).von_mises(), 0.0);
        assert_eq!(SymmetricTensor::<3>::isotropic(-7.0).von_mises(), 0.0);
        let tension = SymmetricTensor { in_plane: Matrix2::new(4.0, 0.0, 0.0, 0.0), out_of_plane: 0.0 };
        assert!((tension.von_mises() - 4.0).abs() < 1e-14);
        let shear = SymmetricTensor { in_plane: Matrix2::new(0.0, 2.0, 2.0, 0.0), out_of_plane: 0.0 };
        assert!((shear.von_mises() - 2.0 * 3.0_f64.sqrt()).abs() < 1e-14);
    }
}
