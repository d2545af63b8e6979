//! The reader of checkpoints: the envelope, and content that a right checksum vouches for.

use crate::good::{MATERIAL, SCENE};
use crate::memory::assert_bounded;
use crate::mutation::{mutated, mutations};
use crate::{fluid, solid, stress};
use proptest::prelude::*;
use std::fs::File;
use std::io::Write;
use std::path::Path;
use std::sync::OnceLock;
use welder::case::{Loaded, load_any};
use welder::fluid::{FluidFlow, FluidModel};
use welder::model::Model;
use welder::observe::{Checkpoint, CheckpointError, CheckpointFolder};
use welder::run::Simulation;
use welder::solid::{SolidBody, SolidModel};
use welder::version;

const NAME: &str = "checkpoint_7.bin";
const DIGEST: u32 = 11;

type Resume = dyn Fn(&Checkpoint) -> Result<(), CheckpointError> + Send + Sync;

/// A scene of one kind of state: a good checkpoint of it, and how a run goes on from one.
struct Kind {
    name: &'static str,
    good: Checkpoint,
    resume: Box<Resume>,
}

/// All kinds; heat alone is the first.
fn kinds() -> &'static [Kind] {
    static KINDS: OnceLock<Vec<Kind>> = OnceLock::new();
    KINDS.get_or_init(|| {
        let hot = "regions: [(low_m: (0.0, 0.0, -0.4e-3), high_m: (0.6e-3, 0.6e-3, 0.0), start_k: 1500.0)],";
        let small = SCENE
            .replace("6.0e-3, 4.0e-3, 3.0e-3", "1.2e-3, 1.2e-3, 0.8e-3")
            .replace(
                "regions: [(low_m: (0.0, 0.0, -1.0e-3), high_m: (1.0e-3, 1.0e-3, 0.0), start_k: 400.0)],",
                hot,
            )
            .replace("spacing_m: 50.0e-6, disorder: 0.1", "spacing_m: 100.0e-6");
        let flow = small.replace("[Heat()]", "[Heat(), Flow(viscosity_factor: 20.0)]");
        let corrected = solid::GOOD.replace("smoothing_ratio: 0.9", "form: Corrected");
        vec![
            weld("heat", &small, MATERIAL),
            weld("flow", &flow, &melt()),
            weld(
                "stress",
                &small.replace("[Heat()]", "[Heat(), Stress(clamped: (x_max: true))]"),
                &stress::material(),
            ),
            of_fluid("fluid", fluid::GOOD),
            of_solid("solid, total", solid::GOOD),
            of_solid("solid, updated", &corrected),
        ]
    })
}

/// The metal with what Flow asks for.
fn melt() -> String {
    let flows = "    viscosity_pa_s: (value: 1.0e-3, source: \"test\"),\n    \
         surface_tension_n_m: (value: 0.9, source: \"test\"),\n    \
         surface_tension_slope_n_m_k: (value: -3.5e-4, source: \"test\"),\n)\n";
    MATERIAL.trim_end().trim_end_matches(')').to_string() + flows
}

fn loaded(scene: &str, material: &str) -> Loaded {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("materials")).unwrap();
    std::fs::write(folder.path().join("materials/metal.ron"), material).unwrap();
    std::fs::write(folder.path().join("scene.ron"), scene).unwrap();
    load_any(folder.path(), &[]).unwrap_or_else(|error| panic!("{error}"))
}

fn weld(name: &'static str, scene: &str, material: &str) -> Kind {
    let Loaded::Weld(case) = loaded(scene, material) else { panic!("no weld") };
    let model = Model::from_case(&case).unwrap();
    let mut simulation = Simulation::new(model.clone()).unwrap();
    simulation.step(1e-5).unwrap();
    let good = simulation.save(DIGEST, 1e-4).unwrap();
    let resume = move |checkpoint: &Checkpoint| {
        Simulation::grown_of(checkpoint)?;
        Simulation::new(model.clone()).unwrap().restore(checkpoint)
    };
    Kind { name, good, resume: Box::new(resume) }
}

fn of_fluid(name: &'static str, scene: &str) -> Kind {
    let Loaded::Fluid(case) = loaded(scene, MATERIAL) else { panic!("no fluid") };
    let start = move || FluidFlow::<2>::new(FluidModel::from_case(&case).unwrap()).unwrap();
    let mut flow = start();
    flow.stride(1.0).unwrap();
    let good = flow.save(DIGEST).unwrap();
    Kind { name, good, resume: Box::new(move |checkpoint| start().restore(checkpoint)) }
}

fn of_solid(name: &'static str, scene: &str) -> Kind {
    let Loaded::Solid(case) = loaded(scene, MATERIAL) else { panic!("no solid") };
    let start = move || SolidBody::<2>::new(SolidModel::from_case(&case).unwrap()).unwrap();
    let mut body = start();
    body.stride(1.0).unwrap();
    let good = body.save(DIGEST).unwrap();
    Kind { name, good, resume: Box::new(move |checkpoint| start().restore(checkpoint)) }
}

/// Writes bytes as the newest checkpoint of a run and goes on from it; a refusal must name the file.
fn read(kind: &Kind, bytes: &[u8]) {
    let run = tempfile::tempdir().unwrap();
    std::fs::create_dir(run.path().join("checkpoint")).unwrap();
    std::fs::write(run.path().join("checkpoint").join(NAME), bytes).unwrap();
    let found = CheckpointFolder::of_run(run.path()).latest(version::PROGRAM, DIGEST);
    let refused = found.and_then(|found| {
        let found = found.expect("the file is there");
        (kind.resume)(&found.checkpoint).map_err(|error| error.in_file(&found.path))
    });
    if let Err(error) = refused {
        assert!(error.to_string().contains(NAME), "{error}");
    }
    assert_bounded();
}

#[test]
fn the_good_ones_are_good() {
    for kind in kinds() {
        let bytes = kind.good.to_bytes().unwrap();
        let read_back = Checkpoint::from_bytes(&bytes, Path::new(NAME)).unwrap();
        (kind.resume)(&read_back).unwrap_or_else(|error| panic!("{}: {error}", kind.name));
        read(kind, &bytes);
    }
}

/// A header that claims terabytes, in a short file and in one that is as long (of holes) as it says.
#[test]
fn terabytes_are_refused() {
    let claim = |length: u64| [b"LIQUIDUS".as_slice(), &1_u32.to_le_bytes(), &length.to_le_bytes()].concat();
    for length in [1 << 20, 1 << 40, 1 << 50, u64::MAX - 3, u64::MAX] {
        read(&kinds()[0], &claim(length));
    }
    let run = tempfile::tempdir().unwrap();
    std::fs::create_dir(run.path().join("checkpoint")).unwrap();
    let path = run.path().join("checkpoint").join(NAME);
    for (magic, length) in [(claim(1 << 30), 1_u64 << 40), (vec![0; 20], 1 << 40)] {
        let mut file = File::create(&path).unwrap();
        file.write_all(&magic).unwrap();
        // Where the file system takes no holes there is nothing to read.
        if file.set_len(length).is_ok() {
            let error = CheckpointFolder::of_run(run.path()).latest("0", DIGEST).unwrap_err();
            assert!(error.to_string().contains(NAME) && error.to_string().contains("damaged"), "{error}");
        }
    }
    assert_bounded();
}

/// Lengths inside the content that claim terabytes, under a right checksum.
#[test]
fn long_columns_that_are_not_there_are_refused() {
    let varint = |ones: usize| [vec![0xff; ones], vec![0x01]].concat();
    for kind in kinds() {
        for ones in [0, 4, 9] {
            let mut changed = kind.good.clone();
            changed.state = varint(ones);
            assert!((kind.resume)(&changed).is_err(), "{}", kind.name);
            for column in 0..changed.columns.len() {
                let mut changed = kind.good.clone();
                changed.columns[column].1 = varint(ones);
                assert!((kind.resume)(&changed).is_err(), "{}", kind.name);
            }
        }
    }
    assert_bounded();
}

/// Columns of the right length that hold what no run writes.
#[test]
fn columns_of_numbers_that_are_none_have_an_answer() {
    for kind in kinds() {
        for (column, (name, bytes)) in kind.good.columns.iter().enumerate() {
            let count = kind.good.column::<f64>(name).unwrap().len();
            for number in [f64::NAN, f64::INFINITY, -1e300] {
                let mut changed = kind.good.clone();
                changed.columns.clear();
                changed.put_column(name, &vec![number; count]).unwrap();
                assert_eq!(changed.columns[0].1.len(), bytes.len());
                let all = kind.good.columns.iter().cloned().enumerate();
                let other = changed.columns.remove(0);
                changed.columns =
                    all.map(|(k, good)| if k == column { other.clone() } else { good }).collect();
                read(kind, &changed.to_bytes().unwrap());
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 300, ..Default::default() })]

    #[test]
    fn any_bytes_have_an_answer(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        read(&kinds()[0], &bytes);
    }

    #[test]
    fn mutated_files_have_an_answer(changes in mutations()) {
        read(&kinds()[0], &mutated(&kinds()[0].good.to_bytes().unwrap(), &changes));
    }

    /// Damage that the checksum does not show: the state, a column, the scalars, a column that is missing.
    #[test]
    fn mutated_content_has_an_answer(
        kind: prop::sample::Index, changes in mutations(), which: prop::sample::Index, time_s: f64, step: u64, part in 0..8,
    ) {
        let kind = kind.get(kinds());
        let mut changed = kind.good.clone();
        let which = which.index(changed.columns.len());
        match part {
            0..3 => changed.state = mutated(&changed.state, &changes),
            3..6 => changed.columns[which].1 = mutated(&changed.columns[which].1, &changes),
            6 => (changed.time_s, changed.step) = (time_s, step),
            _ => drop(changed.columns.remove(which)),
        }
        read(kind, &changed.to_bytes().unwrap());
    }
}
