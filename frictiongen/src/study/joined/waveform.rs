//! The course of one quantity over the period of a steady state: largest value and phase, harmonics, values at any
//! phase.

use super::combination::{Combination, extremes_between};
use super::scene::Joined;
use super::units::AnswerUnits;
use crate::study::joints::Series;
use crate::study::response::MotionQuantity;
use crate::{Complex, Of};
use frictiongen_kernel::Float;
use frictiongen_kernel::joints::{Poly, slope, value};
use std::f64::consts::{PI, TAU};

/// Two values are equal maxima if they differ by less than this part of the largest.
const EQUAL: f64 = 1e-11;
/// Points on [−1, 1] and weights of the Gaussian rule with 8 points, without their mirror images.
const GAUSS: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
];
/// Largest phase, in rad, over which the code integrates a harmonic by one Gaussian rule. The error is then about 1e-16.
const RULE: f64 = 1.0;

/// A quantity whose course over a period the code follows.
#[derive(Clone, Debug)]
pub(in crate::study) enum Course {
    /// A displacement of masses, its derivative, or a force of springs.
    Combination(Combination),
    /// The relative displacement in a contact or a stop, from the second node to the first, times 1 or −1.
    Contact((usize, usize), f64),
}

impl Course {
    /// Returns the course of a motion or of a force of springs. Returns `None` for a quantity that only a contact has.
    pub fn of(joined: &Joined<'_>, of: Of, size: MotionQuantity) -> Option<Self> {
        Combination::of(joined.scene(), of, size).map(Self::Combination)
    }

    /// Returns the course of the relative displacement in the contact or stop with this index.
    pub fn of_contact(joined: &Joined<'_>, index: usize) -> Option<Self> {
        Some(Self::Contact(joined.nodes(index)?, joined.sign(index)))
    }

    /// Returns the quantity from the start of a stretch (time interval of a power series) to its fraction `end`.
    pub fn piece(&self, series: &Series, end: f64, setting: (f64, AnswerUnits)) -> Piece {
        let (_, units) = setting;
        let (terms, factor) = match self {
            Self::Combination(combination) => {
                let factor = combination.in_units(1.0, setting);
                (combination.terms_of(series), factor)
            }
            Self::Contact((plus, minus), sign) => {
                (series.place_terms(*plus, *minus), sign / units.length)
            }
        };
        Piece {
            start: series.start,
            length: series.length,
            end,
            terms: terms.map(|term| factor * term),
        }
    }
}

/// A part of the period in which the quantity is one power series.
#[derive(Clone, Copy, Debug)]
pub(in crate::study) struct Piece {
    /// Time at the start, from the start of the period.
    start: f64,
    /// Duration over which the variable of the series increases by 1.
    length: f64,
    /// Largest value of the variable in the piece.
    end: f64,
    terms: Poly<f64>,
}

impl Piece {
    fn time(&self, at: f64) -> f64 {
        self.start + at * self.length
    }

    /// Returns the integral of the quantity times exp(−iνt) over the piece, for the angular frequency ν.
    fn integral(&self, frequency: f64) -> Complex<f64> {
        let duration = self.end * self.length;
        // The solver's power series extends over 1.5 rad of its fastest oscillation.
        let rules = (2.0_f64).max((frequency * duration / RULE).ceil());
        let half = 0.5 * self.end / rules;
        let mut sum = Complex::new(0.0, 0.0);
        for rule in 0..rules as usize {
            let middle = half * (2 * rule + 1) as f64;
            for (point, weight) in GAUSS {
                for at in [middle - half * point, middle + half * point] {
                    let turned = Complex::from_polar(weight, -frequency * self.time(at));
                    sum += turned * value(&self.terms, at);
                }
            }
        }
        sum * (half * self.length)
    }
}

/// The course of a displacement or a force over the period of a steady state.
///
/// The phase τ = ωt of the load is 0 at a maximum of the load, where the period begins. Displacements, forces and
/// velocities (derivatives with respect to τ) are in the units of [`JoinedAt::units`](super::JoinedAt::units).
#[derive(Clone, Debug)]
pub struct Waveform {
    pieces: Vec<Piece>,
    /// Angular frequency of the load, and number of its cycles in the period.
    omega: f64,
    cycles: usize,
}

impl Waveform {
    pub(super) fn new(pieces: Vec<Piece>, omega: f64, cycles: usize) -> Self {
        Self {
            pieces,
            omega,
            cycles,
        }
    }

    fn period(&self) -> f64 {
        TAU * self.cycles as f64 / self.omega
    }

    /// Returns the instants at which the quantity may have its largest and smallest value, with the values there, in
    /// the order of time.
    fn turns(&self) -> Vec<(f64, f64)> {
        let of_piece = |piece: &Piece| {
            let points = extremes_between(&piece.terms, piece.end);
            let piece = *piece;
            points.map(move |(at, value)| (piece.time(at), value))
        };
        self.pieces.iter().flat_map(of_piece).collect()
    }

    /// Returns the smallest and the largest value in the period.
    #[must_use]
    pub fn extremes(&self) -> (f64, f64) {
        let values = self.turns().into_iter().map(|(_, value)| value);
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(value), high.max(value))
        })
    }

    /// Returns the largest absolute value in the period.
    #[must_use]
    pub fn amplitude(&self) -> f64 {
        let (low, high) = self.extremes();
        high.max(-low)
    }

    /// Returns half of the difference between the largest and the smallest value.
    #[must_use]
    pub fn centred_amplitude(&self) -> f64 {
        let (low, high) = self.extremes();
        0.5 * (high - low)
    }

    /// Returns the mean of the largest and the smallest value. For a contact that sticks off its centre, this is its
    /// offset.
    #[must_use]
    pub fn middle(&self) -> f64 {
        let (low, high) = self.extremes();
        0.5 * (high + low)
    }

    /// Returns the lag of the largest absolute value behind the maximum of the load, in rad, in (−π, π]. If the
    /// quantity is negative there, the lag has half a turn more.
    ///
    /// If the quantity keeps its largest value for some time, the lag belongs to the beginning of this time. If several
    /// maxima are equal, the result is the lag of smallest size. If two lags of equal size have opposite signs, it is
    /// the positive lag.
    #[must_use]
    pub fn phase(&self) -> f64 {
        phase_of(&self.turns(), self.omega)
    }

    /// Returns the lag of the fundamental component behind the load, −arg X₁, in rad, in (−π, π].
    #[must_use]
    pub fn fundamental_phase(&self) -> f64 {
        wrapped(-self.harmonic(1).arg())
    }

    /// Returns the complex amplitude X_n of a harmonic of the load: the quantity is Re Σ X_n exp(inτ). X_0 is its mean.
    /// If the period has several cycles, the harmonics are only a part of it.
    #[must_use]
    pub fn harmonic(&self, n: u32) -> Complex<f64> {
        let cycles = u32::try_from(self.cycles).unwrap_or(u32::MAX);
        self.subharmonic(n.saturating_mul(cycles))
    }

    /// Returns the complex amplitude X of the component with k oscillations in a period. It adds Re X exp(ikτ/p) to the
    /// quantity, where p is the number of cycles in the period.
    #[must_use]
    pub fn subharmonic(&self, k: u32) -> Complex<f64> {
        let period = self.period();
        let pieces = self.pieces.iter();
        let frequency = f64::from(k) * TAU / period;
        let integral: Complex<f64> = pieces.map(|piece| piece.integral(frequency)).sum();
        integral * (if k == 0 { 1.0 } else { 2.0 } / period)
    }

    /// Returns the value at the phase τ in rad. At τ = 0 the load has a maximum.
    #[must_use]
    pub fn displacement(&self, tau: f64) -> f64 {
        self.at(tau, |piece, at| value(&piece.terms, at))
    }

    /// Returns the derivative of the value with respect to τ, at the phase τ in rad. Where it jumps, the result is the
    /// derivative after the jump.
    #[must_use]
    pub fn velocity(&self, tau: f64) -> f64 {
        self.at(tau, |piece, at| {
            value(&slope(&piece.terms), at) / (piece.length * self.omega)
        })
    }

    /// Returns the largest absolute derivative with respect to τ in the period.
    #[must_use]
    pub fn largest_velocity(&self) -> f64 {
        let of_piece = |piece: &Piece| {
            let points = extremes_between(&slope(&piece.terms), piece.end);
            let largest = points.map(|(_, value)| value.abs()).fold(0.0, f64::max);
            largest / (piece.length * self.omega)
        };
        self.pieces.iter().map(of_piece).fold(0.0, f64::max)
    }

    fn at(&self, tau: f64, of: impl Fn(&Piece, f64) -> f64) -> f64 {
        let time = (tau / self.omega).rem_euclid(self.period());
        let after = self.pieces.partition_point(|piece| piece.start <= time);
        let piece = self.pieces.get(after.saturating_sub(1));
        piece.map_or(f64::NAN, |piece| {
            let at = (time - piece.start) / piece.length;
            of(piece, at.min(piece.end))
        })
    }
}

/// Returns the lag of the largest absolute value, as [`Waveform::phase`] does. `turns` contains the instants at which the
/// quantity may have this value, in the order of time, with the values there.
pub(super) fn phase_of<S: Float>(turns: &[(S, S)], omega: S) -> S {
    let size = |turn: &(S, S)| turn.1.to_f64();
    let largest = turns
        .iter()
        .fold(0.0_f64, |most, turn| most.max(size(turn).abs()));
    let is_largest = |value: f64| value.abs() >= largest * (1.0 - EQUAL);
    let before = turns.iter().cycle().skip(turns.len().saturating_sub(1));
    let begins = turns.iter().zip(before).filter(|(turn, before)| {
        let (value, before) = (size(turn), size(before));
        is_largest(value) && !(is_largest(before) && before.signum() == value.signum())
    });
    let lags = begins.map(|(turn, _)| {
        let half = if size(turn) < 0.0 { PI } else { 0.0 };
        let lag = omega * turn.0 + S::constant(half);
        lag.replaced(wrapped(lag.to_f64()))
    });
    let nearest = lags.reduce(|one, other| {
        let (new, old) = (other.to_f64(), one.to_f64());
        let is_nearer = new.abs() < old.abs() - EQUAL;
        let is_positive = new.abs() < old.abs() + EQUAL && old < 0.0 && 0.0 < new;
        if is_nearer || is_positive { other } else { one }
    });
    nearest.unwrap_or(S::constant(0.0))
}

/// Returns an angle that differs from the given angle by full turns, in (−π, π].
fn wrapped(angle: f64) -> f64 {
    let within = angle.rem_euclid(TAU);
    if within > PI { within - TAU } else { within }
}
