//! Particles sorted into levels by the power of two of their reach.

use crate::PairReach;

/// Particles whose reaches differ by less than a factor of two.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Level {
    /// The particles, ascending.
    pub members: Vec<u32>,
    /// The largest reach among them \[m\].
    pub radius: f64,
}

/// The levels that hold particles, by rising reach, and the level of each particle.
///
/// A pair is found from its member on the lower level (or from both on the same): its reach is then at most the radius of
/// the upper level, whose own index answers it. So no search is wider than the particles it looks for are large.
pub(crate) fn split(reach: &PairReach<'_>, particles: usize) -> (Vec<Level>, Vec<u16>) {
    let reaches = match reach {
        _ if particles == 0 => return (Vec::new(), Vec::new()),
        PairReach::Uniform(radius) => {
            let members = (0..particles as u32).collect();
            return (vec![Level { members, radius: *radius }], vec![0; particles]);
        }
        PairReach::Maximum(reaches) | PairReach::Mean(reaches) => *reaches,
    };
    let smallest = reaches.iter().copied().fold(f64::INFINITY, f64::min);
    let power = |reach: f64| binary_exponent(reach / smallest);
    let mut powers: Vec<u16> = reaches.iter().map(|&reach| power(reach)).collect();
    powers.sort_unstable();
    powers.dedup();
    let mut levels: Vec<Level> = powers.iter().map(|_| Level { members: Vec::new(), radius: 0.0 }).collect();
    let mut level_of = Vec::with_capacity(particles);
    for (particle, &reach) in reaches.iter().enumerate() {
        let level = powers.partition_point(|&other| other < power(reach));
        levels[level].members.push(particle as u32);
        levels[level].radius = levels[level].radius.max(reach);
        level_of.push(level as u16);
    }
    (levels, level_of)
}

/// floor(log2(x)) for x >= 1, read from the exponent bits: exact and monotone, where a logarithm need not be.
fn binary_exponent(x: f64) -> u16 {
    ((x.to_bits() >> 52) - 1023) as u16
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_reach_makes_one_level() {
        let (levels, level_of) = split(&PairReach::Uniform(0.5), 3);
        assert_eq!(levels, [Level { members: vec![0, 1, 2], radius: 0.5 }]);
        assert_eq!(level_of, [0, 0, 0]);
    }

    #[test]
    fn powers_of_two_get_their_own_levels_and_empty_ones_none() {
        let (levels, level_of) = split(&PairReach::Mean(&[0.4, 0.1, 0.15, 1.6, 0.4]), 5);
        assert_eq!(level_of, [1, 0, 0, 2, 1]);
        let radii: Vec<f64> = levels.iter().map(|level| level.radius).collect();
        assert_eq!(radii, [0.15, 0.4, 1.6]);
        assert_eq!(levels[1].members, [0, 4]);
    }

    #[test]
    fn exponents_are_exact_at_the_powers() {
        for power in [0_u16, 1, 5, 900] {
            let x = 2_f64.powi(i32::from(power));
            assert_eq!(binary_exponent(x), power);
            assert_eq!(binary_exponent(x * (2.0 - 1e-15)), power);
        }
    }
}
