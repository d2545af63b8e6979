//! The coefficients of RKL2 and the step that a number of stages allows.

use crate::error::Error;

/// The coefficients of stage j = 2..=s:
///
/// Y_j = mu Y_{j-1} + nu Y_{j-2} + (1 - mu - nu) Y_0 + mu~ tau L(Y_{j-1}) + gamma~ tau L(Y_0).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stage {
    /// Weight mu_j of the stage before.
    pub mu: f64,
    /// Weight nu_j of the stage before that.
    pub nu: f64,
    /// Weight 1 - mu_j - nu_j of the start of the step.
    pub one_minus_mu_nu: f64,
    /// Weight mu~_j of tau times the rate at the stage before.
    pub mu_tilde: f64,
    /// Weight gamma~_j of tau times the rate at the start of the step.
    pub gamma_tilde: f64,
}

/// The table of a super step of s stages; Meyer, Balsara and Aslam (2014), J. Comput. Phys. 257, 594.
#[derive(Debug, Clone, PartialEq)]
pub struct Rkl2Coefficients {
    first_mu_tilde: f64,
    stages: Vec<Stage>,
}

impl Rkl2Coefficients {
    /// The table for `stages` evaluations of the right-hand side. The count is odd: at the limit an even
    /// one keeps the shortest wave as it is, R = 1 - b_s + b_s P_s(-1) = 1, an odd one takes it to 1 - 2 b_s.
    ///
    /// # Errors
    /// [`Error::StageCount`] if the count is even or below 3.
    pub fn new(stages: usize) -> Result<Self, Error> {
        if stages < 3 || stages.is_multiple_of(2) {
            return Err(Error::StageCount { found: stages });
        }
        let scale = 1.0 / step_ratio(stages);
        Ok(Self {
            first_mu_tilde: legendre_weight(1) * scale,
            stages: (2..=stages).map(|j| stage(j, scale)).collect(),
        })
    }

    /// Number s of evaluations of the right-hand side in a step.
    #[must_use]
    pub fn stage_count(&self) -> usize {
        self.stages.len() + 1
    }

    /// Weight mu~_1 of the first stage: Y_1 = Y_0 + mu~_1 tau L(Y_0).
    #[must_use]
    pub fn first_mu_tilde(&self) -> f64 {
        self.first_mu_tilde
    }

    /// The stages j = 2..=s in order.
    #[must_use]
    pub fn stages(&self) -> &[Stage] {
        &self.stages
    }
}

/// Largest stable super step of `stages` stages (s): dt_euler (s^2 + s - 2)/4 (Meyer, Balsara and Aslam
/// 2014), where `dt_euler_s` = 2/lambda_max is the largest stable explicit Euler step.
#[must_use]
pub fn max_step(stages: usize, dt_euler_s: f64) -> f64 {
    step_ratio(stages) * dt_euler_s
}

/// The smallest odd number of stages, at least 3, that makes a super step of `tau_s` stable.
#[must_use]
pub fn stages_for(tau_s: f64, dt_euler_s: f64) -> usize {
    let ratio = tau_s / dt_euler_s;
    // The positive root of (s^2 + s - 2)/4 = ratio, then upwards to the next odd count that holds in
    // round-off too.
    let root = 0.5 * ((9.0 + 16.0 * ratio).sqrt() - 1.0);
    let mut stages = (root.floor().max(3.0) as usize - 1) | 1;
    while step_ratio(stages) < ratio {
        stages += 2;
    }
    stages.max(3)
}

/// Super step over Euler step, (s^2 + s - 2)/4.
fn step_ratio(stages: usize) -> f64 {
    let s = stages as f64;
    (s * s + s - 2.0) / 4.0
}

/// b_j = (j^2 + j - 2)/(2 j (j + 1)) for j >= 2; b_0 = b_1 = b_2 = 1/3.
fn legendre_weight(j: usize) -> f64 {
    let j = j.max(2) as f64;
    (j * j + j - 2.0) / (2.0 * j * (j + 1.0))
}

/// The coefficients of stage `j` >= 2; `scale` is w_1 = 4/(s^2 + s - 2).
fn stage(j: usize, scale: f64) -> Stage {
    let order = j as f64;
    let mu = (2.0 * order - 1.0) / order * legendre_weight(j) / legendre_weight(j - 1);
    let nu = -(order - 1.0) / order * legendre_weight(j) / legendre_weight(j - 2);
    let mu_tilde = mu * scale;
    let gamma_tilde = -(1.0 - legendre_weight(j - 1)) * mu_tilde;
    Stage { mu, nu, one_minus_mu_nu: 1.0 - mu - nu, mu_tilde, gamma_tilde }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The stability polynomial of the table at z = -lambda tau.
    fn amplification(coefficients: &Rkl2Coefficients, z: f64) -> f64 {
        let (mut before, mut now) = (1.0, 1.0 + coefficients.first_mu_tilde() * z);
        for stage in coefficients.stages() {
            let next = stage.mu * now
                + stage.nu * before
                + stage.one_minus_mu_nu
                + stage.mu_tilde * z * now
                + stage.gamma_tilde * z;
            (before, now) = (now, next);
        }
        now
    }

    /// Legendre polynomial by its three-term recurrence.
    fn legendre(degree: usize, x: f64) -> f64 {
        let (mut before, mut now) = (1.0, x);
        for j in 2..=degree {
            let order = j as f64;
            (before, now) = (now, ((2.0 * order - 1.0) * x * now - (order - 1.0) * before) / order);
        }
        now
    }

    proptest! {
        #[test]
        fn amplification_is_the_shifted_legendre_polynomial(half in 1..20_usize, along in 0.0..1.0_f64) {
            // R(z) = a_s + b_s P_s(1 + w_1 z) (Meyer, Balsara and Aslam 2014), which is not how it is
            // computed.
            let stages = 2 * half + 1;
            let z = -2.0 * step_ratio(stages) * along;
            let b = legendre_weight(stages);
            let expected = 1.0 - b + b * legendre(stages, 1.0 + z / step_ratio(stages));
            let found = amplification(&Rkl2Coefficients::new(stages).unwrap(), z);
            prop_assert!((found - expected).abs() < 1e-12, "{found} {expected}");
            prop_assert!(found.abs() <= 1.0 + 1e-13);
        }

        #[test]
        fn stages_are_enough_and_not_more(tau_s in 1e-9..1e4_f64) {
            let stages = stages_for(tau_s, 1.0);
            prop_assert!(stages % 2 == 1 && stages >= 3);
            prop_assert!(max_step(stages, 1.0) >= tau_s);
            prop_assert!(stages == 3 || max_step(stages - 2, 1.0) < tau_s);
        }

        #[test]
        fn the_largest_step_of_a_count_needs_that_count(half in 1..500_usize, dt_euler_s in 1e-7..1e-3_f64) {
            let stages = 2 * half + 1;
            prop_assert!(stages_for(max_step(stages, dt_euler_s) * (1.0 - 1e-14), dt_euler_s) == stages);
        }
    }

    #[test]
    fn expands_to_the_exponential_up_to_second_order() {
        for stages in [3, 7, 15] {
            let table = Rkl2Coefficients::new(stages).unwrap();
            let remainder = |z: f64| amplification(&table, z) - (1.0 + z + 0.5 * z * z);
            let ratio = remainder(-2e-3) / remainder(-1e-3);
            assert!((ratio - 8.0).abs() < 0.05, "{stages} stages: {ratio}");
        }
    }

    #[test]
    fn three_stages_by_hand() {
        // w_1 = 0.4, b_0 = b_1 = b_2 = 1/3, b_3 = 5/12.
        let table = Rkl2Coefficients::new(3).unwrap();
        let close =
            |found: f64, expected: f64| assert!((found - expected).abs() < 1e-15, "{found} {expected}");
        close(table.first_mu_tilde(), 0.4 / 3.0);
        let [second, third] = [table.stages()[0], table.stages()[1]];
        close(second.mu, 1.5);
        close(second.nu, -0.5);
        close(second.one_minus_mu_nu, 0.0);
        close(second.mu_tilde, 0.6);
        close(second.gamma_tilde, -0.4);
        close(third.mu, 25.0 / 12.0);
        close(third.nu, -5.0 / 6.0);
        close(third.one_minus_mu_nu, -0.25);
        close(third.mu_tilde, 5.0 / 6.0);
        close(third.gamma_tilde, -5.0 / 9.0);
        assert_eq!(table.stage_count(), 3);
        assert_eq!(max_step(3, 2.0), 5.0);
    }

    #[test]
    fn counts_that_do_not_exist_are_refused() {
        for stages in [0, 1, 2, 4, 10] {
            assert_eq!(Rkl2Coefficients::new(stages), Err(Error::StageCount { found: stages }));
        }
    }
}
