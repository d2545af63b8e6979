//! Smoothing kernels W(r, h): the shapes, one file each, and what is common to all of them.
//!
//! A kernel in D dimensions is W(r, h) = s_D w(r/h) / h^D, with a dimensionless shape w that vanishes beyond
//! its support and a factor s_D that makes the integral of W over space one. Shapes implement [`Shape`];
//! [`Kernel`] follows from it for D = 2 and 3.

mod cubic_spline;
mod gaussian;
mod kind;
mod quintic_spline;
mod scaled;
mod wendland_c2;

pub use cubic_spline::CubicSpline;
pub use gaussian::Gaussian;
pub use kind::{KernelKind, UnknownKernel};
pub use quintic_spline::QuinticSpline;
pub use scaled::ScaledKernel;
pub use wendland_c2::WendlandC2;

/// A radial shape w(q), q = r/h, before normalisation.
pub trait Shape: Copy + Send + Sync {
    /// Support radius in units of h \[-\]: w(q) = 0 for q at and beyond it.
    fn support(self) -> f64;

    /// Factor s_D \[-\] that makes the integral of s_D w over D-dimensional space one.
    ///
    /// Only `dimension` 2 and 3 have a meaning; [`Kernel`] refuses others at compile time.
    fn normalisation(self, dimension: usize) -> f64;

    /// w(q) and w'(q)/q \[-\] for q >= 0. Both are zero at and beyond the support, and w'(q)/q has its finite
    /// limit at q = 0.
    fn evaluate(self, q: f64) -> (f64, f64);
}

/// A smoothing kernel W(r, h) in `D` = 2 or 3 dimensions; distances and smoothing lengths in metres.
///
/// Every [`Shape`] is a kernel; other dimensions than 2 and 3 do not compile.
pub trait Kernel<const D: usize>: Copy + Send + Sync {
    /// Radius \[m\] at and beyond which W is zero.
    fn support_radius(self, smoothing_length: f64) -> f64;

    /// W \[m^-D\] and f = W'(r)/r \[m^-(D+2)\] together, at the cost of one.
    fn value_and_gradient_factor(self, distance: f64, smoothing_length: f64) -> (f64, f64);

    /// W(r, h) \[m^-D\].
    #[inline]
    fn value(self, distance: f64, smoothing_length: f64) -> f64 {
        self.value_and_gradient_factor(distance, smoothing_length).0
    }

    /// f = W'(r)/r \[m^-(D+2)\], so that grad_i W = f (r_i - r_j). Never positive; finite at r = 0.
    #[inline]
    fn gradient_factor(self, distance: f64, smoothing_length: f64) -> f64 {
        self.value_and_gradient_factor(distance, smoothing_length).1
    }
}

impl<S: Shape, const D: usize> Kernel<D> for S {
    #[inline]
    fn support_radius(self, smoothing_length: f64) -> f64 {
        self.support() * smoothing_length
    }

    #[inline]
    fn value_and_gradient_factor(self, distance: f64, smoothing_length: f64) -> (f64, f64) {
        const { assert!(D == 2 || D == 3, "kernels are normalised in 2 and 3 dimensions") };
        let inverse_length = 1.0 / smoothing_length;
        let scale = self.normalisation(D) * inverse_length.powi(D as i32);
        let (value, slope_over_q) = self.evaluate(distance * inverse_length);
        (scale * value, scale * inverse_length * inverse_length * slope_over_q)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const PI: f64 = std::f64::consts::PI;

    /// Integral of W over the ball of the support, by Simpson's rule on each unit of q (the shapes are smooth
    /// between whole numbers).
    fn integral<const D: usize>(kernel: KernelKind, smoothing_length: f64) -> f64 {
        let support = Kernel::<D>::support_radius(kernel, smoothing_length);
        let measure = |r: f64| if D == 2 { 2.0 * PI * r } else { 4.0 * PI * r * r };
        let integrand = |r: f64| measure(r) * Kernel::<D>::value(kernel, r, smoothing_length);
        let intervals = 2000 * kernel.support().round() as usize;
        // The last node sits just inside the support: the Gaussian jumps there.
        let step = support * (1.0 - 1e-12) / intervals as f64;
        let weight = |k: usize| match k {
            0 => 1.0,
            k if k == intervals => 1.0,
            k if k % 2 == 1 => 4.0,
            _ => 2.0,
        };
        (0..=intervals).map(|k| weight(k) * integrand(k as f64 * step)).sum::<f64>() * step / 3.0
    }

    #[test]
    fn integral_over_the_support_is_one() {
        for kernel in KernelKind::ALL {
            for smoothing_length in [1.0, 3.7e-5] {
                assert!((integral::<2>(kernel, smoothing_length) - 1.0).abs() < 1e-9, "{kernel} 2-D");
                assert!((integral::<3>(kernel, smoothing_length) - 1.0).abs() < 1e-9, "{kernel} 3-D");
            }
        }
    }

    #[test]
    fn value_and_factor_vanish_at_and_beyond_the_edge() {
        for kernel in KernelKind::ALL {
            for q in [kernel.support(), kernel.support() * 1.001, 1e6] {
                assert_eq!(kernel.evaluate(q), (0.0, 0.0), "{kernel} at q = {q}");
            }
        }
    }

    #[test]
    fn compact_splines_reach_the_edge_without_a_jump() {
        for kernel in [KernelKind::WendlandC2, KernelKind::CubicSpline, KernelKind::QuinticSpline] {
            let (value, factor) = kernel.evaluate(kernel.support() - 1e-6);
            assert!((0.0..1e-17).contains(&value), "{kernel}: {value}");
            assert!((-1e-11..=0.0).contains(&factor), "{kernel}: {factor}");
        }
    }

    fn any_kernel() -> impl Strategy<Value = KernelKind> {
        prop::sample::select(KernelKind::ALL.to_vec())
    }

    proptest! {
        #[test]
        fn value_is_positive_and_factor_negative_inside(kernel in any_kernel(), fraction in 0.0..0.999) {
            let (value, factor) = kernel.evaluate(fraction * kernel.support());
            prop_assert!(value > 0.0 && factor < 0.0);
        }

        #[test]
        fn factor_is_the_slope_over_the_distance(kernel in any_kernel(), fraction in 0.01..0.99, h in 1e-5..10.0) {
            let distance = fraction * Kernel::<3>::support_radius(kernel, h);
            let step = 1e-6 * h;
            let value = |r: f64| Kernel::<3>::value(kernel, r, h);
            let slope = (value(distance + step) - value(distance - step)) / (2.0 * step);
            let factor = Kernel::<3>::gradient_factor(kernel, distance, h);
            let scale = -Kernel::<3>::gradient_factor(kernel, 0.0, h) * h;
            prop_assert!((factor * distance - slope).abs() < 1e-9 * scale, "{} against {}", factor * distance, slope);
        }

        #[test]
        fn factor_is_continuous_at_the_centre(kernel in any_kernel(), h in 1e-5..10.0) {
            let centre = Kernel::<2>::gradient_factor(kernel, 0.0, h);
            let beside = Kernel::<2>::gradient_factor(kernel, 1e-9 * h, h);
            prop_assert!(centre < 0.0 && (beside / centre - 1.0).abs() < 1e-8);
        }

        #[test]
        fn scaling_with_the_smoothing_length(kernel in any_kernel(), q in 0.0..3.0, h in 1e-5..10.0) {
            let (unit_value, unit_factor) = Kernel::<2>::value_and_gradient_factor(kernel, q, 1.0);
            let (value, factor) = Kernel::<2>::value_and_gradient_factor(kernel, q * h, h);
            prop_assert!((value * h * h - unit_value).abs() < 1e-12);
            prop_assert!((factor * h.powi(4) - unit_factor).abs() < 1e-12);
            let (unit_value, unit_factor) = Kernel::<3>::value_and_gradient_factor(kernel, q, 1.0);
            let (value, factor) = Kernel::<3>::value_and_gradient_factor(kernel, q * h, h);
            prop_assert!((value * h.powi(3) - unit_value).abs() < 1e-12);
            prop_assert!((factor * h.powi(5) - unit_factor).abs() < 1e-12);
        }
    }
}
