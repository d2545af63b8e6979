//! Exact solutions, computed: closed forms, quadrature, roots. SI units, or any other consistent ones.

mod half_spaces;
mod moving_gaussian;
mod mushy_stefan;
mod numeric;
mod plane_flux;
mod stefan;
mod surface_gaussian;
mod top_hat;

pub use half_spaces::HalfSpaces;
pub use moving_gaussian::MovingGaussian;
pub use mushy_stefan::MushyStefan;
pub use plane_flux::plane_flux_rise;
pub use stefan::Stefan;
pub use surface_gaussian::SurfaceGaussian;
pub use top_hat::top_hat_rise;
