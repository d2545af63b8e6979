//! Heat conduction with SPH: conservative pair weights, enthalpy curve, phase change, surface losses.
