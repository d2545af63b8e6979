//! The top of a weld whose melt has flowed: crown, dip and roughness.

use crate::build::Workpiece;
use crate::particles::Particles;
use crate::physics::flow::SMOOTHING_RATIO;
use sph_kernel::{KernelKind, ScaledKernel};

/// Columns of cells on each side of one that its kernel reaches.
const BESIDE: i64 = 3;

/// Steps \[spacings\] in which the surface is looked for from above.
const STEP: f64 = 0.25;

/// Halvings of the last step: to 1e-4 of a spacing.
const HALVINGS: usize = 11;

/// Heights of the weld's top over the top face of the part \[m\], read in the middle of each column of cells.
///
/// The top is where the colour, the sum of V W over all particles, falls to one half, as it does on a plane face. A
/// single particle changes that by a small part of a spacing, and a drop in flight not at all; what is narrower than
/// the kernel looks lower than it is.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Relief {
    /// Highest column.
    pub crown: f64,
    /// Lowest column, positive downwards.
    pub dip: f64,
    /// Root mean square over the columns about their mean.
    pub roughness: f64,
}

impl Relief {
    /// The relief of the columns in which a particle `has_melted`; `None` where none has.
    pub fn of(
        workpiece: &Workpiece,
        particles: &Particles<3>,
        has_melted: impl Fn(usize) -> bool,
    ) -> Option<Self> {
        let columns = Columns::new(workpiece, particles);
        let molten = |column: &usize| columns.members[*column].iter().any(|&i| has_melted(i as usize));
        let heights: Vec<f64> =
            (0..columns.members.len()).filter(molten).map(|column| columns.height(column)).collect();
        let count = heights.len() as f64;
        let mean = heights.iter().sum::<f64>() / count;
        let squares = heights.iter().map(|height| (height - mean).powi(2)).sum::<f64>();
        let extreme = |best: fn(f64, f64) -> f64| heights.iter().copied().reduce(best);
        Some(Self {
            crown: extreme(f64::max)?,
            dip: -extreme(f64::min)?,
            roughness: (squares / count).sqrt(),
        })
    }
}

/// Particles by the column of finest cells that they stand in.
struct Columns<'a> {
    particles: &'a Particles<3>,
    kernel: ScaledKernel<3>,
    spacing: f64,
    /// Underside of the part \[m\].
    bottom: f64,
    counts: [i64; 2],
    low: [f64; 2],
    /// For each column, first axis fastest.
    members: Vec<Vec<u32>>,
}

impl<'a> Columns<'a> {
    fn new(workpiece: &Workpiece, particles: &'a Particles<3>) -> Self {
        let ([nx, ny, _], spacing) = (workpiece.finest.counts(), workpiece.spacing);
        let low = [0, 1].map(|axis| workpiece.low[axis] + workpiece.finest.low[axis] as f64 * spacing);
        let mut members = vec![Vec::new(); nx * ny];
        for (i, position) in particles.position.iter().enumerate() {
            let [x, y] = [0, 1].map(|axis| ((position[axis] - low[axis]) / spacing).floor());
            if x >= 0.0 && y >= 0.0 && (x as usize) < nx && (y as usize) < ny {
                members[y as usize * nx + x as usize].push(i as u32);
            }
        }
        let kernel = KernelKind::WendlandC2.with_smoothing_length(SMOOTHING_RATIO * spacing);
        let counts = [nx as i64, ny as i64];
        Self { particles, kernel, spacing, bottom: workpiece.low[2], counts, low, members }
    }

    /// Height of the surface in the middle of a column \[m\]; where there is a hole, the underside.
    fn height(&self, column: usize) -> f64 {
        let near = self.near(column);
        let colour = |z: f64| -> f64 {
            near.iter()
                .map(|&(aside, height, volume)| volume * self.kernel.value(aside.hypot(height - z)))
                .sum()
        };
        let mut high = near.iter().map(|&(_, height, _)| height).fold(self.bottom, f64::max)
            + self.kernel.support_radius();
        let mut low = high - STEP * self.spacing;
        while colour(low) < 0.5 {
            if low < self.bottom {
                return self.bottom;
            }
            (high, low) = (low, low - STEP * self.spacing);
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if colour(middle) < 0.5 { high = middle } else { low = middle }
        }
        0.5 * (low + high)
    }

    /// Particles in reach of a column's middle: distance aside \[m\], height \[m\] and volume \[m³\]. Ends of the grid
    /// mirror.
    fn near(&self, column: usize) -> Vec<(f64, f64, f64)> {
        let (nx, reach) = (self.counts[0], self.kernel.support_radius());
        let home = [column as i64 % nx, column as i64 / nx];
        let mut near = Vec::new();
        for place in 0..(2 * BESIDE + 1).pow(2) {
            let at = [place % (2 * BESIDE + 1), place / (2 * BESIDE + 1)];
            let [x, y]: [i64; 2] = std::array::from_fn(|axis| home[axis] + at[axis] - BESIDE);
            // The grid and its image take turns.
            let folded: [i64; 2] = std::array::from_fn(|axis| [x, y][axis].rem_euclid(2 * self.counts[axis]));
            let mirrored: [bool; 2] = std::array::from_fn(|axis| folded[axis] >= self.counts[axis]);
            let source: [i64; 2] = std::array::from_fn(|axis| match mirrored[axis] {
                true => 2 * self.counts[axis] - 1 - folded[axis],
                false => folded[axis],
            });
            for &i in &self.members[(source[1] * nx + source[0]) as usize] {
                let position = &self.particles.position[i as usize];
                let aside = [0, 1].map(|axis| {
                    let middle = self.low[axis] + (source[axis] as f64 + 0.5) * self.spacing;
                    let within = position[axis] - middle;
                    let cells = ([x, y][axis] - home[axis]) as f64;
                    cells * self.spacing + if mirrored[axis] { -within } else { within }
                });
                let aside = aside[0].hypot(aside[1]);
                if aside < reach {
                    near.push((aside, position.z, self.particles.volume[i as usize]));
                }
            }
        }
        near
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::LevelPlan;
    use crate::case::library::cases_folder;
    use crate::case::load;
    use crate::model::Model;

    #[test]
    fn a_lattice_is_flat_and_a_wave_has_its_crest_and_trough() {
        let settings = ["resolution.spacing_m=50e-6".to_string()];
        let case = load(&cases_folder().unwrap().join("flow-spot-aluminium"), &settings).unwrap();
        let model = Model::from_case(&case).unwrap();
        let mut workpiece = Workpiece::new(&model, &LevelPlan::uniform(model.counts()));
        assert_eq!(Relief::of(&workpiece, &workpiece.particles, |_| false), None);
        let flat = Relief::of(&workpiece, &workpiece.particles, |_| true).unwrap();
        // The face is found to half a hundredth of a spacing.
        assert!(flat.crown.abs() < 0.25e-6 && flat.dip.abs() < 0.25e-6 && flat.roughness < 1e-9, "{flat:?}");
        // A wave as long as the part, with troughs at its sides, where its image goes on.
        for position in &mut workpiece.particles.position {
            position.z += 30e-6 * (std::f64::consts::PI * position.x / 1e-3).cos();
        }
        let wave = Relief::of(&workpiece, &workpiece.particles, |_| true).unwrap();
        for found in [wave.crown, wave.dip, wave.roughness * 2.0_f64.sqrt()] {
            assert!((found / 30e-6 - 1.0).abs() < 0.03, "{wave:?}");
        }
    }

    #[test]
    fn a_drop_in_flight_is_no_crown_and_a_hole_is_as_deep_as_the_part() {
        let case = load(&cases_folder().unwrap().join("flow-spot-aluminium"), &[]).unwrap();
        let model = Model::from_case(&case).unwrap();
        let mut workpiece = Workpiece::new(&model, &LevelPlan::uniform(model.counts()));
        let [nx, ny, _] = workpiece.finest.counts();
        let middle = workpiece.finest_particles[nx * (ny / 2) + nx / 2] as usize;
        workpiece.particles.position[middle].z += 1e-3;
        let flat = Relief::of(&workpiece, &workpiece.particles, |_| true).unwrap();
        assert!(flat.crown < 1e-6 && flat.dip < 0.5 * workpiece.spacing, "{flat:?}");
        for position in &mut workpiece.particles.position {
            if position.xy().norm() < 0.3e-3 {
                position.z -= 5e-3;
            }
        }
        let pierced = Relief::of(&workpiece, &workpiece.particles, |_| true).unwrap();
        assert_eq!(pierced.dip, model.size[2]);
    }
}
