//! Both limits, the regime between them, and a slice of them.

use super::Emission;
use super::trace::Tracer;
use crate::graph::Graph;
use crate::graph::count::Count;
use crate::graph::print::Printed;
use proc_macro2::TokenStream;

pub(super) fn emit(emission: &Emission<'_>) -> TokenStream {
    let Emission {
        scalar,
        name,
        at,
        facade,
        decay,
        ..
    } = emission;
    let graph = Graph::new(emission.modes());
    let tracer = Tracer::new(&graph, &emission.modal, emission.precision);
    let chain = &tracer.reduced.chain;
    let contact = tracer.contact("contact");
    let formula = |output: crate::graph::Expr<'_>| -> (TokenStream, Count) {
        let taken = ["r", "contact", "modes", "constraint", "beta"];
        let (
            Printed {
                statements,
                outputs,
            },
            count,
        ) = tracer.print(&[output.operand()], emission.precision, &taken);
        (code!(#statements #(#outputs)*), count)
    };
    let (with_constraint, exact_count) =
        formula(chain.continuous_limit(&contact, graph.input("constraint")));
    let (without_search, without_count) =
        formula(chain.continuous_limit(&contact, chain.break_away(&contact)));
    let (sliding, sliding_count) = formula(chain.sliding_limit(&contact));
    let absorbs = !emission.damped() && emission.scene.has_absorber();
    let (modes, sliding) = if absorbs {
        let stiction = emission.literal(emission.reduced.chain.stiction);
        let guarded = code! {
            // Masses beyond the contact absorb: V and H have zeros in common.
            if let Some(force) = #name::CHAIN.absorbed_force(&contact, &#name::MODES, &modes) {
                Scalar::abs(force) / #stiction
            } else {
                #sliding
            }
        };
        (code!(modes,), guarded)
    } else {
        (code!(), sliding)
    };
    let exact_count = format!(" Operations: {exact_count}, after the search.");
    let without_count = format!(" Operations: {without_count}.");
    let sliding_count = format!(" Operations: {sliding_count}.");
    let every_mode_counts = if emission.damped() {
        code!()
    } else {
        code! {
            /// Without damping the search is needed only where some R < 1/2.
        }
    };
    code! {
        impl #at {
            /// β_lim = |V|/√(U² + max(S, H_c + μm*/r²)²), exact: the boundary of continuous motion
            /// (5.65, 5.80, 5.96, 7.49), with S from a guaranteed search over the half period.
            #every_mode_counts
            ///
            #[doc = #exact_count]
            /// The search takes at most `kernel::search::MAX_EVALUATIONS` evaluations of a sum over the
            /// modes; `limits_searched` says how many, and whether it came to its end.
            #[must_use]
            pub fn continuous_limit(&self) -> #scalar {
                self.limit_searched().0
            }

            fn limit_searched(&self) -> (#scalar, Effort) {
                let Self { r, contact, modes, .. } = *self;
                let mut waves = #name::MODES.map(|mode| Wave::<#scalar, #decay>::idle(&mode));
                let constraint =
                    #name::CHAIN.velocity_constraint(&contact, &#name::MODES, &modes, &mut waves);
                let effort = constraint.effort();
                let constraint = constraint.value;
                let limit = { #with_constraint };
                (regime::with_ends(r, limit, 0.0, #name::CONTINUOUS_AT_INFINITY), effort)
            }

            /// Both limits, by one search: what is asked of them needs no other.
            #[must_use]
            pub fn limits(&self) -> Limits<#scalar> {
                Limits { continuous: self.continuous_limit(), sliding: self.sliding_limit() }
            }

            /// Both limits, and what the search took.
            #[must_use]
            pub fn limits_searched(&self) -> (Limits<#scalar>, Effort) {
                let (continuous, effort) = self.limit_searched();
                (Limits { continuous, sliding: self.sliding_limit() }, effort)
            }

            /// β_lim with S replaced by its limit for τ → 0 (5.64): an upper bound, exact wherever
            /// the start of the half period decides.
            ///
            #[doc = #without_count]
            #[inline]
            #[must_use]
            pub fn continuous_limit_without_search(&self) -> #scalar {
                let Self { r, contact, .. } = *self;
                let limit = { #without_search };
                regime::with_ends(r, limit, 0.0, #name::CONTINUOUS_AT_INFINITY)
            }

            /// β_lim with S as the sum of each mode's own maximum, as the thesis prints it (5.55,
            /// 7.37): a lower bound on β_lim.
            ///
            #[doc = #exact_count]
            #[must_use]
            pub fn continuous_limit_per_mode(&self) -> #scalar {
                let Self { r, contact, modes, .. } = *self;
                let constraint =
                    #name::CHAIN.constraint_per_mode::<#decay>(&contact, &#name::MODES, &modes);
                let limit = { #with_constraint };
                regime::with_ends(r, limit, 0.0, #name::CONTINUOUS_AT_INFINITY)
            }

            /// β*_lim = |V|/(μ|H|), from which on the contact never slides (6.11, 6.27, 6.33).
            ///
            #[doc = #sliding_count]
            #[inline]
            #[must_use]
            pub fn sliding_limit(&self) -> #scalar {
                let Self { r, contact, #modes .. } = *self;
                let limit = { #sliding };
                regime::with_ends(r, limit, #name::SLIDING_AT_REST, #name::SLIDING_AT_INFINITY)
            }

            /// The regime at the friction ratio β = F/P.  It searches for β_lim: for many β at one r, ask
            /// [`limits`](Self::limits) once.
            ///
            /// # Errors
            /// `OutOfDomain` for NaN, negative and infinite β.
            pub fn regime(&self, beta: #scalar) -> Result<Regime, OutOfDomain> {
                let beta = regime::check_beta(beta)?;
                Ok(regime::regime(beta, self.continuous_limit(), self.sliding_limit()))
            }

            /// β/min(β_lim, β*_lim) − 1: negative in the continuous regime.  It searches as `regime` does.
            ///
            /// # Errors
            /// `OutOfDomain` for NaN, negative and infinite β.
            pub fn margin(&self, beta: #scalar) -> Result<#scalar, OutOfDomain> {
                let beta = regime::check_beta(beta)?;
                Ok(regime::margin(beta, self.continuous_limit(), self.sliding_limit()))
            }
        }

        impl #name {
            /// Both limits over a slice of frequency ratios, into slices of the same length.
            ///
            /// # Errors
            /// `OutOfDomain` for a slice of another length, which leaves both as they are, and at the
            /// first NaN or negative r; what came before it is filled in.
            pub fn limits_into(
                rs: &[#scalar],
                continuous: &mut [#scalar],
                sliding: &mut [#scalar],
            ) -> Result<(), OutOfDomain> {
                for (room, argument) in [(continuous.len(), "continuous"), (sliding.len(), "sliding")] {
                    if room != rs.len() {
                        return Err(OutOfDomain { argument });
                    }
                }
                for ((r, continuous), sliding) in
                    IntoIterator::into_iter(rs).zip(continuous).zip(sliding)
                {
                    let at = Self::at(*r)?;
                    *continuous = at.continuous_limit();
                    *sliding = at.sliding_limit();
                }
                Ok(())
            }
        }

        impl #facade::LimitsAt for #at {
            type Scalar = #scalar;

            fn continuous_limit(&self) -> #scalar {
                Self::continuous_limit(self)
            }
            fn continuous_limit_without_search(&self) -> #scalar {
                Self::continuous_limit_without_search(self)
            }
            fn continuous_limit_per_mode(&self) -> #scalar {
                Self::continuous_limit_per_mode(self)
            }
            fn sliding_limit(&self) -> #scalar {
                Self::sliding_limit(self)
            }
            fn regime(&self, beta: #scalar) -> Result<Regime, OutOfDomain> {
                Self::regime(self, beta)
            }
            fn margin(&self, beta: #scalar) -> Result<#scalar, OutOfDomain> {
                Self::margin(self, beta)
            }
        }
    }
}
