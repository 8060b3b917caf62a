//! Steady states of a chain with several contacts at one frequency, and its stuck state. All results are
//! non-dimensional groups.
//!
//! Displacements are divided by P/k₁ (by Y for base motion, where Y is the amplitude of the base). Forces are divided
//! by P (by k₁Y), and energies by P²/k₁ (by k₁Y²).

use super::cycle::ContactCycle;
use super::model::Model;
use super::run::Motion;
use super::simulation::{Reference, StartState};
use super::size::{Size, at};
use super::steady::{Search, Steady};
use super::stuck::StuckResponse;
use super::waveform::{Replay, Waveform};
use crate::errors::{Halt, NoOrbit, OutOfDomain, Regime, StuckResonance};
use crate::number::complex::Complex;
use crate::{Float, Scalar};

/// A chain with several contacts at one frequency.
#[derive(Clone, Debug)]
pub struct At<S: Float, Z: Size> {
    /// Constants of the chain. The level (kinetic friction force) of each contact is the contact's fraction of the
    /// common friction force.
    model: Model<S, Z>,
    reference: Reference<S>,
    r: S,
    contacts: &'static [&'static str],
}

impl<S: Float, Z: Size> At<S, Z> {
    /// Evaluates a chain at the frequency ratio r. In `model`, the level (kinetic friction force) of each contact is
    /// the contact's fraction of the common friction force. `contacts` contains the names of the contacts.
    ///
    /// # Errors
    ///
    /// [`OutOfDomain`] if r is not positive and finite.
    pub fn new(
        model: Model<S, Z>,
        reference: Reference<S>,
        r: S,
        contacts: &'static [&'static str],
    ) -> Result<Self, OutOfDomain> {
        reference.omega(r)?;
        Ok(Self {
            model,
            reference,
            r,
            contacts,
        })
    }

    /// Returns the frequency ratio r at which the chain is evaluated.
    pub fn r(&self) -> S {
        self.r
    }

    /// Returns the state in which no contact slides, from a closed form. In this state no contact has a constant force
    /// from an earlier motion.
    ///
    /// # Errors
    ///
    /// [`StuckResonance`] if r is an undamped resonance of the chain with its contacts stuck.
    pub fn stuck(&self) -> Result<StuckState<S, Z>, StuckResonance> {
        let omega = self.r * self.reference.rate;
        let mut model = self.model.clone();
        self.reference.load(&mut model, omega, S::constant(1.0));
        let response = model.stuck(omega).ok_or(StuckResonance)?;
        Ok(StuckState {
            response,
            stiffness: self.reference.stiffness,
            contacts: self.contacts,
        })
    }

    /// Returns a steady state at the common friction ratio β. From a given state it is the one that the motion from
    /// there reaches. Without a state it is the one that the motion from rest reaches, except that a contact that never
    /// slides is in the middle of the interval in which it can stick.
    ///
    /// # Errors
    ///
    /// [`NoOrbit::OutOfDomain`] if β is negative or not finite, if the given state is not finite, or, with its cause,
    /// if the motion exceeds a bound. [`NoOrbit::Unsettled`] if the motion does not settle.
    pub fn orbit(&self, beta: S, state: Option<StartState<'_, S>>) -> Result<Orbit<S, Z>, NoOrbit> {
        let model = self.model.clone();
        let start = self.reference.start(model, (self.r, beta), state);
        let (mut motion, omega) = start.map_err(NoOrbit::OutOfDomain)?;
        let halted = |halt| NoOrbit::OutOfDomain(OutOfDomain::Motion(halt));
        let steady = match state {
            None => motion.settle(omega, None),
            Some(_) => motion.settle_from(omega),
        };
        let steady = steady.map_err(halted)?;
        let steady = steady.ok_or(NoOrbit::Unsettled)?;
        motion.restart(steady.state.clone());
        let is_symmetric = steady.is_symmetric(motion.clone(), omega);
        Ok(Orbit {
            steady,
            motion,
            is_symmetric: is_symmetric.map_err(halted)?,
            omega,
            stiffness: self.reference.stiffness,
        })
    }
}

impl<S: Float, Z: Size> Steady<S, Z> {
    /// Returns true if the motion repeats with the opposite sign after half a period. `motion` is any motion of the
    /// chain, whose state the function replaces.
    ///
    /// # Errors
    ///
    /// [`Halt`] if the motion exceeds a bound.
    pub fn is_symmetric(&self, mut motion: Motion<S, Z>, omega: S) -> Result<bool, Halt> {
        if self.period.is_multiple_of(2) {
            return Ok(false);
        }
        motion.restart(self.state.clone());
        let mut search = Search::by_tables(&motion, omega, S::constant(1.0));
        search.advance(&mut motion, self.period / 2, &mut ())?;
        search.advance_half(&mut motion, &mut ())?;
        let sizes = self.cycle.amplitudes.as_ref().iter().copied();
        let size = sizes.fold(S::constant(f64::from(f32::MIN_POSITIVE)), Scalar::max);
        let small = S::constant(if S::EPSILON < 1e-10 { 1e-7 } else { 1e-3 });
        let opposite = |a: &[S], b: &[S], size: S| {
            let mut pairs = a.iter().zip(b);
            pairs.all(|(a, b)| (*a + *b).abs() <= small * size)
        };
        let end = motion.state();
        let speeds = opposite(self.state.v.as_ref(), end.v.as_ref(), size * omega);
        // If a part of the chain can move without a force, its position is arbitrary, and the code does not compare
        // positions.
        let places = self.neutral > 0 || opposite(self.state.x.as_ref(), end.x.as_ref(), size);
        Ok(speeds && places)
    }
}

/// State of a chain with several contacts in which no contact slides.
#[derive(Clone, Debug)]
pub struct StuckState<S: Float, Z: Size> {
    response: StuckResponse<S, Z>,
    stiffness: S,
    contacts: &'static [&'static str],
}

impl<S: Float, Z: Size> StuckState<S, Z> {
    /// Returns X, the complex amplitude of a mass. The motion of the mass is x̄ = Re X exp(iτ), where τ = ωt is the
    /// phase of the load. The unit is P/k₁ (the base amplitude Y for base motion).
    pub fn mass(&self, mass: usize) -> Complex<S> {
        let zero = S::constant(0.0);
        let found = self.response.displacements.as_ref().get(mass).copied();
        found.unwrap_or(Complex::new(zero, zero))
    }

    /// Returns the amplitude of the force in a contact, in units of P (of k₁Y for a base amplitude Y).
    pub fn contact(&self, contact: usize) -> S {
        at(self.response.forces.as_ref(), contact) / self.stiffness
    }

    /// Returns β*_lim, the smallest common friction ratio at which no contact slides. It is the largest value of
    /// |f|/(μ·share) of all contacts. |f| is the force amplitude of a contact, in units of P (of k₁Y for base motion).
    /// `share` is the contact's fraction of the common friction force.
    pub fn limit(&self) -> S {
        let limit = self.response.limit;
        limit.map_or(S::constant(0.0), |(limit, _)| limit)
    }

    /// Returns the name of the contact that slides first if the friction ratio falls below β*_lim. The name is empty if
    /// the scene has no contact.
    pub fn first(&self) -> &'static str {
        let first = self.response.limit.map_or(0, |(_, first)| first);
        self.contacts.get(first).copied().unwrap_or_default()
    }
}

/// A steady state of a chain with several contacts.
#[derive(Clone, Debug)]
pub struct Orbit<S: Float, Z: Size> {
    steady: Steady<S, Z>,
    /// The motion at the start of a period.
    motion: Motion<S, Z>,
    is_symmetric: bool,
    omega: S,
    stiffness: S,
}

impl<S: Float, Z: Size> Orbit<S, Z> {
    /// Returns the period of the steady state in cycles of the load. It is at most [`MAX_PERIOD`](super::MAX_PERIOD).
    pub fn period(&self) -> usize {
        self.steady.period
    }

    /// Returns the Floquet multipliers of a period, in the order of decreasing absolute value. The list does not
    /// contain the multipliers 1 of marginal directions (directions in which a deviation from the steady state does not
    /// decay).
    pub fn multipliers(&self) -> &[Complex<S>] {
        self.steady.multipliers()
    }

    /// Returns true if every small deviation from the steady state decays, except along marginal directions. A
    /// deviation along a marginal direction does not decay.
    pub fn is_stable(&self) -> bool {
        self.steady.is_stable()
    }

    /// Returns true if the steady motion repeats with the opposite sign after half a period.
    pub fn is_symmetric(&self) -> bool {
        self.is_symmetric
    }

    /// Returns true if the steady state depends on the initial state. This is the case if a contact never slides and
    /// keeps its position. It is also the case if a part of the chain has no path of springs to a support.
    pub fn is_marginal(&self) -> bool {
        self.steady.neutral > 0 || self.steady.marginal.as_ref().contains(&true)
    }

    /// Returns the number of marginal directions (directions in which a deviation does not decay) that belong to parts
    /// of the chain without a path of springs to a support. These directions are displacements and constant velocities
    /// of the parts.
    pub fn free_directions(&self) -> usize {
        self.steady.neutral
    }

    /// Returns the largest difference between the states at the start and at the end of a period, divided by the size
    /// of the state.
    pub fn residual(&self) -> S {
        self.steady.residual
    }

    /// Returns the regime of the steady state. It is *stuck* if no contact slides, and *continuous* if all contacts
    /// slide all the time. In every other case it is *stick-slip*.
    pub fn regime(&self) -> Regime {
        self.steady.cycle.regime()
    }

    /// Returns the motion of a mass in a period of the steady state.
    pub fn mass(&self, mass: usize) -> MassOrbit<'_, S, Z> {
        let Steady { cycle, state, .. } = &self.steady;
        let (largest, centred) = (
            at(cycle.amplitudes.as_ref(), mass),
            at(cycle.centred.as_ref(), mass),
        );
        MassOrbit {
            amplitude: if self.steady.neutral == 0 {
                largest
            } else {
                centred
            },
            centred,
            displacement: at(state.x.as_ref(), mass),
            velocity: at(state.v.as_ref(), mass) / self.omega,
            motion: self.waveform((mass, self.motion.model().wall())),
        }
    }

    /// Returns the course of the displacement of a node minus that of another node.
    fn waveform(&self, nodes: (usize, usize)) -> Waveform<S, Replay<'_, S, Z>> {
        let replay = Replay {
            motion: &self.motion,
            omega: self.omega,
            cycles: self.steady.period,
            nodes,
        };
        Waveform::new(replay, self.omega, self.steady.period)
    }

    /// Returns the motion of a contact in a period of the steady state.
    pub fn contact(&self, contact: usize) -> ContactOrbit<'_, S, Z> {
        let found = self.steady.cycle.contacts.as_ref().get(contact).copied();
        let wall = self.motion.model().wall();
        let own = self.motion.model().contact(contact);
        let nodes = own.map_or((wall, wall), |own| (own.plus, own.minus));
        ContactOrbit {
            cycle: found.unwrap_or(ContactCycle::nothing()),
            is_marginal: self.steady.marginal.as_ref().get(contact) == Some(&true),
            unit: self.stiffness,
            motion: self.waveform(nodes),
        }
    }
}

/// Motion of a mass in a period of a steady state.
#[derive(Clone, Copy, Debug)]
pub struct MassOrbit<'o, S: Float, Z: Size> {
    motion: Waveform<S, Replay<'o, S, Z>>,
    amplitude: S,
    centred: S,
    displacement: S,
    velocity: S,
}

impl<'o, S: Float, Z: Size> MassOrbit<'o, S, Z> {
    /// Returns the course of the displacement x̄ over the period, in units of P/k₁ (of the base amplitude Y for base
    /// motion): phase, harmonics, and values at any phase. Each of its methods follows the motion over the period once or
    /// twice.
    pub fn motion(self) -> Waveform<S, Replay<'o, S, Z>> {
        self.motion
    }

    /// Returns the amplitude of the mass: its largest |x̄| in the period, in units of P/k₁ (of the base amplitude Y for
    /// base motion). If a part of the chain has no path of springs to a support, the result is the centred amplitude
    /// (max x̄ − min x̄)/2 about the mean motion.
    pub fn amplitude(&self) -> S {
        self.amplitude
    }

    /// Returns the centred amplitude (max x̄ − min x̄)/2 of the mass, in units of P/k₁ (of the base amplitude Y for
    /// base motion).
    pub fn centred_amplitude(&self) -> S {
        self.centred
    }

    /// Returns the displacement x̄ and the velocity dx̄/dτ of the mass at a maximum of the load, with τ = ωt.
    pub fn state(&self) -> (S, S) {
        (self.displacement, self.velocity)
    }
}

/// Motion of a contact in a period of a steady state.
#[derive(Clone, Copy, Debug)]
pub struct ContactOrbit<'o, S: Float, Z: Size> {
    motion: Waveform<S, Replay<'o, S, Z>>,
    cycle: ContactCycle<S>,
    is_marginal: bool,
    /// Unit of the contact's force in the results.
    unit: S,
}

impl<'o, S: Float, Z: Size> ContactOrbit<'o, S, Z> {
    /// Returns the course of the relative displacement over the period, in units of P/k₁ (of the base amplitude Y for base
    /// motion): phase, harmonics, and values at any phase. Each of its methods follows the motion over the period once or
    /// twice. The displacement counts as positive in the direction of the later mass, or of the mass if the other side is a
    /// support.
    pub fn motion(self) -> Waveform<S, Replay<'o, S, Z>> {
        self.motion
    }

    /// Returns the number of stops of the contact in a period.
    pub fn stops(&self) -> usize {
        self.cycle.stops
    }

    /// Returns the number of reversals of the contact in a period. A reversal is a change of the sliding direction
    /// without a stop.
    pub fn reversals(&self) -> usize {
        self.cycle.reversals
    }

    /// Returns the fraction of the period during which the contact sticks. An elastic contact that sticks moves with
    /// its spring.
    pub fn stuck_fraction(&self) -> S {
        self.cycle.stuck_fraction
    }

    /// Returns the distance that the contact slides in a period, added over both directions. The unit is P/k₁ (the
    /// base amplitude Y for base motion).
    pub fn slip(&self) -> S {
        self.cycle.slip
    }

    /// Returns the largest absolute relative displacement of the contact's two sides in a period, in units of P/k₁ (of
    /// the base amplitude Y for base motion).
    pub fn displacement(&self) -> S {
        self.cycle.displacement
    }

    /// Returns the largest absolute force of the contact in a period, in units of P (of k₁Y for a base amplitude Y).
    pub fn force(&self) -> S {
        self.cycle.force / self.unit
    }

    /// Returns the energy that friction dissipates in the contact in a period, in units of P²/k₁ (of k₁Y² for a base
    /// amplitude Y).
    pub fn energy(&self) -> S {
        self.cycle.energy / self.unit
    }

    /// Returns the regime of this contact: continuous, stick-slip or stuck.
    pub fn regime(&self) -> Regime {
        self.cycle.regime()
    }

    /// Returns true if the contact never slides in the period. The contact then keeps the force or the position that
    /// the earlier motion has left.
    pub fn is_marginal(&self) -> bool {
        self.is_marginal
    }
}
