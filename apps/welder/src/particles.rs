//! The particles of a scene: one storage for solid and melt, columns of equal length.

use nalgebra::SVector;

/// Phase of a particle as it is written to files.
pub const SOLID: u8 = 0;
/// Between solidus and liquidus.
pub const MUSHY: u8 = 1;
/// All liquid.
pub const LIQUID: u8 = 2;

/// Columns that physics share. A particle melts and freezes in place; its mass never changes.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Particles<const D: usize> {
    /// Position \[m\].
    pub position: Vec<SVector<f64, D>>,
    /// Edge of the cell that the particle stands for \[m\].
    pub spacing: Vec<f64>,
    /// Volume (\[m³\], 2-D: \[m²\]).
    pub volume: Vec<f64>,
    /// Mass \[kg\].
    pub mass: Vec<f64>,
    /// Index of the material in the scene's list.
    pub material: Vec<u8>,
    /// Specific enthalpy \[J/kg\], zero at 0 K: the state of heat.
    pub enthalpy: Vec<f64>,
    /// Specific enthalpy at the start \[J/kg\]: what stored heat is counted from.
    pub start_enthalpy: Vec<f64>,
    /// Highest specific enthalpy so far \[J/kg\].
    pub peak_enthalpy: Vec<f64>,
}

impl<const D: usize> Particles<D> {
    /// Number of particles.
    pub fn len(&self) -> usize {
        self.position.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.position.is_empty()
    }
}

/// Low and high corner of the box around `positions`: of none, the low one is above the high one.
pub fn bounding_box<'a, const D: usize>(
    positions: impl IntoIterator<Item = &'a SVector<f64, D>>,
) -> [SVector<f64, D>; 2] {
    let nothing = [SVector::repeat(f64::INFINITY), SVector::repeat(f64::NEG_INFINITY)];
    positions.into_iter().fold(nothing, |[low, high], x| [low.inf(x), high.sup(x)])
}
