//! The swinging plate of Gray, Monaghan and Swift (2001), clamped by four layers behind its root.

use crate::scene::{Scene, lattice};
use crate::updated_scene::UpdatedScene;
use nalgebra::Vector2;
use sph_solid::{Controls, IsotropicModuli, Material, UpdatedControls};

/// Length and height of the plate of Gray, Monaghan and Swift (2001) \[m\].
const PLATE: [f64; 2] = [0.2, 0.02];

/// Period of a thin plate \[s\]; Timoshenko's is 1.0096 times it.
const THIN: f64 = 0.254_13;

/// Speed of the tip at the start \[m/s\]: a thousandth of sqrt(K/rho).
const AMPLITUDE: f64 = 0.057_009;

fn rubber() -> Material {
    Material::elastic(IsotropicModuli::from_bulk_and_shear(3.25e6, 7.15e5).unwrap(), 1000.0).unwrap()
}

fn positions(cells: usize) -> Vec<Vector2<f64>> {
    let spacing = PLATE[1] / cells as f64;
    lattice([-4.0 * spacing, -0.5 * PLATE[1]], [10 * cells + 4, cells], spacing)
}

/// T/T_thin and the relative change of total energy in half a period, total Lagrangian, `cells` over the height.
pub fn total(cells: usize, ratio: f64) -> (f64, f64) {
    let spacing = PLATE[1] / cells as f64;
    let scene = Scene::new(positions(cells), spacing, ratio, rubber(), Controls::default());
    let (half, energy) = swing(scene, |position| position.x < 0.0);
    (2.0 * half / THIN, energy)
}

/// The same plate held as by Gray, Monaghan and Swift: its root, two heights deep, is free between fixed strips of three
/// layers above and below. Its period \[s\] and the relative change of energy.
pub fn between_strips(cells: usize, ratio: f64) -> (f64, f64) {
    let spacing = PLATE[1] / cells as f64;
    let (root, half_height) = (2.0 * PLATE[1], 0.5 * PLATE[1]);
    let box_of_all = lattice([-root, -half_height - 3.0 * spacing], [12 * cells, cells + 6], spacing);
    let fixed = move |x: &Vector2<f64>| x.y.abs() > half_height;
    let positions = box_of_all.into_iter().filter(|x| !fixed(x) || x.x < 0.0).collect();
    let scene = Scene::new(positions, spacing, ratio, rubber(), Controls::default());
    let (half, energy) = swing(scene, fixed);
    (2.0 * half, energy)
}

/// Half a period \[s\] and the relative change of energy over it, started in the first mode.
fn swing(mut scene: Scene<2>, fixed: impl Fn(&Vector2<f64>) -> bool) -> (f64, f64) {
    for (position, free) in scene.positions.iter().zip(&mut scene.free) {
        if fixed(position) {
            *free = Vector2::zeros();
        }
    }
    let dt = scene.body.stable_step(0.6);
    let half = scene.half_period(|x| Vector2::new(0.0, first_mode(x.x / PLATE[0])), AMPLITUDE, dt, 0.25);
    let start = |i: usize| {
        let speed = AMPLITUDE * first_mode(scene.positions[i].x / PLATE[0]) * scene.free[i].y;
        0.5 * scene.body.masses()[i] * speed * speed
    };
    let start: f64 = (0..scene.positions.len()).map(start).sum();
    (half, scene.energies().iter().sum::<f64>() / start - 1.0)
}

/// The same with the updated-Lagrangian form; energy lost to viscosity counts as change.
pub fn updated(cells: usize, controls: UpdatedControls<2>) -> (f64, f64) {
    let mut scene = UpdatedScene::new(positions(cells), rubber(), controls);
    for i in 0..scene.positions.len() {
        let position = scene.positions[i];
        if position.x < 0.0 {
            scene.free[i] = Vector2::zeros();
        } else {
            scene.velocities[i].y = AMPLITUDE * first_mode(position.x / PLATE[0]);
        }
    }
    let shape = scene.velocities.clone();
    let start: Vec<Vector2<f64>> = scene.positions.clone();
    let project = |scene: &UpdatedScene<2>| -> f64 {
        (0..start.len()).map(|i| (scene.positions[i] - start[i]).dot(&shape[i])).sum()
    };
    let (energy, dt) = (scene.kinetic_energy(), scene.stable_step(0.6));
    let chunk = (2.5e-3 / dt).ceil() as usize;
    let (mut time, mut before) = (0.0, 0.0);
    while time < 0.25 {
        scene.run(chunk, dt);
        time += chunk as f64 * dt;
        let now = project(&scene);
        if before > 0.0 && now <= 0.0 {
            let half = time - chunk as f64 * dt * now / (now - before);
            let change = (scene.kinetic_energy() + scene.elastic_energy()) / energy - 1.0;
            return (2.0 * half / THIN, change);
        }
        before = now;
    }
    (f64::NAN, f64::NAN)
}

/// First mode of a cantilever beam, 1 at the tip (x = 1).
fn first_mode(x: f64) -> f64 {
    let k: f64 = 1.875_104_068_711_961;
    let ratio = (k.cos() + k.cosh()) / (k.sin() + k.sinh());
    let shape = |x: f64| (k * x).cosh() - (k * x).cos() - ratio * ((k * x).sinh() - (k * x).sin());
    shape(x.max(0.0)) / shape(1.0)
}
