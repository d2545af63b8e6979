//! A picture of elastic bodies: von Mises stress at the end, in the plane or in the middle plane of a scene in space.

use super::body::SolidBody;
use crate::fluid::{Cloud, section};
use crate::observe::Pictures;
use nalgebra::SVector;

/// Room around the bodies, in spacings.
const MARGIN: f64 = 4.0;

/// The von Mises stress.
pub fn stress_section<const D: usize>(body: &SolidBody<D>) -> Pictures {
    let (spacing, [low, high]) = (body.model().case.scene.spacing_m, body.bounds());
    let margin = SVector::<f64, D>::repeat(MARGIN * spacing);
    let columns = body.columns();
    let stress = columns.iter().find_map(|(name, column)| match column {
        crate::physics::Column::Scalar(values) if *name == "von_mises_pa" => Some(values),
        _ => None,
    });
    let cloud = Cloud {
        positions: body.positions(),
        kernel: &body.model().kernel,
        spacing,
        low: low - margin,
        size: high - low + margin * 2.0,
        time: body.time(),
    };
    let sections =
        stress.map(|stress| ("stress".to_string(), section(&cloud, "von Mises stress, Pa", stress)));
    Pictures { sections: sections.into_iter().collect() }
}
