//! The linear equations of the fit at displaced inputs: the error of each answer, and its derivative with respect to
//! each input.

use super::error::{error, sense};
use super::{Answer, Judge, Judged};
use crate::backward::asked::{Asked, Of, Place, Watched, answers, motion};
use crate::backward::fit::{fit, shortest};
use crate::backward::inputs::Exact;
use crate::backward::instant::{constraining, followed};
use frictiongen_kernel::Complex;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::dual::Dual;
use frictiongen_model::modal::Modal;
use generated_tests::data::DataAt;

/// Weight of the displacement of an input in the weighted least squares of one step. The weight of an answer is at
/// most 1.
const STILL: f64 = 1e-4;
/// Weight of an answer whose error is already accepted, in the weighted least squares of one step.
const IDLE: f64 = 1e-100;
/// Indices of the columns: r, β and τ come first, then the numbers of the description.
const RATIO: usize = 0;
pub(super) const BETA: usize = 1;
const TAU: usize = 2;
const OF_PLACE: usize = 3;

/// Linear equations of the fit at displaced inputs: Σ a_ij δ_j ≈ b_i for the answers i and the displacements δ_j.
pub(super) struct Linear {
    pub a: Vec<Vec<Dd>>,
    pub b: Vec<Dd>,
    /// True if the contact does not move at the displaced r and β.
    pub stands: bool,
}

impl Linear {
    pub fn fitted(&self, bar: f64) -> f64 {
        fit(&self.a, &self.b, bar)
    }

    /// Returns the step from the present displacements `to` of the inputs to the next displacements, at which the code
    /// re-evaluates the derivatives. The weight of each answer above the accepted error falls with its sensitivity to
    /// the inputs, so that the curvature of the worst answer does not outweigh the other answers.
    pub fn step(&self, to: &[f64], bar: f64) -> Option<Vec<f64>> {
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

    /// Returns the condition number: the largest change of an answer, in rounding units, if every input changes by
    /// one unit.
    pub fn condition(&self) -> f64 {
        let sum = |row: &Vec<Dd>| {
            let sum = row
                .iter()
                .fold(Dd::from(1.0), |sum, slope| sum + slope.abs());
            sum.to_f64()
        };
        self.a.iter().map(sum).fold(1.0, f64::max)
    }

    /// Computes the backward error k = |b|/(1 + Σ|a|) of every answer taken alone.
    pub fn each_alone(&self, told: &[Answer], judged: &mut [Judged]) {
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

impl Judge<'_> {
    /// Returns the equations of the fit at displaced inputs. `to` has the displacements in rounding units. `every`
    /// selects all inputs; otherwise the equations have only r, β and τ.
    pub(super) fn linear(
        &self,
        told: &[Answer],
        exact: &[Complex<Dd>],
        to: &[f64],
        every: bool,
    ) -> Linear {
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
            // Some values in `exact` are more accurate than the formulas in double-double. The value at the displaced
            // inputs keeps the difference between the value in `exact` and the value of the formulas.
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
                // An infinite derivative explains nothing to first order, so it counts as 0.
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

    /// Returns x ∂f/∂x of every question f with respect to every input x.
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

/// Returns this question at another r and β. The instant of its maximum is the instant at that r and β.
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
