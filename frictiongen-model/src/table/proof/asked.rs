//! What tables are asked about their proof.

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

/// The work that the proof of a piece takes for each mode, about, where all are damped and where not: whether a whole one
/// is worth beginning.
const PIECE_WORK: usize = 1800;
const PIECE_WORK_UNDAMPED: usize = 2600;

/// A piece may take so many times its share of the work.
const FAIR: usize = 8;

impl<S: Float> Tables<S> {
    /// The same with what is proven of it.
    #[must_use]
    pub fn proven(mut self, modal: &Modal, work: Work) -> Self {
        [self.proof, self.motion_proof] = self.proof_of(modal, 0..self.pieces.len(), work);
        self
    }

    /// The same where the work is likely to do for the whole of it.
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

    /// What is proven of β_lim as these tables have it.
    #[must_use]
    pub fn prove(&self, modal: &Modal, work: Work) -> Proof {
        let [limit, _] = self.proof_of(modal, 0..self.pieces.len(), work);
        limit
    }

    /// The same of one piece; and what is proven there of amplitude and phase of the contact, if they are tabled.
    #[must_use]
    pub fn prove_piece(&self, modal: &Modal, place: usize, work: Work) -> [Proof; 2] {
        self.proof_of(modal, place..place + 1, work)
    }

    fn proof_of(&self, modal: &Modal, places: Range<usize>, work: Work) -> [Proof; 2] {
        let chain = Chain::of(modal);
        let ends = (S::constant(self.request.r.0), S::constant(self.request.r.1));
        let (low, high) = (ends.0.to_f64(), ends.1.to_f64());
        let landmarks = Landmarks::of(modal, Zeros::of(modal).as_ref(), (low, high));
        // |V| is known wherever β_lim is, but on its zeros and poles.
        let excitation = self.excitation.as_ref().map(|_| &self.excitation_proof);
        let excitation = excitation
            .filter(|proof| proof.evidence != Evidence::Checked && proof.open_length() == 0.0)
            .map(|proof| proof.bound.error)
            // Among the functions it is compared with them.
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
