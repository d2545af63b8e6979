//! What warmth does to the density and the energy of a fluid.

use super::FluidControls;

impl<const D: usize> FluidControls<D> {
    /// rho_0/rho_ref(T) \[-\] at a temperature \[K\]; one where warmth does not expand the fluid.
    #[inline]
    #[must_use]
    pub fn stretch(&self, temperature: f64) -> f64 {
        self.thermal_expansion.map_or(1.0, |law| law.stretch(temperature))
    }

    /// Energy of compression \[J/kg\], s e(rho s) with s = rho_0/rho_ref(T) and e that of the equation of state. Its
    /// change with density is p/rho^2, so that motion gains what it loses; its change with temperature, near beta
    /// p/rho, is the work that expansion does against pressure.
    #[inline]
    #[must_use]
    pub fn compression(&self, density: f64, temperature: f64) -> f64 {
        let stretch = self.stretch(temperature);
        stretch * self.state.energy(density * stretch)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Tait, ThermalExpansion};
    use sph_kernel::KernelKind;

    #[test]
    fn energy_of_compression_changes_by_the_work_of_pressure() {
        let state = Tait::new(2400.0, 12.0, 7.0).unwrap();
        let controls = FluidControls::<2> {
            thermal_expansion: Some(ThermalExpansion::new(1.3e-4, 933.0).unwrap()),
            ..FluidControls::new(KernelKind::WendlandC2.with_smoothing_length(1.0), state)
        };
        let (density, temperature) = (2300.0, 1400.0);
        let pressure = state.pressure(density * controls.stretch(temperature));
        let slope = |step: f64| {
            controls.compression(density + step, temperature)
                - controls.compression(density - step, temperature)
        };
        assert!((slope(1e-2) / 2e-2 / (pressure / (density * density)) - 1.0).abs() < 1e-6);
        // d(s e(rho s))/dT = beta (s e + p/rho).
        let warmed = controls.compression(density, temperature + 0.1)
            - controls.compression(density, temperature - 0.1);
        let exact = 1.3e-4 * (controls.compression(density, temperature) + pressure / density);
        assert!((warmed / 0.2 / exact - 1.0).abs() < 1e-6, "{warmed} {exact}");
        assert_eq!(controls.compression(2400.0, 933.0), 0.0);
        let plain = FluidControls { thermal_expansion: None, ..controls };
        assert_eq!(plain.compression(density, temperature), state.energy(density));
    }
}
