//! The elastic moduli of an isotropic material and how they follow from each other.

use crate::error::{Error, require};

/// The moduli of an isotropic elastic material, all from two of them; relations of Landau and Lifshitz,
/// Theory of Elasticity (1986), section 5.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IsotropicModuli {
    bulk_pa: f64,
    shear_pa: f64,
}

impl IsotropicModuli {
    /// From Young's modulus E (Pa) and Poisson's ratio nu: K = E/(3 (1 - 2 nu)), mu = E/(2 (1 + nu)).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if E is not positive, or nu not above -1 and below 0.5 (where K becomes
    /// infinite).
    pub fn from_young_and_poisson(young_pa: f64, poisson: f64) -> Result<Self, Error> {
        require(young_pa > 0.0, "young_pa", young_pa, "a positive modulus in pascals")?;
        require(poisson > -1.0 && poisson < 0.5, "poisson", poisson, "a ratio above -1 and below 0.5")?;
        Ok(Self {
            bulk_pa: young_pa / (3.0 * (1.0 - 2.0 * poisson)),
            shear_pa: 0.5 * young_pa / (1.0 + poisson),
        })
    }

    /// From the bulk modulus K (Pa) and the shear modulus mu (Pa).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if one of them is not positive.
    pub fn from_bulk_and_shear(bulk_pa: f64, shear_pa: f64) -> Result<Self, Error> {
        require(bulk_pa > 0.0, "bulk_pa", bulk_pa, "a positive modulus in pascals")?;
        require(shear_pa > 0.0, "shear_pa", shear_pa, "a positive modulus in pascals")?;
        Ok(Self { bulk_pa, shear_pa })
    }

    /// From Lame's constants lambda (Pa) and mu (Pa): K = lambda + 2 mu/3.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if mu or K is not positive.
    pub fn from_lame(lambda_pa: f64, shear_pa: f64) -> Result<Self, Error> {
        require(shear_pa > 0.0, "shear_pa", shear_pa, "a positive modulus in pascals")?;
        let bulk_pa = lambda_pa + 2.0 / 3.0 * shear_pa;
        require(bulk_pa > 0.0, "lambda_pa", lambda_pa, "a modulus in pascals above -2/3 of shear_pa")?;
        Ok(Self { bulk_pa, shear_pa })
    }

    /// Bulk modulus K (Pa).
    #[must_use]
    pub fn bulk_pa(&self) -> f64 {
        self.bulk_pa
    }

    /// Shear modulus mu (Pa).
    #[must_use]
    pub fn shear_pa(&self) -> f64 {
        self.shear_pa
    }

    /// Lame's first constant lambda = K - 2 mu/3 (Pa).
    #[must_use]
    pub fn lambda_pa(&self) -> f64 {
        self.bulk_pa - 2.0 / 3.0 * self.shear_pa
    }

    /// Young's modulus E = 9 K mu/(3 K + mu) (Pa).
    #[must_use]
    pub fn young_pa(&self) -> f64 {
        9.0 * self.bulk_pa * self.shear_pa / (3.0 * self.bulk_pa + self.shear_pa)
    }

    /// Poisson's ratio nu = (3 K - 2 mu)/(2 (3 K + mu)).
    #[must_use]
    pub fn poisson(&self) -> f64 {
        0.5 * (3.0 * self.bulk_pa - 2.0 * self.shear_pa) / (3.0 * self.bulk_pa + self.shear_pa)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn every_pair_leads_back(young in 1e5..1e12_f64, poisson in -0.9..0.49_f64) {
            let moduli = IsotropicModuli::from_young_and_poisson(young, poisson).unwrap();
            prop_assert!((moduli.young_pa() / young - 1.0).abs() < 1e-13);
            prop_assert!((moduli.poisson() - poisson).abs() < 1e-13);
            let again = IsotropicModuli::from_lame(moduli.lambda_pa(), moduli.shear_pa()).unwrap();
            // K is a small difference when nu is near -1.
            let (bulk, shear) = (moduli.bulk_pa(), moduli.shear_pa());
            prop_assert!((again.bulk_pa() - bulk).abs() < 1e-14 * (bulk + shear));
            prop_assert!(IsotropicModuli::from_bulk_and_shear(bulk, shear).unwrap() == moduli);
        }

        #[test]
        fn uniaxial_stress_gives_young_and_poisson(young in 1e5..1e12_f64, poisson in -0.9..0.49_f64) {
            // Strain (1, -nu, -nu) must give the stress (E, 0, 0) by sigma = lambda tr(e) + 2 mu e.
            let moduli = IsotropicModuli::from_young_and_poisson(young, poisson).unwrap();
            let trace = 1.0 - 2.0 * poisson;
            let stress = |strain: f64| moduli.lambda_pa() * trace + 2.0 * moduli.shear_pa() * strain;
            let scale = young + moduli.shear_pa();
            prop_assert!((stress(1.0) - young).abs() < 1e-13 * scale);
            prop_assert!(stress(-poisson).abs() < 1e-13 * scale);
        }
    }

    #[test]
    fn poisson_of_a_quarter_makes_lame_constants_equal() {
        let moduli = IsotropicModuli::from_young_and_poisson(100e9, 0.25).unwrap();
        assert!((moduli.lambda_pa() / 40e9 - 1.0).abs() < 1e-14);
        assert!((moduli.shear_pa() / 40e9 - 1.0).abs() < 1e-14);
    }

    #[test]
    fn bad_values_are_named() {
        let message = |result: Result<IsotropicModuli, Error>| result.unwrap_err().to_string();
        let incompressible = message(IsotropicModuli::from_young_and_poisson(1e9, 0.5));
        assert_eq!(incompressible, "poisson is 0.5, but must be a ratio above -1 and below 0.5");
        assert!(message(IsotropicModuli::from_young_and_poisson(-1.0, 0.3)).starts_with("young_pa is -1"));
        assert!(message(IsotropicModuli::from_bulk_and_shear(0.0, 1.0)).starts_with("bulk_pa is 0"));
        assert!(message(IsotropicModuli::from_lame(-1.0, 1.0)).starts_with("lambda_pa is -1"));
        assert!(message(IsotropicModuli::from_lame(f64::NAN, 1.0)).starts_with("lambda_pa is NaN"));
    }
}
