//! The formulas of both limits, and a slice of them.

use super::Emission;
use super::trace::Tracer;
use crate::graph::print::Printed;
use crate::graph::{Expr, Graph};
use proc_macro2::TokenStream;

/// The limits' formulas, as methods of the kernel's `Scene`.
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
    let sliding = formula(chain.sliding_limit(&contact));
    code! {
        /// r²E(H_c + μm*/r²), what the contact force needs for break-away at a reversal (5.63, 7.47).
        #[inline]
        fn break_away(&self, contact: &ContactAt<#scalar>) -> #scalar {
            #break_away
        }

        /// β_lim = |V|/√(U² + max(S, H_c + μm*/r²)²) (5.65, 5.80, 5.96, 7.49); `constraint` is r²E times that
        /// maximum.
        #[inline]
        fn continuous_limit(&self, contact: &ContactAt<#scalar>, constraint: #scalar) -> #scalar {
            #continuous
        }

        /// β*_lim = |V|/(μ|H|) (6.11, 6.27, 6.33).
        #[inline]
        fn sliding_limit(&self, contact: &ContactAt<#scalar>) -> #scalar {
            #sliding
        }
    }
}

/// Both limits over a slice.
pub(super) fn slices(emission: &Emission<'_>) -> TokenStream {
    let scalar = &emission.scalar;
    let of = if emission.is_tabled() {
        code!(Compiled)
    } else {
        code!(At)
    };
    code! {
        /// Both limits over a slice of frequency ratios, into slices of the same length.
        ///
        /// # Errors
        /// `OutOfDomain` for a slice of another length, which changes nothing, and at the first NaN or negative r.
        pub fn limits_into(
            rs: &[#scalar],
            continuous: &mut [#scalar],
            sliding: &mut [#scalar],
        ) -> Result<(), OutOfDomain> {
            #of::limits_into(Self, rs, continuous, sliding)
        }
    }
}
