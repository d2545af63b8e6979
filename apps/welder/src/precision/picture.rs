//! The pictures of a ladder: error against cost for each quantity, and error against spacing for the defaults.

use super::Point;
use super::estimate::{self, Estimate};
use super::quantity::{Errors, QUANTITIES, Quantity};
use super::settings;
use crate::observe::ObserveError;
use crate::observe::scatter_picture::{Series, draw_scatter};
use std::path::Path;

type Cost = fn(&Point) -> f64;

/// Draws the error of each quantity against processor time and against particles.
pub(super) fn draw(folder: &Path, name: &str, points: &[Point]) -> Result<(), ObserveError> {
    let costs: [(&str, &str, Cost); 2] =
        [("cpu", "processor time, s", |p| p.cpu_s), ("particles", "particles", |p| p.particles as f64)];
    for quantity in &QUANTITIES {
        for (stem, label, cost) in costs {
            let names = estimate::names(points).into_iter();
            let series: Vec<_> = names.map(|name| line(name.into(), points, cost, quantity.error)).collect();
            let title = format!("{name}: error in {}", quantity.name);
            let path = folder.join(format!("precision_{}_{stem}.png", quantity.name));
            draw_scatter(&path, &title, (label, "error, %"), &series)?;
        }
    }
    Ok(())
}

fn line(name: String, points: &[Point], cost: Cost, error: fn(&Errors) -> f64) -> Series {
    let own = points.iter().filter(|point| point.setting == name);
    let points = own.map(|p| (cost(p), 100.0 * error(&p.errors).abs())).collect();
    Series { name, points }
}

/// Draws how far each run with the steps of the reference is from the extrapolated value of its quantity, against the spacing. A straight line of
/// slope two is what the scheme promises; a quantity without an extrapolated value has no line.
pub(super) fn draw_convergence(
    folder: &Path,
    name: &str,
    points: &[Point],
    estimates: &[Estimate],
) -> Result<(), ObserveError> {
    let series: Vec<_> = QUANTITIES.iter().map(|quantity| distance(quantity, points, estimates)).collect();
    let title = format!("{name}: distance to the extrapolated value");
    let path = folder.join("precision_convergence.png");
    draw_scatter(&path, &title, ("spacing, um", "distance, %"), &series)
}

fn distance(quantity: &Quantity, points: &[Point], estimates: &[Estimate]) -> Series {
    let own = estimates.iter().find(|e| e.setting == settings::TIGHT && e.quantity == quantity.name);
    let limit = own.and_then(|estimate| estimate.convergence.extrapolated);
    let order = own.and_then(|estimate| estimate.convergence.order);
    let runs = points.iter().filter(|point| point.setting == settings::TIGHT);
    let place = |point: &Point, limit: f64| {
        (1e6 * point.spacing_m, 100.0 * (quantity.scale * (quantity.of)(&point.sizes) / limit - 1.0).abs())
    };
    let points = limit.map_or_else(Vec::new, |limit| runs.map(|point| place(point, limit)).collect());
    let order = order.map_or_else(|| "no order".into(), |order| format!("order {order:.2}"));
    Series { name: format!("{}, {order}", quantity.name), points }
}
