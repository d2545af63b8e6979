//! Gallium that a warm side wall melts (Gau and Viskanta 1986): conduction and phase change in all particles, buoyant flow in
//! those that have melted, among walls of those that have not.
//!
//! Scaled by the width of the cavity, with density, heat capacity, and gravity times expansion of one, so that Ra = 1e5 and
//! Pr = 0.018 of the height, and Ste = 0.041. Buoyancy is the weight by the reference density over temperature,
//! rho_ref = rho_0 (1 - beta (T - T_m)), in Boussinesq's limit: in a closed melt the rest is pressure.

use super::super::neighbors::find;
use super::super::scene::constant;
use super::super::{Benchmark, BenchmarkError, Mark, Outcome, Quantity};
use super::fluid::{Columns, Fluid};
use crate::model::ModelError;
use nalgebra::Vector2;
use sph_fluid::{FluidControls, Renewal, Tait};
use sph_kernel::operators::laplacian_moment;
use sph_kernel::{KernelKind, RowBuffer, ScaledKernel};
use sph_thermal::conduction::moving::{Fields, conduction_row};
use sph_thermal::phase::{EnthalpyCurve, ThermalMaterial};

/// Height over width of the cavity, 63.5 over 88.9 mm.
const HEIGHT: f64 = 5.0 / 7.0;

/// Temperatures of the warm and of the cold wall, and of melting, which takes a fifth of a degree.
const WARM: f64 = 38.0;
const COLD: f64 = 28.0;
const LIQUIDUS: f64 = 29.8;
const SOLIDUS: f64 = 29.6;

/// Latent heat, conductivity and viscosity that give Ste, Ra and Pr.
const STEFAN: f64 = 0.041;
const LATENT: f64 = (WARM - LIQUIDUS) / STEFAN;
const RAYLEIGH: f64 = 1e5;
const PRANDTL: f64 = 0.018;

/// When, as Ste a t over the width squared, and the melted share of the cavity.
const MELTED: [(f64, f64); 3] = [(0.00946, 0.1197), (0.01433, 0.1611), (0.02113, 0.2048)];

/// A particle melts where this share of it is liquid, and freezes where only the other is, as in the program.
const MELTS_AT: f64 = 0.6;
const FREEZES_AT: f64 = 0.4;

/// Step of heat over dx²/a: half of what is stable.
const HEAT_STEP: f64 = 0.15;

/// Artificial viscosity: without it, noise is faster than the flow. It adds nu, 1.5 nu and 2.2 nu at 56, 42 and 28 across.
const DAMPING: f64 = 0.02;

/// Layers of the cavity's walls.
const LAYERS: i32 = 4;

pub(in super::super) const BENCHMARK: Benchmark = Benchmark {
    name: "coupled/gallium",
    tested_crate: "welder",
    reference: "experiment of Gau and Viskanta (1986); a 2-D finite-element solution is 6.6 % off. So is conduction alone (6.8 % \
                at 28 across): in this time convection adds 2 to 8 % to the melt",
    quantities: &[Quantity {
        suffix: "",
        text: "root mean square of the relative errors of the melted share at tau = 0.00946, 0.01433 and 0.02113; resolution: \
               particles across the width",
        marks: &[Mark { resolution: 28.0, error: 0.1 }, Mark { resolution: 56.0, error: 0.1 }],
    }],
    resolutions: [28.0, 42.0, 56.0],
    quick: 1,
    run: |resolution| {
        let mut cavity = Cavity::new(resolution as usize, true)?;
        let shares = cavity.melted_shares()?;
        let squares = MELTED.iter().zip(shares).map(|((_, share), found)| (found / share - 1.0).powi(2));
        let error = (squares.sum::<f64>() / MELTED.len() as f64).sqrt();
        tracing::info!("melted shares {shares:.4?}, largest speed {:.2}", cavity.largest_speed);
        Ok(Outcome {
            errors: vec![error],
            particles: cavity.positions.len(),
            pair_visits: cavity.pair_visits,
        })
    },
};

/// sqrt(g beta dT H): no melt is faster.
fn speed() -> f64 {
    ((WARM - LIQUIDUS) * HEIGHT).sqrt()
}

/// a = nu/Pr with Ra = g beta dT H^3/(nu a).
fn diffusivity() -> f64 {
    ((WARM - LIQUIDUS) * HEIGHT.powi(3) / (RAYLEIGH * PRANDTL)).sqrt()
}

/// The metal, and its melt among its walls.
struct Cavity {
    spacing: f64,
    curve: EnthalpyCurve,
    kernel: ScaledKernel<2>,
    controls: FluidControls<2>,
    /// Columns of all metal; what has not melted stands still.
    positions: Vec<Vector2<f64>>,
    velocities: Vec<Vector2<f64>>,
    densities: Vec<f64>,
    enthalpies: Vec<f64>,
    molten: Vec<bool>,
    /// The melt with its walls, and which metal stands there: melt first; none before anything has melted.
    melt: Option<(Fluid<2>, Vec<usize>)>,
    flows: bool,
    time: f64,
    largest_speed: f64,
    pair_visits: u64,
}

impl Cavity {
    /// `across` particles over the width, all cold; a melt that does not flow leaves conduction alone.
    fn new(across: usize, flows: bool) -> Result<Self, BenchmarkError> {
        let spacing = 1.0 / across as f64;
        let rows = (HEIGHT / spacing).round() as usize;
        let place = |k: usize| Vector2::new((k % across) as f64 + 0.5, (k / across) as f64 + 0.5) * spacing;
        let positions: Vec<_> = (0..across * rows).map(place).collect();
        let conductivity = || constant(diffusivity());
        let metal = ThermalMaterial {
            density: 1.0,
            solidus: SOLIDUS,
            liquidus: LIQUIDUS,
            latent_heat: LATENT,
            heat_capacity_solid: constant(1.0),
            heat_capacity_liquid: constant(1.0),
            conductivity_solid: conductivity(),
            conductivity_liquid: conductivity(),
        };
        let curve = EnthalpyCurve::continuous(&metal).map_err(ModelError::from)?;
        let count = positions.len();
        let controls = FluidControls {
            dynamic_viscosity: PRANDTL * diffusivity(),
            artificial_viscosity: DAMPING,
            density_diffusion: 0.1,
            // Shifting makes the density of a melt two particles wide between walls run away.
            renewal: Some(Renewal { shifting: 0.0, ..Renewal::default() }),
            ..FluidControls::new(
                KernelKind::WendlandC2.with_smoothing_length(1.5 * spacing),
                Tait::new(1.0, 10.0 * speed(), 7.0)?,
            )
        };
        Ok(Self {
            kernel: KernelKind::CubicSpline.with_smoothing_length(1.3 * spacing),
            velocities: vec![Vector2::zeros(); count],
            densities: vec![1.0; count],
            enthalpies: vec![curve.enthalpy_at(COLD); count],
            molten: vec![false; count],
            melt: None,
            time: 0.0,
            largest_speed: 0.0,
            pair_visits: 0,
            spacing,
            curve,
            controls,
            positions,
            flows,
        })
    }

    fn melted_shares(&mut self) -> Result<[f64; 3], BenchmarkError> {
        let mut shares = [0.0; 3];
        for (share, (tau, _)) in shares.iter_mut().zip(MELTED) {
            self.run_to(tau / (STEFAN * diffusivity()))?;
            let liquid = self.enthalpies.iter().map(|&enthalpy| self.curve.liquid_fraction(enthalpy));
            *share = liquid.sum::<f64>() / self.positions.len() as f64;
        }
        Ok(shares)
    }

    fn run_to(&mut self, time: f64) -> Result<(), BenchmarkError> {
        let longest = HEAT_STEP * self.spacing * self.spacing / diffusivity();
        let steps = ((time - self.time) / longest).ceil();
        let dt = (time - self.time) / steps;
        for _ in 0..steps as usize {
            self.conduct(dt);
            if self.flows {
                self.change_phase()?;
                self.flow(dt);
            }
        }
        self.time = time;
        Ok(())
    }

    /// One explicit step of heat: warm and cold side walls, adiabatic floor and lid, by mirrored copies.
    fn conduct(&mut self, dt: f64) {
        let (mut places, mut sources) = (self.positions.clone(), Vec::new());
        let mut potentials: Vec<f64> = self.enthalpies.iter().map(|&h| self.curve.potential(h)).collect();
        let held = [WARM, COLD].map(|temperature| self.curve.potential_at(temperature));
        let reach = self.kernel.support_radius();
        for (axis, plane, held) in
            [(0, 0.0, Some(held[0])), (0, 1.0, Some(held[1])), (1, 0.0, None), (1, HEIGHT, None)]
        {
            for k in 0..places.len() {
                if (places[k][axis] - plane).abs() < reach {
                    let mut place = places[k];
                    place[axis] = 2.0 * plane - place[axis];
                    places.push(place);
                    sources.push(k);
                    potentials.push(held.map_or(potentials[k], |held| 2.0 * held - potentials[k]));
                }
            }
        }
        let (starts, neighbors) = find(&places, reach);
        let volume = vec![self.spacing * self.spacing; places.len()];
        let mut buffer = RowBuffer::default();
        let count = self.positions.len();
        let mut moment: Vec<f64> = Vec::with_capacity(places.len());
        for i in 0..count {
            let row = buffer.fill(i, &neighbors[starts[i]..starts[i + 1]], &places, &self.kernel);
            moment.push(laplacian_moment(&row, &volume));
        }
        for source in sources {
            moment.push(moment[source]);
        }
        let fields = Fields { volume: &volume, moment: &moment, potential: &potentials };
        for i in 0..count {
            let row = buffer.fill(i, &neighbors[starts[i]..starts[i + 1]], &places, &self.kernel);
            self.enthalpies[i] += dt * conduction_row(&row, &fields) / volume[i];
        }
        self.pair_visits += 2 * starts[count] as u64;
    }

    /// Lets particles melt and freeze; where any does, the melt is taken out of the metal anew.
    fn change_phase(&mut self) -> Result<(), BenchmarkError> {
        let liquid = |i: usize| self.curve.liquid_fraction(self.enthalpies[i]);
        let turned =
            |&i: &usize| if self.molten[i] { liquid(i) <= FREEZES_AT } else { liquid(i) >= MELTS_AT };
        let turned: Vec<usize> = (0..self.molten.len()).filter(turned).collect();
        if turned.is_empty() {
            return Ok(());
        }
        self.scatter();
        for i in turned {
            self.molten[i] = !self.molten[i];
            self.velocities[i] = Vector2::zeros();
        }
        self.gather()
    }

    /// Writes the melt back to the metal; walls get the density of the pressure that they carry, and melt with it.
    fn scatter(&mut self) {
        let Some((fluid, members)) = self.melt.take() else { return };
        self.pair_visits += fluid.pair_visits;
        for (k, &i) in members.iter().enumerate() {
            let flowing = k < fluid.len();
            self.positions[i] = fluid.columns.positions[k];
            self.velocities[i] = fluid.columns.velocities[k];
            self.densities[i] = if flowing {
                fluid.columns.densities[k]
            } else {
                self.controls.state.density(fluid.sweep.pressures()[k])
            };
        }
    }

    fn gather(&mut self) -> Result<(), BenchmarkError> {
        let flowing = (0..self.molten.len()).filter(|&i| self.molten[i]);
        let mut members: Vec<usize> = flowing.collect();
        let fluid = members.len();
        let farthest = members.iter().map(|&i| self.positions[i].x).fold(0.0, f64::max);
        let near = farthest + 2.0 * self.controls.kernel.support_radius();
        members.extend((0..self.molten.len()).filter(|&i| !self.molten[i] && self.positions[i].x < near));
        let mut positions: Vec<_> = members.iter().map(|&i| self.positions[i]).collect();
        let mut velocities: Vec<_> = members.iter().map(|&i| self.velocities[i]).collect();
        let mut densities: Vec<_> = members.iter().map(|&i| self.densities[i]).collect();
        densities[fluid..].fill(1.0);
        positions.extend(self.walls().into_iter().filter(|place| place.x < near));
        velocities.resize(positions.len(), Vector2::zeros());
        densities.resize(positions.len(), 1.0);
        let masses = vec![self.spacing * self.spacing; positions.len()];
        let columns = Columns { positions, velocities, densities, masses };
        self.melt = Some((Fluid::new(self.controls, self.spacing, columns, fluid)?, members));
        Ok(())
    }

    /// Particles behind the faces of the cavity.
    fn walls(&self) -> Vec<Vector2<f64>> {
        let [across, up] = [1.0, HEIGHT].map(|length| (length / self.spacing).round() as i32);
        let all = (-LAYERS..up + LAYERS)
            .flat_map(|row| (-LAYERS..across + LAYERS).map(move |column| (column, row)));
        let outside = all.filter(|(column, row)| !(0..across).contains(column) || !(0..up).contains(row));
        outside
            .map(|(column, row)| Vector2::new(f64::from(column) + 0.5, f64::from(row) + 0.5) * self.spacing)
            .collect()
    }

    /// Steps the melt over `dt` at its temperatures.
    fn flow(&mut self, dt: f64) {
        let Some((fluid, members)) = &mut self.melt else { return };
        for (push, &i) in fluid.pushes.iter_mut().zip(members.iter()) {
            push.y = self.curve.temperature(self.enthalpies[i]) - LIQUIDUS;
        }
        let longest = 0.5 * self.controls.kernel.smoothing_length() / (10.0 * speed());
        let steps = (dt / longest).ceil();
        (0..steps as usize).for_each(|_| fluid.step(dt / steps, |_, _| ()));
        for (k, &i) in members.iter().enumerate().take(fluid.len()) {
            self.positions[i] = fluid.columns.positions[k];
            self.largest_speed = self.largest_speed.max(fluid.columns.velocities[k].norm());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn melting_by_conduction_alone_follows_neumann() {
        let mut cavity = Cavity::new(28, false).unwrap();
        let [first, _, _] = cavity.melted_shares().unwrap();
        // Front at 2 lambda sqrt(a t): lambda exp(lambda^2) (erf(lambda) + ..) sqrt(pi) = Ste with 1.8 degrees of warming before.
        assert!((first / neumann() - 1.0).abs() < 0.03, "{first} {}", neumann());
        assert!(cavity.melt.is_none());
    }

    /// Melted share at the first time, in a half space that starts at the temperature of the cold wall.
    fn neumann() -> f64 {
        let [warming, melting] = [LIQUIDUS - COLD, WARM - LIQUIDUS].map(|step| step / LATENT);
        let excess = |lambda: f64| {
            let scale = (-lambda * lambda).exp() / std::f64::consts::PI.sqrt();
            lambda + scale * (warming / libm::erfc(lambda) - melting / libm::erf(lambda))
        };
        let (mut low, mut high) = (0.01, 1.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if excess(middle) < 0.0 { low = middle } else { high = middle }
        }
        2.0 * low * (MELTED[0].0 / STEFAN).sqrt()
    }

    #[test]
    fn warm_melt_rises_and_melts_more_above() {
        let mut cavity = Cavity::new(28, true).unwrap();
        cavity.melted_shares().unwrap();
        let share = |low: f64, high: f64| {
            let chosen = |i: &usize| (low * HEIGHT..high * HEIGHT).contains(&cavity.positions[*i].y);
            let liquid = |i: usize| cavity.curve.liquid_fraction(cavity.enthalpies[i]);
            (0..cavity.positions.len()).filter(chosen).map(liquid).sum::<f64>()
        };
        let (above, below) = (share(0.7, 1.0), share(0.0, 0.3));
        println!("gallium: the upper three tenths hold {:.2} times the melt of the lower", above / below);
        assert!(above > 1.1 * below, "{above} {below}");
        assert!(cavity.largest_speed > 0.1, "{}", cavity.largest_speed);
    }
}
