//! The swinging plate in three forms: period against Timoshenko's beam and change of energy. `plate [CELLS]...` over the
//! height, 5 and 10 by default.

#[allow(dead_code, reason = "shared with the tests, which use all of it")]
#[path = "../tests/bodies/plate.rs"]
mod plate;
#[allow(dead_code, reason = "shared with the tests, which use all of it")]
#[path = "../tests/bodies/scene.rs"]
mod scene;
#[allow(dead_code, reason = "shared with the tests, which use all of it")]
#[path = "../tests/bodies/updated_scene.rs"]
mod updated_scene;

use sph_kernel::KernelKind;
use sph_solid::UpdatedControls;

/// Timoshenko's period over that of a thin plate.
const TIMOSHENKO: f64 = 1.0096;

fn main() {
    let given: Vec<usize> = std::env::args().skip(1).filter_map(|text| text.parse().ok()).collect();
    let all = if given.is_empty() { vec![5, 10] } else { given };
    println!("across  form                             period/Timoshenko  energy");
    for cells in all {
        let line = |name: &str, (period, energy): (f64, f64)| {
            println!("{cells:6}  {name:32} {:17.3}  {energy:+.1e}", period / TIMOSHENKO);
        };
        line("total Lagrangian, h/dx 0.8", plate::total(cells, 0.8));
        let spacing = 0.02 / cells as f64;
        let kernel = KernelKind::Gaussian.with_smoothing_length(1.2 * spacing);
        line(
            "updated, corrected, h/dx 1.2",
            plate::updated(cells, UpdatedControls::corrected(kernel, spacing)),
        );
        let paper = UpdatedControls::paper(kernel, spacing);
        line(
            "updated, paper, h/dx 1.2",
            plate::updated(cells, UpdatedControls { artificial_stress: 0.0, ..paper }),
        );
        line("the same with artificial stress", plate::updated(cells, paper));
    }
}
