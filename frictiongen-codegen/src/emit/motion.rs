//! Emits the continuous motion of the contact and of the masses that the scene provides.

use super::arm::{self, Arm};
use super::emission::{Emission, Part};
use super::names::{TypeNames, field, local};
use super::trace::Tracer;
use crate::graph::alternatives::{self, Alternative};
use crate::graph::print::Printed;
use crate::graph::{Expr, Graph, Operand};
use frictiongen_kernel::response::coefficients::{Fundamental, ModalCoefficients};
use proc_macro2::{Ident, Literal, TokenStream};

/// Names that the code around the formulas already uses.
const TAKEN: [&str; 8] = [
    "at",
    "inverse_r",
    "contact",
    "modes",
    "beta",
    "friction",
    "fundamental",
    "waves",
];

/// Emits the type of the motion, with a method for each mass.
pub(super) fn emit(emission: &Emission<'_>, masses: &[(usize, &Ident)]) -> Part {
    let Emission {
        description,
        facade,
        names: TypeNames { name, motion, .. },
        ..
    } = emission;
    let visibility = &description.visibility;
    let tabled = emission.is_tabled();
    let (exact, how) = if tabled {
        (
            "",
            ": of the contact to the declared accuracy, of the masses exact",
        )
    } else {
        ("exact ", "")
    };
    let about = format!(
        " The {exact}continuous motion of [`{name}`] at one frequency and one friction ratio{how}."
    );
    let inner = if tabled {
        code!(table::Moving)
    } else {
        code!(response::Continuous)
    };
    let types = code! {
        #[doc = #about]
        #[allow(deprecated, non_camel_case_types)]
        #visibility struct #motion(#facade::kernel::#inner<#name>);
    };
    let methods = masses.iter().map(|(mass, method)| {
        let about = format!(" The motion of mass `{method}` (5.50 and its exact form, 7.29).");
        let as_contact = emission.moves_as_contact(*mass);
        let motion = if as_contact {
            code!(self.contact())
        } else {
            let mass = Literal::usize_unsuffixed(*mass);
            code!(self.mass(#mass))
        };
        let answer = if as_contact && tabled {
            code!(SteadyContact)
        } else {
            code!(MotionOf)
        };
        let why = as_contact.then(|| {
            code! {
                ///
                /// It rubs on a support at rest: its motion is the contact's.
            }
        });
        code! {
            #[doc = #about]
            #why
            #[must_use]
            pub fn #method(&self) -> #answer<#name> {
                #motion
            }
        }
    });
    let (by_formulas, wraps) = if tabled {
        let wraps = code!(#facade::kernel::wraps!(#motion, Moving of tabled #name, Copy););
        (code!(Continuous<Self>), wraps)
    } else {
        let wraps = code!(#facade::kernel::wraps!(#motion, Continuous of #name, Copy););
        (code!(#motion), wraps)
    };
    let in_lines = (!emission.in_sums()).then(|| in_lines(emission, masses));
    let items = code! {
        impl ProvidesMotion for #name {
            type Motion = #by_formulas;

            #in_lines
        }

        #wraps

        impl #motion {
            #(#methods)*
        }
    };
    Part {
        types,
        associated: TokenStream::new(),
        items,
    }
}

/// Emits the motions of a scene with few modes in straight lines, as methods of the kernel's `ProvidesMotion`.
fn in_lines(emission: &Emission<'_>, masses: &[(usize, &Ident)]) -> TokenStream {
    let scalar = &emission.scalar;
    let modes = emission.mode_names();
    let masses: Vec<usize> = masses
        .iter()
        .map(|(mass, _)| *mass)
        .filter(|mass| !emission.moves_as_contact(*mass))
        .collect();
    let graph = Graph::new(emission.modes());
    let tracer = Tracer::over_constants(&graph, &emission.modal, emission.precision);
    let body = of_masses(emission, &tracer, &masses);
    let contact = of_contact(emission, &tracer);
    let constants = (emission.damped() || tracer.names_constants()).then(|| emission.constants());
    let has_powers = emission.damped() || emission.reduced.chain.on_moving_base.is_some();
    let powers = has_powers.then(|| {
        code! {
            /// `…_in_range` is times 2²⁴ = 16777216, or over it, which keeps products within the scalar's range and cancels.  `inverse` is
            /// 1/V by way of `unit`, V over its `size`, |re| + |im|; `turning` is V less a mode's own term, or V where that is smaller,
            /// as a mode is in phase with its own; `in_phase_over_v` is `root` over that `size`.
        }
    });
    let masses = (!masses.is_empty()).then(|| {
        code! {
            /// The motion of a mass k, in the same coefficients.  `driven` is a mode's φ_k(φᵀp)·`response`, their sum V_k; `rubbed_back`
            /// is −φ_k(φᵀw)·u, their sum −U_k; `mismatch` is V_kU − U_kV, in which each mode's product with itself, which would cancel,
            /// is left out: `v_term` and `u_term` are a mode's own in V and U, `v_others` and `u_others` what is left without them.  Where
            /// x < 1/2 the mode is mass-controlled: `mass_wave` has all of its response, so that `u_in_sum` and `offset`, else u and g, are 0
            /// and `u_others` is all of U.
            #powers
            #[allow(unused_variables)]
            fn mass_motion(
                at: &At<Self>,
                friction: &Friction<#scalar>,
                mass: usize,
            ) -> Option<MotionOf<Self>> {
                let (inverse_r, contact) = (at.inverse_ratio(), at.contact_sums());
                #constants
                let [#(#modes),*] = at.modes();
                #body
                Some(Motion::of_mass(*friction, fundamental, waves))
            }
        }
    });
    code! {
        /// The relative motion in the contact, and each mode's part in it: `rise` times (1 − d)/x², `fall` times cos τ − d and
        /// `forced` times sin τ − R·q̃, with d and q̃ the mode's free decays from a displacement and from a velocity; `unscale`
        /// is 1/(r²E), `residue` φ_k(φᵀw)/r², for the harmonics.  `friction_force` is β/(r²E) times a mode's φ_k(φᵀw); `friction` has
        /// `root`, Q = √(|V|² − (βU)²) times r²E, and `amplitude`, Q − βG.
        #[allow(unused_variables)]
        fn contact_motion(at: &At<Self>, friction: &Friction<#scalar>) -> MotionOf<Self> {
            let (inverse_r, contact) = (at.inverse_ratio(), at.contact_sums());
            #constants
            let [#(#modes),*] = at.modes();
            #contact
            Motion::of_contact(*friction, fundamental, waves)
        }

        #masses
    }
}

/// Coefficients of a motion: the common ones and those of each mode.
struct Coefficients<'g> {
    fundamental: Fundamental<Expr<'g>>,
    /// Coefficients of each mode; `None` for a mode that the contact does not drive.
    modal: Vec<Option<ModalCoefficients<Expr<'g>>>>,
}

fn of_contact(emission: &Emission<'_>, tracer: &Tracer<'_>) -> TokenStream {
    let contact = tracer.contact("contact");
    let friction = tracer.friction();
    let chain = &tracer.reduced.chain;
    let modes = tracer.reduced.modes.iter().zip(tracer.modes_at());
    let inverse_r = tracer.graph.input("inverse_r");
    let coefficients = Coefficients {
        fundamental: chain.contact_fundamental(&contact, &friction),
        modal: modes
            .enumerate()
            .map(|(index, (mode, at))| {
                let residue = mode.inverse_mass;
                mode.in_contact.then(|| {
                    chain.modal_coefficients(&at, residue, &contact, &friction, inverse_r, index)
                })
            })
            .collect(),
    };
    let (printed, _) = tracer.print(&coefficients.outputs(), emission.precision, &TAKEN);
    let (fundamental, waves) = coefficients.structures(emission, &printed, &code!(motion_wave));
    let statements = printed.statements;
    code! {
        #statements
        let fundamental = #fundamental;
        let waves = #waves;
    }
}

/// Emits the common statements of the masses' motions, and the statements of each mass.
fn of_masses(emission: &Emission<'_>, tracer: &Tracer<'_>, masses: &[usize]) -> TokenStream {
    let motions = masses.iter().map(|mass| {
        let coefficients = of_mass(tracer, *mass);
        let alternative = Alternative::of(tracer.graph, coefficients.outputs());
        ((*mass, coefficients), alternative)
    });
    let (motions, alternatives) = alternatives::grouped(motions);
    let (common, printed) = alternatives::print(&alternatives, emission.precision, &TAKEN);
    let arms = motions.iter().zip(&printed).map(|(motions, printed)| {
        let masses = motions.iter().map(|(mass, _)| *mass).collect();
        let structures = motions
            .first()
            .map(|(_, coefficients)| coefficients.structures(emission, printed, &code!(mass_wave)));
        let (fundamental, waves) = structures.unwrap_or_default();
        Arm {
            masses,
            statements: printed.statements.clone(),
            value: code!((#fundamental, #waves)),
        }
    });
    let arms: Vec<Arm> = arms.collect();
    let (statements, value) = arm::chosen(&arms);
    code! {
        #common
        #statements
        let (fundamental, waves) = #value;
    }
}

fn of_mass<'g>(tracer: &Tracer<'g>, mass: usize) -> Coefficients<'g> {
    let contact = tracer.contact("contact");
    let (friction, inverse_r) = (tracer.friction(), tracer.graph.input("inverse_r"));
    let (chain, at) = (&tracer.reduced.chain, tracer.modes_at());
    let (shape, modes) = (tracer.reduced.shape(mass), &tracer.reduced.modes);
    let parts = modes.iter().zip(&at).zip(shape).enumerate();
    Coefficients {
        fundamental: chain.fundamental_loaded(
            shape,
            tracer.loaded(),
            &at,
            &contact,
            &friction,
            inverse_r,
        ),
        modal: parts
            .map(|(index, ((mode, at), component))| {
                let residue = *component * mode.contact;
                mode.in_contact.then(|| {
                    chain
                        .mass_coefficients(mode, at, residue, &contact, &friction, inverse_r, index)
                })
            })
            .collect(),
    }
}

impl Coefficients<'_> {
    fn outputs(&self) -> Vec<Operand> {
        let Fundamental {
            cosine,
            sine,
            response,
        } = self.fundamental;
        let mut outputs = vec![cosine, sine, response.re, response.im];
        for modal in self.modal.iter().flatten() {
            outputs.extend([modal.rise, modal.fall, modal.forced, modal.residue]);
        }
        outputs.into_iter().map(Expr::operand).collect()
    }

    /// Returns the printed outputs as the fundamental component and the waves of the modes.
    fn structures(
        &self,
        emission: &Emission<'_>,
        printed: &Printed,
        wave: &TokenStream,
    ) -> (TokenStream, TokenStream) {
        let (fundamental, modal) = printed.outputs.split_at(printed.outputs.len().min(4));
        let fundamental = match fundamental {
            [cosine, sine, re, im] => {
                code!(Fundamental { cosine: #cosine, sine: #sine, response: Complex { re: #re, im: #im } })
            }
            _ => TokenStream::new(),
        };
        let mut printed = modal.chunks(4);
        let waves = self.modal.iter().enumerate().map(|(index, modal)| {
            let mode = local(&format!("mode_{}", index + 1));
            let decay = decay(emission, index);
            match modal.and_then(|_| printed.next()) {
                Some([rise, fall, forced, residue]) => {
                    let (rise, fall) = (field("rise", rise), field("fall", fall));
                    let (forced, residue) = (field("forced", forced), field("residue", residue));
                    code!(#wave(#mode.x, #decay, ModalCoefficients { #rise, #fall, #forced, #residue }))
                }
                _ => code!(Wave::at_rest(#mode.x, #decay)),
            }
        });
        (fundamental, code!([#(#waves),*]))
    }
}

/// Emits the decay of a mode.
fn decay(emission: &Emission<'_>, mode: usize) -> TokenStream {
    if !emission.damped() {
        return code!(Undamped);
    }
    let (scalar, constants) = (&emission.scalar, local(&format!("constants_{}", mode + 1)));
    code!(<Damped<#scalar> as Decay<#scalar>>::of(#constants))
}
