//! The bodies of a scene in one form or the other.

use super::model::{Numerics, SolidModel};
use nalgebra::SVector;
use sph_neighbors::{PairReach, SearchMethod};
use sph_solid::{Error, SolidPatch, SolidStart, SymmetricTensor, UpdatedPatch};

/// Particles nearer than this many spacings hang together.
const LINK: f64 = 1.7;

/// Columns of all bodies with the sweep that drives them.
pub(super) enum Patch<const D: usize> {
    /// Gradients at present positions; bodies meet as their kernels do.
    Updated(Box<UpdatedPatch<D>>),
    /// Gradients at the positions of the start; bodies meet by contact.
    Total(Box<SolidPatch<D>>),
}

/// Neighbours for the patch. Positions that are no numbers any more find nobody; the run is stopped after the stride.
fn find<const D: usize>(positions: &[SVector<f64, D>], reach: f64) -> (Vec<usize>, Vec<u32>) {
    let found = SearchMethod::default().find(positions, PairReach::Uniform(reach));
    found.map_or_else(
        |_| (vec![0; positions.len() + 1], Vec::new()),
        |list| (list.starts().to_vec(), list.indices().to_vec()),
    )
}

/// The value of one of the forms, which both have.
macro_rules! either {
    ($patch:expr, $inner:ident => $value:expr) => {
        match $patch {
            Patch::Updated($inner) => $value,
            Patch::Total($inner) => $value,
        }
    };
}

impl<const D: usize> Patch<D> {
    /// At rest at the start of the model, held where it says so.
    pub fn new(model: &SolidModel<D>) -> Result<Self, Error> {
        let (positions, material) = (model.positions.clone(), model.material.clone());
        let spacing = model.case.scene.spacing_m;
        let mut patch = match model.numerics {
            Numerics::Updated(controls) => {
                Patch::Updated(Box::new(UpdatedPatch::new(positions, material, controls, find)?))
            }
            Numerics::Total => {
                let smoothing_ratio = model.kernel.smoothing_length() / spacing;
                let start = SolidStart { smoothing_ratio, ..SolidStart::new(positions, spacing, material) };
                let mut patch = SolidPatch::new(start, find)?;
                patch.let_meet(find);
                Patch::Total(Box::new(patch))
            }
        };
        patch.velocities_mut().copy_from_slice(&model.velocities);
        patch.drive(model);
        Ok(patch)
    }

    /// Moves what is held as the model says, and counts the work of that from here.
    fn drive(&mut self, model: &SolidModel<D>) {
        let held: Vec<usize> = (0..model.held.len()).filter(|&i| model.held[i]).collect();
        let velocities: Vec<SVector<f64, D>> = held.iter().map(|&i| model.velocities[i]).collect();
        let velocity = {
            let held = held.clone();
            move |i: usize, _time: f64| {
                held.binary_search(&i).map_or_else(|_| SVector::zeros(), |at| velocities[at])
            }
        };
        either!(self, patch => patch.drive(held, velocity));
    }

    /// Makes the columns the whole state: lists are made anew, then one evaluation; work is counted from here.
    pub fn renew(&mut self, model: &SolidModel<D>) -> Result<(), Error> {
        match self {
            Patch::Updated(old) => {
                let (positions, material) = (std::mem::take(&mut old.positions), model.material.clone());
                let Numerics::Updated(controls) = model.numerics else { unreachable!("the form stays") };
                let mut fresh = UpdatedPatch::new(positions, material, controls, find)?;
                fresh.velocities = std::mem::take(&mut old.velocities);
                fresh.temperatures = std::mem::take(&mut old.temperatures);
                fresh.densities = std::mem::take(&mut old.densities);
                fresh.deviators = std::mem::take(&mut old.deviators);
                fresh.equivalents = std::mem::take(&mut old.equivalents);
                **old = fresh;
                old.evaluate(0.0);
            }
            // Its pairs never change, and contact does not depend on when its list was made.
            Patch::Total(patch) => patch.evaluate(),
        }
        self.drive(model);
        Ok(())
    }

    /// Work of what moves particles since it was made or renewed \[J; J/m in the plane\].
    pub fn driven_work(&self) -> f64 {
        either!(self, patch => patch.driven_work())
    }

    /// Lets what moves freely keep a share of its velocity.
    pub fn fade(&mut self, kept: f64) {
        either!(self, patch => {
            for (velocity, free) in patch.velocities.iter_mut().zip(&patch.free) {
                *velocity -= velocity.component_mul(free) * (1.0 - kept);
            }
        });
    }

    /// One kick-drift-kick step \[s\].
    pub fn step(&mut self, dt: f64) {
        either!(self, patch => patch.step(dt));
    }

    /// `factor` h/c_P \[s\].
    pub fn stable_step(&self, factor: f64) -> f64 {
        match self {
            Patch::Updated(patch) => patch.stable_step(factor),
            Patch::Total(patch) => patch.body().stable_step(factor),
        }
    }

    /// Directed pairs that were visited since it was made or renewed.
    pub fn pair_visits(&self) -> u64 {
        either!(self, patch => patch.pair_visits())
    }

    /// Positions \[m\].
    pub fn positions(&self) -> &[SVector<f64, D>] {
        match self {
            Patch::Updated(patch) => &patch.positions,
            Patch::Total(patch) => patch.places(),
        }
    }

    /// Velocities \[m/s\].
    pub fn velocities(&self) -> &[SVector<f64, D>] {
        either!(self, patch => &patch.velocities)
    }

    /// Velocities \[m/s\], to be changed.
    pub fn velocities_mut(&mut self) -> &mut [SVector<f64, D>] {
        either!(self, patch => &mut patch.velocities)
    }

    /// Adds a change to all velocities \[m/s\], where components are free.
    pub fn push(&mut self, change: &SVector<f64, D>) {
        either!(self, patch => {
            for (velocity, free) in patch.velocities.iter_mut().zip(&patch.free) {
                *velocity += change.component_mul(free);
            }
        });
    }

    /// Sets the temperatures of a time \[s\], and returns the energy that they bring \[J; J/m in the plane\].
    pub fn set_temperatures(&mut self, model: &SolidModel<D>, time: f64) -> f64 {
        match self {
            Patch::Updated(patch) => {
                let before = patch.elastic_energy();
                patch.temperatures = model.positions.iter().map(|x| model.temperature(x, time)).collect();
                patch.elastic_energy() - before
            }
            Patch::Total(patch) => patch.set_temperatures(|x| model.temperature(x, time)),
        }
    }

    /// Temperatures \[K\].
    pub fn temperatures(&self) -> &[f64] {
        either!(self, patch => &patch.temperatures)
    }

    /// Accumulated equivalent plastic strain \[-\].
    pub fn equivalents(&self) -> &[f64] {
        either!(self, patch => &patch.equivalents)
    }

    /// Masses \[kg; kg/m in the plane\].
    pub fn masses(&self) -> &[f64] {
        match self {
            Patch::Updated(patch) => patch.masses(),
            Patch::Total(patch) => patch.body().masses(),
        }
    }

    /// Densities \[kg/m³\].
    pub fn densities(&self) -> Vec<f64> {
        match self {
            Patch::Updated(patch) => patch.densities.clone(),
            Patch::Total(patch) => (0..self.masses().len()).map(|i| patch.body().density(i)).collect(),
        }
    }

    /// Cauchy stresses \[Pa\].
    pub fn stresses(&self) -> Vec<SymmetricTensor<D>> {
        either!(self, patch => patch.stresses())
    }

    /// Energy of motion and stored energy of strain \[J; J/m in the plane\]; what contact and the control of zero-energy
    /// modes store belongs to the latter.
    pub fn energies(&self) -> [f64; 2] {
        match self {
            Patch::Updated(patch) => [patch.kinetic_energy(), patch.elastic_energy()],
            Patch::Total(patch) => {
                let ledger = patch.ledger();
                [ledger.kinetic, ledger.elastic + ledger.hourglass + ledger.contact]
            }
        }
    }

    /// Number of pieces that hang together.
    pub fn pieces(&self, spacing: f64) -> usize {
        match self {
            Patch::Updated(patch) => patch.pieces(LINK * spacing),
            Patch::Total(patch) => patch.pieces(LINK * spacing, find),
        }
    }
}
