//! Heat in a bar of 200 cells with a hot spot: RKL2 super steps under error control, against the exact decay.
//!
//! Prints for each tolerance the accepted and rejected steps, the evaluations of the right-hand side, those
//! that explicit Euler would have needed, and the error.

use std::f64::consts::PI;

use sph_integrate::{
    Decision, Error, ErrorWeight, Rkl2Coefficients, Rkl2Scratch, StepController, rkl2_step, stages_for,
    weighted_rms_error,
};

const CELLS: usize = 200;
/// The ring's largest eigenvalue is 4.
const DT_EULER_S: f64 = 0.5;
const END_S: f64 = 2000.0;

fn conduction(heat: &[f64], rate: &mut [f64]) {
    for i in 0..CELLS {
        rate[i] = heat[(i + CELLS - 1) % CELLS] - 2.0 * heat[i] + heat[(i + 1) % CELLS];
    }
}

/// Two waves with their exact decay on the ring.
fn exact(time_s: f64) -> Vec<f64> {
    let wave = |i: usize, k: f64| {
        let rate = 4.0 * (PI * k / CELLS as f64).sin().powi(2);
        (-rate * time_s).exp() * (2.0 * PI * k * i as f64 / CELLS as f64).cos()
    };
    (0..CELLS).map(|i| wave(i, 1.0) + wave(i, 12.0)).collect()
}

/// Runs to the end; returns accepted steps, rejected steps, evaluations and the largest error.
fn run(tolerance: f64) -> Result<(u32, u32, usize, f64), Error> {
    let weight = ErrorWeight { absolute: tolerance, relative: 0.0 };
    let mut controller = StepController::new(1.0, 5.0)?;
    let (mut heat, mut scratch) = (exact(0.0), Rkl2Scratch::new(CELLS));
    let mut rates = [vec![0.0; CELLS], vec![0.0; CELLS]];
    let (mut time_s, mut tau_s, mut accepted, mut rejected, mut evaluations) = (0.0, DT_EULER_S, 0, 0, 0);
    while time_s < END_S {
        let start = heat.clone();
        tau_s = f64::min(tau_s, END_S - time_s);
        let table = Rkl2Coefficients::new(stages_for(tau_s, DT_EULER_S))?;
        conduction(&start, &mut rates[0]);
        rkl2_step(&mut heat, tau_s, &table, conduction, &mut scratch);
        conduction(&heat, &mut rates[1]);
        evaluations += table.stage_count() + 1;
        let error = weighted_rms_error([&start, &heat], [&rates[0], &rates[1]], tau_s, weight);
        match controller.propose(tau_s, error) {
            Decision::Accept { next_s } => {
                (time_s, tau_s, accepted) = (time_s + tau_s, next_s, accepted + 1);
            }
            Decision::Reject { retry_s } => (heat, tau_s, rejected) = (start, retry_s, rejected + 1),
        }
    }
    let error = exact(END_S).iter().zip(&heat).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    Ok((accepted, rejected, evaluations, error))
}

fn main() -> Result<(), Error> {
    println!("explicit Euler would need {} evaluations", END_S / DT_EULER_S);
    println!("tolerance  accepted  rejected  evaluations  largest error");
    for tolerance in [1e-3, 1e-4, 1e-5, 1e-6] {
        let (accepted, rejected, evaluations, error) = run(tolerance)?;
        println!("{tolerance:9.0e} {accepted:9} {rejected:9} {evaluations:12} {error:14.2e}");
    }
    Ok(())
}
