//! Computes the amplitude and phase of a signal at one frequency, sample by sample, in a fixed amount of memory. A
//! device can monitor its own friction in this way.
//!
//! A [`Watch`] is a sliding Goertzel filter. It computes the Fourier sum of its last N samples at one frequency. This
//! frequency must have a whole number of cycles in N samples. Two filters, one for the base and one for a mass, give
//! the displacement transmissibility. [`friction_ratio`] computes the friction ratio from the transmissibility. The
//! code neither allocates nor panics. Its rounding errors do not accumulate.

use crate::Complex;
use frictiongen_kernel::Float;

/// A sliding Fourier sum over the last N samples of a signal, at one frequency.
///
/// ```
/// use frictiongen::watch::Watch;
///
/// // Three cycles in 50 samples.
/// let mut watch = Watch::<f32, 50>::new(3).ok_or("more cycles than samples")?;
/// for i in 0..120 {
///     let turn = std::f32::consts::TAU * 3.0 * i as f32 / 50.0;
///     watch.push(0.25 + 2.0 * (turn - 0.5).cos());
/// }
/// let found = watch.fundamental().ok_or("fewer than 50 samples")?;
/// assert!((found.re - 2.0 * 0.5_f32.cos()).abs() < 1e-5 && (found.im + 2.0 * 0.5_f32.sin()).abs() < 1e-5);
/// # Ok::<(), &str>(())
/// ```
#[derive(Clone, Debug)]
pub struct Watch<S, const N: usize> {
    samples: [S; N],
    /// Index of the next sample in the buffer.
    place: usize,
    full: bool,
    /// Fourier sum Σ x e^{−iωt} of the last N samples, before normalisation.
    sum: Complex<S>,
    /// Fourier sum of the samples since the last return to the start of the buffer. Every N samples it replaces `sum`,
    /// so that the rounding errors of older samples disappear.
    fresh: Complex<S>,
    /// The field `turn` is the factor e^{−iωt} of the next sample. The field `step` is the quotient of this factor for
    /// two successive samples.
    turn: Complex<S>,
    step: Complex<S>,
}

impl<S: Float, const N: usize> Watch<S, N> {
    /// Creates a filter for the frequency with `cycles` whole cycles in N samples, which is cycles/N times the sampling
    /// rate. Returns `None` for zero cycles, and if N is less than 2·cycles + 1.
    #[must_use]
    pub fn new(cycles: u16) -> Option<Self> {
        let zero = S::constant(0.0);
        let wave = usize::from(cycles);
        if wave == 0 || N < wave.saturating_mul(2).saturating_add(1) {
            return None;
        }
        #[allow(clippy::cast_precision_loss, reason = "a count of samples")]
        let share = S::constant(2.0 * f64::from(cycles)) / S::constant(N as f64);
        let (sin, cos) = share.sin_cos_pi();
        Some(Self {
            samples: [zero; N],
            place: 0,
            full: false,
            sum: Complex::new(zero, zero),
            fresh: Complex::new(zero, zero),
            turn: Complex::new(S::constant(1.0), zero),
            step: Complex::new(cos, -sin),
        })
    }

    /// Adds a sample to the filter and drops the oldest sample.
    pub fn push(&mut self, sample: S) {
        let Some(slot) = self.samples.get_mut(self.place) else {
            return;
        };
        // N samples contain whole cycles. The sample N steps ago therefore has the same factor e^{−iωt} as the new
        // sample.
        let change = sample - *slot;
        *slot = sample;
        let turn = self.turn;
        self.sum = Complex::new(
            self.sum.re + change * turn.re,
            self.sum.im + change * turn.im,
        );
        self.fresh = Complex::new(
            self.fresh.re + sample * turn.re,
            self.fresh.im + sample * turn.im,
        );
        self.turn = Complex::new(
            turn.re * self.step.re - turn.im * self.step.im,
            turn.re * self.step.im + turn.im * self.step.re,
        );
        self.place += 1;
        if self.place == N {
            let zero = S::constant(0.0);
            self.place = 0;
            self.full = true;
            self.sum = self.fresh;
            self.fresh = Complex::new(zero, zero);
            self.turn = Complex::new(S::constant(1.0), zero);
        }
    }

    /// Returns the complex amplitude X of the fundamental x = Re X e^{iωt} over the last N samples. The time t is 0 at
    /// the first sample ever added. Returns `None` if fewer than N samples have been added.
    #[must_use]
    pub fn fundamental(&self) -> Option<Complex<S>> {
        #[allow(clippy::cast_precision_loss, reason = "a count of samples")]
        let scale = S::constant(2.0) / S::constant(N as f64);
        let sum = Complex::new(self.sum.re * scale, self.sum.im * scale);
        self.full.then_some(sum)
    }
}

/// Returns the transmissibility X/Y of a mass: its complex amplitude X divided by the complex amplitude Y of the base.
/// Returns `None` if Y is 0.
#[must_use]
pub fn transmissibility<S: Float>(mass: Complex<S>, base: Complex<S>) -> Option<Complex<S>> {
    let size = base.re * base.re + base.im * base.im;
    let quotient = Complex::new(
        (mass.re * base.re + mass.im * base.im) / size,
        (mass.im * base.re - mass.re * base.im) / size,
    );
    (quotient.re.is_finite() && quotient.im.is_finite()).then_some(quotient)
}

/// Returns the friction ratio β from a mass's measured transmissibility, for a contact that slides all the time.
///
/// If the contact slides all the time, the fundamental is X = V − (4iβ/π)e^{−iφ}H. Therefore |X − V| = 4β|H|/π (thesis
/// 4.5, 6.4.2). V is the fundamental without friction, and H the response to a harmonic unit force in the contact.
/// Friction therefore shifts the fundamental in the complex plane, by a distance proportional to β. The scene's
/// response at one known β gives the factor of proportion.
///
/// `measured` is the measured fundamental, and `still` the scene's fundamental without friction. `known` is the scene's
/// fundamental at the friction ratio `beta`. If β exceeds β_lim, which `continuous_limit` returns, the contact stops,
/// and the result is too small. Returns `None` if friction does not shift the fundamental.
///
/// ```
/// use frictiongen::watch::friction_ratio;
///
/// frictiongen::friction_system! {
///     struct Block {
///         masses: { block: 1.0 },
///         springs: { base - block: 1.0 },
///         contact: block - wall,
///         excitation: base,
///         scalar: f32,
///     }
/// }
///
/// # fn main() -> Result<(), frictiongen::Error> {
/// let at = Block::at(1.4)?;
/// let fundamental = |beta| Ok::<_, frictiongen::Error>(at.motion(beta)?.block().harmonic(1));
/// let found = friction_ratio(fundamental(0.37)?, fundamental(0.0)?, fundamental(0.1)?, 0.1);
/// assert!(found.is_some_and(|beta| (beta - 0.37).abs() < 1e-6));
/// # Ok(())
/// # }
/// ```
#[must_use]
pub fn friction_ratio<S: Float>(
    measured: Complex<S>,
    still: Complex<S>,
    known: Complex<S>,
    beta: S,
) -> Option<S> {
    let moved = (measured.re - still.re).hypot(measured.im - still.im);
    let unit = (known.re - still.re).hypot(known.im - still.im);
    let found = beta * moved / unit;
    found.is_finite().then_some(found)
}
