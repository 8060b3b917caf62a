//! Proof that a table of β_lim is within its accuracy at every r, and not only at the checked points.
//!
//! The proof divides the range into intervals of r. In each interval it chooses a *witness*: an instant τ of the half
//! period near the largest velocity constraint, as a polynomial in r. With more friction than the velocity constraint
//! at τ allows, the contact would stop at τ before the half period ends. `certify` proves that no other instant has a
//! constraint larger by more than a small margin. The witness and the margin then give an upper and a lower bound on
//! β_lim, which are smooth functions of r. `compare` proves that the polynomial of the table is near these bounds,
//! including all rounding errors of its evaluation. Both modules use intervals with outward rounding. `motion` proves
//! amplitude and phase of the contact in the same way.
//!
//! If the proof of an interval fails, the prover halves the interval. A short interval without a proof stays *open*:
//! the table is checked at points of this interval, but not proven.
//!
//! Some constants are called *tuned*. A tuned value changes the work of a proof, and how much of r stays open. The
//! correctness of a proof does not depend on this value.
//!
//! The products over zeros and poles for β*_lim and |V| need no proof here. The builder of the tables, in
//! `frictiongen-model`, bounds their errors.

mod candidates;
mod cells;
mod certify;
mod compare;
mod early;
mod ends;
mod force;
mod found;
mod motion;
mod prover;
mod ridge;
mod series;
mod side_by_side;
mod stage;
mod witness;

#[cfg(test)]
mod formulas;
#[cfg(test)]
mod moved;
#[cfg(test)]
mod tests;

use found::PieceProof;
use frictiongen_kernel::Float;
use frictiongen_model::modal::Modal;
use frictiongen_model::table::building::{Exact, Landmarks, SIZE, Zeros};
use frictiongen_model::table::{Evidence, Proof, ProofWork, Tables};
use prover::Prover;
use stage::IntervalChain;
use std::ops::Range;

/// Estimated work to prove a piece of a table, divided by the number of modes, if every mode is damped. The unit is an
/// evaluation of one mode, as in [`ProofWork`]. The estimate only decides whether [`prove_if_small`] starts a proof. If
/// the proof needs more work than permitted, it does not cover some intervals of r.
const PIECE_WORK: usize = 1800;
/// Estimated work to prove a piece of a table, divided by the number of modes, if a mode is undamped. It is larger than
/// `PIECE_WORK`, because intervals of r are shorter near the poles of an undamped mode.
const PIECE_WORK_UNDAMPED: usize = 2600;
/// Largest work for one piece, as a multiple of the piece's equal share of the total work. The value is tuned. One
/// piece must not use the work that the other pieces need.
const FAIR: usize = 8;

/// Proves the errors of a table in β_lim, and in amplitude and phase of the contact, for as much of r as the work
/// allows. Stores the proofs in the tables.
pub fn prove<S: Float>(tables: &mut Tables<S>, modal: &Modal, work: ProofWork) {
    let pieces = 0..tables.pieces.len();
    [tables.proof, tables.motion_proof] = of_pieces(tables, modal, pieces, work);
}

/// Makes the proof of [`prove`], but only if the work is likely to suffice for all pieces of the tables.
pub fn prove_if_small<S: Float>(tables: &mut Tables<S>, modal: &Modal, work: ProofWork) {
    let of_piece = if Exact::new(modal).all_damped() {
        PIECE_WORK
    } else {
        PIECE_WORK_UNDAMPED
    };
    let needed = of_piece * tables.pieces.len() * modal.resonances.len();
    if needed <= work.0 {
        prove(tables, modal, work);
    }
}

/// Proves the accuracy of β_lim in one piece of the tables. If the tables contain amplitude and phase of the contact,
/// the function also proves their accuracy in this piece.
#[must_use]
pub fn prove_piece<S: Float>(
    tables: &Tables<S>,
    modal: &Modal,
    place: usize,
    work: ProofWork,
) -> [Proof; 2] {
    of_pieces(tables, modal, place..place + 1, work)
}

/// Proves the accuracy of β_lim, and of amplitude and phase, in the pieces with the given indices.
fn of_pieces<S: Float>(
    tables: &Tables<S>,
    modal: &Modal,
    places: Range<usize>,
    work: ProofWork,
) -> [Proof; 2] {
    let chain = IntervalChain::of(modal);
    let ends = (
        S::constant(tables.request.r.0),
        S::constant(tables.request.r.1),
    );
    let (low, high) = (ends.0.to_f64(), ends.1.to_f64());
    let landmarks = Landmarks::of(modal, Zeros::of(modal).as_ref(), (low, high));
    // Where β_lim is bounded, the error of |V| is bounded too, except at the zeros and poles of |V|.
    let excitation = tables.excitation.as_ref().map(|_| &tables.excitation_proof);
    let excitation = excitation
        .filter(|proof| proof.evidence != Evidence::Checked && proof.open_length() == 0.0)
        .map(|proof| proof.bound.error)
        // If the table contains |V| as a polynomial, the comparison of polynomials covers its error.
        .or((tables.functions > SIZE).then_some(0.0));
    let ProofWork(most) = work;
    let share = ProofWork(most.min(FAIR * most / places.len().max(1)));
    let ends = |place: usize| {
        let next = tables.pieces.get(place + 1);
        let to = next.map_or(high, |next| next.from.to_f64());
        let from = tables.pieces.get(place).map(|piece| piece.from.to_f64());
        (from.unwrap_or(low).max(low), to)
    };
    let one = |exact: &mut Exact<'_>, place: usize| {
        let prover = Prover::new(exact, &chain, tables.request, share, excitation);
        let piece = tables.pieces.get(place)?;
        let zero = landmarks.zero_at(piece.origin.to_f64(), |at| S::constant(at).to_f64());
        let found = prover.piece(piece, ends(place), tables.kinks(), zero);
        Some((found.work, found))
    };
    let all: Vec<usize> = places.collect();
    let found = side_by_side::answered(&all, most, || Exact::new(modal), one);
    let mut whole = PieceProof::nothing(low);
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
