//! A step of any form allocates nothing once the columns have their size.

use nalgebra::SVector;
use sph_kernel::KernelKind;
use sph_neighbors::{PairReach, SearchMethod};
use sph_solid::benchmarks::aluminium::{ALPHA, aluminium};
use sph_solid::benchmarks::shapes::lattice;
use sph_solid::{Material, SolidPatch, SolidStart, UpdatedControls, UpdatedPatch, YieldStress};
use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Counts what the system's allocator is asked for.
struct Counting;

static COUNT: AtomicUsize = AtomicUsize::new(0);

// SAFETY: every call is passed on to the system's allocator as it came.
#[allow(unsafe_code, reason = "an allocator can be written in no other way")]
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        COUNT.fetch_add(1, Ordering::Relaxed);
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

fn find(positions: &[SVector<f64, 3>], reach: f64) -> (Vec<usize>, Vec<u32>) {
    let list = SearchMethod::default().find(positions, PairReach::Uniform(reach)).unwrap();
    (list.starts().to_vec(), list.indices().to_vec())
}

const SPACING: f64 = 1e-3;

fn yielding() -> Material {
    let yield_stress = Some(YieldStress::falling_to_zero(90e6, 293.0, 853.0).unwrap());
    Material { yield_stress, ..aluminium(ALPHA).unwrap() }
}

/// Allocations in 50 steps, after three that may bring columns to their size.
fn made(mut step: impl FnMut()) -> usize {
    (0..3).for_each(|_| step());
    let before = COUNT.load(Ordering::Relaxed);
    (0..50).for_each(|_| step());
    COUNT.load(Ordering::Relaxed) - before
}

/// One test: what others allocate meanwhile would be counted.
#[test]
fn a_step_with_yield_allocates_nothing_in_any_form() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let positions = lattice([0.0; 3], [14; 3], SPACING);
    pool.install(|| {
        let start = SolidStart::new(positions.clone(), SPACING, yielding());
        let mut patch = SolidPatch::new(start, find).unwrap();
        patch.let_meet(find);
        patch.drive(vec![0], |_, time| SVector::repeat(time));
        patch.set_temperatures(|x| 293.0 + 4e4 * x.x);
        let dt = patch.body().stable_step(0.6);
        patch.evaluate();
        assert_eq!(made(|| patch.step(dt)), 0, "total");
        assert!(patch.equivalents.iter().any(|&strain| strain > 0.0), "it yields");
        let kernel = KernelKind::WendlandC2.with_smoothing_length(1.3 * SPACING);
        for (name, controls) in [
            ("corrected", UpdatedControls::corrected(kernel, SPACING)),
            ("paper", UpdatedControls::paper(kernel, SPACING)),
        ] {
            let mut patch = UpdatedPatch::new(positions.clone(), yielding(), controls, find).unwrap();
            patch.temperatures = positions.iter().map(|x| 293.0 + 4e4 * x.x).collect();
            let dt = patch.stable_step(0.6);
            patch.evaluate(0.0);
            // Particles stay near enough for their list, which is the caller's.
            assert_eq!(made(|| patch.step(dt)), 0, "{name}");
            assert!(patch.equivalents.iter().any(|&strain| strain > 0.0), "it yields");
        }
    });
}
