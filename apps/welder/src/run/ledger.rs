//! The energy ledger: what came in, where it is, what is missing.

use crate::model::Model;
use crate::particles::Particles;
use crate::physics::{Exchange, Mechanics};

/// A residual above this share of the energy that was turned over fails the run's audit.
pub const LARGEST_RESIDUAL: f64 = 1e-10;

/// The same for the motion of the melt, whose scheme loses and gains a little.
pub const LARGEST_MECHANICAL_RESIDUAL: f64 = 1e-6;

/// Energies of the whole part, mirror images counted \[J\].
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Ledger {
    /// Light sent out by the laser.
    pub emitted: f64,
    /// Light absorbed.
    pub absorbed: f64,
    /// Light reflected.
    pub reflected: f64,
    /// Light that missed the part.
    pub missed: f64,
    /// Heat lost through faces.
    pub lost: f64,
    /// Heat made by friction, by melt that stops as it freezes, and by deformation.
    pub made: f64,
    /// Stored heat beyond the start, without the latent part.
    pub sensible: f64,
    /// Stored latent heat beyond the start.
    pub latent: f64,
    /// (absorbed + made - lost - stored) over the energy turned over.
    pub residual: f64,
    /// What the melt holds in motion and compression.
    pub moving: f64,
    /// (work of tension and gravity - heat of friction - moving) over the energy turned over.
    pub mechanical_residual: f64,
    /// (elastic and thermoelastic energy + heat of deformation) over the energy turned over, where deformation makes heat.
    pub deformation_residual: f64,
}

impl Ledger {
    /// Adds up the ledger; `copies` is the number of mirror images that make the whole part.
    pub fn new(
        model: &Model,
        particles: &Particles<3>,
        exchange: &Exchange,
        mechanics: &Mechanics,
        copies: f64,
    ) -> Self {
        let stored = pairwise(particles.len(), &|i| {
            particles.mass[i] * (particles.enthalpy[i] - particles.start_enthalpy[i])
        });
        let latent = pairwise(particles.len(), &|i| {
            let curve = &model.curves[particles.material[i] as usize];
            let latent_heat = model.materials[particles.material[i] as usize].latent_heat;
            let fraction = |h: f64| curve.liquid_fraction(h);
            let melted = fraction(particles.enthalpy[i]) - fraction(particles.start_enthalpy[i]);
            particles.mass[i] * latent_heat * melted
        });
        let moved = pairwise(particles.len(), &|i| {
            particles.mass[i] * (particles.enthalpy[i] - particles.start_enthalpy[i]).abs()
        });
        let turned_over = moved.max(exchange.absorbed).max(exchange.lost.abs());
        let share = |energy: f64| if turned_over > 0.0 { energy / turned_over } else { energy };
        let moving = mechanics.kinetic + mechanics.compression;
        let missing = exchange.absorbed + exchange.made - exchange.lost - stored;
        Self {
            emitted: copies * exchange.emitted,
            absorbed: copies * exchange.absorbed,
            reflected: copies * exchange.reflected,
            missed: copies * exchange.missed,
            lost: copies * exchange.lost,
            made: copies * exchange.made,
            sensible: copies * (stored - latent),
            latent: copies * latent,
            residual: share(missing),
            moving: copies * moving,
            mechanical_residual: share(mechanics.work.kept() - moving),
            deformation_residual: if model
                .stress
                .as_ref()
                .is_some_and(|stress| stress.settings.heat_of_deformation)
            {
                share(mechanics.strain + mechanics.thermoelastic + mechanics.deformed)
            } else {
                0.0
            },
        }
    }

    /// What is wrong with it, if anything: energy that is missing, or light that went nowhere.
    pub fn fault(&self) -> Option<String> {
        let light = self.emitted - self.absorbed - self.reflected - self.missed;
        if self.residual.is_nan() || self.residual.abs() > LARGEST_RESIDUAL {
            return Some(format!(
                "the energy ledger is open by {:.2e} of the energy turned over; accepted: {LARGEST_RESIDUAL:.0e}",
                self.residual
            ));
        }
        if self.mechanical_residual.is_nan() || self.mechanical_residual.abs() > LARGEST_MECHANICAL_RESIDUAL {
            return Some(format!(
                "the motion of the melt holds {:.3e} J, and lacks {:.2e} of the energy turned over; accepted: \
                 {LARGEST_MECHANICAL_RESIDUAL:.0e}",
                self.moving, self.mechanical_residual
            ));
        }
        if light.is_nan() || light.abs() > 1e-6 * self.emitted.abs() {
            return Some(format!(
                "of {:.6} J emitted, {:.6} J absorbed, {:.6} J reflected and {:.6} J missed leave {light:.2e} J",
                self.emitted, self.absorbed, self.reflected, self.missed
            ));
        }
        None
    }
}

/// Sum of `term(i)` over `0..count` by halves: the round-off grows with the logarithm of the count.
fn pairwise(count: usize, term: &dyn Fn(usize) -> f64) -> f64 {
    fn half(range: std::ops::Range<usize>, term: &dyn Fn(usize) -> f64) -> f64 {
        if range.len() <= 64 {
            return range.map(term).sum();
        }
        let middle = range.start + range.len() / 2;
        half(range.start..middle, term) + half(middle..range.end, term)
    }
    half(0..count, term)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairwise_sums_lose_almost_nothing() {
        let sum = pairwise(1_000_000, &|i| if i == 0 { 1e16 } else { 1.0 });
        assert!((sum - 1e16 - 999_999.0).abs() <= 64.0, "{}", sum - 1e16);
    }

    #[test]
    fn an_open_ledger_and_lost_light_are_faults() {
        let closed =
            Ledger { emitted: 10.0, absorbed: 4.0, reflected: 5.0, missed: 1.0, ..Ledger::default() };
        assert_eq!(closed.fault(), None);
        assert!(Ledger { residual: 2e-10, ..closed }.fault().unwrap().contains("ledger"));
        assert!(Ledger { residual: f64::NAN, ..closed }.fault().is_some());
        assert!(Ledger { mechanical_residual: -2e-6, ..closed }.fault().unwrap().contains("motion"));
        assert!(Ledger { missed: 0.9, ..closed }.fault().unwrap().contains("missed"));
    }
}
