//! Emits the tables that replace the exact formulas in a scene with a declared accuracy.

use super::checksum;
use super::domain::{checked, domain};
use super::emission::{Emission, EmittedCode};
use super::fields::fields;
use super::names::TypeNames;
use crate::lower::SceneTables;
use frictiongen_kernel::Float;
use frictiongen_kernel::emitted::check::Listed;
use frictiongen_kernel::table::Factor;
use frictiongen_model::scene::Side;
use frictiongen_model::table::{
    Evidence, FINEST_PROVEN, MOST_SHARE, Product, ProofWork, TableReport, Tables,
};
use proc_macro2::{Literal, TokenStream};

/// Emits the tables as constants and the functions that evaluate them. Emits nothing for a scene without a declared
/// accuracy.
pub(super) fn emit(emission: &Emission<'_>, motion: bool) -> EmittedCode {
    match &emission.description.tables {
        None => EmittedCode::default(),
        Some(SceneTables::Double(tables)) => tabled(emission, tables, motion),
        Some(SceneTables::Single(tables)) => tabled(emission, tables, motion),
    }
}

fn tabled<S: Float + Listed<S>>(
    emission: &Emission<'_>,
    tables: &Tables<S>,
    motion: bool,
) -> EmittedCode {
    let Emission {
        scalar,
        names: TypeNames { name, .. },
        ..
    } = emission;
    // The addition of 0.0 removes the sign of a zero, which changes no answer.
    let number = |value: S| emission.literal(value.to_f64() + 0.0);
    let functions = Literal::usize_unsuffixed(tables.functions);
    let terms = Literal::usize_unsuffixed(tables.terms);
    let index = &tables.index;
    let narrow = tables.pieces.len() <= 256;
    let bucket = if narrow { code!(u8) } else { code!(u16) };
    let (low, density) = (number(index.low), number(index.density));
    let halvings = Literal::u32_unsuffixed(index.halvings);
    let buckets = index
        .buckets
        .iter()
        .map(|place| Literal::usize_unsuffixed(*place));
    let pieces = tables.pieces.iter().map(|piece| {
        let (from, origin) = (number(piece.from), number(piece.origin));
        let coefficients = piece.coefficients.iter().map(|of| {
            let of = of.iter().map(|coefficient| number(*coefficient));
            code!([#(#of),*])
        });
        code!(Piece { from: #from, origin: #origin, coefficients: [#(#coefficients),*] })
    });
    let quotient = |product: &Product<S>| quotient(emission, product);
    let sliding = tables.sliding.as_ref().map(|product| {
        let quotient = quotient(product);
        let (checksum, error) = (checksum::about(&quotient), sliding_error(tables));
        code! {
            /// β*_lim = gain·|q|.  q is the numerator over the denominator, or the root of this quotient if `squared`.  Of the factors,
            /// `Zero` is (r − at − rest)(r + at), `Pair` (that + off)² + least, and `Real` r² + off.
            ///
            #[doc = #error]
            #[doc = #checksum]
            const SLIDING_LIMIT: Quotient<'static, #scalar> = #quotient;
        }
    });
    let excitation_about = if tables.functions == 2 {
        " V, with its sign, in the same way."
    } else {
        " |V| in the same way."
    };
    let excitation = tables.excitation.as_ref().map(|product| {
        let quotient = quotient(product);
        let checksum = checksum::about(&quotient);
        code! {
            #[doc = #excitation_about]
            #[doc = #checksum]
            const EXCITATION: Quotient<'static, #scalar> = #quotient;
        }
    });
    let constants = checked(emission, tables);
    let about = about(tables);
    let (limit_about, sliding_about) = (limit_about(tables), sliding_about(tables));
    let domain = domain(emission, tables);
    let sliding_limit = if tables.sliding.is_some() {
        code!(Some(Self::SLIDING_LIMIT.magnitude(r)))
    } else {
        code!({
            let _ = r;
            None
        })
    };
    let contact = motion.then(|| contact(emission, tables));
    let numbers = fields(
        true,
        &[
            ("low", low, "where the first bucket begins"),
            ("density", density, "buckets per unit of r"),
            (
                "halvings",
                code!(#halvings),
                "comparisons that find the piece of r in its bucket",
            ),
            (
                "buckets",
                code!(&[#(#buckets),*]),
                "the first piece of each bucket",
            ),
            (
                "pieces",
                code!(&[#(#pieces),*]),
                "from the r `from` on, each function is Σ coefficients[j]·(r − origin)^j",
            ),
        ],
    );
    let checksum = checksum::about(&numbers);
    let tables = code! {
            #(#[doc = #about])*
            #[doc = #checksum]
            const TABLE: Table<'static, #scalar, ::core::primitive::#bucket, #functions, #terms> =
                Table { #numbers };
            #sliding
            #excitation
    };
    let items = code! {
        impl Tabled for #name {
            #domain

            #(#[doc = #limit_about])*
            #[inline]
            fn tabled_limit(&self, r: #scalar) -> #scalar {
                Self::TABLE.first(r)
            }

            #(#[doc = #sliding_about])*
            #[inline]
            fn tabled_sliding_limit(&self, r: #scalar) -> Option<#scalar> {
                #sliding_limit
            }
        }

        #contact
    };
    EmittedCode {
        items,
        tables,
        constants,
        ..EmittedCode::default()
    }
}

/// Emits the method that computes the motion of the contact from the tables.
fn contact<S: Float>(emission: &Emission<'_>, tables: &Tables<S>) -> TokenStream {
    let Emission {
        scalar,
        names: TypeNames { name, motion, .. },
        ..
    } = emission;
    let table = match tables.functions {
        5 => code!(Some(ContactTable::tabled(Self::TABLE.values(r)))),
        4 => code!(Some(ContactTable::damped(
            Self::TABLE.values(r),
            Self::EXCITATION.value(r)
        ))),
        2 => code!(Some(ContactTable::undamped(
            Self::TABLE.values(r),
            Self::EXCITATION.value(r)
        ))),
        _ => code!({
            let _ = r;
            None
        }),
    };
    let accuracy = tables.request.accuracy;
    let about = format!(
        " To {accuracy:e} up to β = {MOST_SHARE}·β_lim, relative in the amplitude and in rad in the phase; nearer to β_lim this bound grows as 1/(1 − (β/β_lim)²)."
    );
    let proof = format!(" {}", tables.motion_proof.told_in::<S>());
    code! {
        impl TabledMotion for #name {
            type Moving = #motion;

            /// Numbers from which amplitude and phase of the contact follow (2.21, 5.35, 5.38, 7.20, 7.21): with ρ = β/β_lim the
            /// amplitude is |V|(√(1 − ρ²a²) − ρg), and the phase atan2(−ρa, √(1 − ρ²a²)) − arg V.
            ///
            #[doc = #about]
            ///
            #[doc = #proof]
            #[inline]
            fn tabled_contact(&self, r: #scalar) -> Option<ContactTable<#scalar>> {
                #table
            }
        }
    }
}

pub(super) fn quotient<S: Float>(emission: &Emission<'_>, product: &Product<S>) -> TokenStream {
    let denominator = factors(emission, &product.denominator);
    quotient_over(emission, product, &code!(&#denominator))
}

/// Emits a product over zeros, divided by a product over poles. `denominator` is the emitted expression for the poles.
pub(super) fn quotient_over<S: Float>(
    emission: &Emission<'_>,
    product: &Product<S>,
    denominator: &TokenStream,
) -> TokenStream {
    let gain = emission.literal(product.gain.to_f64());
    let squared = product.squared;
    let numerator = factors(emission, &product.numerator);
    code! {
        Quotient {
            gain: #gain,
            squared: #squared,
            numerator: &#numerator,
            denominator: #denominator,
        }
    }
}

/// Emits the factors of a product as an array.
pub(super) fn factors<S: Float>(emission: &Emission<'_>, factors: &[Factor<S>]) -> TokenStream {
    let number = |value: S| emission.literal(value.to_f64());
    let factors = factors.iter().map(|factor| match *factor {
        Factor::Zero { at, rest } => {
            let (at, rest) = (number(at), number(rest));
            code!(Factor::Zero { at: #at, rest: #rest })
        }
        Factor::Pair {
            at,
            rest,
            off,
            least,
        } => {
            let (at, rest) = (number(at), number(rest));
            let (off, least) = (number(off), number(least));
            code!(Factor::Pair { at: #at, rest: #rest, off: #off, least: #least })
        }
        Factor::Real { off } => {
            let off = number(off);
            code!(Factor::Real { off: #off })
        }
    });
    code!([#(#factors),*])
}

/// Returns documentation lines that describe the table and its largest error.
fn about<S: Float>(tables: &Tables<S>) -> Vec<String> {
    let (low, high) = tables.request.r;
    let functions = match tables.functions {
        5 => "β_lim, a = β_lim·U/|V|, g = β_lim·G/|V|, arg V and |V|",
        4 => "β_lim, a = β_lim·U/|V|, g = β_lim·G/|V| and arg V",
        2 => "β_lim and a·sgn V = β_lim·U/V",
        _ => "β_lim",
    };
    let TableReport { worst, points, .. } = tables.report;
    let bytes = tables.bytes_without_stuck();
    let accuracy = tables.request.accuracy;
    let side = match tables.request.side {
        Side::Near => "",
        Side::Safe => ", never above it",
    };
    vec![
        format!(" {functions} over r from {low} to {high}, to {accuracy:e}{side}:"),
        format!(
            " {} pieces of degree {} and {} buckets; with β*_lim {bytes} bytes.",
            tables.pieces.len(),
            tables.terms - 1,
            tables.index.buckets.len(),
        ),
        format!(
            " Largest error of all of them {:.1e}, at r = {}: checked at {points} points that the fit did not use.",
            worst.error,
            worst.place::<S>()
        ),
    ]
}

fn sliding_error<S: Float>(tables: &Tables<S>) -> String {
    format!(
        " Largest error {:.1e} at the points of the check.",
        tables.report.sliding.error
    )
}

fn limit_about<S: Float>(tables: &Tables<S>) -> Vec<String> {
    // True if the tables spent no work on a proof, although a proof of this accuracy is possible.
    let untried = tables.proof.work == ProofWork(0) && FINEST_PROVEN <= tables.request.accuracy;
    let remedy = match (untried, cfg!(feature = "proof")) {
        (true, true) => "  `proof: whole` in the scene asks for a proof.",
        (true, false) => {
            "  With the feature `proof` of frictiongen, `proof: whole` in the scene asks for a proof."
        }
        (false, _) => "",
    };
    let made = if tables.proof.evidence == Evidence::Proven {
        "  The macro and `expand` made this proof, and `frictiongen compile` makes it only with `--prove`."
    } else {
        ""
    };
    vec![
        " β_lim (5.65, 5.80, 5.96, 7.49) from the table.  Its error is relative.".to_owned(),
        String::new(),
        format!(" {}{remedy}{made}", tables.proof.told_in::<S>()),
        String::new(),
        format!(
            " Operations: at every r a lookup of {}, {} additions and multiplications.",
            counted(tables.index.halvings as usize, "comparison"),
            tables.additions_and_multiplications(),
        ),
    ]
}

/// Returns a number with a noun, in the plural unless the number is 1.
pub(super) fn counted(count: usize, noun: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {noun}{plural}")
}

fn sliding_about<S: Float>(tables: &Tables<S>) -> Vec<String> {
    let mut about =
        vec![" β*_lim = |V|/(μ|H|) (6.11, 6.27, 6.33).  Its error is relative.".to_owned()];
    match &tables.sliding {
        Some(product) => {
            let (plain, divisions, roots) = product.operations();
            about.push(String::new());
            about.push(format!(" {}", tables.sliding_proof.told_in::<S>()));
            about.push(String::new());
            about.push(format!(
                " Operations: {plain} additions and multiplications, {}, {}.",
                counted(divisions, "division"),
                counted(roots, "root"),
            ));
        }
        None => {
            about.push(" The exact formulas answer: its zeros cannot be told apart.".to_owned())
        }
    }
    about
}
