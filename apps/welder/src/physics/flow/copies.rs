//! Images of melt and solid in the symmetry planes of a part.

use nalgebra::Vector3;

/// A plane that the part is mirrored in: axis, and place on it \[m\].
pub(super) type Mirror = (usize, f64);

/// Where an image is, and how vectors continue there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Image {
    /// Number of the particle that it shows.
    pub source: u32,
    /// Sign of each component: -1 on the axes that are mirrored.
    pub signs: Vector3<f64>,
    /// Twice the place of the plane on mirrored axes, zero on the others \[m\].
    shift: Vector3<f64>,
}

impl Image {
    /// Where it is when its particle is at `x` \[m\].
    pub fn place(&self, x: &Vector3<f64>) -> Vector3<f64> {
        x.component_mul(&self.signs) + self.shift
    }
}

/// Images of all `positions` nearer than `reach` \[m\] to a plane; in the edge of two planes also those of images.
pub(super) fn images(positions: &[Vector3<f64>], mirrors: &[Mirror], reach: f64) -> Vec<Image> {
    let mut found: Vec<Image> = Vec::new();
    for (at, &(axis, plane)) in mirrors.iter().enumerate() {
        let before = if at == 0 { 0 } else { found.len() };
        let reflect = |image: Image| {
            let near = (image.place(&positions[image.source as usize])[axis] - plane).abs() < reach;
            let mut reflected = image;
            reflected.signs[axis] = -image.signs[axis];
            reflected.shift[axis] = 2.0 * plane - image.shift[axis];
            near.then_some(reflected)
        };
        let own = |source: usize| Image {
            source: source as u32,
            signs: Vector3::repeat(1.0),
            shift: Vector3::zeros(),
        };
        let of_images: Vec<Image> = found[..before].iter().copied().filter_map(reflect).collect();
        found.extend((0..positions.len()).filter_map(|source| reflect(own(source))));
        found.extend(of_images);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_particle_near_the_edge_of_two_planes_has_three_images_and_one_near_none_has_none() {
        let positions = [Vector3::new(0.2, 1.1, 0.5), Vector3::new(5.0, 7.0, 0.5)];
        let found = images(&positions, &[(0, 0.0), (1, 1.0)], 0.5);
        let places: Vec<_> = found.iter().map(|image| image.place(&positions[0])).collect();
        assert!(found.iter().all(|image| image.source == 0));
        let expected = [[-0.2, 1.1, 0.5], [0.2, 0.9, 0.5], [-0.2, 0.9, 0.5]].map(Vector3::from);
        assert_eq!(places.len(), 3);
        for place in expected {
            assert!(places.iter().any(|found| (found - place).norm() < 1e-15), "{place}: {places:?}");
        }
        let signs: Vec<_> = found.iter().map(|image| image.signs.x * image.signs.y).collect();
        assert_eq!(signs.iter().filter(|&&sign| sign == 1.0).count(), 1);
    }
}
