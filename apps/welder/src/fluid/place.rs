//! From the bodies and walls of a scene to particles at rest or under way.

use super::model::{Edge, FluidModel, vector_or_zero};
use crate::build::{centre_of, sites};
use crate::case::fluid::Body;
use nalgebra::{SVector, Vector2};
use sph_fluid::benchmarks::shapes::{cut_ball, rings};
use sph_fluid::benchmarks::square::pressure_of_spin;
use std::f64::consts::PI;

/// Particles of the fluid, and of the walls.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed<const D: usize> {
    /// Positions of the fluid \[m\].
    pub positions: Vec<SVector<f64, D>>,
    /// Masses of the fluid \[kg; kg/m in the plane\].
    pub masses: Vec<f64>,
    /// Densities of the fluid, with the pressure of the start \[kg/m³\].
    pub densities: Vec<f64>,
    /// Velocities of the fluid \[m/s\].
    pub velocities: Vec<SVector<f64, D>>,
    /// Which body each particle belongs to.
    pub bodies: Vec<u8>,
    /// Positions of the walls \[m\].
    pub walls: Vec<SVector<f64, D>>,
    /// Velocities of the walls \[m/s\].
    pub wall_velocities: Vec<SVector<f64, D>>,
}

/// Rows of particles that make a wall: the kernel's support and one more.
pub fn wall_rows(smoothing_ratio: f64) -> i64 {
    (2.0 * smoothing_ratio).ceil() as i64 + 1
}

impl<const D: usize> Placed<D> {
    /// The particles of a scene.
    pub fn new(model: &FluidModel<D>) -> Self {
        let mut placed = Self {
            positions: Vec::new(),
            masses: Vec::new(),
            densities: Vec::new(),
            velocities: Vec::new(),
            bodies: Vec::new(),
            walls: Vec::new(),
            wall_velocities: Vec::new(),
        };
        for (index, body) in model.case.scene.bodies.iter().enumerate() {
            let first = placed.positions.len();
            match body {
                Body::Block { low_m, high_m, spin_rad_s, .. } => {
                    placed.fill_block(model, low_m.vector(), high_m.vector(), *spin_rad_s)
                }
                Body::Ball { centre_m, radius_m, .. } => {
                    placed.fill_ball(model, centre_m.vector(), *radius_m)
                }
            }
            let velocity = vector_or_zero(body.velocity_m_s());
            for velocities in &mut placed.velocities[first..] {
                *velocities += velocity;
            }
            placed.bodies.resize(placed.positions.len(), index as u8);
        }
        placed.build_walls(model);
        placed
    }

    /// Cells of a block, with the pressure of their depth below its top and that of its `spin` \[rad/s\].
    fn fill_block(&mut self, model: &FluidModel<D>, low: SVector<f64, D>, high: SVector<f64, D>, spin: f64) {
        let (spacing, gravity) = (model.spacing(), model.controls.body_acceleration);
        let counts = (high - low).map(|length| (length / spacing).round() as i64);
        let top: f64 = (0..D).map(|axis| (gravity[axis] * low[axis]).min(gravity[axis] * high[axis])).sum();
        for site in sites([0; D], counts.into()) {
            let position = low + centre_of(site) * spacing;
            let from_centre = position - 0.5 * (low + high);
            let in_plane = |vector: SVector<f64, D>| Vector2::new(vector[0], vector[1]);
            let (place, sides) = (in_plane(from_centre), in_plane(high - low));
            let pull = if spin == 0.0 { 0.0 } else { spin * spin * pressure_of_spin(&place, &sides) };
            let pressure = model.density() * (gravity.dot(&position) - top + pull);
            self.push(model, position, spacing.powi(D as i32), pressure);
            if let Some(velocity) = self.velocities.last_mut() {
                (velocity[0], velocity[1]) = (-spin * place.y, spin * place.x);
            }
        }
    }

    /// A disc of rings or a ball cut out of a lattice, of the exact volume and with the pressure of its curvature.
    fn fill_ball(&mut self, model: &FluidModel<D>, centre: SVector<f64, D>, radius: f64) {
        let across = (radius / model.spacing()).round() as usize;
        let tension = model.controls.surface_tension.map_or(0.0, |tension| tension.reference());
        let pressure = (D - 1) as f64 * tension / radius;
        if D == 2 {
            let (positions, areas) = rings(across);
            for (place, area) in positions.iter().zip(areas) {
                let offset = SVector::from_fn(|axis, _| place[axis] * radius);
                self.push(model, centre + offset, area * radius * radius, pressure);
            }
        } else {
            let positions = cut_ball::<D>(across);
            let volume = 4.0 / 3.0 * PI * radius.powi(3) / positions.len() as f64;
            for place in positions {
                self.push(model, centre + place * radius, volume, pressure);
            }
        }
    }

    fn push(&mut self, model: &FluidModel<D>, position: SVector<f64, D>, volume: f64, pressure: f64) {
        let density = model.controls.state.density(pressure) / model.stretch_at(&position);
        self.positions.push(position);
        self.densities.push(density);
        self.masses.push(density * volume);
        self.velocities.push(SVector::zeros());
    }

    /// Cells outside the domain behind its walls; walls go on beyond periodic sides, and end with the domain at open ones.
    fn build_walls(&mut self, model: &FluidModel<D>) {
        let (spacing, rows) = (model.spacing(), wall_rows(model.case.scene.scheme.smoothing_ratio));
        let counts = model.size.map(|length| (length / spacing).round() as i64);
        let behind = |site: [i64; D]| {
            let mut velocities = Vec::new();
            for axis in 0..D {
                let end = match site[axis] {
                    k if k < 0 => 0,
                    k if k >= counts[axis] => 1,
                    _ => continue,
                };
                match model.edges[axis][end] {
                    Edge::Open => return None,
                    Edge::Periodic => (),
                    Edge::Wall(velocity) => velocities.push(velocity),
                }
            }
            // A corner moves only where all its walls move alike.
            let first = *velocities.first()?;
            Some(if velocities.iter().all(|v| *v == first) { first } else { SVector::zeros() })
        };
        let high: [i64; D] = counts.map(|count| count + rows).into();
        for site in sites([-rows; D], high) {
            if let Some(velocity) = behind(site) {
                self.walls.push(model.low + centre_of(site) * spacing);
                self.wall_velocities.push(velocity);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::{Loaded, load_any};
    use sph_fluid::Tait;

    fn placed<const D: usize>(scene: &str) -> Placed<D> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("scene.ron");
        std::fs::write(&path, scene).unwrap();
        let Loaded::Fluid(case) = load_any(&path, &[]).unwrap_or_else(|error| panic!("{error}")) else {
            panic!("a fluid")
        };
        Placed::new(&FluidModel::from_case(&case).unwrap())
    }

    #[test]
    fn a_block_that_turns_has_the_speed_and_the_pressure_of_its_spin() {
        let turning: Placed<2> = placed(
            "Fluid(domain: (low_m: (-1, -1), size_m: (2, 2)), \
             fluid: (density_kg_m3: 900.0, viscosity_pa_s: 0.0, sound_speed_m_s: 50.0), \
             bodies: [Block(low_m: (-0.5, -0.5), high_m: (0.5, 0.5), spin_rad_s: 3, velocity_m_s: (1, 0))], \
             spacing_m: 0.02, time: (end_s: 1))",
        );
        let middle = turning.positions.iter().position(|x| x.norm() < 0.015).unwrap();
        // Twice the torsion function of a square at its centre, 0.07367 L^2 (Timoshenko and Goodier 1970, article 109).
        let pull = Tait::new(900.0, 50.0, 7.0).unwrap().pressure(turning.densities[middle]);
        assert!((pull / (-2.0 * 0.07367 * 900.0 * 9.0) - 1.0).abs() < 5e-3, "{pull}");
        let corner = turning.positions.iter().position(|x| x.x > 0.48 && x.y > 0.48).unwrap();
        let (place, velocity) = (turning.positions[corner], turning.velocities[corner]);
        assert!(
            (velocity - SVector::from([1.0 - 3.0 * place.y, 3.0 * place.x])).norm() < 1e-12,
            "{velocity}"
        );
    }

    #[test]
    fn blocks_and_balls_have_their_exact_mass_and_pressure() {
        let tail = "fluid: (density_kg_m3: 900.0, viscosity_pa_s: 0.1, surface_tension_n_m: 0.05, sound_speed_m_s: 100.0), \
                    spacing_m: 0.1, gravity_m_s2: (0, -10), time: (end_s: 1.0))";
        let disc = placed::<2>(&format!(
            "Fluid(domain: (size_m: (4, 4)), bodies: [Ball(centre_m: (2, 2), radius_m: 0.8)], {tail}"
        ));
        let volume: f64 = disc.masses.iter().zip(&disc.densities).map(|(mass, rho)| mass / rho).sum();
        assert!((volume / (PI * 0.64) - 1.0).abs() < 1e-12);
        // tau/R compresses by tau/(R rho c^2).
        assert!((disc.densities[0] / 900.0 - 1.0 - 0.05 / (0.8 * 9e6)).abs() < 1e-12);
        let block = placed::<2>(&format!(
            "Fluid(domain: (size_m: (4, 4)), bodies: [Block(low_m: (0, 0), high_m: (1, 2))], {tail}"
        ));
        assert_eq!(block.positions.len(), 200);
        // The lowest row lies 1.95 m below the top: rho g H.
        let pressure = 9e6 / 900.0 * (block.densities[0] - 900.0);
        assert!((pressure / (900.0 * 10.0 * 1.95) - 1.0).abs() < 0.01, "{pressure}");
    }

    #[test]
    fn walls_close_corners_end_at_open_sides_and_go_on_beyond_periods() {
        let scene = |sides: &str| {
            format!(
                "Fluid(domain: (size_m: (1.2, 1), sides: ({sides})), bodies: [Block(low_m: (0, 0), high_m: (1.2, 0.5))], \
                 fluid: (density_kg_m3: 1.0, viscosity_pa_s: 1.0, sound_speed_m_s: 100.0), spacing_m: 0.1, time: (end_s: 1.0))"
            )
        };
        // Four rows below 12 cells and 4 beside each, and four columns of 10 cells on each side.
        assert_eq!(placed::<2>(&scene("x_min: Wall(), x_max: Wall(), y_min: Wall()")).walls.len(), 80 + 80);
        assert_eq!(placed::<2>(&scene("y_min: Wall()")).walls.len(), 48);
        let channel = placed::<2>(&scene(
            "x_min: Periodic, x_max: Periodic, y_min: Wall(), y_max: Wall(velocity_m_s: (2, 0))",
        ));
        assert_eq!(channel.walls.len(), 2 * 80);
        let moving =
            channel.walls.iter().zip(&channel.wall_velocities).all(|(x, v)| (v.x == 2.0) == (x.y > 1.0));
        assert!(moving);
    }
}
