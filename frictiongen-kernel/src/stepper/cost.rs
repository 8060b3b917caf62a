//! What a step costs at most, counted from what it loops over.

use super::{MAX_EVENTS, MAX_STRETCHES};
use crate::simulation::WALK;

/// The sizes that the cost of a step follows from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extent {
    /// How many modes there are.
    pub modes: u64,
    /// How many of them the contact drives.
    pub driven: u64,
    /// How many inputs there are.
    pub inputs: u64,
    /// How many coefficients each has over a part.
    pub coefficients: u64,
    /// How many terms of a power series are formed.
    pub terms: u64,
    /// Into how many parts a step is cut.
    pub parts: u64,
    /// Whether the contact rubs on a moving base.
    pub on_moving_base: bool,
    /// Whether the friction law has lines beside the last: a second walk looks for the end of each.
    pub lines: bool,
}

/// Floating-point operations of a step: sums, products, quotients and comparisons.
///
/// `tables` and `most` are bounds by construction: no step by the tables and no step at all has more.
/// An emulated Cortex-M4F takes [`Cost::INSTRUCTIONS`] for each of them at most, beside [`Cost::FIXED`] a part, in
/// single precision and optimised for size; `scripts/firmware` checks it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cost {
    /// A step in which no part is looked through.
    pub tables: u64,
    /// A step with one event, every part but one by the tables, each of its walks in [`Cost::WALK`] evaluations.
    pub one_event: u64,
    /// Any step: in every part [`MAX_STRETCHES`] stretches, each walk with as many evaluations as it may have.
    pub most: u64,
}

impl Cost {
    /// Instructions an operation, at most.
    pub const INSTRUCTIONS: u64 = 4;
    /// Instructions a part beside those.
    pub const FIXED: u64 = 400;
    /// So many evaluations does a walk to an event usually have at most.
    pub const WALK: u64 = 8;

    /// From the sizes of a scene and its tables.
    #[must_use]
    pub const fn of(extent: &Extent) -> Self {
        let attempt = extent.attempt();
        let walks = if extent.lines { 2 } else { 1 };
        let usual = extent.stretch() + walks * Self::WALK * extent.evaluation();
        let longest = extent.stretch() + walks * WALK as u64 * extent.evaluation();
        let tables = extent.parts * attempt;
        Self {
            tables,
            // To the event and from there on, and what the contact does between.
            one_event: tables + 2 * usual + extent.event() + extent.held_force(),
            most: extent.parts
                * (attempt
                    + MAX_STRETCHES as u64 * longest
                    + MAX_EVENTS as u64 * extent.event()
                    + extent.stretch()
                    + extent.held_force()),
        }
    }
}

impl Extent {
    /// A part by the tables, or the attempt at it.
    const fn attempt(&self) -> u64 {
        let Self {
            modes,
            driven,
            inputs,
            coefficients: d,
            ..
        } = *self;
        let load = 2 * inputs * d;
        // The rows of a mode's table, the work, the bound on the bend.
        let mode = load + (d + 1) * (3 + 2 * d) + 4 * d + 30;
        let base = if self.on_moving_base { 8 * d } else { 0 };
        let held = 2 * load + base + 2 * d * (3 + 4 * d) + (5 * inputs + 9) * d + 30;
        let sliding = driven * mode;
        let sticking = (driven - 1) * held + self.still();
        let contact = if sliding < sticking {
            sticking
        } else {
            sliding
        };
        // Input, base, accounts of work.
        (modes - driven) * mode + contact + 80 + 6 * inputs * d
    }

    /// The force in the held contact without the held modes, and the work of the base that carries it.
    const fn still(&self) -> u64 {
        let d = self.coefficients;
        let base = if self.on_moving_base {
            40 + 10 * d * d
        } else {
            0
        };
        4 * self.inputs * d + 12 + base
    }

    /// The force in the held contact at the end of a part.
    const fn held_force(&self) -> u64 {
        self.still() + 2 * self.driven
    }

    /// One stretch of a part that is looked through, its walk left out.
    const fn stretch(&self) -> u64 {
        let Self {
            driven,
            inputs,
            coefficients: d,
            terms,
            ..
        } = *self;
        // The series: a mode's share of the function, its drive, its next coefficients.
        let base = if self.on_moving_base { 8 } else { 0 };
        let series = terms * (driven * (16 + base) + 14) + d * driven * 4 * inputs;
        // The oscillators moved on by their moments, and the inputs seen from there.
        let moved = driven * (terms * (14 + 7 * d) + (8 * inputs + 9) * d + 12);
        let rest = 4 * terms + (inputs + 1) * d * d + 60;
        let on_base = if self.on_moving_base { 50 + 20 * d } else { 0 };
        // The bound on the third derivative.
        series + moved + rest + on_base + 8 * terms
    }

    /// One evaluation of a walk: the series and two derivatives, and how far the next step goes.
    const fn evaluation(&self) -> u64 {
        // Twelve steps of Newton's method, with a square root.
        6 * self.terms + 12 * 14 + 120
    }

    /// From sliding to sticking or back: each oscillator of one kind from all of the other.
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
        inputs: 1,
        coefficients: 4,
        terms: 5,
        parts: 1,
        on_moving_base: true,
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
            Extent { terms: 6, ..TWO },
            Extent { parts: 2, ..TWO },
            Extent { lines: true, ..TWO },
        ] {
            let cost = Cost::of(&more);
            assert!(cost.tables >= of.tables && cost.most > of.most, "{more:?}");
        }
    }

    #[test]
    fn parts_multiply() {
        let parts = Extent { parts: 7, ..TWO };
        let (one, seven) = (Cost::of(&TWO), Cost::of(&parts));
        assert_eq!((7 * one.tables, 7 * one.most), (seven.tables, seven.most));
    }
}
