//! Upper bounds on the cost of a step, in floating-point operations: sums, products, quotients, roots and comparisons.
//!
//! Each method bounds one part of a step. Its factors count the operations of the loops in that part, and tests compare
//! the bounds with counted operations.

use super::coast::{LIMITS, pieces};
use super::table::{Layout, ROWS};
use super::{MAX_STEP_EVENTS, Stepper};
use crate::Float;
use crate::joints::MAX_PATTERNS;
use crate::joints::decide::all_patterns;
use crate::joints::roots::{NEWTON, halvings};
use crate::joints::size::Size;
use crate::stepper::{Cost, Input};

/// Lengths of the loops in a step.
struct Extent {
    layout: Layout,
    /// Number of contacts that may be rigid in a decision.
    rigid: usize,
    /// Number of springs and dashpots.
    links: u64,
    /// Number of entries in the damping matrix.
    damping: u64,
    /// Number of points of the friction law.
    points: u64,
    /// Number of terms of a power series.
    terms: u64,
    /// Largest number of bisections in a search for an event.
    halvings: u64,
    /// Largest number of divisions in the search for one event, and of patterns in a decision.
    limits: [u64; 2],
}

impl Extent {
    fn masses(&self) -> u64 {
        self.layout.masses as u64
    }

    fn nodes(&self) -> u64 {
        self.masses() + 2
    }

    fn contacts(&self) -> u64 {
        self.layout.contacts as u64
    }

    fn loads(&self) -> u64 {
        self.layout.loads as u64
    }

    /// Returns the cost of the displacements and velocities of all nodes at one instant.
    fn at_instant(&self) -> u64 {
        if self.layout.on_base { 40 } else { 4 }
    }

    /// Returns the cost of a sub-interval by the tables.
    fn leap(&self) -> u64 {
        let layout = &self.layout;
        let (masses, contacts, loads) = (self.masses(), self.contacts(), self.loads());
        let count = layout.coordinates() as u64;
        let rows = layout.moments() as u64 + (ROWS as u64 + 1) * contacts;
        let increments = 2 * masses * layout.width() as u64;
        let shears = if layout.shears {
            masses * (3 * masses + contacts) + 5 * masses + 2 * contacts
        } else {
            0
        };
        let products = 2 * (count * rows + increments + shears);
        // The limits of the contacts, the inputs at both ends, and their work.
        products + 100 * contacts + 24 * loads + 4 * masses + 2 * self.at_instant() + 80
    }

    /// Returns the cost of the forces and accelerations of one order, or at one instant.
    fn forces(&self) -> u64 {
        let (contacts, nodes) = (self.contacts(), self.nodes());
        let law = if self.points == 0 {
            0
        } else {
            contacts * (3 * self.terms + 4 * self.points + 40)
        };
        4 * self.links + 3 * self.damping + self.loads() + 14 * contacts + 5 * nodes + law
    }

    /// Returns the cost of a power series and of the motion at its end.
    fn series(&self) -> u64 {
        let (contacts, nodes, terms) = (self.contacts(), self.nodes(), self.terms);
        let order = self.forces() + 2 * nodes + 4 * contacts + 1;
        let inputs = 3 * self.at_instant() + 10 * self.loads() + 24 * contacts + 3 * terms + 20;
        let motion = (2 * self.masses() + contacts) * (2 * terms + 4);
        inputs + terms * order + motion
    }

    /// Returns the cost of the work in a piece of motion.
    fn work(&self) -> u64 {
        let (contacts, terms) = (self.contacts(), self.terms);
        let reaction = if self.layout.on_base {
            2 * terms * (2 * self.links + 2 * self.damping + contacts) + 20 * terms + 60
        } else {
            0
        };
        let product = 14 * terms + 20;
        let contact = if self.points == 0 {
            product
        } else {
            2 * terms * terms + product
        };
        reaction + self.loads() * product + contacts * (contact + terms)
    }

    /// Returns the cost of a bisection after the steps of Newton's method.
    fn bisection(&self) -> u64 {
        let value = 2 * self.terms + 8;
        NEWTON as u64 * (2 * value + 12) + 2 * value + (self.halvings + 8) * value
    }

    /// Returns the cost of the search for the next event. All contacts together have `divisions` divisions of an interval,
    /// and each division is followed by at most one step back to a larger interval.
    fn search(&self) -> u64 {
        let (terms, contacts) = (self.terms, self.contacts());
        // The signs of the terms, two lower bounds of degree 5, the slope, and a Bernstein form.
        let polynomial = 20 * terms + 100 + terms * terms + self.bisection();
        let lines = if self.points == 0 { 0 } else { 2 };
        let [divisions, _] = self.limits;
        let division = terms * (terms + 6) + 16;
        contacts * ((2 + lines) * polynomial + 8 * terms + 12 * self.points + 40)
            + divisions.saturating_mul(division)
    }

    /// Returns the usual cost of the search for an event: a test of each limit, and one root.
    fn usual_search(&self) -> u64 {
        self.contacts() * (24 * self.terms + 100) + self.bisection() / 2
    }

    /// Returns the cost of a decision with the given number of patterns.
    fn decision(&self, patterns: u64) -> u64 {
        let (contacts, nodes) = (self.contacts(), self.nodes());
        let pattern = 6 * nodes + 20 * contacts;
        let known = 2 * self.forces() + self.links * 2 + self.damping + 40 * contacts;
        known + 12 * nodes + 3 * self.at_instant() + patterns.saturating_mul(pattern)
    }

    /// Returns the largest number of patterns that a decision tries. A decision tries the first pattern, then at most all
    /// patterns by Murty's rule, and then all patterns in their order. It first requires that contacts which have broken
    /// away slide. If no pattern fits, it tries all of these again without this condition.
    fn patterns(&self) -> u64 {
        let [_, limit] = self.limits;
        let all = all_patterns(self.rigid) as u64;
        let once = all.saturating_add(1 + all.min(64 * self.rigid as u64));
        if self.rigid == 0 {
            return 1;
        }
        1 + once.saturating_mul(2).min(limit)
    }

    /// Returns the cost of the inputs of a step. Friction forces that do not jump need no decision.
    fn inputs(&self) -> u64 {
        let jolts = self.layout.on_base && self.layout.input == Input::Hold;
        let jolt = if jolts {
            let energies = 2 * (4 * self.masses() + 5 * self.links + 2 * self.forces());
            energies + self.decision(self.patterns()) + 40
        } else {
            0
        };
        jolt + 8 * self.loads() + 8 * self.contacts() + 40
    }

    /// Returns the cost of the rule that ends a sub-interval without a search.
    fn coast(&self) -> u64 {
        let rest = 10 * self.contacts() + 8 * self.nodes() + 2 * self.at_instant();
        self.series() + self.work() + rest
    }
}

impl<S: Float, Z: Size, T: AsRef<[S]>> Stepper<S, Z, T> {
    /// Returns the cost of a step, in floating-point operations. A step without a search costs at most `tables`, if no
    /// friction force starts, ends or jumps. `most` is an upper bound for any step. With an event budget, it counts a
    /// bounded search and a bounded decision for each piece of motion between events. On an emulated Cortex-M4F, in
    /// `f32` and optimised for size, an operation takes at most 8 instructions.
    pub fn cost(&self) -> Cost {
        let model = self.motion.model();
        let halvings = u64::from(halvings::<S>());
        let has_law = !model.law.as_ref().is_empty();
        let degree = if self.pace.on_base { 3 } else { 2 };
        let terms = model.terms_within(self.pace.part, degree) as u64;
        let budget = usize::from(self.status.budget);
        let (events, limits) = match budget {
            // In each depth the search divides fewer intervals than the polynomial has terms, and computes each again from
            // the whole interval.
            0 => (
                MAX_STEP_EVENTS,
                [terms * halvings * (halvings + 1), MAX_PATTERNS as u64],
            ),
            budget => (
                budget,
                [u64::from(LIMITS.divisions), LIMITS.patterns as u64],
            ),
        };
        let rigid = model.contacts().iter().filter(|own| own.is_rigid());
        let extent = Extent {
            layout: self.layout,
            rigid: rigid.count(),
            links: (model.springs.as_ref().len() + model.dashpots.as_ref().len()) as u64,
            damping: model.damping.as_ref().len() as u64,
            points: model.law.as_ref().len() as u64,
            terms,
            halvings,
            limits,
        };
        let parts = u64::from(self.pace.parts);
        let tables = extent.inputs() + parts * extent.leap();
        let piece = extent.series() + extent.work();
        let decision = extent.decision(extent.patterns());
        let pieces = pieces(events, has_law) as u64;
        let event = extent
            .search()
            .saturating_add(decision)
            .saturating_add(piece);
        let part = pieces.saturating_mul(event).saturating_add(extent.coast());
        let frictions = extent.contacts().saturating_mul(decision + 20);
        Cost {
            tables,
            one_event: tables + 2 * (piece + extent.usual_search()) + extent.decision(4),
            most: parts
                .saturating_mul(part)
                .saturating_add(tables + frictions),
            masses: 4 * extent.masses(),
        }
    }
}
