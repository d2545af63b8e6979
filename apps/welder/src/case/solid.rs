//! A scene of elastic bodies: what its case file, `Solid( ... )`, may say.

use super::axes::Axes;
use super::fluid::Span;
use super::over_rise::OverRise;
use super::resolution::first_seed;
use super::scene::{Budget, Output, ResolvedOutput};
use serde::{Deserialize, Serialize};

/// The whole of a case file that begins with `Solid(`. Tuples have two numbers in the plane (plane strain) and three in space, as
/// the first corner or centre of the bodies has; the last axis points up. What a scene in the plane says in kilograms or joules is for
/// one metre of depth.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename = "Solid", deny_unknown_fields)]
pub struct SolidScene {
    /// What the case is, in words; for reports and pictures.
    #[serde(default)]
    pub title: String,
    /// What all bodies are made of.
    pub material: Elastic,
    /// The bodies at the start, without stress.
    pub bodies: Vec<Solid>,
    /// Boxes whose particles are held where they are, or moved. Default: none.
    #[serde(default)]
    pub held: Vec<Hold>,
    /// Acceleration of gravity in m/s2. Default: none.
    #[serde(default)]
    pub gravity_m_s2: Option<Axes>,
    /// Temperatures that the bodies are given. Default: they stay as they are.
    #[serde(default)]
    pub heating: Option<Heating>,
    /// Rate in 1/s at which velocities fade, for bodies that shall come to rest. Default: 0.
    #[serde(default)]
    pub damping_1_s: f64,
    /// Distance of neighbouring particles in metres.
    pub spacing_m: f64,
    /// Uniform random shift of each particle along each axis at the start, in spacings, 0 to 0.3. Default: 0.
    #[serde(default)]
    pub disorder: f64,
    /// Seed of the random shifts. Default: 1.
    #[serde(default = "first_seed")]
    pub seed: u64,
    /// How the bodies are computed.
    #[serde(default)]
    pub scheme: SolidScheme,
    /// How long the run lasts.
    pub time: Span,
    /// What the run writes.
    #[serde(default)]
    pub output: Output,
    /// What the run may cost.
    #[serde(default)]
    pub budget: Budget,
}

/// An elastic material, or one that yields without hardening. What depends on temperature may be a table over its rise,
/// `[(rise_k, value), ...]`: straight lines between, constant beyond the ends.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Elastic {
    /// Density without stress in kg/m3.
    pub density_kg_m3: f64,
    /// Young's modulus in Pa.
    pub young_pa: f64,
    /// Poisson's ratio.
    pub poisson: f64,
    /// Linear expansion in 1/K, d ln(length)/dT; a number or a table. Default: 0.
    #[serde(default)]
    pub expansion_1_k: OverRise,
    /// Von Mises stress in Pa at which it yields; a number or a table. Default: never.
    #[serde(default)]
    pub yield_pa: Option<OverRise>,
}

/// Temperatures over time, above that of the start. They belong to the material and move with it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Heating {
    /// Rises at times, those of a spot at its centre: straight lines from zero at the start to the first node and from node to
    /// node, constant after the last.
    pub nodes: Vec<HeatingNode>,
    /// Where it is hot. Default: everywhere alike.
    #[serde(default)]
    pub spot: Option<HotSpot>,
}

/// A node of the rise of temperature over time.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HeatingNode {
    /// Time in seconds.
    pub time_s: f64,
    /// Temperature above that of the start in kelvin; below zero it cools.
    pub rise_k: f64,
}

/// A rise that falls with the distance r from a centre as exp(-r^2/radius_m^2).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HotSpot {
    /// Its centre in metres.
    pub centre_m: Axes,
    /// The distance in metres at which 1/e of the rise is left.
    pub radius_m: f64,
}

impl Heating {
    /// Rise of temperature in kelvin at a time in seconds.
    pub fn rise_k(&self, time_s: f64) -> f64 {
        let mut before = HeatingNode { time_s: 0.0, rise_k: 0.0 };
        for node in &self.nodes {
            if time_s < node.time_s {
                let share = (time_s - before.time_s) / (node.time_s - before.time_s);
                return before.rise_k + share * (node.rise_k - before.rise_k);
            }
            before = *node;
        }
        before.rise_k
    }
}

/// A body at the start, all of it moving alike.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Solid {
    /// A box of cells.
    Block {
        /// Low corner in metres.
        low_m: Axes,
        /// High corner in metres, a whole number of spacings from the low one.
        high_m: Axes,
        /// Velocity in m/s. Default: at rest.
        #[serde(default)]
        velocity_m_s: Option<Axes>,
    },
    /// A ring in the plane, a hollow ball in space, cut out of a lattice about its centre.
    Ring {
        /// Centre in metres.
        centre_m: Axes,
        /// Inner radius in metres; zero makes a disc or a ball. Default: 0.
        #[serde(default)]
        inner_radius_m: f64,
        /// Outer radius in metres.
        outer_radius_m: f64,
        /// Velocity in m/s. Default: at rest.
        #[serde(default)]
        velocity_m_s: Option<Axes>,
    },
}

impl Solid {
    /// Its velocity, when it has one.
    pub fn velocity_m_s(&self) -> Option<&Axes> {
        match self {
            Solid::Block { velocity_m_s, .. } | Solid::Ring { velocity_m_s, .. } => velocity_m_s.as_ref(),
        }
    }
}

/// A box whose particles are held: those that start in it stay, or move as they are told, whatever pulls at them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Hold {
    /// Low corner in metres.
    pub low_m: Axes,
    /// High corner in metres.
    pub high_m: Axes,
    /// Velocity in m/s, the same at all times. Default: at rest.
    #[serde(default)]
    pub velocity_m_s: Option<Axes>,
}

/// How bodies are computed.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct SolidScheme {
    /// How gradients and forces are formed. Default: Total.
    pub form: Form,
    /// Smoothing length over spacing. Default: 0.8 in the total-Lagrangian form, else 1.2.
    pub smoothing_ratio: Option<f64>,
    /// Artificial stress epsilon, which keeps stretched bodies whole in the updated-Lagrangian forms. Default: 0.3 in the
    /// paper's form, 0 in the corrected one.
    pub artificial_stress: Option<f64>,
}

/// How gradients and forces are formed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Form {
    /// Total Lagrangian: pairs and gradients of the start, and contact where bodies meet. They never break.
    #[default]
    Total,
    /// Updated Lagrangian as in Hu and Eberhard (2015), with artificial stress and viscosity.
    Paper,
    /// Updated Lagrangian with corrected gradients, a force that keeps energy, and viscosity on zero-energy modes.
    Corrected,
}

/// The columns that a frame of a solid can hold.
pub const SOLID_FIELDS: &[&str] = &[
    "velocity_m_s",
    "displacement_m",
    "von_mises_pa",
    "principal_stress_pa",
    "pressure_pa",
    "plastic_strain",
    "temperature_rise_k",
    "density_kg_m3",
    "body",
];

impl SolidScene {
    /// Number of dimensions, 2 or 3: that of the first body.
    pub fn dimension(&self) -> usize {
        match self.bodies.first() {
            Some(Solid::Block { low_m, .. }) => low_m.values().len(),
            Some(Solid::Ring { centre_m, .. }) => centre_m.values().len(),
            None => 2,
        }
    }

    /// What the run writes, the defaults filled in: all columns that change.
    pub fn output(&self) -> ResolvedOutput {
        let changes = |field: &&str| match *field {
            "plastic_strain" => self.material.yield_pa.is_some(),
            "temperature_rise_k" => self.heating.is_some(),
            _ => true,
        };
        let fields = || SOLID_FIELDS.iter().copied().filter(changes).map(String::from).collect();
        self.output.resolved(self.time.end_s, fields)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn temperatures_go_in_straight_lines() {
        let node = |time_s, rise_k| HeatingNode { time_s, rise_k };
        let heating = Heating { nodes: vec![node(2.0, 100.0), node(3.0, -20.0)], spot: None };
        let rises = [0.0, 1.0, 2.0, 2.5, 3.0, 9.0].map(|time| heating.rise_k(time));
        assert_eq!(rises, [0.0, 50.0, 100.0, 40.0, -20.0, -20.0]);
    }
}
