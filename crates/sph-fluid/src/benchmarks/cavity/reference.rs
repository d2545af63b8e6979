//! The steady flow of the cavity by finite differences: stream function, vorticity and temperature, central differences of second
//! order, Thom's vorticity at walls, and relaxation point by point until nothing moves.

use super::super::largest;
use nalgebra::Vector2;

/// Change of a sweep, over the largest value, at which the fields stand still.
const STILL: f64 = 1e-9;
const MOST_SWEEPS: usize = 400_000;

/// Fields on the nodes of a square grid; u = d psi/dy, v = -d psi/dx.
#[derive(Clone, Debug)]
pub struct CavityReference {
    /// Intervals along a side.
    intervals: usize,
    /// Peclet numbers of vorticity and of temperature: Re and Re Pr.
    numbers: [f64; 2],
    stream: Vec<f64>,
    vorticity: Vec<f64>,
    temperature: Vec<f64>,
}

impl CavityReference {
    /// The steady state on a grid.
    ///
    /// # Panics
    /// If relaxation does not come to rest, which no case of this crate does.
    #[must_use]
    pub fn new(intervals: usize, reynolds: f64, prandtl: f64) -> Self {
        let nodes = (intervals + 1) * (intervals + 1);
        let start = |k: usize| 1.0 - (k % (intervals + 1)) as f64 / intervals as f64;
        let mut field = Self {
            intervals,
            numbers: [reynolds, reynolds * prandtl],
            stream: vec![0.0; nodes],
            vorticity: vec![0.0; nodes],
            temperature: (0..nodes).map(start).collect(),
        };
        let moved = (0..MOST_SWEEPS).map(|_| field.sweep()).find(|&moved| moved < STILL);
        assert!(moved.is_some(), "the cavity's reference did not come to rest");
        field
    }

    /// One pass over all nodes; returns the largest change of temperature and of stream function.
    fn sweep(&mut self) -> f64 {
        let (n, row) = (self.intervals, self.intervals + 1);
        self.set_edges();
        let mut moved = 0.0_f64;
        for k in (1..n).flat_map(|j| (1..n).map(move |i| j * row + i)) {
            let u = 0.25 * (self.stream[k + row] - self.stream[k - row]);
            let v = -0.25 * (self.stream[k + 1] - self.stream[k - 1]);
            let mean = |field: &[f64], number: f64| {
                let east_west = 0.25 * (field[k + 1] + field[k - 1] + field[k + row] + field[k - row]);
                let carried = u * (field[k + 1] - field[k - 1]) + v * (field[k + row] - field[k - row]);
                east_west - 0.25 * number * carried
            };
            self.vorticity[k] = mean(&self.vorticity, self.numbers[0]);
            let temperature = mean(&self.temperature, self.numbers[1]);
            moved = moved.max((temperature - self.temperature[k]).abs());
            self.temperature[k] = temperature;
        }
        moved.max(10.0 * self.relax_stream())
    }

    fn relax_stream(&mut self) -> f64 {
        let (n, row) = (self.intervals, self.intervals + 1);
        let area = 1.0 / (n * n) as f64;
        let over = 2.0 / (1.0 + (std::f64::consts::PI / n as f64).sin());
        let mut moved = 0.0_f64;
        for k in (1..n).flat_map(|j| (1..n).map(move |i| j * row + i)) {
            let s = &self.stream;
            let mean = 0.25 * (s[k + 1] + s[k - 1] + s[k + row] + s[k - row] + area * self.vorticity[k]);
            let change = over * (mean - s[k]);
            moved = moved.max(change.abs());
            self.stream[k] += change;
        }
        moved
    }

    /// Adiabatic floor and top, walls without slip, and the top's vorticity from the change of tension: du/dy = -dT/dx.
    fn set_edges(&mut self) {
        let (n, row) = (self.intervals, self.intervals + 1);
        let top = n * row;
        for i in 1..n {
            let t = &mut self.temperature;
            t[i] = (4.0 * t[row + i] - t[2 * row + i]) / 3.0;
            t[top + i] = (4.0 * t[top - row + i] - t[top - 2 * row + i]) / 3.0;
            self.vorticity[top + i] = 0.5 * n as f64 * (t[top + i + 1] - t[top + i - 1]);
        }
        for k in 1..n {
            let square = (n * n) as f64;
            for (wall, next) in [(k, row + k), (k * row, k * row + 1), (k * row + n, k * row + n - 1)] {
                let thom = -2.0 * square * self.stream[next];
                self.vorticity[wall] += 0.3 * (thom - self.vorticity[wall]);
            }
        }
    }

    /// Largest stream function, in size.
    #[must_use]
    pub fn stream(&self) -> f64 {
        largest(self.stream.iter().map(|stream| stream.abs()))
    }

    /// Mean slope of temperature at the hot side.
    #[must_use]
    pub fn nusselt(&self) -> f64 {
        let (n, row) = (self.intervals, self.intervals + 1);
        let slope = |j: usize| {
            let t = &self.temperature[j * row..];
            0.5 * n as f64 * (3.0 * t[0] - 4.0 * t[1] + t[2])
        };
        let ends = 0.5 * (slope(0) + slope(n));
        (ends + (1..n).map(slope).sum::<f64>()) / n as f64
    }

    /// Velocity at a node.
    fn node_velocity(&self, i: usize, j: usize) -> Vector2<f64> {
        let (n, row) = (self.intervals, self.intervals + 1);
        let scale = 0.5 * n as f64;
        if i == 0 || i == n || j == 0 {
            return Vector2::zeros();
        }
        let s = &self.stream[..];
        let k = j * row + i;
        if j == n {
            return Vector2::new(scale * (3.0 * s[k] - 4.0 * s[k - row] + s[k - 2 * row]), 0.0);
        }
        Vector2::new(s[k + row] - s[k - row], s[k - 1] - s[k + 1]) * scale
    }

    /// Velocity at a place of the square, linear between nodes.
    #[must_use]
    pub fn velocity(&self, place: &Vector2<f64>) -> Vector2<f64> {
        let along = |x: f64| {
            let scaled = x.clamp(0.0, 1.0) * self.intervals as f64;
            let k = (scaled as usize).min(self.intervals - 1);
            (k, scaled - k as f64)
        };
        let ((i, right), (j, up)) = (along(place.x), along(place.y));
        let lower = self.node_velocity(i, j) * (1.0 - right) + self.node_velocity(i + 1, j) * right;
        let upper = self.node_velocity(i, j + 1) * (1.0 - right) + self.node_velocity(i + 1, j + 1) * right;
        lower * (1.0 - up) + upper * up
    }
}

#[cfg(test)]
mod tests {
    use super::super::CASES;
    use super::*;

    #[test]
    fn agrees_with_the_published_numbers() {
        for case in CASES {
            let found = CavityReference::new(64, case.reynolds, case.prandtl);
            let speed = found.velocity(&Vector2::new(0.5, 1.0)).x;
            println!(
                "Re {} Pr {}: psi {:.5}, u {speed:.4}, Nu {:.4}",
                case.reynolds,
                case.prandtl,
                found.stream(),
                found.nusselt()
            );
            for (value, published) in
                [(found.stream(), case.stream), (speed, case.speed), (found.nusselt(), case.nusselt)]
            {
                assert!((value / published - 1.0).abs() < 0.015, "{value} {published}");
            }
        }
    }
}
