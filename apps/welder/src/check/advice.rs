//! Which effects matter in a case and which can be left out, and what leaving them out costs at most.

use super::estimates::{Scales, coupling, radiation_coefficient};
use crate::case::scene::Face;
use crate::case::{Case, MaterialCard};
use crate::model::{Model, marangoni_speed};
use crate::run::solid_scales;
use laser_source::Beam;

/// An effect below this share of the rise under the beam can be left out.
const NEGLIGIBLE: f64 = 0.01;

/// Temperature of the surroundings where no face names one \[K\].
const ROOM_K: f64 = 293.0;

/// The advice, a line an effect; none without a laser, on whose beam the estimates stand.
pub(super) fn advice(case: &Case, model: &Model) -> Vec<String> {
    let Some(scales) = scales(model) else { return Vec::new() };
    let card = &case.materials[0].card;
    let peak = scales.start + scales.peak_rise();
    let mut lines = vec![format!(
        "  estimate       {peak:.0} K under the beam when the light goes off (resting beam, half space, solid's properties at the \
         start, no latent heat; Carslaw and Jaeger 1959)"
    )];
    lines.extend(latent_heat(model, &scales));
    lines.extend(boiling(card, peak));
    lines.push(bottom(&scales));
    lines.push(losses(model.faces.top, card, peak, &scales));
    lines.extend(movement(&scales));
    lines.push(stress(case, model, card, peak));
    lines.push(flow(case, model, card, peak, &scales));
    lines
}

/// One line: whether the effect matters (`None`: nothing can be said), its name, its numbers.
fn told(matters: Option<bool>, what: &str, text: String) -> String {
    let verdict = match matters {
        Some(true) => "matters",
        Some(false) => "leave out",
        None => "open",
    };
    format!("  {verdict:<14} {what}: {text}")
}

fn scales(model: &Model) -> Option<Scales> {
    let laser = model.laser.as_ref()?;
    let (start, _, diffusivity) = solid_scales(model);
    let track = laser.track();
    let power = track.points().iter().map(|point| point.power_w).fold(0.0, f64::max);
    Some(Scales {
        start,
        conductivity: model.materials[0].conductivity(start),
        diffusivity,
        power: power * laser.beam().total() * laser.absorption().absorptivity(),
        radius: laser.beam().radius_m(),
        top_hat: matches!(laser.beam(), Beam::TopHat(_)),
        lit: track.on_intervals().iter().map(|[from, to]| to.min(model.end) - from.min(model.end)).sum(),
        speed: track.max_speed(),
        thickness: model.size[2],
    })
    .filter(|scales| scales.power > 0.0 && scales.lit > 0.0 && scales.diffusivity.is_finite())
}

/// Heat balance of what melts: c (T_liquidus - T_start) and the latent heat; their ratio is the Stefan number (Alexiades
/// and Solomon, Mathematical Modeling of Melting and Freezing Processes, 1993).
fn latent_heat(model: &Model, scales: &Scales) -> Option<String> {
    let (material, (start, capacity, _)) = (&model.materials[0], solid_scales(model));
    let sensible = capacity * (material.liquidus - start);
    let stefan = sensible / material.latent_heat;
    let melts = start + scales.peak_rise() > material.solidus;
    (stefan.is_finite() && melts).then(|| {
        let share = 1.0 / (1.0 + stefan);
        told(
            Some(share > NEGLIGIBLE),
            "latent heat",
            format!(
                "Stefan {stefan:.2}, {:.0} % of the heat that melts; without it the same heat melts up to {:.0} % more \
                 (heat balance)",
                100.0 * share,
                100.0 / stefan
            ),
        )
    })
}

fn boiling(card: &MaterialCard, peak: f64) -> Option<String> {
    let boiling = card.boiling_k.as_ref()?.value;
    let over = peak > boiling;
    let text = format!(
        "the estimate is {:.0} K {} the boiling point, {boiling:.0} K",
        (peak - boiling).abs(),
        if over { "over" } else { "below" }
    );
    let cost =
        if over { "; it is not computed, and a peak above boiling is no longer conduction mode" } else { "" };
    Some(told(Some(over), "evaporation", text + cost))
}

fn bottom(scales: &Scales) -> String {
    let (rise, share) = (scales.bottom_rise(), scales.bottom_rise() / scales.peak_rise());
    let fourier = scales.diffusivity * scales.lit / scales.thickness.powi(2);
    told(
        Some(share > NEGLIGIBLE),
        "bottom face",
        format!(
            "Fourier {fourier:.2} of the thickness; it changes the rise under the beam by up to {rise:.1} K, {:.2} % (mirror \
             images, Carslaw and Jaeger 1959, 10.4)",
            100.0 * share
        ),
    )
}

/// What the losses of the top face take away at most; of a face that has none, what a black one would lose.
fn losses(top: Face, card: &MaterialCard, peak: f64, scales: &Scales) -> String {
    let hottest = card.boiling_k.as_ref().map_or(peak, |boiling| peak.min(boiling.value));
    let (coefficient, whose) = match top {
        Face::Losses { convection_w_m2_k, emissivity, ambient_k } => (
            convection_w_m2_k + radiation_coefficient(emissivity, hottest, ambient_k),
            "the top face's losses",
        ),
        _ => (
            radiation_coefficient(1.0, hottest, ROOM_K),
            "radiation of a black top face, which the case leaves out,",
        ),
    };
    let share = scales.losses_share(coefficient);
    told(
        Some(share > NEGLIGIBLE),
        "losses",
        format!(
            "Biot {:.1e} with {coefficient:.0} W/(m2 K) at {hottest:.0} K; {whose} would take away up to {:.2} % of the rise \
             (bound: the whole face as hot, Carslaw and Jaeger 1959, 2.9)",
            scales.biot(coefficient),
            100.0 * share
        ),
    )
}

fn movement(scales: &Scales) -> Option<String> {
    (scales.speed > 0.0).then(|| {
        let ratio = scales.ahead_over_behind();
        told(
            Some(1.0 - ratio > NEGLIGIBLE),
            "movement",
            format!(
                "Peclet {:.3}; one radius ahead of the beam the rise is {ratio:.2} of that one radius behind (Rosenthal 1946)",
                scales.peclet()
            ),
        )
    })
}

/// Heat that Marangoni flow carries over heat that is conducted, v w/a, by [`marangoni_speed`].
fn flow(case: &Case, model: &Model, card: &MaterialCard, peak: f64, scales: &Scales) -> String {
    let (Some(viscosity), Some(slope)) = (&card.viscosity_pa_s, &card.surface_tension_slope_n_m_k) else {
        let text = "not judged: the card lacks viscosity_pa_s or surface_tension_slope_n_m_k";
        return told(None, "flow", text.into());
    };
    let material = &model.materials[0];
    let hottest = card.boiling_k.as_ref().map_or(peak, |boiling| peak.min(boiling.value));
    let excess = hottest - material.liquidus;
    if excess <= 0.0 {
        return told(Some(false), "flow", "nothing melts".into());
    }
    let (pull, density) = (slope.value.abs() * excess, material.density);
    let speed = marangoni_speed(pull, density, viscosity.value, scales.radius);
    let liquid = material.heat_capacity_liquid.at(material.liquidus);
    let peclet = speed * scales.radius * density * liquid / material.conductivity(material.liquidus);
    let listed = case.scene.flow().is_some();
    let cost = match (peclet > 1.0, listed) {
        (true, false) => {
            "; a pool with flow has another width and depth, which a case without Flow() does not show"
        }
        _ => "",
    };
    let way = if slope.value < 0.0 { "outwards" } else { "inwards" };
    told(
        Some(peclet > 1.0),
        "flow",
        format!("Marangoni flow {way} at about {speed:.2} m/s, Peclet {peclet:.1}{cost} (Ostrach 1982)"),
    )
}

/// E alpha dT / sigma_y: stress of a fully held body over its yield stress at the start (Boley and Weiner 1960). The program
/// lets stress take no heat; what that leaves out of the temperatures is the thermoelastic coupling.
fn stress(case: &Case, model: &Model, card: &MaterialCard, peak: f64) -> String {
    let (Some(young), Some(poisson), Some(expansion), Some(strength)) =
        (&card.young_pa, &card.poisson, &card.expansion_1_k, &card.yield_pa)
    else {
        let text = "not judged: the card lacks young_pa, poisson, expansion_1_k or yield_pa";
        return told(None, "stress", text.into());
    };
    let (start, capacity, _) = solid_scales(model);
    let rise = peak.min(model.materials[0].solidus) - start;
    let slope = expansion.at(start);
    let ratio = young.value * slope * rise / strength.at(start);
    let stored = coupling(young.value, poisson.value, slope, start, model.materials[0].density * capacity);
    let yields = ratio > 1.0;
    let listed = case.scene.stress().is_some();
    let cost = match (yields, listed) {
        (true, true) => "held all around, the solid yields and keeps residual stress",
        (true, false) => {
            "held all around, the solid yields and keeps residual stress, which a case without Stress() does not show"
        }
        (false, _) => "even held all around, the solid stays elastic and keeps no residual stress",
    };
    told(
        Some(yields),
        "stress",
        format!(
            "E alpha dT / yield {ratio:.1}: {cost}; the pool is the same with and without, and the coupling that both leave \
             out is {:.1} % of the heat (Boley and Weiner 1960)",
            100.0 * stored
        ),
    )
}
