//! A program of someone whose points are glam's: `sph-neighbors` searches them, single and double precision, and the
//! rows index the caller's own points.

use glam::{DVec2, Vec3};
use sph_neighbors::{PairReach, SearchMethod, spatial_order};

const REACH: f64 = 0.31;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Vogel's spiral: even, and on no lattice.
    let golden = std::f64::consts::PI * (3.0 - 5.0f64.sqrt());
    let seeds: Vec<DVec2> =
        (0..900).map(|k| 0.1 * f64::from(k).sqrt() * DVec2::from_angle(golden * f64::from(k))).collect();
    let flat = SearchMethod::default().find(
        &seeds.iter().map(|seed| seed.to_array().into()).collect::<Vec<_>>(),
        PairReach::Uniform(REACH),
    )?;
    for (i, seed) in seeds.iter().enumerate() {
        let near = |&j: &usize| j != i && seed.distance(seeds[j]) <= REACH;
        let expected: Vec<u32> = (0..seeds.len()).filter(near).map(|j| j as u32).collect();
        assert_eq!(flat.row(i), expected, "row {i}");
    }

    let mut stars: Vec<Vec3> =
        seeds.iter().map(|seed| seed.as_vec2().extend((7.0 * seed.x as f32).sin())).collect();
    let positions =
        |stars: &[Vec3]| stars.iter().map(|star| star.as_dvec3().to_array().into()).collect::<Vec<_>>();
    let before = SearchMethod::default().find(&positions(&stars), PairReach::Uniform(REACH))?;
    // Sorted in space, the same pairs are found.
    spatial_order(&positions(&stars), REACH)?.apply(&mut stars);
    let after = SearchMethod::default().find(&positions(&stars), PairReach::Uniform(REACH))?;
    assert_eq!(before.pairs(), after.pairs());
    println!("points-of-glam: {} pairs in the plane, {} in space", flat.pairs(), after.pairs());
    Ok(())
}
