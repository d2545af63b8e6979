//! Flow of the melt in a solid that does not move: particles that have melted are stepped with the sound of the melt between
//! two steps of heat, at the temperatures of the later one; all others are its walls.
//!
//! A particle melts and freezes in place. It carries its enthalpy with it, so that flow changes no energy of heat; what it takes
//! is the new neighbourhood, which heat finds anew after each step ([`Physics::rearrange`]).

mod melt;
mod state;

use super::{Column, Cost, Exchange, Failure, Mechanics, Physics};
use crate::build::{Workpiece, symmetry_planes};
use crate::case::scene::FlowSchedule;
use crate::model::{FlowModel, Model, ModelError};
use crate::particles::Particles;
use melt::Melt;
use nalgebra::Vector3;
use sph_fluid::{FluidControls, Renewal, Tait};
use sph_integrate::StepLimit;
use sph_kernel::KernelKind;
use sph_thermal::phase::EnthalpyCurve;
use state::State;

/// Smoothing length over spacing that the constants of the free surface are made for.
pub const SMOOTHING_RATIO: f64 = 1.5;

/// Density diffusion of the melt.
const DENSITY_DIFFUSION: f64 = 0.1;

/// Exponent of Tait's equation.
const TAIT_EXPONENT: f64 = 7.0;

/// Gravity \[m/s²\].
const GRAVITY: f64 = 9.81;

/// A particle melts where this share of it is liquid, and freezes where only the other is: between them it stays what it is.
const MELTS_AT: f64 = 0.6;
const FREEZES_AT: f64 = 0.4;

/// The fastest particle goes at most this share of a spacing between two steps of heat.
const LARGEST_MOVE: f64 = 0.25;

/// A melt particle this many spacings outside the part has left it; a crown is lower.
const FARTHEST_OUTSIDE: f64 = 10.0;

/// The melt of a scene.
pub struct Flow {
    melt: Melt,
    state: State,
    curve: EnthalpyCurve,
    spacing: f64,
    /// Whether heat takes the steps of the melt.
    together: bool,
    /// Low and high corner of the part \[m\].
    bounds: [Vector3<f64>; 2],
    /// Artificial speed of sound \[m/s\].
    sound_speed: f64,
    temperatures: Vec<f64>,
}

impl Flow {
    /// The melt of `workpiece`: none, if it starts cold.
    ///
    /// # Errors
    /// [`ModelError`] when the fluid crate refuses a constant.
    pub fn new(model: &Model, flow: &FlowModel, workpiece: &Workpiece) -> Result<Self, ModelError> {
        let (density, spacing) = (model.materials[0].density, workpiece.spacing);
        let sound_speed = flow.sound_speed(model);
        let kernel = KernelKind::WendlandC2.with_smoothing_length(SMOOTHING_RATIO * spacing);
        let controls = FluidControls {
            dynamic_viscosity: flow.viscosity,
            artificial_viscosity: flow.settings.artificial_viscosity,
            density_diffusion: DENSITY_DIFFUSION,
            body_acceleration: Vector3::new(0.0, 0.0, -GRAVITY),
            surface_tension: Some(flow.tension),
            renewal: Some(Renewal::default()),
            ..FluidControls::new(kernel, Tait::new(density, sound_speed, TAIT_EXPONENT)?)
        };
        let count = workpiece.particles.len();
        Ok(Self {
            melt: Melt::new(controls, spacing, symmetry_planes(workpiece.low, workpiece.high, &model.faces))?,
            state: State::at_rest(count, density),
            curve: model.curves[0].clone(),
            spacing,
            together: flow.settings.schedule == FlowSchedule::Together,
            bounds: [workpiece.low.into(), workpiece.high.into()],
            sound_speed,
            temperatures: vec![0.0; count],
        })
    }

    /// Lets particles melt and freeze by their enthalpy; what freezes stands still and forgets its pressure.
    fn change_phase(&mut self, particles: &Particles<3>) {
        for i in 0..particles.len() {
            let liquid = self.curve.liquid_fraction(particles.enthalpy[i]);
            let molten = if self.state.molten[i] { liquid > FREEZES_AT } else { liquid >= MELTS_AT };
            if molten != self.state.molten[i] {
                self.state.molten[i] = molten;
                self.state.velocities[i] = Vector3::zeros();
                self.state.densities[i] = self.melt.reference_density();
            }
        }
    }

    /// What keeps the run from going on: melt outside the part, or too wild to be `stepped`.
    fn problem(&self, particles: &Particles<3>, time: f64, stepped: bool) -> Option<Failure> {
        let finite = |i: usize| particles.position[i].iter().all(|x| x.is_finite());
        let outside = |&i: &usize| {
            let [below, above] =
                [self.bounds[0] - particles.position[i], particles.position[i] - self.bounds[1]];
            !finite(i) || below.max().max(above.max()) > FARTHEST_OUTSIDE * self.spacing
        };
        let speed = |i: &usize| self.state.velocities[*i].norm_squared();
        let all = 0..particles.len();
        let fastest = || all.clone().max_by(|i, j| speed(i).total_cmp(&speed(j)));
        let at = all.clone().find(outside).or_else(|| if stepped { None } else { fastest() })?;
        let what = match (finite(at), stepped) {
            (false, _) => "the melt's positions are no numbers any more",
            (true, true) => "melt has left the part",
            (true, false) => "the melt has become too fast, or its forces too strong, to be stepped",
        };
        Some(Failure {
            physics: "flow",
            what: what.into(),
            time,
            at: finite(at).then(|| particles.position[at].into()),
            advice: "try a larger viscosity_factor or sound_speed_m_s, more artificial_viscosity, or a finer spacing"
                .into(),
        })
    }
}

impl Physics<3> for Flow {
    fn name(&self) -> &'static str {
        "flow"
    }

    /// Steps of heat are so short that melt stays among the neighbours that heat knows.
    fn step_limit(&self, _time: f64) -> StepLimit {
        let fastest = self.state.largest_speed();
        let dt_s = match (self.state.any_molten(), self.together) {
            (false, _) => f64::INFINITY,
            (true, true) => self.melt.steady_step(fastest),
            (true, false) => LARGEST_MOVE * self.spacing / fastest.max(1e-3 * self.sound_speed),
        };
        StepLimit { name: "flow", dt_s }
    }

    fn next_event(&self, _time: f64) -> Option<f64> {
        None
    }

    fn advance(&mut self, particles: &mut Particles<3>, time: f64, step: f64) -> Result<f64, Failure> {
        self.change_phase(particles);
        for (temperature, &enthalpy) in self.temperatures.iter_mut().zip(&particles.enthalpy) {
            *temperature = self.curve.temperature(enthalpy);
        }
        let stepped = self.melt.advance(particles, &mut self.state, &self.temperatures, step);
        match self.problem(particles, time + step, stepped) {
            Some(failure) => Err(failure),
            None => Ok(step),
        }
    }

    fn moves(&self) -> bool {
        self.state.any_molten()
    }

    fn energy(&self) -> Exchange {
        Exchange::default()
    }

    fn cost(&self) -> Cost {
        self.state.cost
    }

    fn mechanics(&self) -> Option<Mechanics> {
        let squares = self.state.velocities.iter().map(Vector3::norm_squared);
        let kinetic = 0.5 * self.melt.mass() * squares.sum::<f64>();
        Some(Mechanics { kinetic, largest_speed: self.state.largest_speed(), ..Mechanics::default() })
    }

    fn columns(&self) -> Vec<(&'static str, Column<3>)> {
        let molten = self.state.molten.iter().map(|&molten| f64::from(u8::from(molten))).collect();
        vec![
            ("velocity_m_s", Column::Vector(self.state.velocities.clone())),
            ("marangoni_force_n", Column::Vector(self.state.marangoni.clone())),
            ("pressure_pa", Column::Scalar(self.state.pressures.clone())),
            ("is_melt", Column::Scalar(molten)),
        ]
    }

    fn save(&self) -> Vec<u8> {
        self.state.save()
    }

    fn restore(&mut self, _particles: &Particles<3>, saved: &[u8]) -> Result<(), String> {
        self.state = State::restore(saved, &self.state)?;
        Ok(())
    }
}
