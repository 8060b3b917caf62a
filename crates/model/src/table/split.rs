//! Frequency ratios at which a table must be divided, and frequency ratios near zeros and resonances at which its
//! error must be checked.

use super::zeros::{Zeros, contact_modes};
use crate::modal::Modal;
use frictiongen_kernel::number::dd::Dd;

/// A zero r₀ of β_lim, as the sum of a double and a remainder.
#[derive(Clone, Copy, Debug)]
pub struct LimitZero {
    /// The position of the zero as a double.
    pub at: f64,
    /// The remainder: the exact zero minus the double `at`.
    pub rest: f64,
}

impl LimitZero {
    fn new(at: Dd) -> Self {
        let high = at.to_f64();
        let rest = (at - Dd::from(high)).to_f64();
        Self { at: high, rest }
    }

    /// Returns r − r₀, the signed distance of r from the zero r₀ of β_lim.
    pub fn distance(&self, r: f64) -> f64 {
        (r - self.at) - self.rest
    }
}

/// Relative distances from a zero of β_lim, a resonance or a subharmonic at which the error of a table is checked. A
/// subharmonic is a resonance divided by 3, 5, 7 and so on.
const BESIDE: [f64; 13] = [
    0.0, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-6, 1e-5, 1e-4, 1e-3, 3e-3, 1e-2,
];
/// Largest relative distance from the range of r at which a zero of β_lim outside the range still influences the
/// table.
const OUTSIDE: f64 = 1e-2;
/// Largest damping at which a resonance, a subharmonic or a zero causes a narrow feature of β_lim. For the subharmonic
/// of order n of a mode, which is its resonance divided by n, the damping is nζ. For a complex zero x + iy of the
/// contact's response to the load it is |x|/y.
const BROAD: f64 = 0.5;
/// Largest number of subharmonics that the code considers for each mode.
const MOST: usize = 10_000;

/// Frequency ratios that are known before any fit: zeros of β_lim, jumps in the phase of the contact's response, and
/// narrow features of β_lim.
#[derive(Clone, Debug)]
pub struct Landmarks {
    /// The zeros of β_lim within the range and just outside, ascending.
    pub zeros: Vec<LimitZero>,
    /// Resonances of undamped modes within the range of r. The phase of the contact's response jumps at each of these
    /// resonances.
    pub jumps: Vec<f64>,
    /// Frequency ratios, in ascending order, at which the code evaluates the error of a table, in addition to the
    /// points of the fit and of the check. They are at and near zeros of β_lim, resonances, and subharmonics
    /// (resonances divided by 3, 5, 7, …).
    pub closely: Vec<f64>,
}

impl Landmarks {
    /// Returns the zero of β_lim that is the origin of a polynomial piece, or `None` if the origin is not a zero.
    /// `to` rounds a zero to the scalar type of the table.
    pub fn zero_at(&self, origin: f64, to: impl Fn(f64) -> f64) -> Option<LimitZero> {
        let mut zeros = self.zeros.iter().copied();
        zeros.find(|zero| to(zero.at) == origin)
    }

    /// Adds a frequency ratio at which the error of the table must be checked.
    pub fn look_at(&mut self, r: f64) {
        let place = self.closely.partition_point(|known| *known < r);
        self.closely.insert(place, r);
    }

    /// Returns the landmarks in a range of r. `zeros` is `None` if the zeros of the contact's responses V and H (to the
    /// load and to a contact force) could not be separated.
    #[must_use]
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
                // At this r the velocity U of the contact that friction causes at a reversal is infinite, whatever the
                // damping of the other modes. β_lim is then 0.
                if zeta.is_zero() && (k > 0 || mode.residue.is_zero()) {
                    edges.push(LimitZero::new(place));
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
                edges.push(LimitZero::new(zero.y));
            }
            if zero.x.abs() < zero.y * Dd::from(BROAD) {
                centres.push(zero.y.to_f64());
            }
        }
        // A zero just outside the range influences the table as much as a zero at a bound of the range.
        let beside = |edge: &LimitZero| {
            low * (1.0 - OUTSIDE) <= edge.at && edge.at <= high * (1.0 + OUTSIDE)
        };
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
