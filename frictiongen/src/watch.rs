//! One frequency followed sample by sample, in fixed room: a device that watches its own friction.
//!
//! A [`Watch`] is a sliding Goertzel filter: the Fourier sum of its last N samples at a frequency with whole cycles in N.  Two
//! of them, of the base and of a mass, give the transmissibility, and [`friction_ratio`] what friction made of it.  Nothing
//! allocates, nothing panics, and rounding does not add up.

use crate::Complex;
use frictiongen_kernel::Float;

/// The last N samples of a signal at one frequency.
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
    /// Where the next sample goes.
    place: usize,
    full: bool,
    /// Σ x e^{−iωt} of all N samples.
    sum: Complex<S>,
    /// The same of those since `place` was 0: it takes the sum's place every N samples, with roundings of its own alone.
    fresh: Complex<S>,
    /// e^{−iωt} of the next sample, and of a step.
    turn: Complex<S>,
    step: Complex<S>,
}

impl<S: Float, const N: usize> Watch<S, N> {
    /// Of a frequency with so many whole cycles in N samples: the rate is N/cycles times the frequency.  None for no cycle and
    /// for fewer than two samples in one.
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

    /// Takes a sample; the oldest one goes.
    pub fn push(&mut self, sample: S) {
        let Some(slot) = self.samples.get_mut(self.place) else {
            return;
        };
        // With whole cycles the sample N before turned as this one does.
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

    /// X of x = Re X e^{iωt} over the last N samples, with t = 0 at the first sample of all; none before there are N.
    #[must_use]
    pub fn fundamental(&self) -> Option<Complex<S>> {
        #[allow(clippy::cast_precision_loss, reason = "a count of samples")]
        let scale = S::constant(2.0) / S::constant(N as f64);
        let sum = Complex::new(self.sum.re * scale, self.sum.im * scale);
        self.full.then_some(sum)
    }
}

/// X/Y; none where Y is 0.
#[must_use]
pub fn transmissibility<S: Float>(mass: Complex<S>, base: Complex<S>) -> Option<Complex<S>> {
    let size = base.re * base.re + base.im * base.im;
    let quotient = Complex::new(
        (mass.re * base.re + mass.im * base.im) / size,
        (mass.im * base.re - mass.re * base.im) / size,
    );
    (quotient.re.is_finite() && quotient.im.is_finite()).then_some(quotient)
}

/// β from the fundamental of a mass over that of the base, where the contact slides all the time.
///
/// There the fundamental is X = V − (4iβ/π)e^{−iφ}H and |X − V| = 4β|H|/π (thesis 4.5, 6.4.2): friction moves it along a line
/// whose unit a scene tells at any other β.  `still` is what the scene does without friction, `known` what it does at
/// `beta`.  Beyond β_lim the contact stops and the answer is too small; `continuous_limit` says where that is.  None where
/// friction does not move the fundamental at all.
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
