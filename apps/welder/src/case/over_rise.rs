//! A value of a body's material that may depend on its temperature, which scenes of bodies give as a rise over the start.

use serde::de::{Error, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};
use std::fmt;

/// A number, or pairs (rise_k, value) over the rise of temperature: rises ascending, straight lines between, constant beyond the ends.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum OverRise {
    /// The same at all temperatures.
    Constant(f64),
    /// Over temperature.
    Table(Vec<(f64, f64)>),
}

impl OverRise {
    /// The points (rise_k, value); a constant is one.
    pub fn points(&self) -> Vec<(f64, f64)> {
        match self {
            OverRise::Constant(value) => vec![(0.0, *value)],
            OverRise::Table(points) => points.clone(),
        }
    }
}

impl Default for OverRise {
    fn default() -> Self {
        OverRise::Constant(0.0)
    }
}

impl<'de> Deserialize<'de> for OverRise {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(NumberOrPairs)
    }
}

struct NumberOrPairs;

impl<'de> Visitor<'de> for NumberOrPairs {
    type Value = OverRise;

    fn expecting(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter.write_str("a number, or pairs over the rise of temperature, [(rise_k, value), ...]")
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<OverRise, E> {
        Ok(OverRise::Constant(value))
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<OverRise, E> {
        Ok(OverRise::Constant(value as f64))
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<OverRise, E> {
        Ok(OverRise::Constant(value as f64))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut sequence: A) -> Result<OverRise, A::Error> {
        let mut points = Vec::new();
        while let Some(point) = sequence.next_element()? {
            points.push(point);
        }
        Ok(OverRise::Table(points))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_pairs_are_read_and_written() {
        let table = OverRise::Table(vec![(0.0, 1e8), (500.0, 0.0)]);
        let texts = ["1.0e8", "3", "-2.5", "[(0.0, 1e8), (500, 0)]"];
        let expected = [1e8, 3.0, -2.5].map(OverRise::Constant).into_iter().chain([table]);
        for (text, expected) in texts.into_iter().zip(expected) {
            let found: OverRise = ron::from_str(text).unwrap();
            assert_eq!(found, expected, "{text}");
            assert_eq!(ron::from_str::<OverRise>(&ron::to_string(&found).unwrap()).unwrap(), expected);
        }
    }

    #[test]
    fn other_things_are_refused() {
        for text in ["\"1e8\"", "[1e8]", "[(1.0, 2.0, 3.0)]", "(value: 1e8)"] {
            assert!(ron::from_str::<OverRise>(text).is_err(), "{text}");
        }
    }
}
