//! One frequency and its harmonics in samples, with their uncertainty.
//!
//! Thesis 4.3.3 takes the peak of a spectrum under a Hann window with zero padding.  This is the same, with its two errors
//! removed: the window's sums are solved for all harmonics and the mean at once, so that none leaks into another, and the
//! frequency is not one of a grid.

use crate::Complex;
use nalgebra::{DMatrix, DVector};
use rustfft::FftPlanner;
use std::f64::consts::TAU;

/// The harmonics that are told apart, where there are samples enough for them.
pub const HARMONICS: usize = 5;
/// How far the noise beside the driving frequency is looked for, of that frequency; the other ends lie at the first
/// subharmonic and at one and a half, where a contact may put something.
const BESIDE: f64 = 0.45;
/// Bins of a Hann window that belong to its line.
const LINE: f64 = 3.0;
/// Fewer bins beside the line tell the noise to less than a tenth; then those between the harmonics are taken too.
const ENOUGH_BINS: usize = 64;
/// Fewer bins do not make a floor.
const FEWEST_BINS: usize = 12;

/// A frequency and its harmonics in one channel: x = Re Σ X_n e^{inωt}, with t from the middle of the part that was taken.
#[derive(Clone, Debug, PartialEq)]
pub struct Tone {
    /// The mean.
    pub mean: f64,
    /// X_1, X_2, ….
    pub harmonics: Vec<Complex<f64>>,
    /// The standard deviation of the real part, and of the imaginary one, of each of them.
    pub deviation: f64,
    /// The root of the mean square of what is left when mean and harmonics are taken away.
    pub residual: f64,
}

impl Tone {
    /// X_1.
    #[must_use]
    pub fn fundamental(&self) -> Complex<f64> {
        let zero = Complex::new(0.0, 0.0);
        self.harmonics.first().copied().unwrap_or(zero)
    }
}

/// The Hann window and the rotations of a frequency over a number of samples.
pub(super) struct Basis {
    /// w_t.
    window: Vec<f64>,
    /// e^{iωt}.
    turns: Vec<Complex<f64>>,
    harmonics: usize,
    /// Of the sums of the window, factored.
    normal: Option<nalgebra::Cholesky<f64, nalgebra::Dyn>>,
    /// Cycles of the frequency in all.
    cycles: f64,
}

impl Basis {
    /// For `count` samples of a frequency of so many cycles a sample.
    pub(super) fn new(count: usize, per_sample: f64, most: usize) -> Self {
        let middle = 0.5 * (count as f64 - 1.0);
        let window = (0..count).map(|t| {
            // Without the zeros at its ends: over count + 1 intervals.
            0.5 - 0.5 * (TAU * (t as f64 + 1.0) / (count as f64 + 1.0)).cos()
        });
        let window: Vec<f64> = window.collect();
        let turns = (0..count).map(|t| {
            let (sin, cos) = (TAU * per_sample * (t as f64 - middle)).sin_cos();
            Complex::new(cos, sin)
        });
        let turns: Vec<Complex<f64>> = turns.collect();
        // Below half the rate with room to spare.
        let room = (0.45 / per_sample).floor() as usize;
        let harmonics = most.min(room).max(1);
        let mut sums = vec![Complex::new(0.0, 0.0); 2 * harmonics + 1];
        for (weight, turn) in window.iter().zip(&turns) {
            let mut power = Complex::new(*weight, 0.0);
            for sum in &mut sums {
                *sum += power;
                power *= turn;
            }
        }
        let normal = normal(&sums, harmonics).cholesky();
        Self {
            window,
            turns,
            harmonics,
            normal,
            cycles: per_sample * count as f64,
        }
    }

    /// Mean and harmonics of samples; none where they cannot be told apart.
    fn components(&self, samples: &[f64]) -> Option<(f64, Vec<Complex<f64>>)> {
        let mut sums = vec![Complex::new(0.0, 0.0); self.harmonics + 1];
        for ((value, weight), turn) in samples.iter().zip(&self.window).zip(&self.turns) {
            let mut power = Complex::new(value * weight, 0.0);
            for sum in &mut sums {
                *sum += power;
                power *= turn.conj();
            }
        }
        // Unknowns: the mean, then cosine and sine of each harmonic.
        let parts = sums.iter().enumerate().flat_map(|(n, sum)| {
            let sine = (n > 0).then_some(-sum.im);
            std::iter::once(sum.re).chain(sine)
        });
        let right = DVector::from_iterator(2 * self.harmonics + 1, parts);
        let solved = self.normal.as_ref()?.solve(&right);
        let values: Vec<f64> = solved.iter().copied().collect();
        let (mean, rest) = values.split_first()?;
        let pairs = rest.chunks_exact(2);
        let harmonics = pairs.filter_map(|pair| Some(Complex::new(*pair.first()?, -*pair.last()?)));
        Some((*mean, harmonics.collect()))
    }

    /// The tone of samples, with its uncertainty; none where there are too few cycles.
    pub(super) fn tone(&self, samples: &[f64]) -> Option<Tone> {
        let (mean, harmonics) = self.components(samples)?;
        let left: Vec<f64> = samples
            .iter()
            .zip(&self.turns)
            .map(|(value, turn)| {
                let mut power = Complex::new(1.0, 0.0);
                let mut rest = value - mean;
                for harmonic in &harmonics {
                    power *= turn;
                    rest -= (harmonic * power).re;
                }
                rest
            })
            .collect();
        let squares: f64 = left.iter().map(|value| value * value).sum();
        let residual = (squares / left.len() as f64).sqrt();
        let whole: f64 = self.window.iter().sum();
        let floor = self.floor(&left, residual);
        Some(Tone {
            mean,
            harmonics,
            // X = 2D/Σw, and each part of D has half of |D|².
            deviation: (2.0 * floor).sqrt() / whole,
            residual,
        })
    }

    /// The mean of |D|² beside the driving frequency, D = Σ w x e^{−iωt} of what is left.
    fn floor(&self, left: &[f64], residual: f64) -> f64 {
        let count = left.len();
        let windowed = left.iter().zip(&self.window).map(|(x, w)| x * w);
        let mut spectrum: Vec<Complex<f64>> =
            windowed.map(|value| Complex::new(value, 0.0)).collect();
        FftPlanner::new()
            .plan_fft_forward(count)
            .process(&mut spectrum);
        let apart = |bin: f64| (bin - self.cycles).abs();
        let beside = |bin: f64| LINE < apart(bin) && apart(bin) < BESIDE * self.cycles;
        let power = |wanted: &dyn Fn(f64) -> bool| {
            let half = spectrum.iter().take(count / 2).enumerate();
            let bins = half.filter(|(bin, _)| wanted(*bin as f64));
            bins.fold((0_usize, 0.0), |(n, sum), (_, value)| {
                (n + 1, sum + value.norm_sqr())
            })
        };
        let (bins, sum) = power(&beside);
        if ENOUGH_BINS <= bins {
            return sum / bins as f64;
        }
        // Few cycles: everything between the harmonics.
        let top = (self.harmonics as f64 + 0.5) * self.cycles;
        let between = |bin: f64| {
            let nearest = (bin / self.cycles).round() * self.cycles;
            LINE < (bin - nearest).abs() && bin < top
        };
        let (bins, sum) = power(&between);
        if FEWEST_BINS <= bins {
            return sum / bins as f64;
        }
        let squares: f64 = self.window.iter().map(|w| w * w).sum();
        residual * residual * squares
    }
}

/// The matrix of the weighted least squares, of the sums Σ w e^{imωt}.
fn normal(sums: &[Complex<f64>], harmonics: usize) -> DMatrix<f64> {
    let at = |m: isize| {
        let sum = sums
            .get(m.unsigned_abs())
            .copied()
            .unwrap_or(Complex::new(0.0, 0.0));
        if m < 0 { sum.conj() } else { sum }
    };
    let size = 2 * harmonics + 1;
    // Columns: 1, cos ωt, sin ωt, cos 2ωt, …
    let order = |index: usize| {
        (
            index.div_ceil(2) as isize,
            index > 0 && index.is_multiple_of(2),
        )
    };
    DMatrix::from_fn(size, size, |i, j| {
        let ((a, a_sine), (b, b_sine)) = (order(i), order(j));
        let (sum, difference) = (at(a + b), at(a - b));
        match (a_sine, b_sine) {
            (false, false) => 0.5 * (sum.re + difference.re),
            (true, true) => 0.5 * (difference.re - sum.re),
            (true, false) => 0.5 * (sum.im + difference.im),
            (false, true) => 0.5 * (sum.im - difference.im),
        }
    })
}

/// How many times longer the samples are made with zeros before their spectrum is taken.
const PADDING: usize = 4;
/// From so many samples on none are added.
const LONG: usize = 1 << 20;
/// Steps in which a frequency is made better by the phases of both halves.
const STEPS: usize = 4;
/// Fewer cycles do not tell a frequency.
pub(super) const FEWEST_CYCLES: f64 = 4.0;

/// The frequency that stands out, in cycles a sample; none where the spectrum has its peak at its start.
pub(super) fn frequency(samples: &[f64]) -> Option<f64> {
    let count = samples.len();
    let mean = samples.iter().sum::<f64>() / count as f64;
    // A long recording has bins enough.
    let padding = if count < LONG { PADDING } else { 1 };
    let padded = (padding * count).next_power_of_two();
    let mut spectrum: Vec<Complex<f64>> = samples
        .iter()
        .enumerate()
        .map(|(t, value)| {
            let w = 0.5 - 0.5 * (TAU * (t as f64 + 1.0) / (count as f64 + 1.0)).cos();
            Complex::new(w * (value - mean), 0.0)
        })
        .collect();
    spectrum.resize(padded, Complex::new(0.0, 0.0));
    FftPlanner::new()
        .plan_fft_forward(padded)
        .process(&mut spectrum);
    let half = spectrum.iter().take(padded / 2).enumerate();
    let (bin, _) = half.max_by(|a, b| a.1.norm_sqr().total_cmp(&b.1.norm_sqr()))?;
    let mut found = bin as f64 / padded as f64;
    let cycles = |found: f64| found * count as f64;
    if cycles(found) < FEWEST_CYCLES {
        return None;
    }
    let middle = count / 2;
    let (first, second) = samples.split_at(middle);
    for _ in 0..STEPS {
        let phase = |part: &[f64]| {
            let basis = Basis::new(part.len(), found, 2);
            let (_, harmonics) = basis.components(part)?;
            harmonics.first().map(|x| x.im.atan2(x.re))
        };
        // The middles of both halves are half of all samples apart, and the phases count from there.
        let apart = 0.5 * count as f64;
        let turns = (phase(second)? - phase(first)?) / TAU - found * apart;
        found += (turns - turns.round()) / apart;
    }
    (FEWEST_CYCLES <= cycles(found)).then_some(found)
}
