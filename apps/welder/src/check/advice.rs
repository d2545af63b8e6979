//! Which effects matter in a case and which can be left out, and what leaving them out costs at most.

use super::estimates::{Scales, coupling, radiation_coefficient};
use crate::case::scene::{Face, Flow};
use crate::case::{Case, MaterialCard};
use crate::model::{FlowModel, GRAVITY, Model, marangoni_speed};
use crate::run::solid_scales;
use laser_source::Beam;
use serde::Serialize;
use sph_thermal::phase::EnthalpyCurve;

/// An effect below this share of the rise under the beam can be left out.
pub(super) const NEGLIGIBLE: f64 = 0.01;

/// Expansion of a molten metal by volume where the card tells none \[1/K\].
const COMMON_EXPANSION: f64 = 1.2e-4;

/// Temperature of the surroundings where no face names one \[K\].
pub(super) const ROOM_K: f64 = 293.0;

/// What is said of one effect.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Advice {
    pub(super) effect: Effect,
    /// Whether it matters; `None` where nothing can be said.
    pub(super) matters: Option<bool>,
    /// Its numbers.
    pub(super) text: String,
    /// What leaving it out changes at most, where that is estimated.
    pub(super) bound: Option<Bound>,
}

/// An effect that is judged.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Effect {
    LatentHeat,
    Evaporation,
    BottomFace,
    Losses,
    Movement,
    Stress,
    Flow,
    Buoyancy,
}

impl Effect {
    pub(super) fn name(self) -> &'static str {
        match self {
            Effect::LatentHeat => "latent heat",
            Effect::Evaporation => "evaporation",
            Effect::BottomFace => "bottom face",
            Effect::Losses => "losses",
            Effect::Movement => "movement",
            Effect::Stress => "stress",
            Effect::Flow => "flow",
            Effect::Buoyancy => "buoyancy",
        }
    }
}

/// Largest change that leaving an effect out is estimated to make, as a share.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Bound {
    /// Of the peak rise.
    Rise(f64),
    /// Of the volume that melts.
    Melt(f64),
}

impl Advice {
    fn new(effect: Effect, matters: Option<bool>, text: String) -> Self {
        Self { effect, matters, text, bound: None }
    }

    fn at_most(self, bound: Bound) -> Self {
        Self { bound: Some(bound), ..self }
    }

    /// The verdict in words.
    pub(super) fn verdict(&self) -> &'static str {
        match self.matters {
            Some(true) => "matters",
            Some(false) => "leave out",
            None => "open",
        }
    }

    /// One line: verdict, name, numbers.
    fn line(&self) -> String {
        format!("  {:<14} {}: {}", self.verdict(), self.effect.name(), self.text)
    }
}

/// The advice as lines, the estimate that it stands on first.
pub(super) fn lines(case: &Case, model: &Model) -> Vec<String> {
    let estimate = scales(model).map(|scales| {
        format!(
            "  estimate       {:.0} K under the beam when the light goes off (resting beam, half space, diffusivity of the solid \
             at the start, no latent heat; Carslaw and Jaeger 1959)",
            Hot::new(model, &scales).temperature
        )
    });
    estimate.into_iter().chain(advice(case, model).iter().map(Advice::line)).collect()
}

/// The advice on each effect; none without a laser, on whose beam the estimates stand.
pub(super) fn advice(case: &Case, model: &Model) -> Vec<Advice> {
    let Some(scales) = scales(model) else { return Vec::new() };
    let card = &case.materials[0].card;
    let hot = Hot::new(model, &scales);
    let peak = hot.temperature;
    let optional = [latent_heat(model, peak), evaporation(model, card, &hot, &scales), movement(&scales)];
    let mut all: Vec<_> = optional.into_iter().flatten().collect();
    all.push(bottom(&hot, &scales));
    all.push(losses(model.faces.top, card, &hot, &scales));
    all.push(stress(case, model, card, peak));
    let melt = Melt::of(model, card, peak);
    all.push(flow(case, melt.as_ref(), &scales));
    all.extend(melt.and_then(|melt| buoyancy(case, card, &melt, &scales)));
    all
}

/// The hottest point. The estimates are linear in the integral of the conductivity over temperature, the Kirchhoff potential,
/// not in temperature itself: a melt that conducts badly is hotter for it, and everything counts more in it.
struct Hot<'a> {
    curve: &'a EnthalpyCurve,
    conductivity: f64,
    start: f64,
    potential: f64,
    /// Its temperature \[K\].
    temperature: f64,
}

impl<'a> Hot<'a> {
    fn new(model: &'a Model, scales: &Scales) -> Self {
        let (curve, conductivity, start) = (&model.curves[0], scales.conductivity, scales.start);
        let potential = curve.potential_at(start) + conductivity * scales.peak_rise();
        Self { curve, conductivity, start, potential, temperature: curve.temperature_at_potential(potential) }
    }

    /// Temperature \[K\] where the solid would have risen by `rise` \[K\].
    fn at(&self, rise: f64) -> f64 {
        self.curve.temperature_at_potential(self.curve.potential_at(self.start) + self.conductivity * rise)
    }

    /// Change of its temperature \[K\] by what would change that of the solid by `rise` \[K\].
    fn change(&self, rise: f64) -> f64 {
        let shifted = self.curve.temperature_at_potential(self.potential + self.conductivity * rise);
        (shifted - self.temperature).abs()
    }

    /// The same over its rise.
    fn share(&self, rise: f64) -> f64 {
        self.change(rise) / (self.temperature - self.start)
    }
}

/// How long the light is on \[s\].
pub(super) fn lit(model: &Model) -> f64 {
    let intervals = model.laser.as_ref().map_or_else(Vec::new, |laser| laser.track().on_intervals());
    intervals.iter().map(|[from, to]| to.min(model.end) - from.min(model.end)).sum()
}

/// Distance of a place from the sides of the whole part, mirrored halves included \[m\].
fn walls(model: &Model, place: [f64; 2]) -> [[f64; 2]; 2] {
    let ((low, high), mirrored) = (model.bounds(), model.mirrored());
    std::array::from_fn(|axis| {
        let (below, above) = (place[axis] - low[axis], high[axis] - place[axis]);
        let beyond = |mirror: bool| if mirror { below + above } else { 0.0 };
        [below + beyond(mirrored[axis][0]), above + beyond(mirrored[axis][1])]
    })
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
        lit: lit(model),
        speed: track.max_speed(),
        thickness: model.size[2],
        walls: walls(model, track.position(0.5 * (track.points()[0].time_s + track.end_time()))),
    })
    .filter(|scales| scales.power > 0.0 && scales.lit > 0.0 && scales.diffusivity.is_finite())
}

/// Heat balance of what melts: c (T_liquidus - T_start) and the latent heat; their ratio is the Stefan number (Alexiades
/// and Solomon, Mathematical Modeling of Melting and Freezing Processes, 1993).
fn latent_heat(model: &Model, peak: f64) -> Option<Advice> {
    let (material, (start, capacity, _)) = (&model.materials[0], solid_scales(model));
    let sensible = capacity * (material.liquidus - start);
    let stefan = sensible / material.latent_heat;
    let melts = peak > material.solidus;
    (stefan.is_finite() && melts).then(|| {
        let share = 1.0 / (1.0 + stefan);
        Advice::new(Effect::LatentHeat, Some(share > NEGLIGIBLE),
            format!(
                "Stefan {stefan:.2}, {:.0} % of the heat that melts; without it the same heat melts up to {:.0} % more \
                 (heat balance)",
                100.0 * share,
                100.0 / stefan
            ),
        )
        .at_most(Bound::Melt(1.0 / stefan))
    })
}

/// How near the surface is to boiling, and, where the card tells how the melt evaporates, what that takes away at most.
fn evaporation(model: &Model, card: &MaterialCard, hot: &Hot, scales: &Scales) -> Option<Advice> {
    let boiling = card.boiling_k.as_ref()?.value;
    let over = hot.temperature > boiling;
    let mut text = format!(
        "the estimate is {:.0} K {} the boiling point, {boiling:.0} K",
        (hot.temperature - boiling).abs(),
        if over { "over" } else { "below" }
    );
    if over {
        text += "; a peak above boiling is no longer conduction mode";
    }
    let Some(vapour) = &model.evaporation[0] else {
        let more =
            "; the card lacks heat_of_evaporation_j_kg or molar_mass_kg_mol, so that its heat is not judged";
        return Some(Advice::new(Effect::Evaporation, Some(over), text + more));
    };
    let listed = matches!(model.faces.top, Face::Losses { evaporation: true, .. });
    let share = hot.share(-scales.losses_fall(|rise| vapour.flux(hot.at(rise).min(boiling))));
    text += &format!(
        "; evaporation, which the case {}, takes away up to {:.2} % of the rise (bound, as for the losses)",
        if listed { "computes" } else { "leaves out" },
        100.0 * share
    );
    Some(Advice::new(Effect::Evaporation, Some(over || share > NEGLIGIBLE), text).at_most(Bound::Rise(share)))
}

fn bottom(hot: &Hot, scales: &Scales) -> Advice {
    let solid = scales.bottom_rise();
    let (rise, share) = (hot.change(solid), hot.share(solid));
    let fourier = scales.diffusivity * scales.lit / scales.thickness.powi(2);
    Advice::new(Effect::BottomFace, Some(share > NEGLIGIBLE),
        format!(
            "Fourier {fourier:.2} of the thickness; it changes the rise under the beam by up to {rise:.1} K, {:.2} % (mirror \
             images, Carslaw and Jaeger 1959, 10.4)",
            100.0 * share
        ),
    )
    .at_most(Bound::Rise(share))
}

/// What the losses of the top face take away at most; of a face that has none, what a black one would lose.
fn losses(top: Face, card: &MaterialCard, hot: &Hot, scales: &Scales) -> Advice {
    let boiling = card.boiling_k.as_ref().map_or(f64::INFINITY, |boiling| boiling.value);
    let hottest = hot.temperature.min(boiling);
    let (convection, emissivity, ambient, whose) = match top {
        Face::Losses { convection_w_m2_k, emissivity, ambient_k, .. } => {
            (convection_w_m2_k, emissivity, ambient_k, "the top face's losses")
        }
        _ => (0.0, 1.0, ROOM_K, "radiation of a black top face, which the case leaves out,"),
    };
    let coefficient = |surface: f64| convection + radiation_coefficient(emissivity, surface, ambient);
    let fall = scales.losses_fall(|rise| {
        let surface = hot.at(rise).min(boiling);
        coefficient(surface) * (surface - ambient)
    });
    let share = hot.share(-fall);
    Advice::new(
        Effect::Losses,
        Some(share > NEGLIGIBLE),
        format!(
            "Biot {:.1e} with {:.0} W/(m2 K) at {hottest:.0} K; {whose} would take away up to {:.2} % of the rise \
             (bound: all the time as hot as at the end, Carslaw and Jaeger 1959, 10.4)",
            scales.biot(coefficient(hottest)),
            coefficient(hottest),
            100.0 * share
        ),
    )
    .at_most(Bound::Rise(share))
}

fn movement(scales: &Scales) -> Option<Advice> {
    (scales.speed > 0.0).then(|| {
        let ratio = scales.ahead_over_behind();
        Advice::new(Effect::Movement, Some(1.0 - ratio > NEGLIGIBLE),
            format!(
                "Peclet {:.3}; one radius ahead of the beam the rise is {ratio:.2} of that one radius behind (Rosenthal 1946)",
                scales.peclet()
            ),
        )
    })
}

/// The melt as it is, whatever the scene makes of its viscosity.
struct Melt {
    flow: FlowModel,
    density: f64,
    diffusivity: f64,
    /// Temperature of its hottest point, at most that of boiling, and how far above the liquidus that is \[K\].
    hottest: f64,
    excess: f64,
}

impl Melt {
    /// `None` where the card does not tell how it flows.
    fn of(model: &Model, card: &MaterialCard, peak: f64) -> Option<Self> {
        let flow = FlowModel::of_card(&Flow::default(), card).ok()?;
        let material = &model.materials[0];
        let hottest = card.boiling_k.as_ref().map_or(peak, |boiling| peak.min(boiling.value));
        let heat = material.density * material.heat_capacity_liquid.at(material.liquidus);
        Some(Self {
            flow,
            density: material.density,
            diffusivity: material.conductivity(material.liquidus) / heat,
            hottest,
            excess: hottest - material.liquidus,
        })
    }

    fn viscosity(&self) -> f64 {
        self.flow.viscosity_at_liquidus()
    }
}

/// Heat that Marangoni flow carries over heat that is conducted, v w/a, by [`marangoni_speed`].
fn flow(case: &Case, melt: Option<&Melt>, scales: &Scales) -> Advice {
    let Some(melt) = melt else {
        let text = "not judged: the card lacks viscosity_pa_s or a surface tension over temperature";
        return Advice::new(Effect::Flow, None, text.into());
    };
    if melt.excess <= 0.0 {
        return Advice::new(Effect::Flow, Some(false), "nothing melts".into());
    }
    let pull = melt.flow.pull(melt.excess);
    let speed = marangoni_speed(pull, melt.density, melt.viscosity(), scales.radius);
    let peclet = speed * scales.radius / melt.diffusivity;
    let listed = case.scene.flow().is_some();
    let cost = match (peclet > 1.0, listed) {
        (true, false) => {
            "; a pool with flow has another width and depth, which a case without Flow() does not show"
        }
        _ => "",
    };
    let outwards = melt.flow.tension.at(melt.hottest) < melt.flow.tension_at_liquidus();
    let way = if outwards { "outwards" } else { "inwards" };
    Advice::new(
        Effect::Flow,
        Some(peclet > 1.0),
        format!("Marangoni flow {way} at about {speed:.2} m/s, Peclet {peclet:.1}{cost} (Ostrach 1982)"),
    )
}

/// What buoyancy drives beside tension, rho g beta dT R^2 over |d tau| (the dynamic Bond number, Grashof's number
/// over the Reynolds number of the Marangoni flow), and the heat that it carries by itself: at most sqrt(g beta dT
/// R), and the surface of Birikh's (1966) layer of depth R over R, g beta dT R^2/(48 nu), where friction rules.
fn buoyancy(case: &Case, card: &MaterialCard, melt: &Melt, scales: &Scales) -> Option<Advice> {
    if melt.excess <= 0.0 {
        return None;
    }
    let given = card.volume_expansion_liquid_1_k.as_ref().map(|expansion| expansion.value);
    let lift = GRAVITY * given.unwrap_or(COMMON_EXPANSION) * melt.excess;
    let (radius, viscosity) = (scales.radius, melt.viscosity() / melt.density);
    let grashof = lift * radius.powi(3) / viscosity.powi(2);
    let reynolds = melt.flow.pull(melt.excess) * radius / (melt.density * viscosity.powi(2));
    let speed = (lift * radius).sqrt().min(lift * radius.powi(2) / (48.0 * viscosity));
    let (bond, peclet) = (grashof / reynolds, speed * radius / melt.diffusivity);
    let whose = match (given, case.scene.flow()) {
        (Some(_), Some(_)) => "which the case computes".to_string(),
        (Some(_), None) => "which a case without Flow() leaves out".to_string(),
        (None, _) => format!(
            "which a card without volume_expansion_liquid_1_k leaves out (here {COMMON_EXPANSION:.1e} 1/K, common for metals)"
        ),
    };
    Some(Advice::new(
        Effect::Buoyancy,
        Some(bond > NEGLIGIBLE && peclet > 1.0),
        format!(
            "{bond:.1e} of what tension drives (Grashof {grashof:.1e} over Reynolds {reynolds:.1e} of Marangoni flow), alone about {speed:.1e} m/s, \
             Peclet {peclet:.1e}; {whose} (Birikh 1966)"
        ),
    ))
}

/// E alpha dT / sigma_y: stress of a fully held body over its yield stress at the start (Boley and Weiner 1960). By default
/// stress takes no heat; what that leaves out of the temperatures is the thermoelastic coupling.
fn stress(case: &Case, model: &Model, card: &MaterialCard, peak: f64) -> Advice {
    let (Some(young), Some(poisson), Some(expansion), Some(strength)) =
        (&card.young_pa, &card.poisson, &card.expansion_1_k, &card.yield_pa)
    else {
        let text = "not judged: the card lacks young_pa, poisson, expansion_1_k or yield_pa";
        return Advice::new(Effect::Stress, None, text.into());
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
    Advice::new(Effect::Stress, Some(yields),
        format!(
            "E alpha dT / yield {ratio:.1}: {cost}; the pool is the same with and without, and the coupling that both leave \
             out (unless heat_of_deformation is on) is {:.1} % of the heat (Boley and Weiner 1960)",
            100.0 * stored
        ),
    )
    .at_most(Bound::Rise(0.0))
}
