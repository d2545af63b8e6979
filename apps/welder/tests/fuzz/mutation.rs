//! Changes of the bytes of a good file, and bytes that were never one.

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};

/// Pieces that readers stumble over: numbers beyond their types, brackets and quotes that never close, paths.
const PIECES: &[&str] = &[
    "1e999",
    "-1e308",
    "5e-324",
    "inf",
    "-inf",
    "NaN",
    "18446744073709551616",
    "-1",
    "0",
    "((((",
    "]]]]",
    "{",
    "\"",
    "r##\"",
    "'",
    "/*",
    "//",
    "Some(",
    "None",
    ":",
    ",",
    "é",
    "\u{0}",
    "\u{feff}",
    "#![enable(",
    "\"../../../x.ron\"",
    "b\"",
    "\\u{110000}",
    "0xffffffffffffffffffff",
    "1_000_000_000_000",
];

/// One change.
#[derive(Debug, Clone)]
pub enum Mutation {
    Insert(Index, Vec<u8>),
    Delete(Index, usize),
    Flip(Index, u8),
    Duplicate(Index, usize),
    Truncate(Index),
}

/// Up to six changes, one after the other.
pub fn mutations() -> impl Strategy<Value = Vec<Mutation>> {
    let bytes = prop_oneof![
        select(PIECES).prop_map(|piece| piece.as_bytes().to_vec()),
        vec(any::<u8>(), 1..8),
        vec(Just(0xff_u8), 1..12),
    ];
    let one = prop_oneof![
        4 => (any::<Index>(), bytes).prop_map(|(at, bytes)| Mutation::Insert(at, bytes)),
        2 => (any::<Index>(), 1..40_usize).prop_map(|(at, length)| Mutation::Delete(at, length)),
        2 => (any::<Index>(), 1_u8..).prop_map(|(at, flip)| Mutation::Flip(at, flip)),
        2 => (any::<Index>(), 1..400_usize).prop_map(|(at, length)| Mutation::Duplicate(at, length)),
        1 => any::<Index>().prop_map(Mutation::Truncate),
    ];
    vec(one, 1..6)
}

/// The bytes with all changes made.
pub fn mutated(good: &[u8], mutations: &[Mutation]) -> Vec<u8> {
    mutations.iter().fold(good.to_vec(), |mut bytes, mutation| {
        let place = |at: &Index| at.index(bytes.len() + 1);
        match mutation {
            Mutation::Insert(at, piece) => {
                let at = place(at);
                bytes.splice(at..at, piece.iter().copied());
            }
            Mutation::Delete(at, length) => {
                let at = place(at);
                bytes.drain(at..(at + length).min(bytes.len()));
            }
            Mutation::Flip(at, flip) => {
                let at = place(at);
                bytes.iter_mut().skip(at).take(1).for_each(|byte| *byte ^= flip);
            }
            Mutation::Duplicate(at, length) => {
                let at = place(at);
                let piece = bytes[at..(at + length).min(bytes.len())].to_vec();
                bytes.splice(at..at, piece);
            }
            Mutation::Truncate(at) => {
                let at = place(at);
                bytes.truncate(at);
            }
        }
        bytes
    })
}
