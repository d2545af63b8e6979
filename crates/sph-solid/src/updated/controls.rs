//! How the updated-Lagrangian form is computed.

use crate::error::{Error, require};
use crate::{ARTIFICIAL_STRESS_FACTOR, ArtificialViscosity};
use sph_kernel::ScaledKernel;

/// How gradients and forces are formed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UpdatedForm {
    /// As in Hu and Eberhard (2015): plain kernel gradients. For comparison: a spinning block stresses itself.
    Paper,
    /// The kernel-gradient correction B in the velocity gradient and in the force, which keeps energy.
    Corrected,
}

/// Coefficients of the updated-Lagrangian form.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UpdatedControls<const D: usize> {
    /// Paper's or corrected gradients.
    pub form: UpdatedForm,
    /// Kernel of all particles.
    pub kernel: ScaledKernel<D>,
    /// Initial spacing \[m\], to which the artificial stress is scaled.
    pub spacing: f64,
    /// Artificial stress epsilon \[-\]; 0 is none.
    pub artificial_stress: f64,
    /// Artificial viscosity; zero coefficients are none.
    pub viscosity: ArtificialViscosity,
    /// Viscosity on zero-energy modes \[-\]; 0 is none.
    pub hourglass_viscosity: f64,
}

impl<const D: usize> UpdatedControls<D> {
    /// The paper's: artificial stress 0.3, viscosity alpha 0.5.
    #[must_use]
    pub fn paper(kernel: ScaledKernel<D>, spacing: f64) -> Self {
        let viscosity = ArtificialViscosity { alpha: 0.5, beta: 0.0 };
        let artificial_stress = ARTIFICIAL_STRESS_FACTOR;
        Self {
            form: UpdatedForm::Paper,
            kernel,
            spacing,
            artificial_stress,
            viscosity,
            hourglass_viscosity: 0.0,
        }
    }

    /// Corrected gradients, no artificial stress, viscosity on zero-energy modes 0.4.
    #[must_use]
    pub fn corrected(kernel: ScaledKernel<D>, spacing: f64) -> Self {
        let viscosity = ArtificialViscosity { alpha: 0.0, beta: 0.0 };
        let form = UpdatedForm::Corrected;
        Self { form, kernel, spacing, artificial_stress: 0.0, viscosity, hourglass_viscosity: 0.4 }
    }

    /// Refuses a spacing that is not positive and coefficients that are negative.
    pub(super) fn check(&self) -> Result<(), Error> {
        require(self.spacing > 0.0, "spacing", self.spacing, "positive, in metres")?;
        for (name, value) in [
            ("artificial_stress", self.artificial_stress),
            ("viscosity alpha", self.viscosity.alpha),
            ("viscosity beta", self.viscosity.beta),
            ("hourglass_viscosity", self.hourglass_viscosity),
        ] {
            require(value >= 0.0, name, value, "zero or above")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use sph_kernel::KernelKind;

    #[test]
    fn bad_controls_are_named() {
        let kernel = KernelKind::WendlandC2.with_smoothing_length::<2>(1.0);
        let message = |controls: UpdatedControls<2>| controls.check().unwrap_err().to_string();
        let controls = UpdatedControls { artificial_stress: -0.3, ..UpdatedControls::paper(kernel, 1.0) };
        assert_eq!(message(controls), "artificial_stress is -0.3, but must be zero or above");
        assert!(message(UpdatedControls::corrected(kernel, 0.0)).starts_with("spacing is 0"));
    }
}
