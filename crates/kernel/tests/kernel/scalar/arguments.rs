//! The rows of the reference table, and random arguments.

use frictiongen_kernel::number::dd::Dd;
use fuzzing::Random;

const TABLE: &str = include_str!("../../data/scalar_reference.csv");

pub struct Row {
    pub name: &'static str,
    pub x: Dd,
    pub y: Dd,
    pub results: [Dd; 2],
}

pub fn rows() -> Vec<Row> {
    let lines = TABLE.lines().filter(|line| !line.starts_with('#'));
    let row = |line: &'static str| {
        let mut fields = line.split(',');
        let name = fields.next().unwrap();
        let n: Vec<f64> = fields.map(|field| field.parse().unwrap()).collect();
        assert_eq!(n.len(), 8);
        Row {
            name,
            x: Dd::new(n[0], n[1]),
            y: Dd::new(n[2], n[3]),
            results: [Dd::new(n[4], n[5]), Dd::new(n[6], n[7])],
        }
    };
    lines.map(row).collect()
}

/// A generator of reproducible arguments.
pub struct Source(pub Random);

impl Source {
    /// A number of random sign, with an exponent evenly distributed over the range.
    fn spread(&mut self, low: f64, high: f64) -> f64 {
        let size = (low + (high - low) * self.0.unit()).exp2();
        if self.0.bits() & 1 == 0 { size } else { -size }
    }

    /// Arguments in the range of the function `name`, in half-turns or radians as the function requires.
    pub fn arguments(&mut self, name: &str, reach: f64) -> (f64, f64) {
        let near = (self.0.bits() % 41) as f64 / 4.0;
        match name {
            "sin_cos_pi" | "one_minus_sinc_pi" | "versine_pi" => match self.0.bits() % 4 {
                0 => (self.spread(-reach, reach), 0.0),
                1 => (near + self.spread(-50.0, -2.0), 0.0),
                _ => (4.0 * self.0.unit() - 2.0, 0.0),
            },
            "sin_cos_pi_minus" => match self.0.bits() % 4 {
                0 => (self.spread(-reach, reach), self.spread(-reach, reach)),
                1 => (near + 4.0 * self.0.unit(), near),
                2 => (near + self.0.unit(), self.spread(-40.0, 0.0)),
                _ => (4.0 * self.0.unit() - 2.0, 4.0 * self.0.unit() - 2.0),
            },
            "exp" | "exp_m1" | "exp_m1_minus" => match self.0.bits() % 2 {
                0 => (self.spread(-reach / 4.0, 6.3), 0.0),
                _ => (8.0 * self.0.unit() - 4.0, 0.0),
            },
            "scaled_sinh_defect" => match self.0.bits() % 2 {
                0 => (self.spread(-reach / 4.0, 10.0).abs(), 0.0),
                _ => (6.0 * self.0.unit(), 0.0),
            },
            "sqrt" => (self.spread(-reach, reach).abs(), 0.0),
            _ => match self.0.bits() % 2 {
                0 => (
                    self.spread(-reach / 3.0, reach / 3.0),
                    self.spread(-reach / 3.0, reach / 3.0),
                ),
                _ => (self.spread(-2.0, 2.0), self.spread(-2.0, 2.0)),
            },
        }
    }
}
