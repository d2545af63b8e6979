//! A square of melt between a hot and a cold side, driven by the tension of its flat top. Side, density, temperature difference and
//! U = |tau_T| dT/eta are one, so that eta = 1/Re and the diffusivity is 1/(Re Pr).

mod reference;

pub use reference::CavityReference;

use super::fit::velocity_at;
use super::largest;
use super::lattice::{Site, WALL_ROWS, lattice};
use crate::{
    Conduction, Error, FindNeighbors, FluidControls, FluidPatch, PatchStart, PressureForce, Renewal,
    SurfaceTension, Tait,
};
use nalgebra::Vector2;
use sph_kernel::KernelKind;

/// Weight that keeps the top flat \[U^2/H\].
const GRAVITY: f64 = 4.0;
/// Artificial speed of sound \[U\].
const SOUND_SPEED: f64 = 16.0;
/// Time over which a measurement goes \[H/U\], half of a turn of the vortex, and how often it looks.
const WINDOW: f64 = 5.0;
const LOOKS: usize = 10;

/// A cavity with its published steady state (97 x 97 nodes; adiabatic floor and top).
#[derive(Clone, Copy, Debug)]
pub struct CavityCase {
    /// Re = |tau_T| dT rho H/eta^2.
    pub reynolds: f64,
    /// Pr = eta/(rho a).
    pub prandtl: f64,
    /// Speed of the middle of the top \[U\].
    pub speed: f64,
    /// Largest stream function \[U H\].
    pub stream: f64,
    /// Heat from the hot side to the cold one over that without flow.
    pub nusselt: f64,
}

/// The cases whose answer is known.
pub const CASES: [CavityCase; 3] = [
    CavityCase { reynolds: 100.0, prandtl: 1.0, speed: 0.1088, stream: 0.01059, nusselt: 1.096 },
    CavityCase { reynolds: 1000.0, prandtl: 1.0, speed: 0.0501, stream: 0.00483, nusselt: 1.92 },
    CavityCase { reynolds: 1000.0, prandtl: 0.015, speed: 0.0946, stream: 0.00930, nusselt: 1.002 },
];

/// A cavity that runs.
#[derive(Debug)]
pub struct Cavity {
    /// The fluid.
    pub patch: FluidPatch<2>,
    case: CavityCase,
}

/// What was measured over five time units.
#[derive(Clone, Copy, Debug)]
pub struct CavityMeans {
    /// Mean speed of the middle of the top \[U\].
    pub speed: f64,
    /// Mean of the largest stream function \[U H\].
    pub stream: f64,
    /// Mean heat from the hot side and to the cold one, over that without flow.
    pub nusselt: [f64; 2],
    /// Root of the mean square of the L2 error of the velocities of all particles against the reference, over its L2 norm.
    pub field: f64,
}

impl Cavity {
    /// At rest under its weight, its temperature falling evenly from the hot side to the cold one. With `cured` the rows of the
    /// top are renewed, continuity is corrected and pressure acts by its slope: without the first two the flow stalls, and without
    /// the last half of the error of its field is noise.
    ///
    /// # Errors
    /// [`Error`] of the sweep.
    pub fn new(rows: usize, case: CavityCase, cured: bool, find: FindNeighbors<2>) -> Result<Self, Error> {
        let (n, viscosity) = (rows as i32, 1.0 / case.reynolds);
        let inside = 0..n;
        // The walls stand above the top: a corner particle that gets over a wall level with it would fall behind.
        let all = -WALL_ROWS..n + WALL_ROWS;
        let start = lattice(1.0 / rows as f64, all.clone(), all, |column, row| {
            match (inside.contains(&column), row) {
                (true, 0..) if row < n => Site::Fluid,
                (true, 0..) => Site::Empty,
                _ => Site::Wall,
            }
        });
        let kernel = KernelKind::WendlandC2.with_smoothing_length(1.5 * start.spacing);
        let controls = FluidControls {
            dynamic_viscosity: viscosity,
            density_diffusion: 0.1,
            body_acceleration: Vector2::new(0.0, -GRAVITY),
            surface_tension: Some(SurfaceTension::new(0.0, -viscosity, 0.0)?),
            renewal: cured.then(Renewal::default),
            corrected_gradients: cured,
            pressure: if cured { PressureForce::Slope } else { PressureForce::Pairs },
            ..FluidControls::new(kernel, Tait::new(1.0, SOUND_SPEED, 7.0)?)
        };
        let start = PatchStart {
            pressure: |position: &Vector2<f64>| GRAVITY * (1.0 - position.y),
            temperature: |position: &Vector2<f64>| 1.0 - position.x,
            conduction: Some(Conduction { diffusivity: viscosity / case.prandtl, heat_capacity: 1.0, held }),
            ..start
        };
        Ok(Self { patch: FluidPatch::new(start, controls, find)?, case })
    }

    /// Steps to a time \[H/U\] and measures over the last five units before it.
    pub fn means(&mut self, time: f64, reference: &CavityReference) -> CavityMeans {
        let mut means = CavityMeans { speed: 0.0, stream: 0.0, nusselt: [0.0; 2], field: 0.0 };
        for look in 1..=LOOKS {
            self.run_to(time - WINDOW + WINDOW * look as f64 / LOOKS as f64);
            let nusselt = self.nusselt();
            means.speed += velocity_at(&self.patch, Vector2::new(0.5, 1.0)).x / LOOKS as f64;
            means.stream += self.stream() / LOOKS as f64;
            means.nusselt = [0, 1].map(|side| means.nusselt[side] + nusselt[side] / LOOKS as f64);
            means.field += self.field_error(reference).powi(2) / LOOKS as f64;
        }
        CavityMeans { field: means.field.sqrt(), ..means }
    }

    fn run_to(&mut self, time: f64) {
        self.patch.run_to(time, 0.5 * 1.5 * self.patch.spacing() / SOUND_SPEED);
    }

    /// The largest flux below any place.
    fn stream(&self) -> f64 {
        let spacing = self.patch.spacing();
        let n = (1.0 / spacing).round() as usize;
        let speed = |column: usize, row: usize| {
            velocity_at(&self.patch, Vector2::new(column as f64, row as f64 + 0.5) * spacing).x
        };
        let column = |column: usize| {
            let mut flux = 0.0;
            largest((0..n).map(|row| {
                flux += speed(column, row) * spacing;
                f64::abs(flux)
            }))
        };
        largest((1..n).map(column))
    }

    fn nusselt(&self) -> [f64; 2] {
        let alone = 1.0 / (self.case.reynolds * self.case.prandtl);
        let (hot, cold) = (|wall: &Vector2<f64>| wall.x < 0.0, |wall: &Vector2<f64>| wall.x > 1.0);
        [self.patch.heat_taken_from(hot) / alone, -self.patch.heat_taken_from(cold) / alone]
    }

    fn field_error(&self, reference: &CavityReference) -> f64 {
        let (mut wrong, mut exact) = (0.0, 0.0);
        for (position, velocity) in self.patch.positions().iter().zip(self.patch.velocities()) {
            let expected = reference.velocity(position);
            wrong += (velocity - expected).norm_squared();
            exact += expected.norm_squared();
        }
        (wrong / exact).sqrt()
    }
}

/// The sides are held at one and zero, floor and top let no heat through.
fn held(position: &Vector2<f64>) -> Option<f64> {
    let beside = position.y > 0.0 && !(0.0..1.0).contains(&position.x);
    beside.then_some(if position.x < 0.5 { 1.0 } else { 0.0 })
}
