//! Evaluates a graph in numbers. It performs the operations of the emitted code in the order of the emitted code.

use super::{Binary, Graph, Id, Operand, Operation, Unary};
use frictiongen_kernel::Float;
use std::collections::HashMap;

#[derive(Clone, Copy)]
enum InterpretedValue<S> {
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
    let mut values: HashMap<Id, InterpretedValue<S>> = HashMap::new();
    for (id, node, _) in graph.reachable(outputs) {
        let value = evaluate(&values, &node, &input)?;
        values.insert(id, value);
    }
    outputs
        .iter()
        .map(|operand| number(&values, operand))
        .collect()
}

fn number<S: Float>(values: &HashMap<Id, InterpretedValue<S>>, operand: &Operand) -> Option<S> {
    match operand {
        Operand::Number(bits) => Some(S::constant(f64::from_bits(*bits))),
        Operand::Node(id) => match values.get(id)? {
            InterpretedValue::Number(value) => Some(*value),
            InterpretedValue::Pair(..) | InterpretedValue::Truth(_) => None,
        },
    }
}

fn evaluate<S: Float>(
    values: &HashMap<Id, InterpretedValue<S>>,
    node: &Operation,
    input: &impl Fn(&str) -> Option<S>,
) -> Option<InterpretedValue<S>> {
    let of = |operand: &Operand| number(values, operand);
    Some(match node {
        Operation::Input(text) => InterpretedValue::Number(input(text)?),
        Operation::Constant(_, bits) => {
            InterpretedValue::Number(S::constant(f64::from_bits(*bits)))
        }
        Operation::Unary(op, a) => {
            let a = of(a)?;
            InterpretedValue::Number(match op {
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
        Operation::Binary(op, a, b) => {
            let (a, b) = (of(a)?, of(b)?);
            InterpretedValue::Number(match op {
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
        Operation::SinCosPi(a) => {
            let (s, c) = of(a)?.sin_cos_pi();
            InterpretedValue::Pair(s, c)
        }
        Operation::SinCosPiMinus(a, b) => {
            let (s, c) = of(a)?.sin_cos_pi_minus(of(b)?);
            InterpretedValue::Pair(s, c)
        }
        Operation::Part(pair, second) => match values.get(pair)? {
            InterpretedValue::Pair(a, b) => InterpretedValue::Number(if *second { *b } else { *a }),
            InterpretedValue::Number(_) | InterpretedValue::Truth(_) => return None,
        },
        Operation::Less(a, b) => InterpretedValue::Truth(of(a)?.lt(of(b)?)),
        Operation::IsZero(a) => InterpretedValue::Truth(of(a)?.is_zero()),
        Operation::Select(condition, yes, no) => match values.get(condition)? {
            InterpretedValue::Truth(true) => InterpretedValue::Number(of(yes)?),
            InterpretedValue::Truth(false) => InterpretedValue::Number(of(no)?),
            InterpretedValue::Number(_) | InterpretedValue::Pair(..) => return None,
        },
    })
}
