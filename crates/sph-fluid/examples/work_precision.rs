//! Work and precision of the melt: flows whose answer is known, with one choice of the scheme changed at a time.
//!
//! `cargo run -p sph-fluid --example work_precision -- kernel` prints a table for the choice of the kernel; others are `smoothing`,
//! `diffusion`, `renewal`, `surface`, `sound` and `resolution`. Errors are in per cent, the capillary number of what moves in a drop at
//! rest in ten-thousandths; a flow that breaks up says so. Steps, directed pairs and processor seconds are those of all flows of a
//! row that ended. The first row is what each scene takes by itself.

#[path = "../tests/surface/patch.rs"]
mod patch;
mod processor;

use patch::find;
use processor::processor_seconds;
use sph_fluid::benchmarks::drop::{RESTING_VISCOSITY, SMALL, drop_at_rest, swinging_drop};
use sph_fluid::benchmarks::layer::{CLOSED_SCHEME, ClosedLayer, SLOPE, film, return_flow};
use sph_fluid::benchmarks::vortices::vortices;
use sph_fluid::benchmarks::{Scheme, drop, layer, vortices};
use sph_fluid::{Error, FluidPatch, Renewal, SurfaceModel};
use sph_kernel::{KernelKind, Shape};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Errors of a flow, as they are printed, and its cost.
struct Found {
    errors: Vec<f64>,
    steps: u64,
    pairs: u64,
}

impl Found {
    fn of(errors: Vec<f64>, patch: &FluidPatch<2>) -> Self {
        Self { errors, steps: patch.steps(), pairs: patch.pair_visits() }
    }
}

/// A flow whose answer is known.
struct Flow {
    columns: &'static [&'static str],
    own: Scheme,
    /// Speed that sound must be fast against; none where it is not varied.
    speed: Option<f64>,
    /// Runs it with so many times its usual particles along an edge.
    run: fn(f64, Scheme) -> Result<Found, Error>,
    has_surface: bool,
    /// Whether it is left out where neither surface nor renewal is varied: it takes as long as all others.
    slow: bool,
}

fn per_cent(ratio: f64) -> f64 {
    100.0 * (ratio - 1.0).abs()
}

fn times(count: usize, refinement: f64) -> usize {
    (count as f64 * refinement).round() as usize
}

const FLOWS: [Flow; 6] = [
    Flow {
        columns: &["drop at rest, p", "its Ca"],
        own: drop::SCHEME,
        speed: Some(1.0),
        run: |refinement, scheme| {
            let rest = drop_at_rest(times(8, refinement), 4.0, scheme, find)?;
            let capillary = 1e4 * RESTING_VISCOSITY * rest.largest_speed;
            Ok(Found::of(vec![per_cent(rest.pressure), capillary], &rest.patch))
        },
        has_surface: true,
        slow: false,
    },
    Flow {
        columns: &["swinging drop"],
        own: drop::SCHEME,
        speed: Some(1.0),
        run: |refinement, scheme| {
            let swing = swinging_drop(times(10, refinement), SMALL, scheme, find)?;
            Ok(Found::of(vec![per_cent(swing.period())], &swing.patch))
        },
        has_surface: true,
        slow: false,
    },
    Flow {
        columns: &["vortices"],
        own: vortices::SCHEME,
        speed: Some(1.0),
        run: |refinement, scheme| {
            let found = vortices(times(25, refinement), scheme, find)?;
            Ok(Found::of(vec![100.0 * found.speed_error], &found.patch))
        },
        has_surface: false,
        slow: false,
    },
    Flow {
        columns: &["film"],
        own: layer::SCHEME,
        speed: Some(-SLOPE),
        run: |refinement, scheme| {
            let (speed, patch) = film(times(8, refinement), scheme, find)?;
            Ok(Found::of(vec![per_cent(speed)], &patch))
        },
        has_surface: true,
        slow: false,
    },
    Flow {
        columns: &["return flow"],
        own: layer::SCHEME,
        speed: Some(-SLOPE),
        run: |refinement, scheme| {
            let (speed, _, patch) = return_flow(times(8, refinement), scheme, find)?;
            Ok(Found::of(vec![per_cent(speed)], &patch))
        },
        has_surface: true,
        slow: false,
    },
    Flow {
        columns: &["closed layer, u", "its field"],
        own: CLOSED_SCHEME,
        speed: None,
        run: |refinement, scheme| {
            let mut closed = ClosedLayer::new(times(8, refinement), scheme, find)?;
            closed.run_to(28.0);
            let (speed, field) = closed.middle();
            Ok(Found::of(vec![per_cent(speed), 100.0 * field], &closed.patch))
        },
        has_surface: true,
        slow: true,
    },
];

type Choice = Box<dyn Fn(&Flow) -> Option<Scheme> + Send + Sync>;

/// One row: its name, how much finer, and what it makes of a flow's own scheme; `None` where it says nothing about the flow.
struct Setting {
    name: String,
    refinement: f64,
    scheme: Choice,
}

fn setting(
    name: impl Into<String>,
    scheme: impl Fn(&Flow) -> Option<Scheme> + Send + Sync + 'static,
) -> Setting {
    Setting { name: name.into(), refinement: 1.0, scheme: Box::new(scheme) }
}

/// What each flow takes by itself.
fn own() -> Setting {
    setting("own", |flow| Some(flow.own))
}

/// The same settings without the flow that is slow.
fn quick(settings: Vec<Setting>) -> Vec<Setting> {
    let without = |setting: Setting| Setting {
        scheme: Box::new(move |flow| if flow.slow { None } else { (setting.scheme)(flow) }),
        ..setting
    };
    settings.into_iter().map(without).collect()
}

/// Kernels with the support that a flow has, and with a third more.
fn kernels() -> Vec<Setting> {
    let of = |kernel: KernelKind, wider: f64, name: &str| {
        setting(format!("{kernel}{name}"), move |flow| {
            let smoothing = wider * flow.own.smoothing * flow.own.kernel.support() / kernel.support();
            Some(Scheme { kernel, smoothing, ..flow.own })
        })
    };
    let others = KernelKind::ALL.into_iter().filter(|&kernel| kernel != KernelKind::WendlandC2);
    let same = others.map(|kernel| of(kernel, 1.0, ", same support"));
    let wider = KernelKind::ALL.into_iter().map(|kernel| of(kernel, 4.0 / 3.0, ", support x 4/3"));
    std::iter::once(own()).chain(same).chain(wider).collect()
}

fn smoothing() -> Vec<Setting> {
    let of = |smoothing: f64| {
        setting(format!("h/dx {smoothing}"), move |flow| Some(Scheme { smoothing, ..flow.own }))
    };
    std::iter::once(own()).chain([1.2, 1.3, 1.5, 1.8, 2.0].map(of)).collect()
}

fn diffusion() -> Vec<Setting> {
    let of = |density_diffusion: f64| {
        setting(format!("delta {density_diffusion}"), move |flow| {
            Some(Scheme { density_diffusion, ..flow.own })
        })
    };
    std::iter::once(own()).chain([0.0, 0.05, 0.2].map(of)).collect()
}

fn renewal() -> Vec<Setting> {
    let of = |(name, renewal): (&str, Option<Renewal>)| {
        setting(name, move |flow| Some(Scheme { renewal, ..flow.own }))
    };
    let strength = |shifting, density_pull| Some(Renewal { shifting, density_pull });
    let choices = [
        ("none", None),
        ("density pull", strength(0.0, 0.005)),
        ("shifting S 3", strength(3.0, 0.0)),
        ("density pull, S 3", strength(3.0, 0.005)),
        ("density pull, S 10", strength(10.0, 0.005)),
    ];
    std::iter::once(own()).chain(choices.map(of)).collect()
}

fn surface() -> Vec<Setting> {
    let of = |(name, surface_model, corrected_gradients, shifted): (&str, SurfaceModel, bool, bool)| {
        setting(name, move |flow| {
            let renewal = if shifted { Some(Renewal::default()) } else { flow.own.renewal };
            let scheme = Scheme { surface_model, corrected_gradients, renewal, ..flow.own };
            flow.has_surface.then_some(scheme)
        })
    };
    let choices = [
        ("force, plain gradients", SurfaceModel::Force, false, false),
        ("force, corrected gradients", SurfaceModel::Force, true, false),
        ("stress, plain gradients", SurfaceModel::Stress, false, false),
        ("stress, corrected gradients", SurfaceModel::Stress, true, false),
        ("stress, plain gradients, S 3", SurfaceModel::Stress, false, true),
    ];
    let own = setting("own", |flow| flow.has_surface.then_some(flow.own));
    std::iter::once(own).chain(choices.map(of)).collect()
}

fn sound() -> Vec<Setting> {
    let of = |ratio: f64| {
        setting(format!("c/v {ratio}"), move |flow| {
            flow.speed.map(|speed| Scheme { sound_speed: ratio * speed, ..flow.own })
        })
    };
    let own = setting("own", |flow| flow.speed.map(|_| flow.own));
    std::iter::once(own).chain([10.0, 20.0, 40.0, 100.0].map(of)).collect()
}

fn resolution() -> Vec<Setting> {
    let of = |refinement: f64| Setting { refinement, name: format!("particles x {refinement}"), ..own() };
    std::iter::once(own()).chain([0.75, 1.5].map(of)).collect()
}

/// The cells of a flow in a row, with its cost; none where it is not run or breaks up.
fn cells(flow: &Flow, setting: &Setting) -> (Vec<String>, Option<Found>) {
    let Some(scheme) = (setting.scheme)(flow) else { return (vec![String::new(); flow.columns.len()], None) };
    // Particles that have left the numbers have no neighbours, and the search says so in its way.
    let found = catch_unwind(AssertUnwindSafe(|| (flow.run)(setting.refinement, scheme)));
    let found =
        found.ok().and_then(Result::ok).filter(|found| found.errors.iter().all(|error| error.is_finite()));
    match found {
        Some(found) => (found.errors.iter().map(|error| format!("{error:.2}")).collect(), Some(found)),
        None => (vec!["broke".into(); flow.columns.len()], None),
    }
}

fn print_row(setting: &Setting) {
    let before = processor_seconds();
    let flows: Vec<_> = FLOWS.iter().map(|flow| cells(flow, setting)).collect();
    let spent = processor_seconds() - before;
    let texts: Vec<&str> = flows.iter().flat_map(|(cells, _)| cells).map(String::as_str).collect();
    let ended = || flows.iter().filter_map(|(_, found)| found.as_ref());
    let (steps, pairs) =
        (ended().map(|found| found.steps).sum::<u64>(), ended().map(|found| found.pairs).sum::<u64>());
    println!(
        "| {} | {} | {steps} | {:.1} | {spent:.1} |",
        setting.name,
        texts.join(" | "),
        1e-6 * pairs as f64
    );
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let axes = "kernel, smoothing, diffusion, renewal, surface, sound or resolution";
    let Some(axis) = std::env::args().nth(1) else {
        println!("give one of {axes}: each takes minutes");
        return Ok(());
    };
    let settings = match axis.as_str() {
        "kernel" => quick(kernels()),
        "smoothing" => quick(smoothing()),
        "diffusion" => quick(diffusion()),
        "renewal" => renewal(),
        "surface" => surface(),
        "sound" => sound(),
        "resolution" => quick(resolution()),
        other => return Err(format!("found `{other}`; accepted: {axes}").into()),
    };
    std::panic::set_hook(Box::new(|_| ()));
    let columns: Vec<&str> = FLOWS.iter().flat_map(|flow| flow.columns).copied().collect();
    println!("| {axis} | {} | steps | pairs, millions | cpu s |", columns.join(" | "));
    println!("|{}", "---|".repeat(columns.len() + 4));
    // Inside the pool: from outside each sweep would wait for a thread to wake up.
    rayon::scope(|_| settings.iter().for_each(print_row));
    Ok(())
}
