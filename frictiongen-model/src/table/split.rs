//! Where a table must be split, and where it must be looked at closely.

use super::zeros::{Zeros, contact_modes};
use crate::modal::Modal;
use frictiongen_kernel::number::dd::Dd;

/// A zero of β_lim, in two parts.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    pub at: f64,
    pub rest: f64,
}

impl Edge {
    fn new(at: Dd) -> Self {
        let high = at.to_f64();
        let rest = (at - Dd::from(high)).to_f64();
        Self { at: high, rest }
    }

    /// How far r lies above it.
    pub fn distance(&self, r: f64) -> f64 {
        (r - self.at) - self.rest
    }
}

/// How far beside a place of interest a table is looked at, relative to it.
const BESIDE: [f64; 13] = [
    0.0, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-6, 1e-5, 1e-4, 1e-3, 3e-3, 1e-2,
];
/// A zero of β_lim counts when it is no farther outside the range than this share of r.
const OUTSIDE: f64 = 1e-2;
/// A mode whose damping takes this much of the motion within a half period leaves no narrow trace.
const BROAD: f64 = 0.5;
/// No more sub-harmonics are looked at than this for each mode.
const MOST: usize = 10_000;

/// What is known of β_lim over a range before it is looked at.
#[derive(Clone, Debug)]
pub(super) struct Landmarks {
    /// The zeros of β_lim within the range and just outside, ascending.
    pub zeros: Vec<Edge>,
    /// The resonances of undamped modes within the range.
    pub jumps: Vec<f64>,
    /// Places to look at besides, ascending: about zeros, resonances and sub-harmonics.
    pub closely: Vec<f64>,
}

impl Landmarks {
    /// The zero that a piece counts from, if it is one.
    pub fn zero_at(&self, origin: f64, to: impl Fn(f64) -> f64) -> Option<Edge> {
        let mut zeros = self.zeros.iter().copied();
        zeros.find(|zero| to(zero.at) == origin)
    }

    /// One more place to look at.
    pub fn look_at(&mut self, r: f64) {
        let place = self.closely.partition_point(|known| *known < r);
        self.closely.insert(place, r);
    }

    pub fn of(modal: &Modal, zeros: Option<&Zeros>, (low, high): (f64, f64)) -> Self {
        let within = |r: f64| low <= r && r <= high;
        let (mut edges, mut centres, mut jumps) = (Vec::new(), Vec::new(), Vec::new());
        for mode in contact_modes(modal) {
            let (sigma, zeta) = (mode.driven.sigma, mode.driven.zeta);
            for k in 0..MOST {
                let order = (2 * k + 1) as f64;
                let place = sigma / Dd::from(order);
                if place.to_f64() < low * (1.0 - OUTSIDE) {
                    break;
                }
                if zeta.to_f64() * order > BROAD {
                    break;
                }
                // Of an undamped mode U is infinite there, whatever damps the others.
                if zeta.is_zero() && (k > 0 || mode.residue.is_zero()) {
                    edges.push(Edge::new(place));
                }
                if zeta.is_zero() && k == 0 && within(place.to_f64()) {
                    jumps.push(place.to_f64());
                }
                centres.push(place.to_f64());
            }
        }
        for zero in zeros
            .iter()
            .flat_map(|zeros| zeros.excitation.iter().chain(&zeros.common))
        {
            if zero.is_on_axis() && !zero.y.is_zero() {
                edges.push(Edge::new(zero.y));
            }
            if zero.x.abs() < zero.y * Dd::from(BROAD) {
                centres.push(zero.y.to_f64());
            }
        }
        // A zero just outside is as near as one at the end.
        let beside =
            |edge: &Edge| low * (1.0 - OUTSIDE) <= edge.at && edge.at <= high * (1.0 + OUTSIDE);
        edges.retain(beside);
        edges.sort_by(|a, b| a.at.total_cmp(&b.at));
        let beside =
            |centre: &f64| BESIDE.map(|part| [centre * (1.0 - part), centre * (1.0 + part)]);
        let mut closely: Vec<f64> = centres.iter().flat_map(beside).flatten().collect();
        closely.retain(|r| within(*r));
        closely.sort_by(f64::total_cmp);
        closely.dedup();
        Self {
            zeros: edges,
            jumps,
            closely,
        }
    }
}
