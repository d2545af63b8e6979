//! SPH smoothing kernels, the row view of one particle's neighbours, and operators that know no physics.
