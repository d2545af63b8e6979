//! A square of fluid without viscosity that starts to turn as a solid would, without anything that holds it (Colagrossi 2005): its corners
//! fly off, and it becomes four arms. Side L, density and angular speed omega are one.
//!
//! Pressure is negative inside, where particles without shifting clump. At the corners its gradient is zero, so that each flies along its
//! tangent, sqrt(1 + (omega t)^2) times as far from the centre as it was. Motion keeps its energy and its angular momentum.

use super::lattice::{Site, lattice};
use super::voids::largest_void;
use super::{Scheme, largest};
use crate::{Error, FindNeighbors, FluidPatch, PatchStart, Renewal};
use nalgebra::Vector2;
use std::f64::consts::PI;

/// Shifting without the pull of densities, whose noise breaks the tips: there is no closed surface here whose rows must come back.
pub const SCHEME: Scheme =
    Scheme { renewal: Some(Renewal { shifting: 3.0, density_pull: 0.0 }), ..Scheme::new(7.0) };
/// Odd terms of the series of the pressure.
const TERMS: u32 = 30;
/// How often a run is looked at in a unit of time.
const LOOKS: f64 = 4.0;

/// What was measured of the square at equal times.
#[derive(Debug)]
pub struct Square {
    /// Radius of the largest void over the spacing ([`largest_void`]).
    pub void: f64,
    /// Largest colour of a particle: one without clumps, two where particles lie in pairs.
    pub crowding: f64,
    /// Share of the kinetic energy that is lost at the end.
    pub energy_lost: f64,
    /// Share of the angular momentum that is lost at the end.
    pub spin_lost: f64,
    /// Distance of the farthest particle from the centre at the end, over that of a free corner particle.
    pub reach: f64,
    /// The fluid.
    pub patch: FluidPatch<2>,
}

/// Pressure over density and squared angular speed \[m^2\] at a place about the centre of a rectangle with the given sides \[m\] that
/// starts to turn: the series with p = 0 along the sides, for nabla^2 p = 2 rho omega^2.
#[must_use]
pub fn pressure_of_spin(position: &Vector2<f64>, sides: &Vector2<f64>) -> f64 {
    let terms = (0..TERMS).map(|k| f64::from(2 * k + 1) * PI);
    let along = |axis: usize| {
        let (place, side) = (position[axis] / sides[axis] + 0.5, sides[axis]);
        terms.clone().map(move |wave| (wave / side, (wave * place).sin() / wave))
    };
    let pairs = along(0).flat_map(|(a, across)| along(1).map(move |(b, up)| (a, b, across * up)));
    -32.0 * pairs.map(|(a, b, shape)| shape / (a * a + b * b)).sum::<f64>()
}

/// That of the square.
fn pressure(position: &Vector2<f64>) -> f64 {
    pressure_of_spin(position, &Vector2::repeat(1.0))
}

/// The square with `across` particles to the side until `end`, looked at four times in a unit of time.
///
/// # Errors
/// [`Error`] of the sweep.
pub fn rotating_square(
    across: usize,
    end: f64,
    scheme: Scheme,
    find: FindNeighbors<2>,
) -> Result<Square, Error> {
    let (spacing, n) = (1.0 / across as f64, across as i32);
    let mut start = lattice(spacing, 0..n, 0..n, |_, _| Site::Fluid);
    start.positions.iter_mut().for_each(|position| *position -= Vector2::repeat(0.5));
    let start = PatchStart { pressure, ..start };
    let mut patch = FluidPatch::new(start, scheme.controls(spacing)?, find)?;
    let velocities: Vec<_> = patch.positions().iter().map(|place| Vector2::new(-place.y, place.x)).collect();
    patch.velocities_mut().copy_from_slice(&velocities);
    let (energy, spin, corner) = (energy(&patch), spin(&patch), farthest(&patch));
    let (mut void, mut crowding) = (0.0, 0.0);
    let looks = (LOOKS * end).ceil() as usize;
    for look in 1..=looks {
        patch.run_to(end * look as f64 / looks as f64, scheme.acoustic_step(0.5, spacing));
        void = largest([void, largest_void(&patch)].into_iter());
        crowding = largest(patch.colours().into_iter().chain([crowding]));
    }
    Ok(Square {
        void,
        crowding,
        energy_lost: 1.0 - self::energy(&patch) / energy,
        spin_lost: 1.0 - self::spin(&patch) / spin,
        reach: farthest(&patch) / (corner * (1.0 + end * end).sqrt()),
        patch,
    })
}

fn energy(patch: &FluidPatch<2>) -> f64 {
    patch.velocities().iter().zip(patch.masses()).map(|(v, mass)| 0.5 * mass * v.norm_squared()).sum()
}

fn spin(patch: &FluidPatch<2>) -> f64 {
    let moments = patch.positions().iter().zip(patch.velocities()).zip(patch.masses());
    moments.map(|((x, v), mass)| mass * x.perp(v)).sum()
}

fn farthest(patch: &FluidPatch<2>) -> f64 {
    largest(patch.positions().iter().map(|place| place.norm()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pressure_of_the_start_has_its_laplacian_and_ends_at_the_sides() {
        let (place, step) = (Vector2::new(0.13, -0.21), 0.02);
        let sum: f64 = [Vector2::x(), Vector2::y(), -Vector2::x(), -Vector2::y()]
            .into_iter()
            .map(|way: Vector2<f64>| pressure(&(place + way * step)))
            .sum();
        assert!(((sum - 4.0 * pressure(&place)) / (step * step) - 2.0).abs() < 0.01);
        assert!(pressure(&Vector2::new(0.5, 0.1)).abs() < 1e-12);
        // Twice the torsion function of a square at its centre, 0.07367 L^2 (Timoshenko and Goodier 1970, article 109).
        assert!((pressure(&Vector2::zeros()) + 2.0 * 0.073_67).abs() < 2e-5);
    }
}
