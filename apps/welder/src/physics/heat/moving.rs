//! Conduction by rows computed anew at every stage: the form for particles that move, and the slow reference of the
//! stored rows.

use crate::build::{Neighborhood, Workpiece};
use crate::physics::rows::{RowTerm, Sweep};
use sph_kernel::operators::laplacian_moment;
use sph_kernel::{KernelKind, Row};
use sph_thermal::conduction::moving::{Fields, conduction_row};

/// Rows of a workpiece that are computed when they are needed.
pub(super) struct MovingRows {
    sweep: Sweep<3>,
    volume: Vec<f64>,
    moment: Vec<f64>,
    /// The particle that each copy shows.
    source: Vec<u32>,
    pairs: usize,
}

/// Second moments of the rows.
struct Moments<'a> {
    volume: &'a [f64],
}

impl RowTerm<3> for Moments<'_> {
    fn width(&self) -> usize {
        1
    }

    fn row(&self, row: &Row<'_, 3>, out: &mut [f64]) {
        out[0] = laplacian_moment(row, self.volume);
    }
}

/// Conducted heat \[W\].
struct Conduction<'a>(Fields<'a>);

impl RowTerm<3> for Conduction<'_> {
    fn width(&self) -> usize {
        1
    }

    fn row(&self, row: &Row<'_, 3>, out: &mut [f64]) {
        out[0] = conduction_row(row, &self.0);
    }
}

impl MovingRows {
    /// Takes over the neighbourhood of a workpiece, whose faces must all mirror.
    pub(super) fn new(workpiece: &Workpiece, neighborhood: Neighborhood, kernel: KernelKind) -> Self {
        let Neighborhood { positions, list, images, ratio } = neighborhood;
        let particles = &workpiece.particles;
        let of_all = |column: &[f64]| -> Vec<f64> {
            let copies = images.source.iter().map(|&source| column[source as usize]);
            column.iter().copied().chain(copies).collect()
        };
        let smoothing_lengths = of_all(&particles.spacing).iter().map(|spacing| ratio * spacing).collect();
        let volume = of_all(&particles.volume);
        let owned = particles.len();
        let sweep = Sweep { owned, positions, smoothing_lengths, list, kernel };
        let mut own = vec![0.0; owned];
        sweep.run(&[&Moments { volume: &volume }], &mut own);
        Self { moment: of_all(&own), pairs: sweep.pairs(), sweep, volume, source: images.source }
    }

    /// Length of a column over particles and copies.
    pub(super) fn column_len(&self) -> usize {
        self.volume.len()
    }

    /// Directed pairs of one sweep.
    pub(super) fn pairs(&self) -> usize {
        self.pairs
    }

    /// Heat \[W\] that each particle receives at `potential` \[W/m\]; `seen` is a column over particles and copies to work in.
    pub(super) fn heat(&self, potential: &[f64], seen: &mut [f64], heat: &mut [f64]) {
        let (own, copies) = seen.split_at_mut(self.sweep.owned);
        own.copy_from_slice(&potential[..own.len()]);
        copies.iter_mut().zip(&self.source).for_each(|(copy, &source)| *copy = own[source as usize]);
        let fields = Fields { volume: &self.volume, moment: &self.moment, potential: seen };
        self.sweep.run(&[&Conduction(fields)], &mut heat[..self.sweep.owned]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::{Members, mirrors, pair_table};
    use crate::case::library::cases_folder;
    use crate::case::load;
    use crate::case::scene::Weights;
    use crate::model::Model;
    use crate::run::{Simulation, level_plan};

    fn model(settings: &[&str]) -> Model {
        let settings: Vec<String> = settings.iter().map(|text| text.to_string()).collect();
        let case = load(&cases_folder().unwrap().join("spot-aluminium"), &settings).unwrap();
        Model::from_case(&case).unwrap()
    }

    #[test]
    fn rows_computed_anew_conduct_what_stored_rows_conduct_on_levels_and_under_disorder() {
        for disorder in ["resolution.disorder=0", "resolution.disorder=0.2"] {
            let model = model(&["resolution.spacing_m=150e-6", disorder]);
            let workpiece = Workpiece::new(&model, &level_plan(&model, 0.0).unwrap());
            let all = Members::all(workpiece.particles.len());
            let planes = mirrors(&workpiece, &model.faces, Weights::Moving);
            let kernel = KernelKind::CubicSpline;
            let neighborhood = Neighborhood::new(&workpiece, &planes, &all, kernel, 1.3).unwrap();
            let volumes = &workpiece.particles.volume;
            let pairs = pair_table(&workpiece, &all, &neighborhood, volumes, kernel).unwrap();
            let stored = pairs.normalized();
            drop(pairs);
            let moving = MovingRows::new(&workpiece, neighborhood, kernel);
            let count = workpiece.particles.len();
            let potential: Vec<f64> = (0..count).map(|i| ((i * i) as f64).sin()).collect();
            let expected = stored.heat(&potential);
            let (mut seen, mut heat) = (vec![0.0; moving.column_len()], vec![0.0; count]);
            moving.heat(&potential, &mut seen, &mut heat);
            let scale = expected.iter().fold(0.0f64, |largest, q| largest.max(q.abs()));
            for i in 0..count {
                assert!(
                    (heat[i] - expected[i]).abs() < 1e-12 * scale,
                    "{i}: {} against {}",
                    heat[i],
                    expected[i]
                );
            }
        }
    }

    #[test]
    fn a_weld_with_rows_computed_anew_is_that_of_stored_rows() {
        let weld = |weights: &str| {
            let heat =
                format!("physics.0=Heat(weights: {weights}, kernel: CubicSpline, smoothing_ratio: 1.3)");
            let settings = ["resolution.spacing_m=150e-6", "time.end_s=0.002", heat.as_str()];
            let mut simulation = Simulation::new(model(&settings)).unwrap();
            simulation.run_quietly().unwrap();
            (simulation.records().liquidus, simulation.ledger().residual)
        };
        let ((stored, _), (moving, residual)) = (weld("Normalized"), weld("Moving"));
        assert!(stored.depth > 1e-4 && (moving.depth / stored.depth - 1.0).abs() < 1e-6);
        assert!((moving.width / stored.width - 1.0).abs() < 1e-6);
        assert!(residual.abs() < 1e-12, "{residual}");
    }
}
