//! What is told of bodies: the largest of what was measured, and where their energy is.

use serde::{Deserialize, Serialize};

/// Bodies that have gained this share of the energy that there was have run away.
const LARGEST_GIFT: f64 = 0.1;

/// Largest of what was measured at a time, or over a run.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct SolidRecords {
    /// Largest speed of a particle \[m/s\].
    pub speed: f64,
    /// Largest von Mises stress \[Pa\].
    pub von_mises: f64,
    /// Largest and smallest principal stress \[Pa\]; tension is positive.
    pub principal: [f64; 2],
    /// Largest displacement from the start \[m\].
    pub displacement: f64,
    /// Largest accumulated equivalent plastic strain \[-\].
    pub plastic: f64,
}

impl SolidRecords {
    /// The largest of both.
    #[must_use]
    pub(super) fn with(&self, other: &Self) -> Self {
        let ([most, least], [first, last]) = (self.principal, other.principal);
        Self {
            speed: self.speed.max(other.speed),
            von_mises: self.von_mises.max(other.von_mises),
            principal: [most.max(first), least.min(last)],
            displacement: self.displacement.max(other.displacement),
            plastic: self.plastic.max(other.plastic),
        }
    }
}

/// Energies of the bodies \[J; J/m in the plane\].
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct SolidLedger {
    /// Of motion.
    pub kinetic: f64,
    /// Of elastic strain.
    pub elastic: f64,
    /// Of height over the start.
    pub potential: f64,
    /// Brought since the start by prescribed temperatures.
    pub heated: f64,
    /// Brought since the start by what is held and moves.
    pub driven: f64,
    /// Work of yield since the start, plastic strain taken as small.
    pub plastic: f64,
    /// Taken since the start by damping.
    pub damped: f64,
    /// Taken since the start by artificial viscosity and the scheme itself; negative where it has given.
    pub lost: f64,
    /// `lost` over the largest of the energies, that of the start included.
    pub residual: f64,
}

impl SolidLedger {
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
}
