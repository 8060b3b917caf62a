//! Tests that interpreting a recorded graph gives the results of the recorded arithmetic, for any mix of known numbers
//! and inputs.

use frictiongen_codegen::graph::interpret::interpret;
use frictiongen_codegen::graph::{Expr, Graph};
use frictiongen_kernel::Scalar;
use frictiongen_model::scene::Precision;

/// Values that include both signs, 0, 1 and −1. Almost all of their sums, products and quotients are exact.
const VALUES: [f64; 9] = [-2.5, -1.0, -0.75, 0.0, 0.125, 0.5, 1.0, 3.0, 8.0];

/// Returns every formula of two values, over any scalar.
fn formulas<S: Scalar>(a: S, b: S) -> Vec<S> {
    let (zero, one) = (S::constant(0.0), S::constant(1.0));
    let choose = |condition| S::select(condition, a, b + one);
    let (sine, cosine) = (a * S::constant(0.25)).sin_cos_pi();
    let (beside, along) = a.sin_cos_pi_minus(b * S::constant(0.25));
    vec![
        a + b,
        a - b,
        a * b,
        a / (b + S::constant(16.0)),
        a + -b,
        -a + b,
        -a + -b,
        a - -b,
        -a - b,
        -a - -b,
        -(-a) * b,
        (zero - a) - b,
        a + zero * b,
        a * one - b * -one,
        choose(a.lt(b)),
        choose(b.lt(a)),
        choose((a - b).is_zero()),
        choose((a * b).is_zero()),
        choose(a.is_zero()),
        a.abs() - b.abs(),
        a.abs().sqrt() + (b * b).sqrt(),
        a.max(b) - a.min(b) * b,
        a.copysign(b),
        a.atan2(b),
        a.hypot(b),
        a.exp() + b.exp_m1(),
        sine + cosine * b,
        beside + along * b,
        a.one_minus_sinc_pi() * b,
        a.abs().scaled_sinh_defect() - b,
        a.detuning_off_pole() * b,
        b.cosine_off_pole() + a,
    ]
}

#[test]
fn interpreted_as_recorded() {
    let mut compared = 0;
    for a in VALUES {
        for b in VALUES {
            let expected = formulas(a, b);
            // Each value is an input of the graph or a number known during recording.
            for (known_a, known_b) in [(false, false), (true, false), (false, true), (true, true)] {
                let graph = Graph::new(2);
                let of = |known, name: &str, value| {
                    if known {
                        Expr::Number(value)
                    } else {
                        graph.input(name)
                    }
                };
                let by_name = |known, name: &str, value| {
                    if known {
                        graph.constant(name, value)
                    } else {
                        graph.input(name)
                    }
                };
                let mut outputs = formulas(of(known_a, "a", a), of(known_b, "b", b));
                outputs.extend(formulas(by_name(known_a, "a", a), by_name(known_b, "b", b)));
                let outputs: Vec<_> = outputs.into_iter().map(Expr::operand).collect();
                let input = |name: &str| Some(if name == "a" { a } else { b });
                let found = interpret(&graph, &outputs, input).expect("both inputs");
                assert_eq!(found.len(), 2 * expected.len());
                let expected = expected.iter().chain(&expected);
                for (index, (found, expected)) in found.iter().zip(expected).enumerate() {
                    // Folding may lose only the sign of a zero.
                    assert!(
                        found == expected || found.is_nan() && expected.is_nan(),
                        "formula {index} of {a}, {b}: {found} for {expected}"
                    );
                    compared += 1;
                }
            }
        }
    }
    println!("{compared} values compared, none skipped");
    assert_eq!(compared, 9 * 9 * 4 * 2 * 32);
}

/// Returns chains of operations on three constants.
fn chains<S: Scalar>(a: S, b: S, c: S) -> [S; 8] {
    [
        a * b * c,
        a / b - c,
        a + b + c,
        S::pi() * a * b,
        S::constant(4.0) / c * a,
        (a + b) * (b + c),
        -(a * c) / b,
        a * b - b * c,
    ]
}

/// Constants with a name must have the values of constants that fold, to the last bit. In single precision, rounding
/// after each operation of a chain may give another result than one rounding at its end. The chain is then folded.
#[test]
fn constants_by_name_have_the_folded_values() {
    #[allow(
        clippy::cast_possible_truncation,
        reason = "rounds to the scene's scalar"
    )]
    let rounded = |precision, value: f64| match precision {
        Precision::F64 => value,
        Precision::F32 => f64::from(value as f32),
    };
    for precision in [Precision::F64, Precision::F32] {
        let (mut by_name, mut folded) = (0, 0);
        for seed in 1..200_u32 {
            let of = |k: f64| rounded(precision, (f64::from(seed) * k).sin() * 3.0);
            let [a, b, c] = [0.7, 1.3, 2.9].map(of);
            let graph = Graph::new(1).in_precision(precision);
            let outputs = chains(
                graph.constant("a", a),
                graph.constant("b", b),
                graph.constant("c", c),
            );
            let plain = chains(Expr::Number(a), Expr::Number(b), Expr::Number(c));
            let both: Vec<_> = outputs.iter().chain(&plain).map(|e| e.operand()).collect();
            let values = match precision {
                Precision::F64 => interpret::<f64>(&graph, &both, |_| None),
                Precision::F32 => interpret::<f32>(&graph, &both, |_| None)
                    .map(|values| values.into_iter().map(f64::from).collect()),
            };
            let values = values.expect("no inputs");
            let (named, plain) = values.split_at(outputs.len());
            for (named, plain) in named.iter().zip(plain) {
                assert_eq!(named.to_bits(), plain.to_bits(), "{a}, {b}, {c}");
            }
            for output in outputs {
                match output {
                    Expr::Node(..) => by_name += 1,
                    Expr::Number(_) => folded += 1,
                }
            }
        }
        println!("{precision:?}: {by_name} by name, {folded} folded");
        assert!(1000 < by_name);
        assert_eq!(precision == Precision::F32, 0 < folded);
    }
}
