//! Pools of melt held by a solid and by their own tension.

use super::super::benchmark::{larger, relative};
use super::super::{Benchmark, Mark, Quantity};
use super::{find, outcome};
use sph_fluid::Renewal;
use sph_fluid::benchmarks::pool::{HalfDiscFlow, HalfSphereFlow, Pool, PoolMeans, PoolSetting};

/// Sixty times the viscosity of liquid aluminium and 50 K: Stokes flow.
const THICK: PoolSetting =
    PoolSetting { across: 10, thickening: 60.0, artificial_viscosity: 0.0, spot: 50.0, sound_speed: 20.0 };
/// Width of the spot \[radii\].
const WIDTH: f64 = 0.7;

pub(in super::super) const HALF_DISC: Benchmark = Benchmark {
    name: "melt/half-disc-pool",
    tested_crate: "sph-fluid",
    reference: "exact series of Stokes flow in a half-disc (liquid aluminium, viscosity x 60, spot of 50 K)",
    quantities: &[
        Quantity {
            suffix: "speed",
            text: "outward speed below the top, 0.3 to 0.7 R, means over 2 ms from 2 to 16 ms, the worst, relative; \
                   resolution: spacings to the radius",
            marks: &[Mark { resolution: 10.0, error: 0.15 }],
        },
        Quantity {
            suffix: "projection",
            text: "share of the exact flow in that of all particles, likewise",
            marks: &[Mark { resolution: 10.0, error: 0.06 }],
        },
        Quantity {
            suffix: "trend",
            text: "fall of the outward speed from the mean over 2 to 9 ms to that over 9 to 16 ms, relative",
            marks: &[Mark { resolution: 10.0, error: 0.06 }],
        },
        Quantity {
            suffix: "field",
            text: "L2 error of all velocities over the L2 norm of the exact ones, the worst of the means",
            marks: &[Mark { resolution: 10.0, error: 0.3 }, Mark { resolution: 20.0, error: 0.15 }],
        },
    ],
    resolutions: [10.0, 14.0, 20.0],
    quick: 1,
    run: |resolution| {
        let exact = HalfDiscFlow::new(WIDTH);
        let setting = PoolSetting { across: resolution as usize, ..THICK };
        let mut pool = Pool::<2>::new(setting, Some(Renewal::default()), false, find)?;
        pool.run_to(2e-3);
        let ends = [4e-3, 6e-3, 8e-3, 10e-3, 12e-3, 14e-3, 16e-3];
        let means = ends.map(|end| pool.means(end, |place| exact.velocity(place)));
        let field = means.iter().map(|means| means.field).fold(0.0, larger);
        let errors = vec![worst_speed(&means), worst_projection(&means), fall(&means), field];
        Ok(outcome(&pool.patch, errors))
    },
};

pub(in super::super) const HALF_SPHERE: Benchmark = Benchmark {
    name: "melt/half-sphere-pool",
    tested_crate: "sph-fluid",
    reference: "exact series of axisymmetric Stokes flow in a half-sphere (liquid aluminium, viscosity x 60, spot of 50 K)",
    quantities: &[
        Quantity {
            suffix: "speed",
            text: "outward speed below the top, 0.3 to 0.7 R, means over 1 ms from 2 to 8 ms, the worst, relative; \
                   resolution: spacings to the radius",
            marks: &[Mark { resolution: 8.0, error: 0.15 }, Mark { resolution: 10.0, error: 0.15 }],
        },
        Quantity {
            suffix: "projection",
            text: "share of the exact flow in that of all particles, likewise",
            marks: &[Mark { resolution: 8.0, error: 0.12 }, Mark { resolution: 10.0, error: 0.12 }],
        },
        Quantity {
            suffix: "field",
            text: "L2 error of all velocities over the L2 norm of the exact ones, the worst of the means",
            marks: &[Mark { resolution: 8.0, error: 0.3 }, Mark { resolution: 10.0, error: 0.3 }],
        },
    ],
    resolutions: [8.0, 9.0, 10.0],
    quick: 1,
    run: |resolution| {
        let exact = HalfSphereFlow::new(WIDTH);
        let setting = PoolSetting { across: resolution as usize, sound_speed: 10.0, ..THICK };
        let mut pool = Pool::<3>::new(setting, Some(Renewal::default()), false, find)?;
        pool.run_to(2e-3);
        let ends = [3e-3, 4e-3, 5e-3, 6e-3, 7e-3, 8e-3];
        let means = ends.map(|end| pool.means(end, |place| exact.velocity(place)));
        let field = means.iter().map(|means| means.field).fold(0.0, larger);
        Ok(outcome(&pool.patch, vec![worst_speed(&means), worst_projection(&means), field]))
    },
};

pub(in super::super) const RESTING: Benchmark = Benchmark {
    name: "melt/resting-pool",
    tested_crate: "sph-fluid",
    reference: "a half-sphere of melt in its solid, without drive: no flow",
    quantities: &[
        Quantity {
            suffix: "speed",
            text: "largest speed in 5 ms, over sqrt(tau/(rho R)); resolution: spacings to the radius",
            marks: &[
                Mark { resolution: 6.0, error: 0.01 },
                Mark { resolution: 8.0, error: 0.01 },
                Mark { resolution: 10.0, error: 0.01 },
            ],
        },
        Quantity {
            suffix: "lost",
            text: "share of particles that lie more than half a spacing outside the pool",
            marks: &[
                Mark { resolution: 6.0, error: 0.0 },
                Mark { resolution: 8.0, error: 0.0 },
                Mark { resolution: 10.0, error: 0.0 },
            ],
        },
    ],
    resolutions: [6.0, 8.0, 10.0],
    quick: 1,
    run: |resolution| {
        let across = resolution as usize;
        let setting = PoolSetting { across, spot: 0.0, sound_speed: 10.0, ..THICK };
        let mut pool = Pool::<3>::new(setting, Some(Renewal::default()), false, find)?;
        let largest = pool.run_to(5e-3) / Pool::<3>::capillary_speed();
        Ok(outcome(&pool.patch, vec![largest, pool.share_outside(0.5)]))
    },
};

pub(in super::super) const HOT: Benchmark = Benchmark {
    name: "melt/hot-pool",
    tested_crate: "sph-fluid",
    reference: "a half-disc of melt under a spot of 200 K stays whole and its flow steady (viscosity x 20, alpha 0.1)",
    quantities: &[
        Quantity {
            suffix: "lost",
            text: "share of particles that lie more than 1.5 spacings outside the pool at 1, 2, 3 or 4 ms, the most; \
                   resolution: spacings to the radius. 10 do not carry it: two of 158 leave",
            marks: &[Mark { resolution: 20.0, error: 0.0 }],
        },
        Quantity {
            suffix: "steady",
            text: "change of the outward speed below the top from the mean over 1 to 2 ms to those over 2 to 3 and 3 to \
                   4 ms, the larger, relative",
            marks: &[Mark { resolution: 20.0, error: 0.1 }],
        },
    ],
    resolutions: [20.0, 24.0, 28.0],
    quick: 1,
    run: |resolution| {
        let exact = HalfDiscFlow::new(WIDTH);
        let across = resolution as usize;
        let setting =
            PoolSetting { across, thickening: 20.0, artificial_viscosity: 0.1, spot: 200.0, ..THICK };
        let mut pool = Pool::<2>::new(setting, Some(Renewal::default()), false, find)?;
        let [first, second, third, fourth] = [1e-3, 2e-3, 3e-3, 4e-3].map(|end| {
            let speed = pool.means(end, |place| exact.velocity(place)).outward;
            (speed, pool.share_outside(1.5))
        });
        let change = larger(relative(third.0, second.0), relative(fourth.0, second.0));
        let lost = [first, second, third, fourth].map(|(_, lost)| lost).into_iter().fold(0.0, larger);
        Ok(outcome(&pool.patch, vec![lost, change]))
    },
};

fn worst_speed(means: &[PoolMeans]) -> f64 {
    means.iter().map(|means| relative(means.speed, 1.0)).fold(0.0, larger)
}

fn worst_projection(means: &[PoolMeans]) -> f64 {
    means.iter().map(|means| relative(means.projection, 1.0)).fold(0.0, larger)
}

/// Of the outward speed, the first half of the means over the second, less one.
fn fall(means: &[PoolMeans]) -> f64 {
    let mean = |part: &[PoolMeans]| part.iter().map(|means| means.outward).sum::<f64>() / part.len() as f64;
    let half = means.len().div_ceil(2);
    1.0 - mean(&means[means.len() - half..]) / mean(&means[..half])
}
