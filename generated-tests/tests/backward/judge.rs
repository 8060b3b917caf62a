//! By how many roundings of its scene the answers of one place are the exact ones.
//!
//! The inputs are the numbers of the description (masses, springs, damping, μ) and r, β and τ.  Answers are as good as
//! their inputs allow if one scene within k roundings of each input has all of them as its exact answers, each but for
//! k roundings of its own size.  By exact first derivatives that is a Chebyshev fit.  Where r stands a few roundings
//! beside a pole derivatives change within a rounding: they are taken anew where the fit has moved r and β to.

use crate::asked::{Asked, Of, Place, Watched, answers, motion};
use crate::fit::{fit, shortest};
use crate::inputs::Exact;
use crate::instant::{constraining, followed};
use frictiongen_kernel::number::complex;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::dual::Dual;
use frictiongen_kernel::{Complex, Float};
use frictiongen_model::modal::Modal;
use generated_tests::data::{Data, DataAt};

/// So few roundings of an answer need no input to explain them.
pub const PLAIN: f64 = 4.0;
/// The weight of an input's rest in such a step, beside 1 of an answer.
const STILL: f64 = 1e-4;
/// The weight of an answer that is below the bar.
const IDLE: f64 = 1e-100;
/// No answer may be off by more: a stuck response is a difference of free ones, which may be larger than it by so much.
const MOST: f64 = 4096.0;
/// Answers of a place with a larger condition need not agree on one displacement: they come from different sums, whose
/// roundings the condition magnifies.  Each by itself must have one.
const AGREEING: f64 = 100.0;
/// So often are the derivatives taken anew: with respect to r, β and τ, then to every input.
const FEW_TURNS: usize = 6;
const TURNS: usize = 12;
/// The columns of r, β and τ come first, then those of the description.
const RATIO: usize = 0;
const BETA: usize = 1;
const TAU: usize = 2;
const OF_PLACE: usize = 3;

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

/// The fit's equations about some r and β.
struct Linear {
    a: Vec<Vec<Dd>>,
    b: Vec<Dd>,
    /// Whether the contact's motion has vanished there.
    stands: bool,
}

/// An angle's distance, within half a turn.
pub fn angle(difference: Dd) -> Dd {
    let turn = Dd::PI + Dd::PI;
    let turns = Float::floor(difference / turn + Dd::from(0.5));
    difference - turns * turn
}

pub fn modulus(value: Complex<Dd>) -> Dd {
    complex::modulus(value, true)
}

fn is_finite(value: Complex<Dd>) -> bool {
    value.re.to_f64().is_finite() && value.im.to_f64().is_finite()
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

    /// The equations about inputs displaced by these roundings; for every input, or for those of the place.
    fn linear(&self, told: &[Answer], exact: &[Complex<Dd>], to: &[f64], every: bool) -> Linear {
        let epsilon = Dd::from(self.epsilon);
        let by = |column: usize| to.get(column).copied().unwrap_or(0.0);
        let displaced = |value: Dd, column| value + value * epsilon * Dd::from(by(column));
        let place = Place {
            r: displaced(self.place.r, RATIO),
            beta: displaced(self.place.beta, BETA),
            tau: displaced(self.place.tau, TAU),
        };
        let here: Vec<Watched<Dd>> = told.iter().map(|answer| answer.watched).collect();
        let scene = to.get(OF_PLACE..).unwrap_or_default();
        let stands = |at: &DataAt<'_, Dd>| at.in_phase(place.beta).is_zero();
        let (stands, there, columns) = if to.is_empty() {
            let columns = self.columns(self.exact.modal(), &place, &here, every);
            (stands(&self.at), exact.to_vec(), columns)
        } else {
            let (data, modal) = self.exact.displaced(scene, self.epsilon);
            let at = data.at(place.r);
            let follow = |watched: &Watched<Dd>| follow(&at, &place, *watched, self.epsilon);
            let questions: Vec<_> = here.iter().map(follow).collect();
            let moved = answers(&at, &place, &questions);
            // What is known better than by the formulas stays so much better.
            let better = exact.iter().zip(self.exact(&here));
            let there = moved.iter().zip(better).map(|(moved, (exact, here))| {
                Complex::new(
                    moved.re + (exact.re - here.re),
                    moved.im + (exact.im - here.im),
                )
            });
            let there = there.collect();
            let columns = self.columns(&modal, &place, &questions, every);
            (stands(&at), there, columns)
        };
        let mut linear = Linear {
            a: Vec::new(),
            b: Vec::new(),
            stands,
        };
        for (index, (answer, there)) in told.iter().zip(&there).enumerate() {
            let size = epsilon * answer.size;
            let (off, sense) = (error(answer, *there), Dd::from(sense(answer)));
            let slopes = |part: fn(Complex<Dd>) -> Dd| -> Vec<Dd> {
                let of = columns.iter().map(|column| part(column[index]));
                // An input that moves the answer without bound explains nothing to first order.
                of.map(|slope| slope * sense / answer.size)
                    .map(|slope| {
                        if slope.to_f64().is_finite() {
                            slope
                        } else {
                            Dd::from(0.0)
                        }
                    })
                    .collect()
            };
            let mut add = |off: Dd, row: Vec<Dd>| {
                let back = row.iter().zip(to);
                let back = back.fold(Dd::from(0.0), |sum, (a, by)| sum + *a * Dd::from(*by));
                linear.b.push(off / size + back);
                linear.a.push(row);
            };
            add(off.re, slopes(|slope| slope.re));
            if answer.watched.asked.is_complex() {
                add(off.im, slopes(|slope| slope.im));
            }
        }
        linear
    }

    /// x ∂f/∂x of every question, for every input.
    fn columns(
        &self,
        modal: &Modal,
        place: &Place<Dd>,
        questions: &[Watched<Dd>],
        every: bool,
    ) -> Vec<Vec<Complex<Dd>>> {
        let questions: Vec<Watched<Dual<Dd>>> =
            questions.iter().map(|one| one.read(Dual::fixed)).collect();
        let fixed = place.read(Dual::fixed);
        let slopes = |answers: Vec<Complex<Dual<Dd>>>, value: Dd| -> Vec<Complex<Dd>> {
            let slopes = answers.iter();
            slopes
                .map(|answer| Complex::new(answer.re.slope * value, answer.im.slope * value))
                .collect()
        };
        let along = |value: Dd| Dual {
            value,
            slope: value,
        };
        let (mut of_ratio, mut of_beta, mut of_tau) = (fixed, fixed, fixed);
        of_ratio.r = along(place.r);
        of_beta.beta = along(place.beta);
        of_tau.tau = along(place.tau);
        let scene = Exact::fixed(modal);
        let one = Dd::from(1.0);
        let mut columns = vec![slopes(
            answers(&scene.at(of_ratio.r), &of_ratio, &questions),
            one,
        )];
        let at = scene.at(fixed.r);
        columns
            .extend([of_beta, of_tau].map(|place| slopes(answers(&at, &place, &questions), one)));
        if every {
            columns.extend(self.exact.moving(modal).map(|moving| {
                let answers = answers(&moving.data.at(fixed.r), &fixed, &questions);
                slopes(answers, moving.value)
            }));
        }
        columns
    }
}

/// Displacements at which the derivatives are taken anew, one after the other.
struct Turning {
    /// The equations at the displacement found last.
    linear: Linear,
    /// It, in roundings.
    to: Vec<f64>,
    /// The last one before the contact stood still.
    moving: Option<Vec<f64>>,
    /// By how many roundings of β the contact is set free.
    back: f64,
}

impl Turning {
    fn of(linear: Linear) -> Self {
        Self {
            to: vec![0.0; linear.a.first().map_or(0, Vec::len)],
            linear,
            moving: None,
            back: 0.5,
        }
    }

    fn next(&mut self, bar: f64) -> Option<&[f64]> {
        if let (true, Some(moving)) = (self.linear.stands, &self.moving) {
            // Beyond |V|/|U| the contact stands still whatever moves: halfway to where it did not.
            for (to, moving) in self.to.iter_mut().zip(moving) {
                *to = 0.5 * (*to + moving);
            }
        } else {
            let step = self.linear.step(&self.to, bar)?;
            if self.linear.stands {
                // To where the limits are as they were told, and back by more and more of β.
                self.back = (self.back + self.back).min(bar);
                self.to[BETA] -= self.back;
            } else {
                self.moving = Some(self.to.clone());
            }
            for (to, step) in self.to.iter_mut().zip(step) {
                *to = (*to + step).clamp(-bar, bar);
            }
        }
        Some(&self.to)
    }
}

impl Linear {
    fn fitted(&self, bar: f64) -> f64 {
        fit(&self.a, &self.b, bar)
    }

    /// From where derivatives are known to where to take them anew: each answer above the bar counts by how far it moves with the
    /// inputs, so that what is curved in the worst of them does not outweigh the others.
    fn step(&self, to: &[f64], bar: f64) -> Option<Vec<f64>> {
        let rest = self.a.iter().zip(&self.b).map(|(row, b)| {
            let there = row.iter().zip(to);
            there.fold(*b, |rest, (a, to)| rest - *a * Dd::from(*to))
        });
        let rest: Vec<Dd> = rest.collect();
        let weight = |(row, rest): (&Vec<Dd>, &Dd)| {
            if rest.abs().to_f64() <= bar {
                return IDLE;
            }
            let sum = row
                .iter()
                .fold(Dd::from(1.0), |sum, slope| sum + slope.abs());
            (Dd::from(1.0) / (sum * sum)).to_f64().max(IDLE)
        };
        let answers: Vec<f64> = self.a.iter().zip(&rest).map(weight).collect();
        let inputs = vec![STILL; self.a.first().map_or(0, Vec::len)];
        let moved = shortest(&self.a, &rest, &inputs, &answers)?;
        Some(moved.iter().map(|moved| moved.to_f64()).collect())
    }

    /// The most that an answer moves by, with one rounding of every input.
    fn condition(&self) -> f64 {
        let sum = |row: &Vec<Dd>| {
            let sum = row
                .iter()
                .fold(Dd::from(1.0), |sum, slope| sum + slope.abs());
            sum.to_f64()
        };
        self.a.iter().map(sum).fold(1.0, f64::max)
    }

    /// k of every answer by itself: |b|/(1 + Σ|a|).
    fn each_alone(&self, told: &[Answer], judged: &mut [Judged]) {
        let mut rows = self.a.iter().zip(&self.b);
        for (answer, judged) in told.iter().zip(judged) {
            let parts = if answer.watched.asked.is_complex() {
                2
            } else {
                1
            };
            let mut alone: f64 = 0.0;
            for (row, off) in rows.by_ref().take(parts) {
                let sum = row
                    .iter()
                    .fold(Dd::from(1.0), |sum, slope| sum + slope.abs());
                alone = alone.max((off.abs() / sum).to_f64());
            }
            judged.alone = judged.alone.min(alone);
        }
    }
}

fn same(a: Complex<Dd>, b: Complex<Dd>) -> bool {
    a.re == b.re && a.im == b.im
}

/// A limit grows without bound beside a zero of what it is divided by: there its reciprocal is compared.
fn may_be_infinite(answer: &Answer) -> bool {
    answer.watched.asked.is_limit() && answer.got.re.to_f64() == f64::INFINITY
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

/// How far an answer is off; of what may be infinite, 1/got − 1/exact, times exact².
fn error(answer: &Answer, exact: Complex<Dd>) -> Complex<Dd> {
    let (got, zero) = (answer.got, Dd::from(0.0));
    if may_be_infinite(answer) {
        Complex::new(-exact.re, zero)
    } else if answer.watched.asked.is_angle() {
        Complex::new(angle(got.re - exact.re), zero)
    } else {
        Complex::new(got.re - exact.re, got.im - exact.im)
    }
}

/// The sign of its derivatives in [`error`].
fn sense(answer: &Answer) -> f64 {
    if may_be_infinite(answer) { -1.0 } else { 1.0 }
}

/// The same question at another r and β, a largest value where it is there.
fn follow(
    at: &DataAt<'_, Dd>,
    place: &Place<Dd>,
    watched: Watched<Dd>,
    epsilon: f64,
) -> Watched<Dd> {
    let instant = watched.instant.map(|tau| match watched.asked {
        Asked::ContinuousLimit => constraining(at, tau, epsilon),
        Asked::Amplitude(of @ Of::Mass(_)) => followed(&motion(at, of, place.beta), tau, epsilon),
        Asked::Height(mass) => {
            let motion = motion(at, Of::Mass(mass), place.beta);
            followed(&motion, tau, epsilon)
        }
        _ => tau,
    });
    Watched { instant, ..watched }
}
