//! Writes the motion of the contact in Rust.

use super::super::{Asked, quotient};
use frictiongen_kernel::Float;
use frictiongen_model::table::Tables;

/// Writes the function for the amplitude and the phase of the contact's relative motion.
pub(super) fn source<S: Float>(
    real: &str,
    root: &str,
    asked: &Asked,
    tables: &Tables<S>,
) -> String {
    let excitation = tables.excitation.as_ref();
    let excitation = excitation.map_or_else(String::new, |product| {
        let product = quotient(asked.numbers, product, root);
        format!("    let excitation = {product};\n")
    });
    let (shares, displacement) = match tables.functions {
        5 => (
            "    let [continuous, quadrature, displacement, direction, excitation] = piece.of.map(|of| polynomial(&of, t));\n",
            "displacement",
        ),
        4 => (
            "    let [continuous, quadrature, displacement, direction] = piece.of.map(|of| polynomial(&of, t));\n",
            "displacement",
        ),
        _ => (
            "    let [continuous, quadrature] = piece.of.map(|of| polynomial(&of, t));\n    \
             let negative = excitation < 0.0;\n    \
             let quadrature = if negative { -quadrature } else { quadrature };\n    \
             let direction = if negative { PI } else { 0.0 };\n",
            "0.0",
        ),
    };
    let unbounded = asked.unbounded.as_ref().map_or_else(String::new, |on| {
        format!("    if {on} {{\n        return Err(Error::Unbounded);\n    }}\n")
    });
    let Asked {
        outside,
        amplitude,
        beta,
        ..
    } = asked;
    format!(
        "\n/// Amplitude ({amplitude}) and phase (lag of the maximum behind the excitation's, rad) of the contact's relative motion\n\
         /// that slides all the time, at the friction ratio β = {beta}.  It exists for β < β_lim; from β*_lim on a stuck state\n\
         /// exists beside it, if the static friction exceeds the kinetic.\n///\n/// # Errors\n/// [`Error`] says what there is instead.\n\
         pub fn contact(r: {real}, beta: {real}) -> Result<({real}, {real}), Error> {{\n    \
         if {outside} {{\n        return Err(Error::OutOfDomain);\n    }}\n    \
         let piece = found(r);\n    let t = r - piece.origin;\n\
         {excitation}{shares}    \
         if !(beta < continuous) {{\n        \
         let slides = beta < sliding_limit(r);\n        \
         return Err(if slides {{ Error::StickSlip }} else {{ Error::Stuck }});\n    }}\n\
         {unbounded}    \
         let share = beta / continuous;\n    let turned = share * quadrature;\n    \
         let product = (1.0 - turned) * (1.0 + turned);\n    \
         let in_phase = {root}(product.abs());\n    \
         let amplitude = {real}::abs(excitation) * (in_phase - share * {displacement});\n    \
         let lag = {real}::atan2(-turned + 0.0, in_phase + 0.0) - direction;\n    \
         Ok((amplitude, wrapped(wrapped(lag))))\n}}\n\n\
         const PI: {real} = core::{real}::consts::PI;\n\n\
         /// An angle moved by a turn into (−π, π].\n\
         fn wrapped(angle: {real}) -> {real} {{\n    \
         let angle = if PI < angle {{ angle - (PI + PI) }} else {{ angle }};\n    \
         if -PI < angle {{ angle }} else {{ angle + (PI + PI) }}\n}}\n"
    )
}
