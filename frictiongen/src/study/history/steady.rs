//! Samples one period of a steady state. The samples come from the closed form, from the steady state with stops, or
//! from the stuck response.

use super::{History, HistoryError, HistoryEvent, check, phase};
use crate::study::{
    orbit::SystemOrbit,
    response::{SystemHeld, SystemMotion, SystemResponse},
};
use crate::{Complex, Given, NoOrbit, Of, OutOfDomain};
use frictiongen_kernel::simulation::{Contact, Event};
use std::f64::consts::{PI, TAU};

impl SystemResponse<'_> {
    /// Returns the number of cycles of the excitation after which the motion repeats.
    #[must_use]
    pub fn period(&self) -> u32 {
        match self {
            Self::StickSlip(orbit) => orbit.period(),
            _ => 1,
        }
    }

    /// Returns samples of one period of the steady state, with every event. The first sample is at a maximum of the
    /// excitation. If the period has several cycles, it is the same maximum as in [`subharmonic`](Self::subharmonic).
    ///
    /// ```
    /// use frictiongen::{Of, System};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let block: System = "struct Block {
    ///     masses: { block: 1 },
    ///     springs: { base - block: 1 },
    ///     contact: block - wall,
    ///     excitation: block,
    /// }"
    /// .parse()?;
    /// let response = block.at(0.3)?.response(0.4)?;
    /// let history = response.history(&[Of::Contact], 400)?;
    /// // The period has two stops and two break-aways, and the last sample equals the first.
    /// assert_eq!(history.events.len(), 4);
    /// let contact = &history.tracks[0].displacement;
    /// assert!((contact[400] - contact[0]).abs() < 1e-14);
    /// assert!(history.friction.iter().all(|force| force.abs() <= 0.4 + 1e-14));
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`HistoryError`] for an invalid request, and for r = 0 and r = ∞, because the excitation then has no cycle.
    /// [`HistoryError`] also if the motion does not settle. In this case, sample a run from rest instead.
    pub fn history(&self, of: &[Of], samples: u32) -> Result<History, HistoryError> {
        let (system, r) = match self {
            Self::Continuous(motion) => (*motion.at().scene(), motion.at().frequency_ratio()),
            // The check below needs a valid r. An orbit exists only if r is neither 0 nor infinite, so that any valid
            // number, such as 1, suffices.
            Self::StickSlip(orbit) => (orbit.system, 1.0),
            Self::Stuck(stuck) => (*stuck.at().scene(), stuck.at().frequency_ratio()),
        };
        check(system, of, self.period(), samples)?;
        if !(0.0 < r && r.is_finite()) {
            return Err(OutOfDomain::FrequencyRatioInTime(Given::of(r)).into());
        }
        if !self.is_settled() {
            return Err(HistoryError::Solver(NoOrbit::Unsettled.into()));
        }
        let mut history = History::new(0, self.period(), samples, of);
        match self {
            Self::Continuous(motion) => continuous(&mut history, motion, of),
            Self::StickSlip(orbit) => with_stops(&mut history, orbit, of),
            Self::Stuck(stuck) => held(&mut history, stuck, of),
        }
        Ok(history)
    }
}

/// Returns the phases τ of all samples in the cycles of the history, and the phase at the end of the last cycle.
fn instants(history: &History) -> impl Iterator<Item = f64> + use<> {
    let samples = u64::from(history.samples);
    let all = 0..=samples * u64::from(history.cycles);
    all.map(move |index| TAU * ((index / samples) as f64) + phase(index % samples, samples))
}

/// Adds the samples and events of a contact that slides all the time. The contact reverses at the maximum and at the
/// minimum of its motion.
fn continuous(history: &mut History, motion: &SystemMotion<'_>, of: &[Of]) {
    let friction = motion.friction();
    let (lag, beta) = (friction.phase, friction.beta);
    let motions: Vec<_> = of.iter().filter_map(|of| motion.motion_of(*of)).collect();
    let sliding = |tau: f64| {
        // `half` is the number of half cycles since the contact's maximum.
        let half = ((tau - lag) / PI).floor();
        if half.rem_euclid(2.0) < 1.0 {
            (Contact::Backward, -beta)
        } else {
            (Contact::Forward, beta)
        }
    };
    for tau in instants(history) {
        let since = tau - lag;
        let moments = motions
            .iter()
            .map(|motion| (motion.displacement(since), motion.velocity(since)));
        history.push(moments, sliding(tau));
    }
    let turn = |tau: f64, contact: Contact| HistoryEvent {
        tau: within(tau, TAU),
        event: Event::Reversal,
        contact,
        displacements: motions
            .iter()
            .map(|motion| motion.displacement(tau - lag))
            .collect(),
    };
    history.events = vec![
        turn(lag, Contact::Backward),
        turn(lag + PI, Contact::Forward),
    ];
    history.events.sort_by(|a, b| a.tau.total_cmp(&b.tau));
}

/// Adds the samples and events of a contact that stops, or that reverses more than twice a cycle.
fn with_stops(history: &mut History, orbit: &SystemOrbit<'_>, of: &[Of]) {
    let origin = orbit.origin();
    let system = orbit.system;
    // A rigid contact is at rest while it sticks. An elastic contact then moves with its spring.
    let rigid = system.scene().stiffness.is_none();
    let prepared: Vec<_> = of.iter().filter_map(|of| orbit.prepared(*of)).collect();
    let motions: Vec<_> = prepared.iter().map(|motion| motion.motion(orbit)).collect();
    for tau in instants(history) {
        let since = tau - origin;
        let contact = orbit.friction(since);
        let moments = motions.iter().zip(of).map(|(motion, of)| {
            let velocity = match (system.simplest(*of), contact.0) {
                (Of::Contact, Contact::Stuck) if rigid => 0.0,
                _ => motion.velocity(since),
            };
            (motion.displacement(since), velocity)
        });
        history.push(moments, contact);
    }
    let intervals: Vec<(f64, Contact)> = orbit
        .intervals()
        .map(|(start, _, contact)| (start, contact))
        .collect();
    // The loop pairs each interval with its predecessor. The predecessor of the first interval is the last interval.
    let before = intervals.iter().cycle().skip(intervals.len().max(1) - 1);
    for ((tau, contact), (_, last)) in intervals.iter().zip(before) {
        let event = match (last, contact) {
            (last, contact) if last == contact => continue,
            (_, Contact::Stuck) => Event::Stop,
            (Contact::Stuck, _) => Event::Slip,
            _ => Event::Reversal,
        };
        history.events.push(HistoryEvent {
            tau: *tau,
            event,
            contact: *contact,
            displacements: motions
                .iter()
                .map(|motion| motion.displacement(tau - origin))
                .collect(),
        });
    }
    history.events.sort_by(|a, b| a.tau.total_cmp(&b.tau));
}

/// Adds the samples of a contact that never slides.
fn held(history: &mut History, held: &SystemHeld<'_>, of: &[Of]) {
    let (force, constant) = (held.contact_force(), held.constant_force());
    let amplitudes: Vec<(Complex<f64>, f64)> =
        of.iter().filter_map(|of| held.motion_of(*of)).collect();
    for tau in instants(history) {
        let (sine, cosine) = tau.sin_cos();
        let moments = amplitudes.iter().map(|(amplitude, offset)| {
            let displacement = offset + amplitude.re * cosine - amplitude.im * sine;
            let velocity = -(amplitude.re * sine) - amplitude.im * cosine;
            (displacement, velocity)
        });
        let holding = constant + force.re * cosine - force.im * sine;
        history.push(moments, (Contact::Stuck, holding));
    }
}

/// Returns τ reduced by whole periods to the range [0, period).
fn within(tau: f64, period: f64) -> f64 {
    let within = tau - (tau / period).floor() * period;
    if within < period { within } else { 0.0 }
}
