//! Laser tracks on bare plates of IN625, measured by NIST for AM-Bench 2018-02, with heat conduction alone.
//!
//! The measured widths and depths are those of the fused zone in sections cut across the finished tracks, so the model is
//! read at everything that was ever above the liquidus. One absorptivity holds for all tracks: the one that gives the
//! first track its measured width times depth.

use super::super::benchmark::{larger, relative};
use super::super::scene::{block, constant, run, uniform_start};
use super::super::{Benchmark, BenchmarkError, Mark, Outcome, Quantity};
use crate::case::scene::{Face, Levels};
use crate::measure::Extent;
use crate::model::{Model, ModelError, TensionLaw};
use crate::run::Simulation;
use laser_source::{Absorption, Beam, Gaussian, LaserSource, Path};
use sph_fluid::SurfaceTension;
use sph_thermal::boundary::Evaporation;
use sph_thermal::phase::{Table, ThermalMaterial};

/// 1/e² radius of the beam \[m\], and temperature of the plate \[K\].
const BEAM_RADIUS: f64 = 85e-6;
const START: f64 = 293.0;

/// A track of the experiment.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Track {
    /// Power of the laser \[W\].
    power: f64,
    /// Speed of the beam \[m/s\].
    speed: f64,
    /// Width and depth of the fused zone \[m\].
    width: f64,
    depth: f64,
}

const TRACKS: [Track; 3] = [
    Track { power: 137.9, speed: 0.4, width: 148e-6, depth: 42e-6 },
    Track { power: 179.2, speed: 0.8, width: 123e-6, depth: 36e-6 },
    Track { power: 179.2, speed: 1.2, width: 106e-6, depth: 30e-6 },
];

/// Metal before the track's start, along it, beyond its end, aside of it and below it \[beam radii\]. With a track twice as
/// long, all sizes stay within 0.1 %; in this time heat goes 2.9 beam radii at most.
const ROOM: f64 = 4.0;
const WAY: f64 = 12.0;
const ASIDE: f64 = 7.0;
const BELOW: f64 = 6.0;

/// Absorptivities that the fit starts from, and how near the first track's width times depth must come, relative.
const FIRST_GUESSES: [f64; 2] = [0.28, 0.34];
const FITTED: f64 = 1e-3;
const MOST_FITS: usize = 8;

pub(in super::super) const BENCHMARK: Benchmark = Benchmark {
    name: "weld/nist-amb2018",
    tested_crate: "welder",
    reference: "NIST AM-Bench 2018-02 (Lane et al. 2020), sections of finished tracks on the AMMT; conduction alone, one \
                absorptivity, fitted to width times depth of the first track. Known to miss 10 % on the other two: measured \
                tracks keep depth over width at 0.29, conduction from a plane surface makes faster ones flatter",
    quantities: &[
        Quantity {
            suffix: "first-track",
            text: "worst relative error of width and depth, 137.9 W, 0.4 m/s, the track of the fit; resolution: spacings to \
                   the 1/e² radius of 85 um",
            marks: &[Mark { resolution: 6.0, error: 0.1 }, Mark { resolution: 12.0, error: 0.1 }],
        },
        Quantity {
            suffix: "width",
            text: "worst relative error of width, 179.2 W at 0.8 and 1.2 m/s",
            marks: &[Mark { resolution: 6.0, error: 0.1 }, Mark { resolution: 12.0, error: 0.1 }],
        },
        Quantity {
            suffix: "depth",
            text: "worst relative error of depth, 179.2 W at 0.8 and 1.2 m/s",
            marks: &[Mark { resolution: 6.0, error: 0.1 }, Mark { resolution: 12.0, error: 0.1 }],
        },
    ],
    resolutions: [6.0, 8.0, 12.0],
    quick: 1,
    run: fitted_tracks,
};

fn fitted_tracks(resolution: f64) -> Result<Outcome, BenchmarkError> {
    let (absorptivity, first) = fit(resolution)?;
    let [second, third] = [TRACKS[1], TRACKS[2]].map(|track| track.run(resolution, absorptivity));
    let (second, third) = (second?, third?);
    let worst_of = |errors: fn(&Track, &Extent) -> f64| {
        let [second, third] = [(&TRACKS[1], &second), (&TRACKS[2], &third)]
            .map(|(track, simulation)| errors(track, &simulation.gauge().weld()));
        larger(second, third)
    };
    let fused = first.gauge().weld();
    let errors = vec![
        larger(TRACKS[0].width_error(&fused), TRACKS[0].depth_error(&fused)),
        worst_of(Track::width_error),
        worst_of(Track::depth_error),
    ];
    let mut outcome = Outcome::of(&first, errors);
    outcome.pair_visits += second.cost().pair_visits + third.cost().pair_visits;
    Ok(outcome)
}

/// The absorptivity that gives the first track its measured width times depth, and the track with it: secants in the
/// logarithm of that product, which is nearly linear.
fn fit(resolution: f64) -> Result<(f64, Simulation), BenchmarkError> {
    let run = |absorptivity: f64| -> Result<(f64, Simulation), BenchmarkError> {
        let simulation = TRACKS[0].run(resolution, absorptivity)?;
        let fused = simulation.gauge().weld();
        Ok(((fused.width * fused.depth / (TRACKS[0].width * TRACKS[0].depth)).ln(), simulation))
    };
    let [mut before, mut now] = FIRST_GUESSES;
    let mut miss_before = run(before)?.0;
    let (mut miss, mut simulation) = run(now)?;
    for _ in 0..MOST_FITS {
        if miss.abs() < FITTED {
            break;
        }
        let next = now - miss * (now - before) / (miss - miss_before);
        (before, miss_before, now) = (now, miss, next);
        (miss, simulation) = run(now)?;
    }
    Ok((now, simulation))
}

impl Track {
    /// Half of the track, behind the mirror plane y = 0, with the program's levels.
    fn run(&self, resolution: f64, absorptivity: f64) -> Result<Simulation, BenchmarkError> {
        let simulation = run(self.model(resolution, absorptivity)?)?;
        let (fused, records) = (simulation.gauge().weld(), simulation.records());
        tracing::info!(
            "{} W, {} m/s, absorptivity {absorptivity:.4}: width {:.1} um, depth {:.1} um, peak {:.0} K, recoil of vapour \
             {:.2} times what tension holds",
            self.power,
            self.speed,
            1e6 * fused.width,
            1e6 * fused.depth,
            records.peak_temperature,
            records.recoil_over_tension
        );
        Ok(simulation)
    }

    fn model(&self, resolution: f64, absorptivity: f64) -> Result<Model, ModelError> {
        let counts = [2.0 * ROOM + WAY, ASIDE, BELOW].map(|radii| (radii * resolution).round() as usize);
        let mut model = block(counts, BEAM_RADIUS / resolution, vec![alloy()?])?;
        model.low_corner = [-ROOM * BEAM_RADIUS, 0.0];
        model.start = uniform_start(START);
        model.resolution.levels = Levels::Auto;
        model.faces.y_min = Face::Symmetry;
        model.evaporation = vec![Some(Evaporation::new(BOILING, HEAT_OF_EVAPORATION, MOLAR_MASS)?)];
        model.tension = Some(TensionLaw::Linear(SurfaceTension::new(TENSION, TENSION_SLOPE, LIQUIDUS)?));
        let path = Path::Straight {
            from_m: [0.0; 2],
            to_m: [WAY * BEAM_RADIUS, 0.0],
            speed_m_s: self.speed,
            power_w: self.power,
            start_s: 0.0,
        };
        let beam = Beam::Gaussian(Gaussian::from_radius_1e2(BEAM_RADIUS));
        model.laser = Some(LaserSource::new(beam, path, Absorption::Surface { absorptivity })?);
        model.end = WAY * BEAM_RADIUS / self.speed;
        Ok(model)
    }

    fn width_error(&self, fused: &Extent) -> f64 {
        relative(fused.width, self.width)
    }

    fn depth_error(&self, fused: &Extent) -> f64 {
        relative(fused.depth, self.depth)
    }
}

/// Vapour as in `cases/materials/in625.ron`: boiling point \[K\], heat of evaporation \[J/kg\], molar mass \[kg/mol\]. No heat of
/// evaporation is taken; the recoil that it would have is told.
const BOILING: f64 = 3190.0;
const HEAT_OF_EVAPORATION: f64 = 6.4e6;
const MOLAR_MASS: f64 = 0.0587;

/// Surface tension of liquid nickel \[N/m\], about, at the liquidus \[K\] of the alloy, and its slope \[N/(m K)\].
const TENSION: f64 = 1.75;
const TENSION_SLOPE: f64 = -3.5e-4;
const LIQUIDUS: f64 = 1620.0;

/// IN625 as in `cases/materials/in625.ron`: conductivities are lines up to their ends, then constant.
fn alloy() -> Result<ThermalMaterial, sph_thermal::Error> {
    let line = |at_zero: f64, slope: f64, ends: [f64; 2]| {
        Table::new(ends.map(|temperature| (temperature, at_zero + slope * temperature)).to_vec())
    };
    Ok(ThermalMaterial {
        density: 7570.0,
        solidus: 1410.0,
        liquidus: LIQUIDUS,
        latent_heat: 2.175e5,
        heat_capacity_solid: constant(579.0),
        heat_capacity_liquid: constant(751.0),
        conductivity_solid: line(8.275, 0.01472, [200.0, 1620.0])?,
        conductivity_liquid: line(4.889, 0.014743, [1410.0, 4500.0])?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_track_is_fused_from_its_start_to_its_end() {
        let simulation = TRACKS[0].run(4.0, 0.3).unwrap();
        let fused = simulation.gauge().weld();
        let way = WAY * BEAM_RADIUS;
        assert!(fused.length > way && fused.length < way + 3.0 * BEAM_RADIUS, "{}", fused.length);
        let error = larger(TRACKS[0].width_error(&fused), TRACKS[0].depth_error(&fused));
        assert!(error < 0.1, "{error}");
    }
}
