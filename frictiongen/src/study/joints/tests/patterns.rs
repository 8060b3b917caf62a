//! Checks the decision on which contacts stick. A pattern says for each contact that it sticks, or in which direction
//! it slides. The tests compare the decision with a search over all 3^m patterns of m contacts. For μ = 1, they also
//! compare it with the minimum of a convex function.

use super::super::{Heap, Model};
use super::{Chain, Random, rigid};
use frictiongen_kernel::joints;
use frictiongen_model::scene::Node::{self, Mass, Wall};

type Decision<'a> = joints::Decision<'a, f64, Heap>;

/// Creates a random chain of m or m + 1 masses with m contacts, and random forces on the masses. The solver must decide
/// which contacts stick.
fn question(random: &mut Random, count: usize, kinetic: bool) -> (Chain, Vec<f64>) {
    let extra = random.below(2);
    let masses: Vec<f64> = (0..count + extra)
        .map(|_| random.between(0.3, 3.0))
        .collect();
    let contacts = (0..count).map(|i| {
        // Each contact is between its mass and the wall or an earlier mass, so that the contacts form no loop.
        let other: Node = if i == 0 || random.unit() < 0.3 {
            Wall
        } else {
            Mass(random.below(i))
        };
        let stiction = if kinetic {
            1.0
        } else {
            random.between(1.0, 2.0)
        };
        rigid((Mass(i), other), random.between(0.2, 3.0), stiction)
    });
    let contacts = contacts.collect();
    let forces = (0..count + extra)
        .map(|_| random.between(-5.0, 5.0))
        .collect();
    (
        Chain {
            masses,
            contacts,
            ..Chain::default()
        },
        forces,
    )
}

/// Solves a linear system by elimination with pivoting.
fn solve(mut a: Vec<Vec<f64>>, mut b: Vec<f64>) -> Vec<f64> {
    let n = b.len();
    for i in 0..n {
        let pivot = (i..n)
            .max_by(|&p, &q| a[p][i].abs().total_cmp(&a[q][i].abs()))
            .expect("a row");
        a.swap(i, pivot);
        b.swap(i, pivot);
        for k in i + 1..n {
            let factor = a[k][i] / a[i][i];
            let row = a[i].clone();
            for (value, pivot) in a[k].iter_mut().zip(row) {
                *value -= factor * pivot;
            }
            b[k] -= factor * b[i];
        }
    }
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|j| a[i][j] * b[j]).sum();
        b[i] = (b[i] - known) / a[i][i];
    }
    b
}

/// Returns the relative acceleration of each contact, and the force of each sticking contact, for one pattern. The
/// forces come from the dense matrix W_SᵀM⁻¹W_S. M is the mass matrix, and W_S contains the direction vectors of the
/// sticking contacts.
fn dense(chain: &Chain, model: &Model, forces: &[f64], pattern: &[i8]) -> (Vec<f64>, Vec<f64>) {
    let n = chain.masses.len();
    let w = |j: usize| {
        let mut w = vec![0.0; n];
        let c = &model.contacts[j];
        w[c.plus] = 1.0;
        if c.minus < n {
            w[c.minus] = -1.0;
        }
        w
    };
    let ws: Vec<Vec<f64>> = (0..pattern.len()).map(w).collect();
    let mut rest = forces.to_vec();
    for (j, &phase) in pattern.iter().enumerate() {
        for (rest, w) in rest.iter_mut().zip(&ws[j]) {
            *rest -= w * f64::from(phase) * chain.contacts[j].level.constant;
        }
    }
    let product =
        |a: &[f64], b: &[f64]| -> f64 { (0..n).map(|i| a[i] * b[i] / chain.masses[i]).sum() };
    let stuck: Vec<usize> = (0..pattern.len()).filter(|&j| pattern[j] == 0).collect();
    let g = stuck
        .iter()
        .map(|&i| stuck.iter().map(|&j| product(&ws[i], &ws[j])).collect());
    let held = solve(
        g.collect(),
        stuck.iter().map(|&j| product(&ws[j], &rest)).collect(),
    );
    let mut holds = vec![0.0; pattern.len()];
    for (&j, hold) in stuck.iter().zip(held) {
        holds[j] = hold;
        for (rest, w) in rest.iter_mut().zip(&ws[j]) {
            *rest -= w * hold;
        }
    }
    let a: Vec<f64> = rest.iter().zip(&chain.masses).map(|(f, m)| f / m).collect();
    (
        ws.iter()
            .map(|w| (0..n).map(|i| w[i] * a[i]).sum())
            .collect(),
        holds,
    )
}

/// Returns all patterns in the order in which the decision prefers them. Patterns with more sticking contacts come
/// first. Patterns with the same number of sticking contacts have the order of the scene description.
fn all(count: usize) -> Vec<Vec<i8>> {
    let mut all: Vec<Vec<i8>> = (0..3_usize.pow(count as u32))
        .map(|code| {
            (0..count)
                .map(|j| [0, 1, -1][code / 3_usize.pow((count - 1 - j) as u32) % 3])
                .collect()
        })
        .collect();
    all.sort_by_key(|pattern| pattern.iter().filter(|&&phase| phase != 0).count());
    all
}

fn fits(chain: &Chain, model: &Model, forces: &[f64], pattern: &[i8]) -> bool {
    let (rates, holds) = dense(chain, model, forces, pattern);
    pattern.iter().enumerate().all(|(j, &phase)| {
        let contact = &chain.contacts[j];
        if phase == 0 {
            holds[j].abs() <= contact.stiction * contact.level.constant
        } else {
            f64::from(phase) * rates[j] > 0.0
        }
    })
}

fn decision<'a>(
    model: &'a Model,
    chain: &Chain,
    forces: &[f64],
    broke: &[(usize, i8)],
) -> Decision<'a> {
    let mut nodes = forces.to_vec();
    nodes.extend([0.0, 0.0]);
    let contacts = chain.contacts.len();
    let broke = |j| broke.iter().find(|(broke, _)| *broke == j).map(|b| b.1);
    Decision {
        model,
        size: forces.iter().map(|f| f.abs()).sum(),
        forces: nodes.into(),
        base: 0.0,
        levels: chain.contacts.iter().map(|c| c.level.constant).collect(),
        asked: (0..contacts).map(|_| true).collect(),
        broke: (0..contacts).map(|j| broke(j).unwrap_or(0)).collect(),
    }
}

fn decide(decision: &Decision) -> Vec<i8> {
    decision.decide().expect("a pattern").into_vec()
}

/// Compares random decisions with a search over all patterns, with and without contacts that have just broken away.
fn against_all(count: usize) {
    let mut random = Random::new(41);
    let (mut several, mut retried) = (0, 0);
    for index in 0..count {
        let contacts = 1 + random.below(6);
        let (chain, forces) = question(&mut random, contacts, index % 3 == 0);
        let model = chain.model().expect("a chain");
        let all = all(contacts);
        // In half of the cases, some contacts have just broken away. These are the contacts whose force would exceed
        // the static friction force if all contacts stuck.
        let (_, holds) = dense(&chain, &model, &forces, &vec![0; contacts]);
        let exceeds = |&j: &usize| {
            let contact = &chain.contacts[j];
            holds[j].abs() > contact.stiction * contact.level.constant
        };
        let broke: Vec<(usize, i8)> = if index % 2 == 0 {
            vec![]
        } else {
            (0..contacts)
                .filter(exceeds)
                .map(|j| (j, if holds[j] > 0.0 { 1 } else { -1 }))
                .collect()
        };
        let going = |pattern: &&Vec<i8>| broke.iter().all(|&(j, side)| pattern[j] == side);
        let fit: Vec<&Vec<i8>> = all
            .iter()
            .filter(|p| fits(&chain, &model, &forces, p))
            .collect();
        let expected = fit.iter().copied().find(going);
        retried += usize::from(expected.is_none());
        let expected = expected.or(fit.first().copied()).expect("a pattern fits");
        if chain.contacts.iter().all(|c| c.stiction == 1.0) {
            assert_eq!(fit.len(), 1, "{chain:?}");
        }
        several += usize::from(fit.len() > 1);
        let got = decide(&decision(&model, &chain, &forces, &broke));
        assert_eq!(expected, &got, "{index}: broke {broke:?} of {fit:?}");
    }
    println!(
        "{count} questions, {several} with several patterns that fit, {retried} where all were asked"
    );
    assert!(several > count / 100);
}

#[test]
fn decisions_are_those_of_all_patterns() {
    against_all(600);
}

/// Repeats `decisions_are_those_of_all_patterns` with more decisions.
#[test]
#[ignore = "a minute"]
fn decisions_are_those_of_all_patterns_long() {
    against_all(100_000);
}

/// Checks that for μ = 1 the accelerations a minimise Σ ½ma² − Σ Ra + Σ F|wᵀa|. R is the sum of the other forces on a
/// mass, F the friction force of a contact, and w its direction vector.
#[test]
fn accelerations_are_those_of_the_convex_minimum() {
    let mut random = Random::new(5);
    for _ in 0..300 {
        let contacts = 1 + random.below(6);
        let (chain, forces) = question(&mut random, contacts, true);
        let model = chain.model().expect("a chain");
        let question = decision(&model, &chain, &forces, &[]);
        let pattern = decide(&question);
        let (a, _) = question.accelerations(&question.asked, &pattern.into());
        let cost = |a: &[f64]| {
            let masses: f64 = (0..chain.masses.len())
                .map(|i| chain.masses[i] * a[i] * a[i] / 2.0 - forces[i] * a[i])
                .sum();
            let contacts = model.contacts.iter();
            masses
                + contacts
                    .map(|c| c.level.constant * c.across(a).abs())
                    .sum::<f64>()
        };
        let least = cost(&a);
        // A convex function has its minimum at a point if no small step from this point lowers the function.
        for step in [1e-1, 1e-3] {
            for _ in 0..40 {
                let mut other = a.clone();
                for a in other.iter_mut().take(chain.masses.len()) {
                    *a += step * random.between(-1.0, 1.0);
                }
                assert!(cost(&other) > least, "{chain:?}");
            }
        }
    }
}

/// Checks the direction of sliding at a break-away with μ = 1. The acceleration is then 0 apart from rounding errors.
/// The force in the contact must therefore determine the direction.
#[test]
fn what_breaks_away_goes_where_its_force_points() {
    for side in [1.0, -1.0] {
        for noise in [0.0, 1e-15, -1e-15] {
            let chain = Chain {
                masses: vec![3.0],
                contacts: vec![rigid((Mass(0), Wall), 0.7, 1.0)],
                ..Chain::default()
            };
            let model = chain.model().expect("a chain");
            let forces = [side * (0.7 + noise)];
            let broke = [(0, side as i8)];
            assert_eq!(
                decide(&decision(&model, &chain, &forces, &broke)),
                [side as i8]
            );
        }
    }
}

/// Checks that the solver finds a pattern for a chain of sixteen contacts that act on each other, with μ = 1.
#[test]
fn sixteen_contacts_are_decided() {
    let mut random = Random::new(3);
    for _ in 0..200 {
        let contacts = (0..16).map(|i| {
            let other = if i == 0 { Wall } else { Mass(i - 1) };
            rigid((Mass(i), other), random.between(0.2, 3.0), 1.0)
        });
        let chain = Chain {
            contacts: contacts.collect(),
            masses: vec![1.0; 16],
            ..Chain::default()
        };
        let forces: Vec<f64> = (0..16).map(|_| random.between(-5.0, 5.0)).collect();
        let model = chain.model().expect("a chain");
        let pattern = decide(&decision(&model, &chain, &forces, &[]));
        assert!(fits(&chain, &model, &forces, &pattern), "{pattern:?}");
    }
}
