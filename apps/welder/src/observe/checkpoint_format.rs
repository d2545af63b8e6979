//! The bytes of a checkpoint: an envelope that shows damage, around a state that keeps every bit.
//!
//! ```text
//! magic (8) | format (u32) | payload length (u64) | payload | CRC-32 of all before it (u32)
//! ```
//! All numbers are little endian.
//! The payload is [postcard](https://postcard.jamesmunns.com): numbers go as their bits, never as text.

use super::checkpoint_error::CheckpointError;
use crate::version;
use nalgebra::SVector;
use serde::{Deserialize, Serialize, de::DeserializeOwned};
use std::fs::File;
use std::io::Read;
use std::path::Path;

const MAGIC: &[u8; 8] = b"LIQUIDUS";
const FORMAT: u32 = 1;
const HEADER_BYTES: usize = 8 + 4 + 8;
const CHECKSUM_BYTES: usize = 4;

/// Everything that a run needs to go on as if it had never stopped.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Checkpoint {
    /// The program that wrote it, [`version::PROGRAM`]: another may compute other bits, or lay out its state in another way.
    pub version: String,
    /// Digest of the resolved case, from [`case_digest`].
    pub case_digest: u32,
    /// Physical time reached.
    pub time_s: f64,
    /// Steps taken.
    pub step: u64,
    /// The state of the run loop and of each physics that is not a column, encoded by its owner.
    pub state: Vec<u8>,
    /// The columns by name, encoded by [`Checkpoint::put_column`].
    pub columns: Vec<(String, Vec<u8>)>,
}

impl Checkpoint {
    /// A checkpoint of this program, still without state and columns.
    pub fn new(case_digest: u32, time_s: f64, step: u64) -> Self {
        let version = version::PROGRAM.to_string();
        Self { version, case_digest, time_s, step, state: Vec::new(), columns: Vec::new() }
    }

    /// Stores a column under a name.
    pub fn put_column<T: Serialize>(&mut self, name: &str, values: &[T]) -> Result<(), CheckpointError> {
        self.columns.push((name.to_string(), encode(name, values)?));
        Ok(())
    }

    /// The column of a name, as the type it was stored with.
    pub fn column<T: DeserializeOwned>(&self, name: &str) -> Result<Vec<T>, CheckpointError> {
        let missing =
            || CheckpointError::Content { name: name.to_string(), reason: "there is none".to_string() };
        let (_, bytes) = self.columns.iter().find(|(stored, _)| stored == name).ok_or_else(missing)?;
        decode(name, bytes)
    }

    /// A column of `count` numbers.
    pub fn numbers(&self, name: &str, count: usize) -> Result<Vec<f64>, CheckpointError> {
        let column: Vec<f64> = self.column(name)?;
        let reason = format!("it is of {} numbers; the case has {count}", column.len());
        let fits = column.len() == count;
        fits.then_some(column).ok_or(CheckpointError::Content { name: name.into(), reason })
    }

    /// Stores a column of vectors under a name.
    pub fn put_vectors<const D: usize>(
        &mut self,
        name: &str,
        vectors: &[SVector<f64, D>],
    ) -> Result<(), CheckpointError> {
        self.put_column(name, &vectors.iter().flat_map(|x| x.iter().copied()).collect::<Vec<f64>>())
    }

    /// A column of `count` vectors.
    pub fn vectors<const D: usize>(
        &self,
        name: &str,
        count: usize,
    ) -> Result<Vec<SVector<f64, D>>, CheckpointError> {
        let flat = self.numbers(name, D * count)?;
        Ok(flat.chunks_exact(D).map(SVector::from_column_slice).collect())
    }

    /// Stores the state of the run loop.
    pub fn put_state<T: Serialize>(&mut self, state: &T) -> Result<(), CheckpointError> {
        self.state = encode("state", state)?;
        Ok(())
    }

    /// The state of the run loop, as the type it was stored with.
    pub fn state<T: DeserializeOwned>(&self) -> Result<T, CheckpointError> {
        decode("state", &self.state)
    }

    /// The bytes of the file.
    pub fn to_bytes(&self) -> Result<Vec<u8>, CheckpointError> {
        let payload = encode("payload", self)?;
        let mut bytes = Vec::with_capacity(HEADER_BYTES + payload.len() + CHECKSUM_BYTES);
        bytes.extend_from_slice(MAGIC);
        bytes.extend_from_slice(&FORMAT.to_le_bytes());
        bytes.extend_from_slice(&(payload.len() as u64).to_le_bytes());
        bytes.extend_from_slice(&payload);
        bytes.extend_from_slice(&crc32fast::hash(&bytes).to_le_bytes());
        Ok(bytes)
    }

    /// Reads a file. Nothing is read behind a header that does not fit the length of the file.
    pub fn read(path: &Path) -> Result<Self, CheckpointError> {
        let refused = |source| CheckpointError::File { action: "read", path: path.to_path_buf(), source };
        let mut file = File::open(path).map_err(refused)?;
        let length = file.metadata().map_err(refused)?.len();
        let mut bytes = Vec::new();
        file.by_ref().take(HEADER_BYTES as u64).read_to_end(&mut bytes).map_err(refused)?;
        check_header(&bytes, length, path)?;
        file.read_to_end(&mut bytes).map_err(refused)?;
        Self::from_bytes(&bytes, path)
    }

    /// Reads the bytes of a file; `path` is for the messages.
    pub fn from_bytes(bytes: &[u8], path: &Path) -> Result<Self, CheckpointError> {
        let damaged = |reason: String| CheckpointError::Damaged { path: path.to_path_buf(), reason };
        let format = check_header(bytes, bytes.len() as u64, path)?;
        let rest = &bytes[HEADER_BYTES..];
        let (payload, checksum) = rest.split_at(rest.len() - CHECKSUM_BYTES);
        if crc32fast::hash(&bytes[..HEADER_BYTES + payload.len()]) as u64 != little_endian(checksum) {
            return Err(damaged("the checksum does not match".to_string()));
        }
        if format != FORMAT {
            return Err(CheckpointError::OtherFormat {
                path: path.to_path_buf(),
                found: format,
                expected: FORMAT,
            });
        }
        postcard::from_bytes(payload)
            .map_err(|error| damaged(format!("the content cannot be decoded, {error}")))
    }
}

/// The format that a header names, when it is one of a file of `length` bytes.
fn check_header(bytes: &[u8], length: u64, path: &Path) -> Result<u32, CheckpointError> {
    let damaged = |reason: String| CheckpointError::Damaged { path: path.to_path_buf(), reason };
    let Some(header) = bytes.first_chunk::<HEADER_BYTES>() else {
        return Err(damaged(format!("truncated to {} bytes", bytes.len())));
    };
    if !header.starts_with(MAGIC) {
        return Err(damaged("it does not start as a checkpoint does".to_string()));
    }
    let expected = little_endian(&header[12..20]);
    let found = length - HEADER_BYTES as u64;
    if expected.checked_add(CHECKSUM_BYTES as u64) != Some(found) {
        return Err(damaged(format!("truncated or overlong, {found} bytes where {expected} + 4 belong")));
    }
    Ok(little_endian(&header[8..12]) as u32)
}

/// A digest of the resolved case, to tell cases apart.
pub fn case_digest(resolved_case: &str) -> u32 {
    crc32fast::hash(resolved_case.as_bytes())
}

fn encode<T: Serialize + ?Sized>(name: &str, value: &T) -> Result<Vec<u8>, CheckpointError> {
    postcard::to_stdvec(value)
        .map_err(|error| CheckpointError::Content { name: name.to_string(), reason: error.to_string() })
}

fn decode<T: DeserializeOwned>(name: &str, bytes: &[u8]) -> Result<T, CheckpointError> {
    postcard::from_bytes(bytes)
        .map_err(|error| CheckpointError::Content { name: name.to_string(), reason: error.to_string() })
}

fn little_endian(bytes: &[u8]) -> u64 {
    bytes.iter().rev().fold(0, |number, &byte| number << 8 | u64::from(byte))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn example() -> Checkpoint {
        let mut checkpoint = Checkpoint {
            version: "0.1.0".into(),
            case_digest: case_digest("spot"),
            time_s: 0.1 + 0.2,
            step: 1_234_567,
            state: Vec::new(),
            columns: Vec::new(),
        };
        checkpoint.put_state(&(3_u64, -0.0_f64)).unwrap();
        checkpoint.put_column("temperature_k", &[293.15, f64::MIN_POSITIVE / 3.0, -0.0, f64::MAX]).unwrap();
        checkpoint.put_column("phase", &[0_u8, 1, 2]).unwrap();
        checkpoint
    }

    fn read(bytes: &[u8]) -> Result<Checkpoint, CheckpointError> {
        Checkpoint::from_bytes(bytes, Path::new("checkpoint_7.bin"))
    }

    #[test]
    fn another_format_with_a_right_checksum_is_refused_as_such() {
        let mut bytes = example().to_bytes().unwrap();
        bytes[8] = 9;
        let end = bytes.len() - CHECKSUM_BYTES;
        let checksum = crc32fast::hash(&bytes[..end]).to_le_bytes();
        bytes[end..].copy_from_slice(&checksum);
        assert!(matches!(read(&bytes), Err(CheckpointError::OtherFormat { found: 9, .. })));
    }

    #[test]
    fn every_truncation_is_refused_and_names_the_file() {
        let bytes = example().to_bytes().unwrap();
        for length in 0..bytes.len() {
            let error = read(&bytes[..length]).unwrap_err();
            assert!(
                error.to_string().starts_with("the checkpoint checkpoint_7.bin is damaged: trunc"),
                "{error}"
            );
        }
    }

    #[test]
    fn every_single_flipped_bit_is_refused() {
        let mut bytes = example().to_bytes().unwrap();
        for bit in 0..8 * bytes.len() {
            bytes[bit / 8] ^= 1 << (bit % 8);
            assert!(matches!(read(&bytes), Err(CheckpointError::Damaged { .. })), "bit {bit}");
            bytes[bit / 8] ^= 1 << (bit % 8);
        }
        assert_eq!(read(&bytes).unwrap(), example());
    }

    #[test]
    fn a_missing_column_or_another_type_is_named() {
        let error = example().column::<f64>("enthalpy_j_kg").unwrap_err();
        assert_eq!(error.to_string(), "the checkpoint has no usable `enthalpy_j_kg`: there is none");
        assert!(example().column::<f64>("phase").unwrap_err().to_string().contains("`phase`"));
        assert_eq!(example().column::<u8>("phase").unwrap(), [0, 1, 2]);
    }

    proptest! {
        #[test]
        fn any_bits_come_back(bits in prop::collection::vec(any::<u64>(), 0..50), time_s: f64, step: u64) {
            let mut checkpoint = Checkpoint { time_s, step, ..example() };
            let values: Vec<f64> = bits.iter().map(|&bits| f64::from_bits(bits)).collect();
            checkpoint.put_column("any", &values).unwrap();
            let back = read(&checkpoint.to_bytes().unwrap()).unwrap();
            let back_values: Vec<f64> = back.column("any").unwrap();
            prop_assert_eq!(back_values.iter().map(|value| value.to_bits()).collect::<Vec<_>>(), bits);
            prop_assert_eq!((back.time_s.to_bits(), back.step), (time_s.to_bits(), step));
            prop_assert_eq!(back.state::<(u64, f64)>().unwrap().1.to_bits(), (-0.0_f64).to_bits());
        }

        #[test]
        fn damage_in_several_places_never_passes(
            flips in prop::collection::vec((any::<prop::sample::Index>(), 1_u8..), 1..20),
            cut: prop::sample::Index,
        ) {
            let whole = example().to_bytes().unwrap();
            let mut bytes = whole.clone();
            for (place, flip) in flips {
                let place = place.index(bytes.len());
                bytes[place] ^= flip;
            }
            prop_assert!(bytes == whole || read(&bytes).is_err());
            bytes.truncate(cut.index(bytes.len()));
            prop_assert!(read(&bytes).is_err());
        }

        #[test]
        fn any_bytes_are_refused_without_panic(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
            prop_assert!(read(&bytes).is_err());
            let framed: Vec<u8> = MAGIC.iter().copied().chain(bytes).collect();
            prop_assert!(read(&framed).is_err());
        }
    }
}
