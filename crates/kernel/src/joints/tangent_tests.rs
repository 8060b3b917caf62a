//! Compares the derivatives of a motion with central differences, on random chains of one to four contacts.

#![allow(clippy::indexing_slicing, reason = "a test may fail")]

use super::heap::{Heap, Short};
use super::model::{Contact, Link, Model};
use super::run::Motion;
use super::steady::Search;
use super::tangent::ShotSpan;
use super::wave::Wave;
use fuzzing::Random;

/// Step of the differences, in units of the unknowns.
const STEP: f64 = 1e-6;

pub(super) fn between(random: &mut Random, low: f64, high: f64) -> f64 {
    low + (high - low) * 0.5 * (1.0 + random.signed())
}

/// Returns a chain of masses between springs, with contacts between neighbours, the wall and the base.
pub(super) fn chain(random: &mut Random, omega: f64) -> Model<f64, Heap> {
    let below = |random: &mut Random, count: usize| between(random, 0.0, count as f64) as usize;
    let masses = 1 + below(random, 4);
    let (wall, base) = (masses, masses + 1);
    let before = |mass: usize| if mass == 0 { base } else { mass - 1 };
    let springs: Vec<Link<f64>> = (0..masses)
        .map(|mass| (mass, before(mass), between(random, 0.5, 4.0)))
        .collect();
    let dashpots: Vec<_> = springs.iter().map(|&(a, b, k)| (a, b, 0.05 * k)).collect();
    let mut contacts: Short<Contact<f64>> = Short::new();
    for mass in 0..masses {
        let minus = if random.signed() > 0.0 {
            wall
        } else {
            before(mass)
        };
        let stiffness = (random.signed() > 0.0).then(|| between(random, 1.0, 20.0));
        let stiction = if random.signed() > 0.0 {
            1.0
        } else {
            between(random, 1.0, 1.5)
        };
        // Rigid contacts must not form a loop.
        let is_second = stiffness.is_none()
            && minus >= wall
            && contacts.iter().any(|c: &Contact<f64>| c.is_rigid());
        if random.signed() > -0.5 && !is_second {
            let level = Wave::constant(between(random, 0.05, 0.6));
            contacts.push(Contact {
                plus: mass,
                minus,
                level,
                stiction,
                stiffness,
                speed: 0.0,
                stop: None,
            });
        }
    }
    let on_base = random.signed() > 0.0;
    let load = Wave::harmonic(1.0, omega);
    let mut model = Model {
        size: Heap {
            masses,
            contacts: contacts.len(),
            loads: 1,
        },
        masses: (0..masses).map(|_| between(random, 0.5, 2.0)).collect(),
        springs: springs.into(),
        dashpots: dashpots.into(),
        damping: [].into(),
        damping_from_base: false,
        contacts,
        law: Vec::new(),
        loads: [(masses - 1, if on_base { Wave::zero() } else { load })]
            .into_iter()
            .collect(),
        base: if on_base { load } else { Wave::zero() }.into(),
        stretch: 0.0,
    };
    model.set_stretch();
    model
}

/// Returns a search in which the positions of all contacts are unknowns, with or without tables.
fn all(motion: &Motion<f64, Heap>, omega: f64, by_tables: bool) -> Search<f64, Heap> {
    let new = if by_tables {
        Search::by_tables
    } else {
        Search::new
    };
    let mut search = new(motion, omega, 1.0);
    search.moving.fill(true);
    search
}

/// Returns the largest difference of the derivatives of a cycle from central differences, divided by the largest
/// derivative.
fn differs(motion: &Motion<f64, Heap>, search: &mut Search<f64, Heap>) -> f64 {
    let span = ShotSpan::Cycles(1);
    let shot = search.shoot(motion, span, true).expect("a motion");
    let derivatives = shot.derivatives.expect("derivatives");
    let every = search.moving.clone();
    let unknowns = search.unknowns().of(&every);
    let from = unknowns.read(motion);
    let mut worst = 0.0_f64;
    let size = derivatives.iter().fold(1.0_f64, |m, d| m.max(d.abs()));
    for column in 0..from.len() {
        let ends = [STEP, -STEP].map(|step| {
            let mut moved = from.clone();
            moved[column] += step;
            let mut end = unknowns.write(motion, &moved);
            search.pass(&mut end, span, &mut ()).expect("a motion");
            unknowns.read(&end)
        });
        for (row, (plus, minus)) in ends[0].iter().zip(&ends[1]).enumerate() {
            // The position of a contact that never slides is no unknown.
            let is_kept = |index: usize| {
                let contact = index.checked_sub(2 * motion.model().wall());
                contact.is_none_or(|j| shot.moving[j])
            };
            if is_kept(row) && is_kept(column) {
                let difference = (*plus - minus) / (2.0 * STEP);
                let exact = derivatives[column * from.len() + row];
                worst = worst.max((difference - exact).abs() / size);
            }
        }
    }
    worst
}

#[test]
fn derivatives_are_differences() {
    let mut random = Random(17);
    let (mut misses, mut compared, mut several) = (0, 0, 0);
    for index in 0..400 {
        let omega = between(&mut random, 0.2, 2.5);
        let model = chain(&mut random, omega);
        let (contacts, masses) = (model.contacts.len(), model.masses.len());
        let rest = vec![0.0; masses];
        let mut motion = Motion::new(model, &rest, &rest).expect("a chain");
        let mut search = all(&motion, omega, index % 2 == 0);
        search.advance(&mut motion, 6, &mut ()).expect("a motion");
        let state = motion.state().clone();
        motion.restart(state);
        let differs = differs(&motion, &mut search);
        // Differences have an error of some 1e-10 of the largest derivative, divided by their step.
        misses += usize::from(differs > 1e-5);
        compared += 1;
        several += usize::from(contacts > 1);
    }
    println!("{misses} of {compared} differ, {several} with several contacts");
    assert!(
        misses == 0 && several > 100,
        "{misses} of {compared}, {several}"
    );
}
