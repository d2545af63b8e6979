//! `summary.json`: what came out of a run, for scripts and for the tables of a report.

use super::{ObserveError, whole_file};
use serde::{Deserialize, Serialize, de::DeserializeOwned};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Status {
    /// It came to its end and every audit passed.
    Done,
    /// It was interrupted after a checkpoint.
    Interrupted,
    /// It went wrong; there is a dossier.
    Failed,
    /// It came to its end, but an audit failed.
    AuditFailed,
    /// It was ended where vapour began to open a keyhole: the model, which is of conduction mode, does not hold any more.
    DeepPenetration,
}

/// The result of a run. A number that is not finite becomes `null`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Summary<Outcome> {
    /// How the run ended.
    pub status: Status,
    /// Version of the program.
    pub version: String,
    /// The commit that the program was built from.
    pub commit: String,
    /// Name of the case.
    pub case: String,
    /// Number of dimensions.
    pub dimension: usize,
    /// Number of particles.
    pub particles: usize,
    /// The finest particle spacing.
    pub spacing_m: f64,
    /// Steps taken.
    pub steps: u64,
    /// How often each limit ruled the step.
    pub step_limits: BTreeMap<String, u64>,
    /// Steps of heat that were taken back, because their estimated error was too large, and tried again shorter.
    pub rejected_steps: u64,
    /// Time on the clock.
    pub wall_s: f64,
    /// Processor time over all threads, where the system tells.
    pub cpu_s: Option<f64>,
    /// Time on the clock before the first step.
    pub setup_s: f64,
    /// Particles times steps, by time on the clock.
    pub particle_steps_per_s: f64,
    /// Directed pairs visited.
    pub pair_visits: u64,
    /// Threads used.
    pub threads: usize,
    /// Most memory held, where the system tells.
    pub peak_memory_bytes: Option<u64>,
    /// What the scene has of its own; its keys stand beside the others.
    #[serde(flatten)]
    pub outcome: Outcome,
    /// Dimensionless numbers of the physics present, by name.
    pub numbers: BTreeMap<String, f64>,
}

/// What a weld has of its own.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct WeldOutcome {
    /// Highest temperature of the top face at any time, between particles.
    pub peak_temperature_k: f64,
    /// The largest pool.
    pub pool: Pool,
    /// What was molten at any time.
    pub weld: Weld,
    /// The energy ledger.
    pub energy: Energy,
    /// Stress, where it was computed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stress: Option<StressEnd>,
}

/// What a scene of fluid has of its own. Masses and energies of a scene in the plane are for one metre of depth.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FluidOutcome {
    /// Mass of the fluid, the same at all times.
    pub mass_kg: f64,
    /// Highest speed of any particle at any time.
    pub max_speed_m_s: f64,
    /// Largest change of a density at any time, relative to the one without pressure.
    pub max_density_change_rel: f64,
    /// Mean pressure over the volume of the fluid at the end.
    pub mean_pressure_pa: f64,
    /// Low corner of the box around the fluid at the end.
    pub low_m: Vec<f64>,
    /// High corner of that box.
    pub high_m: Vec<f64>,
    /// The energy ledger.
    pub energy: FluidEnergy,
}

/// Where the energy of a fluid went.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FluidEnergy {
    /// Stored as motion.
    pub kinetic_j: f64,
    /// Stored as height over the lowest corner of the domain.
    pub potential_j: f64,
    /// Stored as compression.
    pub compression_j: f64,
    /// Stored in the surface since the start.
    pub surface_j: f64,
    /// Taken by friction since the start.
    pub friction_j: f64,
    /// Given by the change of tension with temperature since the start.
    pub driven_j: f64,
    /// Given by expansion against pressure since the start.
    pub expansion_j: f64,
    /// Taken by the scheme itself since the start: what does not close.
    pub numerics_j: f64,
    /// The same over the largest of the other energies, that of the start included.
    pub residual_rel: f64,
}

/// What a scene of elastic bodies has of its own. Masses, momentum and energies of a scene in the plane are for one metre of depth.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SolidOutcome {
    /// Mass of the bodies, the same at all times.
    pub mass_kg: f64,
    /// Highest speed of any particle at any time.
    pub max_speed_m_s: f64,
    /// Largest von Mises stress at any time.
    pub max_von_mises_pa: f64,
    /// Largest principal stress, tension positive at any time.
    pub max_principal_stress_pa: f64,
    /// Smallest principal stress at any time.
    pub min_principal_stress_pa: f64,
    /// Largest displacement from the start at any time.
    pub max_displacement_m: f64,
    /// Largest accumulated equivalent plastic strain.
    pub max_plastic_strain: f64,
    /// Number of pieces that hang together at the end.
    pub pieces: usize,
    /// Momentum at the end.
    pub momentum_kg_m_s: Vec<f64>,
    /// Low corner of the box around the bodies at the end.
    pub low_m: Vec<f64>,
    /// High corner of that box.
    pub high_m: Vec<f64>,
    /// The energy ledger.
    pub energy: SolidEnergy,
}

/// Where the energy of elastic bodies went.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SolidEnergy {
    /// Stored as motion.
    pub kinetic_j: f64,
    /// Stored as elastic strain.
    pub elastic_j: f64,
    /// Stored as height over the start.
    pub potential_j: f64,
    /// Brought since the start by prescribed temperatures.
    pub heated_j: f64,
    /// Brought since the start by what is held and moves.
    pub driven_j: f64,
    /// Work of yield since the start, plastic strain taken as small.
    pub plastic_j: f64,
    /// Taken since the start by damping.
    pub damped_j: f64,
    /// Taken since the start by artificial viscosity and the scheme itself.
    pub lost_j: f64,
    /// The same over the largest of the energies, that of the start included.
    pub residual_rel: f64,
}

/// The largest extents of the pool at the liquidus and at the solidus.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Pool {
    /// Largest width at the liquidus.
    pub max_width_m: f64,
    /// Largest length at the liquidus.
    pub max_length_m: f64,
    /// Largest depth at the liquidus.
    pub max_depth_m: f64,
    /// The same three at the solidus.
    pub at_solidus: PoolSize,
}

/// The largest extents of the pool at one isotherm.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PoolSize {
    /// Largest width.
    pub max_width_m: f64,
    /// Largest length.
    pub max_length_m: f64,
    /// Largest depth.
    pub max_depth_m: f64,
}

/// The weld: everything that was molten at any time.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Weld {
    /// Width.
    pub width_m: f64,
    /// Length.
    pub length_m: f64,
    /// Depth.
    pub depth_m: f64,
    /// Volume.
    pub volume_m3: f64,
    /// When the last melt froze, if it did.
    pub solidified_at_s: Option<f64>,
}

/// Stress and deformation at the end of a run.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct StressEnd {
    /// Largest von Mises stress.
    pub max_von_mises_pa: f64,
    /// Largest principal stress, tension positive.
    pub max_principal_stress_pa: f64,
    /// Smallest principal stress.
    pub min_principal_stress_pa: f64,
    /// Largest displacement from the start.
    pub max_displacement_m: f64,
    /// Largest equivalent plastic strain.
    pub max_plastic_strain: f64,
    /// Kinetic energy of the body that settles over its elastic energy: how far it is from equilibrium.
    pub unrest: f64,
}

/// Where the energy went.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Energy {
    /// Sent out by the source.
    pub emitted_j: f64,
    /// Taken up by the part.
    pub absorbed_j: f64,
    /// Stored as temperature.
    pub sensible_j: f64,
    /// Stored as melt.
    pub latent_j: f64,
    /// Lost through the surface.
    pub lost_j: f64,
    /// Stored as motion.
    pub kinetic_j: f64,
    /// Stored as compression of the melt.
    pub compression_j: f64,
    /// Work of surface tension and its change with temperature on the melt since the start.
    pub surface_work_j: f64,
    /// Work of gravity on the melt since the start.
    pub gravity_work_j: f64,
    /// Work of the melt's expansion against pressure since the start, taken from its heat.
    pub expansion_work_j: f64,
    /// Heat that friction in the melt has made since the start, and the motion of what froze; part of what is stored.
    pub dissipated_j: f64,
    /// Stored as strain.
    pub strain_j: f64,
    /// Stored by stress beside strain and heat, alpha T tr(sigma); only where deformation makes heat, as the one below.
    pub thermoelastic_j: f64,
    /// Heat that pressing, stretching and yield have made since the start, part of what is stored.
    pub deformation_j: f64,
    /// Heat that cannot be accounted for, over the energy turned over (absorbed, lost or moved inside, whichever is largest).
    pub residual_rel: f64,
    /// Work on the melt that is neither motion nor compression nor heat, over the same: what its scheme loses or gains.
    pub mechanical_residual_rel: f64,
    /// Heat made by deformation that did not come from strain, over the same: what settling and the steps leave open.
    pub deformation_residual_rel: f64,
}

impl<Outcome: Serialize> Summary<Outcome> {
    /// Writes the summary, whole or not at all.
    pub fn write(&self, path: &Path) -> Result<(), ObserveError> {
        write_json(path, self)
    }
}

impl<Outcome: DeserializeOwned> Summary<Outcome> {
    /// Reads a summary back.
    pub fn read(path: &Path) -> Result<Self, ObserveError> {
        let text = fs::read_to_string(path).map_err(ObserveError::file("read", path))?;
        serde_json::from_str(&text).map_err(|source| ObserveError::Json { path: path.to_path_buf(), source })
    }
}

/// Writes any value as indented JSON, whole or not at all.
pub fn write_json(path: &Path, value: &impl Serialize) -> Result<(), ObserveError> {
    let mut text = serde_json::to_vec_pretty(value)
        .map_err(|source| ObserveError::Json { path: path.to_path_buf(), source })?;
    text.push(b'\n');
    whole_file::replace(path, &text).map_err(ObserveError::file("write", path))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::Value;

    fn example() -> Summary<WeldOutcome> {
        Summary {
            status: Status::AuditFailed,
            version: "0.1.0".into(),
            commit: "0123456789ab".into(),
            case: "spot-aluminium".into(),
            dimension: 3,
            particles: 10_000,
            spacing_m: 50e-6,
            steps: 417,
            step_limits: BTreeMap::from([("conduction".into(), 400), ("output".into(), 17)]),
            rejected_steps: 3,
            wall_s: 0.4,
            cpu_s: Some(0.39),
            setup_s: 0.1,
            particle_steps_per_s: 1.0e7,
            pair_visits: 3_000_000_000_000,
            threads: 1,
            peak_memory_bytes: None,
            outcome: WeldOutcome {
                peak_temperature_k: 0.1 + 0.2,
                weld: Weld { solidified_at_s: Some(0.0123), ..Weld::default() },
                energy: Energy { residual_rel: -3.0e-16, ..Energy::default() },
                ..WeldOutcome::default()
            },
            numbers: BTreeMap::from([("stefan".into(), 1.7)]),
        }
    }

    fn keys(value: &Value) -> Vec<&str> {
        value.as_object().unwrap().keys().map(String::as_str).collect()
    }

    #[test]
    fn a_summary_comes_back_to_the_last_bit() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("summary.json");
        example().write(&path).unwrap();
        assert_eq!(Summary::<WeldOutcome>::read(&path).unwrap(), example());
    }

    #[test]
    fn the_keys_are_those_of_the_contract() {
        let value = serde_json::to_value(example()).unwrap();
        let named = "status version commit case dimension particles spacing_m steps step_limits rejected_steps wall_s \
                     particle_steps_per_s pair_visits threads peak_memory_bytes peak_temperature_k \
                     pool weld energy numbers";
        let mut expected: Vec<&str> = named.split_whitespace().chain(["cpu_s", "setup_s"]).collect();
        let mut found = keys(&value);
        expected.sort();
        found.sort();
        assert_eq!(found, expected);
        assert_eq!(value["status"], "audit-failed");
        let three = ["max_depth_m", "max_length_m", "max_width_m"];
        let mut at_solidus = keys(&value["pool"]["at_solidus"]);
        at_solidus.sort();
        assert_eq!(at_solidus, three);
        assert!(three.iter().all(|key| value["pool"][key] == 0.0));
        for key in "width_m length_m depth_m volume_m3 solidified_at_s".split_whitespace() {
            assert!(value["weld"].get(key).is_some(), "{key}");
        }
        for key in
            "emitted_j absorbed_j sensible_j latent_j lost_j kinetic_j strain_j residual_rel".split(' ')
        {
            assert!(value["energy"].get(key).is_some(), "{key}");
        }
    }

    #[test]
    fn a_folder_that_is_not_there_is_named() {
        let error = example().write(Path::new("/nowhere/at/all/summary.json")).unwrap_err();
        assert!(error.to_string().starts_with("cannot write /nowhere/at/all/summary.json"), "{error}");
    }
}
