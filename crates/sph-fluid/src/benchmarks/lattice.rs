//! Fluid between walls, both on one square lattice.

use crate::PatchStart;
use nalgebra::Vector2;
use std::ops::Range;

/// Rows of particles of a wall: the support of three spacings and one more.
pub(super) const WALL_ROWS: i32 = 4;

/// What stands on a site.
#[derive(Clone, Copy, Debug)]
pub(super) enum Site {
    Fluid,
    Wall,
    Empty,
}

/// Fluid and walls at rest, row by row from below; the corner of cell (0, 0) is the origin.
pub(super) fn lattice(
    spacing: f64,
    columns: Range<i32>,
    rows: Range<i32>,
    kind: impl Fn(i32, i32) -> Site,
) -> PatchStart<2> {
    let (mut fluid, mut walls) = (Vec::new(), Vec::new());
    for row in rows {
        for column in columns.clone() {
            let position = Vector2::new(f64::from(column) + 0.5, f64::from(row) + 0.5) * spacing;
            match kind(column, row) {
                Site::Fluid => fluid.push(position),
                Site::Wall => walls.push(position),
                Site::Empty => (),
            }
        }
    }
    let volumes = vec![spacing * spacing; fluid.len()];
    let wall_velocities = vec![Vector2::zeros(); walls.len()];
    PatchStart { walls, wall_velocities, ..PatchStart::free(fluid, volumes, spacing) }
}
