//! How physics are composed.
//!
//! A scene is a list of [`Physics`]: what it does not name is not built, stored or computed. Each module owns its private
//! columns, says its own step limit, and reports to the ledger; the run loop knows none of them by name. To add one:
//! its laws in a crate, one file here, one variant in the case's enum (see CONTRIBUTING).

pub mod flow;
pub mod heat;
pub mod rows;
pub mod stress;

use crate::build::Workpiece;
use crate::model::{Model, ModelError};
use crate::particles::Particles;
use nalgebra::SVector;
use serde::{Deserialize, Serialize};
use sph_integrate::StepLimit;
use sph_solid::SymmetricTensor;

/// One physics of a scene.
pub trait Physics<const D: usize> {
    /// Its name in messages, counters and checkpoints.
    fn name(&self) -> &'static str;

    /// The longest step that it takes from `time` \[s\], and what limits it.
    fn step_limit(&self, time: f64) -> StepLimit;

    /// The next time after `time` that a step must end on, because something changes there \[s\].
    fn next_event(&self, time: f64) -> Option<f64>;

    /// Advances the particles from `time` by `step` \[s\] or less, and returns the step taken.
    ///
    /// # Errors
    /// [`Failure`] when the state is no longer one that physics knows.
    fn advance(&mut self, particles: &mut Particles<D>, time: f64, step: f64) -> Result<f64, Failure>;

    /// Whether its last step moved particles, so that neighbours must be found anew.
    fn moves(&self) -> bool {
        false
    }

    /// Whether its last step warmed particles and left them where they are.
    fn warms(&self) -> bool {
        false
    }

    /// Takes up the enthalpies of particles, after another physics has warmed them.
    fn take_heat(&mut self, _particles: &Particles<D>) {}

    /// Takes up the new places and enthalpies of particles, after another physics has moved them.
    ///
    /// # Errors
    /// [`ModelError`] when neighbours or weights cannot be found anew.
    fn rearrange(&mut self, _model: &Model, _workpiece: &Workpiece) -> Result<(), ModelError> {
        Ok(())
    }

    /// Its share of the energy ledger so far \[J\].
    fn energy(&self) -> Exchange;

    /// What it has cost so far.
    fn cost(&self) -> Cost;

    /// Flow, stress and deformation of the moment, where this physics has them.
    fn mechanics(&self) -> Option<Mechanics> {
        None
    }

    /// Columns of its own that frames and pictures can show, by name with unit.
    fn columns(&self) -> Vec<(&'static str, Column<D>)> {
        Vec::new()
    }

    /// Its private state beyond the shared columns, for a checkpoint.
    fn save(&self) -> Vec<u8>;

    /// Takes up a state that [`save`](Self::save) gave, bit for bit; the shared columns are restored already.
    ///
    /// # Errors
    /// A message when `state` is not of this physics.
    fn restore(&mut self, particles: &Particles<D>, state: &[u8]) -> Result<(), String>;
}

/// A column of particle values that exists only to be shown.
#[derive(Debug, Clone, PartialEq)]
pub enum Column<const D: usize> {
    /// One number a particle.
    Scalar(Vec<f64>),
    /// One vector a particle.
    Vector(Vec<SVector<f64, D>>),
    /// Three numbers a particle in any dimension, such as principal stresses.
    Triple(Vec<[f64; 3]>),
    /// A small whole number a particle: a phase, a flag.
    Byte(Vec<u8>),
}

/// Flow, stress and deformation of the part, mirror images not counted; zero where they are not computed.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Mechanics {
    /// Kinetic energy of the flow \[J\].
    pub kinetic: f64,
    /// Energy of the compression of the melt \[J\].
    pub compression: f64,
    /// What forces have done to the melt so far.
    pub work: Work,
    /// Speed of the fastest particle \[m/s\].
    pub largest_speed: f64,
    /// Artificial speed of sound of the melt \[m/s\].
    pub sound_speed: f64,
    /// Elastic energy \[J\].
    pub strain: f64,
    /// Energy \[J\] that a stressed body holds beside that and its heat, alpha T tr(sigma) over its volume; zero where deformation takes
    /// and makes no heat.
    pub thermoelastic: f64,
    /// Heat \[J\] that deformation has made so far.
    pub deformed: f64,
    /// Kinetic energy of a body that settles over its elastic energy \[-\]: how far it is from equilibrium.
    pub unrest: f64,
    /// Largest displacement \[m\].
    pub largest_displacement: f64,
    /// Largest von Mises stress \[Pa\].
    pub largest_von_mises: f64,
    /// Largest and smallest principal stress \[Pa\], where there is stress; tension is positive.
    pub principal_stresses: Option<[f64; 2]>,
    /// Largest equivalent plastic strain \[-\].
    pub largest_plastic_strain: f64,
}

impl Mechanics {
    /// What two physics have, of which each computes numbers of its own.
    #[must_use]
    pub fn with(self, other: Self) -> Self {
        Self {
            kinetic: self.kinetic + other.kinetic,
            compression: self.compression + other.compression,
            work: self.work.with(other.work),
            largest_speed: self.largest_speed.max(other.largest_speed),
            sound_speed: self.sound_speed.max(other.sound_speed),
            strain: self.strain + other.strain,
            thermoelastic: self.thermoelastic + other.thermoelastic,
            deformed: self.deformed + other.deformed,
            unrest: self.unrest.max(other.unrest),
            largest_displacement: self.largest_displacement.max(other.largest_displacement),
            largest_von_mises: self.largest_von_mises.max(other.largest_von_mises),
            principal_stresses: self.principal_stresses.or(other.principal_stresses),
            largest_plastic_strain: self.largest_plastic_strain.max(other.largest_plastic_strain),
        }
    }
}

/// Largest and smallest principal stress of all \[Pa\]; no numbers without any.
pub(crate) fn principal_extremes<const D: usize>(stresses: &[SymmetricTensor<D>]) -> [f64; 2] {
    let principals = stresses.iter().map(SymmetricTensor::principal);
    principals.fold([f64::NAN; 2], |[most, least], [first, _, last]| [most.max(first), least.min(last)])
}

/// What forces have done to the melt \[J\], mirror images not counted.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Work {
    /// Work of surface tension.
    pub tension: f64,
    /// Work of the change of tension with temperature.
    pub marangoni: f64,
    /// Work of gravity.
    pub gravity: f64,
    /// Work of expansion against pressure: heat that warm melt gives to motion and compression.
    pub expansion: f64,
    /// Heat made by friction, artificial viscosity included.
    pub dissipated: f64,
    /// Motion and compression that melt gave up when it froze; heat from then on.
    pub frozen: f64,
}

impl Work {
    /// Both together.
    #[must_use]
    pub fn with(self, other: Self) -> Self {
        Self {
            tension: self.tension + other.tension,
            marangoni: self.marangoni + other.marangoni,
            gravity: self.gravity + other.gravity,
            expansion: self.expansion + other.expansion,
            dissipated: self.dissipated + other.dissipated,
            frozen: self.frozen + other.frozen,
        }
    }

    /// What the melt holds by now, in motion and compression, if its scheme loses nothing.
    pub fn kept(&self) -> f64 {
        self.tension + self.marangoni + self.gravity - self.heat()
    }

    /// Heat that the melt's motion and compression have turned into, less what they were given by heat.
    pub fn heat(&self) -> f64 {
        self.dissipated + self.frozen - self.expansion
    }
}

/// Energy that crossed the border of the particles \[J\], of the modelled part.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Exchange {
    /// Light sent out by the laser.
    pub emitted: f64,
    /// Light absorbed.
    pub absorbed: f64,
    /// Light reflected.
    pub reflected: f64,
    /// Light that missed the part.
    pub missed: f64,
    /// Heat given to faces of given flux or temperature (negative: taken up) and lost to the surroundings.
    pub lost: f64,
    /// Heat made of other forms of energy inside the part.
    pub made: f64,
}

impl Exchange {
    /// Adds what crossed in one step.
    pub fn add(&mut self, step: &Exchange) {
        self.emitted += step.emitted;
        self.absorbed += step.absorbed;
        self.reflected += step.reflected;
        self.missed += step.missed;
        self.lost += step.lost;
        self.made += step.made;
    }
}

/// Work done, in numbers that do not depend on the machine.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Cost {
    /// Evaluations of the right-hand side.
    pub sweeps: u64,
    /// Directed pairs visited.
    pub pair_visits: u64,
    /// Steps that were taken back because their error was too large.
    pub rejected_steps: u64,
    /// Steps of the melt within those of the run.
    pub melt_steps: u64,
}

/// Why a run could not go on.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{physics}: {what} at t = {time:.6e} s{}; {advice}", at.map(|p| format!(", x = {p:?} m")).unwrap_or_default())]
pub struct Failure {
    /// The physics that stopped.
    pub physics: &'static str,
    /// What it found.
    pub what: String,
    /// When \[s\].
    pub time: f64,
    /// Where \[m\].
    pub at: Option<[f64; 3]>,
    /// What to try.
    pub advice: String,
}
