//! All functions from which the limits follow, as Taylor series in r with intervals as coefficients (section 3 of
//! `docs/derivation.md`).
//!
//! All functions are multiplied by r². An undamped mode gives U, the velocity of the contact at a reversal that
//! friction causes, a pole wherever cos(πx/2) = 0, with x = √λ/r. Near such poles the functions are also multiplied by
//! κ, the product of these cosines. The limits are quotients, in which κ cancels.

use crate::series::IntervalSeries;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_model::interval::Interval;
use frictiongen_model::modal::Modal;
use frictiongen_model::table::building::contact_modes;

/// Number of terms of the Taylor series in r. The value is tuned. More terms allow longer intervals of r, but the
/// work of a product grows with the square of their number.
pub(crate) const ORDER: usize = 8;

/// Kind of damping of a mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ModeDecay {
    Undamped,
    Under,
    Critical,
    Over,
}

/// The constants of a mode, each as an interval that contains the exact number.
#[derive(Clone, Copy, Debug)]
pub(crate) struct IntervalMode {
    pub kind: ModeDecay,
    pub sigma: Interval,
    pub zeta: Interval,
    /// q = √|1 − ζ²|, with the modal damping ratio ζ.
    pub q: Interval,
    /// ζ/q, with q = √|1 − ζ²|.
    pub zeta_over_q: Interval,
    /// ζ + q, the larger decay rate of an overdamped mode, with q = √|1 − ζ²|.
    pub fast: Interval,
    /// c = (φᵀw)², the inverse effective mass of the mode in the contact.
    pub inverse_mass: Interval,
    /// (φᵀw)(φᵀp), the residue of the mode in the contact's response to the load. φ is the mode shape, w the direction
    /// vector of the contact, and p the load vector.
    pub residue: Interval,
    /// 2ζσ(φᵀw)Γ, the coefficient of ir in the numerator of the mode in the contact's response to the load. Γ is the
    /// participation factor of the mode. `None` unless damping acts on velocities relative to the moving base.
    pub along: Option<Interval>,
}

/// The constants of a chain, as intervals. Each interval contains the number that the modal analysis gives in
/// double-double.
#[derive(Clone, Debug)]
pub(crate) struct IntervalChain {
    pub modes: Vec<IntervalMode>,
    pub all_undamped: bool,
    /// −1 if the contact slides on a moving base, otherwise 0.
    pub direct: Interval,
    /// m*, the inverse effective mass of the contact.
    pub inverse_mass: Interval,
    /// μ, the ratio of the static to the kinetic friction force.
    pub stiction: Interval,
}

impl IntervalChain {
    pub fn of(modal: &Modal) -> Self {
        let one = Dd::ONE;
        let mut inverse_mass = Dd::ZERO;
        let modes: Vec<IntervalMode> = contact_modes(modal)
            .into_iter()
            .map(|mode| {
                let zeta = mode.driven.zeta;
                let q = ((one - zeta) * (one + zeta)).abs().sqrt();
                inverse_mass = inverse_mass + mode.driven.inverse_mass;
                let kind = if zeta.is_zero() {
                    ModeDecay::Undamped
                } else if zeta < one {
                    ModeDecay::Under
                } else if zeta == one {
                    ModeDecay::Critical
                } else {
                    ModeDecay::Over
                };
                IntervalMode {
                    kind,
                    sigma: Interval::of(mode.driven.sigma),
                    zeta: Interval::of(zeta),
                    q: Interval::of(q),
                    zeta_over_q: Interval::of(zeta / q),
                    fast: Interval::of(zeta + q),
                    inverse_mass: Interval::of(mode.driven.inverse_mass),
                    residue: Interval::of(mode.residue),
                    along: (!mode.along.is_zero()).then(|| Interval::of(mode.along)),
                }
            })
            .collect();
        let undamped = |mode: &IntervalMode| mode.kind == ModeDecay::Undamped;
        Self {
            all_undamped: modes.iter().all(undamped),
            modes,
            direct: Interval::point(if modal.on_moving_base { -1.0 } else { 0.0 }),
            inverse_mass: Interval::of(inverse_mass),
            stiction: Interval::of(modal.stiction),
        }
    }
}

/// The functions of a mode, as series in r at a point or over an interval.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ModeStage<const N: usize> {
    pub oscillator: IntervalMode,
    /// x = √λ/r, the natural frequency of the mode divided by the excitation frequency.
    pub x: IntervalSeries<N>,
    /// r/√λ, the inverse of `x`: the excitation frequency divided by the natural frequency of the mode.
    pub slow: IntervalSeries<N>,
    /// κc(1 + g), the coefficient of the free displacement p in the velocity constraint. c is the mode's inverse
    /// effective mass in the contact, g a damping function of the mode, and κ the common factor of all functions.
    pub free: IntervalSeries<N>,
    /// κcu/x², the coefficient of cos τ − p′ in the velocity constraint, where p is the free displacement. c is the
    /// mode's inverse effective mass in the contact, u a damping function of the mode, and κ the common factor of all
    /// functions.
    pub forced_slope: IntervalSeries<N>,
}

/// The functions of the contact and of the modes, as series in r at a point or over an interval.
#[derive(Clone, Debug)]
pub(crate) struct ChainStage<const N: usize> {
    pub modes: Vec<ModeStage<N>>,
    /// 1/r, the inverse of the frequency ratio.
    pub inverse: IntervalSeries<N>,
    /// κ, the product of cosines by which the functions are multiplied. `None` if no cosine is small, so that κ is 1.
    pub kappa: Option<IntervalSeries<N>>,
    /// κr²V, real and imaginary part. V is the response of the contact to the load, and κ the common factor of all
    /// functions.
    pub excitation: [IntervalSeries<N>; 2],
    /// κr²U, where U is the part of the contact's velocity at a reversal that the friction force causes. κ is the
    /// common factor of all functions.
    pub quadrature: IntervalSeries<N>,
    /// κr²G, where G is the part of the contact's displacement at a reversal that the friction force causes. κ is the
    /// common factor of all functions.
    pub displacement: IntervalSeries<N>,
    /// κ(m* + r²H_c), κr² times the velocity constraint for τ → 0. κ is the common factor of all functions. m* is the
    /// inverse effective mass of the contact. H_c is the contribution of damping to the acceleration of the contact at
    /// a reversal.
    pub start: IntervalSeries<N>,
    /// κ(μm* + r²H_c), κr² times the break-away term, which limits β_lim as a velocity constraint does. κ, m* and H_c
    /// are as in `start`.
    pub break_away: IntervalSeries<N>,
}

/// Bound on |cos(πx/2)| of an undamped mode, with x = √λ/r. A cosine below this bound becomes a factor of κ, by which
/// all functions are multiplied. The value is tuned. A quotient by a smaller cosine is wide over an interval of r, but
/// each factor of κ takes more products.
const SINGULAR: f64 = 0.2;
/// Bound on the distance |x − 1| from a resonance, with x = √λ/r. Below this bound the code uses a form in which the
/// pole of V, the response of the contact to the load, and the zero of cos(πx/2) cancel. At a larger distance the code
/// can divide by x² − 1.
const RESONANT: f64 = 0.5;

/// Returns one flag for each mode. It is true if κ, the product of cosines of `ChainStage`, contains the cosine of
/// the mode near r.
pub(crate) fn singular(chain: &IntervalChain, r: f64) -> Vec<bool> {
    let modes = chain.modes.iter();
    let cosine = |mode: &IntervalMode| {
        let x = mode.sigma.middle() / r;
        Interval::point(0.5 * x).sine_cosine().1.size()
    };
    modes
        .map(|mode| mode.kind == ModeDecay::Undamped && cosine(mode) < SINGULAR)
        .collect()
}

impl<const N: usize> ChainStage<N> {
    /// Returns the functions of the chain as series in r over an interval, or at a point.
    pub fn over(chain: &IntervalChain, r: Interval, singular: &[bool]) -> Self {
        let one = IntervalSeries::fixed(Interval::ONE);
        let (ratio, inverse) = (
            IntervalSeries::<N>::variable(r),
            IntervalSeries::<N>::inverse(r),
        );
        let square = ratio.squared();
        let half = Interval::point(0.5);
        // Sine and cosine of πx/2 are needed for the undamped modes.
        let waves: Vec<(IntervalSeries<N>, IntervalSeries<N>)> = chain
            .modes
            .iter()
            .map(|mode| inverse.times(mode.sigma * half).sine_cosine())
            .collect();
        let cosines: Vec<IntervalSeries<N>> = waves
            .iter()
            .zip(singular)
            .filter(|(_, singular)| **singular)
            .map(|((_, cosine), _)| *cosine)
            .collect();
        let kappa = cosines.iter().copied().reduce(|a, b| a * b);
        let scaled = |value: IntervalSeries<N>| kappa.map_or(value, |kappa| kappa * value);
        // Each mode whose cosine is a factor of κ needs the product of the other factors.
        let mut seen = 0;
        let mut others = || {
            let own = seen;
            seen += 1;
            let rest = cosines
                .iter()
                .enumerate()
                .filter(|(place, _)| *place != own);
            rest.map(|(_, cosine)| *cosine).reduce(|a, b| a * b)
        };
        let mut modes = Vec::with_capacity(chain.modes.len());
        let mut excitation = [
            scaled(IntervalSeries::fixed(chain.direct) * square),
            IntervalSeries::fixed(Interval::ZERO),
        ];
        let mut quadrature = IntervalSeries::fixed(Interval::ZERO);
        let mut reversal = IntervalSeries::fixed(Interval::ZERO);
        let mut displacement = IntervalSeries::fixed(Interval::ZERO);
        for ((mode, (sine, cosine)), singular) in chain.modes.iter().zip(&waves).zip(singular) {
            let x = inverse.times(mode.sigma);
            let detuning = square - IntervalSeries::fixed(mode.sigma * mode.sigma);
            let slow = ratio.times(Interval::ONE / mode.sigma);
            let c = mode.inverse_mass;
            let (free, forced_slope);
            if *singular {
                let rest = others();
                let with = |value: IntervalSeries<N>| rest.map_or(value, |rest| rest * value);
                free = scaled(IntervalSeries::fixed(c));
                forced_slope = with(*sine * slow).times(c);
                let beside = x.value() - Interval::ONE;
                let term = if beside.size() < RESONANT {
                    // This form has no pole at x = 1: cos(πx/2)/(x² − 1) = −(π/2) sinc(π(x − 1)/2)/(x + 1).
                    let sinc = (x - one).times(half).sinc();
                    -(sinc / (x + one)).times(Interval::pi() * half)
                } else {
                    -(*cosine * square / detuning)
                };
                let [re, _] = &mut excitation;
                *re = *re + with(term).times(mode.residue);
            } else {
                let (rise, over_forced_slope) = functions(mode, &x, &slow, (sine, cosine));
                forced_slope = scaled(over_forced_slope.times(c));
                free = scaled(rise.times(c));
                let [re, im] = &mut excitation;
                if mode.kind == ModeDecay::Undamped {
                    *re = *re - scaled(square / detuning).times(mode.residue);
                } else {
                    let loss = ratio.times(mode.zeta.doubled() * mode.sigma);
                    let size = detuning.squared() + loss.squared();
                    let term = scaled(square / size).times(mode.residue);
                    *re = *re - term * detuning;
                    *im = *im - term * loss;
                    if let Some(along) = mode.along {
                        let turned = scaled(square / size).times(along) * ratio;
                        *re = *re + turned * loss;
                        *im = *im - turned * detuning;
                    }
                }
                if mode.kind != ModeDecay::Undamped {
                    // A mode adds c(g + 2ζx·u/x²) to the sum H_c, and c·g/x² to the sum G. H_c is the contribution of
                    // damping to the acceleration of the contact at a reversal. G is its displacement from friction at
                    // a reversal.
                    let own = free - scaled(IntervalSeries::fixed(c));
                    let carried = x.times(mode.zeta.doubled()) * forced_slope;
                    reversal = reversal + own + carried;
                    let softness = Interval::ONE / (mode.sigma * mode.sigma);
                    displacement = displacement + own * square.times(softness);
                }
            }
            quadrature = quadrature + forced_slope;
            modes.push(ModeStage {
                oscillator: *mode,
                x,
                slow,
                free,
                forced_slope,
            });
        }
        let mass = scaled(IntervalSeries::fixed(chain.inverse_mass));
        Self {
            modes,
            inverse,
            kappa,
            excitation,
            quadrature,
            displacement,
            start: reversal + mass,
            break_away: reversal + mass.times(chain.stiction),
        }
    }

    /// Makes the coefficients over an interval of r narrower, by means of the series `at` a point in the interval.
    /// `away` is the interval minus that point.
    pub fn refine(&mut self, at: &Self, away: Interval) {
        for (over, at) in self.excitation.iter_mut().zip(&at.excitation) {
            *over = over.refined(at, away);
        }
        self.quadrature = self.quadrature.refined(&at.quadrature, away);
        self.break_away = self.break_away.refined(&at.break_away, away);
        for (over, at) in self.modes.iter_mut().zip(&at.modes) {
            over.free = over.free.refined(&at.free, away);
            over.forced_slope = over.forced_slope.refined(&at.forced_slope, away);
        }
    }

    /// Returns the functions of the chain with −κ in place of κ. κ is the product of cosines by which all functions are
    /// multiplied.
    pub fn turned(mut self) -> Self {
        for mode in &mut self.modes {
            (mode.free, mode.forced_slope) = (-mode.free, -mode.forced_slope);
        }
        self.kappa = self.kappa.map(|kappa| -kappa);
        self.excitation = self.excitation.map(|part| -part);
        self.quadrature = -self.quadrature;
        self.displacement = -self.displacement;
        (self.start, self.break_away) = (-self.start, -self.break_away);
        self
    }

    /// Returns the functions of the chain with the first `M` terms of each series.
    pub fn truncated<const M: usize>(&self) -> ChainStage<M> {
        let modes = self.modes.iter().map(|mode| ModeStage {
            oscillator: mode.oscillator,
            x: mode.x.truncated(),
            slow: mode.slow.truncated(),
            free: mode.free.truncated(),
            forced_slope: mode.forced_slope.truncated(),
        });
        ChainStage {
            modes: modes.collect(),
            inverse: self.inverse.truncated(),
            kappa: self.kappa.map(|kappa| kappa.truncated()),
            excitation: self.excitation.map(|part| part.truncated()),
            quadrature: self.quadrature.truncated(),
            displacement: self.displacement.truncated(),
            start: self.start.truncated(),
            break_away: self.break_away.truncated(),
        }
    }
}

/// Returns 1 + g and u/x² from the damping functions g and u of a mode. The cosine cos(πx/2) of this mode must not be a
/// factor of κ.
fn functions<const N: usize>(
    mode: &IntervalMode,
    x: &IntervalSeries<N>,
    slow: &IntervalSeries<N>,
    (half_sine, half_cosine): (&IntervalSeries<N>, &IntervalSeries<N>),
) -> (IntervalSeries<N>, IntervalSeries<N>) {
    let one = IntervalSeries::fixed(Interval::ONE);
    let (two, four) = (Interval::point(2.0), Interval::point(4.0));
    let half = Interval::point(0.5);
    match mode.kind {
        ModeDecay::Undamped => (one, *half_sine / *half_cosine * *slow),
        ModeDecay::Under => {
            let e = x.times(-(Interval::pi() * mode.zeta)).exp();
            let (s, c) = x.times(mode.q * half).sine_cosine();
            let ec = e * c;
            // This form of the sum 1 + e² + 2e cos θ has no cancellation.
            let near = (one - e).squared() + (ec * c).times(four);
            let both = ec * s;
            let g = (one - e.squared() - both.times(four * mode.zeta_over_q)) / near;
            let u = (both / near * *slow).times(four / mode.q);
            (one + g, u)
        }
        ModeDecay::Critical => {
            let e = x.times(-Interval::pi()).exp();
            let near = (one + e).squared();
            let turned = e.times(two * Interval::pi());
            let g = (one - e.squared() - turned * *x) / near;
            (one + g, turned / near)
        }
        ModeDecay::Over => {
            let (slow_rate, fast_rate) = (Interval::ONE / mode.fast, mode.fast);
            let e_slow = x.times(-(Interval::pi() * slow_rate)).exp();
            let e_fast = x.times(-(Interval::pi() * fast_rate)).exp();
            let near = (one + e_slow) * (one + e_fast);
            let apart = e_slow - e_fast;
            let g = (one - e_slow * e_fast - apart.times(mode.zeta_over_q)) / near;
            let u = (apart / near * *slow).times(Interval::ONE / mode.q);
            (one + g, u)
        }
    }
}
