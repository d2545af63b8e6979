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
    println!("poisson  speed/c0  artificial stress  pieces  rebound  momentum");
    for (poisson, speed, artificial_stress) in [
        (0.4, 0.059, 0.3),
        (0.4, 0.059, 0.0),
        (0.3975, 0.06, 0.3),
        (0.3975, 0.12, 0.3),
        (0.47, 0.06, 0.3),
        (0.47, 0.12, 0.3),
    ] {
        let end = rings::collide(&rings::Rings { poisson, speed, artificial_stress });
        println!(
            "{poisson:7}  {speed:8}  {artificial_stress:17}  {:6}  {:7.2}  {:.0e}",
            end.pieces, end.rebound, end.momentum
        );
    }
}
