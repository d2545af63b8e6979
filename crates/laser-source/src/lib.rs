//! Laser heat sources: beam profiles, paths, absorption, and the power that reaches each patch of a surface.
