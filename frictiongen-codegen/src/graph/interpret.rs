//! Evaluates a graph in numbers. It performs the operations of the emitted code in the order of the emitted code.

use super::{Binary, Graph, Id, Node, Operand, Unary};
use frictiongen_kernel::Float;
use std::collections::HashMap;

#[derive(Clone, Copy)]
enum Value<S> {
    Number(S),
    Pair(S, S),
    Truth(bool),
}

/// Returns the values of `outputs`. `input` maps the Rust expression of an external value to its number. Returns
/// `None` if `input` does not know an expression.
pub fn interpret<S: Float>(
    graph: &Graph,
    outputs: &[Operand],
    input: impl Fn(&str) -> Option<S>,
) -> Option<Vec<S>> {
    let mut values: HashMap<Id, Value<S>> = HashMap::new();
    for (id, node, _) in graph.reachable(outputs) {
        let value = evaluate(&values, &node, &input)?;
        values.insert(id, value);
    }
    outputs
        .iter()
        .map(|operand| number(&values, operand))
        .collect()
}

fn number<S: Float>(values: &HashMap<Id, Value<S>>, operand: &Operand) -> Option<S> {
    match operand {
        Operand::Number(bits) => Some(S::constant(f64::from_bits(*bits))),
        Operand::Node(id) => match values.get(id)? {
            Value::Number(value) => Some(*value),
            Value::Pair(..) | Value::Truth(_) => None,
        },
    }
}

fn evaluate<S: Float>(
    values: &HashMap<Id, Value<S>>,
    node: &Node,
    input: &impl Fn(&str) -> Option<S>,
) -> Option<Value<S>> {
    let of = |operand: &Operand| number(values, operand);
    Some(match node {
        Node::Input(text) => Value::Number(input(text)?),
        Node::Constant(_, bits) => Value::Number(S::constant(f64::from_bits(*bits))),
        Node::Unary(op, a) => {
            let a = of(a)?;
            Value::Number(match op {
                Unary::Neg => -a,
                Unary::Abs => a.abs(),
                Unary::Sqrt => a.sqrt(),
                Unary::Exp => a.exp(),
                Unary::ExpM1 => a.exp_m1(),
                Unary::OneMinusSincPi => a.one_minus_sinc_pi(),
                Unary::DetuningOffPole => a.detuning_off_pole(),
                Unary::CosineOffPole => a.cosine_off_pole(),
                Unary::ScaledSinhDefect => a.scaled_sinh_defect(),
            })
        }
        Node::Binary(op, a, b) => {
            let (a, b) = (of(a)?, of(b)?);
            Value::Number(match op {
                Binary::Add => a + b,
                Binary::Sub => a - b,
                Binary::Mul => a * b,
                Binary::Div => a / b,
                Binary::Max => a.max(b),
                Binary::Min => a.min(b),
                Binary::Copysign => a.copysign(b),
                Binary::Atan2 => a.atan2(b),
                Binary::Hypot => a.hypot(b),
            })
        }
        Node::SinCosPi(a) => {
            let (s, c) = of(a)?.sin_cos_pi();
            Value::Pair(s, c)
        }
        Node::SinCosPiMinus(a, b) => {
            let (s, c) = of(a)?.sin_cos_pi_minus(of(b)?);
            Value::Pair(s, c)
        }
        Node::Part(pair, second) => match values.get(pair)? {
            Value::Pair(a, b) => Value::Number(if *second { *b } else { *a }),
            Value::Number(_) | Value::Truth(_) => return None,
        },
        Node::Less(a, b) => Value::Truth(of(a)?.lt(of(b)?)),
        Node::IsZero(a) => Value::Truth(of(a)?.is_zero()),
        Node::Select(condition, yes, no) => match values.get(condition)? {
            Value::Truth(true) => Value::Number(of(yes)?),
            Value::Truth(false) => Value::Number(of(no)?),
            Value::Number(_) | Value::Pair(..) => return None,
        },
    })
}
