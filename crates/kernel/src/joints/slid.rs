//! Observers of a motion that detect which contacts slide, count events, or measure displacements.

use super::cycle::{integral, least_slip, sides};
use super::model::{Model, Sides};
use super::run::Observe;
use super::series::Series;
use super::size::{Size, add, at, set};
use super::state::State;
use super::table::Leap;
use crate::{Float, Scalar};

/// Observer of a motion. It detects whether any contact slides.
pub(super) struct Slid<S: Float, Z: Size> {
    sides: Z::Contacts<Sides<S>>,
    /// True if some contact has slid farther than rounding errors can cause.
    pub(super) slides: bool,
    scalar: core::marker::PhantomData<S>,
}

impl<S: Float, Z: Size> Slid<S, Z> {
    /// Starts to observe whether the contacts of a chain slide.
    pub(super) fn new(model: &Model<S, Z>) -> Self {
        Self {
            sides: sides(model),
            slides: false,
            scalar: core::marker::PhantomData,
        }
    }
}

impl<S: Float, Z: Size> Observe<S, Z> for Slid<S, Z> {
    const NEEDS_SERIES: bool = false;

    fn leap(&mut self, leap: &Leap<'_, S, Z>) {
        let phases = leap.state.phases.as_ref().iter().zip(self.sides.as_ref());
        for (_, &own) in phases.filter(|(phase, _)| phase.abs() == 1) {
            let (before, after) = leap.places((own.plus, own.minus));
            self.slides |= (after - before).abs() > least_slip(after.abs());
        }
    }

    fn stretch(&mut self, series: &Series<S, Z>, end: S, state: &State<S, Z>) {
        let phases = state.phases.as_ref().iter().zip(self.sides.as_ref());
        for (_, &own) in phases.filter(|(phase, _)| phase.abs() == 1) {
            let slip = series.length * integral(&series.slip_terms(own), end).abs();
            let place = series.place((own.plus, own.minus), end).abs();
            self.slides |= slip > least_slip(place);
        }
    }
}

/// Observer of a period. It measures how far each contact slides.
pub(super) struct Slips<S: Float, Z: Size> {
    sides: Z::Contacts<Sides<S>>,
    slips: Z::Contacts<S>,
    /// Largest absolute relative displacement of each contact, at the starts of the stretches (time intervals of one
    /// power series).
    places: Z::Contacts<S>,
}

impl<S: Float, Z: Size> Slips<S, Z> {
    /// Starts to measure how far the contacts of a chain slide.
    pub(super) fn new(model: &Model<S, Z>) -> Self {
        let zero = S::constant(0.0);
        Self {
            sides: sides(model),
            slips: model.size.contacts(zero),
            places: model.size.contacts(zero),
        }
    }

    /// Returns, for each contact, true if the contact has slid farther than rounding errors can cause.
    pub(super) fn slides(&self, model: &Model<S, Z>) -> Z::Contacts<bool> {
        self.slides_in(model, 1)
    }

    /// Returns the same as [`slides`](Self::slides) for a number of periods, in each of which rounding may move a
    /// contact whose force only reaches its limit.
    pub(super) fn slides_in(&self, model: &Model<S, Z>, periods: usize) -> Z::Contacts<bool> {
        let mut slides = model.size.contacts(false);
        for (j, slides) in slides.as_mut().iter_mut().enumerate() {
            let place = at(self.places.as_ref(), j);
            *slides = at(self.slips.as_ref(), j) > S::whole(periods) * least_slip(place);
        }
        slides
    }
}

impl<S: Float, Z: Size> Observe<S, Z> for Slips<S, Z> {
    const NEEDS_SERIES: bool = false;

    fn leap(&mut self, leap: &Leap<'_, S, Z>) {
        let phases = leap.state.phases.as_ref().iter().zip(self.sides.as_ref());
        for (j, (phase, &own)) in phases.enumerate() {
            let (before, after) = leap.places((own.plus, own.minus));
            let most = Scalar::max(before.abs(), at(self.places.as_ref(), j));
            set(self.places.as_mut(), j, most);
            if phase.abs() == 1 {
                add(self.slips.as_mut(), j, (after - before).abs());
            }
        }
    }

    fn stretch(&mut self, series: &Series<S, Z>, end: S, state: &State<S, Z>) {
        let phases = state.phases.as_ref().iter().zip(self.sides.as_ref());
        for (j, (phase, &own)) in phases.enumerate() {
            let place = |node| series.displacement_at_start(node);
            let place = (place(own.plus) - place(own.minus)).abs();
            let most = Scalar::max(place, at(self.places.as_ref(), j));
            set(self.places.as_mut(), j, most);
            if phase.abs() == 1 {
                let speed = series.slip_terms(own);
                let slip = series.length * integral(&speed, end);
                add(self.slips.as_mut(), j, slip.abs());
            }
        }
    }
}

/// Observer of a motion that counts the events.
pub(super) struct Count(pub(super) u32);

impl<S: Float, Z: Size> Observe<S, Z> for Count {
    const NEEDS_SERIES: bool = false;

    fn stretch(&mut self, _: &Series<S, Z>, _: S, _: &State<S, Z>) {}

    fn event(&mut self, _: S, _: &Z::Contacts<i8>, _: &Z::Contacts<i8>) {
        self.0 += 1;
    }
}

/// Observer of a motion. It measures the largest displacement of all masses at the starts of the stretches (time
/// intervals of one power series).
pub(super) struct LargestDisplacement<S>(pub(super) S);

impl<S: Float, Z: Size> Observe<S, Z> for LargestDisplacement<S> {
    const NEEDS_SERIES: bool = false;

    fn leap(&mut self, leap: &Leap<'_, S, Z>) {
        let displacements = leap.before.iter().take(leap.state.x.as_ref().len());
        self.0 = displacements.fold(self.0, |most, x| Scalar::max(most, x.abs()));
    }

    fn stretch(&mut self, series: &Series<S, Z>, _: S, state: &State<S, Z>) {
        for mass in 0..state.x.as_ref().len() {
            self.0 = Scalar::max(self.0, series.displacement_at_start(mass).abs());
        }
    }
}
