//! Diffusion of density, against noise in the pressure.

use super::Fields;
use nalgebra::SVector;
use sph_kernel::Row;

/// 2 sum_b V_b (rho_a - rho_b) W'/r \[kg/m^5\] (Molteni and Colagrossi 2009); times delta h c the rate of rho_a.
///
/// `fluid_row` must hold fluid neighbours only ([`leading_part`](crate::leading_part)): across a wall the term pumps the
/// layer. Mass is kept: the sum of V times the rate is zero. It does not vanish for a hydrostatic density at a face.
#[inline]
#[must_use]
pub fn plain_diffusion<const D: usize>(fluid_row: &Row<'_, D>, fields: &Fields<'_, D>) -> f64 {
    let own = fields.densities[fluid_row.index];
    let mut sum = 0.0;
    for (k, &neighbor) in fluid_row.neighbors.iter().enumerate() {
        let b = neighbor as usize;
        sum += fields.volumes[b] * fluid_row.gradient_factors[k] * (own - fields.densities[b]);
    }
    2.0 * sum
}

/// 2 sum_b V_b (rho_a - rho_b - (g_a + g_b).(r_a - r_b)/2) W'/r \[kg/m^5\] (Antuono, Colagrossi, Marrone and Molteni
/// 2010); times delta h c the rate of rho_a.
///
/// `density_gradients` g \[kg/m^4\] are the corrected (CSPM) gradients of the density over fluid neighbours. The term
/// vanishes for a linear density, at faces too. `fluid_row` as in [`plain_diffusion`]; mass is kept as there.
#[inline]
#[must_use]
pub fn corrected_diffusion<const D: usize>(
    fluid_row: &Row<'_, D>,
    fields: &Fields<'_, D>,
    density_gradients: &[SVector<f64, D>],
) -> f64 {
    let a = fluid_row.index;
    let mut sum = 0.0;
    for (k, &neighbor) in fluid_row.neighbors.iter().enumerate() {
        let b = neighbor as usize;
        let expected = 0.5 * (density_gradients[a] + density_gradients[b]).dot(&fluid_row.separations[k]);
        let unexpected = fields.densities[a] - fields.densities[b] - expected;
        sum += fields.volumes[b] * fluid_row.gradient_factors[k] * unexpected;
    }
    2.0 * sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_block::Block;
    use nalgebra::{Vector2, Vector3};
    use sph_kernel::operators::{gradient, moment, regularised_inverse};

    fn corrected<const D: usize>(block: &Block<D>) -> Vec<f64> {
        let gradients = block.map_rows(|row| {
            let inverse = regularised_inverse(&moment(row, &block.volumes));
            gradient(row, &block.volumes, &block.densities, &inverse)
        });
        block.map_rows(|row| corrected_diffusion(row, &block.fields(), &gradients))
    }

    fn plain<const D: usize>(block: &Block<D>) -> Vec<f64> {
        block.map_rows(|row| plain_diffusion(row, &block.fields()))
    }

    #[test]
    fn mass_is_kept() {
        let block = Block::<3>::new(5, 0.3);
        for rates in [plain(&block), corrected(&block)] {
            let sum: f64 = rates.iter().zip(&block.volumes).map(|(rate, volume)| rate * volume).sum();
            let scale: f64 = rates.iter().map(|rate| rate.abs()).sum();
            assert!(sum.abs() < 1e-14 * scale && scale > 1.0);
        }
    }

    #[test]
    fn noise_decays() {
        let block = Block::<2>::new(8, 0.2);
        for rates in [plain(&block), corrected(&block)] {
            let decay: f64 = (0..rates.len()).map(|i| rates[i] * block.volumes[i] * block.densities[i]).sum();
            assert!(decay < -0.1, "{decay}");
        }
    }

    #[test]
    fn a_hydrostatic_density_stays_with_the_correction_only() {
        let mut block = Block::<3>::new(5, 0.2);
        let slope = Vector3::new(0.1, -0.2, 0.05);
        block.densities = block.positions.iter().map(|r| 2.0 + slope.dot(r)).collect();
        assert!(corrected(&block).iter().all(|rate| rate.abs() < 1e-12));
        assert!(plain(&block).iter().any(|rate| rate.abs() > 0.1));
    }

    #[test]
    fn a_parabolic_density_gives_its_second_derivative_in_a_lattice() {
        let mut block = Block::<2>::lattice(9, |_| Vector2::zeros());
        block.densities = block.positions.iter().map(|r| 2.0 + 0.3 * r.x * r.x).collect();
        block.with_row(Block::<2>::middle(9), |row| {
            let expected = 0.6 * moment(row, &block.volumes)[(0, 0)];
            assert!((plain_diffusion(row, &block.fields()) - expected).abs() < 1e-12);
        });
    }
}
