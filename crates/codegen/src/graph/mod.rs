//! Expression graph, which records the closed forms as code.
//!
//! [`Expr`] is a scalar type. The evaluation of a formula with this type records the operations. Constants fold during
//! the recording, and equal operations are recorded once. The result is a [`Graph`]. [`interpret`] evaluates a graph in
//! numbers, [`count`] counts its operations, and [`mod@print`] and [`alternatives`] print it as Rust.

pub mod alternatives;
pub mod count;
pub mod expr;
pub mod interpret;
pub mod literal;
pub mod print;

use frictiongen_model::scene::Precision;
use std::cell::RefCell;
use std::collections::HashMap;

pub use expr::{EmittedCondition, Expr};

/// Index of an operation in its graph. The operands of an operation have lower indices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Id(pub(crate) usize);

/// An operand of an operation: a recorded operation or a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Operand {
    /// The result of an operation of the graph, by its index.
    Node(Id),
    /// A number, stored as the bits of an `f64`.
    Number(u64),
}

impl Operand {
    pub(crate) fn number(value: f64) -> Self {
        Self::Number(value.to_bits())
    }
}

/// An operation on one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[allow(missing_docs, reason = "the names are those of the scalar trait")]
pub enum Unary {
    Neg,
    Abs,
    Sqrt,
    Exp,
    ExpM1,
    OneMinusSincPi,
    ScaledSinhDefect,
    DetuningOffPole,
    CosineOffPole,
}

/// An operation on two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[allow(missing_docs, reason = "the names are those of the scalar trait")]
pub enum Binary {
    Add,
    Sub,
    Mul,
    Div,
    Max,
    Min,
    Copysign,
    Atan2,
    Hypot,
}

/// An operation of the graph: which operation it is, and its operands.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Operation {
    /// An external value, with the Rust expression that names it.
    Input(String),
    /// A constant of the scene, with the Rust expression that names it and the bits of its value.
    Constant(String, u64),
    /// An operation on one number, with its operand.
    Unary(Unary, Operand),
    /// An operation on two numbers, with its operands.
    Binary(Binary, Operand, Operand),
    /// The pair (sin πh, cos πh), where h is the operand.
    SinCosPi(Operand),
    /// The pair (sin π(h − d), cos π(h − d)), where h is the first and d the second operand.
    SinCosPiMinus(Operand, Operand),
    /// One result of an operation that returns a pair. The second field selects the first or the second result.
    Part(Id, bool),
    /// The comparison a < b of two operands.
    Less(Operand, Operand),
    /// The comparison a = 0 of an operand.
    IsZero(Operand),
    /// A choice between two values `yes` and `no`. The value is `yes` if the condition is true, otherwise `no`. The
    /// fields are the condition, `yes` and `no`.
    Select(Id, Operand, Operand),
}

/// Index, operation and name of a recorded operation.
pub(crate) type Recorded = (Id, Operation, Option<ValueName>);

/// Name of the value that an operation computes. `about` is the formula's explanation of the value. The emitted code
/// shows it as a comment.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct ValueName {
    pub text: String,
    pub about: &'static str,
}

#[derive(Default)]
struct Inner {
    nodes: Vec<Operation>,
    known: HashMap<Operation, Id>,
    names: Vec<Option<ValueName>>,
    /// Values of the operations that depend only on constants of the scene.
    values: HashMap<Id, f64>,
}

/// Graph of recorded operations. It grows while formulas are evaluated.
#[derive(Default)]
pub struct Graph {
    inner: RefCell<Inner>,
    /// True if the names of values contain the number of their mode.
    numbered: bool,
    /// Precision in which the emitted code computes.
    precision: Precision,
}

impl Graph {
    /// Creates an empty graph for a scene with `modes` modes.
    #[must_use]
    pub fn new(modes: usize) -> Self {
        Self {
            inner: RefCell::default(),
            numbered: modes > 1,
            precision: Precision::default(),
        }
    }

    /// Returns the graph for emitted code that computes in this precision.
    #[must_use]
    pub fn in_precision(mut self, precision: Precision) -> Self {
        self.precision = precision;
        self
    }

    pub(crate) fn record(&self, node: Operation) -> Id {
        let mut inner = self.inner.borrow_mut();
        if let Some(id) = inner.known.get(&node) {
            return *id;
        }
        let id = Id(inner.nodes.len());
        inner.nodes.push(node.clone());
        inner.names.push(None);
        inner.known.insert(node, id);
        id
    }

    pub(crate) fn name(&self, id: Id, name: &str, about: &'static str, mode: Option<usize>) {
        let text = match mode {
            Some(mode) if self.numbered => format!("mode_{}_{name}", mode + 1),
            _ => name.to_owned(),
        };
        let mut inner = self.inner.borrow_mut();
        let is_input = matches!(
            inner.nodes.get(id.0),
            Some(Operation::Input(_) | Operation::Constant(..))
        );
        if let (false, Some(slot @ None)) = (is_input, inner.names.get_mut(id.0)) {
            *slot = Some(ValueName { text, about });
        }
    }

    /// Returns the value of an operation, if it depends only on constants of the scene.
    pub(crate) fn value(&self, id: Id) -> Option<f64> {
        self.inner.borrow().values.get(&id).copied()
    }

    /// Records an operation whose operands are constants of the scene. `value` is its result.
    pub(crate) fn record_known(&self, node: Operation, value: f64) -> Id {
        let id = self.record(node);
        self.inner.borrow_mut().values.insert(id, value);
        id
    }

    /// Removes the names of all operations. A formula that is recorded later can then give its own names to existing
    /// operations.
    pub(crate) fn unname(&self) {
        self.inner.borrow_mut().names.fill(None);
    }

    /// Returns the recorded operations on which `outputs` depend. Operands are before the operations that use them.
    pub(crate) fn reachable(&self, outputs: &[Operand]) -> Vec<Recorded> {
        let inner = self.inner.borrow();
        let mut needed = vec![false; inner.nodes.len()];
        let mut open: Vec<Id> = outputs.iter().filter_map(operand_id).collect();
        while let Some(id) = open.pop() {
            if let Some(slot @ false) = needed.get_mut(id.0) {
                *slot = true;
                if let Some(node) = inner.nodes.get(id.0) {
                    open.extend(operands(node));
                }
            }
        }
        let all = inner.nodes.iter().zip(&inner.names).zip(needed).enumerate();
        all.filter(|(_, (_, needed))| *needed)
            .map(|(id, ((node, name), _))| (Id(id), node.clone(), name.clone()))
            .collect()
    }
}

fn operand_id(operand: &Operand) -> Option<Id> {
    match operand {
        Operand::Node(id) => Some(*id),
        Operand::Number(_) => None,
    }
}

/// Returns the recorded operands of an operation.
pub(crate) fn operands(node: &Operation) -> Vec<Id> {
    let of = |list: &[&Operand]| {
        list.iter()
            .filter_map(|o| operand_id(o))
            .collect::<Vec<_>>()
    };
    match node {
        Operation::Input(_) | Operation::Constant(..) => Vec::new(),
        Operation::Unary(_, a) | Operation::SinCosPi(a) | Operation::IsZero(a) => of(&[a]),
        Operation::Binary(_, a, b) | Operation::SinCosPiMinus(a, b) | Operation::Less(a, b) => {
            of(&[a, b])
        }
        Operation::Part(pair, _) => vec![*pair],
        Operation::Select(condition, a, b) => {
            let mut all = vec![*condition];
            all.extend(of(&[a, b]));
            all
        }
    }
}
