//! Judges answers for the scenes of `reference/extremes.json`. Their points are near poles and subharmonics, and at r
//! = 0 and r = ∞. Some scenes have vanishing, critical or over-critical damping, masses and springs spread over
//! twelve decades, or nearly equal modes.

use crate::backward::asked::{Asked, Of, Place, Watched, motion};
use crate::backward::inputs::Exact;
use crate::backward::judge::{Answer, Judge, modulus};
use crate::backward::questions::first;
use crate::backward::tally::Tally;
use frictiongen::study::System;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::{Complex, Float};
use generated_tests::reference::{description, exact};
use serde_json::Value;

/// Largest accepted backward error, in rounding units 2^-52 of each input.
const BAR: f64 = 64.0;

/// Number of scenes and values in the reference.
const SCENES: u64 = 48;
const VALUES: u64 = 2337;
/// Number of reference values in scenes with nearly equal modes.
const ILL_VALUES: u64 = 44;
/// Factor by which the backward errors in scenes with nearly equal modes may exceed `BAR`.
const ILL: f64 = 64.0;

fn scenes() -> Vec<Value> {
    serde_json::from_str(include_str!("../../../reference/extremes.json")).expect("JSON")
}

fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

/// Reads a number of the reference, which is written as an exact double.
fn double(value: &Value) -> f64 {
    match value {
        Value::String(text) => text.parse().expect("a number"),
        value => value.as_f64().expect("a number"),
    }
}

struct Case {
    asked: Asked,
    want: Dd,
}

/// One point (r, β, τ) of the reference, with all reference values at this point.
struct Cases {
    name: String,
    place: Place<f64>,
    cases: Vec<Case>,
}

fn cases(scene: &Value) -> Vec<Cases> {
    let mut all = Vec::new();
    for point in list(&scene["points"]) {
        let r = double(&point["r"]);
        let mut at = |beta: f64, known: Vec<(Asked, &Value)>| {
            let known = known.into_iter().filter(|(_, value)| !value.is_null());
            all.push(Cases {
                name: format!("{}, r = {r}, beta = {beta}", scene["name"]),
                place: Place { r, beta, tau: 1.0 },
                cases: known
                    .map(|(asked, known)| Case {
                        asked,
                        want: exact(known),
                    })
                    .collect(),
            });
        };
        let limits = [
            (Asked::ContinuousLimit, "continuous_limit"),
            (Asked::WithoutSearch, "continuous_limit_without_search"),
            (Asked::SlidingLimit, "sliding_limit"),
        ];
        at(0.0, limits.map(|(asked, key)| (asked, &point[key])).into());
        for motion in list(&point["motions"]) {
            let mut known = vec![
                (Asked::Amplitude(Of::Contact), &motion["contact_amplitude"]),
                (Asked::Phase(Of::Contact), &motion["contact_phase"]),
            ];
            let displacements = list(&motion["displacement_at_1"]).iter().enumerate();
            known.extend(
                displacements.map(|(mass, value)| (Asked::Displacement(Of::Mass(mass)), value)),
            );
            at(double(&motion["beta"]), known);
        }
    }
    all
}

/// Returns the answer of a system to a question, through its public interface.
fn ask<S: Float>(system: &System<S>, name: &str, place: &Place<f64>, asked: Asked) -> S {
    let constant = |value: f64| S::constant(value);
    let at = system.at(constant(place.r)).expect("in the domain");
    let motion = || {
        at.motion(constant(place.beta))
            .unwrap_or_else(|error| panic!("{name}: {error}"))
    };
    match asked {
        Asked::ContinuousLimit => at.continuous_limit(),
        Asked::WithoutSearch => at.continuous_limit_without_search(),
        Asked::SlidingLimit => at.sliding_limit(),
        Asked::Amplitude(Of::Contact) => motion().contact().amplitude(),
        Asked::Phase(Of::Contact) => motion().contact().phase(),
        Asked::Displacement(Of::Mass(mass)) => motion()
            .mass_at(mass)
            .expect("a mass")
            .displacement(constant(1.0)),
        other => panic!("the reference has no {other:?}"),
    }
}

/// Converts the result for a case to an answer that the judge takes. The error of a displacement is divided by the
/// size of its motion, and that of a phase by π. The error of every other value is divided by the value itself.
fn told(judge: &Judge<'_>, case: &Case, got: Dd) -> Answer {
    let real = |value: Dd| Complex::new(value, Dd::from(0.0));
    let instant = match case.asked {
        Asked::ContinuousLimit => first(&judge.at().velocity_constraint()),
        _ => None,
    };
    let own = match case.asked {
        Asked::Phase(_) => Dd::PI,
        Asked::Displacement(of) => {
            let motion = motion(judge.at(), of, judge.place().beta);
            motion.amplitude_monoharmonic().max(case.want.abs())
        }
        _ => modulus(real(case.want)),
    };
    Answer {
        watched: Watched {
            asked: case.asked,
            instant,
            lag: None,
        },
        got: real(got),
        searched: true,
        size: own,
        strict: own,
        own,
    }
}

/// Compares every value of the reference with the results of systems over one scalar type. `epsilon` is the rounding
/// unit of the scenes' inputs.
fn compared<S: Float>(epsilon: f64, read: impl Fn(S) -> Dd) -> Tally {
    let mut tally = Tally::default();
    let mut worst_of_ill: f64 = 0.0;
    for scene in scenes() {
        let system: System<S> = description(&scene).parse().expect("a valid scene");
        let reference = Exact::of(&description(&scene).parse().expect("a valid scene"));
        tally.scenes += 1;
        for Cases { name, place, cases } in cases(&scene) {
            let real = |value: Dd| Complex::new(value, Dd::from(0.0));
            if place.r == 0.0 || !place.r.is_finite() {
                for case in &cases {
                    let got = read(ask(&system, &name, &place, case.asked));
                    let (got, want) = (got.to_f64(), case.want.to_f64());
                    let off = (got - want).abs();
                    assert!(
                        got == want || off <= 4.0 * f64::EPSILON * want.abs(),
                        "{name}: {got:e}, reference {want:e}"
                    );
                    tally.skip("an end of the range of r, to four roundings");
                }
                continue;
            }
            let judge = Judge::new(&reference, place.read(Dd::from), epsilon, BAR);
            let ask = |case: &Case| read(ask(&system, &name, &place, case.asked));
            let answers: Vec<Answer> = cases
                .iter()
                .map(|case| told(&judge, case, ask(case)))
                .collect();
            let want: Vec<_> = cases.iter().map(|case| real(case.want)).collect();
            let verdict = judge.compared(&answers, &want);
            if !verdict.keeps(BAR) && is_ill_conditioned(&scene) {
                worst_of_ill = worst_of_ill.max(verdict.alone);
                tally.skip("nearly equal modes, which the scene does not tell apart so well");
                continue;
            }
            tally.note(&answers, &verdict, BAR, || name.clone());
        }
    }
    println!("nearly equal modes: {worst_of_ill:.0} roundings of the scene");
    assert!(worst_of_ill < ILL * BAR, "{worst_of_ill}");
    tally
}

/// Returns true if modes are so close to each other that rounding of the modal data loses their difference.
fn is_ill_conditioned(scene: &Value) -> bool {
    scene["name"] == "nearly equal modes"
}

/// Checks the double-double evaluation against the 20 digits of the JSON file. All other tests of this folder use the
/// double-double evaluation as the reference.
#[test]
fn double_double_is_a_reference() {
    let tally = compared::<Dd>(2f64.powi(-64), |value| value);
    tally.print("double-double, in roundings of 2^-64");
    assert_eq!(tally.above.len(), 0);
    assert_eq!((tally.scenes, tally.answers()), (SCENES, VALUES));
}

/// Compares every value of the reference with the run-time system.
#[test]
fn every_value() {
    let tally = compared::<f64>(f64::EPSILON, Dd::from);
    tally.print("f64");
    assert_eq!(tally.above.len(), 0);
    assert_eq!(tally.scenes, SCENES);
    assert_eq!(tally.answers(), VALUES - ILL_VALUES);
}
