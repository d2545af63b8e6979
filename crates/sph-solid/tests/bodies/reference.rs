//! Changing the reference, and spacing that changes within a body.

use nalgebra::{Matrix2, SMatrix, SVector, Vector2};
use sph_kernel::KernelKind;
use sph_neighbors::{PairReach, SearchMethod};
use sph_solid::benchmarks::aluminium::{ALPHA, DENSITY, aluminium};
use sph_solid::benchmarks::shapes::lattice;
use sph_solid::{
    Controls, Inelastic, Material, Motion, ReferenceColumns, SymmetricTensor, TotalLagrangian,
    strain_of_stress,
};

const SPACING: f64 = 1e-3;

/// A body with h = `ratio` times each particle's own spacing.
fn body(
    positions: &[Vector2<f64>],
    spacings: &[f64],
    volumes: &[f64],
    masses: &[f64],
    material: Material,
) -> TotalLagrangian<2> {
    let lengths: Vec<f64> = spacings.iter().map(|spacing| 0.8 * spacing).collect();
    let reaches: Vec<f64> = lengths.iter().map(|length| 3.001 * length).collect();
    let list = SearchMethod::default().find(positions, PairReach::Mean(&reaches)).unwrap();
    let columns = ReferenceColumns {
        positions,
        volumes,
        masses,
        temperatures: &vec![293.0; positions.len()],
        smoothing_lengths: &lengths,
        list_starts: list.starts(),
        list_neighbors: list.indices(),
    };
    TotalLagrangian::new(&columns, KernelKind::Gaussian, material, Controls::default()).unwrap()
}

/// Accelerations and stresses for one state.
fn evaluate(
    body: &mut TotalLagrangian<2>,
    displacements: &[Vector2<f64>],
    temperature: f64,
    strains: &mut [SymmetricTensor<2>],
) -> (Vec<Vector2<f64>>, Vec<SymmetricTensor<2>>) {
    let particles = displacements.len();
    let temperatures = vec![temperature; particles];
    let motion = Motion { displacements, velocities: &[], temperatures: &temperatures };
    let mut equivalents = vec![0.0; particles];
    let mut accelerations = vec![SVector::zeros(); particles];
    let mut inelastic = Inelastic { strains, equivalents: &mut equivalents };
    body.accelerations(&motion, &mut inelastic, &mut accelerations);
    let (mut in_plane, mut out_of_plane) = (vec![SMatrix::zeros(); particles], vec![0.0; particles]);
    body.stresses(&temperatures, strains, &mut in_plane, &mut out_of_plane);
    let pair = |(in_plane, out_of_plane)| SymmetricTensor { in_plane, out_of_plane };
    (accelerations, in_plane.into_iter().zip(out_of_plane).map(pair).collect())
}

#[test]
fn a_new_reference_carries_the_stress_over() {
    let positions = lattice([-5.0 * SPACING; 2], [10, 10], SPACING);
    let (spacings, volumes) = (vec![SPACING; 100], vec![SPACING * SPACING; 100]);
    let masses: Vec<f64> = volumes.iter().map(|volume| volume * DENSITY).collect();
    let mut old = body(&positions, &spacings, &volumes, &masses, aluminium(0.0).unwrap());
    // Small strain on top of a turn by 40 degrees.
    let turn = *nalgebra::Rotation2::new(0.7).matrix();
    let place = |x: &Vector2<f64>| turn * (x + Vector2::new(1e-2 * x.x * x.x / SPACING, 1e-3 * x.x) * 0.1);
    let displacements: Vec<_> = positions.iter().map(|x| place(x) - x).collect();
    let (before, stresses) =
        evaluate(&mut old, &displacements, 293.0, &mut vec![SymmetricTensor::zero(); 100]);

    let present: Vec<_> = positions.iter().map(place).collect();
    let grown: Vec<f64> = (0..100).map(|i| volumes[i] * old.deformations()[i].determinant()).collect();
    let mut new = body(&present, &spacings, &grown, &masses, aluminium(0.0).unwrap());
    let moduli = *aluminium(0.0).unwrap().solver_moduli();
    let mut strains: Vec<_> =
        stresses.iter().map(|stress| strain_of_stress(stress, &moduli) * -1.0).collect();
    let (after, carried) = evaluate(&mut new, &[Vector2::zeros(); 100], 293.0, &mut strains);
    let scale = stresses.iter().map(|stress| stress.in_plane.norm()).fold(0.0, f64::max);
    let push = before.iter().map(Vector2::norm).fold(0.0, f64::max);
    let force = |i: usize| (after[i] - before[i]).norm() / push;
    assert_eq!(new.masses(), old.masses());
    for i in 0..100 {
        assert!((carried[i].in_plane - stresses[i].in_plane).norm() < 1e-12 * scale);
        // The hourglass energy is forgotten, and the kernel sees the body anew: small beside the force, not zero.
        assert!(force(i) < 0.05, "{}", force(i));
    }
}

#[test]
fn a_jump_of_spacing_keeps_linear_fields_and_free_expansion() {
    // Fine left of x = 0, twice as coarse right of it.
    let fine = lattice([-10.0 * SPACING, -6.0 * SPACING], [10, 12], SPACING);
    let coarse = lattice([0.0, -6.0 * SPACING], [5, 6], 2.0 * SPACING);
    let spacings = [vec![SPACING; fine.len()], vec![2.0 * SPACING; coarse.len()]].concat();
    let positions = [fine, coarse].concat();
    let volumes: Vec<f64> = spacings.iter().map(|spacing| spacing * spacing).collect();
    let masses: Vec<f64> = volumes.iter().map(|volume| volume * DENSITY).collect();
    let mut strains = vec![SymmetricTensor::zero(); positions.len()];
    let mut plain = body(&positions, &spacings, &volumes, &masses, aluminium(0.0).unwrap());
    let gradient = Matrix2::new(2e-3, -5e-3, 4e-3, -1e-3);
    let linear: Vec<_> = positions.iter().map(|x| gradient * x).collect();
    evaluate(&mut plain, &linear, 293.0, &mut strains);
    for deformation in plain.deformations() {
        assert!((deformation - Matrix2::identity() - gradient).norm() < 1e-14);
    }
    // Warm by 50 K: the plane expansion that leaves no stress in the plane, found from the law itself.
    let mut warm = body(&positions, &spacings, &volumes, &masses, aluminium(ALPHA).unwrap());
    let free = |growth: f64| positions.iter().map(|x| x * growth).collect::<Vec<_>>();
    let (mut low, mut high) = (0.0, 1e-2);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        let stress = evaluate(&mut warm, &free(middle), 343.0, &mut strains).1[0].in_plane[(0, 0)];
        if stress < 0.0 { low = middle } else { high = middle }
    }
    let (accelerations, stresses) = evaluate(&mut warm, &free(low), 343.0, &mut strains);
    assert!((low / (1.33 * 50.0 * ALPHA) - 1.0).abs() < 2e-3, "{low}");
    let scale = 70e9 * 50.0 * ALPHA;
    assert!(stresses.iter().all(|stress| stress.in_plane.norm() < 1e-10 * scale));
    assert!(accelerations.iter().all(|a| a.norm() < 1e-10 * scale / (DENSITY * SPACING)));
}
