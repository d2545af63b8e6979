//! Ranges in which a value is plausible, and which other unit a value outside was probably meant in.

/// A range of plausible values and the units that values are mistaken in.
#[derive(Debug, Clone, Copy)]
pub struct Range {
    /// The unit of the value, as it stands in the field's name.
    pub unit: &'static str,
    /// Least plausible value.
    pub low: f64,
    /// Greatest plausible value.
    pub high: f64,
    /// Whether exactly zero is accepted too.
    pub or_zero: bool,
    /// Other units: name, factor, offset; value * factor + offset is in `unit`.
    pub others: &'static [(&'static str, f64, f64)],
}

const LENGTHS: &[(&str, f64, f64)] = &[("um", 1e-6, 0.0), ("mm", 1e-3, 0.0)];
const TIMES: &[(&str, f64, f64)] = &[("ms", 1e-3, 0.0), ("us", 1e-6, 0.0)];
const CELSIUS: &[(&str, f64, f64)] = &[("degrees Celsius", 1.0, 273.15)];
const PERCENT: &[(&str, f64, f64)] = &[("per cent", 0.01, 0.0)];

const fn range(
    unit: &'static str,
    low: f64,
    high: f64,
    others: &'static [(&'static str, f64, f64)],
) -> Range {
    Range { unit, low, high, or_zero: false, others }
}

/// Length of a part along one axis.
pub const PART_LENGTH: Range = range("m", 1e-5, 1.0, LENGTHS);
/// A coordinate.
pub const COORDINATE: Range = range("m", -1.0, 1.0, LENGTHS);
/// Distance of particles.
pub const SPACING: Range = range("m", 1e-6, 1e-2, LENGTHS);
/// Radius of a beam.
pub const BEAM_RADIUS: Range = range("m", 2e-6, 5e-2, LENGTHS);
/// Temperature of a part or its surroundings; 50 K so that 20 or 25 are seen as Celsius.
pub const TEMPERATURE: Range = range("K", 50.0, 6000.0, CELSIUS);
/// Temperature of melting.
pub const MELTING: Range = range("K", 150.0, 4500.0, CELSIUS);
/// Temperature of boiling.
pub const BOILING: Range = range("K", 300.0, 7000.0, CELSIUS);
/// Heat of evaporation of a metal.
pub const EVAPORATION_HEAT: Range = range("J/kg", 2e5, 5e7, &[("kJ/kg or J/g", 1e3, 0.0)]);
/// Molar mass of a metal's vapour.
pub const MOLAR_MASS: Range = range("kg/mol", 0.005, 0.3, &[("g/mol", 1e-3, 0.0)]);
/// Temperatures in a table of a material.
pub const TABLE_TEMPERATURE: Range = range("K", 0.0, 10000.0, CELSIUS);
/// Power of a laser.
pub const POWER: Range = range("W", 10.0, 1e5, &[("kW", 1e3, 0.0), ("mW", 1e-3, 0.0)]);
/// Power at one time of a table; it may be zero.
pub const POWER_AT_A_TIME: Range = Range { or_zero: true, ..POWER };
/// Speed of a beam.
pub const SPEED: Range =
    range("m/s", 1e-4, 20.0, &[("mm/s", 1e-3, 0.0), ("m/min", 1.0 / 60.0, 0.0), ("mm/min", 1.0 / 6e4, 0.0)]);
/// A span of time.
pub const DURATION: Range = range("s", 1e-8, 1e4, TIMES);
/// Share of the light that is absorbed, and emissivity.
pub const SHARE: Range = range("", 0.0, 1.0, PERCENT);
/// Absorption coefficient of light.
pub const ABSORPTION_COEFFICIENT: Range = range("1/m", 10.0, 1e9, &[("1/mm", 1e3, 0.0), ("1/um", 1e6, 0.0)]);
/// Heat flux.
pub const FLUX: Range = range("W/m2", -1e12, 1e12, &[]);
/// Heat transfer coefficient.
pub const CONVECTION: Range = range("W/(m2 K)", 0.0, 1e6, &[]);
/// Density of a metal.
pub const DENSITY: Range = range("kg/m3", 500.0, 23000.0, &[("g/cm3", 1e3, 0.0)]);
/// Specific heat capacity of a metal.
pub const HEAT_CAPACITY: Range =
    range("J/(kg K)", 80.0, 10000.0, &[("J/(g K)", 1e3, 0.0), ("cal/(g K)", 4184.0, 0.0)]);
/// Thermal conductivity of a metal.
pub const CONDUCTIVITY: Range =
    range("W/(m K)", 1.0, 3000.0, &[("W/(mm K)", 1e3, 0.0), ("W/(cm K)", 100.0, 0.0)]);
/// Dynamic viscosity of a melt.
pub const VISCOSITY: Range = range("Pa s", 1e-4, 1.0, &[("mPa s", 1e-3, 0.0)]);
/// Surface tension of a melt.
pub const TENSION: Range = range("N/m", 0.01, 5.0, &[("mN/m", 1e-3, 0.0)]);
/// Change of surface tension with temperature.
pub const TENSION_SLOPE: Range =
    Range { or_zero: true, ..range("N/(m K)", -5e-3, 5e-3, &[("mN/(m K)", 1e-3, 0.0)]) };
/// Artificial speed of sound in a melt.
pub const MELT_SOUND: Range = range("m/s", 0.1, 1e4, &[("km/s", 1e3, 0.0)]);
/// How many times as viscous a melt is made.
pub const VISCOSITY_FACTOR: Range = range("", 1.0, 1e4, &[]);
/// Artificial viscosity of a melt.
pub const ARTIFICIAL_VISCOSITY: Range = Range { or_zero: true, ..range("", 1e-4, 1.0, &[]) };
/// A length in a scene of fluid.
pub const FLUID_LENGTH: Range = range("m", 1e-6, 1e3, LENGTHS);
/// A coordinate in a scene of fluid.
pub const FLUID_PLACE: Range = range("m", -1e3, 1e3, LENGTHS);
/// Distance of particles of a fluid.
pub const FLUID_SPACING: Range = range("m", 1e-7, 10.0, LENGTHS);
/// Density of any liquid, and of model liquids.
pub const LIQUID_DENSITY: Range = range("kg/m3", 0.1, 23000.0, &[]);
/// Dynamic viscosity of any liquid.
pub const LIQUID_VISCOSITY: Range = Range { or_zero: true, ..range("Pa s", 1e-6, 1e5, &[]) };
/// Surface tension of any liquid, and of model liquids.
pub const LIQUID_TENSION: Range = Range { or_zero: true, ..range("N/m", 1e-6, 10.0, &[("mN/m", 1e-3, 0.0)]) };
/// Change of surface tension of any liquid with temperature.
pub const LIQUID_TENSION_SLOPE: Range = range("N/(m K)", -1.0, 1.0, &[]);
/// Expansion of any liquid by volume, and of model liquids.
pub const LIQUID_EXPANSION: Range =
    Range { or_zero: true, ..range("1/K", 1e-6, 1.0, &[("1e-6/K", 1e-6, 0.0)]) };
/// A component of a velocity.
pub const VELOCITY: Range = range("m/s", -1e4, 1e4, &[]);
/// Angular speed of a body of fluid.
pub const SPIN: Range = range("rad/s", -1e6, 1e6, &[]);
/// A component of the acceleration of gravity.
pub const GRAVITY: Range = range("m/s2", -1e5, 1e5, &[]);
/// Artificial speed of sound in a liquid.
pub const LIQUID_SOUND: Range = range("m/s", 1e-6, 1e5, &[("km/s", 1e3, 0.0)]);
/// Temperature of a fluid.
pub const FLUID_TEMPERATURE: Range = range("K", 1.0, 1e4, &[]);
/// Slope of a temperature in space.
pub const TEMPERATURE_SLOPE: Range = range("K/m", -1e9, 1e9, &[]);
/// Smoothing length of a fluid over spacing.
pub const FLUID_SMOOTHING: Range = range("", 1.2, 3.0, &[]);
/// Density diffusion of a fluid.
pub const DENSITY_DIFFUSION: Range = Range { or_zero: true, ..range("", 1e-3, 0.5, &[]) };
/// Strength of the shifting of particles.
pub const SHIFTING: Range = Range { or_zero: true, ..range("", 0.1, 20.0, &[]) };
/// Rate of the pull of densities towards the particles.
pub const DENSITY_PULL: Range = Range { or_zero: true, ..range("", 1e-5, 0.1, &[]) };
/// Young's modulus of any elastic body.
pub const SOLID_YOUNG: Range = range("Pa", 1.0, 1e13, &[("GPa", 1e9, 0.0), ("MPa", 1e6, 0.0)]);
/// Radius of a hole.
pub const RADIUS: Range = Range { or_zero: true, ..range("m", 1e-6, 1e3, LENGTHS) };
/// Artificial stress of an elastic body.
pub const ARTIFICIAL_STRESS: Range = Range { or_zero: true, ..range("", 1e-3, 1.0, &[]) };
/// Linear expansion of a body of a scene of solids, rubber included.
pub const BODY_EXPANSION: Range =
    Range { or_zero: true, ..range("1/K", 1e-8, 1e-2, &[("1e-6/K", 1e-6, 0.0)]) };
/// Yield stress of such a body; zero where it has melted.
pub const BODY_YIELD: Range =
    Range { or_zero: true, ..range("Pa", 1.0, 1e12, &[("GPa", 1e9, 0.0), ("MPa", 1e6, 0.0)]) };
/// Rate at which its velocities fade.
pub const DAMPING: Range = Range { or_zero: true, ..range("1/s", 1e-6, 1e12, &[]) };
/// Temperature above that of the start.
pub const RISE: Range = range("K", -1e4, 1e4, &[]);
/// Young's modulus of a metal.
pub const YOUNG: Range = range("Pa", 1e8, 1e12, &[("GPa", 1e9, 0.0), ("MPa", 1e6, 0.0)]);
/// Poisson's ratio of a metal.
pub const POISSON: Range = range("", 0.0, 0.495, PERCENT);
/// Coefficient of linear thermal expansion.
pub const EXPANSION: Range = Range { or_zero: true, ..range("1/K", 1e-7, 2e-4, &[("1e-6/K", 1e-6, 0.0)]) };
/// Expansion of a molten metal by volume.
pub const MELT_EXPANSION: Range =
    Range { or_zero: true, ..range("1/K", 1e-6, 1e-3, &[("1e-6/K", 1e-6, 0.0)]) };
/// Yield stress of a metal; zero where it has melted.
pub const YIELD: Range =
    Range { or_zero: true, ..range("Pa", 1e5, 1e10, &[("MPa", 1e6, 0.0), ("GPa", 1e9, 0.0)]) };
/// Crossings of the part by a wave in one step of heat.
pub const CROSSINGS: Range = range("", 0.01, 1e3, &[]);
/// Latent heat of fusion of a metal; zero leaves melting without heat.
pub const LATENT_HEAT: Range =
    Range { or_zero: true, ..range("J/kg", 5e3, 5e6, &[("kJ/kg or J/g", 1e3, 0.0)]) };
/// Random shift of particles.
pub const DISORDER: Range = range("spacings", 0.0, 0.3, PERCENT);
/// Smoothing length over spacing.
pub const SMOOTHING_RATIO: Range = range("", 0.5, 3.0, &[]);
/// Temperature error of one step.
pub const TOLERANCE: Range = range("of the heat taken up", 1e-9, 10.0, &[]);
/// Part of the largest stable step.
pub const STEP_FACTOR: Range = range("", 1e-3, 1.0, PERCENT);

impl Range {
    /// Why the value is refused and what to write instead; `None` when it is plausible.
    pub fn refuse(&self, value: f64) -> Option<(String, String)> {
        if (self.low..=self.high).contains(&value) || (self.or_zero && value == 0.0) {
            return None;
        }
        let reason = if !value.is_finite() {
            "not a finite number".to_string()
        } else if value == 0.0 {
            "must not be zero".to_string()
        } else if value < 0.0 && self.low >= 0.0 && self.meant(value).is_empty() {
            "must not be negative".to_string()
        } else {
            format!("{} {} is not plausible", number(value), self.unit).replace("  ", " ")
        };
        Some((reason, format!("{}accepted: {}", self.meant(value), self.accepted())))
    }

    fn accepted(&self) -> String {
        let zero = if self.or_zero { "0, or " } else { "" };
        format!("{zero}{} to {} {}", number(self.low), number(self.high), self.unit).trim_end().to_string()
    }

    /// The units in which the value would be plausible, and the value in the field's own unit.
    fn meant(&self, value: f64) -> String {
        let converted = self.others.iter().map(|(unit, factor, offset)| (unit, value * factor + offset));
        let guesses: Vec<String> = converted
            .filter(|(_, meant)| value != 0.0 && (self.low..=self.high).contains(meant))
            .map(|(unit, meant)| format!("{unit} (then write {})", number(meant)))
            .collect();
        if guesses.is_empty() {
            String::new()
        } else {
            format!("was it meant in {}? ", guesses.join(" or in "))
        }
    }
}

/// A number for people: six digits, powers of ten where they help.
pub fn number(value: f64) -> String {
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    let plain = rounded == 0.0 || (1e-2..1e5).contains(&rounded.abs()) || !rounded.is_finite();
    if plain { format!("{rounded}") } else { format!("{rounded:e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn assert_hint(range: Range, value: f64, hint: &str) {
        let (_, remedy) = range.refuse(value).expect("refused");
        assert!(remedy.contains(hint), "{remedy}");
    }

    #[test]
    fn values_in_other_units_are_recognised() {
        assert_hint(SPACING, 50.0, "um (then write 5e-5)");
        assert_hint(SPACING, 0.05, "mm (then write 5e-5)");
        assert_hint(PART_LENGTH, 6.0, "mm (then write 6e-3)");
        assert_hint(POWER, 0.5, "kW (then write 500)");
        assert_hint(DENSITY, 2.7, "g/cm3 (then write 2700)");
        assert_hint(TEMPERATURE, 20.0, "degrees Celsius (then write 293.15)");
        assert_hint(TEMPERATURE, -20.0, "degrees Celsius (then write 253.15)");
        assert_hint(CONDUCTIVITY, 0.2, "W/(mm K) (then write 200)");
        assert_hint(SPEED, 1000.0, "mm/min (then write 0.0166667)");
        assert_hint(SHARE, 35.0, "per cent (then write 0.35)");
    }

    #[test]
    fn reasons_tell_signs_from_sizes() {
        let reason = |range: Range, value: f64| range.refuse(value).unwrap().0;
        assert_eq!(reason(DENSITY, f64::NAN), "not a finite number");
        assert_eq!(reason(DENSITY, f64::INFINITY), "not a finite number");
        assert_eq!(reason(DENSITY, -2700.0), "must not be negative");
        assert_eq!(reason(DENSITY, 0.0), "must not be zero");
        assert_eq!(reason(DENSITY, 2.7), "2.7 kg/m3 is not plausible");
    }

    #[test]
    fn plausible_values_pass() {
        for (range, value) in
            [(LATENT_HEAT, 0.0), (LATENT_HEAT, 3.97e5), (SHARE, 0.0), (SHARE, 1.0), (COORDINATE, 0.0)]
        {
            assert!(range.refuse(value).is_none());
        }
    }
}
