//! Emits the frequency stage, which evaluates a scene at one frequency ratio r.

use super::emission::Emission;
use super::mode::{self, operations_about};
use super::names::{field, local};
use super::trace::{Tracer, contact_outputs, mode_outputs, symbolic_sum};
use crate::graph::count::OperationCount;
use crate::graph::{Expr, Operand};
use frictiongen_kernel::contact::quadrature::Quadrature;
use frictiongen_kernel::contact::sums::Chain;
use frictiongen_kernel::oscillator::mode::{Kind, Mode};
use proc_macro2::{Ident, Literal, TokenStream};

/// Emitted code that evaluates a scene at one frequency ratio r: methods of the kernel's trait `Scene`, and the
/// function that these methods call.
pub(super) struct Stage {
    pub function: TokenStream,
    pub methods: TokenStream,
    /// Last argument of the kernel macro `scene_items`. It is empty unless the code loops over the array of modes.
    pub in_passes: TokenStream,
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
    let operations = operations_about(&operations);
    let on_base = emission.reduced.chain.on_moving_base.is_some();
    let response = if on_base {
        " r²V is the sum of r²·residue/λ·(1 − 2iζx)/(x² − 1 + 2iζx), relative to the moving base and with r²·`on_moving_base` added,"
    } else if emission.loads_contact() {
        " r²V = r²H, because the load acts on the mass that rubs."
    } else {
        " r²V is the sum of residue/(x² − 1 + 2iζx),"
    };
    let from_base: &[&str] = if emission.reduced.quadratures.is_empty() {
        &[]
    } else {
        &FROM_BASE
    };
    // Without damping some terms are 0. The emitted code has plain zeros for them.
    let undamped = (!emission.damped())
        .then(|| code!(#[doc = " Without damping r²G, r²H_c and the imaginary parts are 0."]));
    let without_g = emission.damped().then(|| {
        code! {
            /// With `WITH_G` false, g and r²G are 0, for callers that do not use them.
            /// `sin_cos_pi_minus(a, b)` is the sine and the cosine of π(a − b), `one_minus_sinc_pi(a)` is 1 − sin(πa)/(πa), and
            /// `scaled_sinh_defect(a)` is 1 − e^(−2a) − 2a·e^(−a).
        }
    });
    let about = code! {
        /// Sums V, H, U, G and H_c of the contact (3.11, 5.20, 5.34, 5.37, 7.11, 7.12), and the functions of the modes.
        ///
        /// V is the response of the contact to the load, and H to a force in the contact.  U is the slope and G the value, at a
        /// reversal, of its response to a square wave of friction.  H_c decides whether the contact breaks away there (5.63).
        ///
        /// Sums over the modes, with x = √λ/r = 1/R:
        #[doc = #response]
        /// r²H is the sum of (φᵀw)²/(x² − 1 + 2iζx), r²U that of (φᵀw)²uR², r²G that of (φᵀw)²gR², r²H_c that of (φᵀw)²(g + 2ζRu).
        /// Each is returned times E as `v`, `h`, `u`, `g` or `reversal`.  E, the `scale`, is the smallest |x² − 1| + 2ζx of the
        /// modes in contact, so that the sums stay finite on a resonance.
        #without_g
        #undamped
        #(#[doc = #from_base])*
        ///
        #[doc = #operations]
    };
    let body = code!(#body (contact, modes));
    let types = code!((ContactAt<#scalar>, [ModeAt<#scalar>; #modes]));
    if in_passes.is_some() {
        return Stage {
            function: TokenStream::new(),
            in_passes: code!(, in passes),
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
    let choice = emission.damped().then(|| code!(<const WITH_G: bool>));
    Stage {
        function: code! {
            #about
            #[inline(always)]
            fn functions #choice (inverse_r: #scalar) -> #types {
                #body
            }
        },
        methods: TokenStream::new(),
        in_passes: TokenStream::new(),
    }
}

/// Additional lines of emitted documentation, if damping acts on velocities relative to the moving base.
const FROM_BASE: [&str; 3] = [
    " Damping acts relative to the base: to residue·`response` in r²VE comes i(φᵀw)·2ζλΓ/x·`response` with Γ = φᵀΓ1, and on a moving",
    " base `static_residue` − 2iζx·wall takes the place of `static_residue`·(1 − 2iζx), wall being `static_residue` − (φᵀw)Γ.",
    " `QUADRATURES` has 2ζλΓ and wall of each mode.",
];

fn uniform_kind(modes: &[Mode<f64>]) -> Option<Kind> {
    let kind = modes.first()?.kind;
    modes.iter().all(|mode| mode.kind == kind).then_some(kind)
}

/// Names that the code around the formulas uses. Values of the formulas must not have these names.
const TAKEN: [&str; 3] = ["inverse_r", "contact", "modes"];

/// Emits the code that evaluates a scene with one mode at a frequency ratio r. The scale E, which keeps the sums over
/// the modes finite at a resonance, is the `size` of this mode.
fn single(emission: &Emission<'_>) -> (TokenStream, OperationCount) {
    let graph = emission.graph(1);
    let tracer = Tracer::over_constants(&graph, &emission.modal, emission.precision);
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
    let constants = emission.constants(&body);
    let body = code!(#constants #body);
    (body, count)
}

/// Emits straight-line code that evaluates a scene with several modes at a frequency ratio r. The code computes the
/// response of each mode, and then the sums V, H, U, G and H_c over the modes.
fn straight(emission: &Emission<'_>) -> (TokenStream, OperationCount) {
    let graph = emission.graph(emission.modes());
    let tracer = Tracer::over_constants(&graph, &emission.modal, emission.precision);
    if emission.in_sums() && emission.reduced.quadratures.is_empty() {
        return summed(emission);
    }
    let (calls, blocks, mut count) = blocks(emission);
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
        #calls
        #blocks
        #statements
        let contact = #contact;
    };
    let constants = emission.constants(&body);
    let body = code!(#constants #body);
    (body, count)
}

/// Emits the response of each mode at r. Then emits, for each mode, a call of the kernel function that adds the mode to
/// the sums V, H, U, G and H_c. The compiler inlines these calls, so the compiled code is that of straight-line code.
fn summed(emission: &Emission<'_>) -> (TokenStream, OperationCount) {
    let (calls, blocks, count) = blocks(emission);
    let graph = emission.graph(emission.modes());
    let tracer = Tracer::over_constants(&graph, &emission.modal, emission.precision);
    let outputs = contact_outputs(&tracer.joined());
    let count = count.and(&OperationCount::of(&graph, &outputs));
    let with_g = if emission.damped() {
        code!(WITH_G)
    } else {
        code!(false)
    };
    let mut sums = TokenStream::new();
    let modes = emission
        .mode_names()
        .into_iter()
        .zip(emission.constant_names());
    for (number, (mode, constants)) in (1..).zip(modes) {
        let at = local(&format!("at_{number}"));
        sums.extend(if number == 1 {
            code!(let sum = Self::CHAIN.begun_by(scale, #constants, &#mode, #at, #with_g);)
        } else if number == 2 {
            code! {
                /// `false`: this mode is not the only one, so that E is not always its own `size`
                let sum = Self::CHAIN.joined_by(&sum, #constants, &#mode, #at, false, #with_g);
            }
        } else {
            code!(let sum = Self::CHAIN.joined_by(&sum, #constants, &#mode, #at, false, #with_g);)
        });
    }
    let body = code! {
        #calls
        #blocks
        #sums
        let contact = Self::CHAIN.completed(&sum, inverse_r);
    };
    let constants = emission.constants(&body);
    (code!(#constants #body), count)
}

/// Emits the response of each mode at r. Also emits the scale E, which keeps the sums over the modes finite at a
/// resonance, and each response multiplied by E.
fn blocks(emission: &Emission<'_>) -> (TokenStream, TokenStream, OperationCount) {
    let mut count = OperationCount::default();
    let (mut calls, mut body) = (TokenStream::new(), TokenStream::new());
    let names = emission.mode_names();
    for (index, name) in names.iter().enumerate() {
        let (call, operations) = mode::call(emission, index);
        count = count.and(&operations);
        calls.extend(code!(let #name = #call;));
    }
    let graph = emission.graph(emission.modes());
    let tracer = Tracer::over_constants(&graph, &emission.modal, emission.precision);
    let chain = &tracer.reduced.chain;
    // The common scale E is the smallest `size` of the modes that the contact drives. The `size` of a mode is
    // |x² − 1| + 2ζx, with x = √λ/r.
    let responses: Vec<_> = (1..=names.len())
        .map(|mode| tracer.response(&format!("mode_{mode}")))
        .collect();
    let constants = &tracer.reduced.modes;
    let sizes = responses.iter().map(|response| response.size);
    let scale = Chain::scale(constants.iter().zip(sizes));
    count = count.and(&OperationCount::of(&graph, &[scale.operand()]));
    let in_contact = names.iter().zip(&emission.reduced.modes);
    let in_contact = in_contact.filter(|(_, mode)| mode.in_contact);
    let in_contact: Vec<&Ident> = in_contact.map(|(name, _)| name).collect();
    let smallest = match in_contact.as_slice() {
        [] => code!(let scale = 1.0;),
        [only] => code!(let scale = #only.size;),
        [first, second, others @ ..] => code! {
            let scale = Scalar::min(#first.size, #second.size);
            #(let scale = Scalar::min(scale, #others.size);)*
        },
    };
    body.extend(code! {
        /// E, the smallest `size` of the modes in contact
        #smallest
        let modes = [#(Self::CHAIN.at_scale(&#names, scale)),*];
    });
    let scaled = chain.scaled(&tracer.response("mode"), graph.input("scale"), false, 0);
    let operations = OperationCount::of(&graph, &mode_outputs(&scaled)).times(names.len());
    count = count.and(&operations);
    let at_names = (1..=names.len()).map(|mode| local(&format!("at_{mode}")));
    body.extend(code!(let [#(#at_names),*] = &modes;));
    (calls, body, count)
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

/// Emits the evaluation of a scene at one r as two loops over the array of modes, each with the formula of one mode.
fn passes(emission: &Emission<'_>, kind: Kind) -> (TokenStream, OperationCount) {
    let Emission {
        precision, scalar, ..
    } = emission;
    let modes = Literal::usize_unsuffixed(emission.modes());
    let damped = emission.damped();
    let graph = emission.graph(1);
    let tracer = Tracer::new(&graph, &emission.modal, *precision);
    let chain = &tracer.reduced.chain;
    let symbolic = mode::symbolic(&graph, kind);

    let first = symbolic.response(graph.input("inverse_r"), 0);
    let first_count = OperationCount::of(&graph, &mode::outputs(&first));
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
        let mut scale = #scalar::INFINITY;
        for (mode, response) in IntoIterator::into_iter(&Self::MODES).zip(&mut responses) {
            *response = Self::#function(mode, inverse_r);
            #smallest
        }
    };

    let response = tracer.response("response");
    let at = chain.scaled(&response, graph.input("sum.scale"), false, 0);
    let sum = symbolic_sum(&graph, damped);
    // If modes have a load in quadrature with the base's motion, the loop binds the two numbers of that load.
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
        return (TokenStream::new(), OperationCount::default());
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
    (body, count)
}
