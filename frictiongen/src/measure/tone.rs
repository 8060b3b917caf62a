//! Finds one frequency in samples, and the amplitudes of its harmonics with their uncertainty.
//!
//! Thesis 4.3.3 takes the peak of a spectrum under a Hann window with zero padding. This module uses the same window,
//! but avoids two errors of that method. It solves one system of equations for the mean and all harmonics, so that no
//! harmonic affects another. It also finds frequencies between the lines of a spectrum.

use crate::Complex;
use nalgebra::{DMatrix, DVector};
use rustfft::FftPlanner;
use std::f64::consts::TAU;

/// Largest number of harmonics that the code computes. If a cycle has few samples, the code computes fewer.
pub const HARMONICS: usize = 5;
/// Half-width of the frequency band in which the code estimates the noise, divided by the driving frequency. A wider
/// band would include 0.5 and 1.5 times the driving frequency, at which a contact may cause components of the motion.
const BESIDE: f64 = 0.45;
/// Largest distance of a spectral bin from a harmonic, in bins, at which the bin belongs to the harmonic and not to the
/// noise.
const LINE: f64 = 3.0;
/// Smallest number of spectral bins with which the relative error of the noise estimate is below 0.1. If the band near
/// the driving frequency has fewer bins, the code also uses the bins between the harmonics.
const ENOUGH_BINS: usize = 64;
/// Smallest number of spectral bins from which the code estimates the noise.
const FEWEST_BINS: usize = 12;

/// Mean and harmonics of a channel at one frequency: x = mean + Re Σ X_n e^{inωt}. The time t is 0 in the middle of the
/// samples.
#[derive(Clone, Debug, PartialEq)]
pub struct Tone {
    /// Mean of the samples. It is the component at zero frequency.
    pub mean: f64,
    /// Complex amplitudes X_1, X_2, … of the harmonics.
    pub harmonics: Vec<Complex<f64>>,
    /// Standard deviation of the real part and of the imaginary part of each harmonic's complex amplitude.
    pub deviation: f64,
    /// Root mean square of the samples after mean and harmonics are subtracted.
    pub residual: f64,
}

impl Tone {
    /// Returns X_1, the complex amplitude of the fundamental component.
    #[must_use]
    pub fn fundamental(&self) -> Complex<f64> {
        let zero = Complex::new(0.0, 0.0);
        self.harmonics.first().copied().unwrap_or(zero)
    }
}

/// The weights of the Hann window and the factors e^{iωt} at one frequency, for a given number of samples.
pub(super) struct ToneBasis {
    /// Weights w_t of the Hann window, one for each sample.
    window: Vec<f64>,
    /// Factors e^{iωt}, one for each sample.
    turns: Vec<Complex<f64>>,
    harmonics: usize,
    /// Cholesky factor of the normal equations whose unknowns are the mean and the harmonics.
    normal: Option<nalgebra::Cholesky<f64, nalgebra::Dyn>>,
    /// Number of cycles of the tone's frequency within the samples.
    cycles: f64,
}

impl ToneBasis {
    /// Prepares a fit to `count` samples. `per_sample` is the frequency in cycles per sample, and `most` the largest
    /// number of harmonics.
    pub(super) fn new(count: usize, per_sample: f64, most: usize) -> Self {
        let middle = 0.5 * (count as f64 - 1.0);
        let window = (0..count).map(|t| {
            // The window runs over count + 1 intervals, so that its first and last weights are not zero.
            0.5 - 0.5 * (TAU * (t as f64 + 1.0) / (count as f64 + 1.0)).cos()
        });
        let window: Vec<f64> = window.collect();
        let turns = (0..count).map(|t| {
            let (sin, cos) = (TAU * per_sample * (t as f64 - middle)).sin_cos();
            Complex::new(cos, sin)
        });
        let turns: Vec<Complex<f64>> = turns.collect();
        // The highest harmonic stays below 0.45 of the sampling rate, safely below the Nyquist frequency.
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

    /// Returns the mean and the complex amplitudes of the harmonics of the samples. Returns `None` if the samples do
    /// not determine these values.
    fn components(&self, samples: &[f64]) -> Option<(f64, Vec<Complex<f64>>)> {
        let mut sums = vec![Complex::new(0.0, 0.0); self.harmonics + 1];
        for ((value, weight), turn) in samples.iter().zip(&self.window).zip(&self.turns) {
            let mut power = Complex::new(value * weight, 0.0);
            for sum in &mut sums {
                *sum += power;
                power *= turn.conj();
            }
        }
        // The unknowns are the mean, then the cosine part and the sine part of each harmonic.
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

    /// Returns mean and harmonics of samples with their uncertainty. Returns `None` if the samples have too few cycles.
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
            // D is the windowed spectrum Σ w x e^{−iωt}, and X = 2D/Σw is the amplitude of a harmonic. The real and the
            // imaginary part of D each contribute half of the mean |D|².
            deviation: (2.0 * floor).sqrt() / whole,
            residual,
        })
    }

    /// Returns the mean of |D|² near the driving frequency, as a measure of the noise. D = Σ w x e^{−iωt} is the
    /// spectrum, with the window's weights w and the samples x in `left`. The samples in `left` no longer contain mean
    /// and harmonics.
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
        // A short record has too few bins near the driving frequency. The noise then comes from all bins between the
        // harmonics.
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

/// Returns the matrix of the normal equations for mean and harmonics, computed from the sums Σ w e^{imωt}.
fn normal(sums: &[Complex<f64>], harmonics: usize) -> DMatrix<f64> {
    let at = |m: isize| {
        let sum = sums
            .get(m.unsigned_abs())
            .copied()
            .unwrap_or(Complex::new(0.0, 0.0));
        if m < 0 { sum.conj() } else { sum }
    };
    let size = 2 * harmonics + 1;
    // The columns of the matrix belong to the functions 1, cos ωt, sin ωt, cos 2ωt, …
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

/// Factor by which appended zeros lengthen the samples before the code computes their spectrum.
const PADDING: usize = 4;
/// Number of samples at and above which the code appends no zeros.
const LONG: usize = 1 << 20;
/// Number of steps that refine a frequency. A step compares the phase of the first half of the samples with the phase
/// of the second half.
const STEPS: usize = 4;
/// Smallest number of cycles in the samples from which the code determines a frequency.
pub(super) const FEWEST_CYCLES: f64 = 4.0;

/// Returns the dominant frequency of samples in cycles per sample. Returns `None` if the samples have fewer than
/// [`FEWEST_CYCLES`] cycles of that frequency.
pub(super) fn frequency(samples: &[f64]) -> Option<f64> {
    let count = samples.len();
    let mean = samples.iter().sum::<f64>() / count as f64;
    // Appended zeros make the frequency grid of the spectrum finer. A long recording has a fine grid anyway.
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
            let basis = ToneBasis::new(part.len(), found, 2);
            let (_, harmonics) = basis.components(part)?;
            harmonics.first().map(|x| x.im.atan2(x.re))
        };
        // The phase of each half refers to the middle of that half. The two middles are `count`/2 samples apart.
        let apart = 0.5 * count as f64;
        let turns = (phase(second)? - phase(first)?) / TAU - found * apart;
        found += (turns - turns.round()) / apart;
    }
    (FEWEST_CYCLES <= cycles(found)).then_some(found)
}
