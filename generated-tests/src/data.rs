//! Scenes whose modal data is converted to another scalar type.
//!
//! A comparison of the results in both scalar types separates the rounding of the evaluation from the rounding of the
//! data.

use frictiongen_kernel::contact::sums::{Chain, ModeAt};
use frictiongen_kernel::modal_sum::wave::{Sum, Wave};
use frictiongen_kernel::oscillator::decay::{Damped, Decay, Instant};
use frictiongen_kernel::oscillator::mode::{Kind, Mode};
use frictiongen_kernel::response::{At, Ends, MotionOf};
use frictiongen_kernel::{Complex, Float};
use frictiongen_model::reduced::Reduced;
use std::ops::Deref;

/// Modal data of a scene in the scalar type `S`.
#[derive(Clone, Debug)]
pub struct Data<S> {
    /// Modes, mode shapes and chain.
    pub reduced: Reduced<S>,
}

/// A scene at one frequency ratio, with the kernel's frequency stage. Methods evaluate functions at single instants.
pub struct DataAt<'a, S: Float>(At<&'a Reduced<S>>);

impl<'a, S: Float> Deref for DataAt<'a, S> {
    type Target = At<&'a Reduced<S>>;

    fn deref(&self) -> &Self::Target {
        &self.0
    }
}

/// Motion of the contact or of one mass.
pub type DataMotion<'a, S> = MotionOf<&'a Reduced<S>>;

impl<S: Float> Data<S> {
    /// Converts the data to another scalar type. If a mode stores a constant in two forms, the more accurate form is
    /// converted, and the second form is computed from the first.
    pub fn read<T: Float>(&self, to: impl Fn(S) -> T) -> Data<T> {
        let Reduced {
            modes,
            shapes,
            quadratures,
            chain,
            ends,
            compliance,
            rubbing,
            absorbs,
            unbounded,
            invisible,
            two_at_once,
        } = &self.reduced;
        let all = |values: &[S]| values.iter().map(|value| to(*value)).collect();
        let mode = |mode: &Mode<S>| {
            let (zeta, q) = damping(mode, &to);
            let q_defect = zeta * zeta / (T::constant(1.0) + q);
            Mode {
                kind: mode.kind,
                in_contact: mode.in_contact,
                resonance: to(mode.resonance),
                zeta,
                q,
                q_defect,
                load: to(mode.load),
                contact: to(mode.contact),
                residue: to(mode.residue),
                contact_squared: to(mode.contact_squared),
                static_residue: to(mode.static_residue),
            }
        };
        Data {
            reduced: Reduced {
                modes: modes.iter().map(mode).collect(),
                shapes: all(shapes),
                quadratures: quadratures.iter().map(|pair| pair.map(&to)).collect(),
                chain: Chain {
                    damped: chain.damped,
                    on_moving_base: chain.on_moving_base.map(&to),
                    inverse_mass: to(chain.inverse_mass),
                    stiction: to(chain.stiction),
                },
                ends: Ends {
                    sliding_at_rest: to(ends.sliding_at_rest),
                    continuous_at_infinity: to(ends.continuous_at_infinity),
                    sliding_at_infinity: to(ends.sliding_at_infinity),
                },
                compliance: compliance.map(&to),
                rubbing: *rubbing,
                absorbs: *absorbs,
                unbounded: all(unbounded),
                invisible: all(invisible),
                two_at_once: *two_at_once,
            },
        }
    }

    /// Evaluates the scene at the frequency ratio r, 0 < r < ∞.
    pub fn at(&self, r: S) -> DataAt<'_, S> {
        DataAt(At::new(&self.reduced, r).expect("in the domain"))
    }
}

/// Returns ζ and q = √|1 − ζ²|, converted to the scalar type of the result. Near critical damping the function computes
/// ζ from q, because q then determines ζ within the rounding of q. Elsewhere it computes q from ζ.
fn damping<S: Float, T: Float>(mode: &Mode<S>, to: impl Fn(S) -> T) -> (T, T) {
    let (zeta, q) = (to(mode.zeta), to(mode.q));
    let one = T::constant(1.0);
    let beside = |square: T| (square.sqrt(), q);
    match mode.kind {
        Kind::Heavy if q.to_f64() < 0.5 => beside(one - q * q),
        Kind::Over if q.to_f64() < 0.5 => beside(one + q * q),
        _ => (zeta, roots(zeta).0),
    }
}

/// Returns q = √|1 − ζ²| and 1 − q.
pub fn roots<S: Float>(zeta: S) -> (S, S) {
    let one = S::constant(1.0);
    let q = ((one - zeta) * (one + zeta)).abs().sqrt();
    (q, zeta * zeta / (one + q))
}

impl<'a, S: Float> DataAt<'a, S> {
    fn chain(&self) -> &'a Chain<S> {
        &self.scene().chain
    }

    /// Reads the sum Σ m(1 + g)p + mu(cos τ − p′) of the velocity constraint at the instant τ. S, the largest
    /// velocity constraint, is the maximum of this sum divided by sin τ.
    fn at_instant<T>(&self, tau: S, read: impl Fn(&Sum<'_, S, Damped<S>>, &Instant<S>) -> T) -> T {
        let modes = self.scene().modes.iter().zip(self.modes());
        let part = |(mode, at): (&Mode<S>, &ModeAt<S>)| {
            let mut wave = Wave::at_rest(at.x, Damped::of(mode));
            if mode.in_contact {
                wave.free = mode.contact_squared * (self.contact_sums().scale + at.g);
                wave.forced_slope = mode.contact_squared * at.u;
            }
            wave
        };
        let waves: Vec<_> = modes.map(part).collect();
        let zero = S::constant(0.0);
        let sum = Sum {
            waves: &waves,
            cosine: zero,
            sine: zero,
        };
        read(&sum, &Instant::new(tau * S::inverse_pi()))
    }

    /// Returns the velocity constraint at the instant τ. At τ = 0 and τ = π, where the constraint is undefined, the
    /// result is 0.
    pub fn constraint(&self, tau: S) -> S {
        let zero = S::constant(0.0);
        self.at_instant(tau, |sum, at| {
            if zero < at.sine {
                (sum.value(at) / at.sine).abs()
            } else {
                zero
            }
        })
    }

    /// Returns β_lim with the signed velocity constraint at an instant τ of the half period in place of its maximum
    /// S. If the break-away term is larger, it replaces the constraint.
    pub fn continuous_limit_by(&self, tau: S) -> S {
        let constraint = self.at_instant(tau, |sum, at| sum.value(at) / at.sine);
        let chain = self.chain();
        let constraint = constraint.max(chain.break_away(self.contact_sums()));
        chain.continuous_limit(self.contact_sums(), constraint)
    }

    /// Returns a function of τ that is 0 where the velocity constraint has its maximum.
    pub fn constraint_slope(&self, tau: S) -> S {
        self.at_instant(tau, |sum, at| {
            sum.slope(at) * at.sine - sum.value(at) * at.cosine
        })
    }

    /// Returns β_lim with the velocity constraint at τ in place of its maximum S. If the break-away term is larger,
    /// it replaces the constraint.
    pub fn continuous_limit_at(&self, tau: S) -> S {
        let chain = self.chain();
        let constraint = self
            .constraint(tau)
            .max(chain.break_away(self.contact_sums()));
        chain.continuous_limit(self.contact_sums(), constraint)
    }

    /// Returns V, the response of the contact to the load, multiplied by r² and the scale E.
    pub fn free(&self) -> Complex<S> {
        self.contact_sums().v
    }

    /// Returns Q = √(|V|² − (βU)²), in the scale of the frequency stage. Q vanishes where β reaches |V|/|U|.
    pub fn in_phase(&self, beta: S) -> S {
        self.0.clone().closed_form(beta).friction().root
    }

    /// Returns the relative motion of the contact at the friction ratio β.
    pub fn contact(&self, beta: S) -> DataMotion<'a, S> {
        self.0.clone().closed_form(beta).contact()
    }

    /// Returns the motion of a mass at the friction ratio β.
    pub fn mass(&self, mass: usize, beta: S) -> DataMotion<'a, S> {
        self.0.clone().closed_form(beta).mass(mass)
    }

    /// Returns the complex amplitude of a mass while the contact is stuck.
    pub fn stuck_amplitude(&self, mass: usize) -> Complex<S> {
        self.0.clone().stuck_unchecked().mass(mass)
    }
}
