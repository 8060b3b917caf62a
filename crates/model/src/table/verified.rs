//! Compares finished tables with the exact values, as the construction of the tables does.

use super::check;
use super::exact::Exact;
use super::product::Product;
use super::shares::{cover, relative};
use super::split::Landmarks;
use super::tables::Tables;
use super::worst::Worst;
use super::zeros::Zeros;
use crate::modal::Modal;
use frictiongen_kernel::Float;
use std::ops::Range;

impl<S: Float> Tables<S> {
    /// Compares these tables with the exact values, as [`build`](Self::build) does, and returns the largest error. The
    /// result differs from [`Report::worst`](super::TableReport::worst) if the tables have changed since `build` made them.
    #[must_use]
    pub fn verify(&self, modal: &Modal) -> Worst {
        self.verified(modal, 0..self.pieces.len())
    }

    /// Compares one polynomial piece with the exact values, as [`build`](Self::build) does, and returns its largest
    /// error. `place` is the index of the piece.
    #[must_use]
    pub fn verify_piece(&self, modal: &Modal, place: usize) -> Worst {
        self.verified(modal, place..place + 1)
    }

    fn verified(&self, modal: &Modal, places: Range<usize>) -> Worst {
        let mut exact = Exact::new(modal);
        let ends = (S::constant(self.request.r.0), S::constant(self.request.r.1));
        let (low, high) = (ends.0.to_f64(), ends.1.to_f64());
        let landmarks = Landmarks::of(modal, Zeros::of(modal).as_ref(), (low, high));
        let shape = (self.functions, self.terms);
        let quotient = self.excitation.as_ref().map(Product::quotient);
        let mut cover = cover(&mut exact, landmarks, &self.request, shape, quotient);
        (cover.comparison.limit, cover.comparison.motion) = cover.whole;
        let mut worst = Worst {
            error: 0.0,
            at: low,
        };
        for place in places {
            let Some(piece) = self.pieces.get(place) else {
                continue;
            };
            let next = self.pieces.get(place + 1);
            let to = next.map_or(high, |next| next.from.to_f64());
            let (seen, _) = check::piece(&mut cover.comparison, piece, (piece.from.to_f64(), to));
            if !(seen.error <= worst.error) {
                worst = seen;
            }
        }
        relative(worst, &self.request)
    }
}
