//! A step of either form allocates nothing once the columns have their size.

use nalgebra::SVector;
use sph_neighbors::{PairReach, SearchMethod};
use sph_solid::benchmarks::aluminium::{ALPHA, aluminium};
use sph_solid::benchmarks::shapes::lattice;
use sph_solid::{SolidPatch, SolidStart, YieldStress};
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

#[test]
fn a_step_with_yield_allocates_nothing() {
    let mut material = aluminium(ALPHA).unwrap();
    material.yield_stress = Some(YieldStress::falling_to_zero(90e6, 293.0, 853.0).unwrap());
    let spacing = 1e-3;
    let start = SolidStart::new(lattice([0.0; 3], [14; 3], spacing), spacing, material);
    let mut patch = SolidPatch::new(start, find).unwrap();
    patch.set_temperatures(|x| 293.0 + 4e4 * x.x);
    let dt = patch.body().stable_step(0.6);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    pool.install(|| {
        patch.run(3, dt);
        let before = COUNT.load(Ordering::Relaxed);
        (0..50).for_each(|_| patch.step(dt));
        let made = COUNT.load(Ordering::Relaxed) - before;
        assert_eq!(made, 0, "allocations in 50 steps");
    });
    assert!(patch.equivalents.iter().any(|&strain| strain > 0.0), "it yields");
}
