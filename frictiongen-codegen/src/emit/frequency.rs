//! Emits the frequency stage, which evaluates a scene at one frequency ratio r.

use super::emission::Emission;
use super::names::{field, local};
use super::trace::{Tracer, contact_outputs, mode_outputs};
use super::{legend, mode};
use crate::graph::count::Count;
use crate::graph::{Expr, Graph, Operand};
use frictiongen_kernel::Scalar;
use frictiongen_kernel::contact::quadrature::Quadrature;
use frictiongen_kernel::contact::sums::{Chain, ContactAt};
use frictiongen_kernel::number::complex::Complex;
use frictiongen_kernel::oscillator::mode::{Kind, Mode};
use proc_macro2::{Literal, TokenStream};

/// Code of the frequency stage: the methods of the kernel's `Scene` and the function that they
/// share.
pub(super) struct Stage {
    pub function: TokenStream,
    pub methods: TokenStream,
}

pub(super) fn emit(emission: &Emission<'_>) -> Stage {
    let scalar = &emission.scalar;
    let modes = Literal::usize_unsuffixed(emission.modes());
    let in_passes = uniform_kind(&emission.reduced.modes).filter(|_| emission.in_passes());
    let (body, operations) = match in_passes {
        Some(kind) => passes(emission, kind),
        None if emission.modes() == 1 => single(emission),
        None => straight(emission),
    };
    let operations = format!(" Operations: {operations}.");
    let on_base = emission.reduced.chain.on_moving_base.is_some();
    let mut legend = match emission.reduced.modes.as_slice() {
        [mode] => legend::single(mode, on_base),
        _ if in_passes.is_some() => legend::sums(on_base),
        _ => legend::lines(on_base, emission.loads_contact()),
    };
    if !emission.reduced.quadratures.is_empty() {
        legend.extend(legend::FROM_BASE);
    }
    let about = code! {
        /// The response and damping functions V, U, G, H of the contact (3.11, 5.20, 5.34, 5.37, 7.11, 7.12), each
        /// times r²E with the scale E that keeps them finite on a resonance, and each mode's part in them.
        #(#[doc = #legend])*
        ///
        #[doc = #operations]
    };
    let body = code!(#body (contact, modes));
    let types = code!((ContactAt<#scalar>, [ModeAt<#scalar>; #modes]));
    if in_passes.is_some() {
        return Stage {
            function: TokenStream::new(),
            methods: code! {
                #about
                #[inline]
                fn frequency_stage(&self, inverse_r: #scalar) -> #types {
                    #body
                }
            },
        };
    }
    // Without damping G is 0, so the parameter `WITH_G` is not emitted.
    let (choice, all, but_g) = if emission.damped() {
        (
            code!(<const WITH_G: bool>),
            code!(::<true>),
            code!(::<false>),
        )
    } else {
        let none = TokenStream::new;
        (none(), none(), none())
    };
    Stage {
        function: code! {
            #about
            #[inline(always)]
            fn functions #choice (inverse_r: #scalar) -> #types {
                #body
            }
        },
        methods: code! {
            /// All functions of the contact at 1/r, and of its modes.
            #[inline]
            fn frequency_stage(&self, inverse_r: #scalar) -> #types {
                Self::functions #all (inverse_r)
            }

            /// Those of the contact without G, which only a motion needs.
            #[inline]
            fn contact_without_g(&self, inverse_r: #scalar) -> ContactAt<#scalar> {
                Self::functions #but_g (inverse_r).0
            }
        },
    }
}

fn uniform_kind(modes: &[Mode<f64>]) -> Option<Kind> {
    let kind = modes.first()?.kind;
    modes.iter().all(|mode| mode.kind == kind).then_some(kind)
}

/// Names that the code around the formulas already uses.
const TAKEN: [&str; 3] = ["inverse_r", "contact", "modes"];

/// Emits the stage of a single mode. Its own size is the scale.
fn single(emission: &Emission<'_>) -> (TokenStream, String) {
    let graph = Graph::new(1);
    let tracer = Tracer::new(&graph, &emission.modal, emission.precision);
    let with_g = |g| graph.where_asked(mode::WITH_G, g);
    let (contact, at) = tracer.frequency(graph.input("inverse_r"), with_g);
    let mut outputs = contact_outputs(&contact);
    for at in &at {
        outputs.extend(mode_outputs(at));
    }
    let (printed, count) = tracer.print(&outputs, emission.precision, &TAKEN);
    let (contact, modes) = printed.outputs.split_at(printed.outputs.len().min(8));
    let contact = contact_structure(contact);
    let mode = mode_structure(modes);
    let statements = printed.statements;
    let body = code! {
        #statements
        let contact = #contact;
        let modes = [#mode];
    };
    (body, count.to_string())
}

/// Emits the functions of each mode, then the sums.
fn straight(emission: &Emission<'_>) -> (TokenStream, String) {
    let graph = Graph::new(emission.modes());
    let tracer = Tracer::over_constants(&graph, &emission.modal, emission.precision);
    let (blocks, mut count) = blocks(emission);
    let mut contact = tracer.joined();
    contact.g = graph.where_asked(mode::WITH_G, contact.g);
    let outputs = contact_outputs(&contact);
    let (printed, operations) = tracer.print(
        &outputs,
        emission.precision,
        &["scale", "inverse_r", "contact", "modes"],
    );
    count = count.and(&operations);
    let statements = printed.statements;
    let contact = contact_structure(&printed.outputs);
    let body = code! {
        #blocks
        #statements
        let contact = #contact;
    };
    (body, count.to_string())
}

/// Emits the functions of each mode, the scale, and the modes at that scale, from which the sums
/// over the modes start.
fn blocks(emission: &Emission<'_>) -> (TokenStream, Count) {
    let mut count = Count::default();
    let mut body = emission.constants();
    let names = emission.mode_names();
    for (index, name) in names.iter().enumerate() {
        let (call, operations) = mode::call(emission, index);
        count = count.and(&operations);
        body.extend(code!(let #name = #call;));
    }
    let graph = Graph::new(emission.modes());
    let tracer = Tracer::over_constants(&graph, &emission.modal, emission.precision);
    let chain = &tracer.reduced.chain;
    // E, the common scale, is formed from the modes that the contact drives.
    let responses: Vec<_> = (1..=names.len())
        .map(|mode| tracer.response(&format!("mode_{mode}")))
        .collect();
    let constants = &tracer.reduced.modes;
    let sizes = responses.iter().map(|response| response.size);
    let scale = Chain::scale(constants.iter().zip(sizes));
    let (printed, operations) = tracer.print(&[scale.operand()], emission.precision, &TAKEN);
    count = count.and(&operations);
    let scale = printed.outputs;
    body.extend(code! {
        let scale = #(#scale)*;
        let modes = [#(Self::CHAIN.at_scale(&#names, scale)),*];
    });
    let scaled = chain.scaled(&tracer.response("mode"), graph.input("scale"), false, 0);
    let operations = Count::of(&graph, &mode_outputs(&scaled)).times(names.len());
    count = count.and(&operations);
    let at_names = (1..=names.len()).map(|mode| local(&format!("at_{mode}")));
    body.extend(code!(let [#(#at_names),*] = &modes;));
    (body, count)
}

fn contact_structure(outputs: &[TokenStream]) -> TokenStream {
    let [scale, v_re, v_im, u, g, reversal, h_re, h_im] = outputs else {
        return TokenStream::new();
    };
    let (scale, u, g) = (field("scale", scale), field("u", u), field("g", g));
    let reversal = field("reversal", reversal);
    code! {
        ContactAt {
            #scale,
            v: Complex { re: #v_re, im: #v_im },
            #u,
            #g,
            #reversal,
            h: Complex { re: #h_re, im: #h_im },
        }
    }
}

fn mode_structure(outputs: &[TokenStream]) -> TokenStream {
    let [x, re, im, u, g] = outputs else {
        return TokenStream::new();
    };
    let (x, u, g) = (field("x", x), field("u", u), field("g", g));
    code!(ModeAt { #x, response: Complex { re: #re, im: #im }, #u, #g })
}

/// Emits the stage as two passes over the array of modes. The body of each pass is the formula of
/// one mode.
fn passes(emission: &Emission<'_>, kind: Kind) -> (TokenStream, String) {
    let Emission {
        precision, scalar, ..
    } = emission;
    let modes = Literal::usize_unsuffixed(emission.modes());
    let damped = emission.damped();
    let graph = Graph::new(1);
    let tracer = Tracer::new(&graph, &emission.modal, *precision);
    let chain = &tracer.reduced.chain;
    let symbolic = mode::symbolic(&graph, kind);

    let first = symbolic.response(graph.input("inverse_r"), 0);
    let first_count = Count::of(&graph, &mode::outputs(&first));
    let function = mode::function_of(kind, &code!(true));
    let every_mode = emission.reduced.modes.iter().all(|mode| mode.in_contact);
    let smallest = code!(scale = Scalar::min(scale, response.size););
    let smallest = if every_mode {
        smallest
    } else {
        code!(if mode.in_contact { #smallest })
    };
    let first_pass = code! {
        let mut responses = [ModeResponse::<#scalar>::zero(); #modes];
        let mut scale = ::core::#scalar::INFINITY;
        for (mode, response) in IntoIterator::into_iter(&Self::MODES).zip(&mut responses) {
            *response = Self::#function(mode, inverse_r);
            #smallest
        }
    };

    let response = tracer.response("response");
    let at = chain.scaled(&response, graph.input("sum.scale"), false, 0);
    let sum = symbolic_sum(&graph, damped);
    // The loop binds both numbers of a mode's load in quadrature, if there is one.
    let from_base = !emission.reduced.quadratures.is_empty();
    let quadrature = from_base.then(|| Quadrature {
        load: graph.input("quadrature"),
        wall: graph.input("wall"),
    });
    let loaded = (&symbolic, quadrature);
    let term = chain.term(sum.scale, loaded, &response, &at, false, true);
    let joined = chain.with_term(&sum, &term, true);
    let mut outputs = mode_outputs(&at);
    let sums = [
        joined.v.re,
        joined.v.im,
        joined.u,
        joined.g,
        joined.reversal,
        joined.h.re,
        joined.h.im,
    ];
    outputs.extend(sums.map(Expr::operand));
    let taken = [
        "r",
        "inverse_r",
        "sum",
        "mode",
        "response",
        "at",
        "contact",
        "modes",
        "quadrature",
        "wall",
    ];
    let (second, second_count) = tracer.print(&outputs, *precision, &taken);
    let statements = &second.statements;
    let (at, sums) = second.outputs.split_at(5);
    let at = mode_structure(at);
    let [v_re, v_im, u, g, reversal, h_re, h_im] = sums else {
        return (TokenStream::new(), String::new());
    };
    let imaginary = damped.then(|| {
        code! {
            sum.v.im = #v_im;
            sum.h.im = #h_im;
            sum.g = #g;
            sum.reversal = #reversal;
        }
    });
    let loop_head = if from_base {
        code! {
            for (((mode, response), at), &[quadrature, wall]) in
                IntoIterator::into_iter(&Self::MODES).zip(&responses).zip(&mut modes).zip(&Self::QUADRATURES)
        }
    } else {
        code! {
            for ((mode, response), at) in
                IntoIterator::into_iter(&Self::MODES).zip(&responses).zip(&mut modes)
        }
    };
    let completed = chain.completed(&sum, graph.input("inverse_r"));
    let outputs: Vec<Operand> = contact_outputs(&completed);
    let (last, last_count) = tracer.print(&outputs, *precision, &taken);
    let contact = contact_structure(&last.outputs);
    let last_statements = &last.statements;
    let body = code! {
        #first_pass
        let mut sum = ContactAt::<#scalar>::zero(scale);
        let mut modes = [ModeAt::<#scalar>::zero(); #modes];
        #loop_head {
            #statements
            *at = #at;
            sum.v.re = #v_re;
            sum.u = #u;
            sum.h.re = #h_re;
            #imaginary
        }
        #last_statements
        let contact = #contact;
    };
    let count = first_count
        .and(&second_count)
        .times(emission.modes())
        .and(&last_count);
    (body, count.to_string())
}

fn symbolic_sum(graph: &Graph, damped: bool) -> ContactAt<Expr<'_>> {
    let of = |field: &str| graph.input(format!("sum.{field}"));
    let if_damped = |field: &str| {
        if damped {
            of(field)
        } else {
            Expr::constant(0.0)
        }
    };
    ContactAt {
        scale: of("scale"),
        v: Complex::new(of("v.re"), if_damped("v.im")),
        u: of("u"),
        g: if_damped("g"),
        reversal: if_damped("reversal"),
        h: Complex::new(of("h.re"), if_damped("h.im")),
    }
}
