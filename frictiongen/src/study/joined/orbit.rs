//! Steady states of scenes with several contacts.

use super::error::{JoinedError, UnknownContact};
use super::scene::Joined;
use super::units::AnswerUnits;
use super::waveform::{Course, Waveform};
use crate::study::error::UnknownMass;
use crate::study::joints::{Approach, Chain, ContactCycle, Motion, Steady};
use crate::study::response::MotionQuantity;
use crate::study::words;
use crate::{Complex, Of, Regime};

/// A steady state of a scene with several contacts.
///
/// Displacements, forces and energies are in the units of [`JoinedAt::units`](super::JoinedAt::units).
#[derive(Clone, Debug)]
pub struct JoinedOrbit<'a> {
    joined: Joined<'a>,
    chain: Chain,
    omega: f64,
    units: AnswerUnits,
    steady: Steady,
    found: FoundBy,
}

/// How a search has found a steady state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FoundBy {
    /// By the motion from rest, or from the initial state of the system.
    Rest,
    /// By the motion from the state in which no contact slides, or from a multiple of it.
    Stuck,
    /// By the motion from the response without friction, or from a multiple of it.
    Linear,
    /// By the motion from one of several states that are spread over all directions.
    Spread,
    /// By Newton's method. The state may be unstable.
    Newton,
    /// As the mirror image of an asymmetric state.
    Mirror,
}

/// Motion of one contact over the period of a steady state with several contacts.
#[derive(Clone, Copy, Debug)]
pub struct ContactOrbit<'o> {
    orbit: &'o JoinedOrbit<'o>,
    index: usize,
    cycle: &'o ContactCycle,
    units: AnswerUnits,
}

impl ContactOrbit<'_> {
    /// Returns the number of stops of the contact in a period.
    #[must_use]
    pub fn stops(&self) -> usize {
        self.cycle.stops
    }

    /// Returns the number of reversals of the contact in a period. A reversal is a change of the sliding direction
    /// without a stop.
    #[must_use]
    pub fn reversals(&self) -> usize {
        self.cycle.reversals
    }

    /// Returns the fraction of the period during which the contact sticks. An elastic contact moves with its spring
    /// while it sticks.
    #[must_use]
    pub fn stuck_fraction(&self) -> f64 {
        self.cycle.stuck_fraction
    }

    /// Returns the distance that the slider of the contact travels in a period, added over both directions.
    #[must_use]
    pub fn slip(&self) -> f64 {
        self.cycle.slip / self.units.length
    }

    /// Returns the largest absolute relative displacement of the contact's two sides in a period.
    #[must_use]
    pub fn displacement(&self) -> f64 {
        self.cycle.displacement / self.units.length
    }

    /// Returns the largest absolute force in the contact in a period.
    #[must_use]
    pub fn force(&self) -> f64 {
        self.cycle.force / self.units.force
    }

    /// Returns the energy that the friction of the contact dissipates in a period.
    #[must_use]
    pub fn energy(&self) -> f64 {
        self.cycle.energy / self.units.energy()
    }

    /// Returns the course of the relative displacement over a period: its phase, its harmonics and its value at any
    /// phase.
    ///
    /// # Errors
    /// [`JoinedError::Engine`] if the solver does not support the chain.
    pub fn motion(&self) -> Result<Waveform, JoinedError> {
        let course = Course::of_contact(&self.orbit.joined, self.index);
        self.orbit.waveform(course)
    }

    /// Returns the regime of this contact: continuous, stick-slip or stuck.
    #[must_use]
    pub fn regime(&self) -> Regime {
        self.cycle.regime()
    }

    /// Returns true for a stop of the scene. [`stops`](Self::stops) is then the number of times that it shuts, and
    /// [`stuck_fraction`](Self::stuck_fraction) the fraction of the period during which it is shut.
    #[must_use]
    pub fn is_of_stop(&self) -> bool {
        self.cycle.is_stop
    }

    /// Returns the word for the regime in a table.
    pub(in crate::study) fn word(&self) -> &'static str {
        match self.is_of_stop() {
            true if self.cycle.stops > 0 => "impacts",
            true if self.cycle.stuck_fraction > 0.0 => "shut",
            true => "open",
            false => words::regime(self.regime()),
        }
    }
}

impl<'a> JoinedOrbit<'a> {
    pub(super) fn new(
        joined: Joined<'a>,
        chain: Chain,
        (omega, units): (f64, AnswerUnits),
        steady: Steady,
    ) -> Self {
        Self {
            joined,
            chain,
            omega,
            units,
            steady,
            found: FoundBy::Rest,
        }
    }

    /// Sets how the search has found this state.
    pub(super) fn with_found(self, found: FoundBy) -> Self {
        Self { found, ..self }
    }

    /// Returns how the search has found this state.
    #[must_use]
    pub fn found_by(&self) -> FoundBy {
        self.found
    }

    /// Returns true if the motion from rest, or from the initial state, ends in this state. If the result is false, that
    /// motion does not settle, and this state is another steady state or contains the last cycles of the motion.
    #[must_use]
    pub fn is_from_rest(&self) -> bool {
        self.steady.approach == Approach::Reached
    }

    /// Returns false if this state contains the last 64 cycles of a motion that does not settle.
    #[must_use]
    pub fn is_settled(&self) -> bool {
        !matches!(self.steady.approach, Approach::Unsettled(_))
    }

    /// Returns the number of cycles over which the search followed the motion without seeing it settle. Returns `None` if
    /// the motion settles.
    #[must_use]
    pub fn cycles_followed(&self) -> Option<usize> {
        match self.steady.approach {
            Approach::Reached => None,
            Approach::Apart(cycles) | Approach::Unsettled(cycles) => Some(cycles),
        }
    }

    /// Returns the angular frequency of the load in rad/s. Without a load, it is that of the limit cycle.
    #[must_use]
    pub fn omega(&self) -> f64 {
        self.omega
    }

    /// Returns the period of the motion in cycles of the load, at most 64.
    #[must_use]
    pub fn period(&self) -> usize {
        self.steady.period
    }

    /// Returns the Floquet multipliers of the motion over a period, in descending order of their modulus. The list
    /// leaves out the multipliers 1 of marginal directions. In a marginal direction, a small deviation neither grows
    /// nor decays.
    #[must_use]
    pub fn multipliers(&self) -> &[Complex<f64>] {
        &self.steady.multipliers
    }

    /// Returns true if every small deviation decays, except along marginal directions. A deviation along a marginal
    /// direction stays constant.
    #[must_use]
    pub fn is_stable(&self) -> bool {
        self.steady.is_stable()
    }

    /// Returns true if a small deviation grows: a multiplier lies outside the unit circle by more than rounding.
    #[must_use]
    pub fn is_unstable(&self) -> bool {
        self.multipliers().iter().any(|m| m.norm() > 1.0 + 1e-7)
    }

    /// Returns true if the steady state depends on the initial state. It depends on the initial state if a contact
    /// never slides and keeps its position, or if a part of the chain has no path of springs to a support.
    #[must_use]
    pub fn is_marginal(&self) -> bool {
        !self.steady.marginal.is_empty() || self.steady.neutral > 0
    }

    /// Returns the names of the contacts that never slide. A contact that never slides keeps the force or the position
    /// that the earlier motion has left.
    #[must_use]
    pub fn marginal_contacts(&self) -> Vec<String> {
        let names = self.joined.contact_names().into_iter().enumerate();
        let kept = names.filter(|(index, _)| self.steady.marginal.contains(index));
        kept.map(|(_, name)| name).collect()
    }

    /// Returns the number of marginal directions that belong to parts of the chain without a path of springs to a
    /// support. A marginal direction is a displacement or a constant velocity of such a part. A small deviation in
    /// this direction does not decay.
    #[must_use]
    pub fn free_directions(&self) -> usize {
        self.steady.neutral
    }

    /// Returns the largest difference between the states at the start and at the end of a period, divided by the size
    /// of the state.
    #[must_use]
    pub fn residual(&self) -> f64 {
        self.steady.residual
    }

    /// Returns the regime. It is *stuck* if no contact slides, and *continuous* if all contacts slide all the time.
    /// Otherwise it is *stick-slip*.
    #[must_use]
    pub fn regime(&self) -> Regime {
        self.steady.cycle.regime()
    }

    /// Returns the motions of all contacts, in the order of the scene description.
    pub fn contacts(&self) -> impl Iterator<Item = ContactOrbit<'_>> {
        let units = self.units;
        let contacts = self.steady.cycle.contacts.iter().enumerate();
        contacts.map(move |(index, cycle)| ContactOrbit {
            orbit: self,
            index,
            cycle,
            units,
        })
    }

    /// Returns the contact called `name`.
    ///
    /// # Errors
    /// [`UnknownContact`] if no contact has this name.
    pub fn contact(&self, name: &str) -> Result<ContactOrbit<'_>, UnknownContact> {
        let index = self.joined.contact_index(name)?;
        self.contacts().nth(index).ok_or_else(|| UnknownContact {
            name: name.to_owned(),
            known: self.joined.contact_names(),
        })
    }

    /// Returns [`contact`](Self::contact), which programs for earlier versions call by this name.
    ///
    /// # Errors
    /// Same errors as [`contact`](Self::contact).
    #[doc(hidden)]
    pub fn contact_named(&self, name: &str) -> Result<ContactOrbit<'_>, UnknownContact> {
        self.contact(name)
    }

    /// Returns the course of the displacement of the mass called `name` over a period: its phase, its harmonics and its
    /// value at any phase.
    ///
    /// ```
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let frame: frictiongen::System = "struct Frame {
    ///     masses: { lower: 2.0, upper: 1.5 },
    ///     springs: { base - lower: 1500.0, lower - upper: 1200.0 },
    ///     contacts: { brace: base - lower { stiffness: 4.0e3 }, pads: lower - upper { share: 0.6 } },
    ///     damping: modal(0.01),
    ///     excitation: base,
    /// }"
    /// .parse()?;
    /// let orbit = frame.joined()?.at(0.6)?.orbit(0.3)?;
    /// let upper = orbit.mass("upper")?;
    /// assert!((upper.amplitude() - orbit.amplitude("upper")?).abs() < 1e-12);
    /// // The state repeats with the opposite sign after half a cycle, so that it has no even harmonics.
    /// assert!(upper.harmonic(2).norm() < 1e-12 && upper.harmonic(3).norm() > 1e-4);
    /// assert!(upper.phase() > 0.0);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`JoinedError::UnknownMass`] if no mass has this name. [`JoinedError::Engine`] if the solver does not support the
    /// chain.
    pub fn mass(&self, name: &str) -> Result<Waveform, JoinedError> {
        let mass = self.joined.mass_index(name)?;
        let (of, size) = (Of::Mass(mass), MotionQuantity::Displacement);
        self.waveform(Course::of(&self.joined, of, size))
    }

    /// Returns the course of one quantity over a period.
    fn waveform(&self, course: Option<Course>) -> Result<Waveform, JoinedError> {
        let course = course.ok_or(JoinedError::Quantity)?;
        let mut all = self.waveforms(&[course])?;
        all.pop().ok_or(JoinedError::Quantity)
    }

    /// Returns the courses of several quantities over a period.
    pub(in crate::study) fn waveforms(
        &self,
        courses: &[Course],
    ) -> Result<Vec<Waveform>, JoinedError> {
        let cycles = self.period();
        let mut pieces = vec![Vec::new(); courses.len()];
        let period = std::f64::consts::TAU / self.omega * cycles as f64;
        let setting = (self.omega, self.units);
        self.motion()?.run(period, &mut |series, end, _| {
            for (pieces, course) in pieces.iter_mut().zip(courses) {
                pieces.push(course.piece(series, end, setting));
            }
        })?;
        let of_pieces = |pieces| Waveform::new(pieces, self.omega, cycles);
        Ok(pieces.into_iter().map(of_pieces).collect())
    }

    /// Returns the amplitude of the mass called `name`: the largest |x̄| in a period. If a part of the chain has no
    /// path of springs to a support, the amplitude is the centred amplitude (max − min)/2 instead.
    ///
    /// # Errors
    /// [`UnknownMass`] if no mass has this name.
    pub fn amplitude(&self, name: &str) -> Result<f64, UnknownMass> {
        let mass = self.joined.mass_index(name)?;
        Ok(self.amplitudes().get(mass).copied().unwrap_or_default())
    }

    /// Returns the amplitudes of all masses, as [`amplitude`](Self::amplitude) does for one mass.
    #[must_use]
    pub fn amplitudes(&self) -> Vec<f64> {
        let cycle = &self.steady.cycle;
        let amplitudes = match self.steady.neutral {
            0 => &cycle.amplitudes,
            _ => &cycle.centred,
        };
        let amplitudes = amplitudes.iter();
        amplitudes.map(|x| x / self.units.length).collect()
    }

    /// Returns the largest |x̄| of every mass in a period. This value includes the mean displacement of the mass.
    #[must_use]
    pub fn largest_displacements(&self) -> Vec<f64> {
        let largest = self.steady.cycle.amplitudes.iter();
        largest.map(|x| x / self.units.length).collect()
    }

    /// Returns the centred amplitude of every mass: (max − min)/2 of its displacement x̄ in a period. If a part of the
    /// chain has no path of springs to a support, the displacement by the mean velocity does not count.
    #[must_use]
    pub fn centred_amplitudes(&self) -> Vec<f64> {
        let centred = self.steady.cycle.centred.iter();
        centred.map(|x| x / self.units.length).collect()
    }

    /// Returns displacement and velocity of every mass at a maximum of the load.
    #[must_use]
    pub fn state(&self) -> (Vec<f64>, Vec<f64>) {
        let state = &self.steady.state;
        let x = state.x.iter().map(|x| x / self.units.length);
        let v = state.v.iter().map(|v| v / self.units.speed);
        (x.collect(), v.collect())
    }

    /// Returns a motion in time that starts from this steady state at a maximum of the load, where the period begins.
    ///
    /// # Errors
    /// [`JoinedError::Engine`] if the solver does not support the chain.
    pub fn motion(&self) -> Result<Motion, JoinedError> {
        let mut motion = Motion::from_rest(&self.chain)?;
        motion.restart(self.steady.state.clone());
        Ok(motion)
    }

    /// Returns true if the motion repeats with the opposite sign after half a period.
    ///
    /// # Errors
    /// [`JoinedError::Engine`] if the solver does not support the chain.
    pub fn is_symmetric(&self) -> Result<bool, JoinedError> {
        Ok(self.steady.is_symmetric(&self.chain, self.omega)?)
    }

    /// Returns this orbit with results in other units.
    pub(in crate::study) fn in_units(self, units: AnswerUnits) -> Self {
        Self { units, ..self }
    }

    /// Returns the steady state in the units of the scene description.
    pub(super) fn steady(&self) -> &Steady {
        &self.steady
    }

    /// Returns the scene, the angular frequency of the load, and the units of the results.
    pub(super) fn setting(&self) -> (&Joined<'a>, f64, AnswerUnits) {
        (&self.joined, self.omega, self.units)
    }
}
