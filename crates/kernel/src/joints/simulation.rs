//! Exact motion of a chain with several contacts as a function of time, under a harmonic load.

use super::model::Model;
use super::now::{ContactState, MassState};
use super::run::{Bounds, Motion};
use super::size::Size;
use super::slid::Count;
use super::wave::Wave;
use crate::Float;
use crate::errors::{Given, OutOfDomain};

/// Largest number of events in one call of [`Simulation::advance`].
pub const MAX_EVENTS: usize = 100_000;
/// Largest number of stretches (time intervals of one power series) in one call of [`Simulation::advance`].
pub const MAX_STRETCHES: usize = 10_000_000;

/// Reference quantities that convert non-dimensional groups to the physical units of a chain, and the kind of
/// excitation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reference<S> {
    /// Reference angular frequency √(k₁/m₁), in rad per unit of time. The excitation has this frequency at r = 1.
    pub rate: S,
    /// Stiffness k₁ of the first spring, in the units of the scene description.
    pub stiffness: S,
    /// True if the base moves and excites the chain. If false, the first load excites the chain.
    pub on_base: bool,
}

impl<S: Float> Reference<S> {
    /// Returns the angular frequency ω of the excitation at the frequency ratio r.
    ///
    /// # Errors
    ///
    /// [`OutOfDomain`] if r is not positive and finite.
    pub(super) fn omega(&self, r: S) -> Result<S, OutOfDomain> {
        if r > S::constant(0.0) && r.is_finite() && (S::constant(1.0) / r).is_finite() {
            Ok(r * self.rate)
        } else {
            Err(OutOfDomain::FrequencyRatioInTime(Given::of(r)))
        }
    }

    /// Sets the load and the friction forces of a chain for the friction ratio β. The load gets the amplitude for
    /// which P/k₁ (for base motion, Y) is 1. Before the call, the level (kinetic friction force) of each contact in
    /// `model` is the contact's fraction of the common friction force.
    pub(super) fn load<Z: Size>(&self, model: &mut Model<S, Z>, omega: S, beta: S) {
        if self.on_base {
            model.base = Wave::harmonic(S::constant(1.0), omega).into();
        } else if let Some((_, load)) = model.loads.as_mut().first_mut() {
            *load = Wave::harmonic(self.stiffness, omega);
        }
        for contact in model.contacts.as_mut() {
            contact.level = Wave::constant(beta * self.stiffness * contact.level.constant);
        }
        model.set_stretch();
    }

    /// Divides all lengths and speeds of the chain, and the constant forces, by the unit of displacement. The unit is P/k₁,
    /// or for base motion the amplitude Y of the base.
    fn scale_lengths<Z: Size>(
        &self,
        model: &mut Model<S, Z>,
        amplitude: S,
    ) -> Result<(), OutOfDomain> {
        let length = if self.on_base {
            amplitude
        } else {
            amplitude / self.stiffness
        };
        let mut before = S::constant(0.0);
        let mut is_sound = length > before && length.is_finite();
        for [speed, _] in model.law.as_mut() {
            *speed = *speed / length;
            is_sound &= *speed > before && speed.is_finite();
            before = *speed;
        }
        if Z::HAS_PARTS {
            for contact in model.contacts.as_mut() {
                contact.speed = contact.speed / length;
                is_sound &= contact.speed.is_finite();
                if let Some(stop) = &mut contact.stop {
                    stop.gap = stop.gap / length;
                    is_sound &= stop.gap.is_finite();
                }
            }
            let loads = model.loads.as_mut().iter_mut().map(|(_, load)| load);
            for load in loads.filter(|load| load.is_constant_load()) {
                load.amplitude = load.amplitude / length;
                is_sound &= load.amplitude.is_finite();
            }
        }
        if is_sound {
            Ok(())
        } else {
            Err(OutOfDomain::LoadAmplitude(Given::of(amplitude)))
        }
    }

    /// Starts a motion at a maximum of the load. Returns the motion and the angular frequency of the load.
    ///
    /// # Errors
    ///
    /// The errors of [`Simulation::new`].
    pub(super) fn start<Z: Size>(
        &self,
        mut model: Model<S, Z>,
        (r, beta): (S, S),
        state: Option<StartState<'_, S>>,
    ) -> Result<(Motion<S, Z>, S), OutOfDomain> {
        let zero = S::constant(0.0);
        let omega = self.omega(r)?;
        if !(beta >= zero && beta.is_finite()) {
            return Err(OutOfDomain::FrictionRatio(Given::of(beta)));
        }
        self.load(&mut model, omega, beta);
        let (mut x, mut v) = (model.size.masses(zero), model.size.masses(zero));
        if let Some((places, speeds)) = state {
            let mut numbers = places.iter().chain(speeds);
            if !numbers.all(|number| number.is_finite()) {
                return Err(OutOfDomain::State);
            }
            for (x, place) in x.as_mut().iter_mut().zip(places) {
                *x = *place;
            }
            for (v, speed) in v.as_mut().iter_mut().zip(speeds) {
                *v = omega * *speed;
            }
        }
        let motion = Motion::new(model, x.as_ref(), v.as_ref());
        Ok((motion.map_err(OutOfDomain::Motion)?, omega))
    }
}

/// Motion of a chain with several contacts as a function of time, in non-dimensional groups. Displacements are divided
/// by P/k₁, or for base motion by the amplitude Y of the base. Velocities are derivatives with respect to τ = ωt.
/// Forces are divided by P (by k₁Y for base motion).
#[derive(Clone, Debug)]
pub struct Simulation<S: Float, Z: Size> {
    motion: Motion<S, Z>,
    omega: S,
    stiffness: S,
}

/// Initial state of a motion. The first slice contains the displacements of all masses, and the second their
/// velocities.
pub(super) type StartState<'s, S> = (&'s [S], &'s [S]);

impl<S: Float, Z: Size> Simulation<S, Z> {
    /// Starts a motion at a maximum of the load, from rest or from a given state. `ratios` contains the frequency
    /// ratio r and the friction ratio β. In `model`, the level (kinetic friction force) of each contact is the
    /// contact's fraction of the common friction force.
    ///
    /// # Errors
    ///
    /// [`OutOfDomain`] if r is not positive and finite, if β is negative or not finite, or if the given state is not
    /// finite.
    pub fn new(
        model: Model<S, Z>,
        reference: Reference<S>,
        ratios: (S, S),
        state: Option<StartState<'_, S>>,
    ) -> Result<Self, OutOfDomain> {
        let (motion, omega) = reference.start(model, ratios, state)?;
        Ok(Self {
            motion,
            omega,
            stiffness: reference.stiffness,
        })
    }

    /// Starts a motion as [`new`](Self::new) does, under a load of the given amplitude in the units of the scene. The
    /// speeds of the friction law have these units.
    ///
    /// # Errors
    ///
    /// The errors of [`new`](Self::new). [`OutOfDomain::LoadAmplitude`] if the amplitude is not positive and finite,
    /// or if the speeds of the law are not positive, ascending and finite after the division by the unit of
    /// displacement.
    pub fn under(
        mut model: Model<S, Z>,
        reference: Reference<S>,
        (r, beta, amplitude): (S, S, S),
        state: Option<StartState<'_, S>>,
    ) -> Result<Self, OutOfDomain> {
        reference.scale_lengths(&mut model, amplitude)?;
        Self::new(model, reference, (r, beta), state)
    }

    /// Advances the motion until the phase τ = ωt of the load has grown by `reach`, in rad. Returns the number of
    /// events during this time.
    ///
    /// # Errors
    ///
    /// [`OutOfDomain`] if `reach` is negative or not finite. [`OutOfDomain::Motion`] with its cause, if the motion
    /// exceeds a bound. The motion then stays at the instant that it has reached.
    pub fn advance(&mut self, reach: S) -> Result<u32, OutOfDomain> {
        if !(reach >= S::constant(0.0) && reach.is_finite()) {
            return Err(OutOfDomain::Duration(Given::of(reach)));
        }
        let until = self.motion.time() + reach / self.omega;
        let bounds = Bounds {
            events: MAX_EVENTS,
            stretches: MAX_STRETCHES,
        };
        let mut count = Count(0);
        let run = self.motion.run(until, bounds, &mut count);
        run.map_err(OutOfDomain::Motion)?;
        Ok(count.0)
    }

    /// Returns the phase τ = ωt of the load since the start of the motion, in rad.
    pub fn tau(&self) -> S {
        self.omega * self.motion.time()
    }

    /// Returns the present displacement and velocity of a mass.
    pub fn mass(&self, mass: usize) -> MassState<S> {
        let MassState {
            displacement,
            velocity,
        } = self.motion.mass(mass);
        MassState {
            displacement,
            velocity: velocity / self.omega,
        }
    }

    /// Returns the present motion and force of a contact.
    pub fn contact(&self, contact: usize) -> ContactState<S> {
        let now = self.motion.contact(contact);
        ContactState {
            velocity: now.velocity / self.omega,
            force: now.force / self.stiffness,
            ..now
        }
    }
}
