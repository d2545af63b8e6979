//! Four numbers side by side, as wide as one vector register of common machines.

use nalgebra::{SMatrix, SVector};
use std::ops::{Add, AddAssign, Mul, Sub, SubAssign};

/// A vector of up to three components, padded to four; the fourth may carry a scalar of the particle.
///
/// In 2-D the third component is zero, so that sums of products need no case for it.
#[derive(Clone, Copy, Debug, Default)]
#[repr(align(32))]
pub(crate) struct Lanes(pub [f64; 4]);

impl Lanes {
    #[inline]
    pub fn new<const D: usize>(vector: &SVector<f64, D>, scalar: f64) -> Self {
        let mut lanes = [0.0; 4];
        lanes[..D].copy_from_slice(vector.as_slice());
        lanes[3] = scalar;
        Self(lanes)
    }

    #[inline]
    pub fn vector<const D: usize>(&self) -> SVector<f64, D> {
        SVector::from_fn(|axis, _| self.0[axis])
    }

    /// The scalar beside the vector.
    #[inline]
    pub fn scalar(&self) -> f64 {
        self.0[3]
    }

    /// self * factor + addend, fused where the machine can.
    #[inline]
    pub fn times_plus(self, factor: f64, addend: Self) -> Self {
        Self(std::array::from_fn(|k| {
            if cfg!(target_feature = "fma") {
                self.0[k].mul_add(factor, addend.0[k])
            } else {
                self.0[k] * factor + addend.0[k]
            }
        }))
    }
}

/// The columns of a matrix.
pub(crate) type Columns<const D: usize> = [Lanes; D];

/// The columns of `matrix`, without scalars.
#[inline]
pub(crate) fn columns<const D: usize>(matrix: &SMatrix<f64, D, D>) -> Columns<D> {
    std::array::from_fn(|k| Lanes::new(&matrix.column(k).into_owned(), 0.0))
}

/// The matrix of these columns.
#[inline]
pub(crate) fn matrix<const D: usize>(columns: &Columns<D>) -> SMatrix<f64, D, D> {
    SMatrix::from_fn(|row, column| columns[column].0[row])
}

impl Add for Lanes {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] + other.0[k]))
    }
}

impl Sub for Lanes {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] - other.0[k]))
    }
}

impl Mul<f64> for Lanes {
    type Output = Self;

    #[inline]
    fn mul(self, factor: f64) -> Self {
        Self(self.0.map(|lane| lane * factor))
    }
}

impl AddAssign for Lanes {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Lanes {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Matrix2, Vector3};

    #[test]
    fn vectors_and_matrices_come_back() {
        let lanes = Lanes::new(&Vector3::new(1.0, 2.0, 3.0), 7.0);
        assert_eq!((lanes.vector::<3>(), lanes.scalar()), (Vector3::new(1.0, 2.0, 3.0), 7.0));
        let square = Matrix2::new(1.0, 2.0, 3.0, 4.0);
        assert_eq!(matrix(&columns(&square)), square);
    }

    #[test]
    fn arithmetic_by_lane() {
        let (a, b) = (Lanes([1.0, 2.0, 3.0, 4.0]), Lanes([5.0, 6.0, 7.0, 8.0]));
        assert_eq!(a.times_plus(2.0, b).0, [7.0, 10.0, 13.0, 16.0]);
        assert_eq!((b - a).0, [4.0; 4]);
    }
}
