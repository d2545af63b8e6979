//! A round drop at rest and one that swings: pressure over tau/R, largest speed, period over Rayleigh's.
//!
//! `cargo run --release -p sph-fluid --example drop -- 20` takes 20 spacings to the radius (10 without an argument).

#[allow(dead_code, reason = "the tests of this module use more of it")]
#[path = "../tests/surface/drop.rs"]
mod drop;
#[allow(dead_code, reason = "the tests of this module use more of it")]
#[path = "../tests/surface/patch.rs"]
mod patch;
#[allow(dead_code, reason = "the tests of this module use more of it")]
#[path = "../tests/surface/shapes.rs"]
mod shapes;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let across: usize = std::env::args().nth(1).map_or(Ok(10), |text| text.parse())?;
    if across < 6 {
        return Err("a drop needs 6 spacings to its radius, so that its kernel fits in".into());
    }
    let (pressure, speed) = drop::at_rest(across, 2.0);
    println!("at rest: p/(tau/R) {pressure:.4}, largest speed {speed:.1e} sqrt(tau/(rho R))");
    println!("swinging: period over Rayleigh's {:.4}", drop::period(across));
    Ok(())
}
