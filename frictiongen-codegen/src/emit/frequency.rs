//! The frequency stage: a scene at one r.

use super::trace::{Tracer, contact_outputs, mode_outputs};
use super::{Emission, Part, derives, field};
use crate::graph::{Expr, Graph, Operand};
use frictiongen_kernel::Scalar;
use frictiongen_kernel::chain::ContactAt;
use frictiongen_kernel::complex::Complex;
use frictiongen_kernel::mode::{Kind, Mode, ModeResponse};
use proc_macro2::{Literal, TokenStream};

pub(super) fn emit(emission: &Emission<'_>) -> Part {
    let Emission {
        description,
        scalar,
        name,
        at,
        ..
    } = emission;
    let visibility = &description.visibility;
    let derives = derives();
    let modes = Literal::usize_unsuffixed(emission.modes());
    let facade = emission.facade;
    let about =
        format!(" [`{name}`] at one frequency ratio: what both limits and every motion share.");
    let types = code! {
        #[doc = #about]
        #derives
        #[allow(non_camel_case_types)]
        #visibility struct #at {
            r: ::core::primitive::#scalar,
            inverse_r: ::core::primitive::#scalar,
            contact: #facade::kernel::chain::ContactAt<::core::primitive::#scalar>,
            modes: [#facade::kernel::chain::ModeAt<::core::primitive::#scalar>; #modes],
        }
    };
    let uniform = uniform_kind(&emission.reduced.modes);
    let (body, operations) = match uniform {
        Some(kind) if emission.in_passes() => passes(emission, kind),
        _ => straight(emission),
    };
    let (low, high) = match emission.precision {
        frictiongen_model::scene::Precision::F64 => range::<f64>(emission),
        frictiongen_model::scene::Precision::F32 => range::<f32>(emission),
    };
    let (low, high) = (emission.literal(low), emission.literal(high));
    let operations = format!(" Operations: {operations}.");
    let items = code! {
        impl #name {
            /// The scene at the frequency ratio r = ω√(m₁/k₁): the response and damping functions
            /// V, U, G, H of the contact (3.11, 5.20, 5.34, 5.37, 7.11, 7.12), each times r²E with
            /// the scale E that keeps them finite on a resonance.
            ///
            #[doc = #operations]
            ///
            /// # Errors
            /// `OutOfDomain` for NaN and negative r; 0 and ∞ answer with the limits.
            #[inline]
            pub fn at(r: #scalar) -> Result<#at, OutOfDomain> {
                let r = regime::check_ratio(r, "r")?;
                let inverse_r = Scalar::min(Scalar::max(1.0 / r, #low), #high);
                #body
                Ok(#at { r, inverse_r, contact, modes })
            }
        }
    };
    Part { types, items }
}

fn range<S: frictiongen_kernel::Float>(emission: &Emission<'_>) -> (f64, f64) {
    let resonances = emission.reduced.modes.iter().map(|mode| mode.resonance);
    let (low, high) = frictiongen_kernel::regime::inverse_ratio_range(resonances.map(S::constant));
    (low.to_f64(), high.to_f64())
}

fn uniform_kind(modes: &[Mode<f64>]) -> Option<Kind> {
    let kind = modes.first()?.kind;
    modes.iter().all(|mode| mode.kind == kind).then_some(kind)
}

fn straight(emission: &Emission<'_>) -> (TokenStream, String) {
    let graph = Graph::new(emission.modes());
    let tracer = Tracer::new(&graph, &emission.modal, emission.precision);
    let (contact, at) = tracer.frequency(graph.input("inverse_r"));
    let mut outputs = contact_outputs(&contact);
    for at in &at {
        outputs.extend(mode_outputs(at));
    }
    let (printed, count) = tracer.print(
        &outputs,
        emission.precision,
        &["r", "inverse_r", "contact", "modes"],
    );
    let (contact, modes) = structures(&printed.outputs);
    let statements = printed.statements;
    let body = code! {
        #statements
        let contact = #contact;
        let modes = [#(#modes),*];
    };
    (body, count.to_string())
}

/// Contact and modes from their outputs, in the order of the tracing.
fn structures(outputs: &[TokenStream]) -> (TokenStream, Vec<TokenStream>) {
    let (contact, modes) = outputs.split_at(outputs.len().min(8));
    let contact = contact_structure(contact);
    (contact, modes.chunks(5).map(mode_structure).collect())
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

/// The same in two passes over the array of modes, each with the formula of one mode as its body.
fn passes(emission: &Emission<'_>, kind: Kind) -> (TokenStream, String) {
    let Emission {
        precision, scalar, ..
    } = emission;
    let modes = Literal::usize_unsuffixed(emission.modes());
    let damped = emission.damped();
    let graph = Graph::new(1);
    let tracer = Tracer::new(&graph, &emission.modal, *precision);
    let chain = &tracer.reduced.chain;
    let symbolic = symbolic_mode(&graph, kind);

    let first = symbolic.response(graph.input("inverse_r"), 0);
    let ModeResponse {
        x,
        denominator,
        size,
        u,
        g,
        reversal,
    } = first;
    let outputs = [x, denominator.re, denominator.im, size, u, g, reversal].map(Expr::operand);
    let taken = ["r", "inverse_r", "scale", "mode", "response", "responses"];
    let (first, first_count) = tracer.print(&outputs, *precision, &taken);
    let statements = &first.statements;
    let [x, re, im, size, u, g, reversal] = first.outputs.as_slice() else {
        return (TokenStream::new(), String::new());
    };
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
            #statements
            *response = ModeResponse {
                x: #x,
                denominator: Complex { re: #re, im: #im },
                size: #size,
                u: #u,
                g: #g,
                reversal: #reversal,
            };
            #smallest
        }
    };

    let response = symbolic_response(&graph, damped);
    let at = chain.scaled(&response, graph.input("sum.scale"), false, 0);
    let sum = symbolic_sum(&graph, damped);
    let joined = chain.joined_by(&sum, &symbolic, &response, &at, false);
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
    let completed = chain.completed(&sum, graph.input("inverse_r"));
    let outputs: Vec<Operand> = contact_outputs(&completed);
    let (last, last_count) = tracer.print(&outputs, *precision, &taken);
    let contact = contact_structure(&last.outputs);
    let last_statements = &last.statements;
    let body = code! {
        #first_pass
        let mut sum = ContactAt::<#scalar>::zero(scale);
        let mut modes = [ModeAt::<#scalar>::zero(); #modes];
        for ((mode, response), at) in
            IntoIterator::into_iter(&Self::MODES).zip(&responses).zip(&mut modes)
        {
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

fn symbolic_mode(graph: &Graph, kind: Kind) -> Mode<Expr<'_>> {
    let of = |field: &str| graph.input(format!("mode.{field}"));
    let zeta = if kind == Kind::Undamped {
        Expr::Number(0.0)
    } else {
        of("zeta")
    };
    Mode {
        kind,
        in_contact: true,
        resonance: of("resonance"),
        zeta,
        q: of("q"),
        q_defect: of("q_defect"),
        load: of("load"),
        contact: of("contact"),
        residue: of("residue"),
        mobility: of("mobility"),
        static_residue: of("static_residue"),
    }
}

fn symbolic_response(graph: &Graph, damped: bool) -> ModeResponse<Expr<'_>> {
    let of = |field: &str| graph.input(format!("response.{field}"));
    let if_damped = |field: &str| {
        if damped {
            of(field)
        } else {
            Expr::constant(0.0)
        }
    };
    ModeResponse {
        x: of("x"),
        denominator: Complex::new(of("denominator.re"), if_damped("denominator.im")),
        size: of("size"),
        u: of("u"),
        g: if_damped("g"),
        reversal: if_damped("reversal"),
    }
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
