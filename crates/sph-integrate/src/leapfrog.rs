//! Leapfrog in kick-drift-kick form, order 2, for motion under forces that depend on position.

/// Advances positions and velocities by one kick-drift-kick step (velocity Verlet; Swope et al. 1982).
///
/// On entry `acceleration` holds that of `position`; on return it holds that of the new positions, so that
/// one evaluation a step is enough. `accelerate(position, acceleration)` writes the accelerations. The step
/// is symplectic and reversible if they depend on the positions only.
pub fn leapfrog_step(
    position: &mut [f64],
    velocity: &mut [f64],
    acceleration: &mut [f64],
    dt_s: f64,
    mut accelerate: impl FnMut(&[f64], &mut [f64]),
) {
    kick(velocity, acceleration, 0.5 * dt_s);
    for i in 0..position.len() {
        position[i] += dt_s * velocity[i];
    }
    accelerate(position, acceleration);
    kick(velocity, acceleration, 0.5 * dt_s);
}

/// Adds the accelerations over `dt_s` to the velocities.
fn kick(velocity: &mut [f64], acceleration: &[f64], dt_s: f64) {
    for i in 0..velocity.len() {
        velocity[i] += dt_s * acceleration[i];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A planar orbit about a unit mass: eccentric, nonlinear.
    fn gravity(position: &[f64], acceleration: &mut [f64]) {
        let cube = position[0].hypot(position[1]).powi(3);
        acceleration[0] = -position[0] / cube;
        acceleration[1] = -position[1] / cube;
    }

    fn spring(position: &[f64], acceleration: &mut [f64]) {
        acceleration[0] = -position[0];
    }

    fn orbit(steps: i32, dt_s: f64, state: &mut [[f64; 2]; 2]) {
        let [position, velocity] = state;
        let mut acceleration = [0.0; 2];
        gravity(position, &mut acceleration);
        for _ in 0..steps {
            leapfrog_step(position, velocity, &mut acceleration, dt_s, gravity);
        }
    }

    #[test]
    fn order_two() {
        let at_end = |steps: i32| {
            let mut state = [[1.0, 0.0], [0.0, 1.1]];
            orbit(steps, 2.0 / f64::from(steps), &mut state);
            state[0]
        };
        let (coarse, middle, fine) = (at_end(100), at_end(200), at_end(400));
        let distance = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
        let order = (distance(coarse, middle) / distance(middle, fine)).log2();
        assert!((order - 2.0).abs() < 0.1, "{order}");
    }

    #[test]
    fn reversible() {
        let start = [[1.0, 0.0], [0.0, 1.1]];
        let mut state = start;
        orbit(1000, 0.01, &mut state);
        assert!((state[0][0] - 1.0).abs() > 0.1, "it has moved");
        state[1] = state[1].map(|speed| -speed);
        orbit(1000, 0.01, &mut state);
        for k in 0..2 {
            assert!((state[0][k] - start[0][k]).abs() < 1e-11 && (state[1][k] + start[1][k]).abs() < 1e-11);
        }
    }

    #[test]
    fn energy_of_an_oscillator_stays_within_its_bound() {
        // The scheme keeps v^2 + (1 - dt^2/4) x^2 exactly, so that v^2 + x^2 stays below 1/(1 - dt^2/4) from
        // rest.
        let (mut x, mut v, mut a, dt_s) = ([1.0], [0.0], [-1.0], 0.1);
        let mut range = [f64::INFINITY, 0.0_f64];
        for _ in 0..100_000 {
            leapfrog_step(&mut x, &mut v, &mut a, dt_s, spring);
            let energy: f64 = v[0] * v[0] + x[0] * x[0];
            range = [range[0].min(energy), range[1].max(energy)];
        }
        let low = 1.0 - 0.25 * dt_s * dt_s;
        assert!(range[0] > low - 1e-9 && range[0] < low + 1e-6, "{range:?}");
        assert!(range[1] > 1.0 - 1e-6 && range[1] < 1.0 + 1e-9, "{range:?}");
    }
}
