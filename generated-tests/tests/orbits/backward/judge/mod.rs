//! Computes the backward error of the answers at one point: the number of rounding units by which the scene's inputs
//! must change so that all answers are exact.
//!
//! The inputs are the numbers of the description (masses, springs, damping, μ) and r, β and τ. The answers have the
//! backward error k if they are the exact answers of one scene whose inputs differ by at most k rounding units. Each
//! answer may also be off by k rounding units of its own size. With exact first derivatives, a Chebyshev fit gives
//! the smallest k. A few rounding units away from a pole, the derivatives themselves change within a rounding unit of
//! r. They are then evaluated again at the r and β that the fit has found.
//!
//! This module has the answers and the verdict on a point. `error` computes the error of an answer, and `linear` the
//! equations of the fit. `turning` chooses the displacements at which the code re-evaluates the derivatives.

mod error;
mod linear;
mod turning;

use crate::backward::asked::{Asked, Place, Watched, answers};
use crate::backward::inputs::Exact;
pub use error::{angle, modulus};
use error::{error, is_finite, may_be_infinite, same};
use frictiongen_kernel::Complex;
use frictiongen_kernel::number::dd::Dd;
use generated_tests::data::{Data, DataAt};
use linear::Linear;
use turning::Turning;

/// Error, in rounding units, up to which no displacement of the inputs is needed as an explanation.
pub const PLAIN: f64 = 4.0;
/// Largest accepted error of any answer, in rounding units. A stuck response is a difference of free responses, which
/// may be larger than the stuck response by this factor.
const MOST: f64 = 4096.0;
/// Condition number above which the answers of a point need not be exact for one common displacement. The answers are
/// different sums, and the condition number magnifies the rounding of each sum. Each answer alone must still be exact
/// for some displacement.
const AGREEING: f64 = 100.0;
/// Numbers of repeated evaluations of the derivatives: `FEW_TURNS` evaluations for r, β and τ alone, then `TURNS`
/// evaluations for every input.
const FEW_TURNS: usize = 6;
const TURNS: usize = 12;

/// An answer of the code under test.
#[derive(Clone, Copy, Debug)]
pub struct Answer {
    /// The question, with the exact instant of a maximum.
    pub watched: Watched<Dd>,
    /// The answer that was returned.
    pub got: Complex<Dd>,
    /// True if the test has found the instant by its own search, in double-double.
    pub searched: bool,
    /// Size whose rounding units measure the error if a displacement of the inputs must explain it.
    pub size: Dd,
    /// The larger of two sizes: the answer's own size, and a thousandth of the largest motion.
    pub strict: Dd,
    /// Absolute value of the exact answer, or the size of its motion if that is more suitable.
    pub own: Dd,
}

/// Errors of one answer, each measured in another unit.
#[derive(Clone, Copy, Debug)]
pub struct Judged {
    /// The exact answer.
    pub exact: Complex<Dd>,
    /// Error in roundings of `Answer::size`.
    pub direct: f64,
    /// Error in roundings of `Answer::strict`.
    pub strict: f64,
    /// Error in roundings of `Answer::own`.
    pub of_its_own: f64,
    /// Backward error of this answer taken alone, in rounding units of the inputs.
    pub alone: f64,
}

impl Judged {
    /// Returns true if the answer belongs to a motion that is smaller than a thousandth of the largest motion.
    pub fn is_far(&self, answer: &Answer) -> bool {
        answer.own < answer.strict
    }
}

/// Verdict on the answers of one point.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// Smallest backward error k that the fit finds for all answers together.
    pub together: f64,
    /// Largest backward error k of the answers, each taken alone.
    pub alone: f64,
    /// Condition number: the largest change of an answer, in rounding units, if every input changes by one unit.
    pub condition: f64,
    pub answers: Vec<Judged>,
}

impl Verdict {
    /// Returns true if the point is accepted. The backward error of every answer alone must be at most `bar`. The
    /// backward error of all answers together must be too, unless the condition number is large.
    pub fn keeps(&self, bar: f64) -> bool {
        self.alone <= bar && (self.together <= bar || AGREEING < self.condition)
    }

    /// Returns true if an answer is NaN, or has an error that is too large for any displacement.
    pub fn is_wrong(&self) -> bool {
        !(self.alone <= MOST)
    }
}

/// Judges the answers at one point of a scene.
pub struct Judge<'a> {
    exact: &'a Exact,
    place: Place<Dd>,
    at: DataAt<'a, Dd>,
    epsilon: f64,
    bar: f64,
    /// Numbers of repeated evaluations of the derivatives: for r, β and τ alone, then for all inputs.
    turns: [usize; 2],
}

impl<'a> Judge<'a> {
    pub fn new(exact: &'a Exact, place: Place<Dd>, epsilon: f64, bar: f64) -> Self {
        let at = exact.data.at(place.r);
        Self {
            exact,
            place,
            at,
            epsilon,
            bar,
            turns: [FEW_TURNS, TURNS],
        }
    }

    /// Restricts the fit to the derivatives at the point itself. They suffice if a change of the inputs by a thousand
    /// rounding units is small.
    pub fn at_once(self) -> Self {
        Self {
            turns: [0, 0],
            ..self
        }
    }

    /// Returns the data of the scene without displacement.
    pub fn data(&self) -> &'a Data<Dd> {
        &self.exact.data
    }

    pub fn at(&self) -> &DataAt<'a, Dd> {
        &self.at
    }

    pub fn place(&self) -> &Place<Dd> {
        &self.place
    }

    /// Returns the exact answers.
    pub fn exact(&self, questions: &[Watched<Dd>]) -> Vec<Complex<Dd>> {
        answers(&self.at, &self.place, questions)
    }

    /// Returns the verdict on answers that all belong to this point.
    pub fn verdict(&self, told: &[Answer]) -> Verdict {
        let exact = self.exact(&told.iter().map(|answer| answer.watched).collect::<Vec<_>>());
        self.compared(told, &exact)
    }

    /// Returns the verdict on answers whose exact values are given.
    pub fn compared(&self, told: &[Answer], exact: &[Complex<Dd>]) -> Verdict {
        let epsilon = Dd::from(self.epsilon);
        let mut judged: Vec<Judged> = Vec::new();
        for (answer, exact) in told.iter().zip(exact) {
            let off = modulus(error(answer, *exact));
            let in_roundings = |size: Dd| {
                let roundings = (off / (epsilon * size)).to_f64();
                let both_zero = off.is_zero() || same(answer.got, *exact);
                match (both_zero, roundings.is_nan()) {
                    (true, _) => 0.0,
                    (false, true) => f64::INFINITY,
                    (false, false) => roundings,
                }
            };
            let direct = in_roundings(answer.size);
            judged.push(Judged {
                exact: *exact,
                direct,
                strict: in_roundings(answer.strict),
                of_its_own: in_roundings(answer.own),
                alone: direct,
            });
        }
        let known = |answer: &Answer, exact: &Complex<Dd>| {
            is_finite(*exact) && (is_finite(answer.got) || may_be_infinite(answer))
        };
        let mut pairs = told.iter().zip(exact);
        let worst = judged
            .iter()
            .fold(0.0, |most: f64, one| most.max(one.direct));
        if worst <= PLAIN || !pairs.all(|(answer, exact)| known(answer, exact)) {
            return Verdict {
                together: worst,
                alone: worst,
                condition: 1.0,
                answers: judged,
            };
        }
        let (mut together, mut condition): (f64, f64) = (0.0, 1.0);
        for group in [Group::Motion, Group::Harmonics] {
            let of_group: Vec<usize> = (0..told.len())
                .filter(|index| Group::of(told[*index].watched.asked) == group)
                // An answer of 0 whose exact value is 0 has no error to explain.
                .filter(|index| judged[*index].direct != 0.0 || !told[*index].size.is_zero())
                .collect();
            let pick = |index: &usize| told[*index];
            let (group, values): (Vec<Answer>, Vec<Complex<Dd>>) = of_group
                .iter()
                .map(|index| (pick(index), exact[*index]))
                .unzip();
            let mut known: Vec<Judged> = of_group.iter().map(|index| judged[*index]).collect();
            let worst = known
                .iter()
                .fold(0.0, |most: f64, one| most.max(one.direct));
            if PLAIN < worst {
                let explained = self.explained(&group, &values, &mut known);
                together = together.max(explained.0);
                condition = condition.max(explained.1);
                for (index, known) in of_group.iter().zip(known) {
                    judged[*index] = known;
                }
            } else {
                together = together.max(worst);
            }
        }
        let alone = judged.iter();
        Verdict {
            together,
            alone: alone.fold(0.0, |most: f64, one| most.max(one.alone)),
            condition,
            answers: judged,
        }
    }

    /// Returns the smallest backward error k that the fit finds, and the condition number of the point. The fit first
    /// displaces r, β and τ alone, which is cheap, and then all inputs. Each time it re-evaluates the derivatives at
    /// the displacements of its last step.
    fn explained(
        &self,
        told: &[Answer],
        exact: &[Complex<Dd>],
        judged: &mut [Judged],
    ) -> (f64, f64) {
        let mut judge = |linear: &Linear| {
            linear.each_alone(told, judged);
            linear.fitted(self.bar)
        };
        let (mut best, mut condition) = (f64::INFINITY, 1.0);
        // At most points the derivatives at the undisplaced point are enough.
        let mut here = Vec::new();
        for every in [false, true] {
            let linear = self.linear(told, exact, &[], every);
            condition = linear.condition();
            best = best.min(judge(&linear));
            if best <= self.bar {
                return (best, condition);
            }
            here.push((every, linear));
        }
        for ((every, linear), turns) in here.into_iter().zip(self.turns) {
            let mut turning = Turning::of(linear);
            for _ in 0..turns {
                let Some(to) = turning.next(self.bar) else {
                    break;
                };
                let there = self.linear(told, exact, to, every);
                best = best.min(judge(&there));
                condition = there.condition();
                if best <= self.bar {
                    return (best, condition);
                }
                turning.linear = there;
            }
        }
        (best, condition)
    }
}

/// Groups of answers. One displacement of the inputs must explain all answers of a group together.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Group {
    Motion,
    /// The harmonics. The fundamental is computed from whole responses, not from the motion, so it forms a group of
    /// its own.
    Harmonics,
}

impl Group {
    fn of(asked: Asked) -> Self {
        match asked {
            Asked::Harmonic(..) => Self::Harmonics,
            _ => Self::Motion,
        }
    }
}
