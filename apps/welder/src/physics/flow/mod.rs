//! Flow of the melt in a solid that does not move: particles that have melted are stepped with the sound of the melt between
//! two steps of heat, at the temperatures of the later one; all others are its walls.
//!
//! A particle melts and freezes in place. It carries its enthalpy with it, and gets the heat that friction makes in it; what heat
//! takes of its motion is the new neighbourhood, found anew after each step ([`Physics::rearrange`]).

mod melt;
mod state;

use super::{Column, Cost, Exchange, Failure, Mechanics, Physics};
use crate::build::{Workpiece, symmetry_planes};
use crate::case::scene::FlowSchedule;
use crate::model::{FlowModel, GRAVITY, Model, ModelError, TensionLaw};
use crate::particles::Particles;
use melt::{Columns, Melt};
use nalgebra::Vector3;
use sph_fluid::{FluidControls, Renewal, SOUND_SPEED_RATIO, Tait};
use sph_integrate::StepLimit;
use sph_kernel::KernelKind;
use sph_thermal::phase::{EnthalpyCurve, Table};
use state::State;

/// Smoothing length over spacing that the constants of the free surface are made for.
pub const SMOOTHING_RATIO: f64 = 1.5;

/// Density diffusion of the melt.
const DENSITY_DIFFUSION: f64 = 0.1;

/// Exponent of Tait's equation.
const TAIT_EXPONENT: f64 = 7.0;

/// A particle melts where this share of it is liquid, and freezes where only the other is: between them it stays what it is.
const MELTS_AT: f64 = 0.6;
const FREEZES_AT: f64 = 0.4;

/// The fastest particle goes at most this share of a spacing between two steps of heat.
pub(crate) const LARGEST_MOVE: f64 = 0.25;

/// Where the melt gets faster than its sound allows, the sound is made faster than that needs by this factor, so that it is not
/// changed in each step.
const SOUND_MARGIN: f64 = 1.1;

/// Sound follows the speed that all but this share of the melt have: a splash of a few particles is no flow.
const FLOWING: f64 = 0.05;

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
    /// Whether the sound follows the flow: where the scene does not set it.
    sound_follows: bool,
    /// Whether anything was molten in the last step.
    moved: bool,
    /// Low and high corner of the part \[m\].
    bounds: [Vector3<f64>; 2],
    /// Viscosity and tension, as far as they are not constants of the melt.
    viscosity: Option<Table>,
    tension: Option<TensionLaw>,
    columns: Columns,
}

impl Flow {
    /// The melt of `workpiece`: none, if it starts cold.
    ///
    /// # Errors
    /// [`ModelError`] when the fluid crate refuses a constant.
    pub fn new(model: &Model, flow: &FlowModel, workpiece: &Workpiece) -> Result<Self, ModelError> {
        let (density, spacing) = (model.materials[0].density, workpiece.spacing);
        let sound_speed = flow.first_sound_speed(model);
        let kernel = KernelKind::WendlandC2.with_smoothing_length(SMOOTHING_RATIO * spacing);
        let controls = FluidControls {
            dynamic_viscosity: flow.viscosity.largest(),
            artificial_viscosity: flow.settings.artificial_viscosity,
            density_diffusion: DENSITY_DIFFUSION,
            body_acceleration: Vector3::new(0.0, 0.0, -GRAVITY),
            surface_tension: Some(flow.tension.for_steps()?),
            viscous_heating: true,
            thermal_expansion: flow.expansion,
            renewal: Some(Renewal::default()),
            ..FluidControls::new(kernel, Tait::new(density, sound_speed, TAIT_EXPONENT)?)
        };
        let count = workpiece.particles.len();
        Ok(Self {
            melt: Melt::new(controls, spacing, symmetry_planes(workpiece.low, workpiece.high, &model.faces))?,
            state: State::at_rest(count, density, sound_speed),
            curve: model.curves[0].clone(),
            spacing,
            together: flow.settings.schedule == FlowSchedule::Together,
            sound_follows: flow.settings.sound_speed_m_s.is_none(),
            moved: false,
            bounds: [workpiece.low.into(), workpiece.high.into()],
            viscosity: (!flow.viscosity.is_constant()).then(|| flow.viscosity.clone()),
            tension: matches!(flow.tension, TensionLaw::Table(_)).then(|| flow.tension.clone()),
            columns: Columns { temperatures: vec![0.0; count], ..Columns::default() },
        })
    }

    /// Lets particles melt and freeze by their enthalpy; what freezes stands still and forgets its pressure, and the energy of both
    /// is heat.
    fn change_phase(&mut self, particles: &mut Particles<3>) {
        for i in 0..particles.len() {
            let liquid = self.curve.liquid_fraction(particles.enthalpy[i]);
            let molten = if self.state.molten[i] { liquid > FREEZES_AT } else { liquid >= MELTS_AT };
            if molten == self.state.molten[i] {
                continue;
            }
            if self.state.molten[i] {
                let energy = 0.5 * self.state.velocities[i].norm_squared()
                    + self.melt.compression(self.state.densities[i], self.state.temperatures[i]);
                particles.enthalpy[i] += energy;
                self.state.work.frozen += particles.mass[i] * energy;
            }
            let temperature = self.curve.temperature(particles.enthalpy[i]);
            self.state.molten[i] = molten;
            self.state.velocities[i] = Vector3::zeros();
            self.state.temperatures[i] = temperature;
            self.state.densities[i] = self.melt.density_at(temperature);
        }
    }

    /// Makes the sound of the melt at least ten times as fast as the melt, at the same pressures.
    fn follow_flow(&mut self) -> Result<(), sph_fluid::Error> {
        let needed = SOUND_SPEED_RATIO * self.state.flow_speed(FLOWING);
        if self.sound_follows && needed > self.state.sound_speed && needed.is_finite() {
            self.state.sound_speed = SOUND_MARGIN * needed;
        }
        let State { molten, densities, temperatures, sound_speed, .. } = &mut self.state;
        let melt = densities.iter_mut().zip(temperatures.iter()).zip(molten.iter());
        self.melt.set_sound_speed(*sound_speed, melt.filter_map(|(of, molten)| molten.then_some(of)))
    }

    /// Temperatures of all particles, and what depends on them.
    fn update_columns(&mut self, particles: &Particles<3>) {
        let Columns { temperatures, viscosities, tensions } = &mut self.columns;
        for (temperature, &enthalpy) in temperatures.iter_mut().zip(&particles.enthalpy) {
            *temperature = self.curve.temperature(enthalpy);
        }
        if let Some(viscosity) = &self.viscosity {
            viscosities.clear();
            viscosities.extend(temperatures.iter().map(|&temperature| viscosity.at(temperature)));
        }
        if let Some(tension) = &self.tension {
            tensions.clear();
            tensions.extend(temperatures.iter().map(|&temperature| tension.at(temperature)));
        }
    }

    fn refused(&self, time: f64, error: &sph_fluid::Error) -> Failure {
        let advice = "set sound_speed_m_s of Flow".into();
        Failure { physics: "flow", what: format!("the sound of the melt: {error}"), time, at: None, advice }
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
            (true, false) => LARGEST_MOVE * self.spacing / fastest.max(1e-3 * self.state.sound_speed),
        };
        StepLimit { name: "flow", dt_s }
    }

    fn next_event(&self, _time: f64) -> Option<f64> {
        None
    }

    fn advance(&mut self, particles: &mut Particles<3>, time: f64, step: f64) -> Result<f64, Failure> {
        let was_molten = self.state.any_molten();
        self.change_phase(particles);
        self.moved = was_molten || self.state.any_molten();
        self.follow_flow().map_err(|error| self.refused(time, &error))?;
        self.update_columns(particles);
        let stepped = self.melt.advance(particles, &mut self.state, &self.columns, step);
        match self.problem(particles, time + step, stepped) {
            Some(failure) => Err(failure),
            None => Ok(step),
        }
    }

    fn moves(&self) -> bool {
        self.moved
    }

    fn energy(&self) -> Exchange {
        Exchange { made: self.state.work.heat(), ..Exchange::default() }
    }

    fn cost(&self) -> Cost {
        self.state.cost
    }

    fn mechanics(&self) -> Option<Mechanics> {
        // Solid is at rest and without pressure.
        let melt = || (0..self.state.molten.len()).filter(|&i| self.state.molten[i]);
        let squares = melt().map(|i| self.state.velocities[i].norm_squared());
        let compressions =
            melt().map(|i| self.melt.compression(self.state.densities[i], self.state.temperatures[i]));
        Some(Mechanics {
            kinetic: 0.5 * self.melt.mass() * squares.sum::<f64>(),
            compression: self.melt.mass() * compressions.sum::<f64>(),
            work: self.state.work,
            largest_speed: self.state.largest_speed(),
            sound_speed: self.state.sound_speed,
            ..Mechanics::default()
        })
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
        // The densities are those of this sound already.
        self.melt
            .set_sound_speed(self.state.sound_speed, std::iter::empty())
            .map_err(|error| format!("flow: {error}"))
    }
}
