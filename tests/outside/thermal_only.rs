//! A program of someone who takes `sph-thermal` and nothing else of this workspace: own kernel, own neighbour search,
//! own time loop. A quarter of a plate starts hot and molten, the rest cold; the plate evens out and keeps its energy.

use sph_thermal::conduction::{Images, PairTable, Planes};
use sph_thermal::phase::{EnthalpyCurve, Table, ThermalMaterial};

/// Spacing and smoothing length [m].
const DX: f64 = 1e-4;
const H: f64 = 0.85 * DX;
const SIDE: usize = 12;

/// W'(r)/r of the Wendland C2 kernel in two dimensions, support 2 h.
fn gradient_factor(distance: f64) -> f64 {
    let q = distance / H;
    if q < 2.0 { -35.0 / (4.0 * std::f64::consts::PI * H.powi(4)) * (1.0 - 0.5 * q).powi(3) } else { 0.0 }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let aluminium = ThermalMaterial {
        density: 2500.0,
        solidus: 847.0,
        liquidus: 905.0,
        latent_heat: 3.97e5,
        heat_capacity_solid: Table::new(vec![(300.0, 900.0), (847.0, 1050.0)])?,
        heat_capacity_liquid: Table::constant(1180.0)?,
        conductivity_solid: Table::constant(200.0)?,
        conductivity_liquid: Table::constant(95.0)?,
    };
    let curve = EnthalpyCurve::continuous(&aluminium)?;

    let places: Vec<[f64; 2]> =
        (0..SIDE * SIDE).map(|n| [n % SIDE, n / SIDE].map(|k| (k as f64 + 0.5) * DX)).collect();
    let positions: Vec<_> = places.iter().map(|&place| place.into()).collect();
    let volume = vec![DX * DX; places.len()];
    let plate = Planes::adiabatic_box([0.0; 2], [SIDE as f64 * DX; 2]);
    let images = Images::new(&positions, &vec![2.0 * H; places.len()], &plate);
    let all: Vec<[f64; 2]> =
        places.iter().copied().chain(images.position.iter().map(|&image| image.into())).collect();
    let near =
        |i: usize, j: usize| i != j && (places[i][0] - all[j][0]).hypot(places[i][1] - all[j][1]) < 2.0 * H;
    let neighbors: Vec<Vec<u32>> = (0..places.len())
        .map(|i| (0..all.len()).filter(|&j| near(i, j)).map(|j| j as u32).collect())
        .collect();
    let pairs =
        PairTable::new(&positions, &volume, &images, |i| &neighbors[i], |_, _, r| gradient_factor(r))?;
    let (rows, fit) = pairs.fitted(1e-6)?;

    let hot = |place: &[f64; 2]| place.iter().all(|&x| x < 0.5 * SIDE as f64 * DX);
    let mut enthalpy: Vec<f64> =
        places.iter().map(|place| curve.enthalpy_at(if hot(place) { 1200.0 } else { 300.0 })).collect();
    let before: f64 = enthalpy.iter().sum();
    let molten = |enthalpy: &[f64]| enthalpy.iter().filter(|&&h| curve.liquid_fraction(h) > 0.5).count();
    let start = molten(&enthalpy);
    // Steps of 5 us, a third of the explicit limit.
    for _ in 0..4000 {
        let theta: Vec<f64> = enthalpy.iter().map(|&h| curve.potential(h)).collect();
        for (h, heat) in enthalpy.iter_mut().zip(rows.heat(&theta)) {
            *h += 5e-6 * heat / (aluminium.density * DX * DX);
        }
    }
    let kept = enthalpy.iter().sum::<f64>() / before - 1.0;
    let temperatures: Vec<f64> = enthalpy.iter().map(|&h| curve.temperature(h)).collect();
    let spread = temperatures.iter().fold(0.0f64, |most, t| most.max((t - temperatures[0]).abs()));
    assert_eq!((start, molten(&enthalpy)), (SIDE * SIDE / 4, 0), "what was molten has frozen");
    assert!(kept.abs() < 1e-12 && spread < 1.0, "energy {kept:e}, spread {spread} K");
    println!(
        "thermal-only: {} pairs fitted to {:.1e}; {start} molten particles froze, energy kept to {kept:.1e}, all at {:.1} K",
        rows.pairs(),
        fit.residual,
        temperatures[0]
    );
    Ok(())
}
