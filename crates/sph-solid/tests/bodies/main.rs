//! Bodies of particles against exact solutions.

mod beam;
mod clamped_plate;
mod driven;
mod find;
mod hard;
mod hot_spot;
mod ledger;
mod motion;
mod plate;
mod reference;
mod rings;
mod rotation;
mod round;
mod thermal;
mod waves;
