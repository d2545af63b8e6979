//! Levels of spacing: where the part is cut finely and where coarsely.
//!
//! The part is a box of finest cells of edge dx. A block of level l is a cube of 2^l cells, aligned to the part's low
//! corner and, along the last axis, to its top. Blocks that touch the fine box are split down to single cells; around
//! them each level keeps at least [`LAYERS`] layers of its own before the next one starts, so that sizes jump by two at
//! most. Where the part's size is no multiple of a block, blocks that stick out are split too. Every level's split
//! region is a union of boxes, so a plan costs nothing however large the part is.

/// Layers of its own that each level has at least.
const LAYERS: i64 = 2;

/// Blocks of the coarsest level that the thinnest side of the part holds at least.
const COARSEST_ACROSS: i64 = 3;

/// A box of finest cells: low corner, and high corner exclusive.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CellBox<const D: usize> {
    /// Low corner.
    pub low: [i64; D],
    /// High corner, exclusive.
    pub high: [i64; D],
}

impl<const D: usize> CellBox<D> {
    /// Number of cells along each axis.
    pub fn counts(&self) -> [usize; D] {
        std::array::from_fn(|axis| (self.high[axis] - self.low[axis]).max(0) as usize)
    }

    fn meets(&self, other: &Self) -> bool {
        (0..D).all(|axis| self.low[axis] < other.high[axis] && other.low[axis] < self.high[axis])
    }

    /// This box grown by `margin` on all sides and then out to multiples of `edge`.
    fn grown(&self, margin: i64, edge: i64) -> Self {
        Self {
            low: self.low.map(|low| (low - margin).div_euclid(edge) * edge),
            high: self.high.map(|high| (high + margin + edge - 1).div_euclid(edge) * edge),
        }
    }
}

/// One particle's cell: a cube of 2^level finest cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cell<const D: usize> {
    /// Level, 0 the finest.
    pub level: u32,
    /// Low corner in finest cells.
    pub low: [i64; D],
}

/// Which blocks of each level are split.
#[derive(Debug, Clone, PartialEq)]
pub struct LevelPlan<const D: usize> {
    counts: [i64; D],
    /// `split[l]`: regions whose blocks of level l + 1 are split into blocks of level l.
    split: Vec<Vec<CellBox<D>>>,
}

impl<const D: usize> LevelPlan<D> {
    /// All cells of the finest level.
    pub fn uniform(counts: [i64; D]) -> Self {
        Self { counts, split: Vec::new() }
    }

    /// Finest cells inside `fine`, coarser ones away from it.
    pub fn around(counts: [i64; D], fine: CellBox<D>) -> Self {
        let thinnest = counts.into_iter().min().unwrap_or(1);
        let mut split: Vec<Vec<CellBox<D>>> = Vec::new();
        let mut edge = 2;
        while edge * COARSEST_ACROSS <= thinnest {
            let finer = split.last().map_or(std::slice::from_ref(&fine), Vec::as_slice);
            let margin = if split.is_empty() { 0 } else { LAYERS * edge / 2 };
            let mut regions: Vec<_> = finer.iter().map(|region| region.grown(margin, edge)).collect();
            regions.extend((0..D).filter_map(|axis| overhang(&counts, axis, edge)));
            split.push(regions);
            edge *= 2;
        }
        // A level whose blocks are all split anyway is none.
        let whole = CellBox { low: [0; D], high: counts };
        let covers = |region: &CellBox<D>| {
            (0..D).all(|axis| region.low[axis] <= whole.low[axis] && region.high[axis] >= whole.high[axis])
        };
        if let Some(full) = split.iter().position(|regions| regions.iter().any(covers)) {
            split.truncate(full);
        }
        Self { counts, split }
    }

    /// The same boxes with each cell cut `times` as finely along each axis: cells of all levels shrink alike.
    pub fn refined(&self, times: i64) -> Self {
        let scaled = |cells: [i64; D]| cells.map(|cell| times * cell);
        let region = |region: &CellBox<D>| CellBox { low: scaled(region.low), high: scaled(region.high) };
        let split = self.split.iter().map(|regions| regions.iter().map(region).collect()).collect();
        Self { counts: scaled(self.counts), split }
    }

    /// The box of finest cells around the fine box, all of level 0.
    pub fn finest_box(&self) -> CellBox<D> {
        let whole = CellBox { low: [0; D], high: self.counts };
        let Some(region) = self.split.first().and_then(|regions| regions.first()) else { return whole };
        CellBox {
            low: std::array::from_fn(|axis| region.low[axis].clamp(0, self.counts[axis])),
            high: std::array::from_fn(|axis| region.high[axis].clamp(0, self.counts[axis])),
        }
    }

    /// Number of levels.
    pub fn levels(&self) -> usize {
        self.split.len() + 1
    }

    /// Number of cells, without making them.
    pub fn count(&self) -> u64 {
        let mut count = 0;
        self.visit(&mut |_| count += 1);
        count
    }

    /// All cells, sorted by level and then along the first axis, the second, the last: neighbours in space are
    /// neighbours in memory, and rows of cells see the same pattern of neighbours.
    pub fn cells(&self) -> Vec<Cell<D>> {
        let mut cells = Vec::new();
        self.visit(&mut |cell| cells.push(cell));
        cells.sort_unstable_by_key(|cell| {
            let mut key = cell.low;
            key.reverse();
            (cell.level, key)
        });
        cells
    }

    fn visit(&self, each: &mut impl FnMut(Cell<D>)) {
        let top = self.split.len() as u32;
        let edge = 1i64 << top;
        let blocks: [i64; D] = self.counts.map(|count| (count + edge - 1) / edge);
        for block in 0..blocks.iter().product::<i64>() {
            let mut rest = block;
            let low = std::array::from_fn(|axis| {
                let at = rest % blocks[axis];
                rest /= blocks[axis];
                at * edge
            });
            self.descend(Cell { level: top, low }, each);
        }
    }

    fn descend(&self, cell: Cell<D>, each: &mut impl FnMut(Cell<D>)) {
        let edge = 1i64 << cell.level;
        if (0..D).any(|axis| cell.low[axis] >= self.counts[axis]) {
            return;
        }
        let bounds = CellBox { low: cell.low, high: cell.low.map(|low| low + edge) };
        let splits = |region: &CellBox<D>| region.meets(&bounds);
        if cell.level == 0 || !self.split[cell.level as usize - 1].iter().any(splits) {
            each(cell);
            return;
        }
        for child in 0..1usize << D {
            let low = std::array::from_fn(|axis| cell.low[axis] + ((child >> axis) & 1) as i64 * edge / 2);
            self.descend(Cell { level: cell.level - 1, low }, each);
        }
    }
}

/// The slab of blocks that stick out at the far end of an axis.
fn overhang<const D: usize>(counts: &[i64; D], axis: usize, edge: i64) -> Option<CellBox<D>> {
    let start = counts[axis] / edge * edge;
    (start < counts[axis]).then(|| {
        let mut slab = CellBox { low: [0; D], high: counts.map(|count| count + edge) };
        slab.low[axis] = start;
        slab
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::HashMap;

    fn owners(cells: &[Cell<3>]) -> HashMap<[i64; 3], u32> {
        let mut owners = HashMap::new();
        for cell in cells {
            let edge = 1i64 << cell.level;
            for n in 0..edge.pow(3) {
                let at =
                    [cell.low[0] + n % edge, cell.low[1] + n / edge % edge, cell.low[2] + n / edge / edge];
                assert!(owners.insert(at, cell.level).is_none(), "two cells own {at:?}");
            }
        }
        owners
    }

    proptest! {
        #[test]
        fn cells_tile_the_part_and_sizes_jump_by_two_at_most(
            counts in [5i64..40, 5i64..40, 5i64..40], corner in [0.0..1.0f64, 0.0..1.0f64, 0.0..1.0f64],
            size in [1i64..12, 1i64..12, 1i64..12],
        ) {
            let low: [i64; 3] = std::array::from_fn(|a| (corner[a] * (counts[a] - 1) as f64) as i64);
            let high = std::array::from_fn(|a| (low[a] + size[a]).min(counts[a]));
            let plan = LevelPlan::around(counts, CellBox { low, high });
            let owners = owners(&plan.cells());
            prop_assert_eq!(owners.len() as i64, counts.iter().product::<i64>());
            for (at, level) in &owners {
                prop_assert!((0..3).all(|a| at[a] < counts[a]));
                if (0..3).all(|a| at[a] >= low[a] && at[a] < high[a]) {
                    prop_assert_eq!(*level, 0);
                }
                for axis in 0..3 {
                    let mut next = *at;
                    next[axis] += 1;
                    if let Some(other) = owners.get(&next) {
                        prop_assert!(level.abs_diff(*other) <= 1);
                    }
                }
            }
            let finest = plan.finest_box();
            for (at, level) in &owners {
                if (0..3).all(|a| at[a] >= finest.low[a] && at[a] < finest.high[a]) {
                    prop_assert_eq!(*level, 0);
                }
            }
        }
    }

    #[test]
    fn a_refined_plan_has_cells_of_the_same_levels_at_the_same_places() {
        let plan = LevelPlan::around([33, 20, 17], CellBox { low: [3, 0, 0], high: [9, 7, 5] });
        assert!(plan.levels() > 2);
        let (coarse, fine) = (owners(&plan.cells()), owners(&plan.refined(3).cells()));
        assert_eq!(fine.len(), 27 * coarse.len());
        for (at, level) in &fine {
            assert_eq!(coarse[&at.map(|cell| cell / 3)], *level, "{at:?}");
        }
        assert_eq!(plan.refined(3).count(), 27 * plan.count());
    }

    #[test]
    fn a_small_fine_box_saves_most_particles() {
        let plan = LevelPlan::around([120, 120, 60], CellBox { low: [0, 0, 0], high: [24, 24, 16] });
        let cells = plan.cells();
        assert!(plan.levels() >= 4, "{}", plan.levels());
        assert!(cells.len() < 20_000, "{}", cells.len());
        assert!(LevelPlan::uniform([12, 10, 8]).cells().len() == 960);
    }
}
