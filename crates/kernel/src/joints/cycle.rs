//! Results of one period of a motion: amplitudes of the masses, and stops, slip, force and energy of the contacts.

use super::model::{Model, Sides};
use super::poly::{Poly, TERMS, slope, value};
use super::roots::first_negative;
use super::run::Observe;
use super::series::Series;
use super::size::{Size, add, at};
use super::state::{IMPACT, STUCK, State};
use crate::errors::Regime;
use crate::{Float, Scalar};

/// Stops, reversals, slip, force and energy of one contact in a period.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactCycle<S> {
    /// Number of transitions of the contact from sliding to sticking.
    pub stops: usize,
    /// Number of transitions of the contact from sliding in one direction to sliding in the opposite direction, without
    /// a stop.
    pub reversals: usize,
    /// Fraction of the period during which the contact sticks.
    pub stuck_fraction: S,
    /// Distance that the contact slides in the period, added over both directions.
    pub slip: S,
    /// Largest absolute relative displacement of the contact in the period.
    pub displacement: S,
    /// Largest absolute force of the contact in the period.
    pub force: S,
    /// Energy that friction dissipates in the contact in the period, or that the dashpot of a stop dissipates.
    pub energy: S,
    /// True for a stop. `stops` is then the number of times that it shuts, and `stuck_fraction` the fraction of the
    /// period during which it is shut.
    pub is_stop: bool,
}

impl<S: Float> ContactCycle<S> {
    /// Returns the results of a contact that has not moved. All numbers are 0.
    pub(super) fn nothing() -> Self {
        let zero = S::constant(0.0);
        Self {
            stops: 0,
            reversals: 0,
            stuck_fraction: zero,
            slip: zero,
            displacement: zero,
            force: zero,
            energy: zero,
            is_stop: false,
        }
    }

    /// Returns true if the contact has slid farther than rounding errors can cause. A contact may reach its friction
    /// force once in every cycle without sliding. Rounding errors then decide whether the contact slides by some 1e-16
    /// of its displacement.
    fn has_slid(&self) -> bool {
        self.slip > least_slip(self.displacement)
    }

    /// Replaces the results by those of a contact that sticks. The caller uses this function if rounding errors alone
    /// cause the slip of the contact.
    fn forget_slip(&mut self) {
        let zero = S::constant(0.0);
        (self.stops, self.reversals) = (0, 0);
        (self.slip, self.energy) = (zero, zero);
        self.stuck_fraction = S::constant(1.0);
    }

    /// Returns the regime of this contact: continuous, stick-slip or stuck.
    pub fn regime(&self) -> Regime {
        let still = self.stops == 0 && self.reversals == 0;
        if still && self.stuck_fraction >= S::constant(0.5) {
            Regime::Stuck
        } else if self.stops == 0 {
            Regime::Continuous
        } else {
            Regime::StickSlip
        }
    }
}

/// Amplitudes of the masses, and results of each contact, in one period.
#[derive(Clone, Debug, PartialEq)]
pub struct Cycle<S: Float, Z: Size> {
    /// Amplitude of each mass: the largest absolute displacement |x| of the mass in the period.
    pub amplitudes: Z::Masses<S>,
    /// Centred amplitude of each mass: half the distance between its smallest and its largest displacement in the
    /// period. If a part of the chain can move without a force, the code first subtracts the displacement due to the
    /// mean velocity of each mass.
    pub centred: Z::Masses<S>,
    /// Results of each contact, in the order of the scene description.
    pub contacts: Z::Contacts<ContactCycle<S>>,
    /// Number of instants in the period at which a contact has an event.
    pub events: usize,
}

impl<S: Float, Z: Size> Cycle<S, Z> {
    /// Returns the regime of the chain. It is *stuck* if no contact slides, and *continuous* if all contacts slide all
    /// the time. In every other case it is *stick-slip*.
    pub fn regime(&self) -> Regime {
        let same = |regime| {
            let contacts = self.contacts.as_ref().iter();
            let mut contacts = contacts.filter(|contact| !contact.is_stop);
            contacts.all(|contact| contact.regime() == regime)
        };
        if same(Regime::Continuous) {
            Regime::Continuous
        } else if same(Regime::Stuck) {
            Regime::Stuck
        } else {
            Regime::StickSlip
        }
    }
}

/// Collects the results of a period while the motion advances, stretch by stretch. A stretch is the time interval of
/// one power series.
#[derive(Clone, Debug)]
pub struct Watch<S: Float, Z: Size> {
    sides: Z::Contacts<Sides<S>>,
    cycle: Cycle<S, Z>,
    /// Smallest and largest displacement of each mass since the start of the period.
    spans: Z::Masses<Option<(S, S)>>,
    /// Constant velocity of each mass. The code subtracts the displacement due to this velocity from the displacement
    /// of the mass.
    drifts: Z::Masses<S>,
    /// Time since the start of the period.
    passed: S,
    /// Phases after an event at the start of the period.
    first: Option<Z::Contacts<i8>>,
}

impl<S: Float, Z: Size> Watch<S, Z> {
    /// Starts to collect the results of a period for a chain.
    pub fn new(model: &Model<S, Z>) -> Self {
        let zero = S::constant(0.0);
        let size = &model.size;
        let mut contacts = size.contacts(ContactCycle::nothing());
        for (j, own) in contacts.as_mut().iter_mut().enumerate() {
            own.is_stop = model.is_stop(j);
        }
        Self {
            sides: sides(model),
            cycle: Cycle {
                amplitudes: size.masses(zero),
                centred: size.masses(zero),
                contacts,
                events: 0,
            },
            spans: size.masses(None),
            drifts: size.masses(zero),
            passed: zero,
            first: None,
        }
    }

    /// Starts to collect the results of a period in which each mass has a constant velocity in addition to its
    /// vibration. `drifts` contains these velocities.
    pub fn drifting(model: &Model<S, Z>, drifts: Z::Masses<S>) -> Self {
        Self {
            drifts,
            ..Self::new(model)
        }
    }

    /// Counts an event at the start of the period, which is also its end. Rounding decides whether the motion passes such
    /// an event at its start, at its end, both times or never. `start` and `end` are the phases at both instants.
    pub(super) fn close(&mut self, start: &Z::Contacts<i8>, end: &Z::Contacts<i8>) {
        let first = self.first.take().unwrap_or_else(|| start.clone());
        if first != *end {
            self.count(end, &first);
        }
    }

    fn count(&mut self, before: &Z::Contacts<i8>, after: &Z::Contacts<i8>) {
        self.cycle.events += 1;
        let phases = before.as_ref().iter().zip(after.as_ref());
        for (contact, (&before, &after)) in self.cycle.contacts.as_mut().iter_mut().zip(phases) {
            let stops = before != STUCK && after == STUCK;
            contact.stops += usize::from(stops || after == IMPACT);
            contact.reversals += usize::from(before * after == -1);
        }
    }

    fn see_masses(&mut self, series: &Series<S, Z>, end: S) {
        let amplitudes = self.cycle.amplitudes.as_mut().iter_mut();
        let masses = amplitudes.zip(self.spans.as_mut()).enumerate();
        for (mass, (amplitude, span)) in masses {
            let mut x = series.displacement_terms(mass);
            let mut v = series.velocity_terms(mass).map(|term| series.length * term);
            let mut values = extremes(&x, &v, end);
            let sizes = values.into_iter().map(Scalar::abs);
            *amplitude = sizes.fold(*amplitude, Scalar::max);
            let drift = at(self.drifts.as_ref(), mass);
            if !drift.is_zero() {
                add(&mut x, 0, -drift * self.passed);
                add(&mut x, 1, -drift * series.length);
                add(&mut v, 0, -drift * series.length);
                values = extremes(&x, &v, end);
            }
            for value in values {
                let (least, most) = span.unwrap_or((value, value));
                *span = Some((Scalar::min(least, value), Scalar::max(most, value)));
            }
        }
        self.passed = self.passed + end * series.length;
    }

    fn see_contact(&mut self, series: &Series<S, Z>, end: S, j: usize, sticks: bool) {
        let sides = self.sides.as_ref().get(j).copied();
        let contact = self.cycle.contacts.as_mut().get_mut(j);
        let (Some(sides), Some(contact)) = (sides, contact) else {
            return;
        };
        let force = series.force_terms(j);
        if let Some(damping) = sides.damping {
            see_stop(contact, series, end, (j, sides, damping, sticks));
            return;
        }
        let speed = series.slip_terms(sides);
        contact.force = Scalar::max(contact.force, largest(&force, &slope(&force), end));
        let most = largest(
            &series.place_terms(sides.plus, sides.minus),
            &series.speed_terms(sides.plus, sides.minus),
            end,
        );
        contact.displacement = Scalar::max(contact.displacement, most);
        if sticks {
            contact.stuck_fraction = contact.stuck_fraction + end * series.length;
            return;
        }
        contact.slip = contact.slip + series.length * integral(&speed, end).abs();
        contact.energy = contact.energy + work(&force, &speed, series.length, end);
    }

    /// Returns the results of a period whose duration is `length`.
    #[must_use]
    pub fn cycle(mut self, length: S) -> Cycle<S, Z> {
        for contact in self.cycle.contacts.as_mut() {
            contact.stuck_fraction = contact.stuck_fraction / length;
            let seems_to_slide =
                contact.slip > S::constant(0.0) || contact.stops + contact.reversals > 0;
            if seems_to_slide && !contact.has_slid() && !contact.is_stop {
                contact.forget_slip();
            }
        }
        let spans = self.spans.as_ref().iter();
        for (centred, span) in self.cycle.centred.as_mut().iter_mut().zip(spans) {
            let width = span.map(|(least, most)| most - least);
            *centred = S::constant(0.5) * width.unwrap_or(S::constant(0.0));
        }
        self.cycle
    }
}

impl<S: Float, Z: Size> Watch<S, Z> {
    /// Returns the results of a period whose duration is `length`, after the first half of the period. The motion
    /// repeats with the opposite sign in the second half.
    #[must_use]
    pub(super) fn half_cycle(mut self, length: S) -> Cycle<S, Z> {
        let twice = |value: &mut S| *value = *value + *value;
        for contact in self.cycle.contacts.as_mut() {
            (contact.stops, contact.reversals) = (2 * contact.stops, 2 * contact.reversals);
            twice(&mut contact.stuck_fraction);
            twice(&mut contact.slip);
            twice(&mut contact.energy);
        }
        self.cycle.events *= 2;
        let mut cycle = self.cycle(length);
        cycle.centred = cycle.amplitudes.clone();
        cycle
    }
}

impl<S: Float, Z: Size> Observe<S, Z> for Watch<S, Z> {
    fn stretch(&mut self, series: &Series<S, Z>, end: S, state: &State<S, Z>) {
        self.see_masses(series, end);
        for (j, &phase) in state.phases.as_ref().iter().enumerate() {
            self.see_contact(series, end, j, phase == STUCK);
        }
    }

    fn event(&mut self, _: S, before: &Z::Contacts<i8>, after: &Z::Contacts<i8>) {
        if self.passed.is_zero() {
            self.first = Some(after.clone());
        } else {
            self.count(before, after);
        }
    }
}

impl<S: Float, Z: Size> Series<S, Z> {
    /// Returns the work of the contact `j` between its nodes `plus` and `minus`, from the start to a fraction of the
    /// time interval. While a rigid contact slides, the work is the energy that its friction dissipates.
    ///
    /// `speed` is the velocity of a moving surface of the contact, and otherwise 0.
    pub fn work(&self, j: usize, ((plus, minus), speed): ((usize, usize), S), fraction: S) -> S {
        let sides = Sides {
            plus,
            minus,
            speed,
            damping: None,
        };
        let speed = self.slip_terms(sides);
        work(&self.force_terms(j), &speed, self.length, fraction)
    }

    /// Returns the integral of the squared relative velocity of two nodes, from the start to a fraction of the time
    /// interval.
    pub fn squared_speed(&self, (plus, minus): (usize, usize), fraction: S) -> S {
        let speed = self.speed_terms(plus, minus);
        work(&speed, &speed, self.length, fraction)
    }
}

/// Returns the largest slip that rounding errors can cause. `displacement` is the largest relative displacement of the
/// contact.
pub(super) fn least_slip<S: Float>(displacement: S) -> S {
    S::constant(64.0 * S::EPSILON) * displacement
}

/// Adds the results of a stop over a stretch. The relative displacement of a stop is that of its nodes.
fn see_stop<S: Float, Z: Size>(
    contact: &mut ContactCycle<S>,
    series: &Series<S, Z>,
    end: S,
    (j, sides, damping, is_shut): (usize, Sides<S>, S, bool),
) {
    let speed = series.speed_terms(sides.plus, sides.minus);
    let place = series.place_terms(sides.plus, sides.minus);
    contact.displacement = Scalar::max(contact.displacement, largest(&place, &speed, end));
    if !is_shut {
        return;
    }
    contact.stuck_fraction = contact.stuck_fraction + end * series.length;
    let dashpot = speed.map(|term| damping * term);
    let mut force = series.force_terms(j);
    for (order, term) in dashpot.iter().enumerate() {
        add(&mut force, order, *term);
    }
    contact.force = Scalar::max(contact.force, largest(&force, &slope(&force), end));
    contact.energy = contact.energy + work(&dashpot, &speed, series.length, end);
}

/// Returns the nodes of each contact, and the velocities of moving surfaces.
pub(super) fn sides<S: Float, Z: Size>(model: &Model<S, Z>) -> Z::Contacts<Sides<S>> {
    let nothing = Sides {
        plus: 0,
        minus: 0,
        speed: S::constant(0.0),
        damping: None,
    };
    let mut sides = model.size.contacts(nothing);
    for (sides, contact) in sides.as_mut().iter_mut().zip(model.contacts()) {
        *sides = contact.sides();
    }
    sides
}

/// Returns the largest absolute value of the polynomial `terms` between 0 and `end`. `slope` is its derivative, up to a
/// constant factor.
fn largest<S: Float>(terms: &Poly<S>, slope: &Poly<S>, end: S) -> S {
    let values = extremes(terms, slope, end).into_iter().map(Scalar::abs);
    values.fold(S::constant(0.0), Scalar::max)
}

/// Returns the values of the polynomial `terms` at 0, at `end`, and at the point between them where `slope` changes its
/// sign. `slope` is the derivative of the polynomial, up to a constant factor.
fn extremes<S: Float>(terms: &Poly<S>, slope: &Poly<S>, end: S) -> [S; 3] {
    let zero = S::constant(0.0);
    let first = slope.iter().find(|term| !term.is_zero());
    let rises = first.is_some_and(|term| *term > zero);
    let turn = first_negative(&slope.map(|term| if rises { term } else { -term }), 0);
    let turn = turn.map_or(end, |turn| Scalar::min(turn, end));
    [zero, end, turn].map(|at| value(terms, at))
}

/// Returns the integral of the polynomial `terms` from 0 to `end`.
pub(super) fn integral<S: Float>(terms: &[S], end: S) -> S {
    let terms = terms.iter().enumerate().rev();
    terms.fold(S::constant(0.0), |sum, (order, term)| {
        (sum + *term / S::whole(order + 1)) * end
    })
}

/// Returns the work of a force from the start of a time interval to the fraction `end`. `length` is the duration of
/// the interval.
pub(super) fn work<S: Float>(force: &[S], speed: &[S], length: S, end: S) -> S {
    let product = product(force, speed);
    let count = force.len() + speed.len();
    length * integral(product.get(..count).unwrap_or(&product), end)
}

/// Returns the coefficients of the product of the polynomials `a` and `b`.
fn product<S: Float>(a: &[S], b: &[S]) -> [S; 2 * TERMS] {
    let mut product = [S::constant(0.0); 2 * TERMS];
    // A load or a friction force on a straight line has only two coefficients.
    let a = a.iter().enumerate().filter(|(_, a)| !a.is_zero());
    for (i, a) in a {
        for (sum, b) in product.iter_mut().skip(i).zip(b) {
            *sum = *sum + *a * *b;
        }
    }
    product
}
