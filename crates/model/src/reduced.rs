//! Modal data for the steady response, rounded to the scalar type of a solver. The data implement the kernel's trait
//! [`Scene`].

use crate::modal::Modal;
use frictiongen_kernel::Float;
use frictiongen_kernel::contact::sums::{Chain, ContactAt, ModeAt};
use frictiongen_kernel::modal_sum::wave::Wave;
use frictiongen_kernel::oscillator::decay::Damped;
use frictiongen_kernel::oscillator::mode::{Kind, Mode};
use frictiongen_kernel::response::{
    Continuous, Ends, Numbers, ProvidesMotion, ProvidesStuck, Scene, Stuck,
};

/// Constants for the steady response of a scene, in owned vectors. The kernel reads them as [`Numbers`].
#[derive(Clone, Debug)]
pub struct Reduced<S> {
    /// The modes that the load or the contact drives, in ascending order of resonance.
    pub modes: Vec<Mode<S>>,
    /// Mode shapes φ: for each mass in turn, its component in each mode of `modes`.
    pub shapes: Vec<S>,
    /// Loads in quadrature with the motion of the base, for each mode of `modes`. The list is empty unless damping acts
    /// on velocities relative to the moving base.
    pub quadratures: Vec<[S; 2]>,
    /// Constants of the whole chain, which belong to no single mode.
    pub chain: Chain<S>,
    /// Limiting values of β_lim and β*_lim at r = 0 and r = ∞.
    pub ends: Ends<S>,
    /// k₁/k, the non-dimensional compliance of an elastic contact with the stiffness k. `None` for a rigid contact.
    pub compliance: Option<S>,
    /// Index of the mass that slides on a support. `None` if two masses slide on each other.
    pub rubbing: Option<usize>,
    /// True if masses beyond the stuck contact may act as an absorber. An absorber is possible only in a chain without
    /// damping.
    pub absorbs: bool,
    /// Frequency ratios of the undamped resonances that the load drives. The response at these resonances may be
    /// unbounded.
    pub unbounded: Vec<S>,
    /// The frequency ratios of `unbounded` at which friction does not act on the resonant mode, because the contact
    /// does not move in this mode.
    pub invisible: Vec<S>,
    /// True if the sums over the modes process two modes at the same time. Optimised code is then faster, but code
    /// without optimisation is slower. The results are identical to the last bit.
    pub two_at_once: bool,
}

impl<S> Reduced<S> {
    /// Returns the component of a mass in each mode shape. The slice is empty if the mass does not exist.
    #[must_use]
    pub fn shape(&self, mass: usize) -> &[S] {
        let mut shapes = self.shapes.chunks_exact(self.modes.len().max(1));
        shapes.nth(mass).unwrap_or_default()
    }
}

impl<T: Float> Modal<T> {
    /// Returns the constants for the steady response in another number type. `to` rounds each number once from
    /// double-double.
    #[must_use]
    pub fn reduced<S>(&self, to: impl Fn(T) -> S) -> Reduced<S> {
        let zero = T::constant(0.0);
        let driven: Vec<usize> = (0..self.resonances.len())
            .filter(|i| {
                let nonzero = |of: &[T]| of.get(*i).is_some_and(|value| !value.vanishes());
                nonzero(&self.loads) || nonzero(&self.contacts) || nonzero(&self.participations)
            })
            .collect();
        let pick = |of: &[T], i: usize| of.get(i).copied().unwrap_or(zero);
        let modes = driven
            .iter()
            .map(|&i| {
                let resonance = pick(&self.resonances, i);
                let zeta = pick(&self.damping_ratios, i);
                let (load, contact) = (pick(&self.loads, i), pick(&self.contacts, i));
                mode(resonance, zeta, load, contact, &to)
            })
            .collect();
        let quadratures = if self.participations.is_empty() || !self.is_damped() {
            Vec::new()
        } else {
            let quadratures = driven.iter().map(|&i| self.quadrature(i, &to));
            quadratures.collect()
        };
        let masses = self.shapes.first().map_or(0, Vec::len);
        let component = |mass: usize, i: usize| {
            let shape = self.shapes.get(i);
            to(shape.map_or(zero, |shape| pick(shape, mass)))
        };
        let shapes = (0..masses)
            .flat_map(|mass| driven.iter().map(move |&i| (mass, i)))
            .map(|(mass, i)| component(mass, i))
            .collect();
        let chain = Chain {
            damped: self.is_damped(),
            on_moving_base: self.on_moving_base.then(|| to(self.static_motion)),
            inverse_mass: to(self.inverse_mass),
            stiction: to(self.stiction),
        };
        let ends = self.ends();
        Reduced {
            modes,
            shapes,
            quadratures,
            chain,
            ends: Ends {
                sliding_at_rest: to(ends.sliding_at_rest),
                continuous_at_infinity: to(ends.continuous_at_infinity),
                sliding_at_infinity: to(ends.sliding_at_infinity),
            },
            compliance: self.compliance.map(&to),
            rubbing: self.rubbing(),
            absorbs: self.has_absorber && !self.is_damped(),
            unbounded: self.unbounded(false).into_iter().map(&to).collect(),
            invisible: self.unbounded(true).into_iter().map(&to).collect(),
            two_at_once: true,
        }
    }
}

impl<T: Float> Modal<T> {
    /// Returns the load on one mode in quadrature with the motion of the base, in another number type. The two numbers
    /// have the meaning of the kernel's `Quadrature`. Both numbers are 0 unless damping acts on velocities relative to
    /// the moving base.
    #[must_use]
    pub fn quadrature<S>(&self, mode: usize, to: &impl Fn(T) -> S) -> [S; 2] {
        let pick = |of: &[T]| of.get(mode).copied().unwrap_or(T::constant(0.0));
        quadrature(
            (pick(&self.resonances), pick(&self.damping_ratios)),
            pick(&self.contacts),
            (pick(&self.participations), pick(&self.walls)),
            to,
        )
    }
}

/// Returns the load on one mode in quadrature with the motion of the base. The two numbers have the meaning of the
/// kernel's `Quadrature`. `to` rounds each number once.
pub(crate) fn quadrature<T: Float, S>(
    (resonance, zeta): (T, T),
    contact: T,
    (participation, wall): (T, T),
    to: &impl Fn(T) -> S,
) -> [S; 2] {
    let lambda = resonance * resonance;
    [
        to((zeta + zeta) * lambda * participation),
        to(-(contact * wall / lambda)),
    ]
}

/// Returns the constants of one mode in another number type. `to` rounds each number once.
pub(crate) fn mode<T: Float, S>(
    resonance: T,
    zeta: T,
    load: T,
    contact: T,
    to: &impl Fn(T) -> S,
) -> Mode<S> {
    let one = T::constant(1.0);
    let q = ((one - zeta) * (one + zeta)).abs().sqrt();
    Mode {
        kind: kind(zeta),
        in_contact: !contact.vanishes(),
        resonance: to(resonance),
        zeta: to(zeta),
        q: to(q),
        q_defect: to(zeta * zeta / (one + q)),
        load: to(load),
        contact: to(contact),
        residue: to(contact * load),
        contact_squared: to(contact * contact),
        static_residue: to(contact * load / (resonance * resonance)),
    }
}

pub(crate) fn kind<T: Float>(zeta: T) -> Kind {
    if zeta.vanishes() {
        return Kind::Undamped;
    }
    // The rounded ζ decides whether the mode is undamped, underdamped or overdamped, because the emitted closed form
    // uses the rounded ζ.
    let zeta = zeta.to_f64();
    if zeta < 0.5 {
        Kind::Light
    } else if zeta < 1.0 {
        Kind::Heavy
    } else if zeta == 1.0 {
        Kind::Critical
    } else {
        Kind::Over
    }
}

impl<S: Float> Reduced<S> {
    /// Returns the constants as [`Numbers`] of the kernel crate.
    #[must_use]
    pub fn numbers(&self) -> Numbers<'_, S> {
        Numbers {
            modes: &self.modes,
            chain: self.chain,
            ends: self.ends,
            rubbing: self.rubbing,
            absorbs: self.absorbs,
            unbounded: &self.unbounded,
            invisible: &self.invisible,
        }
    }
}

impl<S: Float> Scene for &Reduced<S> {
    type Scalar = S;
    type Decay = Damped<S>;
    type Modes = Vec<ModeAt<S>>;
    type Waves = Vec<Wave<S, Damped<S>>>;

    fn numbers(&self) -> Numbers<'_, S> {
        Reduced::numbers(self)
    }

    fn shape(&self, mass: usize) -> Option<&[S]> {
        Some(Reduced::shape(self, mass)).filter(|shape| !shape.is_empty())
    }

    fn quadratures(&self) -> &[[S; 2]] {
        &self.quadratures
    }

    fn compliance(&self) -> Option<S> {
        self.compliance
    }

    fn frequency_stage(&self, inverse_r: S) -> (ContactAt<S>, Vec<ModeAt<S>>) {
        let mut at = Vec::with_capacity(self.modes.len());
        let keep = |mode| at.push(mode);
        let contact = if !self.quadratures.is_empty() {
            let modes = (&*self.modes, &*self.quadratures);
            self.chain.loaded_in_turn::<true>(modes, inverse_r, keep)
        } else if self.two_at_once {
            self.chain.contact(&self.modes, inverse_r, keep)
        } else {
            self.chain.in_turn::<true>(&self.modes, inverse_r, keep)
        };
        (contact, at)
    }

    fn contact_without_g(&self, inverse_r: S) -> ContactAt<S> {
        if self.quadratures.is_empty() {
            return self.chain.contact_without_g(&self.modes, inverse_r);
        }
        let modes = (&*self.modes, &*self.quadratures);
        self.chain.loaded_in_turn::<false>(modes, inverse_r, |_| ())
    }

    fn idle(&self) -> Vec<Wave<S, Damped<S>>> {
        self.modes.iter().map(Wave::idle).collect()
    }
}

impl<S: Float> ProvidesMotion for &Reduced<S> {
    type Motion = Continuous<Self>;
}

impl<S: Float> ProvidesStuck for &Reduced<S> {
    type Stuck = Stuck<Self>;
}
