//! Particles that are moved, whatever pulls at them.

use nalgebra::SVector;
use std::fmt;

/// Velocity \[m/s\] of a particle, by its index, at a time \[s\].
type Velocity<const D: usize> = dyn Fn(usize, f64) -> SVector<f64, D> + Send + Sync;

/// Held particles that move as they are told, and the work that this takes.
pub(super) struct Drive<const D: usize> {
    members: Vec<usize>,
    velocity: Box<Velocity<D>>,
    work: f64,
}

/// Half of a kick: from the velocities of one time to those of another, one of which is the middle of the step.
pub(super) struct HalfKick {
    /// Time that velocities are taken to \[s\].
    pub to: f64,
    /// Middle of the step \[s\].
    pub middle: f64,
    /// How long forces act \[s\].
    pub dt: f64,
}

impl<const D: usize> Drive<D> {
    /// Nobody is moved.
    pub fn none() -> Self {
        Self { members: Vec::new(), velocity: Box::new(|_, _| SVector::zeros()), work: 0.0 }
    }

    /// From now on these and no others are moved, and work is counted.
    pub fn set(
        &mut self,
        mut members: Vec<usize>,
        velocity: impl Fn(usize, f64) -> SVector<f64, D> + Send + Sync + 'static,
    ) {
        members.sort_unstable();
        members.dedup();
        *self = Self { members, velocity: Box::new(velocity), work: 0.0 };
    }

    /// Work of the drive since it was set \[J; J/m in plane strain\].
    pub fn work(&self) -> f64 {
        self.work
    }

    /// Gives the held components of the driven particles their velocities.
    ///
    /// The force of the drive is what is missing between what velocities become and what `accelerations` would make of them:
    /// its work is the change of kinetic energy less that of the other forces over the drift at mid-step.
    pub fn kick(
        &mut self,
        masses: &[f64],
        velocities: &mut [SVector<f64, D>],
        accelerations: &[SVector<f64, D>],
        free: &[SVector<f64, D>],
        half: &HalfKick,
    ) {
        for &i in &self.members {
            let held = SVector::repeat(1.0) - free[i];
            let after = (self.velocity)(i, half.to).component_mul(&held);
            let middle = (self.velocity)(i, half.middle).component_mul(&held);
            let before = velocities[i].component_mul(&held);
            let kinetic = 0.5 * (after.norm_squared() - before.norm_squared());
            self.work += masses[i] * (kinetic - accelerations[i].dot(&middle) * half.dt);
            velocities[i] += after - before;
        }
    }
}

impl<const D: usize> fmt::Debug for Drive<D> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("Drive").field("members", &self.members).finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector2;

    #[test]
    fn work_is_kinetic_energy_and_what_the_load_takes_and_free_components_are_let_alone() {
        let mut drive = Drive::none();
        drive.set(vec![0, 0], |_, time| Vector2::new(2.0 * time, 5.0));
        let (load, free, dt) = ([Vector2::new(-3.0, 7.0)], [Vector2::new(0.0, 1.0)], 0.1);
        let mut velocities = [Vector2::new(0.0, 1.0)];
        for step in 0..10 {
            let (start, middle) = (0.1 * f64::from(step), 0.1 * f64::from(step) + 0.05);
            for to in [middle, start + dt] {
                drive.kick(&[4.0], &mut velocities, &load, &free, &HalfKick { to, middle, dt: 0.5 * dt });
            }
        }
        // One second: speed 2 m/s, path 1 m against 12 N.
        assert!((velocities[0] - Vector2::new(2.0, 1.0)).norm() < 1e-12, "{velocities:?}");
        assert!((drive.work() - (0.5 * 4.0 * 4.0 + 12.0)).abs() < 1e-12, "{}", drive.work());
    }
}
