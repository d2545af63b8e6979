//! Hostile files: whatever stands in a scene, a material card or a checkpoint, the answer is a value or a refusal that
//! names the file. Nothing crashes, memory stays bounded, and nothing is written outside the folder of results.

#[path = "../support/fluid.rs"]
mod fluid;
#[path = "../support/good.rs"]
mod good;
#[path = "../support/solid.rs"]
mod solid;
#[path = "../support/stress.rs"]
mod stress;

mod checkpoints;
mod escape;
mod materials;
mod memory;
mod mutation;
mod scenes;
