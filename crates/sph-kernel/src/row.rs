//! The row view: one particle and its neighbours within the kernel's support.

use crate::{Kernel, ScaledKernel};
use nalgebra::SVector;

/// One particle i and its neighbours j, all columns of the same length and in the order of the neighbour list.
///
/// A row holds real pairs only: every neighbour lies inside the kernel's support, and i itself is not among them.
#[derive(Clone, Copy, Debug)]
pub struct Row<'a, const D: usize> {
    /// The particle i.
    pub index: usize,
    /// The neighbours j.
    pub neighbors: &'a [u32],
    /// r_i - r_j \[m\].
    pub separations: &'a [SVector<f64, D>],
    /// |r_i - r_j| \[m\].
    pub distances: &'a [f64],
    /// W(|r_i - r_j|) \[m^-D\].
    pub values: &'a [f64],
    /// f = W'(r)/r \[m^-(D+2)\], so that grad_i W = f (r_i - r_j).
    pub gradient_factors: &'a [f64],
}

impl<const D: usize> Row<'_, D> {
    /// Number of neighbours.
    #[inline]
    pub fn len(&self) -> usize {
        self.neighbors.len()
    }

    /// Whether the particle is alone.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.neighbors.is_empty()
    }

    /// grad_i W \[m^-(D+1)\] of the pair at `position` in the row.
    #[inline]
    pub fn gradient(&self, position: usize) -> SVector<f64, D> {
        self.separations[position] * self.gradient_factors[position]
    }
}

/// Storage that one row after the other is built in. It grows to the longest list it has seen and then allocates
/// nothing; one per thread.
#[derive(Clone, Debug)]
pub struct RowBuffer<const D: usize> {
    neighbors: Vec<u32>,
    separations: Vec<SVector<f64, D>>,
    distances: Vec<f64>,
    values: Vec<f64>,
    gradient_factors: Vec<f64>,
}

impl<const D: usize> Default for RowBuffer<D> {
    fn default() -> Self {
        Self::with_capacity(0)
    }
}

impl<const D: usize> RowBuffer<D> {
    /// A buffer for lists of up to `neighbors` entries without another allocation.
    pub fn with_capacity(neighbors: usize) -> Self {
        Self {
            neighbors: vec![0; neighbors],
            separations: vec![SVector::zeros(); neighbors],
            distances: vec![0.0; neighbors],
            values: vec![0.0; neighbors],
            gradient_factors: vec![0.0; neighbors],
        }
    }

    /// The longest list \[entries\] that fits without an allocation.
    pub fn capacity(&self) -> usize {
        self.neighbors.len()
    }

    /// Builds the row of particle `index` for one constant smoothing length.
    ///
    /// `neighbors` is the particle's list without itself; entries outside the support (a list usually has a skin) are
    /// dropped. `positions` \[m\] are those of all particles.
    ///
    /// # Panics
    /// If `index` or a neighbour is outside `positions`.
    #[inline]
    pub fn fill(
        &mut self,
        index: usize,
        neighbors: &[u32],
        positions: &[SVector<f64, D>],
        kernel: &ScaledKernel<D>,
    ) -> Row<'_, D> {
        let support = kernel.support_radius();
        let count = self.gather(index, neighbors, positions, |_| support * support);
        kernel.evaluate_slice(
            &self.distances[..count],
            &mut self.values[..count],
            &mut self.gradient_factors[..count],
        );
        self.row(index, count)
    }

    /// Builds the row of particle `index` where smoothing lengths \[m\] vary: each pair takes the mean of its two, which
    /// keeps W and f symmetric in i and j (Hernquist and Katz 1989, for the length).
    ///
    /// # Panics
    /// If `index` or a neighbour is outside `positions` or `smoothing_lengths`.
    pub fn fill_with_mean_lengths<K: Kernel<D>>(
        &mut self,
        index: usize,
        neighbors: &[u32],
        positions: &[SVector<f64, D>],
        smoothing_lengths: &[f64],
        kernel: K,
    ) -> Row<'_, D> {
        let mean = |neighbor: u32| 0.5 * (smoothing_lengths[index] + smoothing_lengths[neighbor as usize]);
        let count = self.gather(index, neighbors, positions, |neighbor| {
            let support = kernel.support_radius(mean(neighbor));
            support * support
        });
        for k in 0..count {
            let length = mean(self.neighbors[k]);
            (self.values[k], self.gradient_factors[k]) =
                kernel.value_and_gradient_factor(self.distances[k], length);
        }
        self.row(index, count)
    }

    /// Stores neighbours nearer than their limit, which is given squared; returns how many there are.
    #[inline]
    fn gather(
        &mut self,
        index: usize,
        neighbors: &[u32],
        positions: &[SVector<f64, D>],
        limit_squared: impl Fn(u32) -> f64,
    ) -> usize {
        self.grow(neighbors.len());
        let here = positions[index];
        let mut count = 0;
        for &neighbor in neighbors {
            let separation = here - positions[neighbor as usize];
            let distance_squared = separation.norm_squared();
            self.neighbors[count] = neighbor;
            self.separations[count] = separation;
            self.distances[count] = distance_squared;
            // Written always and kept only if inside: no branch to mispredict at the edge of the support.
            count += usize::from(distance_squared < limit_squared(neighbor));
        }
        for distance in &mut self.distances[..count] {
            *distance = distance.sqrt();
        }
        count
    }

    fn grow(&mut self, length: usize) {
        if length > self.capacity() {
            *self = Self::with_capacity(length);
        }
    }

    #[inline]
    fn row(&self, index: usize, count: usize) -> Row<'_, D> {
        Row {
            index,
            neighbors: &self.neighbors[..count],
            separations: &self.separations[..count],
            distances: &self.distances[..count],
            values: &self.values[..count],
            gradient_factors: &self.gradient_factors[..count],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{KernelKind, test_points::perturbed_lattice};

    #[test]
    fn holds_exactly_the_pairs_inside_the_support() {
        let positions = perturbed_lattice::<3>(7, 0.2);
        let kernel = KernelKind::CubicSpline.with_smoothing_length::<3>(1.2);
        let index = 171;
        let others: Vec<u32> = (0..positions.len() as u32).filter(|&j| j as usize != index).collect();
        let mut buffer = RowBuffer::default();
        let row = buffer.fill(index, &others, &positions, &kernel);
        let separation = |j: u32| positions[index] - positions[j as usize];
        let inside: Vec<u32> = others.iter().copied().filter(|&j| separation(j).norm() < 2.4).collect();
        assert!(inside.len() > 30);
        assert_eq!((row.index, row.neighbors), (index, inside.as_slice()));
        for (k, &j) in row.neighbors.iter().enumerate() {
            assert_eq!(row.separations[k], separation(j));
            assert_eq!(row.distances[k], separation(j).norm());
            assert_eq!(row.values[k], kernel.value(row.distances[k]));
            assert_eq!(row.gradient(k), separation(j) * kernel.gradient_factor(row.distances[k]));
        }
    }

    #[test]
    fn allocates_nothing_once_warm() {
        let positions = perturbed_lattice::<2>(8, 0.1);
        let kernel = KernelKind::Gaussian.with_smoothing_length::<2>(1.0);
        let others: Vec<u32> = (1..positions.len() as u32).collect();
        let mut buffer = RowBuffer::default();
        let warm = buffer.fill(0, &others, &positions, &kernel).neighbors.as_ptr();
        let capacity = buffer.capacity();
        for length in [0, 5, others.len(), 17] {
            assert_eq!(buffer.fill(0, &others[..length], &positions, &kernel).neighbors.as_ptr(), warm);
        }
        assert_eq!(buffer.capacity(), capacity);
    }

    #[test]
    fn mean_lengths_are_symmetric_and_reduce_to_one_length() {
        let positions = perturbed_lattice::<2>(4, 0.2);
        let kernel = KernelKind::WendlandC2;
        let mut buffer = RowBuffer::default();
        let lengths: Vec<f64> = (0..positions.len()).map(|k| 0.8 + 0.03 * k as f64).collect();
        let of_five = buffer.fill_with_mean_lengths(5, &[6], &positions, &lengths, kernel);
        let (value, factor) = (of_five.values[0], of_five.gradient_factors[0]);
        assert!(value > 0.0);
        let of_six = buffer.fill_with_mean_lengths(6, &[5], &positions, &lengths, kernel);
        assert_eq!((of_six.values[0], of_six.gradient_factors[0]), (value, factor));
        let equal = vec![1.1; positions.len()];
        let varying =
            buffer.fill_with_mean_lengths(5, &[6, 9, 15], &positions, &equal, kernel).values.to_vec();
        let constant = kernel.with_smoothing_length::<2>(1.1);
        assert_eq!(buffer.fill(5, &[6, 9, 15], &positions, &constant).values, varying);
    }

    #[test]
    fn a_lonely_particle_has_an_empty_row() {
        let positions = [SVector::<f64, 2>::zeros(), SVector::from([9.0, 0.0])];
        let kernel = KernelKind::WendlandC2.with_smoothing_length::<2>(1.0);
        let mut buffer = RowBuffer::default();
        assert!(buffer.fill(0, &[], &positions, &kernel).is_empty());
        assert_eq!(buffer.fill(0, &[1], &positions, &kernel).len(), 0);
    }
}
