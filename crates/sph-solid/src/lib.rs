//! Laws of a thermoelastic solid: isotropic moduli and wave speeds.
