//! The gauge: what an engineer would measure on the pool, from the finest grid of particles.
//!
//! Levels are read in the Kirchhoff potential of the part's own material, which bends less than temperature where the
//! conductivity changes. The top face has values of its own, from the two layers below it and the flux of the moment.

use super::Sampler;
use super::isotherm::{Extent, crossing, rise_above_middle, smooth_maximum};
use crate::build::Workpiece;
use crate::case::scene::Face;
use crate::model::{Model, ModelError};
use crate::particles::Particles;
use laser_source::SurfacePatches;
use serde::{Deserialize, Serialize};
use sph_thermal::boundary::{SurfaceLoss, surface_potential, surface_temperature};
use sph_thermal::phase::{EnthalpyCurve, ThermalMaterial};

/// The flux at the end of a step is taken as the mean over this last share of it.
const END_OF_STEP: f64 = 1e-3;

/// The liquidus and the solidus where nodes are read by how far they have melted.
const FULLY_AND_NOT_MOLTEN: [f64; 2] = [1.0, 0.0];

/// What was measured at one time.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Measure {
    /// Hottest point of the top face \[K\], between particles.
    pub peak_temperature: f64,
    /// Region above the liquidus.
    pub liquidus: Extent,
    /// Region above the solidus.
    pub solidus: Extent,
    /// Molten volume of the whole part, mirror images counted \[m³\].
    pub melt_volume: f64,
    /// Largest enthalpy over all particles less that of the solidus \[J/kg\]; not above zero when all is solid.
    pub over_solidus: f64,
    /// Whether melt has reached the edge of the finest spacing.
    pub beyond_finest: bool,
}

/// Values on a plane.
#[derive(Debug, Clone, PartialEq)]
pub struct Map {
    /// Columns, rising \[m\].
    pub x: Vec<f64>,
    /// Rows, rising \[m\].
    pub y: Vec<f64>,
    /// Row after row.
    pub value: Vec<f64>,
}

/// Reads sizes off the finest grid of a workpiece.
pub struct Gauge {
    counts: [usize; 3],
    spacing: f64,
    /// Low corner of the grid in x and y \[m\].
    low: [f64; 2],
    /// Whether the low and high ends of x and y are mirror planes.
    mirror: [[bool; 2]; 2],
    /// Whether the ends of x and y, and the bottom, are faces of the part.
    face: [[bool; 2]; 3],
    curves: Vec<EnthalpyCurve>,
    /// Potentials of the liquidus and the solidus, where there is one material.
    levels: [f64; 2],
    /// How far each node has melted, where there are several.
    melting: Option<Melting>,
    sampler: Sampler,
    patches: Option<SurfacePatches>,
    /// What leaves through the top face to the surroundings.
    /// Loss of the top face for each material, if it has one.
    losses: Vec<SurfaceLoss>,
    flux: Vec<f64>,
    now: Grid,
    peak: Grid,
    copies: f64,
    /// Melt this many cells from the end of the finest grid is at its edge.
    margin_cells: f64,
    scratch: Scratch,
}

/// Melt that flows sees three spacings far, and moves between two readings.
const FLOWING_MARGIN_CELLS: f64 = 4.0;

/// How far nodes of unlike materials have melted: (T - T_s)/(T_l - T_s) of each one's own.
struct Melting {
    material: Vec<u8>,
    /// Solidus, and melting range \[K\].
    ranges: Vec<(f64, f64)>,
    grid: Grid,
}

/// What one reading of sizes works on: kept from step to step, so that a step allocates nothing here.
#[derive(Default)]
struct Scratch {
    /// See [`Gauge::find_deepest`].
    deepest: Vec<u32>,
    depths: Vec<f64>,
    rows: Vec<f64>,
    lengths: Vec<f64>,
}

/// Potentials at the nodes of the finest grid and on the top face above them.
#[derive(Debug, Clone)]
struct Grid {
    nodes: Vec<f64>,
    surface: Vec<f64>,
}

impl Gauge {
    /// A gauge on the finest grid of `workpiece`.
    ///
    /// # Errors
    /// [`ModelError`] when the laser refuses the grid.
    pub fn new(model: &Model, workpiece: &Workpiece) -> Result<Self, ModelError> {
        let counts = workpiece.finest.counts();
        let [nx, ny, nz] = counts;
        let spacing = workpiece.spacing;
        let low = [0, 1].map(|axis| workpiece.low[axis] + spacing * workpiece.finest.low[axis] as f64);
        let faces = [[model.faces.x_min, model.faces.x_max], [model.faces.y_min, model.faces.y_max]];
        let part = model.counts();
        let face: [[bool; 2]; 3] = std::array::from_fn(|axis| {
            [workpiece.finest.low[axis] == 0, workpiece.finest.high[axis] == part[axis]]
        });
        let mirror = std::array::from_fn(|axis| {
            std::array::from_fn(|side| faces[axis][side] == Face::Symmetry && face[axis][side])
        });
        let mirrors = faces.iter().flatten().filter(|face| **face == Face::Symmetry).count();
        let patches = match &model.laser {
            Some(_) => Some(columns(counts, low, spacing)?),
            None => None,
        };
        let curve = &model.curves[0];
        let grid = |value: f64| Grid { nodes: vec![value; nx * ny * nz], surface: vec![value; nx * ny] };
        Ok(Self {
            counts,
            spacing,
            low,
            mirror,
            face,
            levels: [curve.enthalpy_liquidus(), curve.enthalpy_solidus()].map(|h| curve.potential(h)),
            curves: model.curves.clone(),
            melting: melting(model, workpiece, grid(0.0)),
            sampler: Sampler::new(workpiece, &model.faces),
            patches,
            losses: top_losses(model)?,
            flux: vec![0.0; nx * ny],
            now: grid(0.0),
            peak: grid(f64::NEG_INFINITY),
            copies: f64::from(1u32 << mirrors),
            margin_cells: if model.flow.is_some() { FLOWING_MARGIN_CELLS } else { 1.0 },
            scratch: Scratch::default(),
        })
    }

    /// Reads nodes from where particles are now.
    pub fn rearrange(&mut self, model: &Model, workpiece: &Workpiece) {
        self.sampler = Sampler::new(workpiece, &model.faces);
    }

    /// Measures the state at `time` after a step of `step` \[s\].
    pub fn measure(&mut self, model: &Model, particles: &Particles<3>, time: f64, step: f64) -> Measure {
        let curve = |i: usize| &self.curves[particles.material[i] as usize];
        self.sampler.read(|i| curve(i).potential(particles.enthalpy[i]), &mut self.now.nodes);
        self.read_surface(model, time, step);
        if let Some(melting) = &mut self.melting {
            melting.read(&self.now, &self.curves);
        }
        let (grid, [liquidus, solidus]) = match &self.melting {
            None => (&self.now, self.levels),
            Some(melting) => (&melting.grid, FULLY_AND_NOT_MOLTEN),
        };
        keep_largest(&mut self.peak.nodes, &grid.nodes);
        keep_largest(&mut self.peak.surface, &grid.surface);
        let mut scratch = std::mem::take(&mut self.scratch);
        let liquidus = self.extent(grid, liquidus, &mut scratch);
        let solidus = self.extent(grid, solidus, &mut scratch);
        self.scratch = scratch;
        Measure {
            peak_temperature: self.peak_temperature(),
            liquidus,
            beyond_finest: self.at_edge(&solidus),
            solidus,
            melt_volume: self.melt_volume(model, particles),
            over_solidus: over_solidus(model, particles),
        }
    }

    /// Everything that was ever above the liquidus: the weld.
    pub fn weld(&self) -> Extent {
        let [liquidus, _] = if self.melting.is_some() { FULLY_AND_NOT_MOLTEN } else { self.levels };
        self.extent(&self.peak, liquidus, &mut Scratch::default())
    }

    /// Volume that was ever liquid, by the largest liquid fraction of each particle, mirror images counted \[m³\].
    pub fn weld_volume(&self, model: &Model, particles: &Particles<3>) -> f64 {
        let share = |i: usize| {
            let curve = &model.curves[particles.material[i] as usize];
            particles.volume[i] * curve.liquid_fraction(particles.peak_enthalpy[i])
        };
        self.copies * (0..particles.len()).map(share).sum::<f64>()
    }

    /// The largest potentials so far, for a checkpoint.
    pub fn save(&self) -> (Vec<f64>, Vec<f64>) {
        (self.peak.nodes.clone(), self.peak.surface.clone())
    }

    /// Takes up what [`save`](Self::save) gave.
    ///
    /// # Errors
    /// A message when it is of another grid.
    pub fn restore(&mut self, (nodes, surface): (Vec<f64>, Vec<f64>)) -> Result<(), String> {
        if nodes.len() != self.peak.nodes.len() || surface.len() != self.peak.surface.len() {
            return Err("the gauge's state is of another grid".into());
        }
        self.peak = Grid { nodes, surface };
        Ok(())
    }

    /// How many copies of the modelled part make the whole: two for each symmetry plane.
    pub fn copies(&self) -> f64 {
        self.copies
    }

    /// Temperatures of the last measure in the upright section through the column nearest to `at` \[m\] on `axis`, mirror
    /// image added where the section ends on a symmetry plane.
    pub fn section(&self, axis: usize, at: f64) -> Map {
        self.cut(axis, at, |node| self.temperature(node, self.now.nodes[node]))
    }

    /// The same section of `field`, a value of each particle.
    pub fn section_of(&self, field: &[f64], axis: usize, at: f64) -> Map {
        let mut nodes = vec![0.0; self.now.nodes.len()];
        self.sampler.read(|particle| field[particle], &mut nodes);
        self.cut(axis, at, |node| nodes[node])
    }

    fn cut(&self, axis: usize, at: f64, value: impl Fn(usize) -> f64) -> Map {
        let [nx, ny, nz] = self.counts;
        let along = 1 - axis;
        let column =
            ((at - self.low[axis]) / self.spacing - 0.5).round().clamp(0.0, self.counts[axis] as f64 - 1.0);
        let column = column as usize;
        let node = |layer: usize, k: usize| {
            let place = if axis == 1 { column * nx + k } else { k * nx + column };
            value(layer * nx * ny + place)
        };
        let y = (0..nz).rev().map(|layer| -self.spacing * (layer as f64 + 0.5)).collect();
        self.unfold(along, y, |row, k| node(nz - 1 - row, k))
    }

    /// Temperatures of the top face at the last measure, mirror images added.
    pub fn top(&self) -> Map {
        self.seen_from_above([false; 2], |column| self.temperature(column, self.now.surface[column]))
    }

    /// `field`, a value of each particle, in the layer of nodes below the top face, mirror images added; `odd` says for the axes
    /// x and y whether it turns its sign across a mirror plane there.
    pub fn top_of(&self, field: &[f64], odd: [bool; 2]) -> Map {
        let mut nodes = vec![0.0; self.now.nodes.len()];
        self.sampler.read(|particle| field[particle], &mut nodes);
        self.seen_from_above(odd, |column| nodes[column])
    }

    /// `value` of each column of nodes, unfolded at mirror planes at the low ends of x and y.
    fn seen_from_above(&self, odd: [bool; 2], value: impl Fn(usize) -> f64) -> Map {
        let (nx, ny, plane) = (self.counts[0], self.counts[1], self.low[1]);
        let own: Vec<f64> = (0..ny).map(|j| plane + self.spacing * (j as f64 + 0.5)).collect();
        let mirrored = if self.mirror[1][0] { ny } else { 0 };
        let images = own.iter().rev().map(|y| 2.0 * plane - y).take(mirrored);
        let y: Vec<f64> = images.chain(own.iter().copied()).collect();
        let sign = |turns: bool| if turns { -1.0 } else { 1.0 };
        let mut map = self.unfold(0, y, |row, i| {
            let j = if row < mirrored { mirrored - 1 - row } else { row - mirrored };
            sign(odd[1] && row < mirrored) * value(j * nx + i)
        });
        for (value, &x) in map.value.iter_mut().zip(map.x.iter().cycle()) {
            *value *= sign(odd[0] && x < self.low[0]);
        }
        map
    }

    /// A map over x on `axis` (unfolded at a mirror plane at its low end) and rows `y`.
    fn unfold(&self, axis: usize, y: Vec<f64>, value: impl Fn(usize, usize) -> f64) -> Map {
        let count = self.counts[axis];
        let x: Vec<f64> = (0..count).map(|k| self.low[axis] + self.spacing * (k as f64 + 0.5)).collect();
        let mirrored = if self.mirror[axis][0] { count } else { 0 };
        let reflect = |k: usize| if k < mirrored { mirrored - 1 - k } else { k - mirrored };
        let plane = self.low[axis];
        let place = |k: usize| if k < mirrored { 2.0 * plane - x[reflect(k)] } else { x[reflect(k)] };
        let columns = mirrored + count;
        let places = (0..y.len()).flat_map(|row| (0..columns).map(move |k| (row, k)));
        let value = places.map(|(row, k)| value(row, reflect(k))).collect();
        Map { x: (0..columns).map(place).collect(), y, value }
    }

    fn read_surface(&mut self, model: &Model, time: f64, step: f64) {
        let steady = if let Face::Flux { flux_w_m2 } = model.faces.top { flux_w_m2 } else { 0.0 };
        self.flux.fill(steady);
        if let (Some(patches), Some(laser)) = (&mut self.patches, &model.laser) {
            let surface = matches!(laser.absorption(), laser_source::Absorption::Surface { .. });
            if surface && step > 0.0 {
                let per_area = 1.0 / self.spacing.powi(2);
                patches.accumulate(laser, time - END_OF_STEP * step, time, per_area, &mut self.flux);
            }
        }
        let layer = self.surface_len();
        let (z1, z2) = (0.5 * self.spacing, 1.5 * self.spacing);
        for column in 0..layer {
            let first = self.now.nodes[column];
            let second = if self.counts[2] > 1 { self.now.nodes[layer + column] } else { first };
            let surface = |flux: f64| surface_potential((z1, first), (z2, second), flux);
            let entering = self.flux[column];
            let material = self.material(column);
            self.now.surface[column] = match self.losses.get(material) {
                // The law is linear in the flux: what it gives without one, and what one lifts it by.
                Some(loss) => {
                    let (still, lift) = (surface(0.0), surface_potential((z1, 0.0), (z2, 0.0), 1.0));
                    let curve = &self.curves[material];
                    curve.potential_at(surface_temperature(curve, still, entering, lift, loss))
                }
                None => surface(entering),
            };
        }
    }

    fn surface_len(&self) -> usize {
        self.counts[0] * self.counts[1]
    }

    /// Material of a node; a column of the top face has that of its first node.
    fn material(&self, node: usize) -> usize {
        self.melting.as_ref().map_or(0, |melting| melting.material[node] as usize)
    }

    /// Temperature \[K\] at a potential in the material of a node.
    fn temperature(&self, node: usize, potential: f64) -> f64 {
        self.curves[self.material(node)].temperature_at_potential(potential)
    }

    /// Hottest point of the top face \[K\]: between particles of one material, at a particle where there are several.
    fn peak_temperature(&self) -> f64 {
        if self.melting.is_none() {
            return self.temperature(0, self.surface_peak());
        }
        let surface = self.now.surface.iter().enumerate();
        surface.map(|(column, &potential)| self.temperature(column, potential)).fold(0.0, f64::max)
    }

    /// Highest potential of the top face, with the parabolas through its neighbours along x and y.
    fn surface_peak(&self) -> f64 {
        let surface = &self.now.surface;
        let Some(at) = (0..surface.len()).max_by(|&a, &b| surface[a].total_cmp(&surface[b])) else {
            return 0.0;
        };
        let nx = self.counts[0];
        let place = [at % nx, at / nx];
        let stride = [1, nx];
        let rise = |axis: usize| {
            let [low, high] = self.mirror[axis];
            let before =
                if place[axis] > 0 { Some(surface[at - stride[axis]]) } else { low.then_some(surface[at]) };
            let last = place[axis] + 1 == self.counts[axis];
            let after = if last { high.then_some(surface[at]) } else { Some(surface[at + stride[axis]]) };
            match (before, after) {
                (Some(before), Some(after)) => rise_above_middle(before, surface[at], after),
                _ => 0.0,
            }
        };
        surface[at] + rise(0) + rise(1)
    }

    fn extent(&self, grid: &Grid, level: f64, scratch: &mut Scratch) -> Extent {
        self.find_deepest(grid, level, &mut scratch.deepest);
        if scratch.deepest.iter().all(|&deepest| deepest == 0) {
            return Extent::default();
        }
        let depth = self.depth(grid, level, scratch);
        let ([x0, x1], length) = self.longest(grid, level, 0, &mut scratch.lengths);
        let ([y0, y1], width) = self.longest(grid, level, 1, &mut scratch.lengths);
        let bounds = (x0 < x1 && y0 < y1).then_some([[x0, y0, -depth], [x1, y1, 0.0]]);
        Extent { width, length, depth, bounds }
    }

    /// Ends of all spans along `axis`, and the longest of them.
    fn longest(&self, grid: &Grid, level: f64, axis: usize, lengths: &mut Vec<f64>) -> ([f64; 2], f64) {
        let mut ends = [f64::INFINITY, f64::NEG_INFINITY];
        lengths.clear();
        for row in 0..self.counts[1 - axis] {
            let span = self.span(grid, level, axis, row);
            lengths.push(span.map_or(0.0, |span| self.whole(span, axis)));
            if let Some([low, high]) = span {
                ends = [ends[0].min(low), ends[1].max(high)];
            }
        }
        (ends, smooth_maximum(lengths, self.mirror[1 - axis]))
    }

    /// Length of a span with its mirror image where it touches a symmetry plane.
    fn whole(&self, [low, high]: [f64; 2], axis: usize) -> f64 {
        let low_end = self.low[axis];
        let high_end = low_end + self.spacing * self.counts[axis] as f64;
        let touches = |mirror: bool, gap: f64| mirror && gap < 1e-9 * self.spacing;
        let doubled =
            touches(self.mirror[axis][0], low - low_end) || touches(self.mirror[axis][1], high_end - high);
        if doubled { 2.0 * (high - low) } else { high - low }
    }

    /// From the first to the last crossing of the top face's row along `axis`, `row` counting across it.
    fn span(&self, grid: &Grid, level: f64, axis: usize, row: usize) -> Option<[f64; 2]> {
        let nx = self.counts[0];
        let count = self.counts[axis];
        let at = |k: usize| if axis == 0 { row * nx + k } else { k * nx + row };
        let x = |k: usize| self.low[axis] + self.spacing * (k as f64 + 0.5);
        let first = (0..count).find(|&k| grid.surface[at(k)] > level)?;
        let last = (0..count).rfind(|&k| grid.surface[at(k)] > level)?;
        let node = |k: usize| (x(k), grid.surface[at(k)]);
        let low = if first == 0 {
            self.low[axis]
        } else {
            // Read backwards: from the hot node out.
            let end = (first + 1).min(count - 1);
            let (nodes, found) = near_nodes((first.saturating_sub(2)..=end).rev().map(node));
            crossing(&nodes[..found], end - first, level)
        };
        let high = if last + 1 == count {
            self.low[axis] + self.spacing * count as f64
        } else {
            let start = last.saturating_sub(1);
            let (nodes, found) = near_nodes((start..(last + 3).min(count)).map(node));
            crossing(&nodes[..found], last - start, level)
        };
        Some([low, high])
    }

    /// Sets `deepest` to one more than the index of each column's deepest value above `level`, the top face being value
    /// zero; to zero where there is none.
    fn find_deepest(&self, grid: &Grid, level: f64, deepest: &mut Vec<u32>) {
        deepest.clear();
        deepest.extend(grid.surface.iter().map(|&theta| u32::from(theta > level)));
        for (layer, nodes) in grid.nodes.chunks_exact(self.surface_len()).enumerate() {
            for (deepest, &theta) in deepest.iter_mut().zip(nodes) {
                *deepest = if theta > level { layer as u32 + 2 } else { *deepest };
            }
        }
    }

    /// Largest depth of the region that `scratch.deepest` outlines \[m\].
    ///
    /// Only rows and columns that hold the deepest node, and those beside them, can decide: the rest is left at zero.
    fn depth(&self, grid: &Grid, level: f64, scratch: &mut Scratch) -> f64 {
        let Scratch { deepest, depths, rows, .. } = scratch;
        let nx = self.counts[0];
        let row_deepest = |row: usize| deepest[row * nx..(row + 1) * nx].iter().copied().max().unwrap_or(0);
        let whole = deepest.iter().copied().max().unwrap_or(0);
        rows.clear();
        rows.resize(self.counts[1], 0.0);
        for row in 0..self.counts[1] {
            let beside = row.saturating_sub(1)..(row + 2).min(self.counts[1]);
            if beside.clone().all(|row| row_deepest(row) < whole) {
                continue;
            }
            let reach = row_deepest(row);
            let own = &deepest[row * nx..(row + 1) * nx];
            depths.clear();
            depths.extend((0..nx).map(|i| {
                let decides = own[i.saturating_sub(1)..(i + 2).min(nx)].contains(&reach);
                if decides { self.column_depth(grid, level, row * nx + i, own[i] as usize) } else { 0.0 }
            }));
            rows[row] = smooth_maximum(depths, self.mirror[0]);
        }
        smooth_maximum(rows, self.mirror[1]).min(self.counts[2] as f64 * self.spacing)
    }

    /// Depth below the top face to which a column is above `level` \[m\], by its entry in `Scratch::deepest`.
    fn column_depth(&self, grid: &Grid, level: f64, column: usize, deepest: usize) -> f64 {
        let (layer, nz) = (self.surface_len(), self.counts[2]);
        let Some(last) = deepest.checked_sub(1) else { return 0.0 };
        if last == nz {
            return nz as f64 * self.spacing;
        }
        let value =
            |k: usize| if k == 0 { grid.surface[column] } else { grid.nodes[(k - 1) * layer + column] };
        let z = |k: usize| if k == 0 { 0.0 } else { self.spacing * (k as f64 - 0.5) };
        let start = last.saturating_sub(1);
        let (nodes, count) = near_nodes((start..(last + 3).min(nz + 1)).map(|k| (z(k), value(k))));
        crossing(&nodes[..count], last - start, level)
    }

    /// Whether a region reaches an edge of the grid that is no face of the part.
    fn at_edge(&self, extent: &Extent) -> bool {
        let Some([low, high]) = extent.bounds else { return false };
        let margin = self.spacing * self.margin_cells;
        let lateral = (0..2).any(|axis| {
            let end = self.low[axis] + self.spacing * self.counts[axis] as f64;
            (low[axis] <= self.low[axis] + margin && !self.face[axis][0])
                || (high[axis] >= end - margin && !self.face[axis][1])
        });
        let bottom = self.spacing * self.counts[2] as f64 - margin;
        lateral || (extent.depth >= bottom && !self.face[2][1])
    }

    fn melt_volume(&self, model: &Model, particles: &Particles<3>) -> f64 {
        let share = |i: usize| {
            let curve = &model.curves[particles.material[i] as usize];
            particles.volume[i] * curve.liquid_fraction(particles.enthalpy[i])
        };
        self.copies * (0..particles.len()).map(share).sum::<f64>()
    }
}

/// Up to four nodes without an allocation, and how many they are.
fn near_nodes(nodes: impl Iterator<Item = (f64, f64)>) -> ([(f64, f64); 4], usize) {
    let (mut near, mut count) = ([(0.0, 0.0); 4], 0);
    for (place, node) in near.iter_mut().zip(nodes) {
        *place = node;
        count += 1;
    }
    (near, count)
}

impl Melting {
    fn read(&mut self, now: &Grid, curves: &[EnthalpyCurve]) {
        let Self { material, ranges, grid } = self;
        let molten = |node: usize, potential: f64| {
            let material = material[node] as usize;
            let (solidus, range) = ranges[material];
            (curves[material].temperature_at_potential(potential) - solidus) / range
        };
        let fill = |to: &mut [f64], from: &[f64]| {
            to.iter_mut().zip(from).enumerate().for_each(|(node, (to, &from))| *to = molten(node, from));
        };
        fill(&mut grid.nodes, &now.nodes);
        fill(&mut grid.surface, &now.surface);
    }
}

/// The melting of nodes, where the part has several materials.
fn melting(model: &Model, workpiece: &Workpiece, grid: Grid) -> Option<Melting> {
    let material = |&particle: &u32| workpiece.particles.material[particle as usize];
    let range = |material: &ThermalMaterial| (material.solidus, material.liquidus - material.solidus);
    (model.curves.len() > 1).then(|| Melting {
        material: workpiece.finest_particles.iter().map(material).collect(),
        ranges: model.materials.iter().map(range).collect(),
        grid,
    })
}

/// The loss of the top face for each material, if it has one.
fn top_losses(model: &Model) -> Result<Vec<SurfaceLoss>, ModelError> {
    let loss = |material| model.surface_loss(model.faces.top, material).transpose();
    (0..model.curves.len()).filter_map(loss).collect()
}

fn keep_largest(peak: &mut [f64], now: &[f64]) {
    peak.iter_mut().zip(now).for_each(|(peak, now)| *peak = peak.max(*now));
}

fn over_solidus(model: &Model, particles: &Particles<3>) -> f64 {
    let over =
        |i: usize| particles.enthalpy[i] - model.curves[particles.material[i] as usize].enthalpy_solidus();
    (0..particles.len()).map(over).fold(f64::NEG_INFINITY, f64::max)
}

/// Squares of the top face above the columns of the grid.
fn columns(counts: [usize; 3], low: [f64; 2], spacing: f64) -> Result<SurfacePatches, ModelError> {
    let [nx, ny, _] = counts;
    let at = |n: usize, axis: usize| if axis == 0 { n % nx } else { n / nx };
    let column = |axis: usize| -> Vec<f64> {
        (0..nx * ny).map(|n| low[axis] + spacing * (at(n, axis) as f64 + 0.5)).collect()
    };
    Ok(SurfacePatches::new(&column(0), &column(1), &vec![0.5 * spacing; nx * ny])?)
}
