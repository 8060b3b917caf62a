//! Methods of tables that start a proof.

use super::super::exact::{Exact, SIZE};
use super::super::split::Landmarks;
use super::super::tables::Tables;
use super::super::zeros::Zeros;
use super::evidence::{Evidence, Proof, Work};
use super::found::Piece;
use super::stage::Chain;
use super::{Prover, side_by_side};
use crate::modal::Modal;
use frictiongen_kernel::Float;
use std::ops::Range;

/// Approximate work to prove a piece for each mode, with all modes damped and otherwise. It decides whether a complete
/// proof is worth starting.
const PIECE_WORK: usize = 1800;
const PIECE_WORK_UNDAMPED: usize = 2600;

/// Largest work for one piece, relative to its equal share of the total.
const FAIR: usize = 8;

impl<S: Float> Tables<S> {
    /// Returns the tables with a proof.
    #[must_use]
    pub fn proven(mut self, modal: &Modal, work: Work) -> Self {
        [self.proof, self.motion_proof] = self.proof_of(modal, 0..self.pieces.len(), work);
        self
    }

    /// Returns the tables with a proof if the work is likely to suffice for all of them.
    #[must_use]
    pub fn proven_if_small(self, modal: &Modal, work: Work) -> Self {
        let of_piece = if Exact::new(modal).all_damped() {
            PIECE_WORK
        } else {
            PIECE_WORK_UNDAMPED
        };
        let needed = of_piece * self.pieces.len() * modal.resonances.len();
        if needed <= work.0 {
            self.proven(modal, work)
        } else {
            self
        }
    }

    /// Proves the β_lim of these tables, as far as the work allows.
    #[must_use]
    pub fn prove(&self, modal: &Modal, work: Work) -> Proof {
        let [limit, _] = self.proof_of(modal, 0..self.pieces.len(), work);
        limit
    }

    /// Proves β_lim in one piece. Also proves amplitude and phase of the contact there, if the table contains them.
    #[must_use]
    pub fn prove_piece(&self, modal: &Modal, place: usize, work: Work) -> [Proof; 2] {
        self.proof_of(modal, place..place + 1, work)
    }

    fn proof_of(&self, modal: &Modal, places: Range<usize>, work: Work) -> [Proof; 2] {
        let chain = Chain::of(modal);
        let ends = (S::constant(self.request.r.0), S::constant(self.request.r.1));
        let (low, high) = (ends.0.to_f64(), ends.1.to_f64());
        let landmarks = Landmarks::of(modal, Zeros::of(modal).as_ref(), (low, high));
        // |V| is bounded wherever β_lim is, except on its zeros and poles.
        let excitation = self.excitation.as_ref().map(|_| &self.excitation_proof);
        let excitation = excitation
            .filter(|proof| proof.evidence != Evidence::Checked && proof.open_length() == 0.0)
            .map(|proof| proof.bound.error)
            // If |V| is one of the functions, the comparison of the functions covers it.
            .or((self.functions > SIZE).then_some(0.0));
        let Work(most) = work;
        let share = Work(most.min(FAIR * most / places.len().max(1)));
        let ends = |place: usize| {
            let next = self.pieces.get(place + 1);
            let to = next.map_or(high, |next| next.from.to_f64());
            let from = self.pieces.get(place).map(|piece| piece.from.to_f64());
            (from.unwrap_or(low).max(low), to)
        };
        let one = |exact: &mut Exact<'_>, place: usize| {
            let prover = Prover::new(exact, &chain, self.request, share, excitation);
            let piece = self.pieces.get(place)?;
            let zero = landmarks.zero_at(piece.origin.to_f64(), |at| S::constant(at).to_f64());
            let found = prover.piece(piece, ends(place), &self.kinks, zero);
            Some((found.work, found))
        };
        let all: Vec<usize> = places.collect();
        let found = side_by_side::answered(&all, most, || Exact::new(modal), one);
        let mut whole = Piece::nothing(low);
        let mut found = found.into_iter();
        for place in all {
            match found.next() {
                Some(piece) => whole.and(piece),
                None => whole.leave(ends(place)),
            }
        }
        let work = whole.work;
        [whole.limit, whole.motion].map(|found| found.finished(work))
    }
}
