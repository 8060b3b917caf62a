//! One period of a motion as a map of the unknowns of a steady state. Searches outside this crate use it, such as one
//! that follows a steady state along a parameter.

use super::heap::Heap;
use super::run::Motion;
use super::steady::{Search, Steady};
use super::tangent::ShotSpan;
use crate::errors::Halt;

/// The map from the unknowns at the start of a period to those at its end.
///
/// The unknowns are displacements and velocities of the masses, and the positions of the contacts that slide in the
/// period. Displacements and positions are divided by the size of the displacements, and velocities by this size times
/// ω.
pub struct Period {
    search: Search<f64, Heap>,
    span: ShotSpan,
}

/// A motion over one period.
pub struct Mapped {
    /// The unknowns at the start.
    pub from: Vec<f64>,
    /// The unknowns at the end.
    pub to: Vec<f64>,
    /// Derivatives of the unknowns at the end with respect to those at the start, column by column. The list is empty if
    /// they were not requested.
    pub derivatives: Vec<f64>,
    /// The motion at the end.
    pub end: Motion<f64, Heap>,
}

impl Period {
    /// Prepares the map of a motion under a load of the angular frequency ω. `cycles` is the length of the period in
    /// cycles of the load, and `size` is that of the displacements.
    #[must_use]
    pub fn new(motion: &Motion<f64, Heap>, omega: f64, (cycles, size): (usize, f64)) -> Self {
        Self {
            search: Search::new(motion, omega, size),
            span: ShotSpan::Cycles(cycles),
        }
    }

    /// Prepares the map over half a cycle, after which all signs are changed. A symmetric motion has the opposite sign
    /// half a cycle later, so that this map leads it back to its start. The positions of all contacts are unknowns.
    #[must_use]
    pub fn half(motion: &Motion<f64, Heap>, omega: f64, size: f64) -> Self {
        let mut search = Search::new(motion, omega, size);
        search.moving.fill(true);
        Self {
            search,
            span: ShotSpan::Half,
        }
    }

    /// Follows a motion over one period, which starts at a maximum of the load.
    ///
    /// # Errors
    ///
    /// [`Halt`] if the motion exceeds a bound.
    pub fn map(&mut self, start: &Motion<f64, Heap>, derives: bool) -> Result<Mapped, Halt> {
        let shot = self.search.shoot(start, self.span, derives)?;
        if self.span != ShotSpan::Half {
            self.search.moving = shot.moving;
        }
        let unknowns = self.search.unknowns();
        Ok(Mapped {
            from: unknowns.read(start),
            to: unknowns.read(&shot.end),
            derivatives: shot.derivatives.unwrap_or_default(),
            end: shot.end,
        })
    }

    /// Returns a motion that starts with the given unknowns. A contact that did not slide in the last period keeps its
    /// position, or the force of its spring.
    #[must_use]
    pub fn start(&self, motion: &Motion<f64, Heap>, unknowns: &Vec<f64>) -> Motion<f64, Heap> {
        self.search.unknowns().write(motion, unknowns)
    }

    /// Returns true for each contact that slides in the last period, so that its position is an unknown.
    #[must_use]
    pub fn moving(&self) -> &[bool] {
        &self.search.moving
    }

    /// Sets which contacts slide in a whole period, as known from a neighbouring motion.
    pub fn set_moving(&mut self, moving: &[bool]) {
        if self.span != ShotSpan::Half {
            self.search.moving = moving.iter().copied().collect();
        }
    }

    /// Returns the steady state of a motion that repeats after the period. `derivatives` are those of the map.
    ///
    /// # Errors
    ///
    /// [`Halt`] if the motion exceeds a bound.
    pub fn steady(
        &mut self,
        start: Motion<f64, Heap>,
        mut derivatives: Vec<f64>,
    ) -> Result<Steady<f64, Heap>, Halt> {
        self.search.found(start, &mut derivatives, self.span)
    }
}
