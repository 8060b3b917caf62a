//! Emits the formulas of the limits of the friction ratio: β_lim of continuous motion, and β*_lim of sliding.

use super::emission::Emission;
use super::mode::operations_about;
use super::trace::Tracer;
use crate::graph::Expr;
use crate::graph::count::OperationCount;
use crate::graph::print::Printed;
use proc_macro2::TokenStream;

/// Emits the formulas of β_lim (limit of continuous motion) and β*_lim (limit of sliding) as methods of the kernel's
/// trait `Scene`.
pub(super) fn formulas(emission: &Emission<'_>) -> TokenStream {
    let scalar = &emission.scalar;
    let graph = emission.graph(emission.modes());
    let tracer = Tracer::over_constants(&graph, &emission.modal, emission.precision);
    let chain = &tracer.reduced.chain;
    let contact = tracer.contact("contact");
    let formula = |output: Expr<'_>| -> (TokenStream, String) {
        let (printed, count) = tracer.print(
            &[output.operand()],
            emission.precision,
            &["contact", "constraint"],
        );
        let Printed {
            statements,
            outputs,
        } = printed;
        (code!(#statements #(#outputs)*), operations_about(&count))
    };
    let (break_away, break_away_count) = formula(chain.break_away(&contact));
    let limit = chain.continuous_limit(&contact, graph.input("constraint"));
    let (continuous, continuous_count) = formula(limit);
    let reduced = &emission.reduced;
    let same = emission.loads_contact().then(|| {
        code! {
            ///
            /// The load acts on the mass that rubs: V = H.
        }
    });
    let is_one =
        reduced.quadratures.is_empty() && reduced.chain.sliding_limit_is_one(&reduced.modes);
    let (given, (sliding, sliding_count)) = if is_one {
        (
            code!(_),
            (code!(1.0), operations_about(&OperationCount::default())),
        )
    } else {
        (code!(contact), formula(chain.sliding_limit(&contact)))
    };
    code! {
        /// r²E(H_c + μm*/r²) = r²EH_c + μm*E: with it in β_lim the contact breaks away at once at every reversal (5.63, 7.47).
        ///
        #[doc = #break_away_count]
        #[inline]
        fn break_away(&self, contact: &ContactAt<#scalar>) -> #scalar {
            #break_away
        }

        /// β_lim = |V|/√(U² + max(S, H_c + μm*/r²)²) (5.65, 5.80, 5.96, 7.49), with S the largest J(τ)/sin τ over
        /// 0 < τ < π.  With more friction the contact would reverse within the half period.  `constraint` is r²E times
        /// that maximum.  r²J is the sum of (φᵀw)²((1 + g)p + uR²(cos τ − p′)) over the modes.  p is the free motion of
        /// a mode, p″ + 2ζxp′ + x²p = 0, from p = 0 and p′ = 1 at τ = 0.
        ///
        #[doc = #continuous_count]
        #[inline]
        fn continuous_limit(&self, contact: &ContactAt<#scalar>, constraint: #scalar) -> #scalar {
            #continuous
        }

        /// β*_lim = |V|/(μ|H|) (6.11, 6.27, 6.33).
        #same
        ///
        #[doc = #sliding_count]
        #[inline]
        fn sliding_limit(&self, #given: &ContactAt<#scalar>) -> #scalar {
            #sliding
        }
    }
}
