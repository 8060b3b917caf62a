//! Emits the formulas of both limits, and the functions for slices of frequencies.

use super::emission::Emission;
use super::trace::Tracer;
use crate::graph::print::Printed;
use crate::graph::{Expr, Graph};
use proc_macro2::TokenStream;

/// Emits the formulas of both limits as methods of the kernel's `Scene`.
pub(super) fn formulas(emission: &Emission<'_>) -> TokenStream {
    let scalar = &emission.scalar;
    let graph = Graph::new(emission.modes());
    let tracer = Tracer::new(&graph, &emission.modal, emission.precision);
    let chain = &tracer.reduced.chain;
    let contact = tracer.contact("contact");
    let formula = |output: Expr<'_>| -> TokenStream {
        let (printed, _) = tracer.print(
            &[output.operand()],
            emission.precision,
            &["contact", "constraint"],
        );
        let Printed {
            statements,
            outputs,
        } = printed;
        code!(#statements #(#outputs)*)
    };
    let break_away = formula(chain.break_away(&contact));
    let limit = chain.continuous_limit(&contact, graph.input("constraint"));
    let continuous = formula(limit);
    let reduced = &emission.reduced;
    let same = emission.loads_contact().then(|| {
        code! {
            ///
            /// The load acts on the mass that rubs: V = H.
        }
    });
    let is_one =
        reduced.quadratures.is_empty() && reduced.chain.sliding_limit_is_one(&reduced.modes);
    let (given, sliding) = if is_one {
        (code!(_), code!(1.0))
    } else {
        (code!(contact), formula(chain.sliding_limit(&contact)))
    };
    code! {
        /// r²E(H_c + μm*/r²) = `reversal` + μm*E: in β_lim it ensures that the contact breaks away at once at every reversal (5.63, 7.47).
        #[inline]
        fn break_away(&self, contact: &ContactAt<#scalar>) -> #scalar {
            #break_away
        }

        /// β_lim = |V|/√(U² + max(S, H_c + μm*/r²)²) (5.65, 5.80, 5.96, 7.49), with S the largest F(τ)/sin τ over
        /// 0 < τ < π, F a sum over modes: with more friction the contact would reverse within the half period.
        /// `constraint` is r²E times that maximum.
        #[inline]
        fn continuous_limit(&self, contact: &ContactAt<#scalar>, constraint: #scalar) -> #scalar {
            #continuous
        }

        /// β*_lim = |V|/(μ|H|) (6.11, 6.27, 6.33).
        #same
        #[inline]
        fn sliding_limit(&self, #given: &ContactAt<#scalar>) -> #scalar {
            #sliding
        }
    }
}

/// Emits both limits as functions of r, and over a slice.
pub(super) fn slices(emission: &Emission<'_>) -> TokenStream {
    let scalar = &emission.scalar;
    let (of, first) = if emission.is_tabled() {
        (code!(Compiled), "r out of the domain, as of `at`")
    } else {
        (code!(At), "NaN or negative r")
    };
    let errors = format!(
        " `OutOfDomain` for slices of unequal lengths, before anything is written; and at the first {first}, after what precedes it is."
    );
    code! {
        /// Both limits without search: |V|/√(U² + (H_c + μm*/r²)²) (5.64), an upper bound of β_lim that leaves S out, and
        /// β*_lim (6.11, 6.27, 6.33).  Where nothing else is asked of r, this is the shortest way.
        ///
        /// # Errors
        /// `OutOfDomain` for NaN and negative r; 0 and ∞ answer with the limits.
        #[inline]
        pub fn limits_without_search(r: #scalar) -> Result<Limits<#scalar>, OutOfDomain> {
            At::limits_without_search(&Self, r)
        }

        /// Both limits over a slice of frequency ratios, into slices of the same length.
        ///
        /// # Errors
        #[doc = #errors]
        pub fn limits_into(
            rs: &[#scalar],
            continuous: &mut [#scalar],
            sliding: &mut [#scalar],
        ) -> Result<(), OutOfDomain> {
            #of::limits_into(Self, rs, continuous, sliding)
        }
    }
}
