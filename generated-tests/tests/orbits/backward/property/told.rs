//! Collects all answers of a system at one point.

use super::BAR;
use super::brute_force::{FASTEST, by_force};
use super::subject::Subject;
use crate::backward::asked::Place;
use crate::backward::judge::{Answer, Judge};
use crate::backward::questions::{Questions, first};
use crate::backward::tally::Tally;
use frictiongen::study::System;
use frictiongen_kernel::Float;
use frictiongen_kernel::number::dd::Dd;
use generated_tests::data::Data;

/// At one of this many points, the test itself searches for the maxima in double-double.
const SEARCHED: u64 = 16;
/// Largest ratio of a natural frequency to r at which the test searches in double-double.
const SEARCHABLE: f64 = 1e3;
/// At one of this many points, the brute-force search runs.
const BY_FORCE: u64 = 8;
/// The test asks for the limit per mode at one of this many points, because that limit needs many searches.
const PER_MODE: u64 = 256;
/// The test asks for the motion of every mass at one of this many points.
const EVERY_MASS: u64 = 16;
/// Largest change, in rad, of the fastest mode's angle if r changes by a rounding unit. With a larger change no digit
/// of U and S is known.
const SLOW: f64 = 1e-3;
/// Largest fraction of V that may be rounding. With a larger fraction no digit of a mass's motion is known, because τ
/// counts from the maximum of the contact's motion.
const LOST: f64 = 1e-2;

/// A point of a random scene, at which all questions are asked.
pub struct Asking<'s, S> {
    pub subject: &'s Subject<S>,
    pub point: u64,
    pub mass: usize,
}

/// Returns all answers of a system at one point, or `None` if the test skips the point.
pub fn told<'e, S: Float>(
    asking: &Asking<'e, S>,
    place: &Place<S>,
    exact: impl Fn(S) -> Dd + Copy,
    tally: &mut Tally,
) -> Option<(Judge<'e>, Vec<Answer>)> {
    let Asking {
        subject,
        point,
        mass,
    } = *asking;
    let system = &subject.system;
    let masses = system.scene().masses.len();
    let number = subject.seed.wrapping_add(point);
    let resonances = &system.modal().resonances;
    let fastest = resonances.last().map_or(1.0, |value| value.to_f64()) / place.r.to_f64();
    let searched = number.is_multiple_of(SEARCHED) && fastest < SEARCHABLE;
    let judge = Judge::new(&subject.exact, place.read(exact), S::EPSILON, BAR);
    let at = system.at(place.r).expect("a ratio in the domain");
    let mut questions = Questions::new(&judge, exact, searched, masses);
    if questions.is_reached() {
        questions.sliding(&at);
    } else {
        tally.skip("limits of a contact that the load does not reach");
    }
    let every: Vec<usize> = (0..masses).collect();
    let asked = if number.is_multiple_of(EVERY_MASS) {
        every
    } else {
        vec![mass]
    };
    if !questions.stuck(&at, &asked, masses) {
        tally.skip("a resonance of the stuck chain");
    }
    // At very small r, a rounding unit of r changes the angles of the modes so much that U and S may have any value.
    let zero = S::constant(0.0);
    let (continuous, without) = (at.continuous_limit(), at.continuous_limit_without_search());
    let nearly = S::constant(1.0 + BAR * S::EPSILON);
    let sane = zero <= continuous && continuous <= without * nearly;
    assert!(
        sane,
        "{continuous:?} above {without:?} at {place:?}, seed {}",
        subject.seed
    );
    if fastest * S::EPSILON > SLOW {
        tally.skip("angles below the rounding of r");
    } else {
        let found = rounded_data(system).at(place.r).velocity_constraint();
        if questions.is_reached() {
            questions.limits(&at, first(&found), number.is_multiple_of(PER_MODE));
        }
        match at.motion(place.beta) {
            // V consists of rounding only.
            _ if questions.faint() * S::EPSILON > LOST => {
                tally.skip("a contact that the load does not reach to rounding");
            }
            Ok(motion) => {
                questions.contact(&motion, place.tau);
                let reduced = system.modal();
                // A mass that rubs on the wall moves as the contact does.
                let rubs =
                    |mass: &usize| !reduced.on_moving_base && reduced.contact == (*mass, None);
                let asked: Vec<usize> = asked.into_iter().filter(|mass| !rubs(mass)).collect();
                questions.masses(&motion, &asked, masses, place.tau);
            }
            Err(error) => tally.skip(refused(error)),
        }
        let searched_by_force = number.is_multiple_of(BY_FORCE);
        if searched_by_force && fastest < FASTEST {
            by_force(&judge, &mut questions.told, fastest, place);
        } else if searched_by_force {
            tally.skip("brute force among fast modes");
        }
    }
    for _ in 0..questions.given_up {
        tally.skip("a search for an amplitude that gave up");
    }
    for _ in 0..questions.unreached {
        tally.skip("a mass that the load does not reach while the contact is stuck");
    }
    let told = questions.told;
    Some((judge, told))
}

fn refused(error: frictiongen::NotContinuous) -> &'static str {
    use frictiongen::NotContinuous;
    match error {
        NotContinuous::StickSlip => "not continuous: stick-slip",
        NotContinuous::Stuck => "not continuous: stuck",
        NotContinuous::Unbounded => "not continuous: unbounded",
        _ => "not continuous: out of the domain",
    }
}

fn rounded_data<S: Float>(system: &System<S>) -> Data<S> {
    let rounded = |value: Dd| S::constant(value.hi) + S::constant(value.lo);
    Data {
        reduced: system.modal().reduced(rounded),
    }
}
