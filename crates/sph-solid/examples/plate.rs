//! Work and precision of the swinging plate in all forms: period against Timoshenko's beam, change of energy and cost, and what each
//! form costs at equal error. `plate [CELLS]...` over the height, 3 and 5 by default; 20 takes minutes.

#[path = "../tests/bodies/find.rs"]
mod find;
mod processor;

use find::find;
use processor::processor_seconds;
use sph_kernel::KernelKind;
use sph_solid::benchmarks::plate::{Swing, TIMOSHENKO, clamped, updated};
use sph_solid::{Error, UpdatedControls};

/// Errors of the period at which costs are compared \[%\].
const ERRORS: [f64; 4] = [20.0, 10.0, 5.0, 2.0];

/// One plate in one form.
struct Found {
    cells: usize,
    /// Error of the period \[%\].
    error: f64,
    energy: f64,
    steps: u64,
    pairs: u64,
    /// Processor time \[s\].
    seconds: f64,
}

impl Found {
    fn of<Patch>(cells: usize, swing: &Swing<Patch>, pairs: u64, seconds: f64) -> Self {
        let error = 100.0 * (swing.period / TIMOSHENKO - 1.0);
        Self { cells, error, energy: swing.energy, steps: swing.steps, pairs, seconds }
    }
}

/// A name and how a plate of so many cells over the height swings.
type Form = (&'static str, fn(usize) -> Result<Found, Error>);

const FORMS: [Form; 4] = [
    ("total, h/dx 0.8", |cells| {
        let before = processor_seconds();
        let swing = clamped(cells, find)?;
        Ok(Found::of(cells, &swing, swing.patch.pair_visits(), processor_seconds() - before))
    }),
    ("updated, corrected, h/dx 1.2", |cells| swing_updated(cells, UpdatedControls::corrected)),
    ("updated, paper, no artificial stress", |cells| {
        swing_updated(cells, |kernel, spacing| UpdatedControls {
            artificial_stress: 0.0,
            ..UpdatedControls::paper(kernel, spacing)
        })
    }),
    ("updated, paper, artificial stress 0.3", |cells| swing_updated(cells, UpdatedControls::paper)),
];

fn swing_updated(
    cells: usize,
    controls: impl Fn(sph_kernel::ScaledKernel<2>, f64) -> UpdatedControls<2>,
) -> Result<Found, Error> {
    let (spacing, before) = (0.02 / cells as f64, processor_seconds());
    let kernel = KernelKind::Gaussian.with_smoothing_length(1.2 * spacing);
    let swing = updated(controls(kernel, spacing), find)?;
    Ok(Found::of(cells, &swing, swing.patch.pair_visits(), processor_seconds() - before))
}

/// Processor time \[s\] at which a form has the error, on the straight lines between its plates over logarithms; none beyond
/// them.
fn cost_at(error: f64, found: &[Found]) -> Option<f64> {
    let pair = found.windows(2).find(|pair| pair[0].error >= error && pair[1].error <= error)?;
    let share = (pair[0].error / error).ln() / (pair[0].error / pair[1].error).ln();
    Some(pair[0].seconds * (pair[1].seconds / pair[0].seconds).powf(share))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let given: Vec<usize> = std::env::args().skip(1).filter_map(|text| text.parse().ok()).collect();
    let cells = if given.is_empty() { vec![3, 5] } else { given };
    println!(
        "| form | across | period, error % | energy | steps | pairs, millions | cpu s | cpu us a particle-step |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    let mut costs = Vec::new();
    for (name, run) in FORMS {
        let found = cells.iter().map(|&cells| run(cells)).collect::<Result<Vec<_>, _>>()?;
        for Found { cells, error, energy, steps, pairs, seconds } in &found {
            let particles = (10 * cells + 4) * cells;
            println!(
                "| {name} | {cells} | {error:+.2} | {energy:+.1e} | {steps} | {:.1} | {seconds:.2} | {:.2} |",
                1e-6 * *pairs as f64,
                1e6 * seconds / (*steps as f64 * particles as f64),
            );
        }
        costs.push((name, ERRORS.map(|error| cost_at(error, &found))));
    }
    println!("\n| cpu s at an error of | {} |", ERRORS.map(|error| format!("{error} %")).join(" | "));
    println!("|---{}|", "|---".repeat(ERRORS.len()));
    for (name, costs) in costs {
        let cells = costs.map(|cost| cost.map_or("-".into(), |cost| format!("{cost:.2}")));
        println!("| {name} | {} |", cells.join(" | "));
    }
    Ok(())
}
