//! A material value over temperature: piecewise linear, constant beyond both ends, with its exact integral.

use crate::error::{Error, require};

/// A value that is linear between its nodes (temperature \[K\], value) and constant beyond the first and the last.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Table {
    nodes: Vec<(f64, f64)>,
    /// Integral of the value from the first node to each node.
    integrals: Vec<f64>,
}

impl Table {
    /// Checks and stores the nodes; `name` and `accepted` are for the message, `holds` says whether a value will do.
    pub fn new(
        name: &'static str,
        nodes: &[(f64, f64)],
        holds: impl Fn(f64) -> bool,
        accepted: &'static str,
    ) -> Result<Self, Error> {
        let wrong = |found: String| Error::Table { table: name, found };
        if nodes.is_empty() {
            return Err(wrong("there is no node".into()));
        }
        for &(temperature, value) in nodes {
            require(true, "temperature of a node", temperature, "a finite number")?;
            require(holds(value), name, value, accepted)?;
        }
        if let Some(pair) = nodes.windows(2).find(|pair| pair[1].0 <= pair[0].0) {
            return Err(wrong(format!("{} K follows {} K", pair[1].0, pair[0].0)));
        }
        let mut integrals = vec![0.0];
        for pair in nodes.windows(2) {
            let area = 0.5 * (pair[0].1 + pair[1].1) * (pair[1].0 - pair[0].0);
            integrals.push(integrals[integrals.len() - 1] + area);
        }
        Ok(Self { nodes: nodes.to_vec(), integrals })
    }

    /// The value at `temperature` \[K\].
    pub fn at(&self, temperature: f64) -> f64 {
        let (node, slope) = self.segment(temperature);
        self.nodes[node].1 + slope * (temperature - self.nodes[node].0)
    }

    /// Integral of the value from the first node to `temperature` \[K\].
    pub fn integral_to(&self, temperature: f64) -> f64 {
        let (node, slope) = self.segment(temperature);
        let beyond = temperature - self.nodes[node].0;
        self.integrals[node] + beyond * (self.nodes[node].1 + 0.5 * slope * beyond)
    }

    /// The node that `temperature` is measured from, and the slope that holds there.
    fn segment(&self, temperature: f64) -> (usize, f64) {
        let upper = self.nodes.partition_point(|node| node.0 <= temperature);
        if upper == 0 || upper == self.nodes.len() {
            return (upper.saturating_sub(1), 0.0);
        }
        let ((t0, v0), (t1, v1)) = (self.nodes[upper - 1], self.nodes[upper]);
        (upper - 1, (v1 - v0) / (t1 - t0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn table(nodes: &[(f64, f64)]) -> Result<Table, Error> {
        Table::new("strength", nodes, |value| value >= 0.0, "not negative")
    }

    #[test]
    fn interpolates_between_and_holds_beyond() {
        let table = table(&[(300.0, 10.0), (400.0, 20.0), (500.0, 5.0)]).unwrap();
        let values = [200.0, 350.0, 400.0, 450.0, 900.0].map(|temperature| table.at(temperature));
        assert_eq!(values, [10.0, 15.0, 20.0, 12.5, 5.0]);
    }

    #[test]
    fn bad_tables_are_named() {
        let message = |nodes: &[(f64, f64)]| table(nodes).unwrap_err().to_string();
        assert!(message(&[]).starts_with("strength: there is no node"));
        assert!(message(&[(400.0, 1.0), (300.0, 1.0)]).starts_with("strength: 300 K follows 400 K"));
        assert_eq!(message(&[(300.0, -1.0)]), "strength is -1, but must be not negative");
    }

    proptest! {
        #[test]
        fn the_integral_has_the_value_as_its_slope(temperature in 200.0..600.0_f64) {
            let table = table(&[(300.0, 10.0), (400.0, 20.0), (500.0, 5.0)]).unwrap();
            let step = 1e-3;
            let slope = (table.integral_to(temperature + step) - table.integral_to(temperature - step)) / (2.0 * step);
            prop_assert!((slope - table.at(temperature)).abs() < 1e-3);
        }
    }
}
