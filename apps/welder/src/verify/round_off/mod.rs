//! Promises that hold to the last bits: the energy ledger, the melt's momentum, and the same bits on any number of threads and after a stop.

mod ledger;
mod momentum;
mod resume;
mod threads;

pub(super) use ledger::BENCHMARK as LEDGER;
pub(super) use momentum::BENCHMARK as MELT_MOMENTUM;
pub(super) use resume::BENCHMARK as RESUME;
pub(super) use threads::BENCHMARK as THREADS;

/// 1/e² radius of the beam \[m\].
const BEAM_RADIUS: f64 = 0.6e-3;

/// Share of values whose bits differ; all of them where there are more in one list.
fn share_of_other_bits(first: &[f64], second: &[f64]) -> f64 {
    if first.len() != second.len() {
        return 1.0;
    }
    let differing = first.iter().zip(second).filter(|(a, b)| a.to_bits() != b.to_bits()).count();
    differing as f64 / first.len() as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_bit_of_one_value_counts() {
        let values = [1.0, 2.0, 3.0, 0.0];
        assert_eq!(share_of_other_bits(&values, &values), 0.0);
        assert_eq!(share_of_other_bits(&values, &[1.0, 2.0 + 4.5e-16, 3.0, 0.0]), 0.25);
        assert_eq!(share_of_other_bits(&values, &[1.0, 2.0, 3.0, -0.0]), 0.25);
        assert_eq!(share_of_other_bits(&values, &values[..3]), 1.0);
    }
}
