//! A scene of elastic bodies as the run loop sees it.

use super::course::{self, Plan, RunError};
use super::{Scenario, StepReport};
use crate::case::{self, SolidCase};
use crate::cli::{ExitStatus, RunArguments};
use crate::observe::{Checkpoint, CheckpointError, Measures, Pictures, SolidEnergy, SolidOutcome, SolidRow};
use crate::physics::{Column, Cost, Failure};
use crate::solid::{SolidBody, SolidModel, body_sections};
use nalgebra::SVector;
use std::collections::BTreeMap;

/// Runs the case, in the plane or in space.
pub(super) fn run(case: &SolidCase, arguments: &RunArguments) -> Result<ExitStatus, RunError> {
    let plan = Plan {
        name: case.name.clone(),
        resolved: case::resolved_solid_ron(case),
        output: case.scene.output(),
        max_steps: case.scene.budget.max_steps,
    };
    match case.scene.dimension() {
        2 => course::run(plan, arguments, || SolidBody::<2>::new(SolidModel::from_case(case)?)),
        _ => course::run(plan, arguments, || SolidBody::<3>::new(SolidModel::from_case(case)?)),
    }
}

impl<const D: usize> Scenario<D> for SolidBody<D> {
    type Outcome = SolidOutcome;

    fn name(&self) -> &str {
        &self.model().case.name
    }

    fn time(&self) -> f64 {
        SolidBody::time(self)
    }

    fn end(&self) -> f64 {
        self.model().case.scene.time.end_s
    }

    fn steps(&self) -> u64 {
        SolidBody::steps(self)
    }

    fn limits(&self) -> &BTreeMap<String, u64> {
        SolidBody::limits(self)
    }

    fn cost(&self) -> Cost {
        SolidBody::cost(self)
    }

    fn finished(&self) -> bool {
        SolidBody::time(self) >= self.end()
    }

    fn step(&mut self, stop: f64) -> Result<StepReport, Failure> {
        self.stride(stop)
    }

    fn fault(&self) -> Option<String> {
        self.ledger().fault()
    }

    fn save(&self, case_digest: u32) -> Result<Checkpoint, CheckpointError> {
        SolidBody::save(self, case_digest)
    }

    fn restore(&mut self, checkpoint: &Checkpoint) -> Result<(), CheckpointError> {
        SolidBody::restore(self, checkpoint)
    }

    fn positions(&self) -> &[SVector<f64, D>] {
        SolidBody::positions(self)
    }

    fn spacings(&self) -> &[f64] {
        SolidBody::spacings(self)
    }

    fn spacing(&self) -> f64 {
        self.model().case.scene.spacing_m
    }

    fn columns(&self) -> Vec<(&'static str, Column<D>)> {
        SolidBody::columns(self)
    }

    fn measures(&self, last: &StepReport) -> Measures {
        let (ledger, largest, [low, high]) = (self.ledger(), self.largest(), self.bounds());
        Measures::Solid(SolidRow {
            time_s: SolidBody::time(self),
            step: SolidBody::steps(self),
            dt_s: last.step,
            dt_limit: last.limit.to_string(),
            max_speed_m_s: largest.speed,
            max_von_mises_pa: largest.von_mises,
            max_principal_stress_pa: largest.principal[0],
            min_principal_stress_pa: largest.principal[1],
            max_displacement_m: largest.displacement,
            max_plastic_strain: largest.plastic,
            pieces: self.pieces(),
            x_min_m: low[0],
            x_max_m: high[0],
            y_min_m: low[1],
            y_max_m: high[1],
            z_min_m: low.get(2).copied(),
            z_max_m: high.get(2).copied(),
            kinetic_j: ledger.kinetic,
            elastic_j: ledger.elastic,
            potential_j: ledger.potential,
            heated_j: ledger.heated,
            driven_j: ledger.driven,
            plastic_j: ledger.plastic,
            damped_j: ledger.damped,
            lost_j: ledger.lost,
            energy_residual_rel: ledger.residual,
        })
    }

    fn pictures(&self, _at_end: bool) -> Pictures {
        body_sections(self)
    }

    fn outcome(&self) -> SolidOutcome {
        let (ledger, records, [low, high]) = (self.ledger(), self.records(), self.bounds());
        SolidOutcome {
            mass_kg: self.mass(),
            max_speed_m_s: records.speed,
            max_von_mises_pa: records.von_mises,
            max_principal_stress_pa: records.principal[0],
            min_principal_stress_pa: records.principal[1],
            max_displacement_m: records.displacement,
            max_plastic_strain: records.plastic,
            pieces: self.pieces(),
            momentum_kg_m_s: self.momentum().iter().copied().collect(),
            low_m: low.iter().copied().collect(),
            high_m: high.iter().copied().collect(),
            energy: SolidEnergy {
                kinetic_j: ledger.kinetic,
                elastic_j: ledger.elastic,
                potential_j: ledger.potential,
                heated_j: ledger.heated,
                driven_j: ledger.driven,
                plastic_j: ledger.plastic,
                damped_j: ledger.damped,
                lost_j: ledger.lost,
                residual_rel: ledger.residual,
            },
        }
    }

    fn numbers(&self) -> BTreeMap<String, f64> {
        solid_numbers(self)
    }

    fn told(&self) -> Vec<String> {
        let (ledger, records) = (self.ledger(), self.records());
        let unit = if D == 2 { "J/m" } else { "J" };
        vec![
            format!(
                "  {} pieces; largest speed {:.4e} m/s, largest von Mises stress {:.4e} Pa",
                self.pieces(),
                records.speed,
                records.von_mises
            ),
            format!(
                "  energy, {unit}: motion {:.4e}, elastic {:.4e}, height {:.4e}; heating brought {:.4e}, what moves {:.4e}; yield took {:.4e}, damping {:.4e}",
                ledger.kinetic,
                ledger.elastic,
                ledger.potential,
                ledger.heated,
                ledger.driven,
                ledger.plastic,
                ledger.damped
            ),
            format!(
                "  viscosity and scheme took {:.4e} {unit} ({:.1e} of the largest)",
                ledger.lost, ledger.residual
            ),
        ]
    }
}

/// Dimensionless numbers: speed_over_sound, the largest speed over that of waves of pressure, and strain, the largest von Mises stress
/// over Young's modulus.
pub(crate) fn solid_numbers<const D: usize>(body: &SolidBody<D>) -> BTreeMap<String, f64> {
    let (records, model) = (body.records(), body.model());
    [
        ("speed_over_sound", records.speed / model.wave_speed),
        ("strain", records.von_mises / model.case.scene.material.young_pa),
    ]
    .into_iter()
    .map(|(name, value)| (name.to_string(), value))
    .collect()
}
