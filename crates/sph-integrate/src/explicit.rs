//! Classical explicit schemes, for reference.

mod euler;
mod rk2;
mod rk4;

pub use euler::euler_step;
pub use rk2::rk2_step;
pub use rk4::rk4_step;

/// Work columns of [`rk2_step`] and [`rk4_step`], as long as the state.
#[derive(Debug, Clone)]
pub struct ExplicitScratch {
    start: Vec<f64>,
    rate: Vec<f64>,
    sum: Vec<f64>,
}

impl ExplicitScratch {
    /// Columns for a state of `size` numbers.
    #[must_use]
    pub fn new(size: usize) -> Self {
        Self { start: vec![0.0; size], rate: vec![0.0; size], sum: vec![0.0; size] }
    }
}
