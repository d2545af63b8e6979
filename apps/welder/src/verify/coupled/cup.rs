//! Melt at rest in an elastic cup, by two forms of the pair force between melt and solid: the melt's pressure carried to the solid,
//! which this project takes, and the solid's own stress, as Hu and Eberhard (2015, section 2.3) write it.
//!
//! The outermost row of a body without traction carries almost no stress: where the melt meets that, it must carry nearly
//! twice its own pressure to be held, and never comes to rest.

use super::super::benchmark::relative;
use super::super::neighbors::find;
use super::super::{Benchmark, BenchmarkError, Mark, Outcome, Quantity};
use super::fluid::{Fluid, load};
use nalgebra::{SMatrix, Vector2};
use sph_fluid::{FluidControls, Tait};
use sph_kernel::KernelKind;
use sph_solid::benchmarks::shapes::lattice;
use sph_solid::{DEFAULT_STEP_FACTOR, IsotropicModuli, Material, SolidPatch, SolidStart};

/// Width and depth of the melt, thickness of the cup in particles of the melt's depth.
const WIDTH_OVER_DEPTH: f64 = 16.0 / 12.0;
const WALL: usize = 5;

/// Depth \[m\], density \[kg/m³\], gravity \[m/s²\]: rho g H is 0.3 % of rho c^2 of the melt.
const DEPTH: f64 = 6e-4;
const DENSITY: f64 = 2385.0;
const GRAVITY: f64 = 2000.0;

/// Speeds of sound of the melt and of the cup \[m/s\], sqrt(K/rho).
const MELT_SOUND: f64 = 20.0;
const CUP_SOUND: f64 = 50.0;
const POISSON: f64 = 0.33;

/// Time to come to rest, and over which pressures are averaged then \[s\].
const REST: f64 = 4e-3;
const LOOK: f64 = 5e-4;

/// Step of both over the melt's h/c: the load of a step is that of its start, which feeds an oscillation of the cup where steps are
/// longer.
const STEP: f64 = 0.1;

/// Both lose their speed by this rate \[1/s\]: the cup as in dynamic relaxation, the melt so that REST suffices.
const FADING: f64 = 5e3;

pub(in super::super) const BENCHMARK: Benchmark = Benchmark {
    name: "coupled/cup",
    tested_crate: "welder",
    reference: "rho g H",
    quantities: &[
        Quantity {
            suffix: "pressure",
            text: "relative error of the pressure of the melt's lowest row, the melt's pressure carried to the cup; resolution: rows \
                   of melt",
            marks: &MARKS_OF_PRESSURE,
        },
        Quantity {
            suffix: "speed",
            text: "largest speed of the melt after 4 ms, over sqrt(g H)",
            marks: &MARKS_OF_SPEED,
        },
        Quantity {
            suffix: "hu-eberhard-2015-pressure",
            text: "the pressure with the cup's own stress in the pair, as the paper has it; for comparison",
            marks: &MARKS_OF_PRESSURE,
        },
        Quantity {
            suffix: "hu-eberhard-2015-speed",
            text: "the speed with that; for comparison",
            marks: &MARKS_OF_SPEED,
        },
    ],
    resolutions: [8.0, 12.0, 16.0],
    quick: 1,
    run: |rows| {
        let mut errors = Vec::new();
        let mut found = Outcome { errors: Vec::new(), particles: 0, pair_visits: 0 };
        for own_stress in [false, true] {
            let mut cup = Cup::new(rows as usize, own_stress)?;
            let (pressure, speed) = cup.at_rest();
            errors.extend([relative(pressure, 1.0), speed]);
            found.particles = cup.melt.columns.positions.len();
            found.pair_visits += cup.melt.pair_visits + cup.solid.pair_visits();
        }
        Ok(Outcome { errors, ..found })
    },
};

const MARKS_OF_PRESSURE: [Mark; 2] =
    [Mark { resolution: 8.0, error: 0.01 }, Mark { resolution: 12.0, error: 0.01 }];
const MARKS_OF_SPEED: [Mark; 2] =
    [Mark { resolution: 8.0, error: 1e-3 }, Mark { resolution: 12.0, error: 1e-3 }];

/// Melt and cup.
struct Cup {
    melt: Fluid<2>,
    solid: SolidPatch<2>,
    spacing: f64,
    own_stress: bool,
    dt: f64,
    finer_steps: usize,
}

impl Cup {
    fn new(rows: usize, own_stress: bool) -> Result<Self, BenchmarkError> {
        let spacing = DEPTH / rows as f64;
        let across = (WIDTH_OVER_DEPTH * rows as f64).round() as usize;
        let inside =
            |place: &Vector2<f64>| place.y > 0.0 && place.x > 0.0 && place.x < across as f64 * spacing;
        let low = -(WALL as f64) * spacing;
        let mut block = lattice([low; 2], [across + 2 * WALL, rows + WALL], spacing);
        block.retain(|place| !inside(place));
        let modulus = DENSITY * CUP_SOUND * CUP_SOUND;
        let young = 3.0 * modulus * (1.0 - 2.0 * POISSON);
        let material = Material::elastic(IsotropicModuli::from_young_and_poisson(young, POISSON)?, DENSITY)?;
        let mut solid = SolidPatch::new(SolidStart::new(block, spacing, material), find)?;
        let (left, right) = (low + spacing, (across + WALL - 1) as f64 * spacing);
        solid.hold(|place| place.y < left || place.x < left || place.x > right);
        solid.evaluate();
        let length = 1.5 * spacing;
        let controls = FluidControls {
            artificial_viscosity: 0.1,
            body_acceleration: Vector2::new(0.0, -GRAVITY),
            ..FluidControls::new(
                KernelKind::WendlandC2.with_smoothing_length(length),
                Tait::new(DENSITY, MELT_SOUND, 7.0)?,
            )
        };
        let walls: Vec<_> = solid.positions().iter().map(|place| (*place, spacing * spacing)).collect();
        let pressure = |place: &Vector2<f64>| DENSITY * GRAVITY * (DEPTH - place.y);
        let places = lattice([0.0; 2], [across, rows], spacing);
        let mut melt = Fluid::at_rest(controls, spacing, places, pressure, &walls)?;
        if own_stress {
            melt.wall_pressures = vec![0.0; walls.len()];
        }
        let dt = STEP * length / MELT_SOUND;
        let finer_steps = (dt / solid.body().stable_step(DEFAULT_STEP_FACTOR)).ceil() as usize;
        Ok(Self { melt, solid, spacing, own_stress, dt, finer_steps })
    }

    fn step(&mut self) {
        let Self { melt, solid, finer_steps, dt, own_stress, .. } = self;
        let mut loads = melt.forces_on_walls(solid.positions().len());
        if *own_stress {
            let stresses: Vec<SMatrix<f64, 2, 2>> =
                solid.stresses().into_iter().map(|stress| stress.in_plane).collect();
            melt.push_by_own_stress(&stresses, &mut loads);
        }
        load(solid, &loads, *finer_steps, *dt);
        let kept = (-FADING * *dt).exp();
        solid.velocities.iter_mut().for_each(|velocity| *velocity *= kept);
        melt.step_around(solid, *dt);
        let fluid = melt.len();
        melt.columns.velocities[..fluid].iter_mut().for_each(|velocity| *velocity *= kept);
    }

    /// Mean pressure of the lowest row after rest, over that of its depth, and the largest speed over sqrt(g H).
    fn at_rest(&mut self) -> (f64, f64) {
        let steps = |time: f64| (time / self.dt).ceil() as usize;
        let (rest, look) = (steps(REST), steps(LOOK));
        (0..rest).for_each(|_| self.step());
        let (mut sum, mut fastest) = (0.0, 0.0f64);
        for _ in 0..look {
            self.step();
            let lowest = |i: &usize| self.melt.columns.positions[*i].y < self.spacing;
            let pressures = self.melt.sweep.pressures();
            let row: Vec<f64> = (0..self.melt.len()).filter(lowest).map(|i| pressures[i]).collect();
            let velocities = &self.melt.columns.velocities[..self.melt.len()];
            fastest = velocities.iter().map(Vector2::norm).fold(fastest, f64::max);
            sum += row.iter().sum::<f64>() / row.len() as f64;
        }
        let pressure = sum / look as f64 / (DENSITY * GRAVITY * (DEPTH - 0.5 * self.spacing));
        (pressure, fastest / (GRAVITY * DEPTH).sqrt())
    }
}
