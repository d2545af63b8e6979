//! The reader of checkpoints: the envelope, and content that a right checksum vouches for.

use crate::memory::assert_bounded;
use crate::mutation::{Mutation, mutated, mutations};
use proptest::prelude::*;
use std::fs::File;
use std::io::Write;
use std::path::Path;
use std::sync::OnceLock;
use welder::model::Model;
use welder::observe::{Checkpoint, CheckpointError, CheckpointFolder};
use welder::run::Simulation;
use welder::verify::{block, reference_aluminium};

const NAME: &str = "checkpoint_7.bin";
const DIGEST: u32 = 11;

fn model() -> &'static Model {
    static MODEL: OnceLock<Model> = OnceLock::new();
    MODEL.get_or_init(|| {
        let mut model = block([4; 3], 1e-4, vec![reference_aluminium()]).unwrap();
        model.end = 1e-3;
        model
    })
}

fn good() -> &'static Checkpoint {
    static GOOD: OnceLock<Checkpoint> = OnceLock::new();
    GOOD.get_or_init(|| {
        let mut simulation = Simulation::new(model().clone()).unwrap();
        simulation.step(1e-3).unwrap();
        simulation.save(DIGEST, 1e-4).unwrap()
    })
}

/// Goes on from a checkpoint as a resumed run does.
fn resume(checkpoint: &Checkpoint) -> Result<(), CheckpointError> {
    Simulation::grown_of(checkpoint)?;
    Simulation::new(model().clone()).unwrap().restore(checkpoint)
}

/// Writes bytes as the newest checkpoint of a run and reads it; a refusal must name the file.
fn read(bytes: &[u8]) {
    let run = tempfile::tempdir().unwrap();
    std::fs::create_dir(run.path().join("checkpoint")).unwrap();
    std::fs::write(run.path().join("checkpoint").join(NAME), bytes).unwrap();
    let found = CheckpointFolder::of_run(run.path()).latest(env!("CARGO_PKG_VERSION"), DIGEST);
    let refused = found.and_then(|found| {
        let found = found.expect("the file is there");
        resume(&found.checkpoint).map_err(|error| error.in_file(&found.path))
    });
    if let Err(error) = refused {
        assert!(error.to_string().contains(NAME), "{error}");
    }
    assert_bounded();
}

#[test]
fn the_good_one_is_good() {
    let bytes = good().to_bytes().unwrap();
    assert!(resume(&Checkpoint::from_bytes(&bytes, Path::new(NAME)).unwrap()).is_ok());
    read(&bytes);
}

/// A header that claims terabytes, in a short file and in one that is as long (of holes) as it says.
#[test]
fn terabytes_are_refused() {
    let claim = |length: u64| [b"LIQUIDUS".as_slice(), &1_u32.to_le_bytes(), &length.to_le_bytes()].concat();
    for length in [1 << 20, 1 << 40, 1 << 50, u64::MAX - 3, u64::MAX] {
        read(&claim(length));
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
    for ones in 0..10 {
        let mut changed = good().clone();
        changed.state = varint(ones);
        assert!(resume(&changed).is_err());
        for column in 0..good().columns.len() {
            let mut changed = good().clone();
            changed.columns[column].1 = varint(ones);
            assert!(resume(&changed).is_err());
        }
    }
    assert_bounded();
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 300, ..Default::default() })]

    #[test]
    fn any_bytes_have_an_answer(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        read(&bytes);
    }

    #[test]
    fn mutated_files_have_an_answer(changes in mutations()) {
        read(&mutated(&good().to_bytes().unwrap(), &changes));
    }

    /// Damage that the checksum does not show: the payload, the state, a column, the scalars.
    #[test]
    fn mutated_content_has_an_answer(
        state in mutations(), column in mutations(), which: prop::sample::Index, time_s: f64, step: u64, part in 0..4,
    ) {
        let mut changed = good().clone();
        let change = |bytes: &mut Vec<u8>, changes: &[Mutation]| *bytes = mutated(bytes, changes);
        match part {
            0 => change(&mut changed.state, &state),
            1 => {
                let which = which.index(changed.columns.len());
                change(&mut changed.columns[which].1, &column);
            }
            2 => (changed.time_s, changed.step) = (time_s, step),
            _ => drop(changed.columns.remove(which.index(good().columns.len()))),
        }
        read(&changed.to_bytes().unwrap());
    }
}
