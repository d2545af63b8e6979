//! The largest eigenvalue of an operator, which sets the longest explicit step.

/// Factor on the estimate of [`largest_eigenvalue`]: power iteration approaches from below, and 60 iterations
/// on the spectrum of a diffusion operator leave a few per cent.
pub const SPECTRAL_SAFETY: f64 = 1.05;

/// Iterations of [`largest_eigenvalue`].
const ITERATIONS: usize = 60;

/// An upper estimate of the largest eigenvalue of a symmetric positive semi-definite operator of `size`
/// unknowns.
///
/// `apply(v, image)` writes the image of `v`. Power iteration from a fixed start vector, times
/// [`SPECTRAL_SAFETY`]; the same bits every time. A diagonal scaling that makes the operator D^-1 A is made
/// symmetric as D^-1/2 A D^-1/2. Returns 0 for an operator that maps everything to zero, and NaN if it makes
/// a NaN.
#[must_use]
pub fn largest_eigenvalue(size: usize, mut apply: impl FnMut(&[f64], &mut [f64])) -> f64 {
    let mut vector: Vec<f64> = (0..size as u64).map(scatter).collect();
    let mut image = vec![0.0; size];
    let mut growth = 0.0;
    normalise(&mut vector);
    for _ in 0..ITERATIONS {
        apply(&vector, &mut image);
        growth = normalise(&mut image);
        if growth == 0.0 {
            return 0.0;
        }
        std::mem::swap(&mut vector, &mut image);
    }
    SPECTRAL_SAFETY * growth
}

/// Divides by the Euclidean norm, and returns that norm.
fn normalise(vector: &mut [f64]) -> f64 {
    let norm = vector.iter().map(|value| value * value).sum::<f64>().sqrt();
    if norm != 0.0 {
        vector.iter_mut().for_each(|value| *value /= norm);
    }
    norm
}

/// A number in -1..1 scattered by index (splitmix64; Steele, Lea and Flood 2014), so that the start vector
/// has a part along every eigenvector.
fn scatter(index: u64) -> f64 {
    let mut bits = (index + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    bits ^= bits >> 31;
    (bits >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// Minus the second difference with fixed ends; eigenvalues 4 sin^2(k pi / (2 (n + 1))), k = 1..n.
    fn laplacian(v: &[f64], image: &mut [f64]) {
        for i in 0..v.len() {
            let left = if i > 0 { v[i - 1] } else { 0.0 };
            let right = v.get(i + 1).copied().unwrap_or(0.0);
            image[i] = 2.0 * v[i] - left - right;
        }
    }

    #[test]
    fn bounds_the_spectrum_of_the_laplacian_closely() {
        for size in [1, 2, 5, 30, 1000, 100_000] {
            let exact = 4.0 * (size as f64 * PI / (2.0 * (size as f64 + 1.0))).sin().powi(2);
            let ratio = largest_eigenvalue(size, laplacian) / exact;
            assert!(ratio > 1.0 && ratio <= SPECTRAL_SAFETY * (1.0 + 1e-12), "{size}: {ratio}");
        }
    }

    #[test]
    fn isolated_eigenvalue_is_found_to_round_off() {
        let found =
            largest_eigenvalue(3, |v, image| (0..3).for_each(|i| image[i] = [7.0, 2.0, 1.0][i] * v[i]));
        assert!((found / (7.0 * SPECTRAL_SAFETY) - 1.0).abs() < 1e-14);
    }

    #[test]
    fn zero_and_broken_operators() {
        assert_eq!(largest_eigenvalue(4, |_, image| image.fill(0.0)), 0.0);
        assert_eq!(largest_eigenvalue(0, |_, _| ()), 0.0);
        assert!(largest_eigenvalue(4, |_, image| image.fill(f64::NAN)).is_nan());
    }
}
