//! Emits the response of one mode at a frequency ratio r. Each kind of damping has one emitted function, and each mode
//! has one call of the function for its damping.

use super::emission::Emission;
use super::names::{field, local};
use super::trace::Tracer;
use crate::graph::count::OperationCount;
use crate::graph::{Expr, Graph, Operand};
use frictiongen_kernel::oscillator::mode::{Kind, Mode, ModeResponse};
use proc_macro2::TokenStream;

/// Emits the functions that return the response of a mode. The functions multiply the response by a factor that removes
/// its pole. Modes with the same kind of damping share one function.
pub(super) fn functions(emission: &Emission<'_>) -> TokenStream {
    if emission.modes() == 1 {
        return TokenStream::new();
    }
    let scalar = &emission.scalar;
    let modes = &emission.reduced.modes;
    let functions = KINDS.iter().filter_map(|(kind, function, about)| {
        if modes.iter().all(|mode| mode.kind != *kind) {
            return None;
        }
        let graph = emission.graph(1);
        let tracer = Tracer::new(&graph, &emission.modal, emission.precision);
        let mut response = symbolic(&graph, *kind).response(graph.input("inverse_r"), 0);
        response.g = graph.where_asked(WITH_G, response.g);
        let outputs = outputs(&response);
        let (printed, count) = tracer.print(&outputs, emission.precision, &["inverse_r", "mode"]);
        let (statements, structure) = (printed.statements, structure(&printed.outputs));
        let (function, operations) = (local(function), operations_about(&count));
        let choice = has_g(*kind).then(|| code!(<const WITH_G: bool>));
        Some(code! {
            #[doc = #about]
            ///
            /// It returns uR²·size, g·size and (g + 2ζRu)·size.  The factor `size` removes the pole at x = 1.
            ///
            #[doc = #operations]
            #[inline(always)]
            fn #function #choice (mode: &Mode<#scalar>, inverse_r: #scalar) -> ModeResponse<#scalar> {
                #statements
                #structure
            }
        })
    });
    functions.collect()
}

/// Returns true if a mode with this kind of damping has g ≠ 0. g is the displacement of the mode at a reversal, under
/// a square wave of friction.
pub(super) fn has_g(kind: Kind) -> bool {
    kind != Kind::Undamped
}

/// Name of a constant parameter of emitted functions. It selects whether a function computes g, the displacement of a
/// mode at a reversal. `limits_without_search` needs no g, and the compiler alone would not remove the whole
/// computation of g.
pub(super) const WITH_G: &str = "WITH_G";

/// The kinds of damping, each with the name and the documentation of its emitted function.
const KINDS: [(Kind, &str, &str); 5] = [
    (
        Kind::Undamped,
        "undamped_mode",
        " The functions of an undamped mode.",
    ),
    (
        Kind::Light,
        "damped_mode",
        " The functions of a lightly damped mode, ζ < 1/2.",
    ),
    (
        Kind::Heavy,
        "heavily_damped_mode",
        " The functions of a mode below critical damping, ζ ≥ 1/2.",
    ),
    (
        Kind::Critical,
        "critically_damped_mode",
        " The functions of a critically damped mode.",
    ),
    (
        Kind::Over,
        "overdamped_mode",
        " The functions of an overdamped mode.",
    ),
];

/// Emits the path of the function for this kind of damping. `with_g` is the argument that selects whether the
/// function computes g, the displacement of the mode at a reversal.
pub(super) fn function_of(kind: Kind, with_g: &TokenStream) -> TokenStream {
    let function = KINDS.iter().find(|(of, ..)| *of == kind);
    let function = local(function.map_or("", |(_, function, _)| function));
    if has_g(kind) {
        code!(#function::<#with_g>)
    } else {
        code!(#function)
    }
}

/// Emits the call of the function that returns the response of one mode at r. The second result is the number of
/// operations in this call.
pub(super) fn call(emission: &Emission<'_>, index: usize) -> (TokenStream, OperationCount) {
    let Some(mode) = emission.reduced.modes.get(index) else {
        return (TokenStream::new(), OperationCount::default());
    };
    // The count uses the numbers of this mode, because operations on them fold where the function is inlined.
    let graph = emission.graph(1);
    let tracer = Tracer::over_constants(&graph, &emission.modal, emission.precision);
    let Some(constants) = tracer.reduced.modes.get(index) else {
        return (TokenStream::new(), OperationCount::default());
    };
    let response = constants.response(graph.input("inverse_r"), 0);
    let count = OperationCount::of(&graph, &outputs(&response));
    let function = function_of(mode.kind, &code!(WITH_G));
    let constants = local(&format!("constants_{}", index + 1));
    (code!(Self::#function(#constants, inverse_r)), count)
}

/// Returns the fields of a mode's response, in the order in which the code emits them.
pub(super) fn outputs(response: &ModeResponse<Expr<'_>>) -> Vec<Operand> {
    let ModeResponse {
        x,
        denominator,
        size,
        u,
        g,
        reversal,
    } = *response;
    [x, denominator.re, denominator.im, size, u, g, reversal]
        .map(Expr::operand)
        .to_vec()
}

fn structure(outputs: &[TokenStream]) -> TokenStream {
    let [x, re, im, size, u, g, reversal] = outputs else {
        return TokenStream::new();
    };
    let (x, size, u) = (field("x", x), field("size", size), field("u", u));
    let (g, reversal) = (field("g", g), field("reversal", reversal));
    code! {
        ModeResponse {
            #x,
            denominator: Complex { re: #re, im: #im },
            #size,
            #u,
            #g,
            #reversal,
        }
    }
}

pub(super) fn symbolic(graph: &Graph, kind: Kind) -> Mode<Expr<'_>> {
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
        contact_squared: of("contact_squared"),
        static_residue: of("static_residue"),
    }
}

/// Returns the documentation line with the number of operations of a function. The line does not count operations
/// whose operands are all constants.
pub(super) fn operations_about(operations: &OperationCount) -> String {
    format!(" Operations: {operations}.")
}
