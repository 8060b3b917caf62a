//! Scalar type that records the operations performed on it.

use super::{Binary, Graph, Id, Operand, Operation, Unary};
use frictiongen_kernel::Scalar;
use frictiongen_model::scene::Precision;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number that is known when the code is emitted, or a value that the emitted code computes.
#[derive(Clone, Copy)]
pub enum Expr<'g> {
    /// A number that is known when the code is emitted.
    Number(f64),
    /// A value that the emitted code computes: an operation of the graph.
    Node(&'g Graph, Id),
}

/// Result of a comparison: a truth value that is known when the code is emitted, or a comparison in the emitted code.
#[derive(Clone, Copy)]
pub enum EmittedCondition<'g> {
    /// A result that is known when the code is emitted.
    Known(bool),
    /// A comparison in the emitted code: an operation of the graph.
    Node(&'g Graph, Id),
}

impl Graph {
    /// Records an external value. `text` is the Rust expression that names it.
    pub fn input(&self, text: impl Into<String>) -> Expr<'_> {
        Expr::Node(self, self.record(Operation::Input(text.into())))
    }

    /// Records a constant of the scene. `text` is the Rust expression that names it. A constant with the value 0, 1
    /// or −1 is recorded as a plain number, so that formulas fold it.
    pub fn constant(&self, text: impl Into<String>, value: f64) -> Expr<'_> {
        if value == 0.0 || value.abs() == 1.0 {
            return Expr::Number(value);
        }
        let node = Operation::Constant(text.into(), value.to_bits());
        Expr::Node(self, self.record_known(node, value))
    }

    /// Records a choice by the constant parameter `flag` of the emitted function: `value` if `flag` is true,
    /// otherwise 0. The choice takes over the name of `value`.
    #[must_use]
    pub fn where_asked<'g>(&'g self, flag: &str, value: Expr<'g>) -> Expr<'g> {
        let Expr::Node(_, id) = value else {
            return value;
        };
        let flag = self.record(Operation::Input(flag.to_owned()));
        let chosen = self.record(Operation::Select(
            flag,
            Operand::Node(id),
            Operand::number(0.0),
        ));
        let mut inner = self.inner.borrow_mut();
        let name = inner.names.get_mut(id.0).and_then(Option::take);
        if let Some(slot) = inner.names.get_mut(chosen.0) {
            *slot = name;
        }
        drop(inner);
        Expr::Node(self, chosen)
    }
}

impl<'g> Expr<'g> {
    /// Returns this value as an operand of an operation.
    #[must_use]
    pub fn operand(self) -> Operand {
        match self {
            Self::Number(value) => Operand::number(value),
            Self::Node(_, id) => Operand::Node(id),
        }
    }

    fn graph(self) -> Option<&'g Graph> {
        match self {
            Self::Number(_) => None,
            Self::Node(graph, _) => Some(graph),
        }
    }

    fn is(self, number: f64) -> bool {
        matches!(self, Self::Number(value) if value == number)
    }

    /// Returns the value of a number, or of an expression that contains only constants of the scene.
    fn value(self) -> Option<f64> {
        match self {
            Self::Number(value) => Some(value),
            Self::Node(graph, id) => graph.value(id),
        }
    }

    fn unary(self, op: Unary, number: impl Fn(f64) -> f64) -> Self {
        match (self, self.value()) {
            (Self::Node(graph, id), Some(value)) if op == Unary::Neg => {
                let node = Operation::Unary(op, Operand::Node(id));
                Self::Node(graph, graph.record_known(node, number(value)))
            }
            (_, Some(value)) => Self::Number(number(value)),
            (Self::Node(graph, id), None) => {
                Self::Node(graph, graph.record(Operation::Unary(op, Operand::Node(id))))
            }
            (known, None) => known,
        }
    }

    fn binary(self, op: Binary, other: Self, number: impl Fn(f64, f64) -> f64) -> Self {
        let (a, b) = (self, other);
        let Some(graph) = a.graph().or(b.graph()) else {
            return match (a.value(), b.value()) {
                (Some(a), Some(b)) => Self::Number(number(a, b)),
                _ => a,
            };
        };
        let node = Operation::Binary(op, a.operand(), b.operand());
        match (a.value(), b.value()) {
            (Some(a), Some(b)) => {
                let value = number(a, b);
                if stays(graph.precision, op, [a, b], value) {
                    Self::Node(graph, graph.record_known(node, value))
                } else {
                    Self::Number(value)
                }
            }
            _ => Self::Node(graph, graph.record(node)),
        }
    }

    /// Returns a if this value was recorded as `-a`. The recorder uses a to write x − (−a) as x + a.
    fn negated(self) -> Option<Self> {
        let Self::Node(graph, id) = self else {
            return None;
        };
        let inner = graph.inner.borrow();
        match inner.nodes.get(id.0) {
            Some(Operation::Unary(Unary::Neg, Operand::Node(of))) => Some(Self::Node(graph, *of)),
            _ => None,
        }
    }

    fn pair(graph: &'g Graph, node: Operation) -> (Self, Self) {
        let pair = graph.record(node);
        let part = |second| Self::Node(graph, graph.record(Operation::Part(pair, second)));
        (part(false), part(true))
    }
}

impl Neg for Expr<'_> {
    type Output = Self;
    fn neg(self) -> Self {
        self.negated()
            .unwrap_or_else(|| self.unary(Unary::Neg, |a| -a))
    }
}

#[allow(
    clippy::suspicious_arithmetic_impl,
    reason = "a + (−b) is recorded as a − b"
)]
impl Add for Expr<'_> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        if self.is(0.0) {
            return other;
        }
        if other.is(0.0) {
            return self;
        }
        match other.negated() {
            Some(of) => self - of,
            None => self.binary(Binary::Add, other, |a, b| a + b),
        }
    }
}

#[allow(
    clippy::suspicious_arithmetic_impl,
    reason = "a − (−b) is recorded as a + b"
)]
impl Sub for Expr<'_> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        if self.is(0.0) {
            return -other;
        }
        if other.is(0.0) {
            return self;
        }
        match other.negated() {
            Some(of) => self + of,
            None => self.binary(Binary::Sub, other, |a, b| a - b),
        }
    }
}

impl Mul for Expr<'_> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        if self.is(0.0) || other.is(0.0) {
            return Self::Number(0.0);
        }
        if self.is(1.0) {
            return other;
        }
        if other.is(1.0) {
            return self;
        }
        if self.is(-1.0) {
            return -other;
        }
        if other.is(-1.0) {
            return -self;
        }
        self.binary(Binary::Mul, other, |a, b| a * b)
    }
}

impl Div for Expr<'_> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if self.is(0.0) {
            return self;
        }
        if other.is(1.0) {
            return self;
        }
        self.binary(Binary::Div, other, |a, b| a / b)
    }
}

impl<'g> Scalar for Expr<'g> {
    const MASS_CONTROLLED: bool = true;
    type Condition = EmittedCondition<'g>;

    fn constant(value: f64) -> Self {
        Self::Number(value)
    }

    fn pi() -> Self {
        Self::Number(std::f64::consts::PI)
    }

    fn inverse_pi() -> Self {
        Self::Number(std::f64::consts::FRAC_1_PI)
    }

    fn lt(self, other: Self) -> EmittedCondition<'g> {
        match (self.value(), other.value(), self.graph().or(other.graph())) {
            (Some(a), Some(b), _) => EmittedCondition::Known(a < b),
            (_, _, Some(graph)) => {
                let node = Operation::Less(self.operand(), other.operand());
                EmittedCondition::Node(graph, graph.record(node))
            }
            (_, _, None) => EmittedCondition::Known(false),
        }
    }

    fn is_zero(self) -> EmittedCondition<'g> {
        match (self, self.value()) {
            (_, Some(value)) => EmittedCondition::Known(value == 0.0),
            (Self::Node(graph, id), None) => {
                EmittedCondition::Node(graph, graph.record(Operation::IsZero(Operand::Node(id))))
            }
            (Self::Number(_), None) => EmittedCondition::Known(false),
        }
    }

    fn select(condition: EmittedCondition<'g>, yes: Self, no: Self) -> Self {
        match condition {
            EmittedCondition::Known(true) => yes,
            EmittedCondition::Known(false) => no,
            EmittedCondition::Node(_, _) if yes.operand() == no.operand() => yes,
            EmittedCondition::Node(graph, id) => Self::Node(
                graph,
                graph.record(Operation::Select(id, yes.operand(), no.operand())),
            ),
        }
    }

    fn abs(self) -> Self {
        self.unary(Unary::Abs, f64::abs)
    }
    fn sqrt(self) -> Self {
        self.unary(Unary::Sqrt, f64::sqrt)
    }
    fn max(self, other: Self) -> Self {
        self.binary(Binary::Max, other, f64::max)
    }
    fn min(self, other: Self) -> Self {
        self.binary(Binary::Min, other, f64::min)
    }
    fn copysign(self, sign: Self) -> Self {
        self.binary(Binary::Copysign, sign, f64::copysign)
    }
    fn exp(self) -> Self {
        self.unary(Unary::Exp, Scalar::exp)
    }
    fn exp_m1(self) -> Self {
        self.unary(Unary::ExpM1, Scalar::exp_m1)
    }
    fn atan2(self, x: Self) -> Self {
        self.binary(Binary::Atan2, x, Scalar::atan2)
    }
    fn hypot(self, other: Self) -> Self {
        self.binary(Binary::Hypot, other, Scalar::hypot)
    }
    fn sin_cos_pi(self) -> (Self, Self) {
        match self {
            Self::Number(value) => {
                let (s, c) = value.sin_cos_pi();
                (Self::Number(s), Self::Number(c))
            }
            Self::Node(graph, id) => Self::pair(graph, Operation::SinCosPi(Operand::Node(id))),
        }
    }
    fn sin_cos_pi_minus(self, d: Self) -> (Self, Self) {
        match (self, d, self.graph().or(d.graph())) {
            (Self::Number(h), Self::Number(d), _) => {
                let (s, c) = h.sin_cos_pi_minus(d);
                (Self::Number(s), Self::Number(c))
            }
            (h, d, _) if d.is(0.0) => h.sin_cos_pi(),
            (h, d, Some(graph)) => {
                Self::pair(graph, Operation::SinCosPiMinus(h.operand(), d.operand()))
            }
            (h, d, None) => (h, d),
        }
    }
    fn one_minus_sinc_pi(self) -> Self {
        self.unary(Unary::OneMinusSincPi, Scalar::one_minus_sinc_pi)
    }
    fn detuning_off_pole(self) -> Self {
        self.unary(Unary::DetuningOffPole, Scalar::detuning_off_pole)
    }
    fn cosine_off_pole(self) -> Self {
        self.unary(Unary::CosineOffPole, Scalar::cosine_off_pole)
    }
    fn scaled_sinh_defect(self) -> Self {
        self.unary(Unary::ScaledSinhDefect, Scalar::scaled_sinh_defect)
    }

    fn named(self, name: &'static str, about: &'static str, mode: Option<usize>) -> Self {
        if let Self::Node(graph, id) = self {
            graph.name(id, name, about, mode);
        }
        self
    }
}

/// Returns true if the emitted code contains this operation on constants of the scene, so that the compiler computes
/// its result in the scene's precision. If false, the emitted code contains only the result as a number.
///
/// The compiler's result must equal `value`, which is computed in double precision and rounded to the scene's
/// precision. The function also returns false if the result allows further folding, or if compilers may round the
/// operation differently.
fn stays(precision: Precision, op: Binary, operands: [f64; 2], value: f64) -> bool {
    let rounded = |value: f64| match precision {
        Precision::F64 => value,
        #[allow(clippy::cast_possible_truncation, reason = "the scene's scalar is f32")]
        Precision::F32 => f64::from(value as f32),
    };
    let [a, b] = operands.map(rounded);
    let computed = match op {
        Binary::Add => a + b,
        Binary::Sub => a - b,
        Binary::Mul => a * b,
        Binary::Div => a / b,
        _ => return false,
    };
    // Double precision has more than twice as many digits as single precision. Rounding twice therefore gives the same
    // number as rounding once.
    let same = rounded(computed).to_bits() == rounded(value).to_bits();
    same && value.is_finite() && value != 0.0 && value.abs() != 1.0
}
