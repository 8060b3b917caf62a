//! The course of one quantity over the period of a steady state: largest value and phase, harmonics, values at any
//! phase.

use super::poly::{Poly, slope, value};
use super::roots::{carried, halvings};
use super::run::{Motion, Observe};
use super::series::Series;
use super::size::Size;
use super::state::State;
use super::steady::Search;
use crate::number::complex::{self, Complex};
use crate::number::phase::within_cycle;
use crate::{Float, Scalar};
use core::f64::consts::TAU;

/// Number of parts of a piece in each of which the search for extreme values expects at most one. The fastest oscillation
/// advances by less than 0.2 rad in a part.
const PARTS: usize = 8;
/// Largest number of Gaussian rules in one piece.
const MOST_RULES: f64 = 16384.0;

/// A part of the period in which the quantity is one power series.
#[derive(Clone, Copy, Debug)]
pub struct Piece<S> {
    /// Time at the start, from the start of the period.
    pub start: S,
    /// Duration over which the variable of the series increases by 1.
    pub length: S,
    /// Largest value of the variable in the piece.
    pub end: S,
    /// Coefficients of the series.
    pub terms: Poly<S>,
}

impl<S: Float> Piece<S> {
    fn time(&self, at: S) -> S {
        self.start + at * self.length
    }

    /// Returns the integral of the quantity times exp(−iνt) over the piece, for the angular frequency ν.
    fn integral(&self, frequency: S) -> Complex<S> {
        // Points on [0, 1] and weights of the Gaussian rule with 8 points, without their mirror images. Literals keep
        // double precision out of code in single precision.
        let number = |value: f64| S::constant(value);
        let gauss = [
            (
                number(0.183_434_642_495_649_8),
                number(0.362_683_783_378_362),
            ),
            (
                number(0.525_532_409_916_329),
                number(0.313_706_645_877_887_3),
            ),
            (
                number(0.796_666_477_413_626_7),
                number(0.222_381_034_453_374_48),
            ),
            (
                number(0.960_289_856_497_536_3),
                number(0.101_228_536_290_376_26),
            ),
        ];
        let (zero, one, two) = (number(0.0), number(1.0), number(2.0));
        // A rule extends over at most 1 rad of the harmonic and half of the solver's power series. Its error is then
        // about 1e-16.
        let rules = -(-(frequency * self.end * self.length)).floor();
        let rules = Scalar::min(Scalar::max(rules, two), number(MOST_RULES));
        let half = number(0.5) * self.end / rules;
        let mut sum = complex::real(zero);
        let mut rule = zero;
        while rule < rules {
            let middle = half * (two * rule + one);
            for (point, weight) in gauss {
                for at in [middle - half * point, middle + half * point] {
                    let angle = frequency * self.time(at) * S::inverse_pi();
                    let (sin, cos) = angle.sin_cos_pi();
                    let value = weight * value(&self.terms, at);
                    sum = complex::add(sum, Complex::new(value * cos, -(value * sin)));
                }
            }
            rule = rule + one;
        }
        complex::scale(sum, half * self.length)
    }
}

/// Passes the points between 0 and `end` at which a polynomial may have an extreme value, in ascending order, with the
/// values there.
pub fn extremes<S: Float>(terms: &Poly<S>, end: S, mut watch: impl FnMut(S, S)) {
    let slope = slope(terms);
    let part = end / S::whole(PARTS);
    for index in 0..PARTS {
        let (low, high) = (S::whole(index) * part, S::whole(index + 1) * part);
        watch(low, value(terms, low));
        if let Some(turn) = turn(&slope, (low, high)) {
            watch(turn, value(terms, turn));
        }
    }
    watch(end, value(terms, end));
}

/// Returns the point between `low` and `high` at which a polynomial changes its sign.
fn turn<S: Float>(terms: &Poly<S>, (mut low, mut high): (S, S)) -> Option<S> {
    let (zero, half) = (S::constant(0.0), S::constant(0.5));
    let rises = value(terms, low) < zero;
    if rises == (value(terms, high) < zero) {
        return None;
    }
    for _ in 0..halvings::<S>() {
        let middle = half * (low + high);
        if (value(terms, middle) < zero) == rises {
            low = middle;
        } else {
            high = middle;
        }
    }
    Some(carried(terms, half * (low + high)))
}

/// The pieces of a period, in the order of time.
pub trait Pieces<S: Float> {
    /// Passes each piece.
    fn each(&self, watch: impl FnMut(&Piece<S>));
}

#[cfg(any(test, feature = "std"))]
impl<S: Float> Pieces<S> for Vec<Piece<S>> {
    fn each(&self, watch: impl FnMut(&Piece<S>)) {
        self.iter().for_each(watch);
    }
}

/// The relative displacement of two nodes in a period, which the solver computes again for each result.
#[derive(Clone, Copy, Debug)]
pub struct Replay<'o, S: Float, Z: Size> {
    /// The motion at the start of the period.
    pub(super) motion: &'o Motion<S, Z>,
    pub(super) omega: S,
    pub(super) cycles: usize,
    /// The node whose displacement counts as positive, and the other node.
    pub(super) nodes: (usize, usize),
}

/// Observer that passes the pieces of a motion.
struct Cut<W, S> {
    watch: W,
    nodes: (usize, usize),
    /// Time from the start of the period to that of the present cycle.
    start: S,
}

impl<S: Float, Z: Size, W: FnMut(&Piece<S>)> Observe<S, Z> for Cut<W, S> {
    fn stretch(&mut self, series: &Series<S, Z>, end: S, _: &State<S, Z>) {
        let (plus, minus) = self.nodes;
        (self.watch)(&Piece {
            start: self.start + series.start,
            length: series.length,
            end,
            terms: series.place_terms(plus, minus),
        });
    }
}

impl<S: Float, Z: Size> Pieces<S> for Replay<'_, S, Z> {
    fn each(&self, watch: impl FnMut(&Piece<S>)) {
        let zero = S::constant(0.0);
        let mut motion = self.motion.clone();
        let mut search = Search::by_tables(&motion, self.omega, S::constant(1.0));
        let mut cut = Cut {
            watch,
            nodes: self.nodes,
            start: zero,
        };
        for cycle in 0..self.cycles {
            cut.start = search.length(cycle);
            // The search for the steady state has followed the same period within the same bounds.
            if search.advance(&mut motion, 1, &mut cut).is_err() {
                return;
            }
        }
    }
}

/// The course of a displacement or a force over the period of a steady state.
///
/// The phase τ = ωt of the load is 0 at a maximum of the load, where the period begins. Displacements, forces and
/// velocities (derivatives with respect to τ) are in the units of the steady state.
#[derive(Clone, Copy, Debug)]
pub struct Waveform<S, P> {
    pieces: P,
    /// Angular frequency of the load, and number of its cycles in the period.
    omega: S,
    cycles: usize,
}

impl<S: Float, P: Pieces<S>> Waveform<S, P> {
    /// Creates the course from its pieces. `omega` is the angular frequency of the load, and `cycles` the number of its
    /// cycles in the period.
    #[must_use]
    pub fn new(pieces: P, omega: S, cycles: usize) -> Self {
        Self {
            pieces,
            omega,
            cycles,
        }
    }

    fn period(&self) -> S {
        S::constant(TAU) * S::whole(self.cycles) / self.omega
    }

    /// Passes the instants at which the quantity may have its largest and smallest value, with the values there, in the
    /// order of time.
    fn turns(&self, mut watch: impl FnMut(S, S)) {
        self.pieces.each(|piece| {
            extremes(&piece.terms, piece.end, |at, value| {
                watch(piece.time(at), value);
            });
        });
    }

    /// Returns the smallest and the largest value in the period.
    #[must_use]
    pub fn extremes(&self) -> (S, S) {
        let mut found: Option<(S, S)> = None;
        self.turns(|_, value| {
            let (low, high) = found.unwrap_or((value, value));
            found = Some((Scalar::min(low, value), Scalar::max(high, value)));
        });
        found.unwrap_or((S::constant(0.0), S::constant(0.0)))
    }

    /// Returns the largest absolute value in the period.
    #[must_use]
    pub fn amplitude(&self) -> S {
        let (low, high) = self.extremes();
        Scalar::max(high, -low)
    }

    /// Returns half of the difference between the largest and the smallest value.
    #[must_use]
    pub fn centred_amplitude(&self) -> S {
        let (low, high) = self.extremes();
        S::constant(0.5) * (high - low)
    }

    /// Returns the mean of the largest and the smallest value. For a contact that sticks off its centre, this is its
    /// offset.
    #[must_use]
    pub fn middle(&self) -> S {
        let (low, high) = self.extremes();
        S::constant(0.5) * (high + low)
    }

    /// Returns the lag of the largest absolute value behind the maximum of the load, in rad, in (−π, π]. If the
    /// quantity is negative there, the lag has half a turn more.
    ///
    /// If the quantity keeps its largest value for some time, the lag belongs to the beginning of this time. If several
    /// maxima are equal, the result is the lag of smallest size. If two lags of equal size have opposite signs, it is
    /// the positive lag.
    #[must_use]
    pub fn phase(&self) -> S {
        let zero = S::constant(0.0);
        // Largest relative difference of two equal maxima, and difference of two equal lags.
        let equal = S::constant(if S::EPSILON < 1e-10 { 1e-11 } else { 1e-5 });
        let (mut largest, mut before) = (zero, zero);
        self.turns(|_, value| {
            largest = Scalar::max(largest, value.abs());
            before = value;
        });
        let least = largest * (S::constant(1.0) - equal);
        let mut best: Option<S> = None;
        self.turns(|time, value| {
            let kept = before.abs() >= least && (before < zero) == (value < zero);
            before = value;
            if value.abs() < least || kept {
                return;
            }
            let half = S::whole(usize::from(value < zero));
            let lag = wrapped(self.omega * time * S::inverse_pi() + half);
            let is_better = best.is_none_or(|best| {
                let is_nearer = lag.abs() < best.abs() - equal;
                is_nearer || (lag.abs() < best.abs() + equal && best < zero && zero < lag)
            });
            if is_better {
                best = Some(lag);
            }
        });
        best.unwrap_or(zero)
    }

    /// Returns the lag of the fundamental component behind the load, −arg X₁, in rad, in (−π, π].
    #[must_use]
    pub fn fundamental_phase(&self) -> S {
        let fundamental = self.harmonic(1);
        wrapped(-fundamental.im.atan2(fundamental.re) * S::inverse_pi())
    }

    /// Returns the complex amplitude X_n of a harmonic of the load: the quantity is Re Σ X_n exp(inτ). X_0 is its mean.
    /// If the period has several cycles, the harmonics are only a part of it.
    #[must_use]
    pub fn harmonic(&self, n: u32) -> Complex<S> {
        let cycles = u32::try_from(self.cycles).unwrap_or(u32::MAX);
        self.subharmonic(n.saturating_mul(cycles))
    }

    /// Returns the complex amplitude X of the component with k oscillations in a period. It adds Re X exp(ikτ/p) to the
    /// quantity, where p is the number of cycles in the period.
    #[must_use]
    pub fn subharmonic(&self, k: u32) -> Complex<S> {
        let period = self.period();
        let order = S::whole(usize::try_from(k).unwrap_or(usize::MAX));
        let frequency = order * S::constant(TAU) / period;
        let mut sum = complex::real(S::constant(0.0));
        self.pieces
            .each(|piece| sum = complex::add(sum, piece.integral(frequency)));
        let factor = S::constant(if k == 0 { 1.0 } else { 2.0 });
        complex::scale(sum, factor / period)
    }

    /// Returns the value at the phase τ in rad. At τ = 0 the load has a maximum.
    #[must_use]
    pub fn displacement(&self, tau: S) -> S {
        self.at(tau, |piece, at| value(&piece.terms, at))
    }

    /// Returns the derivative of the value with respect to τ, at the phase τ in rad. Where it jumps, the result is the
    /// derivative after the jump.
    #[must_use]
    pub fn velocity(&self, tau: S) -> S {
        self.at(tau, |piece, at| {
            value(&slope(&piece.terms), at) / (piece.length * self.omega)
        })
    }

    /// Returns the largest absolute derivative with respect to τ in the period.
    #[must_use]
    pub fn largest_velocity(&self) -> S {
        let mut largest = S::constant(0.0);
        self.pieces.each(|piece| {
            let rate = S::constant(1.0) / (piece.length * self.omega);
            extremes(&slope(&piece.terms), piece.end, |_, value| {
                largest = Scalar::max(largest, rate * value.abs());
            });
        });
        largest
    }

    fn at(&self, tau: S, of: impl Fn(&Piece<S>, S) -> S) -> S {
        let cycles = S::whole(self.cycles);
        let within = within_cycle(tau * S::inverse_pi() / cycles) * cycles;
        let time = within * S::constant(core::f64::consts::PI) / self.omega;
        let mut found = None;
        self.pieces.each(|piece| {
            if piece.start <= time || found.is_none() {
                found = Some(*piece);
            }
        });
        found.map_or(S::constant(0.0), |piece| {
            let at = (time - piece.start) / piece.length;
            of(&piece, Scalar::min(at, piece.end))
        })
    }
}

/// Converts an angle in half-turns to rad, in (−π, π].
fn wrapped<S: Float>(half_turns: S) -> S {
    let within = within_cycle(half_turns);
    let one = S::constant(1.0);
    let within = if within > one {
        within - one - one
    } else {
        within
    };
    within * S::constant(core::f64::consts::PI)
}
