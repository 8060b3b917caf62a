//! Upper bounds on the cost of a step, in floating-point operations. The module computes them from the lengths of the
//! loops in a step.

use super::{MAX_EVENTS, MAX_STRETCHES};
use crate::motion::WALK;

/// Largest number of evaluations of the contact's velocity or force in one search for an event, if the step has an
/// event budget.
pub(super) const SEARCH: u32 = 12;
/// Cost of the rule that ends a sub-interval without a search for events, as a number of pieces of motion between
/// events. In a chain of up to 64 masses, the rule costs at most as much as these pieces.
pub(super) const RULE: u32 = 4;
/// Largest number of pieces of motion before an event, if the step has an event budget and the friction force depends
/// on the speed.
pub(super) const PIECES: u32 = 4;

/// Numbers of modes, inputs and table entries of a scene, from which the code computes the cost of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extent {
    /// Number of modes of the chain.
    pub modes: u64,
    /// Number of modes that the contact drives.
    pub driven: u64,
    /// Number of modes that the chain loses when its contact sticks.
    pub lost: u64,
    /// Number of inputs of the stepper.
    pub inputs: u64,
    /// Number of coefficients of an input's polynomial over a sub-interval.
    pub coefficients: u64,
    /// Number of terms of a power series of the motion.
    pub terms: u64,
    /// Number of sub-intervals into which the stepper divides a step.
    pub parts: u64,
    /// True if the contact rubs on a moving base.
    pub on_moving_base: bool,
    /// True if damping acts relative to the moving base.
    pub damped_from_base: bool,
    /// True if the friction law consists of at least two straight lines over the speed. After the search for a stop, a
    /// second search then finds the instant at which the speed reaches the end of a line.
    pub lines: bool,
}

/// Cost of one step of a stepper, in floating-point operations: sums, products, quotients and comparisons.
///
/// The fields `tables` and `most` are upper bounds by construction. A step that uses only the constant tables costs at
/// most `tables`, and any step costs at most `most`. On an emulated Cortex-M4F, in single precision and optimised for
/// size, an operation takes at most [`Cost::INSTRUCTIONS`] instructions. A sub-interval takes at most [`Cost::FIXED`]
/// additional instructions. `scripts/firmware` checks these bounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cost {
    /// Cost of a step without a search for events, in floating-point operations.
    pub tables: u64,
    /// Cost of a step with one event, in floating-point operations. The estimate assumes [`Cost::WALK`] evaluations in
    /// each search, and constant tables in all sub-intervals without an event.
    pub one_event: u64,
    /// Upper bound on the cost of any step, in floating-point operations. Without an event budget, the bound assumes
    /// [`MAX_STRETCHES`] pieces of motion in every sub-interval, and the largest permitted number of evaluations in
    /// each search. With a budget of n events, the bound assumes searches for n + 1 events in every sub-interval, with
    /// [`Cost::SEARCH`] evaluations each.
    pub most: u64,
    /// Upper bound on the cost of reading the motions of all masses after a step, in floating-point operations.
    pub masses: u64,
}

impl Cost {
    /// Largest number of processor instructions for one floating-point operation.
    pub const INSTRUCTIONS: u64 = 4;
    /// Largest number of processor instructions in a sub-interval that are not floating-point operations.
    pub const FIXED: u64 = 400;
    /// Number of evaluations of the contact's velocity or force that a search for one event usually does not exceed.
    pub const WALK: u64 = 8;
    /// Largest number of evaluations of the contact's velocity or force in one search for an event, if the step has an
    /// event budget.
    pub const SEARCH: u64 = SEARCH as u64;

    /// Computes the cost of a step with a budget of `budget` events. If `budget` is 0, the step has no budget.
    pub(super) const fn within(extent: &Extent, budget: u8) -> Self {
        let of = Self::of(extent);
        if budget == 0 {
            return of;
        }
        let (walks, pieces) = if extent.lines {
            (2, PIECES as u64)
        } else {
            (1, 1)
        };
        let events = budget as u64 + 1;
        let piece = extent.stretch() + walks * Self::SEARCH * extent.evaluation();
        let part = events * (pieces * piece + extent.event()) + extent.rest() + extent.held_force();
        Self {
            most: of.tables + extent.parts * part,
            ..of
        }
    }

    /// Computes the cost of a step without an event budget, from the sizes of a scene and its tables.
    #[must_use]
    pub const fn of(extent: &Extent) -> Self {
        let attempt = extent.attempt();
        let walks = if extent.lines { 2 } else { 1 };
        let usual = extent.stretch() + walks * Self::WALK * extent.evaluation();
        let longest = extent.stretch() + walks * WALK as u64 * extent.evaluation();
        let tables = extent.parts * attempt;
        Self {
            tables,
            // A step with one event consists of a piece before the event, the event itself, and a piece after the
            // event.
            one_event: tables + 2 * usual + extent.event() + extent.held_force(),
            most: extent.parts
                * (attempt
                    + (MAX_STRETCHES - RULE) as u64 * longest
                    + larger(RULE as u64 * longest, extent.rest())
                    + MAX_EVENTS as u64 * extent.event()
                    + extent.stretch()
                    + extent.held_force()),
            masses: extent.masses(),
        }
    }
}

/// Returns the larger of two costs.
const fn larger(one: u64, other: u64) -> u64 {
    if one < other { other } else { one }
}

impl Extent {
    /// Returns the cost of advancing one sub-interval with the constant tables. The stepper tries the tables first,
    /// even in a sub-interval with an event.
    const fn attempt(&self) -> u64 {
        let Self {
            modes,
            driven,
            inputs,
            coefficients: d,
            ..
        } = *self;
        let load = 2 * inputs * d;
        // The cost of a mode consists of the rows of its table, the work, and the bound on the second derivative.
        let mode = load + (d + 1) * (3 + 2 * d) + 4 * d + 30;
        let base = if self.on_moving_base { 8 * d } else { 0 };
        let held = 2 * load + base + 2 * d * (3 + 4 * d) + (5 * inputs + 9) * d + 30;
        let sliding = driven * mode;
        let sticking = (driven - self.lost) * held + self.still();
        let contact = larger(sliding, sticking);
        // The work of the damping load needs another loop over all modes.
        let reaction = if self.damped_from_base {
            modes * (mode + 10) + 2 * d * d + 80
        } else {
            0
        };
        // The constants are the cost of the inputs, the base and the work.
        (modes - driven) * mode + contact + 80 + 6 * inputs * d + reaction
    }

    /// Returns the cost of computing the component of the stuck contact's force that the inputs and the base cause. The
    /// cost includes the work of the base on which the contact sticks.
    const fn still(&self) -> u64 {
        let d = self.coefficients;
        let base = if self.on_moving_base {
            40 + 10 * d * d
        } else {
            0
        };
        4 * self.inputs * d + 12 + base
    }

    /// Returns the cost of the force in the stuck contact at the end of a sub-interval.
    const fn held_force(&self) -> u64 {
        self.still() + 2 * self.driven
    }

    /// Returns the cost of one piece of motion between events, without the search for its end.
    const fn stretch(&self) -> u64 {
        let Self {
            driven,
            inputs,
            coefficients: d,
            terms,
            ..
        } = *self;
        // The cost of the power series consists of three parts for each mode: its term in the series, its drive, and
        // its next coefficients.
        let base = if self.on_moving_base { 8 } else { 0 };
        let series = terms * (driven * (16 + base) + 14) + d * driven * 4 * inputs;
        // The oscillators advance by integrals (moments). The code then moves the origin of the inputs' polynomials to
        // the end of the piece.
        let reaction = if self.damped_from_base { 4 * d + 2 } else { 0 };
        let moved = driven * (terms * (14 + 7 * d) + (8 * inputs + 9) * d + 12 + reaction);
        let rest = 4 * terms + (inputs + 1) * d * d + 60;
        let on_base = if self.on_moving_base { 50 + 20 * d } else { 0 };
        // The summand 8 · terms is the cost of the bound on the third derivative.
        series + moved + rest + on_base + 8 * terms
    }

    /// Returns the cost of the rule that ends a sub-interval without a search. The rule computes the force in the stuck
    /// contact, two power series, their integrals and a piece of motion. The rule changes the contact once to sliding
    /// and once to sticking.
    const fn rest(&self) -> u64 {
        let changes = 2 * self.event() + self.held_force();
        2 * self.stretch() + changes + 12 * self.terms + 4 * self.driven + 40
    }

    /// Returns the cost of computing the motions of all masses. If the contact sticks, the code first computes the
    /// modes of the chain from the modes of the stuck chain. The code then multiplies the mode shapes by the modes.
    const fn masses(&self) -> u64 {
        let Self {
            modes,
            driven,
            lost,
            ..
        } = *self;
        driven * (12 * (driven - lost) + 12) + modes * (4 * modes + 4)
    }

    /// Returns the cost of one evaluation of a power series in a search for an event. The evaluation computes the
    /// series, two derivatives, and the length of the search's next step.
    const fn evaluation(&self) -> u64 {
        // The length of the next step needs at most twelve steps of Newton's method and one square root.
        6 * self.terms + 12 * 14 + 120
    }

    /// Returns the cost of a change between sliding and sticking. The state of each oscillator after the change is a
    /// sum over all oscillators before the change.
    const fn event(&self) -> u64 {
        self.driven * (8 * self.driven + 2 * self.inputs + 12) + 40
    }
}

#[cfg(test)]
mod tests {
    use super::{Cost, Extent};

    const TWO: Extent = Extent {
        modes: 2,
        driven: 2,
        lost: 1,
        inputs: 1,
        coefficients: 4,
        terms: 5,
        parts: 1,
        on_moving_base: true,
        damped_from_base: false,
        lines: false,
    };

    #[test]
    fn more_of_anything_costs_more() {
        let of = Cost::of(&TWO);
        assert!(of.tables < of.one_event && of.one_event < of.most, "{of:?}");
        for more in [
            Extent { modes: 3, ..TWO },
            Extent {
                modes: 3,
                driven: 3,
                ..TWO
            },
            Extent { inputs: 2, ..TWO },
            Extent {
                damped_from_base: true,
                ..TWO
            },
            Extent { terms: 6, ..TWO },
            Extent { parts: 2, ..TWO },
            Extent { lines: true, ..TWO },
        ] {
            let cost = Cost::of(&more);
            assert!(cost.tables >= of.tables && cost.most > of.most, "{more:?}");
        }
    }

    /// Checks the cost of the rule that ends a sub-interval. The bound on any step counts RULE pieces of motion for
    /// this rule, so that the rule must cost no more than these pieces.
    #[test]
    fn the_rule_costs_no_more_than_its_pieces() {
        for driven in 1..=64 {
            for terms in [3, 8, 20] {
                let of = Extent {
                    modes: driven,
                    driven,
                    terms,
                    ..TWO
                };
                let longest = of.stretch() + u64::from(crate::motion::WALK) * of.evaluation();
                assert!(of.rest() <= u64::from(super::RULE) * longest, "{of:?}");
            }
        }
    }

    #[test]
    fn a_budget_bounds_the_cost() {
        let without = Cost::of(&TWO);
        let of = [1, 2, 4].map(|budget| Cost::within(&TWO, budget).most);
        assert!(of[0] < of[1] && of[1] < of[2] && 20 * of[2] < without.most);
        assert_eq!(Cost::within(&TWO, 0), without);
        assert!(without.one_event < of[0]);
    }

    #[test]
    fn parts_multiply() {
        let parts = Extent { parts: 7, ..TWO };
        let (one, seven) = (Cost::of(&TWO), Cost::of(&parts));
        assert_eq!((7 * one.tables, 7 * one.most), (seven.tables, seven.most));
    }
}
