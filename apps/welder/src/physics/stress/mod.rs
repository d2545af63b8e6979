//! Thermal stress: a thermoelastic body with yield that follows the temperatures of heat.
//!
//! Sound would cross a part some ten thousand times during a weld, and nothing of it matters: stress is in equilibrium with
//! the temperatures of the moment (quasi-static). So each step of heat gives the body a time of its own to settle in, by
//! damped motion while the temperatures go from the old ones to the new: dynamic relaxation, without a matrix. Heat does not
//! feel the shape, which changes by about 1 %; that elastic strain makes up to 1 K it feels where the scene asks for it.
//!
//! Where melt flows, the body stays on its lattice and reads there the temperatures that the moving particles bring: the melt
//! carries no stress, and what freezes begins stress-free where it freezes. The flow does not feel the deformation, which is a
//! hundredth of a spacing.

mod copies;
mod heat;
mod lattice;
mod state;

use super::{Column, Cost, Exchange, Failure, Mechanics, Physics, principal_extremes};
use crate::build::Workpiece;
use crate::model::{Model, ModelError, StressModel};
use crate::particles::Particles;
use copies::Copies;
use heat::HeatOfDeformation;
use lattice::Lattice;
use nalgebra::{SMatrix, Vector3};
use rayon::prelude::*;
use sph_integrate::StepLimit;
use sph_kernel::{Kernel, KernelKind};
use sph_neighbors::{PairReach, SearchMethod};
use sph_solid::{
    Controls, DEFAULT_STEP_FACTOR, Inelastic, Material, Motion, ReducedSound, ReferenceColumns,
    SymmetricTensor, TotalLagrangian, pressure_wave_speed,
};
use sph_thermal::phase::EnthalpyCurve;
use state::State;

/// Kernel and smoothing length over spacing that the hourglass stiffness of [`Controls::default`] is made for.
const KERNEL: KernelKind = KernelKind::Gaussian;
const SMOOTHING_RATIO: f64 = 0.8;

/// Velocities fade by this rate, in wave speeds over lengths of the part: near the critical damping of the slowest waves.
const FADING: f64 = 2.0;

/// A displacement above this many spacings is none of a body that warms and cools.
const LARGEST_DISPLACEMENT: f64 = 100.0;

/// Particles to a piece of work.
const PIECE: usize = 2048;

/// A body in the total-Lagrangian form, with the copies of its particles beyond mirror planes and clamped faces.
pub struct Stress {
    body: TotalLagrangian<3>,
    copies: Copies,
    curve: EnthalpyCurve,
    /// Where particles of the scene have gone, if melt flows.
    lattice: Option<Lattice>,
    /// The heat that deformation makes, where the scene asks for it.
    heat: Option<HeatOfDeformation>,
    state: State,
    /// Accelerations of particles and copies \[m/s²\].
    accelerations: Vec<Vector3<f64>>,
    /// Temperatures of particles and copies at the stage in hand \[K\].
    temperatures: Vec<f64>,
    /// Temperatures at the end of the step in hand \[K\].
    end_temperatures: Vec<f64>,
    /// Step of the settling \[s\], of its own time.
    step: f64,
    /// Steps of settling in a step of heat.
    steps: usize,
    /// Share of a velocity that is left after a step.
    fade: f64,
}

impl Stress {
    /// The body of `workpiece`, stress-free at its start temperatures.
    ///
    /// # Errors
    /// [`ModelError`] when the neighbour search or the solid crate refuses the particles.
    pub fn new(model: &Model, stress: &StressModel, workpiece: &Workpiece) -> Result<Self, ModelError> {
        let particles = &workpiece.particles;
        let length = SMOOTHING_RATIO * workpiece.spacing;
        let reach = Kernel::<3>::support_radius(KERNEL, length) * (1.0 + 1e-9);
        let copies = Copies::new(model, stress, workpiece, reach);
        let positions = copies.all_positions(&particles.position);
        let list = SearchMethod::default().find(&positions, PairReach::Uniform(reach))?;
        let curve = model.curves[0].clone();
        let own: Vec<f64> = particles.enthalpy.iter().map(|&enthalpy| curve.temperature(enthalpy)).collect();
        let temperatures = copies.all_scalars(&own);
        let columns = ReferenceColumns {
            positions: &positions,
            volumes: &copies.all_scalars(&particles.volume),
            masses: &copies.all_scalars(&particles.mass),
            temperatures: &temperatures,
            smoothing_lengths: &vec![length; positions.len()],
            list_starts: list.starts(),
            list_neighbors: list.indices(),
        };
        let material = Material {
            expansion: stress.expansion.clone(),
            sound: ReducedSound::none(stress.moduli),
            yield_stress: Some(stress.yield_stress.clone()),
        };
        let body = TotalLagrangian::new(&columns, KERNEL, material, Controls::default())?;
        let step = body.stable_step(DEFAULT_STEP_FACTOR);
        let crossing =
            largest_extent(model) / pressure_wave_speed(&stress.moduli, model.materials[0].density);
        let count = positions.len();
        let mut stress = Self {
            state: State::at_rest(particles.len(), count, temperatures.clone()),
            accelerations: vec![Vector3::zeros(); count],
            end_temperatures: temperatures.clone(),
            temperatures,
            step,
            steps: (stress.settings.crossings * crossing / step).ceil() as usize,
            fade: (-FADING * step / crossing).exp(),
            body,
            copies,
            curve,
            lattice: model.flow.is_some().then(|| Lattice::new(model, workpiece)),
            heat: stress.settings.heat_of_deformation.then(|| HeatOfDeformation::new(stress, particles)),
        };
        if stress.heat.is_some() {
            stress.state.traces = vec![0.0; particles.len()];
        }
        stress.accelerate();
        Ok(stress)
    }

    /// Steps of settling in each step of heat.
    pub fn steps(&self) -> usize {
        self.steps
    }

    /// Particles and the copies of them beyond mirror planes and clamped faces.
    pub fn particles(&self) -> usize {
        self.temperatures.len()
    }

    /// Directed pairs that one evaluation visits.
    pub fn pairs(&self) -> usize {
        // Once for the deformation, once for the forces, each in both directions.
        4 * self.body.stored_pairs()
    }

    /// One damped kick-drift-kick step at the temperatures of the stage in hand.
    fn settle(&mut self) {
        let (dt, fade) = (self.step, self.fade);
        let State { displacements, velocities, .. } = &mut self.state;
        let owned = velocities.len();
        (displacements[..owned].par_iter_mut(), velocities.par_iter_mut(), &self.accelerations[..owned])
            .into_par_iter()
            .with_min_len(PIECE)
            .for_each(|(displacement, velocity, acceleration)| {
                *velocity += acceleration * (0.5 * dt);
                *displacement += *velocity * dt;
            });
        self.accelerate();
        (self.state.velocities.par_iter_mut(), &self.accelerations[..owned])
            .into_par_iter()
            .with_min_len(PIECE)
            .for_each(|(velocity, acceleration)| {
                *velocity = (*velocity + acceleration * (0.5 * dt)) * fade;
            });
    }

    /// Accelerations at the present displacements and the temperatures of the stage in hand.
    fn accelerate(&mut self) {
        let State { displacements, strains, equivalents, .. } = &mut self.state;
        self.copies.reflect(displacements);
        let motion = Motion { displacements, velocities: &[], temperatures: &self.temperatures };
        let mut inelastic = Inelastic { strains, equivalents };
        self.body.accelerations(&motion, &mut inelastic, &mut self.accelerations);
        self.state.cost.sweeps += 2;
        self.state.cost.pair_visits += self.pairs() as u64;
    }

    /// Temperatures a `share` of the way from the last step's end to this one's.
    fn warm(&mut self, share: f64) {
        (self.temperatures.par_iter_mut(), &self.state.temperatures, &self.end_temperatures)
            .into_par_iter()
            .with_min_len(PIECE)
            .for_each(|(now, start, end)| *now = start + share * (end - start));
    }

    /// Stress of the particles in true units \[Pa\].
    fn stresses(&self) -> Vec<SymmetricTensor<3>> {
        let count = self.temperatures.len();
        let (mut in_plane, mut out_of_plane) = (vec![SMatrix::zeros(); count], vec![0.0; count]);
        self.body.stresses(&self.temperatures, &self.state.strains, &mut in_plane, &mut out_of_plane);
        in_plane.truncate(self.state.velocities.len());
        in_plane.into_iter().map(|in_plane| SymmetricTensor { in_plane, out_of_plane: 0.0 }).collect()
    }

    /// What the particles of the scene show of a column of the body's.
    fn shown<T: Copy>(&self, column: Vec<T>) -> Vec<T> {
        match &self.lattice {
            Some(lattice) => lattice.shown(&column),
            None => column,
        }
    }

    /// Gives the particles the heat of deformation in this step; where melt flows, those that a place of the body
    /// reads its temperature from share its heat.
    fn warm_particles(&mut self, particles: &mut Particles<3>) {
        let traces: Vec<f64> = match &self.heat {
            Some(_) => self.stresses().iter().map(|stress| stress.in_plane.trace()).collect(),
            None => return,
        };
        let Some(heat) = &mut self.heat else { return };
        let temperatures = [&self.state.temperatures[..], &self.end_temperatures[..]];
        let heats = heat.of_step(temperatures, [&self.state.traces, &traces]);
        self.state.deformed += heats.iter().sum::<f64>();
        let mut warm = |i: usize, heat: f64| particles.enthalpy[i] += heat / particles.mass[i];
        match &mut self.lattice {
            Some(lattice) => lattice.spread(&heats, warm),
            None => heats.iter().enumerate().for_each(|(i, &heat)| warm(i, heat)),
        }
        self.state.traces = traces;
    }

    /// What keeps the run from going on: a displacement that is no number, or so large that it cannot be elastic.
    fn problem(&self, particles: &Particles<3>, time: f64, spacing: f64) -> Option<Failure> {
        let owned = &self.state.displacements[..particles.len()];
        let wild = |u: &Vector3<f64>| {
            let farthest = u.amax();
            !farthest.is_finite() || farthest > LARGEST_DISPLACEMENT * spacing
        };
        let at = owned.iter().position(wild)?;
        Some(Failure {
            physics: "stress",
            what: format!("a particle has moved by {:.2e} m", owned[at].norm()),
            time,
            at: Some(particles.position[at].into()),
            advice: "try more crossings, a finer spacing, or a wider range from solidus to liquidus".into(),
        })
    }
}

impl Physics<3> for Stress {
    fn name(&self) -> &'static str {
        "stress"
    }

    /// Stress takes steps of its own within those of heat.
    fn step_limit(&self, _time: f64) -> StepLimit {
        StepLimit { name: "stress", dt_s: f64::INFINITY }
    }

    fn next_event(&self, _time: f64) -> Option<f64> {
        None
    }

    fn advance(&mut self, particles: &mut Particles<3>, time: f64, step: f64) -> Result<f64, Failure> {
        let own = &mut self.end_temperatures[..particles.len()];
        match &mut self.lattice {
            Some(lattice) => lattice.read(|i| self.curve.temperature(particles.enthalpy[i]), own),
            None => own.par_iter_mut().zip(&particles.enthalpy).for_each(|(temperature, &enthalpy)| {
                *temperature = self.curve.temperature(enthalpy);
            }),
        }
        self.copies.copy(&mut self.end_temperatures);
        for k in 1..=self.steps {
            self.warm(k as f64 / self.steps as f64);
            self.settle();
            if let Some(heat) = &mut self.heat {
                heat.add_yield(self.body.plastic_works());
            }
        }
        self.warm_particles(particles);
        self.state.temperatures.copy_from_slice(&self.end_temperatures);
        match self.problem(particles, time + step, particles.spacing[0]) {
            Some(failure) => Err(failure),
            None => Ok(step),
        }
    }

    fn rearrange(&mut self, _model: &Model, workpiece: &Workpiece) -> Result<(), ModelError> {
        if let Some(lattice) = &mut self.lattice {
            lattice.follow(workpiece);
        }
        Ok(())
    }

    fn warms(&self) -> bool {
        self.heat.is_some()
    }

    fn energy(&self) -> Exchange {
        Exchange { made: self.state.deformed, ..Exchange::default() }
    }

    fn cost(&self) -> Cost {
        self.state.cost
    }

    fn mechanics(&self) -> Option<Mechanics> {
        let owned = self.state.velocities.len();
        let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
        let speeds = self.state.velocities.iter().map(|v| v.norm_squared());
        let kinetic: f64 = speeds.zip(self.body.masses()).map(|(square, mass)| 0.5 * mass * square).sum();
        let strain = self.body.elastic_energy(owned, &self.temperatures, &self.state.strains);
        let stresses = self.stresses();
        Some(Mechanics {
            strain,
            thermoelastic: self
                .heat
                .as_ref()
                .map_or(0.0, |heat| heat.stored(&self.temperatures, &self.state.traces)),
            deformed: self.state.deformed,
            unrest: kinetic / strain.max(f64::MIN_POSITIVE),
            largest_displacement: largest(&mut self.state.displacements[..owned].iter().map(|u| u.norm())),
            largest_von_mises: largest(&mut stresses.iter().map(SymmetricTensor::von_mises)),
            principal_stresses: Some(principal_extremes(&stresses)),
            largest_plastic_strain: largest(&mut self.state.equivalents[..owned].iter().copied()),
            ..Mechanics::default()
        })
    }

    fn columns(&self) -> Vec<(&'static str, Column<3>)> {
        let owned = self.state.velocities.len();
        let stresses = self.stresses();
        let von_mises = stresses.iter().map(SymmetricTensor::von_mises).collect();
        let principal = stresses.iter().map(SymmetricTensor::principal).collect();
        vec![
            ("displacement_m", Column::Vector(self.shown(self.state.displacements[..owned].to_vec()))),
            ("von_mises_pa", Column::Scalar(self.shown(von_mises))),
            ("principal_stress_pa", Column::Triple(self.shown(principal))),
            ("plastic_strain", Column::Scalar(self.shown(self.state.equivalents[..owned].to_vec()))),
        ]
    }

    fn save(&self) -> Vec<u8> {
        self.state.save(&self.accelerations)
    }

    fn restore(&mut self, _particles: &Particles<3>, saved: &[u8]) -> Result<(), String> {
        let (mut state, accelerations) = State::restore(saved, &self.state)?;
        self.temperatures.copy_from_slice(&state.temperatures);
        self.end_temperatures.copy_from_slice(&state.temperatures);
        // The body finds its deformation from the displacements again; the saved strains and forces hold.
        self.state = state.clone();
        self.accelerate();
        std::mem::swap(&mut self.state, &mut state);
        self.accelerations = accelerations;
        Ok(())
    }
}

/// Longest side of the whole part, mirror image counted \[m\].
fn largest_extent(model: &Model) -> f64 {
    let mirrored = model.mirrored();
    let whole = |axis: usize| {
        let doubled = mirrored.get(axis).is_some_and(|ends| ends[0] || ends[1]);
        if doubled { 2.0 * model.size[axis] } else { model.size[axis] }
    };
    (0..3).map(whole).fold(0.0, f64::max)
}
