//! Upper bounds on the cost of a step, in floating-point operations.

use super::{MAX_STEP_EVENTS, Stepper, coast, table::Layout};
use crate::Float;
use crate::joints::MAX_PATTERNS;
use crate::joints::poly::terms_of;
use crate::joints::roots::halvings;
use crate::joints::size::Size;
use crate::stepper::Cost;

/// Lengths of the loops in a step.
struct Extent {
    layout: Layout,
    /// Number of springs and dashpots.
    links: u64,
    /// Number of entries in the damping matrix.
    damping: u64,
    /// Number of terms of a power series.
    terms: u64,
    /// Largest number of bisections in a search for an event.
    halvings: u64,
}

impl Extent {
    /// Returns the cost of a sub-interval by the tables.
    fn leap(&self) -> u64 {
        let layout = &self.layout;
        let [masses, contacts, loads] =
            [layout.masses, layout.contacts, layout.loads].map(|count| count as u64);
        let count = layout.coordinates() as u64;
        let rows = layout.moments() as u64 + 5 * contacts;
        let increments = 2 * masses * layout.width() as u64;
        let shears = if layout.shears {
            masses * (3 * masses + contacts) + 8 * masses + 6 * contacts
        } else {
            0
        };
        let watched = contacts * (3 * count + 60);
        let inputs = 2 * (4 * loads + 8 * contacts + 30);
        let rest = watched + inputs + 8 * masses + 20 * (loads + contacts) + 40;
        2 * (count * rows + increments + shears) + rest
    }

    /// Returns the cost of the forces and accelerations at one instant.
    fn forces(&self) -> u64 {
        let (masses, contacts) = (self.layout.masses as u64, self.layout.contacts as u64);
        5 * self.links
            + 3 * self.damping
            + 6 * masses
            + 8 * contacts
            + self.layout.loads as u64
            + 10
    }

    /// Returns the cost of a piece of motion between two events without the search for its end: its power series, the
    /// motion at its end, and its work.
    fn piece(&self) -> u64 {
        let layout = &self.layout;
        let (masses, contacts) = (layout.masses as u64, layout.contacts as u64);
        let nodes = masses + 2;
        let series = self.terms * (self.forces() + 4 * nodes + 4 * contacts);
        let motion = 4 * self.terms * (2 * masses + contacts);
        let products = layout.loads as u64 * 6 * self.terms + contacts * 6 * self.terms;
        let base = if layout.on_base {
            3 * self.terms * self.terms + 6 * self.terms * nodes
        } else {
            0
        };
        series + motion + products + base + 20 * contacts
    }

    /// Returns an upper bound on the cost of the search for an event. A polynomial of n terms has at most n − 1 real and
    /// complex roots near the interval. Near each root the search divides the interval at most `halvings` times, and
    /// looks at two halves after each division.
    fn search(&self) -> u64 {
        let (terms, contacts) = (self.terms, self.layout.contacts as u64);
        let divide = 3 * terms * terms;
        2 * contacts * (2 * self.halvings * terms * divide + 10 * terms)
    }

    /// Returns the usual cost of the search for an event: a test of each limit, and one bisection.
    fn usual_search(&self) -> u64 {
        let (terms, contacts) = (self.terms, self.layout.contacts as u64);
        2 * contacts * (terms * terms + 2 * terms * self.halvings)
    }

    /// Returns an upper bound on the cost of a decision which contacts stick.
    fn decision(&self) -> u64 {
        let contacts = u32::try_from(self.layout.contacts).unwrap_or(u32::MAX);
        let patterns = 3_u64.saturating_pow(contacts).min(MAX_PATTERNS as u64);
        2 * self.forces() + patterns.saturating_mul(self.forces() + 12 * u64::from(contacts))
    }
}

impl<S: Float, Z: Size, T: AsRef<[S]>> Stepper<S, Z, T> {
    /// Returns the cost of a step, in floating-point operations. A step without a search costs at most `tables`. `most` is
    /// an upper bound by construction: it counts the longest search for each event, which is far longer than any that
    /// was measured. On an emulated Cortex-M4F, in `f32` and optimised for size, an operation takes at most 8
    /// instructions.
    pub fn cost(&self) -> Cost {
        let model = self.motion.model();
        let links = model.springs.as_ref().len() + model.dashpots.as_ref().len();
        let extent = Extent {
            layout: self.layout,
            links: links as u64,
            damping: model.damping.as_ref().len() as u64,
            terms: terms_of::<S>() as u64,
            halvings: u64::from(halvings::<S>()),
        };
        let parts = u64::from(self.pace.parts);
        let (leap, piece, decision) = (extent.leap(), extent.piece(), extent.decision());
        let budget = match u64::from(self.status.budget) {
            0 => MAX_STEP_EVENTS as u64,
            budget => budget,
        };
        // An event ends a piece. Beyond the budget, one more piece ends the sub-interval without a search.
        let pieces = coast::PIECES as u64 + coast::PIECES_PER_EVENT as u64 * budget;
        let masses = model.wall() as u64;
        Cost {
            tables: parts * leap,
            one_event: parts * leap + 2 * (piece + extent.usual_search()) + decision,
            most: parts * (leap + (pieces + 1) * (piece + extent.search() + decision)),
            masses: 4 * masses,
        }
    }
}
