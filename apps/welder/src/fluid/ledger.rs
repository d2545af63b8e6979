//! Where the energy of a fluid is, and what the scheme itself took.

use super::flow::FluidFlow;
use serde::{Deserialize, Serialize};
use sph_fluid::Powers;

/// A scheme that has given more than this share of the largest energy has run away.
const LARGEST_GIFT: f64 = 0.1;

/// A scheme that has taken more than this share of the largest energy is to be mentioned.
const LARGE_TAKE: f64 = 0.1;

/// Work since the start \[J; J/m in the plane\].
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Work {
    /// Of friction.
    pub friction: f64,
    /// Of surface tension.
    pub tension: f64,
    /// Of the change of tension with temperature.
    pub marangoni: f64,
    /// Of warmth: what expansion did against pressure.
    pub expansion: f64,
}

impl Work {
    /// Adds the work of forces over `duration` \[s\] between two powers, by the trapezoidal rule.
    pub fn add(&mut self, before: &Powers, after: &Powers, duration: f64) {
        self.friction += 0.5 * duration * (before.friction + after.friction);
        self.tension += 0.5 * duration * (before.tension + after.tension);
        self.marangoni += 0.5 * duration * (before.marangoni + after.marangoni);
    }
}

/// Energies of a fluid \[J; J/m in the plane\].
///
/// Pressure and continuity exchange motion for compression exactly but for the error of the steps. What does not close exactly is
/// named `numerics`: density diffusion and the pull of densities, shifting, the pressure that walls carry on, the steps, and
/// that work is sampled once for each list of neighbours.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct FluidLedger {
    /// Of motion.
    pub kinetic: f64,
    /// Of height over the lowest corner of the domain.
    pub potential: f64,
    /// Of compression.
    pub compression: f64,
    /// Stored in the surface since the start: the work done against tension.
    pub surface: f64,
    /// Taken by friction since the start; negative where moving walls have given more.
    pub friction: f64,
    /// Given by the change of tension with temperature since the start.
    pub driven: f64,
    /// Given by expansion since the start: places that warm and cool the fluid pay for it.
    pub expansion: f64,
    /// Taken by the scheme itself since the start; negative where it has given.
    pub numerics: f64,
    /// `numerics` over the largest of the other energies, that of the start included.
    pub residual: f64,
}

impl FluidLedger {
    /// The ledger of this moment; `start` is the sum of motion, height and compression at the start.
    pub fn new<const D: usize>(flow: &FluidFlow<D>, start: f64, work: &Work) -> Self {
        let [kinetic, potential, compression] = flow.energies();
        let (surface, friction) = (-work.tension, -work.friction);
        let held = kinetic + potential + compression;
        let numerics = start + work.marangoni + work.expansion - held - surface - friction;
        let given = [work.marangoni, work.expansion];
        let scale = [start, kinetic, potential, compression, surface, friction]
            .into_iter()
            .chain(given)
            .fold(0.0, |largest: f64, energy| largest.max(energy.abs()));
        let residual = if scale > 0.0 { numerics / scale } else { numerics };
        Self {
            kinetic,
            potential,
            compression,
            surface,
            friction,
            driven: work.marangoni,
            expansion: work.expansion,
            numerics,
            residual,
        }
    }

    /// What is wrong with it, if anything: energy from nowhere.
    pub fn fault(&self) -> Option<String> {
        let made = self.residual.is_nan() || self.residual < -LARGEST_GIFT;
        made.then(|| {
            format!(
                "the scheme itself gave {:.1e} of the largest energy; accepted: {LARGEST_GIFT}",
                -self.residual
            )
        })
    }

    /// What the user should know of it.
    pub fn warning(&self) -> Option<String> {
        (self.residual > LARGE_TAKE).then(|| {
            format!(
                "the scheme itself took {:.0} % of the largest energy: a finer spacing_m or less scheme.density_diffusion \
                 may tell what it changes",
                100.0 * self.residual
            )
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn energy_from_nowhere_is_a_fault_and_much_that_is_taken_a_warning() {
        let with = |residual| FluidLedger { residual, ..FluidLedger::default() };
        assert_eq!((with(0.09).fault(), with(0.09).warning()), (None, None));
        assert_eq!(with(-0.09).fault(), None);
        assert!(with(-0.2).fault().unwrap().contains("gave 2.0e-1"));
        assert!(with(f64::NAN).fault().is_some());
        assert!(with(0.3).warning().unwrap().contains("30 %"));
    }

    #[test]
    fn work_of_a_power_that_grows_evenly_is_exact() {
        let power = |p: f64| Powers { friction: -p, tension: 2.0 * p, marangoni: 0.5 * p };
        let mut work = Work::default();
        work.add(&power(1.0), &power(3.0), 2.0);
        work.add(&power(3.0), &power(4.0), 1.0);
        assert_eq!(work, Work { friction: -7.5, tension: 15.0, marangoni: 3.75, expansion: 0.0 });
    }
}
