//! The swinging plate in three forms: period against Timoshenko's beam and change of energy. `plate [CELLS]...` over the
//! height, 5 and 10 by default.

#[path = "../tests/bodies/find.rs"]
mod find;

use find::find;
use sph_kernel::KernelKind;
use sph_solid::UpdatedControls;
use sph_solid::benchmarks::plate::{Swing, TIMOSHENKO, clamped, updated};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let given: Vec<usize> = std::env::args().skip(1).filter_map(|text| text.parse().ok()).collect();
    let all = if given.is_empty() { vec![5, 10] } else { given };
    println!("across  form                             period/Timoshenko  energy");
    for cells in all {
        let line = |name: &str, period: f64, energy: f64| {
            println!("{cells:6}  {name:32} {:17.3}  {energy:+.1e}", period / TIMOSHENKO);
        };
        let Swing { period, energy, .. } = clamped(cells, find)?;
        line("total Lagrangian, h/dx 0.8", period, energy);
        let spacing = 0.02 / cells as f64;
        let kernel = KernelKind::Gaussian.with_smoothing_length(1.2 * spacing);
        let paper = UpdatedControls::paper(kernel, spacing);
        for (name, controls) in [
            ("updated, corrected, h/dx 1.2", UpdatedControls::corrected(kernel, spacing)),
            ("updated, paper, h/dx 1.2", UpdatedControls { artificial_stress: 0.0, ..paper }),
            ("the same with artificial stress", paper),
        ] {
            let Swing { period, energy, .. } = updated(controls, find)?;
            line(name, period, energy);
        }
    }
    Ok(())
}
