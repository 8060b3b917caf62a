//! What tables are asked about their proof.

use super::super::exact::Exact;
use super::super::split::Landmarks;
use super::super::tables::Tables;
use super::super::zeros::Zeros;
use super::{Proof, Prover, Work};
use crate::modal::Modal;
use frictiongen_kernel::Float;
use std::ops::Range;

/// The work that the proof of a piece takes for each mode, about: where a whole one is worth beginning.
const PIECE_WORK: usize = 3500;

impl<S: Float> Tables<S> {
    /// The same with what is proven of it.
    #[must_use]
    pub fn proven(mut self, modal: &Modal, work: Work) -> Self {
        self.proof = self.prove(modal, work);
        self
    }

    /// The same where the work is likely to do for the whole of it.
    #[must_use]
    pub fn proven_if_small(self, modal: &Modal, work: Work) -> Self {
        let needed = PIECE_WORK * self.pieces.len() * modal.resonances.len();
        if needed <= work.0 {
            self.proven(modal, work)
        } else {
            self
        }
    }

    /// What is proven of β_lim as these tables have it.
    #[must_use]
    pub fn prove(&self, modal: &Modal, work: Work) -> Proof {
        self.proof_of(modal, 0..self.pieces.len(), work)
    }

    /// The same of one piece.
    #[must_use]
    pub fn prove_piece(&self, modal: &Modal, place: usize, work: Work) -> Proof {
        self.proof_of(modal, place..place + 1, work)
    }

    fn proof_of(&self, modal: &Modal, places: Range<usize>, work: Work) -> Proof {
        let mut exact = Exact::new(modal);
        let ends = (S::constant(self.request.r.0), S::constant(self.request.r.1));
        let (low, high) = (ends.0.to_f64(), ends.1.to_f64());
        let landmarks = Landmarks::of(modal, Zeros::of(modal).as_ref(), (low, high));
        let mut prover = Prover::new(&mut exact, self.request, work, places.len());
        for place in places {
            let Some(piece) = self.pieces.get(place) else {
                continue;
            };
            let next = self.pieces.get(place + 1);
            let to = next.map_or(high, |next| next.from.to_f64());
            let from = piece.from.to_f64().max(low);
            let zero = landmarks.zero_at(piece.origin.to_f64(), |at| S::constant(at).to_f64());
            prover.piece(piece, (from, to), &self.kinks, zero);
        }
        prover.finished()
    }
}
