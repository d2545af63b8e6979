//! Pictures of a fluid: speed and pressure in the plane, or in the middle plane of a scene in space.

use super::flow::FluidFlow;
use crate::observe::{Pictures, SectionGrid};
use nalgebra::SVector;
use sph_kernel::ScaledKernel;

/// Grid points to a spacing.
const FINENESS: f64 = 2.0;

/// A place belongs to the fluid where the kernel finds this share of a full neighbourhood.
const INSIDE: f64 = 0.25;

/// Particles that a section cuts through.
pub struct Cloud<'a, const D: usize> {
    /// Positions \[m\].
    pub positions: &'a [SVector<f64, D>],
    /// Kernel of the means.
    pub kernel: &'a ScaledKernel<D>,
    /// Distance of neighbouring particles \[m\].
    pub spacing: f64,
    /// Low corner of the picture \[m\].
    pub low: SVector<f64, D>,
    /// Size of the picture \[m\].
    pub size: SVector<f64, D>,
    /// Time, for the title \[s\].
    pub time: f64,
}

/// Speed and pressure, kernel means of the particles near each point of a grid over the domain; not a number outside the fluid.
pub fn sections<const D: usize>(flow: &FluidFlow<D>) -> Pictures {
    let speeds: Vec<f64> = flow.velocities().iter().map(SVector::norm).collect();
    let names = [("speed", "speed, m/s", speeds), ("pressure", "pressure, Pa", flow.pressures().to_vec())];
    let model = flow.model();
    let cloud = Cloud {
        positions: flow.positions(),
        kernel: &model.controls.kernel,
        spacing: model.spacing(),
        low: model.low,
        size: model.size,
        time: flow.time(),
    };
    let grids = names.map(|(stem, quantity, values)| (stem.to_string(), section(&cloud, quantity, &values)));
    Pictures { sections: grids.into() }
}

/// Kernel means of `values` near each point of a grid in the plane, or in the middle plane along x and z; not a number away from
/// the particles. `quantity` is what they are, with their unit.
pub fn section<const D: usize>(cloud: &Cloud<'_, D>, quantity: &'static str, values: &[f64]) -> SectionGrid {
    let (up, step) = (D - 1, cloud.spacing / FINENESS);
    let axis = |axis: usize| -> Vec<f64> {
        let count = (cloud.size[axis] / step).round() as usize;
        (0..=count).map(|k| cloud.low[axis] + k as f64 * step).collect()
    };
    let (x_m, y_m) = (axis(0), axis(up));
    let middle = cloud.low + cloud.size * 0.5;
    let (mut sums, mut weights) = (vec![0.0; x_m.len() * y_m.len()], vec![0.0; x_m.len() * y_m.len()]);
    let (kernel, reach) = (cloud.kernel, cloud.kernel.support_radius());
    let cell = cloud.spacing.powi(D as i32);
    let near = |nodes: &[f64], at: f64| {
        let first = nodes.partition_point(|&node| node < at - reach);
        first..nodes.partition_point(|&node| node <= at + reach)
    };
    for (position, value) in cloud.positions.iter().zip(values) {
        for row in near(&y_m, position[up]) {
            for column in near(&x_m, position[0]) {
                let mut point = middle;
                (point[0], point[up]) = (x_m[column], y_m[row]);
                let weight = cell * kernel.value((point - position).norm());
                sums[row * x_m.len() + column] += weight * value;
                weights[row * x_m.len() + column] += weight;
            }
        }
    }
    let mean = |(sum, weight): (&f64, &f64)| if *weight > INSIDE { sum / weight } else { f64::NAN };
    SectionGrid {
        title: format!("{}, t = {:.4e} s", quantity.split(',').next().unwrap_or_default(), cloud.time),
        x_label: "x",
        y_label: if D == 2 { "y" } else { "z" },
        x_m,
        y_m,
        quantity,
        value: sums.iter().zip(&weights).map(mean).collect(),
        levels: Vec::new(),
        levels_of: None,
    }
}
