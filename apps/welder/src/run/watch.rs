//! From the simulation of a weld to what its observers see.

use super::{Simulation, StepReport};
use crate::measure::Map;
use crate::observe::{HistoryRow, Pictures, SectionGrid};
use crate::particles::{LIQUID, MUSHY, SOLID};
use crate::physics::Column;

/// Every column that can be shown.
pub(super) fn columns(simulation: &Simulation) -> Vec<(&'static str, Column<3>)> {
    let (model, particles) = (simulation.model(), simulation.particles());
    let curve = |i: usize| &model.curves[particles.material[i] as usize];
    let all = 0..particles.len();
    let temperatures =
        |enthalpies: &[f64]| all.clone().map(|i| curve(i).temperature(enthalpies[i])).collect();
    let fractions: Vec<f64> = all.clone().map(|i| curve(i).liquid_fraction(particles.enthalpy[i])).collect();
    let phase = |fraction: &f64| match *fraction {
        f if f <= 0.0 => SOLID,
        f if f < 1.0 => MUSHY,
        _ => LIQUID,
    };
    let molten = |i: usize| u8::from(curve(i).liquid_fraction(particles.peak_enthalpy[i]) >= 1.0);
    let mut columns = vec![
        ("temperature_k", Column::Scalar(temperatures(&particles.enthalpy))),
        ("peak_temperature_k", Column::Scalar(temperatures(&particles.peak_enthalpy))),
        ("phase", Column::Byte(fractions.iter().map(phase).collect())),
        ("liquid_fraction", Column::Scalar(fractions)),
        ("was_molten", Column::Byte(all.clone().map(molten).collect())),
        ("enthalpy_j_kg", Column::Scalar(particles.enthalpy.clone())),
        ("spacing_m", Column::Scalar(particles.spacing.clone())),
        ("material", Column::Byte(particles.material.clone())),
    ];
    columns.extend(simulation.columns());
    columns
}

/// The row of the history.
pub(super) fn measures(simulation: &Simulation, last: &StepReport) -> HistoryRow {
    let (now, ledger) = (&simulation.records().now, simulation.ledger());
    let mechanics = simulation.mechanics();
    let stress = mechanics.filter(|_| simulation.model().stress.is_some());
    let principal =
        |which: usize| stress.and_then(|mechanics| mechanics.principal_stresses).map(|both| both[which]);
    HistoryRow {
        time_s: simulation.time(),
        step: simulation.steps(),
        dt_s: last.step,
        dt_limit: last.limit.to_string(),
        peak_temperature_k: now.peak_temperature,
        pool_width_m: now.liquidus.width,
        pool_length_m: now.liquidus.length,
        pool_depth_m: now.liquidus.depth,
        melt_volume_m3: now.melt_volume,
        max_speed_m_s: mechanics.map_or(0.0, |mechanics| mechanics.largest_speed),
        energy_in_j: ledger.absorbed,
        energy_stored_j: ledger.sensible + ledger.latent,
        energy_lost_j: ledger.lost,
        energy_residual_rel: ledger.residual,
        max_von_mises_pa: stress.map(|mechanics| mechanics.largest_von_mises),
        max_principal_stress_pa: principal(0),
        min_principal_stress_pa: principal(1),
        max_displacement_m: stress.map(|mechanics| mechanics.largest_displacement),
        max_plastic_strain: stress.map(|mechanics| mechanics.largest_plastic_strain),
    }
}

/// Sections through the beam (or the middle), of the finest grid: of temperature with the top face, of speed and Marangoni
/// force where melt flows, and of stress where it is computed.
pub(super) fn pictures(simulation: &Simulation) -> Pictures {
    let mut sections = temperatures(simulation);
    sections.extend(flows(simulation));
    sections.extend(stresses(simulation, "stress"));
    Pictures { sections }
}

/// The stress that is left at the end, where it is computed.
pub(super) fn last_pictures(simulation: &Simulation) -> Pictures {
    Pictures { sections: stresses(simulation, "residual_stress") }
}

/// What stress has done by now, where it is computed: sections of the largest principal stress, displacement and plastic strain.
pub(super) fn deformations(simulation: &Simulation) -> Vec<(String, SectionGrid)> {
    let mut sections = Vec::new();
    for (name, column) in simulation.columns() {
        let (stem, quantity, field) = match (name, column) {
            ("principal_stress_pa", Column::Triple(all)) => (
                "principal_stress",
                "largest principal stress, Pa",
                all.iter().map(|principal| principal[0]).collect(),
            ),
            ("displacement_m", Column::Vector(all)) => (
                "displacement",
                "displacement, m",
                all.iter().map(|displacement| displacement.norm()).collect(),
            ),
            ("plastic_strain", Column::Scalar(all)) => ("plastic_strain", "plastic strain", all),
            _ => continue,
        };
        sections.extend(sections_of(simulation, &field, stem, quantity));
    }
    sections
}

/// Where sections cut \[m\]: through the beam, or the middle.
fn cut(simulation: &Simulation) -> [f64; 2] {
    let model = simulation.model();
    let (low, high) = model.bounds();
    let middle = [0, 1].map(|axis| 0.5 * (low[axis] + high[axis]));
    model.laser.as_ref().map_or(middle, |laser| {
        let lit = laser.track().end_time();
        laser.track().position(simulation.time().min(lit))
    })
}

/// Sections of the von Mises stress, for files whose names begin with `stem`.
fn stresses(simulation: &Simulation, stem: &str) -> Vec<(String, SectionGrid)> {
    let columns = simulation.columns();
    let stress = columns.iter().find(|(name, _)| *name == "von_mises_pa");
    let Some((_, Column::Scalar(stress))) = stress else { return Vec::new() };
    sections_of(simulation, stress, stem, "von Mises stress, Pa")
}

/// Sections of a field along x and along y, for files whose names begin with `stem`.
fn sections_of(
    simulation: &Simulation,
    field: &[f64],
    stem: &str,
    quantity: &'static str,
) -> Vec<(String, SectionGrid)> {
    let place = cut(simulation);
    let when = format!("t = {:.3} ms", 1e3 * simulation.time());
    let section = |(along, x_label): (usize, &'static str)| {
        let map = simulation.gauge().section_of(field, 1 - along, place[1 - along]);
        let grid = SectionGrid {
            title: format!("Section along {x_label}, {when}"),
            x_label,
            y_label: "z",
            x_m: map.x,
            y_m: map.y,
            quantity,
            value: map.value,
            levels: Vec::new(),
            levels_of: None,
        };
        (format!("{stem}_{x_label}"), grid)
    };
    [(0, "x"), (1, "y")].map(section).to_vec()
}

/// Speed of the melt in sections and from above, and the components of the Marangoni force on it from above, with the outline of the
/// pool.
fn flows(simulation: &Simulation) -> Vec<(String, SectionGrid)> {
    let columns = simulation.columns();
    let vectors = |wanted: &str| {
        columns.iter().find_map(|(name, column)| match column {
            Column::Vector(values) if *name == wanted => Some(values),
            _ => None,
        })
    };
    let (Some(velocities), Some(forces)) = (vectors("velocity_m_s"), vectors("marangoni_force_n")) else {
        return Vec::new();
    };
    let (gauge, material) = (simulation.gauge(), &simulation.model().materials[0]);
    let when = format!("t = {:.3} ms", 1e3 * simulation.time());
    let place = cut(simulation);
    let grid = |title: String, labels: [&'static str; 2], quantity, map: Map, temperature: Map| SectionGrid {
        title: format!("{title}, {when}"),
        x_label: labels[0],
        y_label: labels[1],
        x_m: map.x,
        y_m: map.y,
        quantity,
        value: map.value,
        levels: vec![(material.liquidus, "liquidus")],
        levels_of: Some((temperature.value, "K")),
    };
    let speed: Vec<f64> = velocities.iter().map(|velocity| velocity.norm()).collect();
    let section = |(along, label): (usize, &'static str)| {
        let (across, at) = (1 - along, place[1 - along]);
        let title = format!("Section along {label}");
        let map = gauge.section_of(&speed, across, at);
        (format!("speed_{label}"), grid(title, [label, "z"], "speed, m/s", map, gauge.section(across, at)))
    };
    let mut pictures = [(0, "x"), (1, "y")].map(section).to_vec();
    let from_above = |title: &str, quantity, field: &[f64], odd| {
        grid(title.to_string(), ["x", "y"], quantity, gauge.top_of(field, odd), gauge.top())
    };
    pictures.push(("speed_top".into(), from_above("Melt from above", "speed, m/s", &speed, [false; 2])));
    for (axis, (name, quantity)) in
        [("x", "force along x, N"), ("y", "force along y, N"), ("z", "force along z, N")]
            .into_iter()
            .enumerate()
    {
        let along: Vec<f64> = forces.iter().map(|force| force[axis]).collect();
        let picture = from_above("Marangoni force", quantity, &along, [axis == 0, axis == 1]);
        pictures.push((format!("marangoni_{name}"), picture));
    }
    pictures
}

fn temperatures(simulation: &Simulation) -> Vec<(String, SectionGrid)> {
    let (model, gauge) = (simulation.model(), simulation.gauge());
    let material = &model.materials[0];
    let levels = vec![(material.liquidus, "liquidus"), (material.solidus, "solidus")];
    let [x, y] = cut(simulation);
    let when = format!("t = {:.3} ms", 1e3 * simulation.time());
    let grid = |title: String, x_label, y_label, map: Map| SectionGrid {
        title,
        x_label,
        y_label,
        x_m: map.x,
        y_m: map.y,
        quantity: "temperature, K",
        value: map.value,
        levels: levels.clone(),
        levels_of: None,
    };
    vec![
        (
            "section_x".into(),
            grid(format!("Section along x through the beam, {when}"), "x", "z", gauge.section(1, y)),
        ),
        (
            "section_y".into(),
            grid(format!("Section along y through the beam, {when}"), "y", "z", gauge.section(0, x)),
        ),
        ("top".into(), grid(format!("From above, {when}"), "x", "y", gauge.top())),
    ]
}
