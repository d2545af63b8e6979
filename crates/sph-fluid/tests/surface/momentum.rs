//! Momentum of a free body.

use crate::patch::find;
use sph_fluid::benchmarks::momentum::{pair_residual, tension_residual};

#[test]
fn pairs_keep_momentum_and_tension_loses_little() {
    let (pairs, _) = pair_residual(8, find).unwrap();
    let (tension, _) = tension_residual(8, find).unwrap();
    println!(
        "momentum, R/dx 8: pairs {pairs:.1e}, centre of mass under tension {tension:.1e} of the capillary speed"
    );
    assert!(pairs < 1e-13, "{pairs}");
    assert!(tension < 5e-3 && tension > 1e-9, "{tension}");
}
