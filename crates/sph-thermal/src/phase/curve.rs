//! The enthalpy curve: temperature, liquid fraction and Kirchhoff potential from specific enthalpy.
//!
//! State is the specific enthalpy h \[J/kg\], zero at 0 K. With c_m = (c_s + c_l)/2 the curve of this project is
//!
//! ```text
//! h_s = int_0^T_s c_s dT          h_l = h_s + c_m (T_l - T_s) + H_f
//! T piecewise linear through (h_s, T_s), (h_l, T_l), slopes 1/c_s below and 1/c_l above
//! f = clamp((h - h_s)/(h_l - h_s), 0, 1)
//! ```
//!
//! which is continuous and monotone for all positive inputs. The curve of Hu and Eberhard (2015, eq. 20-21) jumps at
//! T_s unless c_s T_s = c_l T_l; it is here under its own name, with the size of its jump.
//!
//! The Kirchhoff potential is theta(T) = int_{T_s}^T k dT \[W/m\]: with it, the flux between two particles of one
//! material is linear in theta whatever k(T) is.

use super::ThermalMaterial;
use crate::error::Error;

/// How far a heat capacity may change over one linear piece of the curve; the curve is exact at the ends of each.
const HEAT_CAPACITY_CHANGE_PER_PIECE: f64 = 0.0025;

/// Pieces up to which selecting among all is faster than looking one up.
const MOST_SELECTED_PIECES: usize = 12;

/// The bend of temperature where the paper's curve meets its own mushy branch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TemperatureJump {
    /// Temperature just above the solidus enthalpy minus the one just below it \[K\].
    pub at_solidus_k: f64,
    /// Heat taken up between T_s and T_l in excess of the latent heat, as a fraction of it.
    pub excess_latent_heat: f64,
}

/// One piece: T is linear and theta quadratic in h from `enthalpy` to the next piece's start.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Piece {
    enthalpy: f64,
    temperature: f64,
    /// dT/dh \[K kg/J\].
    slope: f64,
    potential: f64,
    /// First and second coefficient of theta in (h - enthalpy).
    linear: f64,
    quadratic: f64,
}

/// Temperature, liquid fraction and Kirchhoff potential of one material over specific enthalpy.
#[derive(Debug, Clone, PartialEq)]
pub struct EnthalpyCurve {
    pieces: Vec<Piece>,
    enthalpy_solidus: f64,
    enthalpy_liquidus: f64,
    /// For each bucket of equal width from the first to the last piece: the piece at the bucket's start.
    buckets: Vec<u16>,
    buckets_per_joule: f64,
    largest_slope: f64,
    jump: Option<TemperatureJump>,
}

impl EnthalpyCurve {
    /// The continuous curve of this project (see the module).
    ///
    /// # Errors
    /// What [`ThermalMaterial::validate`] refuses.
    pub fn continuous(material: &ThermalMaterial) -> Result<Self, Error> {
        material.validate()?;
        let (solidus, liquidus) = (material.solidus, material.liquidus);
        let mut nodes = vec![(0.0, 0.0)];
        extend_branch(&mut nodes, solidus, &material.heat_capacity_solid);
        let enthalpy_solidus = nodes[nodes.len() - 1].0;
        let mean_capacity =
            0.5 * (material.heat_capacity_solid.at(solidus) + material.heat_capacity_liquid.at(liquidus));
        let enthalpy_liquidus =
            enthalpy_solidus + mean_capacity * (liquidus - solidus) + material.latent_heat;
        nodes.push((enthalpy_liquidus, liquidus));
        let last = material.heat_capacity_liquid.node_temperatures(liquidus, f64::INFINITY).last();
        let last = last.unwrap_or(liquidus);
        if last > liquidus {
            extend_branch(&mut nodes, last, &material.heat_capacity_liquid);
        }
        let lines = nodes.windows(2).map(|w| (w[0], w[1])).collect();
        let end_slope = 1.0 / material.heat_capacity_liquid.at(last);
        Ok(Self::from_lines(material, lines, end_slope, (enthalpy_solidus, enthalpy_liquidus), None))
    }

    /// The curve of Hu and Eberhard (2015, eq. 20-21), with c_s and c_l taken at T_s and T_l.
    ///
    /// Its temperature jumps at h = c_s T_s; [`temperature_jump`](Self::temperature_jump) says by how much.
    ///
    /// # Errors
    /// What [`ThermalMaterial::validate`] refuses.
    pub fn hu_eberhard_2015(material: &ThermalMaterial) -> Result<Self, Error> {
        material.validate()?;
        let (solidus, liquidus) = (material.solidus, material.liquidus);
        let solid = material.heat_capacity_solid.at(solidus);
        let liquid = material.heat_capacity_liquid.at(liquidus);
        let intermediate = liquid * liquidus / solidus;
        let latent_slope = material.latent_heat / (liquidus - solidus);
        let (h_solid, h_liquid) = (solid * solidus, intermediate * liquidus + material.latent_heat);
        let after = (h_solid + latent_slope * solidus) / (intermediate + latent_slope);
        let lines = vec![((0.0, 0.0), (h_solid, solidus)), ((h_solid, after), (h_liquid, liquidus))];
        let sensible = 0.5 * (solid + liquid) * (liquidus - solidus);
        let taken_up = h_liquid - h_solid - sensible;
        let jump = TemperatureJump {
            at_solidus_k: after - solidus,
            excess_latent_heat: taken_up / material.latent_heat - 1.0,
        };
        Ok(Self::from_lines(material, lines, 1.0 / liquid, (h_solid, h_liquid), Some(jump)))
    }

    /// How far the paper's curve jumps; `None` for the continuous curve.
    pub fn temperature_jump(&self) -> Option<TemperatureJump> {
        self.jump
    }

    /// Enthalpy at which melting begins \[J/kg\].
    pub fn enthalpy_solidus(&self) -> f64 {
        self.enthalpy_solidus
    }

    /// Enthalpy at which melting ends \[J/kg\].
    pub fn enthalpy_liquidus(&self) -> f64 {
        self.enthalpy_liquidus
    }

    /// Temperature \[K\] of a specific enthalpy \[J/kg\].
    #[inline]
    pub fn temperature(&self, enthalpy: f64) -> f64 {
        let piece = &self.pieces[self.piece_of(enthalpy)];
        piece.temperature + piece.slope * (enthalpy - piece.enthalpy)
    }

    /// Kirchhoff potential \[W/m\] of a specific enthalpy \[J/kg\]; zero at the solidus.
    #[inline]
    pub fn potential(&self, enthalpy: f64) -> f64 {
        let piece = &self.pieces[self.piece_of(enthalpy)];
        let over = enthalpy - piece.enthalpy;
        piece.potential + over * (piece.linear + over * piece.quadratic)
    }

    /// [`potential`](Self::potential) of several enthalpies at once: with few pieces, by selection instead of look-up,
    /// which compilers turn into vector code.
    #[inline]
    pub fn potentials<const N: usize>(&self, enthalpy: &[f64; N]) -> [f64; N] {
        if self.pieces.len() > MOST_SELECTED_PIECES {
            return enthalpy.map(|enthalpy| self.potential(enthalpy));
        }
        let first = &self.pieces[0];
        let mut start = [first.enthalpy; N];
        let mut constant = [first.potential; N];
        let mut linear = [first.linear; N];
        let mut quadratic = [first.quadratic; N];
        for piece in &self.pieces[1..] {
            for lane in 0..N {
                let here = enthalpy[lane] >= piece.enthalpy;
                start[lane] = if here { piece.enthalpy } else { start[lane] };
                constant[lane] = if here { piece.potential } else { constant[lane] };
                linear[lane] = if here { piece.linear } else { linear[lane] };
                quadratic[lane] = if here { piece.quadratic } else { quadratic[lane] };
            }
        }
        let mut potential = [0.0; N];
        for lane in 0..N {
            let over = enthalpy[lane] - start[lane];
            potential[lane] = constant[lane] + over * (linear[lane] + over * quadratic[lane]);
        }
        potential
    }

    /// Conductivity \[W/(m K)\] at a specific enthalpy \[J/kg\].
    #[inline]
    pub fn conductivity(&self, enthalpy: f64) -> f64 {
        let piece = &self.pieces[self.piece_of(enthalpy)];
        (piece.linear + 2.0 * piece.quadratic * (enthalpy - piece.enthalpy)) / piece.slope
    }

    /// Share of liquid, 0 to 1, at a specific enthalpy \[J/kg\].
    #[inline]
    pub fn liquid_fraction(&self, enthalpy: f64) -> f64 {
        ((enthalpy - self.enthalpy_solidus) / (self.enthalpy_liquidus - self.enthalpy_solidus))
            .clamp(0.0, 1.0)
    }

    /// Specific enthalpy \[J/kg\] at a temperature \[K\]; the lowest one where the paper's curve has several.
    pub fn enthalpy_at(&self, temperature: f64) -> f64 {
        let last = self.pieces.len() - 1;
        let found = (0..last).find(|&i| {
            let (piece, next) = (&self.pieces[i], self.pieces[i + 1].enthalpy);
            piece.temperature + piece.slope * (next - piece.enthalpy) >= temperature
        });
        let piece = &self.pieces[found.unwrap_or(last)];
        piece.enthalpy + (temperature - piece.temperature) / piece.slope
    }

    /// Kirchhoff potential \[W/m\] at a temperature \[K\].
    pub fn potential_at(&self, temperature: f64) -> f64 {
        self.potential(self.enthalpy_at(temperature))
    }

    /// Temperature \[K\] at a Kirchhoff potential \[W/m\]: the inverse of [`potential_at`](Self::potential_at).
    pub fn temperature_at_potential(&self, potential: f64) -> f64 {
        let piece = &self.pieces[self.pieces.partition_point(|p| p.potential <= potential).max(1) - 1];
        let over = potential - piece.potential;
        // The stable root of quadratic * x^2 + linear * x = over.
        let root = (piece.linear * piece.linear + 4.0 * piece.quadratic * over).max(0.0).sqrt();
        piece.temperature + piece.slope * 2.0 * over / (piece.linear + root)
    }

    /// Largest d(theta)/dh = k/c \[kg/(m s)\] of the curve up to a temperature \[K\]: what bounds an explicit step.
    pub fn largest_potential_slope(&self) -> f64 {
        self.largest_slope
    }

    /// Largest dT/dh = 1/c \[kg K/J\] of the curve.
    pub fn largest_temperature_slope(&self) -> f64 {
        self.pieces.iter().map(|piece| piece.slope).fold(0.0, f64::max)
    }

    #[inline]
    fn piece_of(&self, enthalpy: f64) -> usize {
        let last = self.buckets.len() - 1;
        let bucket = ((enthalpy - self.pieces[0].enthalpy) * self.buckets_per_joule).max(0.0) as usize;
        let mut piece = self.buckets[bucket.min(last)] as usize;
        while piece + 1 < self.pieces.len() && enthalpy >= self.pieces[piece + 1].enthalpy {
            piece += 1;
        }
        piece
    }

    /// Builds the pieces from straight lines ((h, T), (h, T)) of T(h), cut where the conductivity bends.
    fn from_lines(
        material: &ThermalMaterial,
        lines: Vec<((f64, f64), (f64, f64))>,
        end_slope: f64,
        (enthalpy_solidus, enthalpy_liquidus): (f64, f64),
        jump: Option<TemperatureJump>,
    ) -> Self {
        let nodes = material.conductivity_nodes();
        let mut pieces = Vec::new();
        for &((h0, t0), (h1, t1)) in &lines {
            let slope = (t1 - t0) / (h1 - h0);
            let cuts = nodes.iter().copied().filter(|&t| t > t0 && t < t1);
            for t in std::iter::once(t0).chain(cuts) {
                pieces.push(piece(material, h0 + (t - t0) / slope, t, slope));
            }
        }
        let &(_, (h_end, t_end)) = lines.last().expect("a curve has at least one line");
        let cuts = nodes.iter().copied().filter(|&t| t > t_end);
        for t in std::iter::once(t_end).chain(cuts) {
            pieces.push(piece(material, h_end + (t - t_end) / end_slope, t, end_slope));
        }
        close_pieces(material, &mut pieces);
        let (buckets, buckets_per_joule) = bucket_table(&pieces);
        let largest_slope = largest_slope(&pieces);
        Self { pieces, enthalpy_solidus, enthalpy_liquidus, buckets, buckets_per_joule, largest_slope, jump }
    }
}

/// Adds nodes (h, T) of a branch with capacity c(T) up to `end`, h exact at each node.
fn extend_branch(nodes: &mut Vec<(f64, f64)>, end: f64, capacity: &super::Table) {
    let start = nodes[nodes.len() - 1].1;
    let stops: Vec<f64> = capacity.node_temperatures(start, end).chain(std::iter::once(end)).collect();
    for stop in stops {
        let &(h0, t0) = nodes.last().expect("starts with a node");
        let (c0, c1) = (capacity.at(t0), capacity.at(stop));
        let parts = ((c1 - c0).abs() / (HEAT_CAPACITY_CHANGE_PER_PIECE * c0.min(c1))).ceil().max(1.0);
        for part in 1..=parts as usize {
            let over = (stop - t0) * part as f64 / parts;
            let mean = c0 + 0.5 * (c1 - c0) * part as f64 / parts;
            nodes.push((h0 + mean * over, t0 + over));
        }
    }
}

/// A piece that starts at (h, T); its potential is filled in by [`close_pieces`].
fn piece(material: &ThermalMaterial, enthalpy: f64, temperature: f64, slope: f64) -> Piece {
    let linear = material.conductivity(temperature) * slope;
    Piece { enthalpy, temperature, slope, potential: 0.0, linear, quadratic: 0.0 }
}

/// Integrates k over temperature through all pieces, and shifts the potential to zero at the solidus.
fn close_pieces(material: &ThermalMaterial, pieces: &mut [Piece]) {
    let potential_between = |t0: f64, t1: f64| {
        let mut stops = vec![t0];
        stops.extend(material.conductivity_nodes().into_iter().filter(|&t| t > t0.min(t1) && t < t0.max(t1)));
        stops.push(t1);
        if t1 < t0 {
            let inner = stops.len() - 1;
            stops[1..inner].reverse();
        }
        let trapezoid =
            |w: &[f64]| 0.5 * (material.conductivity(w[0]) + material.conductivity(w[1])) * (w[1] - w[0]);
        stops.windows(2).map(trapezoid).sum::<f64>()
    };
    for i in 0..pieces.len() {
        pieces[i].potential = potential_between(material.solidus, pieces[i].temperature);
        if i + 1 < pieces.len() {
            let (piece, width) = (pieces[i], pieces[i + 1].enthalpy - pieces[i].enthalpy);
            let end = material.conductivity(piece.temperature + piece.slope * width) * piece.slope;
            pieces[i].quadratic = 0.5 * (end - piece.linear) / width;
        }
    }
}

/// Buckets of equal enthalpy, about four a piece, so that a look-up needs no search.
fn bucket_table(pieces: &[Piece]) -> (Vec<u16>, f64) {
    let (first, last) = (pieces[0].enthalpy, pieces[pieces.len() - 1].enthalpy);
    let count = (4 * pieces.len()).clamp(16, 4096);
    let per_joule = count as f64 / (last - first).max(f64::MIN_POSITIVE);
    let start_of = |bucket: usize| first + bucket as f64 / per_joule;
    let piece_at = |h: f64| pieces.partition_point(|p| p.enthalpy <= h).max(1) - 1;
    ((0..count).map(|b| piece_at(start_of(b)) as u16).collect(), per_joule)
}

fn largest_slope(pieces: &[Piece]) -> f64 {
    let ends =
        pieces.windows(2).map(|w| w[0].linear + 2.0 * w[0].quadratic * (w[1].enthalpy - w[0].enthalpy));
    pieces.iter().map(|p| p.linear).chain(ends).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::super::Table;
    use super::super::material::tests::aluminium;
    use super::*;
    use proptest::prelude::*;

    fn with_tables() -> ThermalMaterial {
        ThermalMaterial {
            heat_capacity_solid: Table::new(vec![(293.0, 900.0), (600.0, 1030.0), (847.0, 1150.0)]).unwrap(),
            heat_capacity_liquid: Table::new(vec![(905.0, 1177.0), (1500.0, 1100.0)]).unwrap(),
            conductivity_solid: Table::new(vec![(293.0, 237.0), (700.0, 220.0), (847.0, 205.0)]).unwrap(),
            conductivity_liquid: Table::new(vec![(905.0, 91.0), (2000.0, 110.0)]).unwrap(),
            ..aluminium()
        }
    }

    #[test]
    fn corners_are_where_the_formulas_put_them() {
        let curve = EnthalpyCurve::continuous(&aluminium()).unwrap();
        assert!((curve.enthalpy_solidus() - 1050.0 * 847.0).abs() < 1e-6);
        let liquidus = 1050.0 * 847.0 + 1115.0 * 58.0 + 3.97e5;
        assert!((curve.enthalpy_liquidus() - liquidus).abs() < 1e-6);
        assert!((curve.temperature(liquidus + 1180.0 * 100.0) - 1005.0).abs() < 1e-9);
        assert!((curve.potential_at(847.0)).abs() < 1e-9);
        assert!((curve.potential_at(293.0) + 200.0 * 554.0).abs() < 1e-6);
        assert!((curve.potential_at(905.0) - 147.5 * 58.0).abs() < 1e-6);
        assert!((curve.largest_potential_slope() - 200.0 / 1050.0).abs() < 1e-12);
    }

    #[test]
    fn tables_integrate_exactly_at_their_nodes() {
        let curve = EnthalpyCurve::continuous(&with_tables()).unwrap();
        let expected = 900.0 * 293.0 + 0.5 * (900.0 + 1030.0) * 307.0;
        assert!((curve.enthalpy_at(600.0) - expected).abs() < 1e-6);
        assert!((curve.temperature(expected) - 600.0).abs() < 1e-9);
        let between = 900.0 * 293.0 + (900.0 + 0.5 * 130.0 * 157.0 / 307.0) * 157.0;
        assert!((curve.temperature(between) - 450.0).abs() < 1e-2, "{}", curve.temperature(between));
    }

    #[test]
    fn the_papers_curve_jumps_and_says_so() {
        let curve = EnthalpyCurve::hu_eberhard_2015(&aluminium()).unwrap();
        let jump = curve.temperature_jump().unwrap();
        let before = curve.temperature(curve.enthalpy_solidus() - 1e-6);
        let after = curve.temperature(curve.enthalpy_solidus() + 1e-6);
        assert!((after - before - jump.at_solidus_k).abs() < 1e-6);
        assert!(jump.at_solidus_k < -20.0 && jump.at_solidus_k > -60.0, "{jump:?}");
        assert!(jump.excess_latent_heat > 0.4 && jump.excess_latent_heat < 0.9, "{jump:?}");
        let top = curve.enthalpy_liquidus();
        assert!((curve.temperature(top - 1e-6) - curve.temperature(top + 1e-6)).abs() < 1e-6);
        // Eq. 20 read literally, at one enthalpy inside each branch.
        let (mushy, liquid) = (1.2e6, 2.0e6);
        let c_in = 1180.0 * 905.0 / 847.0;
        let slope = 3.97e5 / 58.0;
        assert!((curve.temperature(mushy) - (mushy + slope * 847.0) / (c_in + slope)).abs() < 1e-9);
        assert!((curve.temperature(liquid) - (liquid - 3.97e5 - c_in * 58.0) / 1180.0).abs() < 1e-9);
    }

    #[test]
    fn the_papers_curve_does_not_jump_where_its_condition_holds() {
        let matched = ThermalMaterial {
            heat_capacity_solid: Table::constant(1180.0 * 905.0 / 847.0).unwrap(),
            ..aluminium()
        };
        let jump = EnthalpyCurve::hu_eberhard_2015(&matched).unwrap().temperature_jump().unwrap();
        assert!(jump.at_solidus_k.abs() < 1e-9);
    }

    proptest! {
        #[test]
        fn continuous_monotone_and_invertible(
            solidus in 300.0..2000.0f64, range in 0.5..300.0f64, latent in 0.0..1e6f64,
            cs in 100.0..3000.0f64, cl in 100.0..3000.0f64, ks in 1.0..400.0f64, kl in 1.0..400.0f64,
            share in 0.0..1.0f64,
        ) {
            let material = ThermalMaterial {
                density: 2700.0, solidus, liquidus: solidus + range, latent_heat: latent,
                heat_capacity_solid: Table::constant(cs).unwrap(),
                heat_capacity_liquid: Table::constant(cl).unwrap(),
                conductivity_solid: Table::new(vec![(300.0, ks), (900.0, 1.3 * ks)]).unwrap(),
                conductivity_liquid: Table::constant(kl).unwrap(),
            };
            let curve = EnthalpyCurve::continuous(&material).unwrap();
            let h = share * 3.0 * curve.enthalpy_liquidus();
            let step = 1e-6 * curve.enthalpy_liquidus();
            let rise = curve.temperature(h + step) - curve.temperature(h);
            prop_assert!(rise > 0.0 && rise <= step / cs.min(cl) * (1.0 + 1e-6));
            let t = curve.temperature(h);
            prop_assert!((curve.enthalpy_at(t) - h).abs() <= 1e-9 * curve.enthalpy_liquidus());
            let theta = curve.potential(h);
            prop_assert_eq!(curve.potentials(&[h, 0.5 * h, h + step, 2.0 * h]), [h, 0.5 * h, h + step, 2.0 * h].map(|h| curve.potential(h)));
            prop_assert!((curve.temperature_at_potential(theta) - t).abs() < 1e-6 * t.max(1.0));
            // d theta = k dT, by the midpoint.
            let slope = (curve.potential(h + step) - theta) / rise;
            let k = material.conductivity(0.5 * (t + curve.temperature(h + step)));
            prop_assert!((slope - k).abs() < 2e-3 * ks.max(kl), "{slope} against {k}");
            prop_assert!((curve.conductivity(h) - material.conductivity(t)).abs() < 1e-6 * ks.max(kl));
            let f = curve.liquid_fraction(h);
            prop_assert!((0.0..=1.0).contains(&f));
            prop_assert!((t < solidus) == (f == 0.0) || (t - solidus).abs() < 1e-9 * solidus);
        }
    }
}
