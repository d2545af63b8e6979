//! A scene of fluid as the run loop sees it.

use super::course::{self, Plan, RunError};
use super::{Scenario, StepReport};
use crate::case::{self, FluidCase};
use crate::cli::{ExitStatus, RunArguments};
use crate::fluid::{FluidFlow, FluidModel, sections};
use crate::observe::{Checkpoint, CheckpointError, FluidEnergy, FluidOutcome, FluidRow, Measures, Pictures};
use crate::physics::{Column, Cost, Failure};
use nalgebra::SVector;
use sph_fluid::equivalent_viscosity;
use std::collections::BTreeMap;

/// Runs the case, in the plane or in space.
pub(super) fn run(case: &FluidCase, arguments: &RunArguments) -> Result<ExitStatus, RunError> {
    let plan = Plan {
        name: case.name.clone(),
        resolved: case::resolved_fluid_ron(case),
        output: case.scene.output(),
        max_steps: case.scene.budget.max_steps,
    };
    match case.scene.dimension() {
        2 => course::run(plan, arguments, || FluidFlow::<2>::new(FluidModel::from_case(case)?)),
        _ => course::run(plan, arguments, || FluidFlow::<3>::new(FluidModel::from_case(case)?)),
    }
}

impl<const D: usize> Scenario<D> for FluidFlow<D> {
    type Outcome = FluidOutcome;

    fn name(&self) -> &str {
        &self.model().case.name
    }

    fn time(&self) -> f64 {
        FluidFlow::time(self)
    }

    fn end(&self) -> f64 {
        self.model().case.scene.time.end_s
    }

    fn steps(&self) -> u64 {
        FluidFlow::steps(self)
    }

    fn limits(&self) -> &BTreeMap<String, u64> {
        FluidFlow::limits(self)
    }

    fn cost(&self) -> Cost {
        FluidFlow::cost(self)
    }

    fn finished(&self) -> bool {
        FluidFlow::time(self) >= self.end()
    }

    fn step(&mut self, stop: f64) -> Result<StepReport, Failure> {
        self.stride(stop)
    }

    fn fault(&self) -> Option<String> {
        self.ledger().fault()
    }

    fn warnings(&self) -> Vec<String> {
        self.ledger().warning().into_iter().collect()
    }

    fn save(&self, case_digest: u32) -> Result<Checkpoint, CheckpointError> {
        FluidFlow::save(self, case_digest)
    }

    fn restore(&mut self, checkpoint: &Checkpoint) -> Result<(), CheckpointError> {
        FluidFlow::restore(self, checkpoint)
    }

    fn positions(&self) -> &[SVector<f64, D>] {
        FluidFlow::positions(self)
    }

    fn spacings(&self) -> &[f64] {
        FluidFlow::spacings(self)
    }

    fn spacing(&self) -> f64 {
        self.model().spacing()
    }

    fn columns(&self) -> Vec<(&'static str, Column<D>)> {
        FluidFlow::columns(self)
    }

    fn measures(&self, last: &StepReport) -> Measures {
        let (ledger, [low, high]) = (self.ledger(), self.bounds());
        Measures::Fluid(FluidRow {
            time_s: FluidFlow::time(self),
            step: FluidFlow::steps(self),
            dt_s: last.step,
            dt_limit: last.limit.to_string(),
            max_speed_m_s: self.largest_speed(),
            mean_pressure_pa: self.mean_pressure(),
            max_density_change_rel: self.density_change(),
            x_min_m: low[0],
            x_max_m: high[0],
            y_min_m: low[1],
            y_max_m: high[1],
            z_min_m: low.get(2).copied(),
            z_max_m: high.get(2).copied(),
            kinetic_j: ledger.kinetic,
            potential_j: ledger.potential,
            compression_j: ledger.compression,
            surface_j: ledger.surface,
            friction_j: ledger.friction,
            driven_j: ledger.driven,
            expansion_j: ledger.expansion,
            energy_residual_rel: ledger.residual,
        })
    }

    fn pictures(&self, _at_end: bool) -> Pictures {
        sections(self)
    }

    fn outcome(&self) -> FluidOutcome {
        let (ledger, records, [low, high]) = (self.ledger(), self.records(), self.bounds());
        FluidOutcome {
            mass_kg: self.mass(),
            max_speed_m_s: records.speed,
            max_density_change_rel: records.density_change,
            mean_pressure_pa: self.mean_pressure(),
            low_m: low.iter().copied().collect(),
            high_m: high.iter().copied().collect(),
            energy: FluidEnergy {
                kinetic_j: ledger.kinetic,
                potential_j: ledger.potential,
                compression_j: ledger.compression,
                surface_j: ledger.surface,
                friction_j: ledger.friction,
                driven_j: ledger.driven,
                expansion_j: ledger.expansion,
                numerics_j: ledger.numerics,
                residual_rel: ledger.residual,
            },
        }
    }

    fn numbers(&self) -> BTreeMap<String, f64> {
        fluid_numbers(self.model(), self.records().speed)
    }

    fn told(&self) -> Vec<String> {
        let (ledger, records) = (self.ledger(), self.records());
        let sound = self.model().sound_speed();
        let unit = if D == 2 { "J/m" } else { "J" };
        vec![
            format!(
                "  largest speed {:.4e} m/s, {:.3} of the sound of {sound:.3} m/s; density changed by {:.2} %",
                records.speed,
                records.speed / sound,
                100.0 * records.density_change
            ),
            format!(
                "  energy, {unit}: motion {:.4e}, height {:.4e}, compression {:.4e}, surface {:.4e}",
                ledger.kinetic, ledger.potential, ledger.compression, ledger.surface
            ),
            format!(
                "    friction took {:.4e}, tension's change gave {:.4e}, expansion {:.4e}, the scheme took {:.4e} ({:.1e} of the largest)",
                ledger.friction, ledger.driven, ledger.expansion, ledger.numerics, ledger.residual
            ),
        ]
    }
}

/// Dimensionless numbers at a largest speed v \[m/s\], with the smallest thickness or radius L of the bodies:
/// reynolds rho v L/eta, cell_reynolds rho v dx/eta, mach v/c of the artificial sound, weber rho v^2 L/tau, froude
/// v/sqrt(g L), and friction_by_numerics, what artificial viscosity adds to eta, over eta, and, where warmth expands
/// the fluid, grashof g beta G L^4/nu^2 of the slope G of temperature.
pub(crate) fn fluid_numbers<const D: usize>(model: &FluidModel<D>, speed: f64) -> BTreeMap<String, f64> {
    let (controls, length) = (&model.controls, model.expected.length);
    let (density, viscosity) = (model.density(), controls.dynamic_viscosity);
    let (gravity, smoothing) = (controls.body_acceleration.norm(), controls.kernel.smoothing_length());
    let tension = controls.surface_tension.map_or(0.0, |tension| tension.reference());
    let added = equivalent_viscosity::<D>(smoothing, model.sound_speed(), controls.artificial_viscosity);
    let slope = model.temperature.map_or(0.0, |(_, slope)| slope.norm());
    let lift = gravity * model.case.scene.fluid.volume_expansion_1_k * slope * length.powi(4);
    let numbers = [
        ("reynolds", density * speed * length / viscosity),
        ("cell_reynolds", density * speed * model.spacing() / viscosity),
        ("mach", speed / model.sound_speed()),
        ("weber", density * speed * speed * length / tension),
        ("froude", speed / (gravity * length).sqrt()),
        ("friction_by_numerics", density * added / viscosity),
        ("grashof", if lift > 0.0 { lift * (density / viscosity).powi(2) } else { f64::NAN }),
    ];
    // What there is none of makes a number infinite, or none.
    let finite = numbers.into_iter().filter(|(_, value)| value.is_finite());
    finite.map(|(name, value)| (name.to_string(), value)).collect()
}
