//! Builds all tables of a scene, from the request to the report on their errors.

use super::cover::NotCovered;
use super::evidence::Proof;
use super::exact::Exact;
use super::fit::{Fitted, TERMS, terms};
use super::held::Held;
use super::index::Index;
use super::kinks;
use super::product::Product;
use super::quotients::Products;
use super::request::{COARSEST, FINEST, FINEST_PROVEN, Request, TableError};
use super::shares::{cover, relative};
use super::split::Landmarks;
use super::worst::Worst;
use super::zeros::Zeros;
use crate::modal::Modal;
use crate::rounded;
use crate::scene::{Accuracy, Provide, Proving, Scene};
use frictiongen_kernel::Float;

/// The tables of the stuck responses may take at most the allowed bytes divided by this number.
const STUCK_PART: usize = 4;
/// The first length that the construction tries for a piece is the length of the range of r, divided by this number.
const FIRST: f64 = 16.0;
/// Largest number of pieces whose indices fit into one byte.
const IN_A_BYTE: usize = 1 << u8::BITS;

/// Size of the tables of a scene, and the errors that the check has found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TableReport {
    /// Largest relative error of β_lim that the check has found. For tables with the motion of the contact, the number
    /// also covers the amplitude and phase of the contact.
    pub worst: Worst,
    /// Largest relative error of β*_lim that the check has found.
    pub sliding: Worst,
    /// Number of frequency ratios at which the check has compared the tables with exact values.
    pub points: usize,
    /// Number of frequency ratios at which the exact values were computed.
    pub evaluations: usize,
    /// Size of all numbers that the tables store, in bytes.
    pub bytes: usize,
}

/// Tables of the limits, the contact's motion and the stuck responses of a scene, with their proofs. The numbers have
/// the type `S`.
#[derive(Clone, Debug)]
pub struct Tables<S> {
    /// The request for which the tables were built.
    pub request: Request,
    /// Number of functions that each piece approximates by polynomials, from 1 (β_lim alone) to 5. The functions are
    /// β_lim, a = β_lim·U/|V|, g = β_lim·G/|V|, arg V and |V|, where V is the response of the contact without
    /// friction.
    pub functions: usize,
    /// Number of coefficients of each polynomial.
    pub terms: usize,
    /// Polynomial pieces of β_lim and of the other functions, in ascending order of r.
    pub pieces: Vec<Fitted<S>>,
    /// Buckets of r, by which a lookup finds the polynomial piece that contains r.
    pub index: Index<S>,
    /// Table of β*_lim as a product over zeros and poles. `None` if only the exact sums over the modes are accurate
    /// enough.
    pub sliding: Option<Product<S>>,
    /// |V|, the amplitude of the contact without friction, as a product over zeros and poles. `None` if the table has
    /// polynomials for |V|, or if the tables have no motion.
    pub excitation: Option<Product<S>>,
    /// Responses while the contact is stuck, if the request includes them. `None` if only the exact formulas are
    /// accurate enough. The check compares the responses with the exact values. No proof covers them.
    pub held: Option<Held<S>>,
    /// Size of the tables, and the errors that the check has found.
    pub report: TableReport,
    /// Proof, complete or partial, that β_lim from the table has the requested accuracy in the range of r.
    pub proof: Proof,
    /// Proof that amplitude and phase of the contact have the requested accuracy. The proof covers β/β_lim up to the
    /// largest ratio in `FRICTION_SHARES`.
    pub motion_proof: Proof,
    /// Proof that the table of β*_lim has the requested accuracy. This proof takes so little work that the builder
    /// always makes it.
    pub sliding_proof: Proof,
    /// Proof that |V|, the amplitude of the contact without friction, has the requested accuracy, if a product
    /// represents |V|.
    pub excitation_proof: Proof,
    /// Undamped resonances within the range that the load drives, rounded to the number type. At these frequency ratios
    /// the amplitude of a continuous motion is infinite.
    pub unbounded: Vec<S>,
    /// Frequency ratios at which β_lim has a kink, in ascending order.
    pub(super) kinks: Vec<f64>,
}

/// Rounds a number to one significant digit, as in a written accuracy.
fn one_digit(value: f64) -> f64 {
    format!("{value:.0e}").parse().unwrap_or(value)
}

impl<S: Float> Tables<S> {
    /// Builds the tables of a scene for a request.
    ///
    /// # Errors
    /// Returns every [`TableError`] except `TooFewBytes`.
    pub fn build(modal: &Modal, request: Request) -> Result<Self, TableError> {
        request.check::<S>()?;
        let mut exact = Exact::new(modal);
        let tables = Self::built(&mut exact, request).map_err(|error| match error {
            TableError::NotMet { at, accuracy, .. } => TableError::NotMet {
                accuracy,
                reached: Self::reached(&mut exact, request),
                at,
            },
            other => other,
        })?;
        Ok(tables.with(Self::held_of(modal, &request).as_ref()))
    }

    /// Returns the kinks of β_lim, in ascending order.
    #[must_use]
    pub fn kinks(&self) -> &[f64] {
        &self.kinks
    }

    /// Returns true if amplitude and phase of the contact follow from these tables.
    #[must_use]
    pub fn moves(&self) -> bool {
        self.functions > 1
    }

    /// Returns the number of additions and multiplications in a lookup and in the evaluation of one polynomial.
    #[must_use]
    pub fn additions_and_multiplications(&self) -> usize {
        // The count includes r − low and its product with the density, and r − origin and its square. Each pair of
        // terms takes two operations. The combination of two pairs takes two more.
        let pairs = self.terms.div_ceil(2);
        2 + 2 + 2 * pairs + 2 * (pairs - 1)
    }

    /// Builds the tables that a scene declares. Returns `None` for a scene that declares no tables.
    ///
    /// # Errors
    /// Returns every [`TableError`].
    pub fn of(scene: &Scene) -> Result<Option<Self>, TableError> {
        let declared = &scene.declared;
        let Some(range) = declared.range.filter(|_| declared.is_tabled()) else {
            return Ok(None);
        };
        let moves = |item: &Provide| matches!(item, Provide::Motion(_));
        let mut request = Request {
            r: range.r,
            accuracy: COARSEST,
            side: declared.side,
            motion: scene.provide.iter().any(moves),
            stuck: scene.provide.contains(&Provide::Stuck),
        };
        let modal = Modal::of(scene);
        let tables = match (declared.accuracy, declared.budget) {
            (Accuracy::Relative(accuracy), _) => {
                request.accuracy = accuracy;
                Self::build(&modal, request)
            }
            (Accuracy::Exact, bytes) => {
                let finest = match declared.proof {
                    Proving::Quick => FINEST,
                    Proving::Whole => FINEST_PROVEN,
                };
                Self::within_to(&modal, request, bytes.unwrap_or(0.0) as usize, finest)
            }
        };
        tables.map(Some)
    }

    /// Builds the most accurate tables that fit into a number of bytes.
    ///
    /// # Errors
    /// [`TableError::TooFewBytes`], and the errors of [`build`](Self::build).
    pub fn within(modal: &Modal, request: Request, bytes: usize) -> Result<Self, TableError> {
        Self::within_to(modal, request, bytes, FINEST)
    }

    /// Builds the most accurate tables that fit into a number of bytes. The function tries no accuracy finer than
    /// `finest`.
    fn within_to(
        modal: &Modal,
        request: Request,
        bytes: usize,
        finest: f64,
    ) -> Result<Self, TableError> {
        let coarsest = Request {
            accuracy: COARSEST,
            ..request
        };
        coarsest.check::<S>()?;
        let mut exact = Exact::new(modal);
        // The responses with the contact stuck get only a limited fraction of the bytes, because their exact formulas
        // need no search and are therefore fast.
        let held = Self::held_of(modal, &request);
        let held = held.filter(|held| held.bytes() <= bytes / STUCK_PART);
        let mut within = |finer: Request| {
            let kept = held.as_ref().filter(|held| held.keeps(finer.accuracy));
            let room = bytes.saturating_sub(kept.map_or(0, Held::bytes));
            Self::built_within(&mut exact, finer, room).map(|tables| tables.with(held.as_ref()))
        };
        let mut best = within(coarsest)?;
        let least = best.report.bytes;
        if least > bytes {
            return Err(TableError::TooFewBytes { bytes, least });
        }
        // The loop tries the accuracies 5, 2 and 1 times 10^−k. The first accuracy that does not fit ends the search.
        for step in 0_u32.. {
            let unit = [5.0, 2.0, 1.0]
                .get((step % 3) as usize)
                .copied()
                .unwrap_or(1.0);
            let accuracy = unit / 10_f64.powf(2.0 + f64::from(step / 3));
            let finer = Request {
                accuracy,
                ..request
            };
            if accuracy < finest || finer.check::<S>().is_err() {
                break;
            }
            match within(finer) {
                Ok(tables) if tables.report.bytes <= bytes => best = tables,
                _ => break,
            }
        }
        Ok(best)
    }

    /// Returns the size in bytes of the tables of the limits and of the contact's motion. [`TableReport::bytes`] also
    /// includes the responses with the contact stuck.
    #[must_use]
    pub fn bytes_without_stuck(&self) -> usize {
        self.report.bytes - self.held.as_ref().map_or(0, Held::bytes)
    }

    /// Returns the responses while the contact is stuck. Their products do not contain the load of damping relative to a
    /// moving base. For such a scene the result is `None`, and the exact formulas give the stuck responses.
    fn held_of(modal: &Modal, request: &Request) -> Option<Held<S>> {
        let is_held = request.stuck && modal.participations.is_empty();
        is_held.then(|| Held::of(modal, request.r)).flatten()
    }

    /// Adds the stuck responses to the tables, if they are accurate enough.
    fn with(mut self, held: Option<&Held<S>>) -> Self {
        let accuracy = self.request.accuracy;
        self.held = held.filter(|held| held.keeps(accuracy)).cloned();
        self.report.bytes += self.held.as_ref().map_or(0, Held::bytes);
        self
    }

    /// Returns the finest accuracy that a table can meet. The method tries accuracies that are 10, 100, … times as
    /// coarse as the request. Returns `None` if no table meets any of them.
    fn reached(exact: &mut Exact<'_>, request: Request) -> Option<f64> {
        let mut accuracy = request.accuracy;
        while accuracy < COARSEST {
            accuracy = one_digit(10.0 * accuracy).min(COARSEST);
            let coarser = Request {
                accuracy,
                ..request
            };
            if Self::built(exact, coarser).is_ok() {
                return Some(accuracy);
            }
        }
        None
    }

    fn built(exact: &mut Exact<'_>, request: Request) -> Result<Self, TableError> {
        Self::built_within(exact, request, usize::MAX)
    }

    /// Builds the tables of the limits and of the contact's motion. If polynomials of the usual degree do not
    /// suffice, the method tries higher degrees. Higher degrees are needed if a mode changes a function within a few
    /// hundred rounding units of r.
    fn built_within(
        exact: &mut Exact<'_>,
        request: Request,
        bytes: usize,
    ) -> Result<Self, TableError> {
        let usual = terms(request.accuracy);
        let not_met = match Self::of_terms(exact, request, bytes, usual) {
            Err(error @ TableError::NotMet { .. }) => error,
            other => return other,
        };
        let mut more = TERMS.into_iter().filter(|more| usual < *more);
        let found = more.find_map(|more| Self::of_terms(exact, request, bytes, more).ok());
        found.ok_or(not_met)
    }

    /// Builds the tables with polynomials of `terms` coefficients. |V| is the amplitude of the contact without
    /// friction. |V| is one of the polynomials if every mode is damped and the tables fit into the allowed bytes.
    /// Otherwise |V| is a product over zeros and poles. A product needs fewer bytes, but takes a square root and some
    /// operations for every zero and pole.
    fn of_terms(
        exact: &mut Exact<'_>,
        request: Request,
        bytes: usize,
        terms: usize,
    ) -> Result<Self, TableError> {
        if request.motion && exact.all_damped() {
            let tabled = Self::built_with(exact, request, terms, true);
            if let Ok(tables) = tabled
                && tables.report.bytes <= bytes
            {
                return Ok(tables);
            }
        }
        Self::built_with(exact, request, terms, false)
    }

    fn built_with(
        exact: &mut Exact<'_>,
        request: Request,
        terms: usize,
        with_size: bool,
    ) -> Result<Self, TableError> {
        let modal = exact.modal;
        // The bounds of the range are rounded as in a lookup.
        let ends = (S::constant(request.r.0), S::constant(request.r.1));
        let (low, high) = (ends.0.to_f64(), ends.1.to_f64());
        let zeros = Zeros::of(modal);
        let landmarks = Landmarks::of(modal, zeros.as_ref(), (low, high));
        let Products {
            sliding,
            excitation,
            worst: off,
            points,
            proofs: [sliding_proof, excitation_proof],
        } = Products::of(
            exact,
            zeros.as_ref(),
            &landmarks,
            &request,
            !with_size,
            (low, high),
        );
        let functions = match (&excitation, exact.damped()) {
            // If the zeros of the contact's response V to the load could not be separated, V may have a zero at a real
            // r. |V| then has a kink, so that the pieces do not contain |V|.
            _ if with_size && zeros.is_some() => 5,
            (None, _) => 1,
            (Some(_), false) => 2,
            (Some(_), true) => 4,
        };
        let mut kinks = kinks::kinks(exact, (low, high));
        if exact.damped() {
            // The response V of the contact to the load has a jump of arg V at the resonance of an undamped mode among
            // damped modes.
            kinks.extend(landmarks.jumps.iter().copied());
        }
        let quotient = excitation.as_ref().map(Product::quotient);
        let mut cover = cover(
            exact,
            landmarks.clone(),
            &request,
            (functions, terms),
            quotient,
        );
        cover.kinks = kinks.clone();
        cover.last = (high - low) / FIRST;
        let not_met = |NotCovered { at }| TableError::NotMet {
            accuracy: request.accuracy,
            reached: None,
            at,
        };
        let (pieces, worst, looked) = cover.checked(low, high).map_err(not_met)?;
        let worst = relative(worst, &request);
        let index = Index::of(&pieces, ends);
        let numbers: usize = pieces.iter().map(Fitted::numbers).sum();
        let narrow = if pieces.len() <= IN_A_BYTE { 1 } else { 2 };
        let products = sliding.iter().chain(&excitation).map(Product::numbers);
        let size = core::mem::size_of::<S>();
        let bytes = numbers * size + index.buckets.len() * narrow;
        let bytes = bytes + products.sum::<usize>() * size;
        let mut unbounded: Vec<S> = modal.unbounded(false).into_iter().map(rounded).collect();
        unbounded.retain(|own| ends.0 <= *own && *own <= ends.1);
        Ok(Self {
            request,
            functions,
            terms,
            pieces,
            index,
            sliding,
            excitation,
            held: None,
            report: TableReport {
                worst,
                sliding: off,
                points: points + looked,
                evaluations: exact.looked_at(),
                bytes,
            },
            proof: Proof::none((low, high)),
            motion_proof: Proof::none((low, high)),
            sliding_proof,
            excitation_proof,
            unbounded,
            kinks,
        })
    }
}
