//! The continuous enthalpy curve beside that of Hu and Eberhard (2015, eqs. 20-21), and how far theirs jumps.
//!
//! `cargo run -p sph-thermal --example enthalpy_curves`

use sph_thermal::Error;
use sph_thermal::phase::{EnthalpyCurve, Table, ThermalMaterial};

fn main() -> Result<(), Error> {
    // The constants of this project's reference solutions, near those of an aluminium alloy.
    let material = ThermalMaterial {
        density: 2500.0,
        solidus: 847.0,
        liquidus: 905.0,
        latent_heat: 3.97e5,
        heat_capacity_solid: Table::constant(1050.0)?,
        heat_capacity_liquid: Table::constant(1180.0)?,
        conductivity_solid: Table::constant(200.0)?,
        conductivity_liquid: Table::constant(95.0)?,
    };
    let ours = EnthalpyCurve::continuous(&material)?;
    let papers = EnthalpyCurve::hu_eberhard_2015(&material)?;

    println!("enthalpy kJ/kg   continuous K   eqs. 20-21 K");
    let solidus = ours.enthalpy_solidus();
    for enthalpy in
        [0.5e6, solidus - 1.0, solidus + 1.0, 1.0e6, 1.2e6, ours.enthalpy_liquidus(), 1.6e6, 2.0e6]
    {
        let (own, other) = (ours.temperature(enthalpy), papers.temperature(enthalpy));
        println!("{:14.1} {own:14.2} {other:14.2}", 1e-3 * enthalpy);
    }
    let jump = papers.temperature_jump().expect("the paper's curve says how far it jumps");
    println!(
        "eqs. 20-21 jump by {:.2} K at the solidus, and take up {:.1} % of the latent heat too much up to the liquidus",
        jump.at_solidus_k,
        100.0 * jump.excess_latent_heat
    );
    Ok(())
}
