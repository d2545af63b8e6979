//! Heat that friction makes of motion.
//!
//! Both sides of a pair get half of the work that its friction does against their difference of velocities, so that all the energy
//! of motion that friction takes is heat of some particle, to round-off. Of a pair with a wall the fluid gets all of it, against the
//! wall's own velocity: what a moving wall puts in is in it.

use super::Fields;
use super::artificial_viscosity::artificial_term;
use super::viscosity::{Friction, Viscosity, shear_scale, shear_term, strain_scale, strain_term};
use nalgebra::SVector;
use sph_kernel::{Row, ScaledKernel};

/// Heat \[W/kg\] of [`viscous_acceleration`](crate::viscous_acceleration) or [`strain_acceleration`](crate::strain_acceleration).
///
/// Neighbours from `mobile` on are walls. `seen` \[m/s\] are the velocities that friction sees, `fields.velocities` each one's own.
#[inline]
#[must_use]
pub fn friction_heating<const D: usize>(
    row: &Row<'_, D>,
    fields: &Fields<'_, D>,
    seen: &[SVector<f64, D>],
    mobile: usize,
    friction: Friction,
    viscosity: Viscosity<'_>,
) -> f64 {
    let a = row.index;
    match friction {
        Friction::Shear => {
            shear_scale(fields, a)
                * work(row, fields, mobile, |k| shear_term(row, fields, seen, viscosity, k))
        }
        Friction::Strain => {
            strain_scale(fields, a)
                * work(row, fields, mobile, |k| strain_term(row, fields, seen, viscosity, k))
        }
    }
}

/// Heat \[W/kg\] of [`artificial_acceleration`](crate::artificial_acceleration).
#[inline]
#[must_use]
pub fn artificial_heating<const D: usize>(
    row: &Row<'_, D>,
    fields: &Fields<'_, D>,
    kernel: &ScaledKernel<D>,
    mobile: usize,
    sound_speed: f64,
    coefficient: f64,
) -> f64 {
    let length = kernel.smoothing_length();
    let sum = work(row, fields, mobile, |k| artificial_term(row, fields, length, k));
    sum * (coefficient * sound_speed * length)
}

/// Of each pair, what its `term` takes from the motion, shared.
#[inline]
fn work<const D: usize>(
    row: &Row<'_, D>,
    fields: &Fields<'_, D>,
    mobile: usize,
    term: impl Fn(usize) -> SVector<f64, D>,
) -> f64 {
    let own = fields.velocities[row.index];
    let taken = |k: usize| {
        let b = row.neighbors[k] as usize;
        let share = if b < mobile { 0.5 } else { 1.0 };
        -share * term(k).dot(&(own - fields.velocities[b]))
    };
    (0..row.len()).map(taken).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_block::Block;
    use crate::{artificial_acceleration, strain_acceleration, viscous_acceleration};

    const EVEN: Viscosity<'static> = Viscosity::Even(0.6);

    /// sum m (a.v + q) over sum m |a.v|, and the least heat.
    fn balance<const D: usize>(
        block: &Block<D>,
        accelerations: &[SVector<f64, D>],
        heats: &[f64],
    ) -> (f64, f64) {
        let powers = (0..heats.len()).map(|i| block.masses[i] * accelerations[i].dot(&block.velocities[i]));
        let (sum, size) = powers.fold((0.0, 0.0), |(sum, size), power| (sum + power, size + power.abs()));
        let heat: f64 = heats.iter().zip(&block.masses).map(|(heat, mass)| heat * mass).sum();
        ((sum + heat).abs() / size, heats.iter().copied().fold(f64::INFINITY, f64::min))
    }

    #[test]
    fn what_friction_takes_is_heat_to_round_off() {
        let block = Block::<3>::new(5, 0.3);
        let (fields, seen, all) = (block.fields(), &block.velocities, block.positions.len());
        let kernel = Block::<3>::kernel();
        let pairs = [
            (
                block.map_rows(|row| viscous_acceleration(row, &fields, seen, EVEN)),
                block.map_rows(|row| friction_heating(row, &fields, seen, all, Friction::Shear, EVEN)),
            ),
            (
                block.map_rows(|row| strain_acceleration(row, &fields, seen, EVEN)),
                block.map_rows(|row| friction_heating(row, &fields, seen, all, Friction::Strain, EVEN)),
            ),
            (
                block.map_rows(|row| artificial_acceleration(row, &fields, &kernel, 9.0, 0.2)),
                block.map_rows(|row| artificial_heating(row, &fields, &kernel, all, 9.0, 0.2)),
            ),
        ];
        for (accelerations, heats) in pairs {
            let (rest, least) = balance(&block, &accelerations, &heats);
            assert!(rest < 1e-14 && least >= 0.0, "{rest} {least}");
        }
    }

    #[test]
    fn a_wall_at_rest_gets_no_heat_and_takes_no_work() {
        // The last particles are a wall: what friction takes from the others is their heat.
        let block = Block::<2>::new(6, 0.2);
        let mobile = 24;
        let mut velocities = block.velocities.clone();
        velocities[mobile..].fill(SVector::zeros());
        let fields = Fields { velocities: &velocities, ..block.fields() };
        let (mut taken, mut heat) = (0.0, 0.0);
        for i in 0..mobile {
            block.with_row(i, |row| {
                let force = viscous_acceleration(row, &fields, &block.velocities, EVEN) * block.masses[i];
                taken -= force.dot(&velocities[i]);
                let own = friction_heating(row, &fields, &block.velocities, mobile, Friction::Shear, EVEN);
                heat += own * block.masses[i];
            });
        }
        assert!((taken - heat).abs() < 1e-13 * taken.abs().max(1.0) && taken > 1.0, "{taken} {heat}");
    }
}
