//! Rows of a workpiece in which melt flows: kept where nothing has moved, renewed where something has.
//!
//! A row is renewed with normalised weights where the particle or one of its neighbours has moved. A row beside it takes the
//! new weights of the pairs that it shares with renewed ones, and keeps the others, fitted or not: each pair has one weight,
//! seen from both ends, so that heat is exchanged and never made.

use crate::build::{Members, Neighborhood, Workpiece, pair_table};
use crate::model::ModelError;
use crate::particles::bounding_box;
use nalgebra::Vector3;
use sph_kernel::{Kernel, KernelKind};
use sph_thermal::conduction::{ConductionRows, PairTable, Planes};

/// How rows are made: the same for all of them.
#[derive(Debug, Clone, Copy)]
pub(super) struct RowRule {
    /// What mirrors.
    pub planes: Planes<3>,
    pub kernel: KernelKind,
    /// Smoothing length over spacing.
    pub ratio: f64,
}

/// The rows, and where their particles were when they were made.
pub(super) struct RenewedRows {
    rule: RowRule,
    rows: ConductionRows,
    placed: Vec<Vector3<f64>>,
    /// Second moment of each particle's row.
    moments: Vec<f64>,
    /// Which rows have ever been renewed.
    renewed: Vec<bool>,
    /// Whether all of those are to be made anew, because the particles are those of a checkpoint.
    stale: bool,
}

impl RenewedRows {
    /// Takes over the `rows` that were made from `pairs`.
    pub(super) fn new(
        rule: RowRule,
        rows: ConductionRows,
        pairs: &PairTable<'_, 3>,
        workpiece: &Workpiece,
    ) -> Self {
        Self {
            rule,
            rows,
            placed: workpiece.particles.position.clone(),
            moments: pairs.moments(),
            renewed: vec![false; workpiece.particles.len()],
            stale: false,
        }
    }

    pub(super) fn rows(&self) -> &ConductionRows {
        &self.rows
    }

    /// Which rows have ever been renewed: what a checkpoint must hold.
    pub(super) fn renewed(&self) -> &[bool] {
        &self.renewed
    }

    /// Takes up what [`renewed`](Self::renewed) gave; the next [`renew`](Self::renew) makes those rows.
    pub(super) fn restore(&mut self, renewed: Vec<bool>) {
        (self.renewed, self.stale) = (renewed, true);
    }

    /// Renews what the particles that have moved since the last time make necessary; returns the rows that have changed,
    /// rising.
    ///
    /// # Errors
    /// [`ModelError`] when the neighbour search refuses the particles.
    pub(super) fn renew(&mut self, workpiece: &Workpiece) -> Result<Vec<u32>, ModelError> {
        let positions = &workpiece.particles.position;
        let moved: Vec<usize> = (0..positions.len()).filter(|&i| positions[i] != self.placed[i]).collect();
        let mut renewed: Vec<usize> = moved.clone();
        for &i in &moved {
            renewed.extend(self.rows.row(i).0.iter().map(|&j| j as usize));
        }
        if std::mem::take(&mut self.stale) {
            renewed.extend((0..positions.len()).filter(|&i| self.renewed[i]));
        }
        if renewed.is_empty() {
            return Ok(Vec::new());
        }
        let members = self.members(workpiece, &renewed);
        let neighborhood =
            Neighborhood::new(workpiece, &self.rule.planes, &members, self.rule.kernel, self.rule.ratio)?;
        let mut local = vec![false; members.len()];
        for k in renewed.iter().filter_map(|&i| members.find(i)) {
            local[k] = true;
        }
        for k in moved.iter().filter_map(|&i| members.find(i)) {
            neighborhood.row(k).for_each(|end| local[end] = true);
        }
        let volumes = members.gather(&workpiece.particles.volume);
        let pairs = pair_table(workpiece, &members, &neighborhood, &volumes, self.rule.kernel)?;
        let changed = self.replace(&members, &local, &pairs);
        for i in moved {
            self.placed[i] = positions[i];
        }
        Ok(changed)
    }

    /// Everyone near the rows to renew: their neighbours, and those of new neighbours.
    fn members(&self, workpiece: &Workpiece, renewed: &[usize]) -> Members {
        let positions = &workpiece.particles.position;
        let support = Kernel::<3>::support_radius(self.rule.kernel, 1.0) * self.rule.ratio;
        let places = renewed.iter().flat_map(|&i| [&positions[i], &self.placed[i]]);
        let [low, high] = bounding_box(places);
        let largest = renewed.iter().map(|&i| workpiece.particles.spacing[i]).fold(0.0, f64::max);
        let within = |supports: f64| {
            let margin = Vector3::repeat(supports * support * largest);
            Members::within(positions, low - margin, high + margin)
        };
        // A neighbour is of the next level at most: twice the spacing, and half of it in the mean of the pair.
        let wide = within(3.0);
        let even = wide.indices().iter().all(|&i| workpiece.particles.spacing[i as usize] <= largest);
        if even { within(2.0) } else { wide }
    }

    /// Puts the new rows of the `local` ones, and of those beside them, in the place of the old.
    fn replace(&mut self, members: &Members, local: &[bool], pairs: &PairTable<'_, 3>) -> Vec<u32> {
        let moments = pairs.moments();
        for (k, &i) in members.indices().iter().enumerate() {
            if local[k] {
                self.moments[i as usize] = moments[k];
                self.renewed[i as usize] = true;
            }
        }
        let fresh = pairs.normalized_by(&members.gather(&self.moments));
        let mut changed = Vec::new();
        let mut entries = Vec::new();
        for (k, &i) in members.indices().iter().enumerate() {
            let (neighbors, weights) = fresh.row(k);
            entries.clear();
            let news = neighbors.iter().zip(weights).filter(|(j, _)| local[k] || local[**j as usize]);
            entries.extend(news.map(|(&j, &weight)| (members.indices()[j as usize], weight)));
            let shares = !entries.is_empty();
            let is_new = |j: u32| members.find(j as usize).is_some_and(|at| local[at]);
            let (neighbors, weights) = self.rows.row(i as usize);
            if !local[k] && !shares && !neighbors.iter().any(|&j| is_new(j)) {
                continue;
            }
            if !local[k] {
                let kept = neighbors.iter().zip(weights).filter(|(j, _)| !is_new(**j));
                entries.extend(kept.map(|(&j, &weight)| (j, weight)));
                entries.sort_unstable_by_key(|entry| entry.0);
            }
            self.rows.replace_row(i as usize, &entries);
            changed.push(i);
        }
        changed
    }

    /// Bound on the spectrum of `dh/dt = (1/mass) sum g (h_j - h_i)` in the renewed rows (Gershgorin) \[1/s over W/m per J/kg\].
    pub(super) fn bound(&self, mass: &[f64]) -> f64 {
        let row = |i: usize| 2.0 * self.rows.row(i).1.iter().map(|g| g.abs()).sum::<f64>() / mass[i];
        (0..mass.len()).filter(|&i| self.renewed[i]).map(row).fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::{LevelPlan, mirrors};
    use crate::case::library::cases_folder;
    use crate::case::load;
    use crate::case::scene::Weights;
    use crate::model::Model;

    const KERNEL: KernelKind = KernelKind::WendlandC2;
    const RATIO: f64 = 1.3;

    fn workpiece() -> (Model, Workpiece) {
        let settings = ["resolution.spacing_m=100e-6".to_string()];
        let settings = [settings.to_vec(), vec!["part.size_m=(2.0e-3,2.0e-3,0.3e-3)".to_string()]].concat();
        let case = load(&cases_folder().unwrap().join("flow-spot-aluminium"), &settings).unwrap();
        let model = Model::from_case(&case).unwrap();
        let workpiece = Workpiece::new(&model, &LevelPlan::uniform(model.counts()));
        (model, workpiece)
    }

    /// Normalised rows of all particles where they are.
    fn rows_of(model: &Model, workpiece: &Workpiece) -> RenewedRows {
        let all = Members::all(workpiece.particles.len());
        let planes = mirrors(workpiece, &model.faces, Weights::Normalized);
        let neighborhood = Neighborhood::new(workpiece, &planes, &all, KERNEL, RATIO).unwrap();
        let volumes = &workpiece.particles.volume;
        let pairs = pair_table(workpiece, &all, &neighborhood, volumes, KERNEL).unwrap();
        let rule = RowRule { planes, kernel: KERNEL, ratio: RATIO };
        RenewedRows::new(rule, pairs.normalized(), &pairs, workpiece)
    }

    /// Moves some particles below the top, by up to 0.9 of the spacing along each axis.
    fn stir(workpiece: &mut Workpiece, phase: f64) {
        let spacing = workpiece.spacing;
        for (n, position) in workpiece.particles.position.iter_mut().enumerate() {
            if position.x.hypot(position.y) < 3e-4 && position.z > -3e-4 {
                let at = n as f64 + phase;
                *position += 0.9 * spacing * Vector3::new(at.sin(), (2.0 * at).sin(), (3.0 * at).sin());
            }
        }
        // A drop beyond the reach of all others, and of its own image.
        let drop = workpiece.particles.len() / 2;
        workpiece.particles.position[drop].z = 5.0 * spacing;
    }

    #[test]
    fn rows_renewed_in_part_are_the_rows_of_the_whole_and_a_checkpoint_gives_them_again() {
        let (model, mut workpiece) = workpiece();
        let mut rows = rows_of(&model, &workpiece);
        let mut resumed = rows_of(&model, &workpiece);
        for phase in [0.0, 100.0] {
            stir(&mut workpiece, phase);
            let changed = rows.renew(&workpiece).unwrap();
            assert!(
                changed.len() > 100 && changed.len() < workpiece.particles.len() * 3 / 4,
                "{}",
                changed.len()
            );
            let whole = rows_of(&model, &workpiece);
            for i in 0..workpiece.particles.len() {
                let ((near, weights), (found, renewed)) = (whole.rows.row(i), rows.rows.row(i));
                assert_eq!(near, found, "row {i}");
                let close = |(a, b): (&f64, &f64)| (a - b).abs() < 1e-12 * workpiece.spacing;
                assert!(weights.iter().zip(renewed).all(close), "row {i}: {weights:?} against {renewed:?}");
            }
        }
        // Some stand beyond the faces now, and each pair still has one weight.
        assert!(workpiece.particles.position.iter().any(|x| x.z > 0.0));
        let weight = |i: usize, j: u32| {
            let (near, weights) = rows.rows.row(i);
            near.binary_search(&j).map_or(0.0, |at| weights[at])
        };
        for i in 0..workpiece.particles.len() {
            for &j in rows.rows.row(i).0 {
                let (there, back) = (weight(i, j), weight(j as usize, i as u32));
                assert!((there - back).abs() <= 1e-14 * there.abs(), "{i} and {j}: {there:e} {back:e}");
            }
        }
        assert!(rows.renew(&workpiece).unwrap().is_empty());
        resumed.restore(rows.renewed().to_vec());
        resumed.renew(&workpiece).unwrap();
        for i in 0..workpiece.particles.len() {
            assert_eq!(rows.rows.row(i), resumed.rows.row(i), "row {i}");
        }
    }
}
