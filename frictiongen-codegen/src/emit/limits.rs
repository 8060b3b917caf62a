//! The formulas of both limits, and a slice of them.

use super::trace::Tracer;
use super::{Emission, field, frequency};
use crate::graph::count::Count;
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
    let without_search = without_search(emission);
    let reduced = &emission.reduced;
    let on_contact = reduced.chain.on_moving_base.is_none()
        && reduced
            .modes
            .iter()
            .all(|mode| mode.residue == mode.inverse_mass);
    let same = on_contact.then(|| {
        code! {
            ///
            /// The load acts on the mass that rubs: V = H.
        }
    });
    code! {
        /// r²E(H_c + μm*/r²): its part in β_lim makes the contact break away at once at every reversal (5.63, 7.47).
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
        fn sliding_limit(&self, contact: &ContactAt<#scalar>) -> #scalar {
            #sliding
        }

        #without_search
    }
}

/// Both limits from 1/r on, as one function of straight lines; nothing where the frequency stage is passes.
fn without_search(emission: &Emission<'_>) -> TokenStream {
    if emission.in_passes() {
        return TokenStream::new();
    }
    let scalar = &emission.scalar;
    let graph = Graph::new(emission.modes());
    let tracer = Tracer::new(&graph, &emission.modal, emission.precision);
    let (blocks, contact, count) = if emission.modes() == 1 {
        let contact = tracer.frequency(graph.input("inverse_r")).0;
        (TokenStream::new(), contact, Count::default())
    } else {
        let (blocks, count) = frequency::blocks(emission, false);
        (blocks, tracer.joined(false), count)
    };
    let outputs = tracer.limits_of(&contact).map(Expr::operand);
    let taken = ["inverse_r", "scale", "modes"];
    let (printed, operations) = tracer.print(&outputs, emission.precision, &taken);
    let (statements, count) = (printed.statements, count.and(&operations));
    let [continuous, sliding, h] = printed.outputs.as_slice() else {
        return TokenStream::new();
    };
    let (continuous, sliding) = (field("continuous", continuous), field("sliding", sliding));
    let operations = format!(" Operations: {count}.");
    code! {
        /// Both limits (5.64; 6.11, 6.27, 6.33) and Re H, without what only a motion needs; names as in `frequency_stage`.
        ///
        #[doc = #operations]
        #[inline]
        fn limits_without_search(&self, inverse_r: #scalar) -> (Limits<#scalar>, #scalar) {
            #blocks
            #statements
            (Limits { #continuous, #sliding }, #h)
        }
    }
}

/// Both limits from r on, and over a slice.
pub(super) fn slices(emission: &Emission<'_>) -> TokenStream {
    let scalar = &emission.scalar;
    let (of, first) = if emission.is_tabled() {
        (code!(Compiled), "r out of the domain, as of `at`")
    } else {
        (code!(At), "NaN or negative r")
    };
    let errors = format!(
        " `OutOfDomain` for slices of unequal lengths, and then nothing is written; at the first {first}, up to which it is."
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
