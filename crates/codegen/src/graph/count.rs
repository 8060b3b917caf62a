//! Counts the operations of an emitted function on its longest path.

use super::{Binary, Graph, Id, Operand, Operation, Unary};
use std::collections::BTreeMap;

/// Number of operations of each kind in a formula.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct OperationCount(BTreeMap<&'static str, usize>);

impl OperationCount {
    /// Counts the operations on which `outputs` depend.
    #[must_use]
    pub fn of(graph: &Graph, outputs: &[Operand]) -> Self {
        let mut count = Self::default();
        let nodes = graph.reachable(outputs);
        let is_input = |condition: &Id| {
            let place = nodes.binary_search_by_key(condition, |(id, ..)| *id);
            let node = place.ok().and_then(|place| nodes.get(place));
            matches!(node, Some((_, Operation::Input(_), _)))
        };
        for (id, node, _) in &nodes {
            // The compiler computes every operation that depends only on constants of the scene. The count omits such
            // an operation.
            if graph.value(*id).is_some() {
                continue;
            }
            // If the condition is a constant parameter, the compiler makes the choice. The choice then costs nothing at
            // run time.
            if matches!(node, Operation::Select(condition, ..) if is_input(condition)) {
                continue;
            }
            if let Some(kind) = kind(node) {
                // The emitted code repeats a comparison in each choice that depends on it, so a choice counts twice.
                let times = if matches!(node, Operation::Select(..)) {
                    2
                } else {
                    1
                };
                *count.0.entry(kind).or_default() += times;
            }
        }
        count
    }

    /// Returns the sum of this count and another.
    #[must_use]
    pub fn and(mut self, other: &Self) -> Self {
        for (kind, number) in &other.0 {
            *self.0.entry(kind).or_default() += number;
        }
        self
    }

    /// Returns this count multiplied by `times`.
    #[must_use]
    pub fn times(mut self, times: usize) -> Self {
        for number in self.0.values_mut() {
            *number *= times;
        }
        self
    }

    /// Returns the number of all operations.
    #[must_use]
    pub fn total(&self) -> usize {
        self.0.values().sum()
    }
}

/// Writes, for example, `12: 5 ×, 3 +, 2 ÷, 1 √, 1 sin_cos_pi`.
impl std::fmt::Display for OperationCount {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if self.total() == 0 {
            return f.write_str("none");
        }
        write!(f, "{}", self.total())?;
        let mut parts: Vec<_> = self.0.iter().collect();
        parts.sort_by(|a, b| b.1.cmp(a.1).then(a.0.cmp(b.0)));
        for (index, (kind, number)) in parts.into_iter().enumerate() {
            write!(f, "{} {number} {kind}", if index == 0 { ":" } else { "," })?;
        }
        Ok(())
    }
}

fn kind(node: &Operation) -> Option<&'static str> {
    Some(match node {
        Operation::Input(_)
        | Operation::Constant(..)
        | Operation::Part(..)
        | Operation::Less(..)
        | Operation::IsZero(_) => {
            return None;
        }
        Operation::Unary(Unary::Neg | Unary::Abs, _) | Operation::Binary(Binary::Copysign, ..) => {
            "sign"
        }
        Operation::Unary(Unary::Sqrt, _) => "√",
        Operation::Unary(Unary::Exp, _) => "exp",
        Operation::Unary(Unary::ExpM1, _) => "exp_m1",
        Operation::Unary(Unary::OneMinusSincPi, _) => "one_minus_sinc_pi",
        Operation::Unary(Unary::ScaledSinhDefect, _) => "scaled_sinh_defect",
        Operation::Binary(Binary::Add | Binary::Sub, ..) => "+",
        Operation::Binary(Binary::Mul, ..) => "×",
        Operation::Binary(Binary::Div, ..) => "÷",
        Operation::Unary(Unary::DetuningOffPole | Unary::CosineOffPole, _)
        | Operation::Binary(Binary::Max | Binary::Min, ..)
        | Operation::Select(..) => "compare",
        Operation::Binary(Binary::Atan2, ..) => "atan2",
        Operation::Binary(Binary::Hypot, ..) => "hypot",
        Operation::SinCosPi(_) | Operation::SinCosPiMinus(..) => "sin_cos_pi",
    })
}
