//! Finds steady states (periodic motions) of a chain with several contacts by the shooting method.
//!
//! The unknowns are the displacements and velocities at a maximum of the load, and positions of contacts. For an
//! elastic contact, the position is that of its slider. For a rigid contact that sticks at this instant, the position
//! is its relative displacement. If a contact does not slide in the period, its position is arbitrary within an interval, and
//! the steady state is *marginal*. Over half a cycle the search puts the contact in the middle of this interval. Over
//! whole cycles the position is no unknown, and stays where the earlier motion has left it.

use super::cycle::{Cycle, Watch};
use super::least::apart;
use super::run::{Bounds, Motion, Observe};
use super::simulation::{MAX_EVENTS, MAX_STRETCHES};
use super::size::Size;
use super::slid::{Slid, Slips};
use super::state::State;
use super::tangent::{Both, ShotSpan};
use super::tolerances::Tolerances;
use crate::errors::Halt;
use crate::number::complex::Complex;
use crate::{Float, Scalar};

/// Number of cycles from rest that the motion runs before the first attempt to find a steady state.
const WARM: usize = 30;
/// Largest number of attempts to find a steady state. Before each further attempt the motion runs for twice as many
/// cycles as before the previous attempt.
pub(super) const ATTEMPTS: usize = 6;
/// Largest period of a steady state, in cycles of the load.
pub const MAX_PERIOD: usize = 64;
/// Number of cycles without sliding after which the search assumes that all contacts stick for ever, even if it cannot
/// prove this. Without this assumption, the search would find no steady state of an undamped chain whose contacts stick,
/// because its free vibration never decays.
const QUIET: usize = 128;
/// Distance from a periodic motion at which the test of this motion ends, divided by the distance at the start of the
/// test. The code predicts this ratio from the Floquet multipliers.
const DECAY: f64 = 1e-3;
/// Factor by which a deviation may exceed the prediction from the Floquet multipliers.
const TRANSIENT: f64 = 5.0;
/// Largest number of cycles for which the test of a periodic motion follows the motion.
const MAX_CONFIRM: usize = 256;

/// Largest numbers of events and stretches (time intervals of one power series) in one cycle.
pub(super) const BOUNDS: Bounds = Bounds {
    events: MAX_EVENTS,
    stretches: MAX_STRETCHES,
};

/// The steady state that a motion soon reaches, or the results of its last cycles.
pub type Soon<S, Z> = Result<Steady<S, Z>, Cycle<S, Z>>;

/// The place of a contact that never slides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// In the middle of the interval in which it can stick.
    Centred,
    /// Where the motion has left it.
    Reached,
}

/// A steady state of a chain with several contacts. Its motion repeats after one or several cycles of the load.
#[derive(Clone, Debug)]
pub struct Steady<S: Float, Z: Size> {
    /// Length of the period, in cycles of the load.
    pub period: usize,
    /// State at a maximum of the load, at which the period starts.
    pub state: State<S, Z>,
    /// Number of independent motions of the chain that change no force. An example is a displacement or a constant
    /// velocity of a part of the chain without a support. The load does not determine these displacements and
    /// velocities. In the steady state they have the values that the preceding motion has reached.
    pub neutral: usize,
    /// Floquet multipliers of a period. The array also has unused entries at its end.
    pub(super) multipliers: Z::Unknowns<Complex<S>>,
    /// Number of Floquet multipliers in `multipliers`.
    pub(super) count: usize,
    /// True for each contact that does not slide in the period. The steady state depends on the positions of these
    /// contacts, or on the constant forces in them.
    pub marginal: Z::Contacts<bool>,
    /// Amplitudes of the masses and results of the contacts in a period.
    pub cycle: Cycle<S, Z>,
    /// Largest difference between the states at the start and at the end of a period, divided by the size of the state.
    pub residual: S,
    /// Relation of the steady state to the motion from which the search started.
    pub approach: Approach,
}

/// Relation of a steady state to the motion from which the search for it started.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Approach {
    /// The motion settles in the steady state, or the search needed no motion.
    Reached,
    /// The motion does not settle within this number of cycles. The steady state is another stable one.
    Apart(usize),
    /// The motion does not settle within this number of cycles, and the search knows no steady state. The result contains
    /// the cycles that follow.
    Unsettled(usize),
}

impl<S: Float, Z: Size> Steady<S, Z> {
    /// Returns the results of a period of a motion that follows no load. The search knows no multipliers of it.
    #[cfg(any(test, feature = "std"))]
    pub fn of_cycle(state: State<S, Z>, cycle: Cycle<S, Z>, size: &Z) -> Self {
        let zero = S::constant(0.0);
        Self {
            period: 1,
            state,
            neutral: 0,
            multipliers: size.unknowns(Complex::new(zero, zero)),
            count: 0,
            marginal: size.contacts(false),
            cycle,
            residual: zero,
            approach: Approach::Reached,
        }
    }

    /// Returns the Floquet multipliers of a period, in the order of decreasing absolute value. The list does not
    /// contain the multipliers 1 of the contacts in `marginal` and of the motions that `neutral` counts.
    pub fn multipliers(&self) -> &[Complex<S>] {
        let all = self.multipliers.as_ref();
        all.get(..self.count).unwrap_or(all)
    }

    /// Returns true if every small deviation from the steady state decays, except displacements of contacts in
    /// `marginal` and motions that `neutral` counts.
    pub fn is_stable(&self) -> bool {
        let most = S::constant(1.0 - 1e-9);
        self.multipliers().iter().all(|m| modulus(m) < most)
    }

    /// Returns true if no small deviation from the steady state grows. `noise` is the error of a multiplier.
    pub(super) fn is_bounded(&self, noise: S) -> bool {
        let most = S::constant(1.0) + noise;
        self.multipliers().iter().all(|m| modulus(m) < most)
    }
}

/// Returns the largest distance from a periodic motion after a number of periods, divided by the distance before, of a
/// motion that approaches it. `rate` is the modulus of the largest multiplier.
fn furthest<S: Float>(rate: S, periods: usize) -> S {
    let expected = (0..periods).fold(S::constant(1.0), |expected, _| expected * rate);
    let expected = Scalar::max(expected, S::constant(DECAY));
    let half = S::constant(0.5) * (S::constant(1.0) + expected);
    Scalar::min(half, S::constant(TRANSIENT) * expected)
}

pub(super) fn modulus<S: Float>(number: &Complex<S>) -> S {
    number.re.hypot(number.im)
}

/// Returns the distance of a Floquet multiplier from 1 in the complex plane.
pub(super) fn from_one<S: Float>(number: &Complex<S>) -> S {
    (number.re - S::constant(1.0)).hypot(number.im)
}

impl<S: Float, Z: Size> Motion<S, Z> {
    /// Searches for the steady state that the motion reaches, under loads of the angular frequency ω, except that a
    /// contact that never slides is in the middle of the interval in which it can stick. If the motion does not settle,
    /// the function returns `None`. The period of a steady state is at most [`MAX_PERIOD`] cycles.
    ///
    /// If the steady state is the only one, the search need not follow the motion. Newton's method then starts from
    /// `near`, if the steady state of a similar chain is known. Otherwise the function follows the motion as
    /// [`settle_from`](Self::settle_from) does.
    ///
    /// # Errors
    ///
    /// [`Halt`] if the motion exceeds a bound.
    pub fn settle(
        &self,
        omega: S,
        near: Option<&Steady<S, Z>>,
    ) -> Result<Option<Steady<S, Z>>, Halt> {
        let mut search = Search::by_tables(self, omega, S::constant(1.0));
        let asked = (ATTEMPTS, Place::Centred);
        search.reach(&mut self.clone(), asked, near, &mut |_, _| {})
    }

    /// Searches for the steady state that the motion reaches, under loads of the angular frequency ω. A contact that
    /// never slides stays where the motion has left it.
    ///
    /// The search follows at most 1890 cycles until the motion settles, 12 times 319 cycles to confirm a result, and 24
    /// times 49 periods in Newton's method. If no contact slides for 128 cycles, the result is the state in which all
    /// contacts stick, even if a free vibration about this state does not decay.
    ///
    /// # Errors
    ///
    /// [`Halt`] if the motion exceeds a bound.
    pub fn settle_from(&self, omega: S) -> Result<Option<Steady<S, Z>>, Halt> {
        let mut search = Search::by_tables(self, omega, S::constant(1.0));
        let asked = (ATTEMPTS, Place::Reached);
        search.reach(&mut self.clone(), asked, None, &mut |_, _| {})
    }

    /// Searches as [`settle`](Self::settle) does, or as [`settle_from`](Self::settle_from) if `place` is
    /// [`Place::Reached`], but with a number of attempts. Before the first attempt the motion runs for 30 cycles, and
    /// before each further attempt for twice as many as before the previous one. If the motion does not settle, the
    /// function returns the results of the next [`MAX_PERIOD`] cycles.
    ///
    /// # Errors
    ///
    /// [`Halt`] if the motion exceeds a bound.
    pub fn settle_soon(&self, omega: S, attempts: usize, place: Place) -> Result<Soon<S, Z>, Halt> {
        let mut motion = self.clone();
        let mut search = Search::by_tables(self, omega, S::constant(1.0));
        let found = search.reach(&mut motion, (attempts, place), None, &mut |_, _| {})?;
        if let Some(steady) = found {
            return Ok(Ok(steady));
        }
        let mut watch = Watch::new(motion.model());
        search.advance(&mut motion, MAX_PERIOD, &mut watch)?;
        Ok(Err(watch.cycle(search.length(MAX_PERIOD))))
    }

    /// Searches for a periodic motion near the present state by Newton's method alone, under loads of the angular
    /// frequency ω. `period` is the number of cycles of the load in a period. The search divides displacements by
    /// `place`, which must be about as large as the displacements. Returns `None` if Newton's method does not
    /// converge, or if the motion already repeats after fewer cycles.
    ///
    /// # Errors
    ///
    /// [`Halt`] if the motion exceeds a bound.
    pub fn refine(
        &self,
        omega: S,
        (period, place): (usize, S),
    ) -> Result<Option<Steady<S, Z>>, Halt> {
        let mut search = Search::by_tables(self, omega, place);
        // Where the steady state is the only one, contacts that never slide stay centred.
        let centres = period == 1 && self.model().is_contraction() && search.is_odd(self.model());
        let span = if centres {
            ShotSpan::Half
        } else {
            ShotSpan::Cycles(period)
        };
        let found = search.newton(self, span)?;
        match found {
            Some(steady) if period > 1 && search.repeats_earlier(self, &steady)? => Ok(None),
            found => Ok(found),
        }
    }

    /// Searches as [`refine`](Self::refine) does for a motion that has the opposite sign half a cycle later. Returns
    /// `None` also if the loads or the chain permit no such motion.
    ///
    /// # Errors
    ///
    /// [`Halt`] if the motion exceeds a bound.
    pub fn refine_symmetric(&self, omega: S, place: S) -> Result<Option<Steady<S, Z>>, Halt> {
        let mut search = Search::by_tables(self, omega, place);
        if !search.is_odd(self.model()) {
            return Ok(None);
        }
        search.newton(self, ShotSpan::Half)
    }
}

#[cfg(any(test, feature = "std"))]
impl Motion<f64, super::heap::Heap> {
    /// Returns the mirror image of the motion: the motion half a cycle later, with the opposite sign. Returns `None` if
    /// the loads or the chain permit no such motion.
    ///
    /// # Errors
    ///
    /// [`Halt`] if the motion exceeds a bound.
    pub fn mirrored(&self, omega: f64) -> Result<Option<Self>, Halt> {
        let mut search = Search::new(self, omega, 1.0);
        if !search.is_odd(self.model()) {
            return Ok(None);
        }
        let mut mirrored = self.clone();
        search.pass(&mut mirrored, ShotSpan::Half, &mut ())?;
        Ok(Some(mirrored))
    }
}

/// Search for a periodic motion of a chain by the shooting method.
pub(super) struct Search<S: Float, Z: Size> {
    /// Angular frequency ω of the load, in rad per unit of time.
    pub(super) omega: S,
    /// Duration of one cycle of the load.
    pub(super) cycle: S,
    /// Typical size of the displacements in the motion. The search divides displacements by this size.
    pub(super) place: S,
    /// True for each contact that slides in the period.
    pub(super) moving: Z::Contacts<bool>,
    /// Number of cycles since a contact last slid.
    quiet: usize,
    /// Number of cycles for which the search has followed the motion.
    pub(super) cycles: usize,
    pub(super) tolerances: Tolerances<S>,
    /// Tables for the chain and the loads of the motion, if the search uses them.
    tables: Option<Z::Tables<S>>,
}

impl<S: Float, Z: Size> Search<S, Z> {
    pub(super) fn new(motion: &Motion<S, Z>, omega: S, place: S) -> Self {
        Self {
            omega,
            cycle: S::constant(core::f64::consts::TAU) / omega,
            place,
            moving: motion.model().size.contacts(false),
            quiet: 0,
            cycles: 0,
            tolerances: Tolerances::new(),
            tables: None,
        }
    }

    /// Returns a search that uses tables, if they exist for the loads of the motion.
    pub(super) fn by_tables(motion: &Motion<S, Z>, omega: S, place: S) -> Self {
        let model = motion.model();
        let tables = || model.size.tables(&motion.shared, model.coordinates());
        Self {
            tables: model.has_tables().then(tables),
            ..Self::new(motion, omega, place)
        }
    }

    /// Searches for a steady state, by Newton's method from `near` if the steady state is the only one. Afterwards the
    /// motion is at the end of the last cycle that the search has followed. `others` is that of
    /// [`followed`](Self::followed).
    pub(super) fn reach(
        &mut self,
        motion: &mut Motion<S, Z>,
        (attempts, place): (usize, Place),
        near: Option<&Steady<S, Z>>,
        others: &mut impl FnMut(Steady<S, Z>, S),
    ) -> Result<Option<Steady<S, Z>>, Halt> {
        if place == Place::Reached {
            return self.followed(motion, attempts, others);
        }
        let start = motion.clone();
        // If this search exceeds a bound, the code ignores the error, because the search below may still find a steady
        // state.
        if let Ok(Some(steady)) = self.only(&start, near) {
            return Ok(Some(steady));
        }
        self.moving = start.model().size.contacts(false);
        let Some(steady) = self.followed(motion, attempts, others)? else {
            return Ok(None);
        };
        self.centred(&start, steady).map(Some)
    }

    /// Advances the motion by a number of cycles. Returns the shortest period, in cycles, after which the last states
    /// approximately repeat, or `None` if they do not repeat.
    pub(super) fn warm(
        &mut self,
        motion: &mut Motion<S, Z>,
        cycles: usize,
    ) -> Result<Option<usize>, Halt> {
        self.cycles += cycles;
        let window = MAX_PERIOD.min(cycles / 2);
        let skipped = cycles.saturating_sub(window);
        let mut slid = Slid::new(motion.model());
        self.advance(motion, skipped, &mut slid)?;
        self.note(slid.slides, skipped);
        let first = motion.state().clone();
        let zero = S::constant(0.0);
        let mut aways = [zero; MAX_PERIOD];
        let mut most = zero;
        let mut watch = Watch::new(motion.model());
        for (index, away) in aways.iter_mut().take(window).enumerate() {
            let mut slips = Slips::new(motion.model());
            if index + 1 == window {
                self.advance(motion, 1, &mut Both(&mut slips, &mut watch))?;
            } else {
                self.advance(motion, 1, &mut slips)?;
            }
            let slides = slips.slides(motion.model());
            self.note(slides.as_ref().contains(&true), 1);
            *away = self.between(motion.state(), &first);
            most = Scalar::max(most, *away);
        }
        let amplitudes = watch.cycle(self.cycle).amplitudes;
        let place = amplitudes.as_ref().iter().copied();
        let place = place.fold(zero, Scalar::max);
        // If nothing moves, the size of the displacements is arbitrary.
        self.place = if place > zero {
            place
        } else {
            S::constant(1.0)
        };
        let near = S::constant(0.02) * most;
        let mut aways = aways.iter().take(window);
        Ok(aways.position(|away| *away <= near).map(|place| place + 1))
    }

    /// Follows a motion until it settles. Returns `None` if it does not settle within a number of attempts. `others`
    /// receives the periodic motions that Newton's method finds and the motion does not approach, each with its distance
    /// from the motion.
    fn followed(
        &mut self,
        motion: &mut Motion<S, Z>,
        attempts: usize,
        others: &mut impl FnMut(Steady<S, Z>, S),
    ) -> Result<Option<Steady<S, Z>>, Halt> {
        let mut cycles = WARM;
        for _ in 0..attempts {
            // A motion that has not slid so far need not be followed any longer than `QUIET`.
            let left = if self.quiet == self.cycles {
                QUIET.saturating_sub(self.quiet).max(WARM)
            } else {
                cycles
            };
            let period = self.warm(motion, cycles.min(left))?;
            for period in [Some(1), period.filter(|&period| period > 1)]
                .into_iter()
                .flatten()
            {
                let Some(steady) = self.newton(motion, ShotSpan::Cycles(period))? else {
                    continue;
                };
                if steady.period > 1 && self.repeats_earlier(motion, &steady)? {
                    continue;
                }
                let far = self.away(motion.state(), &steady);
                if self.accepts(motion, &steady)? {
                    return self.about_its_mean(motion, steady).map(Some);
                }
                others(steady, far);
            }
            cycles *= 2;
        }
        Ok(None)
    }

    /// Updates the number of cycles without sliding.
    fn note(&mut self, slides: bool, cycles: usize) {
        self.quiet = if slides { 0 } else { self.quiet + cycles };
    }

    /// Returns true if the motion settles on a periodic motion. The result is also true if all contacts stick and the
    /// motion vibrates about the periodic motion for ever, and if the motion has come to a periodic motion about which an
    /// undamped part of the chain could vibrate.
    pub(super) fn accepts(
        &mut self,
        motion: &mut Motion<S, Z>,
        steady: &Steady<S, Z>,
    ) -> Result<bool, Halt> {
        if self.is_stuck(motion, steady) {
            return Ok(true);
        }
        let is_bounded = steady.is_bounded(self.tolerances.noise);
        let is_there = is_bounded && self.away(motion.state(), steady) <= self.tolerances.close;
        Ok((steady.is_stable() || is_there)
            && self.confirm(motion, steady)?
            && self.leads_to(motion, steady)?)
    }

    /// Returns true if no contact slides in a steady state, and if the motion, too, has no contact that slides from now on.
    fn is_stuck(&self, motion: &Motion<S, Z>, steady: &Steady<S, Z>) -> bool {
        !self.moving.as_ref().contains(&true)
            && steady.is_bounded(self.tolerances.noise)
            && (self.quiet >= QUIET || motion.sticks_for_ever(steady))
    }

    /// Returns true if Newton's method finds the same periodic motion from the present state of a motion that approaches
    /// it. Another periodic motion may be so close that the motion comes near this one on its way there.
    fn leads_to(&mut self, motion: &Motion<S, Z>, steady: &Steady<S, Z>) -> Result<bool, Halt> {
        let is_close = self.away(motion.state(), steady) <= self.tolerances.close;
        if is_close || self.is_stuck(motion, steady) || motion.model().is_contraction() {
            return Ok(true);
        }
        let found = self.newton(motion, ShotSpan::Cycles(steady.period))?;
        let apart = |found: Steady<S, Z>| self.away(&found.state, steady);
        Ok(found.is_some_and(|found| apart(found) <= self.tolerances.close))
    }

    /// Returns a steady state in which each contact that never slides is in the middle of the interval in which it can
    /// stick. If moving the contacts there would lead to another motion, the function returns the steady state itself.
    pub(super) fn centred(
        &mut self,
        motion: &Motion<S, Z>,
        steady: Steady<S, Z>,
    ) -> Result<Steady<S, Z>, Halt> {
        let is_marginal = steady.marginal.as_ref().contains(&true);
        if steady.period != 1 || !is_marginal || !self.is_odd(motion.model()) {
            return Ok(steady);
        }
        let amplitudes = steady.cycle.amplitudes.as_ref().iter().copied();
        self.place = amplitudes.fold(S::constant(f64::from(f32::MIN_POSITIVE)), Scalar::max);
        let mut near = motion.clone();
        near.restart(steady.state.clone());
        let Some(found) = self.newton(&near, ShotSpan::Half)? else {
            return Ok(steady);
        };
        let slides = found.marginal.as_ref().contains(&false);
        let is_stable = found.is_stable() || (!slides && found.is_bounded(self.tolerances.noise));
        let stops = |one: &Steady<S, Z>| {
            let contacts = one.cycle.contacts.as_ref().iter();
            contacts.fold(0, |sum, contact| sum + contact.stops + contact.reversals)
        };
        let same = found.marginal == steady.marginal && stops(&found) == stops(&steady);
        Ok(if is_stable && same { found } else { steady })
    }

    /// Returns true if a periodic motion already repeats after fewer cycles than its period.
    pub(super) fn repeats_earlier(
        &mut self,
        motion: &Motion<S, Z>,
        steady: &Steady<S, Z>,
    ) -> Result<bool, Halt> {
        let mut motion = motion.clone();
        motion.restart(steady.state.clone());
        for _ in 1..steady.period {
            self.advance(&mut motion, 1, &mut ())?;
            if self.away(motion.state(), steady) <= self.tolerances.close {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Returns the distance between two states. It is the largest difference of two displacements, or of two velocities
    /// divided by ω.
    fn between(&self, one: &State<S, Z>, other: &State<S, Z>) -> S {
        let rate = S::constant(core::f64::consts::TAU) / self.cycle;
        let speeds = apart(one.v.as_ref(), other.v.as_ref()) / rate;
        Scalar::max(apart(one.x.as_ref(), other.x.as_ref()), speeds)
    }

    /// Advances the motion by a number of cycles. The motion must be at a maximum of the load. At the start of each
    /// cycle the time is set to 0.
    pub(super) fn advance(
        &mut self,
        motion: &mut Motion<S, Z>,
        cycles: usize,
        watch: &mut impl Observe<S, Z>,
    ) -> Result<(), Halt> {
        for _ in 0..cycles {
            let state = motion.state().clone();
            motion.restart(state);
            motion.run_by(&mut self.tables, (self.cycle, BOUNDS), watch)?;
        }
        Ok(())
    }

    /// Advances the motion by half a cycle from a maximum of the load, and sets the time to 0 at its start.
    pub(super) fn advance_half(
        &mut self,
        motion: &mut Motion<S, Z>,
        watch: &mut impl Observe<S, Z>,
    ) -> Result<(), Halt> {
        let state = motion.state().clone();
        motion.restart(state);
        let half = S::constant(0.5) * self.cycle;
        motion.run_by(&mut self.tables, (half, BOUNDS), watch)
    }

    /// Returns the duration of a number of cycles of the load.
    pub(super) fn length(&self, cycles: usize) -> S {
        S::whole(cycles) * self.cycle
    }

    /// Computes the centred amplitude of each mass again, if a part of the chain can move without a force. Such a part
    /// may drift. The function therefore first subtracts the mean velocity of each mass times the time. The centred
    /// amplitude is half the distance between the smallest and the largest displacement of the mass.
    fn about_its_mean(
        &mut self,
        motion: &Motion<S, Z>,
        mut steady: Steady<S, Z>,
    ) -> Result<Steady<S, Z>, Halt> {
        if steady.neutral == 0 {
            return Ok(steady);
        }
        let length = self.length(steady.period);
        let mut motion = motion.clone();
        motion.restart(steady.state.clone());
        let mut drifts = motion.state().x.clone();
        let mut end = motion.clone();
        self.advance(&mut end, steady.period, &mut ())?;
        for (drift, end) in drifts.as_mut().iter_mut().zip(end.state().x.as_ref()) {
            *drift = (*end - *drift) / length;
        }
        let mut watch = Watch::drifting(motion.model(), drifts);
        self.advance(&mut motion, steady.period, &mut watch)?;
        steady.cycle.centred = watch.cycle(length).centred;
        Ok(steady)
    }

    /// Returns true if the motion approaches a periodic motion as fast as its Floquet multipliers predict. Returns
    /// false if a contact slides during this test, but not in the periodic motion.
    ///
    /// With μ > 1 a motion that approaches another periodic motion, or wanders, may come closer to this one, too. The
    /// distance therefore has to fall about as far as predicted, and again in the second half of the test.
    fn confirm(&mut self, motion: &mut Motion<S, Z>, steady: &Steady<S, Z>) -> Result<bool, Halt> {
        let (one, half) = (S::constant(1.0), S::constant(0.5));
        let rate = steady.multipliers().first();
        let rate = rate.map_or(S::constant(0.0), modulus);
        let most = MAX_CONFIRM.checked_div(steady.period);
        let most = most.unwrap_or(1).max(1);
        let (mut periods, mut expected) = (1, rate);
        while expected > S::constant(DECAY) && periods < most {
            expected = expected * rate;
            periods += 1;
        }
        let (first, rest) = (periods / 2, periods.div_ceil(2));
        self.cycles += periods * steady.period;
        let before = self.away(motion.state(), steady);
        let slides = self.slides_beside(motion, steady, first)?;
        let middle = self.away(motion.state(), steady);
        let slides = self.slides_beside(motion, steady, rest)? || slides;
        let after = self.away(motion.state(), steady);
        if slides {
            return Ok(false);
        }
        let falls = after <= half * (one + expected) * before;
        let is_near =
            after <= furthest(rate, periods) * before && after <= furthest(rate, rest) * middle;
        let is_near = is_near || motion.model().is_contraction();
        Ok(after <= self.tolerances.close || (falls && is_near))
    }

    /// Advances the motion by a number of periods. Returns true if a contact slides in this time that does not slide in
    /// the periodic motion.
    fn slides_beside(
        &mut self,
        motion: &mut Motion<S, Z>,
        steady: &Steady<S, Z>,
        periods: usize,
    ) -> Result<bool, Halt> {
        let mut slips = Slips::new(motion.model());
        self.advance(motion, periods * steady.period, &mut slips)?;
        let slides = slips.slides_in(motion.model(), periods);
        let mut slides = slides.as_ref().iter().zip(steady.marginal.as_ref());
        Ok(slides.any(|(slides, marginal)| *slides && *marginal))
    }

    /// Returns the largest difference between a state and the initial state of a periodic motion, divided by the sizes
    /// of the unknowns. If a part of the chain can move without a force, the code compares only the velocities.
    pub(super) fn away(&self, state: &State<S, Z>, steady: &Steady<S, Z>) -> S {
        let rate = S::constant(core::f64::consts::TAU) / self.cycle;
        let away = if steady.neutral > 0 {
            apart(state.v.as_ref(), steady.state.v.as_ref()) / rate
        } else {
            self.between(state, &steady.state)
        };
        away / self.place
    }
}
