//! Bodies of particles against exact solutions; the cases in modules of their own are run by the examples too.

mod hot_spot;
mod material;
mod motion;
mod plate;
mod reference;
mod rings;
mod round;
mod scene;
mod thermal;
mod updated;
mod updated_scene;
mod waves;
