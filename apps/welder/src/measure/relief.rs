//! The top of a weld whose melt has flowed: crown, dip and roughness.

use crate::build::Workpiece;
use crate::particles::Particles;

/// Heights of the weld's top over the top face of the part \[m\], from the highest particle of each column of cells.
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
    ///
    /// On the lattice the highest particle stands half a spacing below the face, so that a weld that has not flowed is flat.
    pub fn of(
        workpiece: &Workpiece,
        particles: &Particles<3>,
        has_melted: impl Fn(usize) -> bool,
    ) -> Option<Self> {
        let [nx, ny, _] = workpiece.finest.counts();
        let spacing = workpiece.spacing;
        let mut tops = vec![f64::NEG_INFINITY; nx * ny];
        let mut melted = vec![false; nx * ny];
        for i in 0..particles.len() {
            let place = |axis: usize| {
                let low = workpiece.low[axis] + workpiece.finest.low[axis] as f64 * spacing;
                ((particles.position[i][axis] - low) / spacing).floor()
            };
            let (x, y) = (place(0), place(1));
            if x >= 0.0 && y >= 0.0 && (x as usize) < nx && (y as usize) < ny {
                let column = y as usize * nx + x as usize;
                tops[column] = tops[column].max(particles.position[i].z + 0.5 * particles.spacing[i]);
                melted[column] |= has_melted(i);
            }
        }
        let heights: Vec<f64> =
            tops.iter().zip(&melted).filter(|(_, melted)| **melted).map(|(top, _)| *top).collect();
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::LevelPlan;
    use crate::case::library::cases_folder;
    use crate::case::load;
    use crate::model::Model;

    #[test]
    fn a_lattice_is_flat_and_a_lifted_column_is_the_crown() {
        let settings = ["resolution.spacing_m=100e-6".to_string()];
        let case = load(&cases_folder().unwrap().join("flow-spot-aluminium"), &settings).unwrap();
        let model = Model::from_case(&case).unwrap();
        let mut workpiece = Workpiece::new(&model, &LevelPlan::uniform(model.counts()));
        assert_eq!(Relief::of(&workpiece, &workpiece.particles, |_| false), None);
        let flat = Relief::of(&workpiece, &workpiece.particles, |_| true).unwrap();
        assert!(flat.crown.abs() + flat.dip.abs() + flat.roughness < 1e-12, "{flat:?}");
        let top = workpiece.finest_particles[0] as usize;
        workpiece.particles.position[top].z += 30e-6;
        let lifted = Relief::of(&workpiece, &workpiece.particles, |_| true).unwrap();
        // One of n columns at h: rms h sqrt((n - 1)/n)/sqrt(n).
        let n = (workpiece.finest.counts()[0] * workpiece.finest.counts()[1]) as f64;
        let expected = 30e-6 * ((n - 1.0) / n / n).sqrt();
        assert!((lifted.crown - 30e-6).abs() < 1e-12 && lifted.dip.abs() < 1e-12, "{lifted:?}");
        assert!((lifted.roughness / expected - 1.0).abs() < 1e-9, "{lifted:?} {expected}");
    }
}
