//! By how many roundings of its scene the answers of one place are the exact ones.
//!
//! The inputs are the numbers of the description (masses, springs, damping, μ) and r, β and τ.  Answers are as good as
//! their inputs allow if one scene within k roundings of each input has all of them as its exact answers, each but for
//! k roundings of its own size.  By exact first derivatives that is a Chebyshev fit.  Where r stands a few roundings
//! beside a pole derivatives change within a rounding: they are taken anew where the fit has moved r and β to.
//!
//! Here is what is asked and what a place is found to be; `error` has how far an answer is off, `linear` the fit's
//! equations, `turning` where their derivatives are taken anew.

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

/// So few roundings of an answer need no input to explain them.
pub const PLAIN: f64 = 4.0;
/// No answer may be off by more: a stuck response is a difference of free ones, which may be larger than it by so much.
const MOST: f64 = 4096.0;
/// Answers of a place with a larger condition need not agree on one displacement: they come from different sums, whose
/// roundings the condition magnifies.  Each by itself must have one.
const AGREEING: f64 = 100.0;
/// So often are the derivatives taken anew: with respect to r, β and τ, then to every input.
const FEW_TURNS: usize = 6;
const TURNS: usize = 12;

/// An answer of the code under test.
#[derive(Clone, Copy, Debug)]
pub struct Answer {
    /// What was asked; with the exact instant of a largest value.
    pub watched: Watched<Dd>,
    /// What was told.
    pub got: Complex<Dd>,
    /// Whether double-double has searched for the instant itself.
    pub searched: bool,
    /// What its own roundings are counted in where answers are explained.
    pub size: Dd,
    /// Its own size, or a thousandth of the largest motion.
    pub strict: Dd,
    /// Its own size.
    pub own: Dd,
}

/// What is known of one answer.
#[derive(Clone, Copy, Debug)]
pub struct Judged {
    /// The exact answer.
    pub exact: Complex<Dd>,
    /// In roundings of its size.
    pub direct: f64,
    /// In roundings of its strict size.
    pub strict: f64,
    /// In roundings of its own size.
    pub of_its_own: f64,
    /// In roundings of the inputs, were it the only answer of its place.
    pub alone: f64,
}

impl Judged {
    /// Whether the answer is of a motion below a thousandth of the largest.
    pub fn is_far(&self, answer: &Answer) -> bool {
        answer.own < answer.strict
    }
}

/// What is known of a place.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// The smallest k found for all answers together.
    pub together: f64,
    /// The largest of the answers, each by itself.
    pub alone: f64,
    /// By how many roundings an answer moves with one of every input, at most.
    pub condition: f64,
    pub answers: Vec<Judged>,
}

impl Verdict {
    /// Whether the place keeps the bar: every answer by itself, and all together unless their condition is large.
    pub fn keeps(&self, bar: f64) -> bool {
        self.alone <= bar && (self.together <= bar || AGREEING < self.condition)
    }

    /// Whether nothing about it is to be understood.
    pub fn is_wrong(&self) -> bool {
        !(self.alone <= MOST)
    }
}

/// One place of a scene.
pub struct Judge<'a> {
    exact: &'a Exact,
    place: Place<Dd>,
    at: DataAt<'a, Dd>,
    epsilon: f64,
    bar: f64,
    /// How often derivatives are taken anew, for few inputs and for all.
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

    /// By the derivatives where the answers were asked alone, which is enough where a thousand roundings are few.
    pub fn at_once(self) -> Self {
        Self {
            turns: [0, 0],
            ..self
        }
    }

    /// The scene's own.
    pub fn data(&self) -> &'a Data<Dd> {
        &self.exact.data
    }

    pub fn at(&self) -> &DataAt<'a, Dd> {
        &self.at
    }

    pub fn place(&self) -> &Place<Dd> {
        &self.place
    }

    /// The exact answers.
    pub fn exact(&self, questions: &[Watched<Dd>]) -> Vec<Complex<Dd>> {
        answers(&self.at, &self.place, questions)
    }

    /// What is known of these answers, all of this place.
    pub fn verdict(&self, told: &[Answer]) -> Verdict {
        let exact = self.exact(&told.iter().map(|answer| answer.watched).collect::<Vec<_>>());
        self.compared(told, &exact)
    }

    /// The same where the exact answers are known.
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
                // What is 0 and told as 0 needs no displacement.
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

    /// The smallest k found: by r, β and τ alone, which is cheap, then by every input.  Derivatives are taken anew at
    /// what the last step found.  With the place's condition.
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
        // Most places are explained where they are.
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

/// Answers that one displacement explains.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Group {
    Motion,
    /// The fundamental is put together from whole responses, not from the motion.
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
