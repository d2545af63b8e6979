//! What a run may take: particles and memory before it is built, steps while it goes on.

use crate::build::LevelPlan;
use crate::case::memory;
use crate::case::scene::Scene;
use crate::check::bytes_per_particle;

/// The limits of a scene and of the machine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Limits {
    particles: u64,
    bytes_per_particle: f64,
    /// Bytes, and who says so.
    memory: Option<(f64, &'static str)>,
    pub(crate) steps: u64,
}

impl Limits {
    /// What the budget of `scene` and the free memory allow.
    pub(crate) fn of(scene: &Scene) -> Self {
        let budget = &scene.budget;
        Self {
            particles: budget.max_particles,
            bytes_per_particle: bytes_per_particle(scene),
            memory: memory(&scene.budget),
            steps: budget.max_steps,
        }
    }

    /// Refuses a plan that is too large, in words.
    pub(crate) fn refuse(&self, plan: &LevelPlan<3>) -> Option<String> {
        // The cells of the finest box are known at once; there can be too many to count the rest.
        let finest: f64 = plan.finest_box().counts().map(|count| count as f64).iter().product();
        let particles = if finest > self.particles as f64 { finest } else { plan.count() as f64 };
        if particles > self.particles as f64 {
            return Some(format!(
                "takes {particles:.2e} particles, beyond budget.max_particles = {}",
                self.particles
            ));
        }
        let wanted = particles * self.bytes_per_particle;
        let (bytes, origin) = self.memory.filter(|(bytes, _)| wanted > *bytes)?;
        Some(format!("takes {particles:.2e} particles and {wanted:.2e} bytes, beyond {origin} ({bytes:.2e})"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::CellBox;

    #[test]
    fn what_is_too_large_is_refused_without_counting_it() {
        let limits =
            Limits { particles: 1000, bytes_per_particle: 1850.0, memory: Some((1e6, "a test")), steps: 1 };
        assert_eq!(limits.refuse(&LevelPlan::uniform([5, 10, 10])), None);
        assert!(limits.refuse(&LevelPlan::uniform([6, 10, 10])).unwrap().contains("beyond a test"));
        assert!(limits.refuse(&LevelPlan::uniform([11, 10, 10])).unwrap().contains("max_particles = 1000"));
        let huge = LevelPlan::around([1 << 20; 3], CellBox { low: [0; 3], high: [1 << 15; 3] });
        assert!(limits.refuse(&huge).unwrap().contains("3.52e13 particles"), "{:?}", limits.refuse(&huge));
    }
}
