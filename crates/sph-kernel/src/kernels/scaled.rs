//! A kernel for one constant smoothing length.

use super::{CubicSpline, Gaussian, KernelKind, QuinticSpline, Shape, WendlandC2};

/// A kernel with its smoothing length fixed and its factors precomputed: no division and no power per pair.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScaledKernel<const D: usize> {
    kind: KernelKind,
    smoothing_length: f64,
    inverse_length: f64,
    value_scale: f64,
    factor_scale: f64,
}

impl<const D: usize> ScaledKernel<D> {
    /// Fixes the smoothing length \[m\] of a kernel.
    ///
    /// # Panics
    /// If the smoothing length is not finite and positive.
    pub fn new(kind: KernelKind, smoothing_length: f64) -> Self {
        const { assert!(D == 2 || D == 3, "kernels are normalised in 2 and 3 dimensions") };
        assert!(
            smoothing_length.is_finite() && smoothing_length > 0.0,
            "the smoothing length must be finite and positive, not {smoothing_length}"
        );
        let inverse_length = 1.0 / smoothing_length;
        let value_scale = kind.normalisation(D) * inverse_length.powi(D as i32);
        let factor_scale = value_scale * inverse_length * inverse_length;
        Self { kind, smoothing_length, inverse_length, value_scale, factor_scale }
    }

    /// The kernel's name.
    pub fn kind(&self) -> KernelKind {
        self.kind
    }

    /// The smoothing length h \[m\].
    #[inline]
    pub fn smoothing_length(&self) -> f64 {
        self.smoothing_length
    }

    /// Radius \[m\] at and beyond which W is zero.
    #[inline]
    pub fn support_radius(&self) -> f64 {
        self.kind.support() * self.smoothing_length
    }

    /// W(r) \[m^-D\].
    #[inline]
    pub fn value(&self, distance: f64) -> f64 {
        self.value_scale * self.kind.evaluate(distance * self.inverse_length).0
    }

    /// f = W'(r)/r \[m^-(D+2)\]; never positive, finite at r = 0.
    #[inline]
    pub fn gradient_factor(&self, distance: f64) -> f64 {
        self.factor_scale * self.kind.evaluate(distance * self.inverse_length).1
    }

    /// W and f of many distances \[m\] at once: the kernel is chosen once for the slice, not once a pair.
    ///
    /// # Panics
    /// If the three slices differ in length.
    #[inline]
    pub fn evaluate_slice(&self, distances: &[f64], values: &mut [f64], gradient_factors: &mut [f64]) {
        match self.kind {
            KernelKind::WendlandC2 => self.sweep(WendlandC2, distances, values, gradient_factors),
            KernelKind::Gaussian => self.sweep(Gaussian, distances, values, gradient_factors),
            KernelKind::CubicSpline => self.sweep(CubicSpline, distances, values, gradient_factors),
            KernelKind::QuinticSpline => self.sweep(QuinticSpline, distances, values, gradient_factors),
        }
    }

    #[inline]
    fn sweep(&self, shape: impl Shape, distances: &[f64], values: &mut [f64], gradient_factors: &mut [f64]) {
        assert!(distances.len() == values.len() && distances.len() == gradient_factors.len());
        for ((&distance, value), factor) in distances.iter().zip(values).zip(gradient_factors) {
            let (shape_value, slope_over_q) = shape.evaluate(distance * self.inverse_length);
            *value = self.value_scale * shape_value;
            *factor = self.factor_scale * slope_over_q;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Kernel;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn agrees_with_the_kernel(kernel in prop::sample::select(KernelKind::ALL.to_vec()), q in 0.0..3.1, h in 1e-5..10.0) {
            let distance = q * h;
            let scaled = kernel.with_smoothing_length::<3>(h);
            let (value, factor) = Kernel::<3>::value_and_gradient_factor(kernel, distance, h);
            prop_assert_eq!(scaled.value(distance), value);
            prop_assert_eq!(scaled.gradient_factor(distance), factor);
            prop_assert_eq!(scaled.support_radius(), Kernel::<3>::support_radius(kernel, h));
        }

        #[test]
        fn a_slice_agrees_with_single_calls(kernel in prop::sample::select(KernelKind::ALL.to_vec()), count in 0_usize..40) {
            let scaled = kernel.with_smoothing_length::<2>(0.3);
            let distances: Vec<f64> = (0..count).map(|k| 0.025 * k as f64).collect();
            let (mut values, mut factors) = (vec![f64::NAN; count], vec![f64::NAN; count]);
            scaled.evaluate_slice(&distances, &mut values, &mut factors);
            for k in 0..count {
                prop_assert!((values[k] - scaled.value(distances[k])).abs() <= 1e-15 * scaled.value(0.0));
                prop_assert!((factors[k] - scaled.gradient_factor(distances[k])).abs() <= -1e-15 * scaled.gradient_factor(0.0));
            }
        }
    }

    #[test]
    #[should_panic(expected = "must be finite and positive, not 0")]
    fn refuses_a_smoothing_length_of_zero() {
        KernelKind::WendlandC2.with_smoothing_length::<2>(0.0);
    }
}
