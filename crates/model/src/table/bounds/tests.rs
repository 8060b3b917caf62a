//! Tests the proof of products against double-double numbers, and with faults that the proof has to find.

use super::super::evidence::Evidence;
use super::super::exact::Exact;
use super::super::tables::Tables;
use super::super::zeros::Zeros;
use super::{KnownZero, Product, Proof, Receptances, RoundedInterval, plain};
use crate::modal::Modal;
use crate::samples::{random, request, scene};
use crate::scene::Side;
use frictiongen_kernel::Float;
use frictiongen_kernel::number::complex;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::table::{Factor, Quotient};

/// Kind, number of masses, ζ and μ of each tested chain. If ζ is negative, only every second mode is damped, with the
/// damping ratio |ζ|.
const KINDS: [(&str, usize, f64, f64); 20] = [
    ("Wall", 1, 0.0, 1.0),
    ("Wall", 1, 0.02, 1.2),
    ("Base", 1, 0.0, 1.2),
    ("Base", 2, 0.02, 1.0),
    ("Pair", 2, 0.0, 1.0),
    ("Pair", 5, 0.02, 1.0),
    ("Wall", 5, 0.0, 1.2),
    ("Base", 3, 1.7, 1.0),
    ("Wall", 2, 1.0, 1.1),
    ("Wall", 10, 0.0, 1.0),
    ("Pair", 10, 0.02, 1.2),
    ("Base", 10, 0.0, 1.2),
    ("Wall", 2, -0.02, 1.0),
    ("Base", 3, -0.1, 1.2),
    ("Pair", 5, -0.02, 1.0),
    ("Shaken", 1, 0.2, 1.0),
    ("Shaken", 5, 0.02, 1.2),
    ("Shaken", 2, 1.7, 1.0),
    ("Apart", 3, 0.3, 1.0),
    ("Apart", 5, -0.02, 1.2),
];

fn asked(accuracy: f64, side: Side) -> super::Request {
    super::Request {
        motion: true,
        ..request(accuracy, side)
    }
}

/// Returns β*_lim and |V| at r in double-double, where V is the response of the contact to the load. Each of the two
/// values has a bound on the error of the sum from which the code computes it.
fn exact(exact: &Exact<'_>, r: f64) -> [(Dd, f64); 2] {
    let [v, h] = exact.receptances(r);
    let [v, h] = [v, h].map(|sum| complex::modulus(sum, true));
    let sizes: f64 = exact
        .contact_modes()
        .iter()
        .map(|mode| {
            let sigma = mode.driven.sigma.to_f64();
            let beside = (sigma - r).abs().max(1e-17) * (sigma + r);
            (mode.residue.abs() + mode.driven.inverse_mass).to_f64() / beside
        })
        .sum();
    let off = 1e-29 * (1.0 + sizes);
    let noise = [off / v.to_f64() + off / h.to_f64(), off / v.to_f64()];
    [(v / h / exact.modal.stiction, noise[0]), (v, noise[1])]
}

/// Returns random frequency ratios, and the numbers of the scalar type at and near each zero.
fn places<S: Float>(zeros: &Zeros) -> Vec<f64> {
    let mut state = 5;
    let mut places: Vec<f64> = (0..500)
        .map(|_| S::constant(0.2 + 2.3 * random(&mut state)).to_f64())
        .collect();
    let all = [
        &zeros.excitation,
        &zeros.receptance,
        &zeros.common,
        &zeros.loaded,
    ];
    for zero in all.into_iter().flatten() {
        let y = zero.y.to_f64();
        for step in [0.0, 1.0, -1.0, 2.0, -3.0, 10.0, 1e3, -1e5] {
            places.push(S::constant(y * (1.0 + step * S::EPSILON)).to_f64());
        }
    }
    places.retain(|r| 0.2 < *r && *r < 2.5);
    places
}

fn counted<S: Float>(accuracy: f64, side: Side) -> (usize, usize) {
    let (mut compared, mut proven) = (0, 0);
    for (kind, count, zeta, stiction) in KINDS {
        let modal = scene(kind, count, zeta, stiction);
        let known = Exact::new(&modal);
        let Ok(tables) = Tables::<S>::build(&modal, asked(accuracy, side)) else {
            continue;
        };
        let zeros = Zeros::of(&modal).unwrap();
        let products = [
            (&tables.sliding, &tables.sliding_proof),
            (&tables.excitation, &tables.excitation_proof),
        ];
        for (which, (product, proof)) in products.into_iter().enumerate() {
            // If every mode is damped, the amplitude |V| of the contact without friction is a polynomial of the table.
            // No product exists in this case.
            let Some(product) = product else {
                assert!(which == 1 && tables.functions == 5, "{kind}{count}");
                continue;
            };
            let name = format!("{kind}{count}, {zeta}, {which}: {}", proof.told());
            println!("{name}");
            assert!(proof.evidence != Evidence::Checked, "{name}");
            assert_eq!(proof.open_length(), 0.0, "{name}: {:?}", proof.open);
            assert!(proof.bound.error <= accuracy, "{name}");
            proven += 1;
            for r in places::<S>(&zeros) {
                if proof.open.iter().any(|(at, _)| *at == r) {
                    continue;
                }
                let (expected, noise) = exact(&known, r)[which];
                let own = Dd::from(product.quotient().value(S::constant(r)).to_f64()).abs();
                if expected.is_zero() || !expected.is_finite() {
                    continue;
                }
                let error = (own / expected - Dd::ONE).to_f64();
                assert!(
                    error.abs() <= proof.bound.error + noise,
                    "{name} at {r:?}: {error:e}, noise {noise:e}"
                );
                assert!(
                    which == 1 || side == Side::Near || error >= -noise,
                    "{name} at {r:?}: {error:e}"
                );
                compared += 1;
            }
        }
    }
    (compared, proven)
}

#[test]
fn the_bound_holds() {
    for (accuracy, side) in [(1e-3, Side::Near), (1e-6, Side::Safe), (1e-11, Side::Near)] {
        let (compared, proven) = counted::<f64>(accuracy, side);
        assert!(compared > 20 * 400 && proven >= 20, "{compared}, {proven}");
    }
    for (accuracy, side) in [(1e-4, Side::Near), (1e-3, Side::Safe)] {
        let (compared, proven) = counted::<f32>(accuracy, side);
        assert!(compared > 20 * 400 && proven >= 20, "{compared}, {proven}");
    }
}

/// Returns the number of numbers that a factor stores.
fn numbers<S>(factor: &Factor<S>) -> usize {
    match factor {
        Factor::Zero { .. } => 2,
        Factor::Pair { .. } => 4,
        Factor::Real { .. } => 1,
    }
}

/// Returns a factor in which the number with the index `which` is larger by `by`.
fn moved<S: Float>(factor: Factor<S>, which: usize, by: f64) -> Factor<S> {
    let add = |value: S| S::constant(value.to_f64() + by);
    match factor {
        Factor::Zero { at, rest } if which == 0 => Factor::Zero { at: add(at), rest },
        Factor::Zero { at, rest } => Factor::Zero {
            at,
            rest: add(rest),
        },
        Factor::Real { off } => Factor::Real { off: add(off) },
        Factor::Pair {
            at,
            rest,
            off,
            least,
        } => match which {
            0 => Factor::Pair {
                at: add(at),
                rest,
                off,
                least,
            },
            1 => Factor::Pair {
                at,
                rest: add(rest),
                off,
                least,
            },
            2 => Factor::Pair {
                at,
                rest,
                off: add(off),
                least,
            },
            _ => Factor::Pair {
                at,
                rest,
                off,
                least: add(least),
            },
        },
    }
}

/// Returns the largest relative difference of two products over the range of r.
fn farthest<S: Float>(a: &Quotient<'_, S>, b: &Quotient<'_, S>) -> f64 {
    let places = (0..2000).map(|k| S::constant(0.2 + 2.3 * (k as f64 + 0.5) / 2000.0));
    let ratio = |r: S| (a.value(r).to_f64() / b.value(r).to_f64() - 1.0).abs();
    places.map(ratio).fold(0.0, f64::max)
}

/// Returns true if a product is proven over the whole range of r.
fn passes(proof: &Proof) -> bool {
    proof.evidence != Evidence::Checked && proof.open_length() == 0.0
}

fn faults<S: Float>(accuracy: f64) -> usize {
    let mut found = 0;
    for (kind, count, zeta, stiction) in KINDS {
        let modal: Modal = scene(kind, count, zeta, stiction);
        let asked = asked(accuracy, Side::Near);
        let tables = Tables::<S>::build(&modal, asked).unwrap();
        let (known, zeros) = (Exact::new(&modal), Zeros::of(&modal));
        let receptances = Receptances::of(&known, zeros.as_ref(), 2.5).unwrap();
        for which in 0..2 {
            let Some(own) = [&tables.sliding, &tables.excitation][which].clone() else {
                assert!(which == 1 && tables.functions == 5, "{kind}{count}");
                continue;
            };
            let prove = |product: &Product<S>| match which {
                0 => receptances.sliding(product, &asked),
                _ => receptances.excitation(product, &asked),
            };
            assert!(passes(&prove(&own)), "{kind}{count}");
            for times in [10.0, 1.2, -1.2] {
                let mut wrong = own.clone();
                wrong.gain = S::constant(own.gain.to_f64() * (1.0 + times * accuracy));
                assert!(!passes(&prove(&wrong)), "{kind}{count}: the gain");
                let all = own.numerator.len() + own.denominator.len();
                for place in 0..all {
                    let with = |number: usize, by: f64| {
                        let mut wrong = own.clone();
                        let first = wrong.numerator.len();
                        let factor = if place < first {
                            &mut wrong.numerator[place]
                        } else {
                            &mut wrong.denominator[place - first]
                        };
                        *factor = moved(*factor, number, by);
                        wrong
                    };
                    let factors = own.numerator.iter().chain(&own.denominator);
                    for number in 0..numbers(factors.clone().nth(place).unwrap()) {
                        // The loop adjusts the change `by` until the product is wrong by about `times` the accuracy at
                        // some frequency ratio.
                        let mut by = accuracy * times;
                        for _ in 0..6 {
                            let off = farthest(&with(number, by).quotient(), &own.quotient());
                            by *= (times.abs() * accuracy / off.max(1e-3 * accuracy))
                                .clamp(1e-3, 1e3);
                        }
                        let wrong = with(number, by);
                        let off = farthest(&wrong.quotient(), &own.quotient());
                        if !(off > 1.05 * accuracy) {
                            continue;
                        }
                        assert!(
                            !passes(&prove(&wrong)),
                            "{kind}{count}, {zeta}, {which}: number {number} of factor {place} off by {by:e} passes, {off:e}"
                        );
                        found += 1;
                    }
                }
            }
        }
    }
    found
}

/// Checks that a product is not proven if one of its numbers causes an error as large as the accuracy, or ten times as
/// large.
#[test]
fn a_wrong_number_is_not_proven() {
    let found = faults::<f64>(1e-3) + faults::<f64>(1e-8) + faults::<f32>(1e-4);
    println!("{found} faults");
    assert!(found > 1200, "{found}");
}

/// Checks that the error bound of a product grows with the position error of each zero. The bound includes this error
/// divided by the distance of r from the zero, or half of this quotient for the square root of a product. The test
/// requires only a 25th of the position error.
#[test]
fn uncertain_zeros_are_in_the_bound() {
    let (weight, mut seen) = (1e-6, 0);
    for (kind, count, zeta, stiction) in KINDS {
        let modal = scene(kind, count, zeta, stiction);
        let (known, zeros) = (Exact::new(&modal), Zeros::of(&modal));
        let asked = asked(1e-3, Side::Near);
        let tables = Tables::<f64>::build(&modal, asked).unwrap();
        let product = tables.sliding.unwrap();
        let sound = Receptances::of(&known, zeros.as_ref(), 2.5).unwrap();
        let all = sound.receptance.zeros.len();
        for place in 0..all {
            let mut uncertain = Receptances::of(&known, zeros.as_ref(), 2.5).unwrap();
            uncertain.receptance.zeros[place].1 = weight;
            let (own, sound) = (
                uncertain.sliding(&product, &asked),
                sound.sliding(&product, &asked),
            );
            let more = own.bound.error - sound.bound.error;
            assert!(more > weight / 25.0, "{kind}{count}, {zeta}: {more:e}");
            seen += 1;
        }
        // The remainder of the sum that belongs to no zero is fully part of the bound.
        let mut uncertain = Receptances::of(&known, zeros.as_ref(), 2.5).unwrap();
        uncertain.receptance.tail = weight;
        let own = uncertain.sliding(&product, &asked);
        let more = own.bound.error - sound.sliding(&product, &asked).bound.error;
        assert!(more > 0.9 * weight, "{kind}{count}, {zeta}: {more:e}");
    }
    assert!(seen > 30, "{seen}");
}

/// Checks that the error bound of a factor includes the error of its zero's position.
#[test]
fn an_uncertain_place_is_in_the_bound() {
    let (off, mut seen) = (1e-9, 0);
    for (kind, count, zeta, stiction) in KINDS {
        let modal = scene(kind, count, zeta, stiction);
        let zeros = Zeros::of(&modal).unwrap();
        let tables = Tables::<f64>::build(&modal, asked(1e-3, Side::Near)).unwrap();
        let product = tables.sliding.unwrap();
        for (factor, zero) in product.denominator.iter().zip(&zeros.receptance) {
            let place = zero.y.to_f64().max(0.1);
            let cell = RoundedInterval {
                low: 1.2 * place,
                high: 1.3 * place,
            };
            let error = |off| {
                let known = KnownZero {
                    off,
                    ..plain(*zero)
                };
                known.bounds::<f64>(factor, cell).unwrap().error
            };
            let away = (zero.x.to_f64()).hypot(0.3 * place) + place;
            let more = error(off) - error(0.0);
            assert!(more > off / away, "{kind}{count}, {zeta}: {more:e}");
            seen += 1;
        }
    }
    assert!(seen > 30, "{seen}");
}

/// Checks that the proof reports a frequency ratio that it leaves out. Two masses rub on each other, and the load acts
/// on the second. The contact's response V to the load has the numerator 1 − r². V vanishes at r = 1, the only r
/// without a proof.
#[test]
fn a_zero_that_is_a_number_is_named() {
    let modal = scene("Pair", 2, 0.0, 1.0);
    let tables = Tables::<f64>::build(&modal, asked(1e-3, Side::Near)).unwrap();
    assert_eq!(tables.sliding_proof.open, [(1.0, 1.0)]);
    assert_eq!(tables.sliding_proof.evidence, Evidence::Partly);
}

/// Checks that the weight of a zero reveals an error of the zero, even an error far smaller than the accuracy.
#[test]
fn zeros_that_are_none() {
    for (kind, count, zeta, stiction) in KINDS {
        let modal = scene(kind, count, zeta, stiction);
        let known = Exact::new(&modal);
        let zeros = Zeros::of(&modal).unwrap();
        let sound = Receptances::of(&known, Some(&zeros), 2.5).unwrap();
        for place in 0..zeros.receptance.len() {
            let mut wrong = zeros.clone();
            let by = Dd::from(1e-15);
            wrong.receptance[place].y = wrong.receptance[place].y * (Dd::ONE + by);
            if wrong.receptance[place].y.is_zero() {
                wrong.receptance[place].x = wrong.receptance[place].x * (Dd::ONE + by);
            }
            let weight = |of: &Receptances| of.receptance.zeros[place].1;
            let wrong = Receptances::of(&known, Some(&wrong), 2.5);
            let seen = wrong.as_ref().map_or(f64::INFINITY, weight);
            assert!(
                seen > 1e-17 && seen > 1e6 * weight(&sound),
                "{kind}{count}: {seen:e}"
            );
        }
        // If one zero is missing, the product is not equal to the sum.
        let mut fewer = zeros.clone();
        if fewer.receptance.pop().is_some() {
            let few = Receptances::of(&known, Some(&fewer), 2.5);
            assert!(
                few.is_none_or(|few| few.receptance.tail > 1.0),
                "{kind}{count}"
            );
        }
    }
}
