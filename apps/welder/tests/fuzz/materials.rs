//! The reader of material cards.

use crate::good::{MATERIAL, SCENE};
use crate::memory::assert_bounded;
use crate::mutation::{mutated, mutations};
use crate::scenes::read_in;
use crate::stress;
use proptest::prelude::*;
use welder::case::read_card;

/// Reads a card alone and as the metal of a good scene.
fn read(card: &[u8]) {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("materials")).unwrap();
    let path = folder.path().join("materials/metal.ron");
    std::fs::write(&path, card).unwrap();
    std::fs::write(folder.path().join("scene.ron"), SCENE).unwrap();
    if let Err(problem) = read_card(&path) {
        assert!(problem.to_string().contains("metal.ron"), "{problem}");
    }
    read_in(folder.path());
    assert_bounded();
}

#[test]
fn huge_tables_and_numbers_have_an_answer() {
    for number in ["1e308", "-1e308", "1e999", "5e-324", "inf", "NaN", "-0.0"] {
        for value in ["2500.0", "847.0", "905.0", "3.97e5", "1050.0", "300.0", "200.0"] {
            assert!(MATERIAL.contains(value), "{value}");
            read(MATERIAL.replacen(value, number, 1).as_bytes());
        }
    }
    let points: String = (0..60_000).map(|k| format!("({k}, 900),")).collect();
    read(MATERIAL.replace("(300.0, 900.0), (847.0, 1050.0)", &points).as_bytes());
    read("(".repeat(300_000).as_bytes());
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 300, ..Default::default() })]

    #[test]
    fn any_bytes_have_an_answer(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        read(&bytes);
    }

    #[test]
    fn mutated_cards_have_an_answer(changes in mutations()) {
        read(&mutated(MATERIAL.as_bytes(), &changes));
    }

    #[test]
    fn mutated_cards_with_stress_have_an_answer(changes in mutations()) {
        read(&mutated(stress::material().as_bytes(), &changes));
    }
}
