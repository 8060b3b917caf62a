//! Implements the kernel's closed-form response for a run-time system.

use super::few::Few;
use super::motion::{SystemMotion, SystemStuck};
use super::orbit::SystemOrbit;
use super::system::System;
use crate::system::FrictionSystem;
use crate::{NoOrbit, OutOfDomain};
use frictiongen_kernel::contact::regime::Limits;
use frictiongen_kernel::contact::sums::{ContactAt, ModeAt};
use frictiongen_kernel::modal_sum::wave::Wave;
use frictiongen_kernel::orbit::{ProvidesOrbit, Start};
use frictiongen_kernel::oscillator::decay::Damped;
use frictiongen_kernel::response::{
    At, Numbers, ProvidesMotion, ProvidesStuck, Scene, limits_of_sums,
};
use frictiongen_kernel::{Float, Plain};
use frictiongen_model::reduced::Reduced;
use std::ops::Deref;

/// A run-time system at one frequency ratio r. Its methods return the limits β_lim and β*_lim, and the regime and the
/// motions at a friction ratio β.
#[derive(Clone, Debug)]
pub struct SystemAt<'a, S: Float = f64>(At<&'a System<S>>);

impl<'a, S: Float> From<At<&'a System<S>>> for SystemAt<'a, S> {
    fn from(at: At<&'a System<S>>) -> Self {
        Self(at)
    }
}

impl<'a, S: Float> Deref for SystemAt<'a, S> {
    type Target = At<&'a System<S>>;

    fn deref(&self) -> &Self::Target {
        &self.0
    }
}

impl<S: Float> Scene for &System<S> {
    type Scalar = S;
    type Decay = Damped<S>;
    type Modes = Few<ModeAt<S>>;
    type Waves = Few<Wave<S, Damped<S>>>;

    fn numbers(&self) -> Numbers<'_, S> {
        self.reduced.numbers()
    }

    fn shape(&self, mass: usize) -> Option<&[S]> {
        Some(self.reduced.shape(mass)).filter(|shape| !shape.is_empty())
    }

    fn quadratures(&self) -> &[[S; 2]] {
        &self.reduced.quadratures
    }

    fn compliance(&self) -> Option<S> {
        self.reduced.compliance
    }

    fn frequency_stage(&self, inverse_r: S) -> (ContactAt<S>, Few<ModeAt<S>>) {
        let Reduced { chain, modes, .. } = &self.reduced;
        if !self.reduced.quadratures.is_empty() {
            let (contact, at) = (&self.reduced).frequency_stage(inverse_r);
            return (contact, Few::Many(at));
        }
        match modes.as_slice() {
            modes @ [_] => {
                let mut one = [ModeAt::zero(); 1];
                (
                    chain.contact(modes, inverse_r, into(&mut one)),
                    Few::One(one),
                )
            }
            modes @ [_, _] => {
                let mut two = [ModeAt::zero(); 2];
                (
                    chain.contact(modes, inverse_r, into(&mut two)),
                    Few::Two(two),
                )
            }
            modes => {
                let mut many = Vec::with_capacity(modes.len());
                let contact = chain.contact(modes, inverse_r, |mode| many.push(mode));
                (contact, Few::Many(many))
            }
        }
    }

    fn contact_without_g(&self, inverse_r: S) -> ContactAt<S> {
        (&self.reduced).contact_without_g(inverse_r)
    }

    #[inline]
    fn limits_without_search(&self, inverse_r: S) -> (Limits<S>, S) {
        match &self.driven {
            Some(modes) => {
                let chain = &self.reduced.chain;
                chain.limits_of_driven(modes, inverse_r, self.sliding_limit_is_one)
            }
            None => self.limits_of_sums(inverse_r),
        }
    }

    fn inverse_ratio_range(&self) -> (S, S) {
        self.range
    }

    fn sliding_limit(&self, contact: &ContactAt<S>) -> S {
        if self.sliding_limit_is_one {
            S::constant(1.0)
        } else {
            self.reduced.chain.sliding_limit(contact)
        }
    }

    fn idle(&self) -> Few<Wave<S, Damped<S>>> {
        match self.reduced.modes.as_slice() {
            [only] => Few::One([Wave::idle(only)]),
            [first, second] => Few::Two([first, second].map(Wave::idle)),
            modes => Few::Many(modes.iter().map(Wave::idle).collect()),
        }
    }
}

/// Returns a function that writes its argument to the next element of the slice `room` at each call.
fn into<T>(room: &mut [T]) -> impl FnMut(T) {
    let mut places = room.iter_mut();
    move |value| {
        if let Some(place) = places.next() {
            *place = value;
        }
    }
}

impl<'a, S: Float> ProvidesMotion for &'a System<S> {
    type Motion = SystemMotion<'a, S>;
}

impl<'a, S: Float> ProvidesStuck for &'a System<S> {
    type Stuck = SystemStuck<'a, S>;
}

impl<'a, S: Plain> ProvidesOrbit for &'a System<S> {
    type Orbit = SystemOrbit<'a, S>;
    type State = [S];

    fn settled(
        at: &At<Self>,
        beta: S,
        start: Start<'_, S>,
        last: bool,
    ) -> Result<SystemOrbit<'a, S>, NoOrbit> {
        let system = *at.scene();
        system.settled_from(
            at.frequency_ratio(),
            beta,
            start,
            (at.sliding_limit(), last),
        )
    }
}

impl<S: Float> System<S> {
    /// Returns an upper bound on β_lim, the limit β*_lim, and the real part of r²EH, without a search over the cycle.
    /// H is the receptance of the contact. E is the factor that keeps the sums of [`ContactAt`] finite at a resonance.
    /// Only damped chains and chains with many modes need this function.
    ///
    /// The compiler must not inline this function. Otherwise the caller is longer, and slower for an undamped chain
    /// with one mass.
    #[inline(never)]
    fn limits_of_sums(&self, inverse_r: S) -> (Limits<S>, S) {
        limits_of_sums(&self, inverse_r)
    }

    /// Returns the system evaluated at the frequency ratio r.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN and negative r. At r = 0 and r = ∞ the result contains limit values. [`OutOfDomain`]
    /// also for `friction: stribeck`, and for a scene with several contacts or dashpots. The exact continuous response
    /// needs one contact, with a kinetic friction force that does not depend on the speed.
    pub fn at(&self, r: S) -> Result<SystemAt<'_, S>, OutOfDomain> {
        self.constant_force()?;
        At::new(self, r).map(SystemAt::from)
    }
}

impl<S: Float> FrictionSystem for System<S> {
    type Scalar = S;
    type At<'a> = SystemAt<'a, S>;

    fn resonances(&self) -> &[S] {
        Self::resonances(self)
    }
    fn masses(&self) -> usize {
        self.scene.masses.len()
    }
    fn mass_name(&self, index: usize) -> Option<&str> {
        self.scene.masses.get(index).map(|mass| mass.name.as_str())
    }
    fn at(&self, r: S) -> Result<SystemAt<'_, S>, OutOfDomain> {
        Self::at(self, r)
    }
    fn limits_without_search(&self, r: S) -> Result<Limits<S>, OutOfDomain> {
        Self::limits_without_search(self, r)
    }
    fn limits_without_search_into(
        &self,
        rs: &[S],
        continuous: &mut [S],
        sliding: &mut [S],
    ) -> Result<(), OutOfDomain> {
        self.constant_force()?;
        At::limits_without_search_into(&self, rs, continuous, sliding)
    }
}
