//! Emits the code that computes the continuous motion of the contact and of the masses that the scene provides.

use super::arm::{self, Arm};
use super::emission::{Emission, EmittedCode};
use super::mode::operations_about;
use super::names::{TypeNames, field, local};
use super::trace::Tracer;
use crate::graph::alternatives::{self, Alternative};
use crate::graph::count::OperationCount;
use crate::graph::print::Printed;
use crate::graph::{Expr, Operand};
use frictiongen_kernel::response::coefficients::{Fundamental, ModalCoefficients};
use proc_macro2::{Ident, Literal, TokenStream};

/// Names that the code around the formulas uses. Values of the formulas must not have these names.
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
pub(super) fn emit(emission: &Emission<'_>, masses: &[(usize, &Ident)]) -> EmittedCode {
    let Emission {
        description,
        facade,
        names: TypeNames { name, motion, .. },
        ..
    } = emission;
    let visibility = &description.visibility;
    let tabled = emission.is_tabled();
    let (exact, how) = if tabled {
        ("Continuous", accuracies(emission, masses))
    } else {
        ("Exact continuous", String::new())
    };
    let about =
        format!(" {exact} motion of [`{name}`] at one frequency and one friction ratio{how}.");
    let inner = if tabled {
        code!(table::Moving)
    } else {
        code!(response::Continuous)
    };
    let types = code! {
        #[doc = #about]
        #[allow(deprecated, non_camel_case_types, reason = "names and attributes are those of the description")]
        #visibility struct #motion(#facade::kernel::#inner<#name>);
    };
    let methods = masses.iter().map(|(mass, method)| {
        let about = format!(" Motion of mass `{method}` (5.50 and its exact form, 7.29).");
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
                /// It rubs on a support at rest, so its motion is that of the contact.
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
    let of_contact = if tabled {
        code!(SteadyContact<#name>)
    } else {
        code!(MotionOf<#name>)
    };
    let contact = emission.contact_method(&code!(contact), &of_contact);
    let (by_formulas, wraps) = if tabled {
        let wraps = code!(#facade::kernel::wraps!(#motion, Moving of tabled #name, Copy););
        (code!(Continuous<Self>), wraps)
    } else {
        let wraps = code!(#facade::kernel::wraps!(#motion, Continuous of #name, Copy););
        (code!(#motion), wraps)
    };
    let in_lines = (!emission.in_sums()).then(|| in_lines(emission, masses));
    let of_kernel = in_lines.is_none().then(|| {
        code! {
            /// The motions are those of the kernel, which sums over the modes in loops.  Worst case: a fixed number of operations
            /// for each mode.  No search is made before an amplitude or a phase is asked for.
        }
    });
    let items = code! {
        #of_kernel
        impl ProvidesMotion for #name {
            type Motion = #by_formulas;

            #in_lines
        }

        /// `Clone`, `Copy`, `Debug`, `From` and `Deref`: the motion has all methods of the wrapped type.
        #wraps

        impl #motion {
            #(#methods)*

            #contact
        }
    };
    EmittedCode {
        types,
        items,
        ..EmittedCode::default()
    }
}

/// Returns a documentation text that says which motions come from tables.
fn accuracies(emission: &Emission<'_>, masses: &[(usize, &Ident)]) -> String {
    let moves_as_contact = |mass: usize| emission.moves_as_contact(mass);
    let same = masses.iter().find(|(mass, _)| moves_as_contact(*mass));
    let tabled = same.map_or_else(String::new, |(_, name)| {
        format!(", which is that of `{name}`,")
    });
    let exact = if masses.iter().all(|(mass, _)| moves_as_contact(*mass)) {
        ""
    } else if same.is_some() {
        ", those of the other masses by the exact formulas"
    } else {
        ", those of the masses by the exact formulas"
    };
    format!(": that of the contact{tabled} to the declared accuracy{exact}")
}

/// Emits straight-line code for the motions of a scene with few modes, as methods of the kernel's `ProvidesMotion`.
fn in_lines(emission: &Emission<'_>, masses: &[(usize, &Ident)]) -> TokenStream {
    let scalar = &emission.scalar;
    let masses: Vec<usize> = masses
        .iter()
        .map(|(mass, _)| *mass)
        .filter(|mass| !emission.moves_as_contact(*mass))
        .collect();
    let graph = emission.graph(emission.modes());
    let tracer = Tracer::over_constants(&graph, &emission.modal, emission.precision);
    let (body, mass_operations) = of_masses(emission, &tracer, &masses);
    let (contact, contact_operations) = of_contact(emission, &tracer);
    let [mass_operations, contact_operations] =
        [mass_operations, contact_operations].map(|count| operations_about(&count));
    let waves = waves_about(emission);
    let inputs = emission.inputs(&body);
    let contact_inputs = emission.inputs(&contact);
    let masses = (!masses.is_empty()).then(|| {
        code! {
            /// The motion of mass k: its terms of cos τ and sin τ, and the coefficients of each mode.
            ///
            /// The coefficients are those of `contact_motion`, with φ_k(φᵀw) in place of (φᵀw)².
            /// The two products of a mode with itself cancel, so both are left out.  A mode with x < 1/2 is
            /// mass-controlled: `mass_wave` has its whole response, and its u and g are 0 in the sums.
            ///
            #[doc = #mass_operations]
            #[doc = #waves]
            fn mass_motion(
                at: &At<Self>,
                friction: &Friction<#scalar>,
                mass: usize,
            ) -> Option<MotionOf<Self>> {
                #inputs
                #body
                Some(Motion::of_mass(*friction, fundamental, waves))
            }
        }
    });
    code! {
        /// The relative motion in the contact: its terms of cos τ and sin τ, and the coefficients of each mode's functions.
        ///
        /// d and q̃ are free motions of a mode, solutions of y″ + 2ζxy′ + x²y = 0: d from d = 1 and d′ = 0 at τ = 0, and q̃
        /// from q̃ = 0 and q̃′ = x.  The coefficients multiply (1 − d)/x² (`rise`), cos τ − d (`fall`, 0 without damping)
        /// and sin τ − Rq̃ (`forced`).  `harmonic` is (φᵀw)²/r², which only higher harmonics need.  Of `friction`, `unscale`
        /// is 1/(r²E), `amplitude` is Q − βG with Q = √(|V|² − (βU)²), and `root` is Q·r²E.
        ///
        #[doc = #contact_operations]
        #[doc = #waves]
        fn contact_motion(at: &At<Self>, friction: &Friction<#scalar>) -> MotionOf<Self> {
            #contact_inputs
            #contact
            Motion::of_contact(*friction, fundamental, waves)
        }

        #masses
    }
}

/// Coefficients of the motion of the contact or of a mass, for its fundamental component and for each mode.
struct Coefficients<'g> {
    fundamental: Fundamental<Expr<'g>>,
    /// Coefficients of each mode; `None` for a mode that the contact does not drive.
    modal: Vec<Option<ModalCoefficients<Expr<'g>>>>,
}

/// Returns the documentation line about the work that the kernel's functions do for a motion. The number of operations
/// of the emitted function excludes this work.
fn waves_about(emission: &Emission<'_>) -> String {
    let modes = emission.modes();
    let plural = if modes == 1 { "" } else { "s" };
    format!(
        " The kernel adds one wave for each of {modes} mode{plural}.  No search is made before an amplitude or a phase is asked for."
    )
}

fn of_contact(emission: &Emission<'_>, tracer: &Tracer<'_>) -> (TokenStream, OperationCount) {
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
                let residue = mode.contact_squared;
                mode.in_contact.then(|| {
                    chain.modal_coefficients(&at, residue, &contact, &friction, inverse_r, index)
                })
            })
            .collect(),
    };
    let (printed, count) = tracer.print(&coefficients.outputs(), emission.precision, &TAKEN);
    let (fundamental, waves) = coefficients.structures(emission, &printed, &code!(motion_wave));
    let statements = printed.statements;
    let body = code! {
        #statements
        let fundamental = #fundamental;
        let waves = #waves;
    };
    (body, count)
}

/// Emits the code that computes the motion of each mass: the statements that all masses share, then the statements of
/// each mass. The second result is the number of operations for the mass that needs the most.
fn of_masses(
    emission: &Emission<'_>,
    tracer: &Tracer<'_>,
    masses: &[usize],
) -> (TokenStream, OperationCount) {
    let motions = masses.iter().map(|mass| {
        let coefficients = of_mass(tracer, *mass);
        let alternative = Alternative::of(tracer.graph, coefficients.outputs());
        ((*mass, coefficients), alternative)
    });
    let (motions, alternatives) = alternatives::grouped(motions);
    let count = alternatives::most_operations(tracer.graph, &alternatives);
    let (common, printed) = alternatives::print(&alternatives, emission.precision, &TAKEN);
    let arms = motions.iter().zip(&printed).map(|(motions, printed)| {
        let masses = motions.iter().map(|(mass, _)| *mass).collect();
        let structures = motions
            .first()
            .map(|(_, coefficients)| coefficients.structures(emission, printed, &code!(mass_wave)));
        let (fundamental, waves) = structures.unwrap_or_default();
        let value = code!((#fundamental, #waves));
        let statements = &printed.statements;
        let shape = emission.shape(&code!(#statements #value));
        Arm {
            masses,
            statements: code!(#shape #statements),
            value,
        }
    });
    let arms: Vec<Arm> = arms.collect();
    let (statements, value) = arm::chosen(&arms, emission.scene.masses.len());
    let body = code! {
        #common
        #statements
        let (fundamental, waves) = #value;
    };
    (body, count)
}

fn of_mass<'g>(tracer: &Tracer<'g>, mass: usize) -> Coefficients<'g> {
    let contact = tracer.contact("contact");
    let (friction, inverse_r) = (tracer.friction(), tracer.graph.input("inverse_r"));
    let (chain, at) = (&tracer.reduced.chain, tracer.modes_at());
    let (shape, modes) = (tracer.shape(mass), &tracer.reduced.modes);
    let parts = modes.iter().zip(&at).zip(&shape).enumerate();
    Coefficients {
        fundamental: chain.fundamental_loaded(
            &shape,
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
            outputs.extend([modal.rise, modal.fall, modal.forced, modal.harmonic]);
        }
        outputs.into_iter().map(Expr::operand).collect()
    }

    /// Returns the expressions of a motion in the emitted code: its fundamental component, and the waves of its modes.
    /// `printed` has the numbers in these expressions.
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
                Some([rise, fall, forced, harmonic]) => {
                    let (rise, fall) = (field("rise", rise), field("fall", fall));
                    let (forced, harmonic) = (field("forced", forced), field("harmonic", harmonic));
                    code!(#wave(#mode.x, #decay, ModalCoefficients { #rise, #fall, #forced, #harmonic }))
                }
                _ => code!(Wave::at_rest(#mode.x, #decay)),
            }
        });
        (fundamental, code!([#(#waves),*]))
    }
}

/// Emits the value that describes the decay of a mode. It is `Undamped`, or the constants of a damped mode.
fn decay(emission: &Emission<'_>, mode: usize) -> TokenStream {
    if !emission.damped() {
        return code!(Undamped);
    }
    let (scalar, constants) = (&emission.scalar, local(&format!("constants_{}", mode + 1)));
    code!(<Damped<#scalar> as Decay<#scalar>>::of(#constants))
}
