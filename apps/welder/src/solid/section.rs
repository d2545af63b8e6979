//! Pictures of elastic bodies at the end, in the plane or in the middle plane of a scene in space: von Mises stress, largest principal
//! stress, displacement, and plastic strain where they yield.

use super::body::SolidBody;
use crate::fluid::{Cloud, section};
use crate::observe::Pictures;
use crate::physics::Column;
use nalgebra::SVector;

/// Room around the bodies, in spacings.
const MARGIN: f64 = 4.0;

/// The pictures, each with the name of its file.
pub fn body_sections<const D: usize>(body: &SolidBody<D>) -> Pictures {
    let (spacing, [low, high]) = (body.model().case.scene.spacing_m, body.bounds());
    let margin = SVector::<f64, D>::repeat(MARGIN * spacing);
    let cloud = Cloud {
        positions: body.positions(),
        kernel: &body.model().kernel,
        spacing,
        low: low - margin,
        size: high - low + margin * 2.0,
        time: body.time(),
    };
    let mut sections = Vec::new();
    for (name, column) in body.columns() {
        let (stem, quantity, values) = match (name, column) {
            ("von_mises_pa", Column::Scalar(all)) => ("stress", "von Mises stress, Pa", all),
            ("principal_stress_pa", Column::Triple(all)) => (
                "principal_stress",
                "largest principal stress, Pa",
                all.iter().map(|principal| principal[0]).collect(),
            ),
            ("displacement_m", Column::Vector(all)) => {
                ("displacement", "displacement, m", all.iter().map(SVector::norm).collect())
            }
            ("plastic_strain", Column::Scalar(all)) if body.model().material.yield_stress.is_some() => {
                ("plastic_strain", "plastic strain", all)
            }
            _ => continue,
        };
        sections.push((stem.to_string(), section(&cloud, quantity, &values)));
    }
    Pictures { sections }
}
