//! Decisions of several rigid contacts, against enumeration of all patterns and against a convex minimum.

use crate::scene::{between, direction, ground};
use frictiongen::kernel::joints::{Candidate, Chain, Joint, MAX_JOINTS, Phase, Resting, decide};
use fuzzing::Random;
use nalgebra::{DMatrix, DVector};

const NOTHING: Resting<f64> = Resting {
    phase: Phase::Stuck,
    force: 0.0,
};

/// A random decision of 1 to 6 contacts that form no loop.
struct Decision {
    candidates: Vec<Candidate<f64>>,
    mobility: DMatrix<f64>,
}

impl Decision {
    fn new(random: &mut Random, most_stiction: f64) -> Self {
        let m = 1 + random.below(6);
        let masses: Vec<_> = (0..m).map(|_| random.between(0.5, 4.0)).collect();
        // Contact i joins mass i with the ground or with a mass before it.
        let mut w = DMatrix::zeros(m, m);
        for i in 0..m {
            let other = random.below(i + 1);
            let link = if other == i {
                ground(i)
            } else {
                between(other, i)
            };
            for (mass, sign) in direction(&link, m).into_iter().enumerate() {
                w[(mass, i)] = sign;
            }
        }
        let inverse = DMatrix::from_fn(m, m, |i, j| if i == j { 1.0 / masses[i] } else { 0.0 });
        let candidate = |random: &mut Random| Candidate {
            acceleration: random.between(-3.0, 3.0),
            level: random.between(0.1, 2.0),
            stiction: if most_stiction > 1.0 {
                random.between(1.0, most_stiction)
            } else {
                1.0
            },
            gone: Phase::Stuck,
            rounding: 0.0,
        };
        let candidates = (0..m).map(|_| candidate(random)).collect();
        Self {
            candidates,
            mobility: w.transpose() * inverse * w,
        }
    }
    fn decided(&self) -> Vec<Resting<f64>> {
        let mut mobility = [[0.0; MAX_JOINTS]; MAX_JOINTS];
        let m = self.candidates.len();
        for i in 0..m {
            for j in 0..m {
                mobility[i][j] = self.mobility[(i, j)];
            }
        }
        let mut answers = [NOTHING; MAX_JOINTS];
        decide(&self.candidates, &mobility, &mut answers).expect("a pattern");
        answers[..m].to_vec()
    }
    /// Returns the forces of a pattern, 0 for a contact that sticks, if it fits.
    fn forces(&self, pattern: &[usize]) -> Option<DVector<f64>> {
        let m = pattern.len();
        let sign = |i: usize| [0.0, 1.0, -1.0][pattern[i]];
        let mut left = DMatrix::zeros(m, m);
        let mut right = DVector::zeros(m);
        for i in 0..m {
            if pattern[i] == 0 {
                left.set_row(i, &self.mobility.row(i));
                right[i] = self.candidates[i].acceleration;
            } else {
                left[(i, i)] = 1.0;
                right[i] = sign(i) * self.candidates[i].level;
            }
        }
        let forces = left.lu().solve(&right)?;
        let moved = &self.mobility * &forces;
        let good = (0..m).all(|i| {
            let candidate = &self.candidates[i];
            let acceleration = candidate.acceleration - moved[i];
            if pattern[i] == 0 {
                forces[i].abs() <= candidate.stiction * candidate.level
            } else {
                sign(i) * acceleration > 0.0
            }
        });
        good.then_some(forces)
    }
    /// Returns the pattern of the rule: the most stuck contacts, then the first in the order of the contacts.
    fn enumerated(&self) -> (Vec<usize>, DVector<f64>, usize) {
        let m = self.candidates.len();
        let mut best: Option<(Vec<usize>, DVector<f64>)> = None;
        let mut count = 0;
        for code in 0..3usize.pow(u32::try_from(m).expect("few")) {
            // The first contact is the leading digit.
            let pattern: Vec<_> = (0..m)
                .map(|i| code / 3usize.pow(u32::try_from(m - 1 - i).expect("few")) % 3)
                .collect();
            let Some(forces) = self.forces(&pattern) else {
                continue;
            };
            count += 1;
            let stuck = |pattern: &[usize]| pattern.iter().filter(|&&phase| phase == 0).count();
            if best
                .as_ref()
                .is_none_or(|(best, _)| stuck(best) < stuck(&pattern))
            {
                best = Some((pattern, forces));
            }
        }
        let (pattern, forces) = best.expect("a pattern");
        (pattern, forces, count)
    }
}

fn digit(phase: Phase) -> usize {
    match phase {
        Phase::Positive => 1,
        Phase::Negative => 2,
        Phase::Stuck | Phase::Free => 0,
    }
}

/// Compares decisions with enumeration. Returns how many had more than one pattern that fits.
fn enumerate(decisions: u32, most_stiction: f64) -> u32 {
    let mut random = Random(46);
    let mut several = 0;
    for index in 0..decisions {
        let decision = Decision::new(&mut random, most_stiction);
        let decided = decision.decided();
        let (pattern, forces, count) = decision.enumerated();
        several += u32::from(count > 1);
        let found: Vec<_> = decided.iter().map(|answer| digit(answer.phase)).collect();
        assert_eq!(found, pattern, "decision {index}");
        for (answer, force) in decided.iter().zip(forces.iter()) {
            assert!(
                (answer.force - force).abs() < 1e-11,
                "decision {index}: {} {force}",
                answer.force
            );
        }
    }
    several
}

#[test]
fn decisions_follow_the_rule_among_all_patterns() {
    // With μ = 1 the pattern is unique; above it often is not.
    assert_eq!(enumerate(1000, 1.0), 0);
    assert!(enumerate(1000, 2.0) > 10);
}

#[test]
#[ignore = "slow: 100,000 decisions"]
fn many_decisions_follow_the_rule_among_all_patterns() {
    assert_eq!(enumerate(50_000, 1.0), 0);
    assert!(enumerate(50_000, 2.0) > 500);
}

/// With μ = 1 the forces minimise ½fᵀAf − bᵀf within |f| ≤ F.  The minimum comes from coordinate descent.
#[test]
fn forces_without_stiction_are_a_convex_minimum() {
    let mut random = Random(4646);
    for index in 0..500 {
        let decision = Decision::new(&mut random, 1.0);
        let m = decision.candidates.len();
        let mut forces = vec![0.0; m];
        for _ in 0..20_000 {
            let mut change = 0.0f64;
            for i in 0..m {
                let candidate = &decision.candidates[i];
                let others: f64 = (0..m)
                    .filter(|&j| j != i)
                    .map(|j| decision.mobility[(i, j)] * forces[j])
                    .sum();
                let force = (candidate.acceleration - others) / decision.mobility[(i, i)];
                let force = force.clamp(-candidate.level, candidate.level);
                change = change.max((force - forces[i]).abs());
                forces[i] = force;
            }
            if change < 1e-15 {
                break;
            }
        }
        for (answer, force) in decision.decided().iter().zip(&forces) {
            assert!(
                (answer.force - force).abs() < 1e-9,
                "decision {index}: {} {force}",
                answer.force
            );
        }
    }
}

/// A contact that broke away goes although it could stick, and sticks if no pattern lets it go.
#[test]
fn what_broke_away_goes_if_a_pattern_lets_it_go() {
    let mut mobility = [[0.0; MAX_JOINTS]; MAX_JOINTS];
    mobility[0][0] = 1.0;
    let mut candidate = Candidate {
        acceleration: 1.5,
        level: 1.0,
        stiction: 2.0,
        gone: Phase::Stuck,
        rounding: 0.0,
    };
    let phase = |candidate: Candidate<f64>| {
        let mut answers = [NOTHING; MAX_JOINTS];
        decide(&[candidate], &mobility, &mut answers).expect("a pattern");
        answers[0].phase
    };
    assert_eq!(phase(candidate), Phase::Stuck);
    candidate.gone = Phase::Positive;
    assert_eq!(phase(candidate), Phase::Positive);
    candidate.gone = Phase::Negative;
    assert_eq!(phase(candidate), Phase::Stuck);
}

/// Rigid contacts whose holding forces are not determined are found: a pair twice, and a loop through the ground.
#[test]
fn loops_of_rigid_contacts_are_redundant() {
    let redundant = |links: &[(Option<usize>, Option<usize>)], stiffness: Option<f64>| {
        let joint = |&(from, to): &(Option<usize>, Option<usize>)| Joint {
            link: frictiongen::kernel::joints::Link {
                from,
                to,
                base: 0.0,
            },
            stiffness: None,
            stiction: 1.0,
        };
        let mut joints: Vec<_> = links.iter().map(joint).collect();
        joints.last_mut().expect("a contact").stiffness = stiffness;
        Chain {
            masses: &[1.0; 4],
            springs: &[],
            dampers: &[],
            damping: &[],
            joints: &joints,
        }
        .is_redundant()
    };
    let chain = [(None, Some(0)), (Some(0), Some(1)), (Some(1), Some(2))];
    assert!(!redundant(&chain, None));
    let twice = [(Some(0), Some(1)), (Some(0), Some(1))];
    assert!(redundant(&twice, None));
    assert!(!redundant(&twice, Some(1.0)));
    let ring = [
        (Some(2), Some(3)),
        (None, Some(3)),
        (None, Some(0)),
        (Some(0), Some(1)),
        (Some(1), Some(2)),
    ];
    assert!(redundant(&ring, None));
    assert!(!redundant(&ring, Some(1.0)));
}
