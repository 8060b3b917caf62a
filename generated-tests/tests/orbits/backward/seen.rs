//! Tests that the judge refuses faulty answers: answers that are off by a thousand rounding units, NaN, and the
//! instant of another maximum. No displacement of the inputs explains a faulty answer.

use crate::backward::asked::{Asked, Of, Place};
use crate::backward::inputs::Exact;
use crate::backward::judge::{Answer, Judge};
use crate::backward::property::BAR;
use crate::backward::questions::Questions;
use frictiongen::study::System;
use frictiongen_kernel::Complex;
use frictiongen_kernel::number::dd::Dd;
use std::collections::BTreeMap;

/// Error that the tests add to an answer, in rounding units of its size.
const FAULT: f64 = 1e3;

/// Scenes of one to four masses, with every contact, damped and undamped.
const SCENES: [&str; 6] = [
    "struct One { masses: { a: 1.0 }, springs: { base - a: 1.3 }, contact: a - wall, excitation: a, stiction: 1.2 }",
    "struct Pair { masses: { a: 1.0, b: 0.6 }, springs: { base - a: 1.3, a - b: 0.7 }, contact: a - wall,
     excitation: b, stiction: 1.2 }",
    "struct Pair { masses: { a: 1.0, b: 0.6 }, springs: { base - a: 1.3, a - b: 0.7 }, contact: b - base,
     excitation: base, damping: modal(0.02) }",
    "struct Three { masses: { a: 1.0, b: 0.6, c: 1.7 }, springs: { base - a: 1.3, a - b: 0.7, b - c: 2.1 },
     contact: a - c, excitation: b, damping: rayleigh(0.02, 0.03), stiction: 1.5 }",
    "struct Three { masses: { a: 1.0, b: 0.6, c: 1.7 }, springs: { base - a: 1.3, a - b: 0.7, b - c: 2.1, c - wall: 0.4 },
     contact: b - wall, excitation: base, stiction: 1.1 }",
    "struct Four { masses: { a: 1.0, b: 0.6, c: 1.7, d: 0.9 },
     springs: { base - a: 1.3, a - b: 0.7, b - c: 2.1, c - d: 1.1 },
     contact: d - wall, excitation: a, damping: modal[0.01, 0.3, 1.0, 1.7], stiction: 1.3 }",
];

/// Calls `visit` for each scene at several frequencies: ordinary frequencies, and frequencies a thousandth away from
/// a resonance or a subharmonic, where condition numbers are 10³.
fn each_place(mut visit: impl FnMut(&Judge<'_>, &[Answer], &str)) {
    for text in SCENES {
        let system: System = text.parse().expect("a scene");
        let exact = Exact::of(&text.parse().expect("a scene"));
        let masses = system.scene().masses.len();
        let resonances = system.resonances();
        let first = resonances[0];
        for r in [0.9, 1.7, first * 1.001, first / 3.0 * 0.999] {
            let at = system.at(r).expect("in the domain");
            let beta = 0.4 * at.continuous_limit().min(at.sliding_limit());
            let place = Place { r, beta, tau: 0.8 };
            let judge = Judge::new(&exact, place.read(Dd::from), f64::EPSILON, BAR).at_once();
            let mut questions = Questions::new(&judge, Dd::from, true, masses);
            questions.sliding(&at);
            let all: Vec<usize> = (0..masses).collect();
            assert!(questions.stuck(&at, &all, masses), "{text} at {r}");
            questions.limits(&at, None, true);
            let motion = at.motion(beta).expect("below both limits");
            questions.contact(&motion, 0.8);
            let modal = system.modal();
            let rubs = |mass: &usize| !modal.on_moving_base && modal.contact == (*mass, None);
            let moving: Vec<usize> = all.into_iter().filter(|mass| !rubs(mass)).collect();
            questions.masses(&motion, &moving, masses, 0.8);
            let told = questions.told;
            visit(&judge, &told, &format!("{text} at r = {r}"));
        }
    }
}

#[test]
fn what_is_right_is_below_the_bar() {
    let mut places = 0;
    each_place(|judge, told, place| {
        let verdict = judge.verdict(told);
        assert!(verdict.keeps(BAR), "{place}: {verdict:?}");
        places += 1;
    });
    println!("{places} places");
    assert_eq!(places, 24);
}

/// Checks that an error of a thousand rounding units in one answer exceeds the accepted error. All other answers are
/// right.
#[test]
fn a_thousand_roundings_are_above_it() {
    let mut seen: BTreeMap<&str, (u64, u64)> = BTreeMap::new();
    each_place(|judge, told, place| {
        for (index, answer) in told.iter().enumerate() {
            let mut faulty = told.to_vec();
            faulty[index].got.re = answer.got.re + answer.size * Dd::from(FAULT * f64::EPSILON);
            let found = !(judge.verdict(&faulty).together <= BAR);
            let (all, missed) = seen.entry(answer.watched.asked.kind()).or_default();
            *all += 1;
            *missed += u64::from(!found);
            if !found {
                println!("missed {:?} at {place}", answer.watched.asked);
            }
        }
    });
    report(&seen, 17);
}

/// Checks that NaN in place of any answer exceeds the accepted error.
#[test]
fn nan_is_above_it() {
    let mut seen: BTreeMap<&str, (u64, u64)> = BTreeMap::new();
    each_place(|judge, told, _| {
        for (index, answer) in told.iter().enumerate() {
            let mut faulty = told.to_vec();
            faulty[index].got = Complex::new(Dd::from(f64::NAN), Dd::from(0.0));
            let found = !(judge.verdict(&faulty).together <= BAR);
            let (all, missed) = seen.entry(answer.watched.asked.kind()).or_default();
            *all += 1;
            *missed += u64::from(!found);
        }
    });
    report(&seen, 17);
}

/// Checks that an error of 1.5 rad in the contact's phase exceeds the accepted error.
#[test]
fn another_phase_is_above_it() {
    let mut seen: BTreeMap<&str, (u64, u64)> = BTreeMap::new();
    each_place(|judge, told, _| {
        for (index, answer) in told.iter().enumerate() {
            if answer.watched.asked == Asked::Phase(Of::Contact) {
                let mut faulty = told.to_vec();
                faulty[index].got.re = answer.got.re + Dd::from(1.5);
                let found = !(judge.verdict(&faulty).together <= BAR);
                let (all, missed) = seen.entry("contact phase").or_default();
                *all += 1;
                *missed += u64::from(!found);
            }
        }
    });
    report(&seen, 1);
}

/// Asserts that every kind of question was asked, and that the judge refused every fault.
fn report(seen: &BTreeMap<&str, (u64, u64)>, kinds: usize) {
    for (kind, (all, missed)) in seen {
        println!("{kind:>22}: {all} faults, {missed} missed");
    }
    assert_eq!(seen.len(), kinds);
    let missed: u64 = seen.values().map(|(_, missed)| missed).sum();
    assert_eq!(missed, 0);
}
