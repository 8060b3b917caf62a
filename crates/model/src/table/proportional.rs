//! Responses of chains with Rayleigh damping, the sum of a mass-proportional and a stiffness-proportional term.
//!
//! Rayleigh damping means 2ζ_i√λ_i = a + bλ_i. Then s² + 2ζ_i√λ_i s + λ_i = (1 + bs)(λ_i + q), with q = (s² + as)/(1 +
//! bs). Every receptance is therefore that of the undamped chain at s² = q, divided by 1 + bs. The zeros and poles of
//! the receptance follow from those of the undamped chain.
//!
//! The force of a spring contains the factor 1 + bs. A response may therefore have a zero at s = −1/b. The order of
//! this zero is the number of springs that transmit the force. An iteration cannot find a multiple zero to its last
//! digits.

use super::zeros::{EQUAL, Rational, Zero};
use crate::modal::Modal;
use frictiongen_kernel::Scalar;
use frictiongen_kernel::number::dd::Dd;

/// Factors a and b of Rayleigh damping, non-dimensional: 2ζ_i√λ_i = a + bλ_i for every mode.
#[derive(Clone, Copy, Debug)]
pub(super) struct Proportional {
    mass: Dd,
    stiffness: Dd,
}

impl Proportional {
    /// Returns the factors a and b of a chain. Returns `None` if the damping of some mode is not a + bλ.
    pub fn of(modal: &Modal) -> Option<Self> {
        let rates = modal.resonances.iter().zip(&modal.damping_ratios);
        let rates = rates.map(|(sigma, zeta)| (*sigma * *sigma, Dd::from(2.0) * *zeta * *sigma));
        let rates: Vec<(Dd, Dd)> = rates.collect();
        let (low, high) = (rates.first()?, rates.last()?);
        let size = low.1.max(high.1);
        let apart = high.0 - low.0;
        let mut stiffness = Dd::ZERO;
        if apart > high.0 * Dd::from(EQUAL) {
            stiffness = (high.1 - low.1) / apart;
        }
        if stiffness.abs() * high.0 <= size * Dd::from(EQUAL) {
            stiffness = Dd::ZERO;
        }
        let own = Self {
            mass: low.1 - stiffness * low.0,
            stiffness,
        };
        let fits = |(square, rate): &(Dd, Dd)| {
            (own.mass + own.stiffness * *square - *rate).abs() <= size * Dd::from(EQUAL)
        };
        rates.iter().all(fits).then_some(own)
    }

    /// Returns the response of the damped chain that corresponds to a response of the undamped chain. `over` is the
    /// number of additional factors 1 + bs in the denominator of the damped response.
    pub fn of_undamped(&self, undamped: &Rational, over: usize) -> Option<Rational> {
        let (mut zeros, mut poles) = (Vec::new(), Vec::new());
        let mut left = 0_isize;
        for zero in &undamped.zeros {
            left -= self.moved(zero, &mut zeros);
        }
        for pole in &undamped.poles {
            left += self.moved(pole, &mut poles);
        }
        left = left.checked_sub_unsigned(over)?;
        if !self.stiffness.is_zero() {
            let carried = Zero {
                x: -(Dd::ONE / self.stiffness),
                y: Dd::ZERO,
            };
            let on = if left < 0 { &mut poles } else { &mut zeros };
            on.extend((0..left.unsigned_abs()).map(|_| carried));
        }
        Some(Rational { zeros, poles })
    }

    /// Appends the zeros of the damped chain that follow from one zero of the undamped chain. Returns the number of
    /// different values of q = s² that belong to this undamped zero.
    fn moved(&self, zero: &Zero, into: &mut Vec<Zero>) -> isize {
        let half = Dd::from(0.5);
        if zero.x.is_zero() || zero.y.is_zero() {
            let square = (zero.y - zero.x) * (zero.y + zero.x);
            let rate = (self.mass + self.stiffness * square) * half;
            let rest = square - rate * rate;
            if rest > Dd::ZERO {
                into.push(Zero {
                    x: -rate,
                    y: rest.sqrt(),
                });
            } else {
                let root = (-rest).sqrt();
                let far = if rate < Dd::ZERO {
                    root - rate
                } else {
                    -(root + rate)
                };
                for x in [far, square / far] {
                    into.push(Zero { x, y: Dd::ZERO });
                }
            }
            return 1;
        }
        // The four zeros ±x ± iy of the undamped chain have two values −s² = y² − x² ∓ 2ixy. One value suffices,
        // because the zeros of the second value are the complex conjugates of the zeros of the first.
        let square = (
            (zero.y - zero.x) * (zero.y + zero.x),
            -(Dd::from(2.0) * zero.x * zero.y),
        );
        let rate = (
            (self.mass + self.stiffness * square.0) * half,
            self.stiffness * square.1 * half,
        );
        let rest = (
            rate.0 * rate.0 - rate.1 * rate.1 - square.0,
            Dd::from(2.0) * rate.0 * rate.1 - square.1,
        );
        let size = rest.0.hypot(rest.1);
        // The larger of the real and the imaginary part of the root is computed first, to avoid cancellation.
        let (re, im) = if rest.0 > Dd::ZERO {
            let re = ((size + rest.0) * half).sqrt();
            (re, rest.1 / (re + re))
        } else {
            let im = ((size - rest.0) * half).sqrt();
            (rest.1 / (im + im), im)
        };
        for side in [Dd::ONE, -Dd::ONE] {
            into.push(Zero {
                x: side * re - rate.0,
                y: (side * im - rate.1).abs(),
            });
        }
        2
    }
}
