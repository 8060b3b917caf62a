//! A scene read from its modal data as they stand in some scalar: what separates the rounding of an
//! evaluation from the rounding of its data.

use frictiongen_kernel::chain::{Chain, ContactAt, ModeAt};
use frictiongen_kernel::decay::{Damped, Decay, Instant};
use frictiongen_kernel::mode::{Kind, Mode, ModeResponse};
use frictiongen_kernel::motion::Friction;
use frictiongen_kernel::search::Peak;
use frictiongen_kernel::steady::Motion;
use frictiongen_kernel::wave::{Sum, Wave};
use frictiongen_kernel::{Complex, Float};
use frictiongen_model::modal::Reduced;

/// Modal data, and which mass a contact with a support is on.
#[derive(Clone, Debug)]
pub struct Data<S> {
    /// Modes, shapes, chain.
    pub reduced: Reduced<S>,
    /// The contact's two masses, or its one.
    pub contact: (usize, Option<usize>),
}

/// The scene at one frequency ratio.
pub struct DataAt<'a, S> {
    data: &'a Data<S>,
    inverse_r: S,
    contact: ContactAt<S>,
    modes: Vec<ModeAt<S>>,
}

/// The motion of the contact or of a mass.
pub type DataMotion<S> = Motion<S, Damped<S>, Vec<Wave<S, Damped<S>>>>;

impl<S: Float> Data<S> {
    /// The same data in another scalar.  What a mode's constants say twice is formed anew from what
    /// says it best.
    pub fn read<T: Float>(&self, to: impl Fn(S) -> T) -> Data<T> {
        let Reduced {
            modes,
            shapes,
            chain,
            ends,
        } = &self.reduced;
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
                mobility: to(mode.mobility),
                static_residue: to(mode.static_residue),
            }
        };
        Data {
            reduced: Reduced {
                modes: modes.iter().map(mode).collect(),
                shapes: shapes
                    .iter()
                    .map(|shape| shape.iter().map(|value| to(*value)).collect())
                    .collect(),
                chain: Chain {
                    damped: chain.damped,
                    on_moving_base: chain.on_moving_base.map(&to),
                    mobility: to(chain.mobility),
                    stiction: to(chain.stiction),
                },
                ends: frictiongen_model::modal::Ends {
                    sliding_at_rest: to(ends.sliding_at_rest),
                    continuous_at_infinity: to(ends.continuous_at_infinity),
                    sliding_at_infinity: to(ends.sliding_at_infinity),
                },
            },
            contact: self.contact,
        }
    }

    /// The scene at r, 0 < r < ∞.
    pub fn at(&self, r: S) -> DataAt<'_, S> {
        let Reduced { modes, chain, .. } = &self.reduced;
        let (low, high) = frictiongen_kernel::regime::inverse_ratio_range(
            modes.iter().map(|mode| mode.resonance),
        );
        let inverse_r = (S::constant(1.0) / r).max(low).min(high);
        let mut responses = vec![ModeResponse::zero(); modes.len()];
        let scale = Chain::responses(modes, inverse_r, &mut responses);
        let mut at = vec![ModeAt::zero(); modes.len()];
        let contact = chain.contact(modes, &responses, scale, inverse_r, &mut at);
        DataAt {
            data: self,
            inverse_r,
            contact,
            modes: at,
        }
    }
}

/// ζ and q = √|1 − ζ²|: q from ζ, but beside critical damping ζ from q, which says there within its
/// rounding what ζ cannot.
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

/// q = √|1 − ζ²| and 1 − q.
pub fn roots<S: Float>(zeta: S) -> (S, S) {
    let one = S::constant(1.0);
    let q = ((one - zeta) * (one + zeta)).abs().sqrt();
    (q, zeta * zeta / (one + q))
}

impl<S: Float> DataAt<'_, S> {
    fn chain(&self) -> &Chain<S> {
        &self.data.reduced.chain
    }

    fn idle(&self) -> Vec<Wave<S, Damped<S>>> {
        let modes = self.data.reduced.modes.iter().zip(&self.modes);
        modes
            .map(|(mode, at)| Wave::rest(at.x, Damped::of(mode)))
            .collect()
    }

    /// The search for the velocity constraint S.
    pub fn constraint_peak(&self) -> Peak<S> {
        let modes = &self.data.reduced.modes;
        self.chain()
            .velocity_constraint(&self.contact, modes, &self.modes, &mut self.idle())
    }

    /// Σ m(1 + g)p + mu(cos τ − p′), which over sin τ is what S is the largest value of.
    fn at_instant<T>(&self, tau: S, read: impl Fn(&Sum<'_, S, Damped<S>>, &Instant<S>) -> T) -> T {
        let mut waves = self.idle();
        let modes = self.data.reduced.modes.iter().zip(&self.modes);
        for (wave, (mode, at)) in waves.iter_mut().zip(modes) {
            if mode.in_contact {
                wave.free = mode.mobility * (self.contact.scale + at.g);
                wave.swing_slope = mode.mobility * at.u;
            }
        }
        let zero = S::constant(0.0);
        let sum = Sum {
            waves: &waves,
            cosine: zero,
            sine: zero,
        };
        read(&sum, &Instant::new(tau * S::inverse_pi()))
    }

    /// The velocity constraint at one instant; 0 at the ends of the half period, where it has no meaning.
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

    /// β_lim were S what it is at τ, of either sign over the whole half period, or the break-away term.
    pub fn continuous_limit_by(&self, tau: S) -> S {
        let constraint = self.at_instant(tau, |sum, at| sum.value(at) / at.sine);
        let chain = self.chain();
        let constraint = constraint.max(chain.break_away(&self.contact));
        chain.continuous_limit(&self.contact, constraint)
    }

    /// What is 0 where the constraint is at its largest.
    pub fn constraint_slope(&self, tau: S) -> S {
        self.at_instant(tau, |sum, at| {
            sum.slope(at) * at.sine - sum.value(at) * at.cosine
        })
    }

    /// β_lim.
    pub fn continuous_limit(&self) -> S {
        let constraint = self.constraint_peak().value;
        self.chain().continuous_limit(&self.contact, constraint)
    }

    /// β_lim with S as it is at τ, or at τ → 0 if that is larger.
    pub fn continuous_limit_at(&self, tau: S) -> S {
        let chain = self.chain();
        let constraint = self.constraint(tau).max(chain.break_away(&self.contact));
        chain.continuous_limit(&self.contact, constraint)
    }

    /// β_lim with S at τ → 0.
    pub fn continuous_limit_without_search(&self) -> S {
        let chain = self.chain();
        chain.continuous_limit(&self.contact, chain.break_away(&self.contact))
    }

    /// β_lim with S as the sum of each mode's own maximum.
    pub fn continuous_limit_per_mode(&self) -> S {
        let (chain, modes) = (self.chain(), &self.data.reduced.modes);
        let constraint = chain.constraint_per_mode::<Damped<S>>(&self.contact, modes, &self.modes);
        chain.continuous_limit(&self.contact, constraint)
    }

    /// β*_lim.
    pub fn sliding_limit(&self) -> S {
        let chain = self.chain();
        match chain.absorbed_force(&self.contact, &self.data.reduced.modes, &self.modes) {
            Some(force) => force.abs() / chain.stiction,
            None => chain.sliding_limit(&self.contact),
        }
    }

    /// V, times r² and the scale.
    pub fn free(&self) -> Complex<S> {
        self.contact.v
    }

    fn friction(&self, beta: S) -> Friction<S> {
        self.chain().friction(&self.contact, self.inverse_r, beta)
    }

    /// Q, which vanishes where β reaches |V|/|U|.
    pub fn in_phase(&self, beta: S) -> S {
        self.friction(beta).root
    }

    /// The waves of the modes that the contact drives.
    fn waves(
        &self,
        of: impl Fn(usize, &Mode<S>, &ModeAt<S>) -> Wave<S, Damped<S>>,
    ) -> Vec<Wave<S, Damped<S>>> {
        let modes = self.data.reduced.modes.iter().zip(&self.modes).enumerate();
        modes
            .filter(|(_, (mode, _))| mode.in_contact)
            .map(|(index, (mode, at))| of(index, mode, at))
            .collect()
    }

    /// The relative motion in the contact at β.
    pub fn contact(&self, beta: S) -> DataMotion<S> {
        let friction = self.friction(beta);
        let carrier = self.chain().contact_carrier(&self.contact, &friction);
        let waves = self.waves(|_, mode, at| {
            self.chain()
                .contact_wave(mode, at, &self.contact, &friction, self.inverse_r)
        });
        Motion::of_contact(friction, carrier, waves)
    }

    /// The motion of a mass at β.
    pub fn mass(&self, mass: usize, beta: S) -> DataMotion<S> {
        let Reduced { modes, shapes, .. } = &self.data.reduced;
        if self.chain().on_moving_base.is_none() && self.data.contact == (mass, None) {
            return self.contact(beta);
        }
        let friction = self.friction(beta);
        let carrier = self.chain().carrier(
            &shapes[mass],
            modes,
            &self.modes,
            &self.contact,
            &friction,
            self.inverse_r,
        );
        let waves = self.waves(|i, mode, at| {
            let component = shapes[mass][i];
            self.chain().mass_wave(
                mode,
                component,
                at,
                &self.contact,
                &friction,
                self.inverse_r,
            )
        });
        Motion::of_mass(friction, carrier, waves)
    }

    /// The complex amplitude of a mass while the contact is stuck.
    pub fn stuck(&self, mass: usize) -> Complex<S> {
        let Reduced { modes, shapes, .. } = &self.data.reduced;
        let chain = self.chain();
        let zero = S::constant(0.0);
        if self.data.contact == (mass, None) {
            let held = if chain.on_moving_base.is_some() {
                1.0
            } else {
                0.0
            };
            return Complex::new(S::constant(held), zero);
        }
        if let Some(force) = chain.absorbed_force(&self.contact, modes, &self.modes) {
            let amplitude = chain.stuck_under(
                force,
                &shapes[mass],
                modes,
                &self.modes,
                &self.contact,
                self.inverse_r,
            );
            return Complex::new(amplitude, zero);
        }
        chain.stuck(
            &shapes[mass],
            modes,
            &self.modes,
            &self.contact,
            self.inverse_r,
        )
    }
}
