//! A property over temperature: piecewise linear, constant beyond both ends.

use crate::error::Error;

/// A positive material property over temperature \[K\].
///
/// Linear between its nodes, constant below the first and above the last one.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    nodes: Vec<(f64, f64)>,
}

impl Table {
    /// A property that does not depend on temperature.
    ///
    /// # Errors
    /// [`Error::Table`] unless `value` is finite and positive.
    pub fn constant(value: f64) -> Result<Self, Error> {
        Self::new(vec![(300.0, value)])
    }

    /// A property given at (temperature \[K\], value) nodes with rising temperatures.
    ///
    /// # Errors
    /// [`Error::Table`] when there is no node, temperatures do not rise, or a value is not finite and positive.
    pub fn new(nodes: Vec<(f64, f64)>) -> Result<Self, Error> {
        if nodes.is_empty() {
            return Err(Error::Table("no node; accepted: at least one (temperature, value) pair".into()));
        }
        if let Some(&(t, v)) = nodes.iter().find(|(t, v)| !(t.is_finite() && v.is_finite() && *v > 0.0)) {
            return Err(Error::Table(format!(
                "found ({t}, {v}); accepted: finite numbers, the value above 0"
            )));
        }
        if let Some(w) = nodes.windows(2).find(|w| w[1].0 <= w[0].0) {
            return Err(Error::Table(format!("temperature {} follows {}; accepted: rising", w[1].0, w[0].0)));
        }
        Ok(Self { nodes })
    }

    /// The property at a temperature \[K\].
    pub fn at(&self, temperature: f64) -> f64 {
        let upper = self.nodes.partition_point(|node| node.0 <= temperature);
        if upper == 0 {
            return self.nodes[0].1;
        }
        let (t0, v0) = self.nodes[upper - 1];
        match self.nodes.get(upper) {
            Some(&(t1, v1)) => v0 + (v1 - v0) * (temperature - t0) / (t1 - t0),
            None => v0,
        }
    }

    /// The largest value of all temperatures.
    pub fn largest(&self) -> f64 {
        self.nodes.iter().map(|node| node.1).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Whether it has one value at all temperatures.
    pub fn is_constant(&self) -> bool {
        self.nodes.iter().all(|node| node.1 == self.nodes[0].1)
    }

    /// The slopes \[value/K\] of the pieces that reach into the range between two temperatures \[K\], rising; zero beyond the nodes
    /// is not among them.
    pub fn slopes(&self, low: f64, high: f64) -> impl Iterator<Item = f64> + '_ {
        let reaches = move |piece: &&[(f64, f64)]| piece[1].0 > low && piece[0].0 < high;
        self.nodes
            .windows(2)
            .filter(reaches)
            .map(|piece| (piece[1].1 - piece[0].1) / (piece[1].0 - piece[0].0))
    }

    /// The node temperatures strictly between two temperatures, rising.
    pub(crate) fn node_temperatures(&self, low: f64, high: f64) -> impl Iterator<Item = f64> + '_ {
        self.nodes.iter().map(|node| node.0).filter(move |&t| t > low && t < high)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn interpolates_between_and_holds_beyond() {
        let table = Table::new(vec![(300.0, 10.0), (400.0, 20.0), (500.0, 5.0)]).unwrap();
        assert_eq!(table.at(200.0), 10.0);
        assert_eq!(table.at(350.0), 15.0);
        assert_eq!(table.at(400.0), 20.0);
        assert_eq!(table.at(450.0), 12.5);
        assert_eq!(table.at(900.0), 5.0);
    }

    #[test]
    fn tells_its_largest_value_and_its_slopes() {
        let table = Table::new(vec![(300.0, 1.0), (400.0, 3.0), (600.0, 2.0)]).unwrap();
        assert_eq!((table.largest(), table.is_constant()), (3.0, false));
        assert!(Table::constant(2.0).unwrap().is_constant());
        assert_eq!(table.slopes(300.0, 600.0).collect::<Vec<_>>(), [0.02, -0.005]);
        assert_eq!(table.slopes(400.0, 450.0).collect::<Vec<_>>(), [-0.005]);
        assert_eq!(table.slopes(700.0, 800.0).count(), 0);
    }

    #[test]
    fn refuses_what_is_no_table() {
        assert!(Table::new(vec![]).is_err());
        assert!(Table::new(vec![(300.0, 1.0), (300.0, 2.0)]).is_err());
        assert!(Table::new(vec![(300.0, -1.0)]).is_err());
        assert!(Table::new(vec![(300.0, f64::NAN)]).is_err());
    }
}
