//! What one particle makes of its deformation gradient, and what viscosity makes of a pair.

use super::lanes::Lanes;
use super::material::{Controls, Material};
use crate::{
    ArtificialViscosity, SymmetricTensor, cauchy_stress, elastic_strain, first_stress, radial_return,
    second_stress, second_stress_of_cauchy, strain_of_stress,
};
use nalgebra::SMatrix;

/// m_i m_j Pi |f| (x_i - x_j) on i \[N\]: along the present line of the pair, so that both momenta stay.
#[inline]
pub(crate) fn viscous_force<const D: usize>(
    law: &ArtificialViscosity,
    sound: f64,
    moved: [Lanes; 2],
    speeds: [Lanes; 2],
    weight: Lanes,
) -> Lanes {
    let apart = moved[0] - moved[1] + weight * (-1.0 / weight.scalar());
    let density = 0.5 * (moved[0].scalar() + moved[1].scalar());
    let length = 0.5 * (speeds[0].scalar() + speeds[1].scalar());
    let (separation, relative) = (apart.vector::<D>(), (speeds[0] - speeds[1]).vector::<D>());
    let pi = law.pair(&separation, &relative, length, sound, density);
    Lanes::new(&separation, 0.0) * (density * density * weight.scalar() * pi)
}

/// The material's law with what is the same for all particles at hand.
pub(crate) struct PointLaw<'a> {
    material: &'a Material,
    /// c = hourglass (K + 4 mu/3) \[Pa\], before any plastic strain.
    pub hourglass_modulus: f64,
}

impl<'a> PointLaw<'a> {
    pub fn new(material: &'a Material, controls: &Controls) -> Self {
        let moduli = material.solver_moduli();
        let wave = moduli.bulk_pa() + 4.0 / 3.0 * moduli.shear_pa();
        Self { material, hourglass_modulus: controls.hourglass * wave }
    }

    /// theta for the logarithmic stretch `reference` of the reference temperature.
    #[inline]
    pub fn stretch(&self, temperature: f64, reference: f64) -> f64 {
        (self.material.expansion.logarithmic_stretch(temperature) - reference).exp()
    }

    /// The first Piola-Kirchhoff stress \[Pa\], after a return to the yield stress if there is one, and the hourglass modulus
    /// \[Pa\].
    ///
    /// Yield acts on the Cauchy stress, whose pressure it leaves alone; what is taken off goes back to the axes of the
    /// reference. The modulus falls with the secant one, sigma_y/(sigma_y + 3 mu e_p): else a body that has flowed unevenly would be
    /// held by the stiffness of modes that its plastic strain has left behind.
    #[inline]
    pub fn update<const D: usize>(
        &self,
        deformation: &SMatrix<f64, D, D>,
        stretch: f64,
        temperature: f64,
        inelastic: &mut SymmetricTensor<D>,
        equivalent: &mut f64,
    ) -> (SMatrix<f64, D, D>, f64) {
        let moduli = self.material.solver_moduli();
        let mut hourglass = self.hourglass_modulus;
        let mut stress = second_stress(&(elastic_strain(deformation, stretch) - *inelastic), moduli);
        if self.material.yield_stress.is_some() {
            let yield_pa = self.material.solver_yield_pa(temperature);
            let cauchy = cauchy_stress(deformation, stretch, &stress);
            if let Some(step) = radial_return(&cauchy.deviator(), moduli.shear_pa(), yield_pa) {
                let excess = step.strain * (2.0 * moduli.shear_pa());
                let excess = second_stress_of_cauchy(deformation, stretch, &excess);
                stress = stress - excess;
                *inelastic += strain_of_stress(&excess, moduli);
                *equivalent += step.equivalent;
            }
            if *equivalent > 0.0 {
                hourglass *= yield_pa / (yield_pa + 3.0 * moduli.shear_pa() * *equivalent);
            }
        }
        (first_stress(deformation, stretch, &stress), hourglass)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{IsotropicModuli, YieldStress};
    use nalgebra::Matrix2;

    #[test]
    fn the_hourglass_modulus_falls_with_plastic_strain_only() {
        let moduli = IsotropicModuli::from_young_and_poisson(70e9, 0.33).unwrap();
        let mut material = Material::elastic(moduli, 2700.0).unwrap();
        material.yield_stress = Some(YieldStress::falling_to_zero(90e6, 293.0, 853.0).unwrap());
        let point = PointLaw::new(&material, &Controls { hourglass: 0.1, viscosity: 0.0 });
        let modulus = |shear: f64, temperature: f64| {
            let (mut strain, mut equivalent) = (SymmetricTensor::zero(), 0.0);
            let deformation = Matrix2::new(1.0, shear, shear, 1.0);
            point.update(&deformation, 1.0, temperature, &mut strain, &mut equivalent).1
        };
        assert_eq!(modulus(1e-4, 293.0), point.hourglass_modulus);
        // Shear 1e-2: total equivalent strain 2/sqrt(3) 1e-2, so that the secant modulus is 90 MPa over 3 mu times it.
        let secant = 90e6 / (3.0 * moduli.shear_pa() * 2.0 / 3.0_f64.sqrt() * 1e-2);
        assert!((modulus(1e-2, 293.0) / point.hourglass_modulus / secant - 1.0).abs() < 1e-3);
        assert_eq!(modulus(1e-4, 900.0), 0.0);
    }
}
