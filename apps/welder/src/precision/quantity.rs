//! The quantities that a ladder looks at, and how far a run is off in each.

use serde::Serialize;

/// Sizes that a run found.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub(crate) struct Sizes {
    pub(crate) width_m: f64,
    pub(crate) depth_m: f64,
    pub(crate) length_m: f64,
    pub(crate) peak_temperature_k: f64,
    /// Peak temperature over the start: errors of temperature are relative to it.
    pub(crate) peak_rise_k: f64,
    pub(crate) weld_volume_m3: f64,
    pub(crate) solidified_at_s: Option<f64>,
}

/// Relative differences to the reference; no number where the reference is zero.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub(crate) struct Errors {
    pub(crate) width_error: f64,
    pub(crate) depth_error: f64,
    pub(crate) length_error: f64,
    pub(crate) peak_error: f64,
    pub(crate) weld_error: f64,
}

impl Errors {
    /// How far `found` is off.
    pub(crate) fn against(found: &Sizes, reference: &Sizes) -> Self {
        let of = |quantity: &Quantity| {
            let (found, exact) = ((quantity.of)(found), (quantity.of)(reference));
            if exact == 0.0 { f64::NAN } else { found / exact - 1.0 }
        };
        let [width_error, depth_error, length_error, peak_error, weld_error] = QUANTITIES.map(|q| of(&q));
        Self { width_error, depth_error, length_error, peak_error, weld_error }
    }
}

/// One quantity: its name, how it is shown, and where it stands.
#[derive(Clone, Copy)]
pub(super) struct Quantity {
    pub(super) name: &'static str,
    pub(super) unit: &'static str,
    /// Units over SI units.
    pub(super) scale: f64,
    pub(super) of: fn(&Sizes) -> f64,
    pub(super) error: fn(&Errors) -> f64,
}

/// All of them: the largest extents of the pool at the liquidus, the peak temperature, and the volume of the weld.
pub(super) const QUANTITIES: [Quantity; 5] = [
    Quantity { name: "width", unit: "um", scale: 1e6, of: |s| s.width_m, error: |e| e.width_error },
    Quantity { name: "depth", unit: "um", scale: 1e6, of: |s| s.depth_m, error: |e| e.depth_error },
    Quantity { name: "length", unit: "um", scale: 1e6, of: |s| s.length_m, error: |e| e.length_error },
    Quantity { name: "peak", unit: "K rise", scale: 1.0, of: |s| s.peak_rise_k, error: |e| e.peak_error },
    Quantity { name: "weld", unit: "mm3", scale: 1e9, of: |s| s.weld_volume_m3, error: |e| e.weld_error },
];
