//! Mirrored images across plane faces.
//!
//! A particle near an adiabatic face or a symmetry plane sees the body continued by its mirror image with the same
//! potential (even); near a face of fixed potential, with the potential reflected about the face's value (odd):
//! theta' = 2 theta_face - theta. Folded into the pair weights at set-up, images cost nothing at run time and make the
//! scheme second order up to the face (plain SPH is 5 to 16 % too hot there).

use nalgebra::SVector;

/// How the potential continues across a plane face.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Parity {
    /// Mirrored: no heat flows through the plane (adiabatic or symmetry).
    Even,
    /// Reflected about the face's own value: the face holds a fixed potential.
    Odd,
}

/// The plane faces of an axis-aligned body: two a dimension, each absent or with a parity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Planes<const D: usize> {
    /// Coordinates of the low and high face of each axis \[m\].
    pub position: [[f64; 2]; D],
    /// Parity of the low and high face of each axis; `None` where there is no plane.
    pub parity: [[Option<Parity>; 2]; D],
}

impl<const D: usize> Planes<D> {
    /// A box whose faces are all mirrors: the adiabatic body.
    pub fn adiabatic_box(low: [f64; D], high: [f64; D]) -> Self {
        let position = std::array::from_fn(|axis| [low[axis], high[axis]]);
        Self { position, parity: [[Some(Parity::Even); 2]; D] }
    }
}

/// One way to continue a coordinate across the planes of its axis.
#[derive(Debug, Clone, Copy)]
struct Continuation {
    /// x' = sign x + shift.
    sign: f64,
    shift: f64,
    /// theta' = parity theta + wall[0] theta_low + wall[1] theta_high.
    parity: f64,
    wall: [f64; 2],
}

/// Images of particles, each with its source, its position, and how the source's values continue.
#[derive(Debug, Clone, PartialEq)]
pub struct Images<const D: usize> {
    /// Index of the particle that an image mirrors.
    pub source: Vec<u32>,
    /// Where the image stands \[m\].
    pub position: Vec<SVector<f64, D>>,
    /// Sign by which each vector component of the source continues: -1 on mirrored axes.
    pub mirror: Vec<[f64; D]>,
    /// +1 where the potential is mirrored, -1 where it is reflected about a face's value.
    pub parity: Vec<f64>,
    /// Share of each face's potential in the image's: low and high of each axis.
    pub wall: Vec<[[f64; 2]; D]>,
    /// What is added to each component of the source's position after the mirror \[m\].
    shift: Vec<[f64; D]>,
    /// For each particle the axes along which it stands outside the body.
    outside: Vec<[bool; D]>,
}

impl Continuation {
    fn is_identity(&self) -> bool {
        self.sign == 1.0 && self.shift == 0.0
    }
}

impl<const D: usize> Images<D> {
    /// All images that lie within `reach` of the body, which must be at least half of `reach` thick. A particle outside the
    /// body has none on the axis along which it is outside.
    ///
    /// `reach` \[m\] is a column: the farthest that each particle can be seen from.
    pub fn new(positions: &[SVector<f64, D>], reach: &[f64], planes: &Planes<D>) -> Self {
        let continuations: Vec<_> = (0..D).map(|axis| continuations(planes, axis)).collect();
        let mut images = Self {
            source: Vec::new(),
            position: Vec::new(),
            mirror: Vec::new(),
            parity: Vec::new(),
            wall: Vec::new(),
            shift: Vec::new(),
            outside: Vec::new(),
        };
        for (index, (position, &reach)) in positions.iter().zip(reach).enumerate() {
            images.add_all(index as u32, position, reach, planes, &continuations);
        }
        images
    }

    /// Whether a particle sees an image: not one across a plane beyond which it stands itself, so that of two particles either
    /// both see the other's image or neither does.
    pub fn is_seen(&self, image: usize, particle: usize) -> bool {
        let reflected = |axis: usize| self.mirror[image][axis] != 1.0 || self.shift[image][axis] != 0.0;
        (0..D).all(|axis| !(reflected(axis) && self.outside[particle][axis]))
    }

    /// Where an image stands when its source is at `x` \[m\].
    pub fn place(&self, image: usize, x: &SVector<f64, D>) -> SVector<f64, D> {
        SVector::from_fn(|axis, _| self.mirror[image][axis] * x[axis] + self.shift[image][axis])
    }

    /// Number of images.
    pub fn len(&self) -> usize {
        self.source.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.source.is_empty()
    }

    /// Adds every combination of continuations of one particle that is in reach of the body.
    fn add_all(
        &mut self,
        source: u32,
        position: &SVector<f64, D>,
        reach: f64,
        planes: &Planes<D>,
        continuations: &[Vec<Continuation>],
    ) {
        let outside: [bool; D] = std::array::from_fn(|axis| {
            let [low, high] = planes.position[axis];
            position[axis] < low || position[axis] > high
        });
        self.outside.push(outside);
        let in_reach: [Vec<&Continuation>; D] = std::array::from_fn(|axis| {
            let [low, high] = planes.position[axis];
            // What stands beyond a plane itself, like melt that bulges, would be mirrored into the body.
            let near = |c: &&Continuation| {
                let x = c.sign * position[axis] + c.shift;
                c.is_identity() || (!outside[axis] && x > low - reach && x < high + reach)
            };
            continuations[axis].iter().filter(near).collect()
        });
        let combinations: usize = in_reach.iter().map(Vec::len).product();
        // Combination 0 takes the identity on every axis: the particle itself.
        for combination in 1..combinations {
            let mut rest = combination;
            let chosen: [&Continuation; D] = std::array::from_fn(|axis| {
                let choice = in_reach[axis][rest % in_reach[axis].len()];
                rest /= in_reach[axis].len();
                choice
            });
            self.add(source, position, chosen);
        }
    }

    fn add(&mut self, source: u32, position: &SVector<f64, D>, chosen: [&Continuation; D]) {
        self.source.push(source);
        self.mirror.push(chosen.map(|c| c.sign));
        self.shift.push(chosen.map(|c| c.shift));
        self.position.push(self.place(self.source.len() - 1, position));
        self.parity.push(chosen.iter().map(|c| c.parity).product());
        // Axis after axis: each later reflection also reflects what the earlier ones brought in.
        let mut wall = [[0.0; 2]; D];
        for (axis, continuation) in chosen.iter().enumerate() {
            wall.iter_mut().flatten().for_each(|share| *share *= continuation.parity);
            wall[axis] = continuation.wall;
        }
        self.wall.push(wall);
    }
}

/// The identity first, then the reflections in either plane and, between two planes, both double reflections.
fn continuations<const D: usize>(planes: &Planes<D>, axis: usize) -> Vec<Continuation> {
    let [low, high] = planes.position[axis];
    let reflect = |parity: Parity| if parity == Parity::Even { (1.0, 0.0) } else { (-1.0, 2.0) };
    let mut all = vec![Continuation { sign: 1.0, shift: 0.0, parity: 1.0, wall: [0.0; 2] }];
    let [at_low, at_high] = planes.parity[axis];
    if let Some((parity, share)) = at_low.map(reflect) {
        all.push(Continuation { sign: -1.0, shift: 2.0 * low, parity, wall: [share, 0.0] });
    }
    if let Some((parity, share)) = at_high.map(reflect) {
        all.push(Continuation { sign: -1.0, shift: 2.0 * high, parity, wall: [0.0, share] });
    }
    if let (Some((low_parity, low_share)), Some((high_parity, high_share))) =
        (at_low.map(reflect), at_high.map(reflect))
    {
        let width = high - low;
        let parity = low_parity * high_parity;
        // First in the low plane, then in the high one, and the other way round.
        let upper = [high_parity * low_share, high_share];
        let lower = [low_share, low_parity * high_share];
        all.push(Continuation { sign: 1.0, shift: 2.0 * width, parity, wall: upper });
        all.push(Continuation { sign: 1.0, shift: -2.0 * width, parity, wall: lower });
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector2;
    use nalgebra::Vector3;

    #[test]
    fn a_corner_particle_has_seven_images_in_three_dimensions() {
        let mut planes = Planes::adiabatic_box([0.0; 3], [1.0; 3]);
        planes.parity.iter_mut().for_each(|axis| axis[1] = None);
        let images = Images::new(&[Vector3::new(0.1, 0.1, 0.1)], &[0.5], &planes);
        assert_eq!(images.len(), 7);
        let opposite = images.position.iter().position(|p| (p + Vector3::new(0.1, 0.1, 0.1)).norm() < 1e-15);
        assert_eq!(images.mirror[opposite.unwrap()], [-1.0; 3]);
    }

    #[test]
    fn a_particle_far_from_every_face_has_none() {
        let planes = Planes::adiabatic_box([0.0; 2], [1.0; 2]);
        assert!(Images::new(&[Vector2::new(0.5, 0.5)], &[0.2], &planes).is_empty());
    }

    #[test]
    fn a_particle_beyond_a_face_is_not_mirrored_into_the_body() {
        let planes = Planes::adiabatic_box([0.0; 2], [1.0; 2]);
        assert!(Images::new(&[Vector2::new(0.5, 1.1)], &[0.3], &planes).is_empty());
        // Along the other axis it still is.
        let beside = Images::new(&[Vector2::new(0.1, 1.1)], &[0.3], &planes);
        assert_eq!(beside.position, [Vector2::new(-0.1, 1.1)]);
        // And it sees no image across the plane that it is beyond.
        let both = Images::new(&[Vector2::new(0.5, 1.1), Vector2::new(0.5, 0.95)], &[0.3, 0.3], &planes);
        assert_eq!(both.position, [Vector2::new(0.5, 1.05)]);
        assert!(!both.is_seen(0, 0) && both.is_seen(0, 1));
    }

    #[test]
    fn an_odd_face_continues_a_linear_field_exactly() {
        // theta = 3 + 2 x between faces of fixed value: every image must carry 3 + 2 x' of its own position.
        let planes =
            Planes { position: [[0.0, 1.0], [0.0, 1.0]], parity: [[Some(Parity::Odd); 2], [None; 2]] };
        let at = Vector2::new(0.3, 0.5);
        let images = Images::new(&[at], &[1.8], &planes);
        assert_eq!(images.len(), 4);
        for i in 0..images.len() {
            let wall = images.wall[i][0];
            let value = images.parity[i] * (3.0 + 2.0 * at.x) + wall[0] * 3.0 + wall[1] * 5.0;
            assert!((value - (3.0 + 2.0 * images.position[i].x)).abs() < 1e-14);
        }
    }
}
