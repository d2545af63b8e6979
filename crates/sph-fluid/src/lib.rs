//! Laws of a weakly compressible melt: equation of state and sound speed.
