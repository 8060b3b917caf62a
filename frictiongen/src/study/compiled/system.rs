//! A run-time system with tables of its limits and of its motions.

use crate::study::error::UnknownMass;
use crate::study::system::System;
use crate::system::FrictionSystem;
use crate::{Limits, OutOfDomain};
use frictiongen_kernel::Float;
use frictiongen_kernel::contact::sums::ContactAt;
use frictiongen_kernel::response::{Continuous, MotionOf, Numbers, ProvidesMotion, Scene};
use frictiongen_kernel::table::{
    Compiled, ContactTable, Domain, Moving, Piece, SteadyContact, Table, Tabled, TabledMotion,
};
use frictiongen_model::scene::Side;
#[cfg(feature = "proof")]
use frictiongen_model::table::ProofWork;
use frictiongen_model::table::{Fitted, Proof, Request, TableError, Tables};
use std::ops::{Deref, Range};

/// Number of functions of frequency in a table: β_lim, a = β_lim·U/|V|, g = β_lim·G/|V|, arg V and |V|. V is the
/// complex amplitude of the contact without friction. U and G are the velocity and the displacement that friction
/// causes at a reversal, divided by β.
const FUNCTIONS: usize = 5;

/// The polynomial pieces of a table. The variant gives the degree of the polynomials.
#[derive(Clone, Debug)]
enum TablePieces<S> {
    Cubic(Vec<Piece<S, FUNCTIONS, 4>>),
    Quintic(Vec<Piece<S, FUNCTIONS, 6>>),
    Septic(Vec<Piece<S, FUNCTIONS, 8>>),
    Nonic(Vec<Piece<S, FUNCTIONS, 10>>),
}

/// A system with tables of its limits and of its contact's motion. The tables have a declared accuracy over a range of
/// frequency ratios r.
///
/// Within this range a `CompiledSystem` has the methods of the trait [`FrictionSystem`], as the exact [`System`] has.
/// The exact formulas compute the results that the tables do not contain, such as the motions of masses while the
/// contact slides.
///
/// ```
/// use frictiongen::{FrictionSystem, LimitsAt, System};
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let system: System = "struct Block {
///     masses: { block: 2.0 },
///     springs: { base - block: 50.0 },
///     contact: block - wall,
///     excitation: block,
/// }"
/// .parse()?;
/// let tables = system.compile(0.2..2.5, 1e-4)?;
/// let (fast, exact) = (tables.at(0.9)?.continuous_limit(), system.at(0.9)?.continuous_limit());
/// assert!((fast / exact - 1.0).abs() < 1e-4);
/// assert!(tables.at(3.0).is_err());
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct CompiledSystem<'s, S: Float = f64> {
    system: &'s System<S>,
    tables: Tables<S>,
    pieces: TablePieces<S>,
}

impl<S: Float> System<S> {
    /// Creates tables of β_lim, of the contact's motion and of the stuck responses over a range of frequency ratios r.
    /// `accuracy` is the largest relative error of a number from a table. For a phase it is the largest error in rad.
    ///
    /// # Errors
    /// [`TableError`] for an invalid range or accuracy, and if no table reaches the accuracy.
    pub fn compile(
        &self,
        range: Range<f64>,
        accuracy: f64,
    ) -> Result<CompiledSystem<'_, S>, TableError> {
        self.compile_for(Request {
            r: (range.start, range.end),
            accuracy,
            side: Side::Near,
            motion: true,
            stuck: true,
        })
    }

    /// Creates tables for a [`Request`], which has all options such as range, accuracy and side.
    ///
    /// # Errors
    /// Same errors as [`compile`](Self::compile).
    pub fn compile_for(&self, request: Request) -> Result<CompiledSystem<'_, S>, TableError> {
        self.single().map_err(|_| TableError::SeveralContacts)?;
        self.rigid().map_err(|_| TableError::ElasticContact)?;
        let tables = Tables::build(self.modal(), request)?;
        let pieces = TablePieces::of(&tables);
        Ok(CompiledSystem {
            system: self,
            tables,
            pieces,
        })
    }
}

/// Converts the fitted polynomial pieces to arrays with `C` coefficients for each function. A function that the request
/// does not include has only coefficients of 0.
fn arrays<S: Float, const C: usize>(pieces: &[Fitted<S>]) -> Vec<Piece<S, FUNCTIONS, C>> {
    let array = |piece: &Fitted<S>| {
        let mut coefficients = [[S::constant(0.0); C]; FUNCTIONS];
        for (to, from) in coefficients.iter_mut().zip(&piece.coefficients) {
            for (to, from) in to.iter_mut().zip(from) {
                *to = *from;
            }
        }
        Piece {
            from: piece.from,
            origin: piece.origin,
            coefficients,
        }
    };
    pieces.iter().map(array).collect()
}

impl<S: Float> TablePieces<S> {
    fn of(tables: &Tables<S>) -> Self {
        let pieces = &tables.pieces;
        match tables.terms {
            4 => Self::Cubic(arrays(pieces)),
            6 => Self::Quintic(arrays(pieces)),
            8 => Self::Septic(arrays(pieces)),
            _ => Self::Nonic(arrays(pieces)),
        }
    }
}

impl<'s, S: Float> CompiledSystem<'s, S> {
    /// Returns the exact system, without tables.
    #[must_use]
    pub fn system(&self) -> &'s System<S> {
        self.system
    }

    /// Returns the tables. The tables contain the request, and the result of the comparison of the tables with the
    /// exact functions.
    #[must_use]
    pub fn tables(&self) -> &Tables<S> {
        &self.tables
    }

    /// Proves the error bounds of the tables for β_lim and for the contact's motion, and returns the system with these
    /// proofs. If a proof needs more than the permitted `work`, it is incomplete. [`ProofWork::WHOLE`] takes a few
    /// seconds.
    #[cfg(feature = "proof")]
    #[must_use]
    pub fn proven(mut self, work: ProofWork) -> Self {
        frictiongen_proof::prove(&mut self.tables, self.system.modal(), work);
        self
    }

    /// Returns the proof of the error bound for β_lim. The method `proven`, which needs the feature `proof`, makes
    /// this proof. Without a call of `proven`, the result only says that the tables were compared with exact values at
    /// points.
    ///
    /// `tables().motion_proof` is the proof for the contact's motion. `tables().sliding_proof` is the proof for β*_lim,
    /// which needs no evaluations.
    #[must_use]
    pub fn proof(&self) -> &Proof {
        &self.tables.proof
    }

    /// Returns this system at the frequency ratio r.
    ///
    /// # Errors
    /// [`OutOfDomain`] outside the range of the tables, and for NaN.
    pub fn at(&self, r: S) -> Result<CompiledAt<'_, S>, OutOfDomain> {
        Compiled::new(self, r).map(CompiledAt)
    }

    fn table<'p, const C: usize>(
        &'p self,
        pieces: &'p [Piece<S, FUNCTIONS, C>],
    ) -> Table<'p, S, usize, FUNCTIONS, C> {
        let index = &self.tables.index;
        Table {
            low: index.low,
            density: index.density,
            halvings: index.halvings,
            buckets: &index.buckets,
            pieces,
        }
    }
}

impl<'a, S: Float> Scene for &'a CompiledSystem<'_, S> {
    type Scalar = S;
    type Decay = <&'a System<S> as Scene>::Decay;
    type Modes = <&'a System<S> as Scene>::Modes;
    type Waves = <&'a System<S> as Scene>::Waves;

    fn numbers(&self) -> Numbers<'_, S> {
        self.system.reduced.numbers()
    }
    fn shape(&self, mass: usize) -> Option<&[S]> {
        Some(self.system.reduced.shape(mass)).filter(|shape| !shape.is_empty())
    }
    fn quadratures(&self) -> &[[S; 2]] {
        &self.system.reduced.quadratures
    }
    fn frequency_stage(&self, inverse_r: S) -> (ContactAt<S>, Self::Modes) {
        self.system.frequency_stage(inverse_r)
    }
    fn idle(&self) -> Self::Waves {
        self.system.idle()
    }
    fn inverse_ratio_range(&self) -> (S, S) {
        self.system.inverse_ratio_range()
    }
    fn contact_without_g(&self, inverse_r: S) -> ContactAt<S> {
        self.system.contact_without_g(inverse_r)
    }
}

impl<S: Float> Tabled for &CompiledSystem<'_, S> {
    fn domain(&self) -> Domain<S> {
        let (low, high) = self.tables.request.r;
        Domain {
            r: (S::constant(low), S::constant(high)),
            beta: (S::constant(0.0), S::constant(f64::INFINITY)),
            exact_beyond: false,
            always_continuous: false,
            never_stuck: false,
        }
    }
    fn tabled_limit(&self, r: S) -> S {
        match &self.pieces {
            TablePieces::Cubic(pieces) => self.table(pieces).first(r),
            TablePieces::Quintic(pieces) => self.table(pieces).first(r),
            TablePieces::Septic(pieces) => self.table(pieces).first(r),
            TablePieces::Nonic(pieces) => self.table(pieces).first(r),
        }
    }
    fn tabled_sliding_limit(&self, r: S) -> Option<S> {
        let product = self.tables.sliding.as_ref()?;
        Some(product.quotient().magnitude(r))
    }
}

impl<'a, S: Float> TabledMotion for &'a CompiledSystem<'a, S> {
    type Moving = CompiledMotion<'a, S>;

    fn tabled_contact(&self, r: S) -> Option<ContactTable<S>> {
        let functions = self.tables.functions;
        let excitation = self.tables.excitation.as_ref();
        if functions < FUNCTIONS && excitation.is_none() {
            return None;
        }
        let values = match &self.pieces {
            TablePieces::Cubic(pieces) => self.table(pieces).values(r),
            TablePieces::Quintic(pieces) => self.table(pieces).values(r),
            TablePieces::Septic(pieces) => self.table(pieces).values(r),
            TablePieces::Nonic(pieces) => self.table(pieces).values(r),
        };
        let [limit, quadrature, displacement, direction, _] = values;
        Some(
            match excitation.map(|product| product.quotient().value(r)) {
                None => ContactTable::tabled(values),
                Some(excitation) if functions == 4 => {
                    ContactTable::damped([limit, quadrature, displacement, direction], excitation)
                }
                Some(excitation) => ContactTable::undamped([limit, quadrature], excitation),
            },
        )
    }
}

impl<S: Float> ProvidesMotion for &CompiledSystem<'_, S> {
    type Motion = Continuous<Self>;
}

impl<S: Float> FrictionSystem for CompiledSystem<'_, S> {
    type Scalar = S;
    type At<'a>
        = CompiledAt<'a, S>
    where
        Self: 'a;

    fn resonances(&self) -> &[S] {
        self.system.resonances()
    }
    fn masses(&self) -> usize {
        FrictionSystem::masses(self.system)
    }
    fn mass_name(&self, index: usize) -> Option<&str> {
        self.system.mass_name(index)
    }
    fn at(&self, r: S) -> Result<CompiledAt<'_, S>, OutOfDomain> {
        Self::at(self, r)
    }
    fn limits_without_search(&self, r: S) -> Result<Limits<S>, OutOfDomain> {
        self.system.limits_without_search(r)
    }
    fn limits_without_search_into(
        &self,
        rs: &[S],
        continuous: &mut [S],
        sliding: &mut [S],
    ) -> Result<(), OutOfDomain> {
        FrictionSystem::limits_without_search_into(self.system, rs, continuous, sliding)
    }
}

/// A [`CompiledSystem`] at one frequency ratio, with the limits, the regime and the motions.
#[derive(Clone, Debug)]
pub struct CompiledAt<'a, S: Float = f64>(Compiled<&'a CompiledSystem<'a, S>>);

impl<'a, S: Float> Deref for CompiledAt<'a, S> {
    type Target = Compiled<&'a CompiledSystem<'a, S>>;

    fn deref(&self) -> &Self::Target {
        &self.0
    }
}

/// The continuous motion of a [`CompiledSystem`] at one frequency ratio and one friction ratio.
#[derive(Clone, Debug)]
pub struct CompiledMotion<'a, S: Float = f64>(Moving<&'a CompiledSystem<'a, S>>);

/// The relative motion of the contact of a [`CompiledSystem`], from tables, while the contact slides all the time.
pub type CompiledContact<'a, S = f64> = SteadyContact<&'a CompiledSystem<'a, S>>;

impl<'a, S: Float> CompiledMotion<'a, S> {
    /// Returns the continuous motion of a mass, by the exact formulas.
    ///
    /// # Errors
    /// [`UnknownMass`] if no mass has this name.
    pub fn mass(&self, name: &str) -> Result<MotionOf<&'a CompiledSystem<'a, S>>, UnknownMass> {
        let system = self.at().scene().system;
        let motion = self.mass_at(system.mass_index(name)?);
        motion.ok_or_else(|| system.unknown(name))
    }
}

impl<'a, S: Float> From<Moving<&'a CompiledSystem<'a, S>>> for CompiledMotion<'a, S> {
    fn from(motion: Moving<&'a CompiledSystem<'a, S>>) -> Self {
        Self(motion)
    }
}

impl<'a, S: Float> Deref for CompiledMotion<'a, S> {
    type Target = Moving<&'a CompiledSystem<'a, S>>;

    fn deref(&self) -> &Self::Target {
        &self.0
    }
}
