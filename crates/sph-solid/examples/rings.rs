//! Two rubber rings collide, with and without artificial stress: only with it they stay whole.

#[allow(dead_code, reason = "shared with the tests, which use all of it")]
#[path = "../tests/bodies/rings.rs"]
mod rings;
#[allow(dead_code, reason = "shared with the tests, which use all of it")]
#[path = "../tests/bodies/scene.rs"]
mod scene;
#[allow(dead_code, reason = "shared with the tests, which use all of it")]
#[path = "../tests/bodies/updated_scene.rs"]
mod updated_scene;

fn main() {
    for artificial_stress in [0.3, 0.0] {
        let (pieces, momentum, rebound) = rings::rings(artificial_stress, 0.012);
        println!(
            "artificial stress {artificial_stress}: {pieces} pieces, rebound {rebound:.2} of the speed, momentum {momentum:.0e}"
        );
    }
}
