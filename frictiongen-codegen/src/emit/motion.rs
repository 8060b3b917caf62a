//! The continuous motion: of the contact, and of the masses that the scene asks for.

use super::trace::Tracer;
use super::{Emission, Part, derives, field, local, rounded};
use crate::graph::{Expr, Graph};
use frictiongen_kernel::motion::{Carrier, Share};
use proc_macro2::{Ident, Literal, TokenStream};

const TAKEN: [&str; 8] = [
    "r",
    "inverse_r",
    "contact",
    "modes",
    "beta",
    "friction",
    "carrier",
    "waves",
];

pub(super) fn emit(emission: &Emission<'_>, masses: &[(usize, &Ident)]) -> Part {
    let Emission {
        description,
        scalar,
        name,
        at,
        motion,
        facade,
        decay,
        ..
    } = emission;
    let visibility = &description.visibility;
    let derives = derives();
    let about = format!(
        " The exact continuous motion of [`{name}`] at one frequency and one friction ratio."
    );
    let types = code! {
        #[doc = #about]
        #derives
        #[allow(non_camel_case_types)]
        #visibility struct #motion {
            at: #at,
            friction: #facade::kernel::motion::Friction<::core::primitive::#scalar>,
        }
    };
    let (friction, operations) = friction(emission);
    let operations = format!(" Operations: {operations}, after both limits.");
    let contact = of_contact(emission);
    let asked = masses.iter().map(|(index, name)| {
        let index = Literal::usize_unsuffixed(*index);
        code!(#facade::Of::Mass(#index) => Some(question(&self.#name())))
    });
    let methods = masses
        .iter()
        .map(|(index, name)| of_mass(emission, *index, name));
    let unbounded = emission.list(
        emission
            .modal
            .unbounded(false)
            .into_iter()
            .map(|r| rounded(r, emission.precision)),
    );
    let items = code! {
        impl #at {
            /// The exact continuous motion at the friction ratio β = F/P: amplitude and phase of
            /// the contact (5.35, 5.38, 7.20, 7.21) on the way.
            ///
            #[doc = #operations]
            ///
            /// # Errors
            /// `NotContinuous` says which regime it is instead, or that an undamped resonance is
            /// unbounded at this β, or that β is out of the domain.
            pub fn motion(&self, beta: #scalar) -> Result<#motion, NotContinuous> {
                let Self { r, inverse_r, contact, modes } = *self;
                let mut waves = #name::MODES.map(|mode| Wave::<#scalar, #decay>::idle(&mode));
                let beta = #name::CHAIN.admitted(
                    r,
                    beta,
                    self.sliding_limit(),
                    #name::CONTINUOUS_AT_INFINITY,
                    &#unbounded,
                    &contact,
                    &#name::MODES,
                    &modes,
                    &mut waves,
                )?;
                #friction
                Ok(#motion { at: *self, friction })
            }
        }

        impl #motion {
            #contact
            #(#methods)*
        }

        impl #facade::MotionAt for #at {
            type Motion = #motion;

            fn motion(&self, beta: #scalar) -> Result<#motion, NotContinuous> {
                Self::motion(self, beta)
            }
        }

        impl #facade::ContinuousMotion for #motion {
            type Scalar = #scalar;

            fn ask<T>(
                &self,
                of: #facade::Of,
                question: impl ::core::ops::FnOnce(&dyn #facade::Steady<Scalar = #scalar>) -> T,
            ) -> Option<T> {
                match of {
                    #facade::Of::Contact => Some(question(&self.contact())),
                    #(#asked,)*
                    #[allow(unreachable_patterns)]
                    _ => None,
                }
            }
        }
    };
    Part { types, items }
}

/// The friction stage: amplitude and phase of the contact.
fn friction(emission: &Emission<'_>) -> (TokenStream, String) {
    let graph = Graph::new(emission.modes());
    let tracer = Tracer::new(&graph, &emission.modal, emission.precision);
    let contact = tracer.contact("contact");
    let stage =
        tracer
            .reduced
            .chain
            .friction(&contact, graph.input("inverse_r"), graph.input("beta"));
    let outputs = [stage.root, stage.amplitude, stage.phase, stage.unscale].map(Expr::operand);
    let (printed, count) = tracer.print(&outputs, emission.precision, &TAKEN);
    let statements = printed.statements;
    let [root, amplitude, phase, unscale] = printed.outputs.as_slice() else {
        return (TokenStream::new(), String::new());
    };
    let (root, amplitude) = (field("root", root), field("amplitude", amplitude));
    let (phase, unscale) = (field("phase", phase), field("unscale", unscale));
    let statements = code! {
        let friction = {
            #statements
            Friction { beta, #root, #amplitude, #phase, #unscale }
        };
    };
    (statements, count.to_string())
}

/// What a motion's function begins with, and its modes by name.
fn opening(emission: &Emission<'_>, used: &[usize]) -> TokenStream {
    let at = &emission.at;
    let names = (0..emission.modes()).map(|index| {
        if used.contains(&index) {
            let name = local(&format!("mode_{}", index + 1));
            code!(#name)
        } else {
            code!(_)
        }
    });
    let modes = if emission.in_sums() {
        code!(modes)
    } else {
        code!(modes: [#(#names),*])
    };
    code! {
        let Self { at: #at { inverse_r, contact, #modes, .. }, friction } = *self;
    }
}

/// Values of a carrier.
const CARRIER: usize = 4;
/// Values of a mode's share.
const SHARE: usize = 4;

fn waves(
    emission: &Emission<'_>,
    wave: &TokenStream,
    used: &[usize],
    shares: &[TokenStream],
) -> TokenStream {
    let Emission { name, scalar, .. } = emission;
    let waves = used.iter().zip(shares.chunks(SHARE)).map(|(index, share)| {
        let mode = local(&format!("mode_{}", index + 1));
        let decay = if emission.damped() {
            let index = Literal::usize_unsuffixed(*index);
            code!(<Damped<#scalar> as Decay<#scalar>>::of(&#name::MODES[#index]))
        } else {
            code!(Undamped)
        };
        let [rise, fall, swing, gain] = share else {
            return TokenStream::new();
        };
        code!(#wave(#mode.x, #decay, Share { rise: #rise, fall: #fall, swing: #swing, gain: #gain }))
    });
    code!([#(#waves),*])
}

fn carrier_structure(outputs: &[TokenStream]) -> TokenStream {
    let [cosine, sine, re, im] = outputs else {
        return TokenStream::new();
    };
    code! {
        Carrier {
            cosine: #cosine,
            sine: #sine,
            response: Complex { re: #re, im: #im },
        }
    }
}

fn carrier_outputs<'g>(carrier: &Carrier<Expr<'g>>) -> [Expr<'g>; CARRIER] {
    let Carrier {
        cosine,
        sine,
        response,
    } = *carrier;
    [cosine, sine, response.re, response.im]
}

fn share_outputs<'g>(share: &Share<Expr<'g>>) -> [Expr<'g>; SHARE] {
    [share.rise, share.fall, share.swing, share.gain]
}

fn returned(emission: &Emission<'_>, waves: usize) -> TokenStream {
    let Emission { scalar, decay, .. } = emission;
    let waves = Literal::usize_unsuffixed(waves);
    code!(Motion<#scalar, #decay, [Wave<#scalar, #decay>; #waves]>)
}

fn of_contact(emission: &Emission<'_>) -> TokenStream {
    let Emission { decay, name, .. } = emission;
    let used: Vec<usize> = driven(emission, |mode| mode.in_contact);
    let opening = opening(emission, &used);
    let returned = returned(
        emission,
        if emission.in_sums() {
            emission.modes()
        } else {
            used.len()
        },
    );
    let graph = Graph::new(emission.modes());
    let tracer = Tracer::new(&graph, &emission.modal, emission.precision);
    let contact = tracer.contact("contact");
    let carrier = tracer
        .reduced
        .chain
        .contact_carrier(&contact, &tracer.friction());
    let mut outputs = carrier_outputs(&carrier).to_vec();
    if !emission.in_sums() {
        let at = tracer.modes_at();
        for (index, (mode, at)) in tracer.reduced.modes.iter().zip(&at).enumerate() {
            if mode.in_contact {
                let share =
                    tracer.share(index, mode.mobility, at, &contact, graph.input("inverse_r"));
                outputs.extend(share_outputs(&share));
            }
        }
    }
    let outputs: Vec<_> = outputs.into_iter().map(Expr::operand).collect();
    let (printed, count) = tracer.print(&outputs, emission.precision, &TAKEN);
    let (carrier, shares) = printed.outputs.split_at(printed.outputs.len().min(CARRIER));
    let carrier = carrier_structure(carrier);
    let statements = printed.statements;
    let waves = if emission.in_sums() {
        code! {
            #name::CHAIN.contact_waves::<#decay, _>(
                &#name::MODES, &modes, &contact, &friction, inverse_r,
            )
        }
    } else {
        waves(emission, &code!(steady::motion_wave), &used, shares)
    };
    let operations = format!(" Operations: {count}.");
    code! {
        /// The relative motion in the contact: x̄ of the mass, of the mass from the base, or of the
        /// later mass from the earlier.
        ///
        #[doc = #operations]
        #[must_use]
        pub fn contact(&self) -> #returned {
            #opening
            #statements
            let carrier = #carrier;
            let waves = #waves;
            Motion::of_contact(friction, carrier, waves)
        }
    }
}

fn driven(
    emission: &Emission<'_>,
    wanted: impl Fn(&frictiongen_kernel::mode::Mode<f64>) -> bool,
) -> Vec<usize> {
    let modes = emission.reduced.modes.iter().enumerate();
    modes
        .filter(|(_, mode)| wanted(mode))
        .map(|(index, _)| index)
        .collect()
}

fn of_mass(emission: &Emission<'_>, mass: usize, method: &Ident) -> TokenStream {
    let Emission {
        scalar,
        decay,
        name,
        modal,
        reduced,
        ..
    } = emission;
    let about = format!(" The motion of mass `{method}` (5.50 and its exact form, 7.29).");
    if reduced.chain.on_moving_base.is_none() && modal.contact == (mass, None) {
        let in_contact = driven(emission, |mode| mode.in_contact).len();
        let returned = returned(
            emission,
            if emission.in_sums() {
                emission.modes()
            } else {
                in_contact
            },
        );
        return code! {
            #[doc = #about]
            ///
            /// It rubs on a support at rest: its motion is the contact's.
            #[inline]
            #[must_use]
            pub fn #method(&self) -> #returned {
                self.contact()
            }
        };
    }
    let shape: Vec<f64> = reduced.shapes.get(mass).cloned().unwrap_or_default();
    if emission.in_sums() {
        let modes = Literal::usize_unsuffixed(emission.modes());
        let returned = returned(emission, emission.modes());
        let opening = opening(emission, &[]);
        let shape = emission.list(shape);
        return code! {
            #[doc = #about]
            #[must_use]
            pub fn #method(&self) -> #returned {
                const SHAPE: [#scalar; #modes] = #shape;
                #opening
                let carrier = #name::CHAIN.carrier(&SHAPE, &#name::MODES, &modes, &contact, &friction, inverse_r);
                let waves = #name::CHAIN.mass_waves::<#decay, _>(
                    &#name::MODES, &SHAPE, &modes, &contact, &friction, inverse_r,
                );
                Motion::of_mass(friction, carrier, waves)
            }
        };
    }
    let moves = |index: usize| shape.get(index).is_some_and(|component| *component != 0.0);
    let rubbed: Vec<usize> = driven(emission, |mode| mode.in_contact)
        .into_iter()
        .filter(|index| moves(*index))
        .collect();
    let graph = Graph::new(emission.modes());
    let tracer = Tracer::new(&graph, &emission.modal, emission.precision);
    let chain = &tracer.reduced.chain;
    let contact = tracer.contact("contact");
    let inverse_r = graph.input("inverse_r");
    let at = tracer.modes_at();
    let components = tracer.reduced.shapes.get(mass).cloned().unwrap_or_default();
    let carrier = chain.carrier(
        &components,
        &tracer.reduced.modes,
        &at,
        &contact,
        &tracer.friction(),
        inverse_r,
    );
    let mut outputs = carrier_outputs(&carrier).to_vec();
    for index in &rubbed {
        if let (Some(component), Some(mode), Some(at)) = (
            components.get(*index),
            tracer.reduced.modes.get(*index),
            at.get(*index),
        ) {
            let residue = *component * mode.contact;
            let share = tracer.mass_share(*index, mode, residue, at, &contact, inverse_r);
            outputs.extend(share_outputs(&share));
        }
    }
    let outputs: Vec<_> = outputs.into_iter().map(Expr::operand).collect();
    let (printed, count) = tracer.print(&outputs, emission.precision, &TAKEN);
    let (carrier, shares) = printed.outputs.split_at(printed.outputs.len().min(CARRIER));
    let carrier = carrier_structure(carrier);
    let statements = printed.statements;
    let waves = waves(emission, &code!(steady::mass_wave), &rubbed, shares);
    let all: Vec<usize> = (0..emission.modes()).collect();
    let opening = opening(emission, &all);
    let returned = returned(emission, rubbed.len());
    let operations = format!(" Operations: {count}.");
    code! {
        #[doc = #about]
        ///
        #[doc = #operations]
        #[must_use]
        #[allow(unused_variables)]
        pub fn #method(&self) -> #returned {
            #opening
            #statements
            let carrier = #carrier;
            let waves = #waves;
            Motion::of_mass(friction, carrier, waves)
        }
    }
}
