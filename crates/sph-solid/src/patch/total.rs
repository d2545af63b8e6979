//! A patch in the total-Lagrangian form.

use super::drive::{Drive, HalfKick};
use super::meeting::Meeting;
use super::{FindNeighbors, START_TEMPERATURE, kick, kinetic_energy, pieces};
use crate::error::{Error, require};
use crate::{
    Contact, Controls, Inelastic, Material, Motion, ReferenceColumns, SymmetricTensor, TotalLagrangian,
    pressure_wave_speed,
};
use nalgebra::{SMatrix, SVector};
use sph_kernel::{Kernel, KernelKind};

/// What a patch starts from.
#[derive(Clone, Debug)]
pub struct SolidStart<const D: usize> {
    /// Positions \[m\].
    pub positions: Vec<SVector<f64, D>>,
    /// Volumes over that of a cell \[-\]; without entries, every particle has the volume of a cell.
    pub shares: Vec<f64>,
    /// Edge of a cell \[m\].
    pub spacing: f64,
    /// Smoothing length over the spacing \[-\], of a Gaussian kernel.
    pub smoothing_ratio: f64,
    /// What the body is made of.
    pub material: Material,
    /// How its numerics are tuned.
    pub controls: Controls,
}

impl<const D: usize> SolidStart<D> {
    /// With the smoothing length, 0.8 spacings, that the default controls are for.
    #[must_use]
    pub fn new(positions: Vec<SVector<f64, D>>, spacing: f64, material: Material) -> Self {
        let shares = Vec::new();
        Self { positions, shares, spacing, smoothing_ratio: 0.8, material, controls: Controls::default() }
    }
}

/// A body with the sweep that drives it. For tests, examples and benchmarks of the crate's own laws.
///
/// Columns have one entry per particle and are the caller's to set between steps, but for the reference.
#[derive(Debug)]
pub struct SolidPatch<const D: usize> {
    /// Displacements u = x - X \[m\].
    pub displacements: Vec<SVector<f64, D>>,
    /// Velocities \[m/s\].
    pub velocities: Vec<SVector<f64, D>>,
    /// Temperatures \[K\].
    pub temperatures: Vec<f64>,
    /// Strain that gives no stress \[-\].
    pub strains: Vec<SymmetricTensor<D>>,
    /// Accumulated equivalent plastic strain \[-\].
    pub equivalents: Vec<f64>,
    /// 1 where a component moves freely, 0 where it is held.
    pub free: Vec<SVector<f64, D>>,
    /// Acceleration of all particles \[m/s^2\], as of weight.
    pub body_acceleration: SVector<f64, D>,
    /// Time since the start \[s\], which a drive is told.
    pub time: f64,
    positions: Vec<SVector<f64, D>>,
    body: TotalLagrangian<D>,
    wave_speed: f64,
    contact: Contact,
    meeting: Option<Meeting<D>>,
    drive: Drive<D>,
    /// Where particles are in the last evaluation.
    places: Vec<SVector<f64, D>>,
    accelerations: Vec<SVector<f64, D>>,
    /// Directed pairs that the two passes of one evaluation visit.
    visits: u64,
    pair_visits: u64,
    ledger: MechanicalLedger,
}

/// Where the mechanical energy of a patch is, came from and went \[J; J/m in plane strain\], in the units of the solver.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MechanicalLedger {
    /// Kinetic energy.
    pub kinetic: f64,
    /// Elastic energy.
    pub elastic: f64,
    /// Energy of the hourglass control.
    pub hourglass: f64,
    /// Energy of contact.
    pub contact: f64,
    /// Work of plastic strain since the start.
    pub plastic: f64,
    /// What the artificial viscosity took.
    pub viscous: f64,
    /// What fading velocities took ([`SolidPatch::settle`]).
    pub damped: f64,
    /// What the body acceleration brought.
    pub weight: f64,
    /// Work of what moves particles since it was set ([`SolidPatch::drive`]).
    pub driven: f64,
    /// What [`SolidPatch::set_temperatures`] brought: elastic energy of the same shape at another temperature.
    pub warmed: f64,
}

impl MechanicalLedger {
    /// Stored and taken energy less what was brought: stays, to the order of the step, while a body is stepped.
    #[must_use]
    pub fn balance(&self) -> f64 {
        let stored = self.kinetic + self.elastic + self.hourglass + self.contact;
        stored + self.plastic + self.viscous + self.damped - self.weight - self.driven - self.warmed
    }
}

impl<const D: usize> SolidPatch<D> {
    /// At rest at 293 K, without stress, free everywhere.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a spacing or a smoothing length that is not positive, and what [`TotalLagrangian::new`]
    /// refuses.
    pub fn new(start: SolidStart<D>, find: FindNeighbors<D>) -> Result<Self, Error> {
        let SolidStart { positions, shares, spacing, smoothing_ratio, material, controls } = start;
        require(spacing > 0.0, "spacing", spacing, "a positive length in metres")?;
        require(smoothing_ratio > 0.0, "smoothing_ratio", smoothing_ratio, "positive")?;
        let (particles, kernel, length) = (positions.len(), KernelKind::Gaussian, smoothing_ratio * spacing);
        // Lattices hold pairs exactly at the support's end: a little more, so that round-off does not choose among them.
        let reach = Kernel::<D>::support_radius(kernel, length) * (1.0 + 1e-9);
        let (list_starts, list_neighbors) = find(&positions, reach);
        let density = material.expansion.reference_density(START_TEMPERATURE);
        let cell = spacing.powi(D as i32);
        let volumes: Vec<f64> = match shares.len() {
            0 => vec![cell; particles],
            _ => shares.iter().map(|share| share * cell).collect(),
        };
        let temperatures = vec![START_TEMPERATURE; particles];
        let columns = ReferenceColumns {
            positions: &positions,
            volumes: &volumes,
            masses: &volumes.iter().map(|volume| density * volume).collect::<Vec<_>>(),
            temperatures: &temperatures,
            smoothing_lengths: &vec![length; particles],
            list_starts: &list_starts,
            list_neighbors: &list_neighbors,
        };
        let moduli = material.solver_moduli();
        let wave_speed = pressure_wave_speed(moduli, density);
        let contact = Contact { modulus_pa: moduli.bulk_pa() + 4.0 / 3.0 * moduli.shear_pa(), spacing };
        Ok(Self {
            body: TotalLagrangian::new(&columns, kernel, material, controls)?,
            displacements: vec![SVector::zeros(); particles],
            velocities: vec![SVector::zeros(); particles],
            strains: vec![SymmetricTensor::zero(); particles],
            equivalents: vec![0.0; particles],
            free: vec![SVector::repeat(1.0); particles],
            body_acceleration: SVector::zeros(),
            time: 0.0,
            accelerations: vec![SVector::zeros(); particles],
            visits: 2 * list_neighbors.len() as u64,
            pair_visits: 0,
            ledger: MechanicalLedger::default(),
            meeting: None,
            drive: Drive::none(),
            places: positions.clone(),
            temperatures,
            wave_speed,
            contact,
            positions,
        })
    }

    /// Reference positions X \[m\].
    #[must_use]
    pub fn positions(&self) -> &[SVector<f64, D>] {
        &self.positions
    }

    /// Positions x = X + u of the last evaluation \[m\].
    #[must_use]
    pub fn places(&self) -> &[SVector<f64, D>] {
        &self.places
    }

    /// The sweep, with masses and the deformation gradients of the last evaluation.
    #[must_use]
    pub fn body(&self) -> &TotalLagrangian<D> {
        &self.body
    }

    /// Directed pairs that the passes of strain and of forces have visited; a stored pair that serves both of its
    /// particles counts twice.
    #[must_use]
    pub fn pair_visits(&self) -> u64 {
        self.pair_visits
    }

    /// Sets displacements \[m\] and evaluates them.
    pub fn set_displacements(&mut self, displacement: impl Fn(&SVector<f64, D>) -> SVector<f64, D>) {
        self.displacements.clear();
        self.displacements.extend(self.positions.iter().map(displacement));
        self.evaluate();
    }

    /// Sets velocities \[m/s\].
    pub fn set_velocities(&mut self, velocity: impl Fn(&SVector<f64, D>) -> SVector<f64, D>) {
        self.velocities.clear();
        self.velocities.extend(self.positions.iter().map(velocity));
    }

    /// Sets temperatures \[K\] by reference position, and returns the energy that they bring \[J; J/m in plane strain\]:
    /// elastic energy of the same shape at another temperature.
    pub fn set_temperatures(&mut self, temperature: impl Fn(&SVector<f64, D>) -> f64) -> f64 {
        let before = self.elastic_energy();
        self.temperatures.clear();
        self.temperatures.extend(self.positions.iter().map(temperature));
        let brought = self.elastic_energy() - before;
        self.ledger.warmed += brought;
        brought
    }

    fn elastic_energy(&self) -> f64 {
        self.body.elastic_energy(self.positions.len(), &self.temperatures, &self.strains)
    }

    /// Holds all components of the particles that `fixed` takes.
    pub fn hold(&mut self, fixed: impl Fn(&SVector<f64, D>) -> bool) {
        for (position, free) in self.positions.iter().zip(&mut self.free) {
            if fixed(position) {
                *free = SVector::zeros();
            }
        }
    }

    /// From now on holds all components of `members` and moves them with the `velocity` \[m/s\] of a particle, by its index,
    /// at a time \[s\]; components that [`SolidPatch::free`] frees again move as forces say. A later call takes the place of
    /// this one.
    pub fn drive(
        &mut self,
        members: Vec<usize>,
        velocity: impl Fn(usize, f64) -> SVector<f64, D> + Send + Sync + 'static,
    ) {
        members.iter().for_each(|&i| self.free[i] = SVector::zeros());
        self.drive.set(members, velocity);
    }

    /// Work of what moves particles since it was set \[J; J/m in plane strain\].
    #[must_use]
    pub fn driven_work(&self) -> f64 {
        self.drive.work()
    }

    /// From now on faces that meet push each other apart ([`Contact`]): those of separate bodies, and those of one body that
    /// are more than four spacings from each other in the reference.
    pub fn let_meet(&mut self, find: FindNeighbors<D>) {
        self.meeting = Some(Meeting::new(self.contact, find));
    }

    /// Accelerations of the present columns; needed after they were set, before [`SolidPatch::step`] or
    /// [`SolidPatch::stresses`].
    pub fn evaluate(&mut self) {
        let motion = Motion {
            displacements: &self.displacements,
            velocities: &self.velocities,
            temperatures: &self.temperatures,
        };
        let mut inelastic = Inelastic { strains: &mut self.strains, equivalents: &mut self.equivalents };
        self.body.accelerations(&motion, &mut inelastic, &mut self.accelerations);
        self.accelerations.iter_mut().for_each(|acceleration| *acceleration += self.body_acceleration);
        self.places.clear();
        self.places.extend(self.positions.iter().zip(&self.displacements).map(|(x, u)| x + u));
        if let Some(meeting) = &mut self.meeting {
            meeting.accelerate(&self.places, &self.positions, self.body.masses(), &mut self.accelerations);
        }
        self.ledger.plastic += self.body.plastic_works().iter().sum::<f64>();
        self.pair_visits += self.visits;
    }

    /// One kick-drift-kick step \[s\].
    pub fn step(&mut self, dt: f64) {
        let middle = self.time + 0.5 * dt;
        self.half_kick(&HalfKick { to: middle, middle, dt: 0.5 * dt });
        for (displacement, velocity) in self.displacements.iter_mut().zip(&self.velocities) {
            *displacement += velocity * dt;
        }
        self.ledger.weight += dt * self.momentum().dot(&self.body_acceleration);
        self.evaluate();
        self.time += dt;
        self.half_kick(&HalfKick { to: self.time, middle, dt: 0.5 * dt });
        self.ledger.viscous += dt * self.body.viscous_power(&self.velocities);
    }

    fn half_kick(&mut self, half: &HalfKick) {
        let Self { body, velocities, accelerations, free, drive, .. } = self;
        kick(velocities, accelerations, free, half.dt);
        drive.kick(body.masses(), velocities, accelerations, free, half);
    }

    fn momentum(&self) -> SVector<f64, D> {
        self.body.masses().iter().zip(&self.velocities).map(|(mass, velocity)| velocity * *mass).sum()
    }

    /// Evaluates and steps `steps` times by `dt` \[s\].
    pub fn run(&mut self, steps: usize, dt: f64) {
        self.evaluate();
        (0..steps).for_each(|_| self.step(dt));
    }

    /// Relaxes a body of half size `half` \[m\] to rest: velocities fade at the rate 2 c_P/half for 16 half/c_P.
    pub fn relax(&mut self, half: f64) {
        self.settle(half, 16.0);
    }

    /// Lets a body of half size `half` \[m\] settle: velocities fade at the rate 2 c_P/half for `times` half/c_P.
    pub fn settle(&mut self, half: f64, times: f64) {
        let dt = self.body.stable_step(0.6);
        let steps = (times * half / self.wave_speed / dt).ceil() as usize;
        let kept = (-2.0 * self.wave_speed / half * dt).exp();
        self.evaluate();
        for _ in 0..steps {
            self.step(dt);
            let moving = kinetic_energy(self.body.masses(), &self.velocities);
            for (velocity, free) in self.velocities.iter_mut().zip(&self.free) {
                *velocity -= velocity.component_mul(free) * (1.0 - kept);
            }
            self.ledger.damped += moving - kinetic_energy(self.body.masses(), &self.velocities);
        }
    }

    /// Cauchy stress in true units \[Pa\].
    #[must_use]
    pub fn stresses(&self) -> Vec<SymmetricTensor<D>> {
        let mut in_plane = vec![SMatrix::zeros(); self.positions.len()];
        let mut out_of_plane = vec![0.0; self.positions.len()];
        self.body.stresses(&self.temperatures, &self.strains, &mut in_plane, &mut out_of_plane);
        let tensor = |(in_plane, out_of_plane)| SymmetricTensor { in_plane, out_of_plane };
        in_plane.into_iter().zip(out_of_plane).map(tensor).collect()
    }

    /// Kinetic, elastic and hourglass energy \[J; J/m in plane strain\].
    #[must_use]
    pub fn energies(&self) -> [f64; 3] {
        let (elastic, hourglass) = self.body.energies(&self.temperatures, &self.strains);
        [kinetic_energy(self.body.masses(), &self.velocities), elastic, hourglass]
    }

    /// Energies now, and what was taken and brought since the start. Its [`balance`](MechanicalLedger::balance) stays, but
    /// for what a caller does by setting displacements, velocities or strains.
    #[must_use]
    pub fn ledger(&self) -> MechanicalLedger {
        let [kinetic, elastic, hourglass] = self.energies();
        let contact = self.meeting.as_ref().map_or(0.0, |meeting| meeting.energy(&self.places));
        MechanicalLedger { kinetic, elastic, hourglass, contact, driven: self.driven_work(), ..self.ledger }
    }

    /// Heat \[W; W/m in plane strain\] of the present velocities by the Gough-Joule effect, one entry per particle
    /// ([`TotalLagrangian::gough_joule_heats`]).
    pub fn gough_joule_heats(&mut self, heats: &mut [f64]) {
        self.body.gough_joule_heats(&self.velocities, &self.temperatures, heats);
    }

    /// Number of pieces: particles nearer than `link` \[m\] hang together. Bodies of this form never break; what is more is
    /// stretched beyond the link, what is less touches.
    #[must_use]
    pub fn pieces(&self, link: f64, find: FindNeighbors<D>) -> usize {
        pieces(&self.places, link, find)
    }

    /// Mean of a value over the particles whose reference positions satisfy `inside`.
    #[must_use]
    pub fn mean(&self, inside: impl Fn(&SVector<f64, D>) -> bool, value: impl Fn(usize) -> f64) -> f64 {
        let chosen = (0..self.positions.len()).filter(|&i| inside(&self.positions[i]));
        let (sum, count) = chosen.fold((0.0, 0.0), |(sum, count), i| (sum + value(i), count + 1.0));
        sum / count
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::IsotropicModuli;

    #[test]
    fn bad_lengths_are_named() {
        let moduli = IsotropicModuli::from_young_and_poisson(1.0, 0.3).unwrap();
        let start = SolidStart::<2>::new(Vec::new(), 0.0, Material::elastic(moduli, 1.0).unwrap());
        let message = |start| SolidPatch::new(start, |_, _| (vec![0], vec![])).unwrap_err().to_string();
        assert_eq!(message(start.clone()), "spacing is 0, but must be a positive length in metres");
        let start = SolidStart { spacing: 1.0, smoothing_ratio: -1.0, ..start };
        assert_eq!(message(start), "smoothing_ratio is -1, but must be positive");
    }
}
