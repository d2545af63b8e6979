//! Numbers along the axes of a scene in the plane or in space.

use nalgebra::SVector;
use serde::de::{Error, SeqAccess, Visitor};
use serde::ser::SerializeTuple;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt;

/// Two numbers (x, y) of a plane scene or three (x, y, z) of one in space; the last axis points up.
#[derive(Debug, Clone, PartialEq)]
pub struct Axes(Vec<f64>);

impl Axes {
    /// The numbers, 2 or 3.
    pub fn values(&self) -> &[f64] {
        &self.0
    }

    /// The numbers of a scene of `D` dimensions.
    ///
    /// # Panics
    /// If they are fewer.
    pub fn vector<const D: usize>(&self) -> SVector<f64, D> {
        SVector::from_column_slice(&self.0[..D])
    }

    /// The same number along each of `dimension` axes.
    pub fn repeat(value: f64, dimension: usize) -> Self {
        Axes(vec![value; dimension])
    }
}

impl Serialize for Axes {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut tuple = serializer.serialize_tuple(self.0.len())?;
        self.0.iter().try_for_each(|value| tuple.serialize_element(value))?;
        tuple.end()
    }
}

impl<'de> Deserialize<'de> for Axes {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_tuple(3, TwoOrThree)
    }
}

struct TwoOrThree;

impl<'de> Visitor<'de> for TwoOrThree {
    type Value = Axes;

    fn expecting(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter.write_str("a tuple of two numbers (x, y) or three (x, y, z)")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut sequence: A) -> Result<Axes, A::Error> {
        let mut values = Vec::new();
        while let Some(value) = sequence.next_element()? {
            if values.len() == 3 {
                return Err(A::Error::invalid_length(4, &self));
            }
            values.push(value);
        }
        if values.len() < 2 { Err(A::Error::invalid_length(values.len(), &self)) } else { Ok(Axes(values)) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_and_three_numbers_are_read_and_written() {
        for text in ["(1.0,-2.5)", "(1.0,-2.5,3e-3)"] {
            let axes: Axes = ron::from_str(text).unwrap();
            assert_eq!(axes.values()[..2], [1.0, -2.5]);
            let again: Axes = ron::from_str(&ron::to_string(&axes).unwrap()).unwrap();
            assert_eq!(again, axes);
        }
    }

    #[test]
    fn other_counts_are_refused() {
        for text in ["()", "(1.0)", "(1.0, 2.0, 3.0, 4.0)", "(1.0, \"a\")", "1.0"] {
            assert!(ron::from_str::<Axes>(text).is_err(), "{text}");
        }
    }
}
