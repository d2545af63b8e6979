//! What a kernel sees of a body that ends at a plane: colour, weight and centroid by depth.

use sph_kernel::ScaledKernel;

/// Intervals of the table over the support.
const INTERVALS: usize = 512;
/// Intervals of the quadrature over a plane or over the rest of the support; even.
const QUADRATURE: usize = 256;

/// Tables over the depth s \[m\] below the plane, s > 0 inside.
///
/// w1(s), the kernel integrated over the plane at distance s \[1/m\]; C(s) = 1/2 + int_0^s w1, the colour; and
/// q(s) = int_|s|^R t w1(t) dt / C(s), the distance from a particle to the centroid of what its kernel sees \[m\].
#[derive(Clone, Debug)]
pub struct PlaneProfile {
    support: f64,
    /// w1 at equal steps from 0 to the support.
    weights: Vec<f64>,
    /// C at equal steps from 0 to the support.
    colours: Vec<f64>,
    /// int_s^R t w1(t) dt at equal steps from 0 to the support.
    moments: Vec<f64>,
}

impl PlaneProfile {
    /// The tables of a kernel.
    #[must_use]
    pub fn new<const D: usize>(kernel: &ScaledKernel<D>) -> Self {
        let support = kernel.support_radius();
        let step = support / INTERVALS as f64;
        let at = |k: f64| plane_integral(kernel, k * step);
        let weights: Vec<f64> = (0..=INTERVALS).map(|k| at(k as f64)).collect();
        let middles: Vec<f64> = (0..INTERVALS).map(|k| at(k as f64 + 0.5)).collect();
        let mut colours = vec![0.5; INTERVALS + 1];
        let mut moments = vec![0.0; INTERVALS + 1];
        for k in 0..INTERVALS {
            colours[k + 1] = colours[k] + step / 6.0 * (weights[k] + 4.0 * middles[k] + weights[k + 1]);
        }
        for k in (0..INTERVALS).rev() {
            let ends = k as f64 * weights[k] + (k + 1) as f64 * weights[k + 1];
            let inside = 4.0 * (k as f64 + 0.5) * middles[k];
            moments[k] = moments[k + 1] + step * step / 6.0 * (ends + inside);
        }
        Self { support, weights, colours, moments }
    }

    /// Radius of the kernel's support \[m\].
    #[must_use]
    pub fn support(&self) -> f64 {
        self.support
    }

    /// w1(s) \[1/m\], even in s.
    #[must_use]
    pub fn weight(&self, depth: f64) -> f64 {
        self.interpolate(&self.weights, depth.abs())
    }

    /// C(s) \[-\]: 1/2 on the plane, one from a support below it on, zero from a support above it on.
    #[must_use]
    pub fn colour(&self, depth: f64) -> f64 {
        let deep = self.interpolate(&self.colours, depth.abs());
        if depth < 0.0 { 1.0 - deep } else { deep }
    }

    /// Depth \[m\] at which the colour is `colour`: the inverse of [`PlaneProfile::colour`], from -R to R.
    #[must_use]
    pub fn depth_of_colour(&self, colour: f64) -> f64 {
        if colour < 0.5 {
            return -self.depth_of_colour(1.0 - colour);
        }
        let above = self.colours.partition_point(|&entry| entry < colour);
        self.between(&self.colours, above, colour)
    }

    /// Depth \[m\] at which the centroid of what the kernel sees is `offset` \[m\] away: at most a support, and not less than
    /// minus half of it. Crowding of particles does not change it, as it does the colour.
    #[must_use]
    pub fn depth_of_offset(&self, offset: f64) -> f64 {
        // Moment less offset times colour falls with depth through zero; both are linear between the entries of their tables.
        let excess = |k: isize| {
            let (colour, moment) = (self.colours[k.unsigned_abs()], self.moments[k.unsigned_abs()]);
            moment - offset * if k < 0 { 1.0 - colour } else { colour }
        };
        let (mut high, mut low) = (-(INTERVALS as isize) / 2, INTERVALS as isize);
        while low - high > 1 {
            let middle = high + (low - high) / 2;
            if excess(middle) > 0.0 { high = middle } else { low = middle }
        }
        let above = excess(high).max(0.0);
        self.support / INTERVALS as f64 * (high as f64 + above / (above - excess(low)))
    }

    /// q(s) \[m\].
    #[must_use]
    pub fn offset(&self, depth: f64) -> f64 {
        self.interpolate(&self.moments, depth.abs()) / self.colour(depth)
    }

    fn interpolate(&self, table: &[f64], distance: f64) -> f64 {
        let place = distance / self.support * INTERVALS as f64;
        let k = place as usize;
        if k >= INTERVALS {
            return table[INTERVALS];
        }
        table[k] + (place - k as f64) * (table[k + 1] - table[k])
    }

    /// Where a rising table takes `value`, given the first entry that is not below it.
    fn between(&self, table: &[f64], above: usize, value: f64) -> f64 {
        let step = self.support / INTERVALS as f64;
        if above == 0 {
            return 0.0;
        }
        if above > INTERVALS {
            return self.support;
        }
        let rise = table[above] - table[above - 1];
        let share = if rise > 0.0 { (value - table[above - 1]) / rise } else { 0.0 };
        step * (above as f64 - 1.0 + share)
    }
}

/// The kernel integrated over a plane at a distance: 2 int W ds in 2-D, 2 pi int W s ds in 3-D (Simpson over
/// s^2 = (R^2 - d^2) sin^2, which takes the end of the support smoothly).
fn plane_integral<const D: usize>(kernel: &ScaledKernel<D>, distance: f64) -> f64 {
    let reach = (kernel.support_radius().powi(2) - distance * distance).max(0.0).sqrt();
    let step = std::f64::consts::FRAC_PI_2 / QUADRATURE as f64;
    let integrand = |k: usize| {
        let (sine, cosine) = (k as f64 * step).sin_cos();
        let s = reach * sine;
        let around = if D == 2 { 2.0 } else { 2.0 * std::f64::consts::PI * s };
        around * kernel.value(distance.hypot(s)) * reach * cosine
    };
    let inner: f64 = (1..QUADRATURE).map(|k| if k % 2 == 1 { 4.0 } else { 2.0 } * integrand(k)).sum();
    step / 3.0 * (integrand(0) + inner + integrand(QUADRATURE))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use sph_kernel::KernelKind;
    use std::sync::LazyLock;

    static PROFILES: LazyLock<[PlaneProfile; 4]> = LazyLock::new(|| {
        let (wendland, gaussian) = (KernelKind::WendlandC2, KernelKind::Gaussian);
        [
            PlaneProfile::new(&wendland.with_smoothing_length::<2>(0.3)),
            PlaneProfile::new(&wendland.with_smoothing_length::<3>(0.3)),
            PlaneProfile::new(&gaussian.with_smoothing_length::<2>(0.3)),
            PlaneProfile::new(&gaussian.with_smoothing_length::<3>(0.3)),
        ]
    });

    #[test]
    fn half_of_the_kernel_lies_on_each_side() {
        for profile in PROFILES.iter() {
            assert_eq!(profile.colour(0.0), 0.5);
            assert!((profile.colour(profile.support()) - 1.0).abs() < 1e-6);
            assert!(profile.colour(-profile.support()).abs() < 1e-6);
        }
    }

    #[test]
    fn a_gaussian_gives_the_error_function() {
        // Uncut, C = (1 + erf(s/h))/2 and w1 = exp(-(s/h)^2)/(h sqrt(pi)); the cut at 3 h shifts them by 1e-4 to 5e-4.
        for profile in &PROFILES[2..] {
            assert!((profile.colour(0.3) - 0.921_350_4).abs() < 5e-4);
            assert!((profile.weight(0.0) * 0.3 * std::f64::consts::PI.sqrt() - 1.0).abs() < 1e-3);
        }
    }

    #[test]
    fn the_moment_on_the_plane_is_that_of_the_half_kernel() {
        // Gaussian: int_0^inf t w1 dt = h/(2 sqrt(pi)), over C = 1/2.
        let exact = 0.3 / std::f64::consts::PI.sqrt();
        for profile in &PROFILES[2..] {
            assert!((profile.offset(0.0) / exact - 1.0).abs() < 2e-3, "{}", profile.offset(0.0));
        }
    }

    #[test]
    fn offsets_that_no_depth_has_give_the_ends() {
        for profile in PROFILES.iter() {
            assert_eq!(profile.depth_of_offset(profile.support()), -0.5 * profile.support());
            assert!((profile.depth_of_offset(0.0) / profile.support() - 1.0).abs() < 1e-15);
        }
    }

    proptest! {
        #[test]
        fn depths_come_back(kind in 0_usize..4, share in -0.45..0.9_f64) {
            let profile = &PROFILES[kind];
            let depth = share * profile.support();
            let from_colour = profile.depth_of_colour(profile.colour(depth));
            prop_assert!((from_colour - depth).abs() < 1e-3 * profile.support());
            let from_offset = profile.depth_of_offset(profile.offset(depth));
            prop_assert!((from_offset - depth).abs() < 1e-9 * profile.support());
        }
    }
}
