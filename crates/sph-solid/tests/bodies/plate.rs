//! The swinging plate, held in two ways and in three forms.

use crate::find::find;
use sph_kernel::KernelKind;
use sph_solid::UpdatedControls;
use sph_solid::benchmarks::plate::{
    BETWEEN_STRIPS, TIMOSHENKO, amplitude_after, between_strips, clamped, updated,
};

#[test]
fn plate_swings_with_the_period_of_timoshenkos_beam() {
    for (cells, mark) in [(5, 0.058), (10, 0.0195)] {
        let swing = clamped(cells, find).unwrap();
        let (ratio, energy) = (swing.period / TIMOSHENKO, swing.energy);
        println!("plate, {cells} across: period {ratio:.4} of Timoshenko's, energy {energy:.1e}");
        assert!((ratio - 1.0).abs() < mark, "{ratio} at {cells}");
        assert!(energy.abs() < 1e-4, "{energy} at {cells}");
    }
}

#[test]
fn ten_periods_leave_the_amplitude() {
    let (kept, _) = amplitude_after(10, 4, find).unwrap();
    println!("plate, 4 across: amplitude {kept:.3} after ten periods");
    assert!((0.8..1.2).contains(&kept), "{kept}");
}

#[test]
fn plate_between_strips_swings_as_finite_elements_say() {
    let swing = between_strips(10, find).unwrap();
    let (period, energy) = (swing.period, swing.energy);
    println!("plate between strips, 10 across: period {period:.4} s, energy {energy:.1e}");
    assert!((period / BETWEEN_STRIPS - 1.0).abs() < 0.03, "{period}");
    assert!(energy.abs() < 1e-4, "{energy}");
}

#[test]
fn the_corrected_plate_is_nearer_to_timoshenkos_than_the_papers() {
    let spacing = 0.02 / 5.0;
    let kernel = KernelKind::Gaussian.with_smoothing_length(1.2 * spacing);
    let corrected = updated(UpdatedControls::corrected(kernel, spacing), find).unwrap();
    let paper = updated(UpdatedControls::paper(kernel, spacing), find).unwrap();
    let [near, far] = [corrected.period / TIMOSHENKO, paper.period / TIMOSHENKO];
    println!(
        "plate, 5 across: corrected {near:.3} (energy {:.1e}), paper {far:.3} of Timoshenko's",
        corrected.energy
    );
    // The trial's 1.275 and 1.427.
    assert!((near - 1.275).abs() < 0.02, "{near}");
    assert!((far - 1.427).abs() < 0.02, "{far}");
    assert!(corrected.energy.abs() < 0.05, "{}", corrected.energy);
}
