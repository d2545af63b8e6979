//! What a weld says at its end: its part of summary.json, and the dimensionless numbers of the physics present.

use super::Simulation;
use crate::measure::{Extent, Relief};
use crate::model::Model;
use crate::observe::{Energy, Pool, PoolSize, StressEnd, Weld, WeldOutcome};
use crate::physics::flow::SMOOTHING_RATIO;
use sph_fluid::equivalent_viscosity;
use std::collections::BTreeMap;

/// What the summary says of vapour: recoil_over_tension, where the material tells.
pub(super) fn vapour_numbers(simulation: &Simulation) -> BTreeMap<String, f64> {
    let model = simulation.model();
    let told = model.evaporation[0].is_some() && model.tension.is_some();
    told.then(|| ("recoil_over_tension".to_string(), simulation.records().recoil_over_tension))
        .into_iter()
        .collect()
}

/// What the summary says of a weld.
pub(super) fn outcome(simulation: &Simulation) -> WeldOutcome {
    let (records, ledger) = (simulation.records(), simulation.ledger());
    let (pool, solidus) = (sizes(&records.liquidus), sizes(&records.solidus));
    let weld = simulation.gauge().weld();
    let (mechanics, copies) = (simulation.mechanics().unwrap_or_default(), simulation.gauge().copies());
    WeldOutcome {
        peak_temperature_k: records.peak_temperature,
        pool: Pool {
            max_width_m: pool.max_width_m,
            max_length_m: pool.max_length_m,
            max_depth_m: pool.max_depth_m,
            at_solidus: solidus,
        },
        weld: Weld {
            // The weld holds every pool; peaks are kept node by node, so a size read off them can fall a hair short.
            width_m: weld.width.max(pool.max_width_m),
            length_m: weld.length.max(pool.max_length_m),
            depth_m: weld.depth.max(pool.max_depth_m),
            volume_m3: simulation.gauge().weld_volume(simulation.model(), simulation.particles()),
            solidified_at_s: records.solidified_at,
        },
        energy: Energy {
            emitted_j: ledger.emitted,
            absorbed_j: ledger.absorbed,
            sensible_j: ledger.sensible,
            latent_j: ledger.latent,
            lost_j: ledger.lost,
            kinetic_j: copies * mechanics.kinetic,
            compression_j: copies * mechanics.compression,
            surface_work_j: copies * (mechanics.work.tension + mechanics.work.marangoni),
            gravity_work_j: copies * mechanics.work.gravity,
            expansion_work_j: copies * mechanics.work.expansion,
            dissipated_j: copies * (mechanics.work.dissipated + mechanics.work.frozen),
            deformation_j: copies * mechanics.deformed,
            thermoelastic_j: copies * mechanics.thermoelastic,
            strain_j: copies * mechanics.strain,
            residual_rel: ledger.residual,
            mechanical_residual_rel: ledger.mechanical_residual,
            deformation_residual_rel: ledger.deformation_residual,
        },
        stress: mechanics.principal_stresses.map(|[largest, smallest]| StressEnd {
            max_von_mises_pa: mechanics.largest_von_mises,
            max_principal_stress_pa: largest,
            min_principal_stress_pa: smallest,
            max_displacement_m: mechanics.largest_displacement,
            max_plastic_strain: mechanics.largest_plastic_strain,
            unrest: mechanics.unrest,
        }),
    }
}

fn sizes(extent: &Extent) -> PoolSize {
    PoolSize { max_width_m: extent.width, max_length_m: extent.length, max_depth_m: extent.depth }
}

/// Dimensionless numbers of the flow, with the largest speed v of the run, half the pool's largest width R and its largest
/// excess dT over the liquidus: friction_by_numerics, what artificial viscosity adds to eta, over eta; with eta alone reynolds rho v R/eta, cell_reynolds rho v dx/eta, mach v/c of the artificial sound,
/// marangoni |tau_T| dT R rho c_p/(eta k), weber rho v^2 R/tau. With them the steps of the melt, and the relief of the top.
pub(super) fn flow_numbers(simulation: &Simulation) -> BTreeMap<String, f64> {
    let (model, records) = (simulation.model(), simulation.records());
    let (Some(flow), true) = (&model.flow, records.liquidus.width > 0.0) else { return BTreeMap::new() };
    let material = &model.materials[0];
    let (radius, speed) = (0.5 * records.liquidus.width, records.largest_speed);
    let (viscosity, tension) = (flow.viscosity_at_liquidus(), flow.tension_at_liquidus());
    let inertia = material.density * speed / viscosity;
    let excess = records.peak_temperature - material.liquidus;
    let diffusivity = material.conductivity(material.liquidus)
        / (material.density * material.heat_capacity_liquid.at(material.liquidus));
    let sound = simulation.mechanics().map_or(0.0, |mechanics| mechanics.sound_speed);
    let length = SMOOTHING_RATIO * model.spacing();
    let added = equivalent_viscosity::<3>(length, sound, flow.settings.artificial_viscosity);
    let mut numbers = vec![
        ("melt_steps", simulation.cost().melt_steps as f64),
        ("friction_by_numerics", material.density * added / viscosity),
        ("reynolds", inertia * radius),
        ("cell_reynolds", inertia * model.spacing()),
        ("sound_speed_m_s", sound),
        ("mach", records.largest_mach),
        ("compressed_by_rel", 0.5 * records.largest_mach.powi(2)),
        ("marangoni", flow.pull(excess) * radius / (viscosity * diffusivity)),
        ("weber", material.density * speed * speed * radius / tension),
    ];
    let particles = simulation.particles();
    let has_melted = |i: usize| model.curves[0].liquid_fraction(particles.peak_enthalpy[i]) >= 1.0;
    if let Some(relief) = Relief::of(simulation.workpiece(), particles, has_melted) {
        numbers.extend([
            ("crown_m", relief.crown),
            ("dip_m", relief.dip),
            ("surface_roughness_m", relief.roughness),
        ]);
    }
    numbers.into_iter().map(|(name, value)| (name.to_string(), value)).collect()
}

/// Start temperature \[K\], heat capacity from there to the solidus \[J/(kg K)\] and diffusivity at the start \[m²/s\] of the
/// part's own material.
pub(crate) fn solid_scales(model: &Model) -> (f64, f64, f64) {
    let (material, curve) = (&model.materials[0], &model.curves[0]);
    let start = (model.start)(model.bounds().0).1;
    let capacity = (curve.enthalpy_solidus() - curve.enthalpy_at(start)) / (material.solidus - start);
    (start, capacity, material.conductivity(start) / (material.density * capacity))
}

/// Dimensionless numbers of heat: fourier and peclet of the beam, stefan of the melting range, and what resolves them.
pub fn numbers(model: &Model) -> BTreeMap<String, f64> {
    let mut numbers = BTreeMap::new();
    let material = &model.materials[0];
    let (start, capacity, diffusivity) = solid_scales(model);
    if capacity.is_finite() && material.latent_heat > 0.0 {
        numbers.insert("stefan".into(), capacity * (material.liquidus - start) / material.latent_heat);
    }
    if let Some(laser) = &model.laser {
        let (radius, track) = (laser.beam().radius_m(), laser.track());
        let lit: f64 = track.on_intervals().iter().map(|[from, to]| to - from).sum();
        numbers.insert("fourier".into(), diffusivity * lit / radius.powi(2));
        numbers.insert("peclet".into(), track.max_speed() * radius / diffusivity);
        numbers.insert("beam_radius_over_spacing".into(), radius / model.spacing());
    }
    numbers
}
