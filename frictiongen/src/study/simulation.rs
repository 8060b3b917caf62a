//! Exact simulations in time of a run-time system, from event to event.

use super::error::UnknownMass;
use super::system::System;
use crate::{Given, OutOfDomain, Simulates, SimulatesUnder, Unsupported};
use frictiongen_kernel::motion::{AnyContact, Dynamics, Lines, Part};
use frictiongen_kernel::simulation::{Moment, Segment, Simulation};
use frictiongen_kernel::{Float, Plain};

/// An exact simulation in time of a system, from event to event. The simulation is an iterator over its segments. In a
/// segment the contact sticks, or slides in one direction.
#[derive(Clone, Debug)]
pub struct SystemSimulation<'a, S = f64> {
    pub(super) system: &'a System<S>,
    run: KernelSimulation<'a, S>,
    /// True if no load acts. A moving base is then at rest.
    pub(super) is_free: bool,
}

/// The kernel's simulation in time, with its data in vectors, for any friction law.
type KernelSimulation<'a, S> = Simulation<'a, S, Vec<Part<S>>, Lines<'a, S>, AnyContact<S>>;

impl<S: Plain> System<S> {
    pub(super) fn dynamics(&self) -> Dynamics<'_, S, AnyContact<S>> {
        self.transient().contact_dynamics()
    }

    /// Returns the modal data for a simulation in time. Fails if too many modes are at or beyond critical damping, and
    /// for several contacts or dashpots.
    pub(super) fn dynamics_in_time(&self) -> Result<Dynamics<'_, S, AnyContact<S>>, OutOfDomain> {
        self.single()?;
        if self.loses_motion() {
            return Err(Unsupported::CriticalDamping.into());
        }
        Ok(self.dynamics())
    }

    /// Returns the storage of a simulation: a list of oscillators at rest. The list has one oscillator for each mode
    /// of the chain, and one for each mode of the chain with its contact stuck.
    pub(super) fn parts(&self) -> Vec<Part<S>> {
        let dynamics = self.dynamics();
        vec![Part::empty(); dynamics.oscillators()]
    }

    /// Starts the exact motion in time from rest, at the frequency ratio r and the friction ratio β. The excitation
    /// starts at its maximum.
    ///
    /// ```
    /// use frictiongen::kernel::simulation::Event;
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let system: frictiongen::System = "struct Block {
    ///     masses: { block: 1 },
    ///     springs: { base - block: 1 },
    ///     contact: block - wall,
    ///     excitation: block,
    /// }"
    /// .parse()?;
    /// let mut run = system.simulation(0.3, 0.4)?;
    /// let stops = run.by_ref().take(100).filter(|segment| segment.event == Some(Event::Stop));
    /// assert!(stops.count() > 40);
    /// assert!(run.mass("block")?.displacement().abs() < 1.0);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`OutOfDomain`] unless r is positive and finite, and β is finite and not negative.
    /// [`Unsupported::FrictionLaw`](crate::Unsupported::FrictionLaw) for `friction: stribeck`, which needs
    /// [`simulation_under`](Self::simulation_under).
    /// [`Unsupported::CriticalDamping`](crate::Unsupported::CriticalDamping) if too many modes are at or beyond
    /// critical damping. Less than half of the digits would then remain.
    pub fn simulation(&self, r: S, beta: S) -> Result<SystemSimulation<'_, S>, OutOfDomain> {
        self.constant_force()?;
        self.started(r, beta, Lines::none(), None)
    }

    /// Starts the exact motion in time from a given state at a maximum of the excitation. `state` contains x̄ and
    /// dx̄/dτ of every mass.
    ///
    /// # Errors
    /// Same errors as [`simulation`](Self::simulation). [`OutOfDomain`] also if `state` does not have one finite
    /// displacement and one finite velocity for each mass.
    pub fn simulation_from(
        &self,
        r: S,
        beta: S,
        state: (&[S], &[S]),
    ) -> Result<SystemSimulation<'_, S>, OutOfDomain> {
        self.constant_force()?;
        self.started(r, beta, Lines::none(), Some(state))
    }

    /// Starts the exact motion in time from rest, under a load of the given amplitude. The amplitude is P of a force,
    /// or Y of a base motion, in the scene's units.
    ///
    /// The method needs the amplitude because the speeds of `friction: stribeck` have units. With a constant kinetic
    /// friction force, the motion does not depend on the amplitude. β is the kinetic friction force at zero speed,
    /// divided by P (by k₁Y for base motion).
    ///
    /// ```
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let block: frictiongen::System = "struct Block {
    ///     masses: { block: 2.0 },
    ///     springs: { base - block: 800.0 },
    ///     contact: block - wall,
    ///     excitation: block,
    ///     stiction: 1.2,
    ///     friction: stribeck(0.05: 0.7, 0.2: 0.6),
    ///     provide: [simulation],
    /// }"
    /// .parse()?;
    /// // A load of 10 N at 3 rad/s, and 4 N of friction.
    /// let mut run = block.simulation_under(block.frequency_ratio(3.0), 0.4, 10.0)?;
    /// for _ in 0..100 {
    ///     run.next();
    /// }
    /// assert!(run.mass("block")?.displacement().abs() < 1.0);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// Same errors as [`simulation`](Self::simulation), except for `friction: stribeck`. [`OutOfDomain::LoadAmplitude`]
    /// for an amplitude that is not positive and finite, or that takes the law's speeds out of the scalar's range.
    /// [`OutOfDomain::Steepness`] for a law that is too steep: it changes the motion more than
    /// [`MAX_STEEPNESS`](frictiongen_kernel::simulation::MAX_STEEPNESS) times as fast as the fastest mode does.
    pub fn simulation_under(
        &self,
        r: S,
        beta: S,
        amplitude: S,
    ) -> Result<SystemSimulation<'_, S>, OutOfDomain> {
        self.started(r, beta, self.lines(r, amplitude)?, None)
    }

    /// Starts the exact motion in time under a load from a given state at a maximum of the excitation. `state`
    /// contains x̄ and dx̄/dτ of every mass.
    ///
    /// # Errors
    /// Same errors as [`simulation_under`](Self::simulation_under). [`OutOfDomain`] also if `state` does not have one
    /// finite displacement and one finite velocity for each mass.
    pub fn simulation_under_from(
        &self,
        r: S,
        beta: S,
        amplitude: S,
        state: (&[S], &[S]),
    ) -> Result<SystemSimulation<'_, S>, OutOfDomain> {
        self.started(r, beta, self.lines(r, amplitude)?, Some(state))
    }

    /// Returns the friction law with non-dimensional sliding speeds. These speeds depend on r and on the amplitude of
    /// the load.
    fn lines(&self, r: S, amplitude: S) -> Result<Lines<'_, S>, OutOfDomain> {
        self.loaded()?;
        if S::constant(0.0) < amplitude && amplitude.is_finite() {
            Ok(self.steps().lines(r, amplitude))
        } else {
            Err(OutOfDomain::LoadAmplitude(Given::of(amplitude)))
        }
    }

    fn started<'a>(
        &'a self,
        r: S,
        beta: S,
        lines: Lines<'a, S>,
        state: Option<(&[S], &[S])>,
    ) -> Result<SystemSimulation<'a, S>, OutOfDomain> {
        if let Some(state) = state {
            self.check_state(state)?;
        }
        let dynamics = self.dynamics_in_time()?;
        let run = Simulation::along(dynamics, r, beta, lines, state, self.parts())?;
        Ok(SystemSimulation {
            system: self,
            run,
            is_free: false,
        })
    }

    /// Starts a free vibration at the unit of time √(m₁/k₁). Displacements have a unit of length, β that of F/k₁, and the
    /// velocities of `state` are derivatives with respect to the time in this unit. `speed` is the unit of velocity, in
    /// the scene's units.
    #[cfg(feature = "desk")]
    pub(super) fn simulation_without_load(
        &self,
        beta: S,
        speed: S,
        state: (&[S], &[S]),
    ) -> Result<SystemSimulation<'_, S>, OutOfDomain> {
        self.check_state(state)?;
        let (one, dynamics) = (S::constant(1.0), self.dynamics_in_time()?);
        let lines = Lines::under(&self.steps().law, one, one, speed);
        let run = Simulation::free(dynamics, (one, beta), lines, state, self.parts())?;
        Ok(SystemSimulation {
            system: self,
            run,
            is_free: true,
        })
    }

    pub(super) fn check_state(&self, (x, v): (&[S], &[S])) -> Result<(), OutOfDomain> {
        let masses = self.scene().masses.len();
        if x.len() == masses && v.len() == masses {
            Ok(())
        } else {
            Err(OutOfDomain::State)
        }
    }
}

impl<'a, S: Float> SystemSimulation<'a, S> {
    /// Returns the present displacement x̄ and velocity dx̄/dτ of the mass called `name`.
    ///
    /// # Errors
    /// [`UnknownMass`] if no mass has this name.
    pub fn mass(&self, name: &str) -> Result<Moment<S>, UnknownMass> {
        Ok(self.run.mass(self.system.mass_index(name)?))
    }

    /// Returns the kernel's simulation, whose methods return the phase, the number of cycles, the relative motion and
    /// the friction force.
    #[must_use]
    pub fn run(&self) -> &KernelSimulation<'a, S> {
        &self.run
    }

    /// Advances to the next event, or by the phase `reach` (in rad of τ = ωt) if no event comes earlier. A reach of 0
    /// changes nothing.
    ///
    /// # Errors
    /// [`OutOfDomain`] for a reach that is negative, infinite or NaN. The simulation is then unchanged.
    pub fn advance(&mut self, reach: S) -> Result<Segment<S>, OutOfDomain> {
        self.run.advance(reach)
    }
}

impl<S: Float> Iterator for SystemSimulation<'_, S> {
    type Item = Segment<S>;

    fn next(&mut self) -> Option<Segment<S>> {
        self.run.next()
    }
}

impl<'a, S> std::ops::Deref for SystemSimulation<'a, S> {
    type Target = KernelSimulation<'a, S>;

    fn deref(&self) -> &Self::Target {
        &self.run
    }
}

impl<S> std::ops::DerefMut for SystemSimulation<'_, S> {
    fn deref_mut(&mut self) -> &mut Self::Target {
        &mut self.run
    }
}

impl<S: Plain> SimulatesUnder for System<S> {
    type Scalar = S;
    type Run<'a> = SystemSimulation<'a, S>;

    fn simulation_under(
        &self,
        r: S,
        beta: S,
        amplitude: S,
    ) -> Result<SystemSimulation<'_, S>, OutOfDomain> {
        System::simulation_under(self, r, beta, amplitude)
    }
}

impl<S: Plain> Simulates for System<S> {
    type Run<'a> = SystemSimulation<'a, S>;

    fn simulation(&self, r: S, beta: S) -> Result<SystemSimulation<'_, S>, OutOfDomain> {
        System::simulation(self, r, beta)
    }
}
