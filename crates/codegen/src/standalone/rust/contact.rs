//! Writes the motion of the contact in Rust.

use super::super::formulas::Formulas;
use super::super::{LoadWords, NumberFormat, Source, motion_in_contact};
use frictiongen_kernel::Float;

/// Writes the function for the amplitude and the phase of the contact's relative motion.
pub(super) fn source<S: Float>(
    source: &Source<'_, S>,
    formulas: &Formulas,
    words: &LoadWords,
) -> String {
    let NumberFormat { real, .. } = formulas.numbers;
    let excitation = match &formulas.excitation {
        Some(product) => product.clone(),
        None => "polynomial(&piece.abs_v, t)".to_owned(),
    };
    let (shares, in_motion) = if source.tables.functions >= 4 {
        (
            "    let quadrature = polynomial(&piece.a, t);\n    \
             let displacement = polynomial(&piece.g, t);\n    \
             let direction = polynomial(&piece.arg_v, t);\n",
            "(in_phase - share * displacement)",
        )
    } else {
        (
            "    let signed_quadrature = polynomial(&piece.a, t);\n    \
             let negative = excitation < 0.0;\n    \
             let quadrature = if negative { -signed_quadrature } else { signed_quadrature };\n    \
             let direction = if negative { HALF_TURN } else { 0.0 };\n",
            "in_phase",
        )
    };
    let unbounded = Formulas::on(&formulas.unbounded).map_or_else(String::new, |on| {
        format!("    if {on} {{\n        return Err(Error::Unbounded);\n    }}\n")
    });
    let LoadWords {
        amplitude, beta, ..
    } = words;
    let sign = motion_in_contact(source.scene);
    let beside = match words.stuck_beside {
        "" => String::new(),
        words => format!(
            "\n/// {}",
            words.replace("beta >= beta*_lim", "β ≥ `β*_lim`")
        ),
    };
    format!(
        "\n/// Returns the amplitude ({amplitude}) and the phase of the relative motion in the contact, if the contact slides all\n\
         /// the time.  The phase is the lag of its maximum behind the maximum of the excitation, in rad,\n\
         /// in (−π, π].\n\
         /// {sign}\n\
         /// This motion exists for β = {beta} below `β_lim`.{beside}\n///\n\
         /// With ρ = β/`β_lim` the amplitude is |V| (√(1 − ρ²a²) − ρg), by (2.21, 5.35, 7.20).  The phase is\n\
         /// atan2(−ρa, √(1 − ρ²a²)) − arg V, by (5.38, 7.21).  Without damping g is 0.\n///\n\
         /// # Errors\n/// [`Error`] is the reason why this motion does not exist.\n\
         pub fn contact(r: {real}, beta: {real}) -> Result<({real}, {real}), Error> {{\n    \
         if !((R_MIN..=R_MAX).contains(&r) && (BETA_MIN..=BETA_MAX).contains(&beta)) {{\n        return Err(Error::OutOfDomain);\n    }}\n    \
         let piece = found(r);\n    let t = r - piece.origin;\n    \
         let continuous = polynomial(&piece.beta_lim, t);\n    \
         if beta >= continuous {{\n        \
         let slides = beta < sliding_limit(r);\n        \
         return Err(if slides {{ Error::StickSlip }} else {{ Error::Stuck }});\n    }}\n\
         {unbounded}    \
         let excitation = {excitation};\n{shares}    \
         let share = beta / continuous;\n    let turned = share * quadrature;\n    \
         let product = (1.0 - turned) * (1.0 + turned);\n    \
         // Only errors of the tables make the product negative.\n    \
         let in_phase = {real}::sqrt(product.abs());\n    \
         let amplitude = {real}::abs(excitation) * {in_motion};\n    \
         // 0 - turned avoids -0 and thus the angle -0.  arg V is continuous within a piece and may lie outside (−π, π].\n    \
         // The lag is wrapped twice, which suffices up to 5π.\n    \
         let lag = {real}::atan2(0.0 - turned, in_phase) - direction;\n    \
         Ok((amplitude, wrapped(wrapped(lag))))\n}}\n\n\
         const HALF_TURN: {real} = core::{real}::consts::PI;\n\n\
         /// Moves an angle outside (−π, π] by one turn towards this interval.\n\
         fn wrapped(angle: {real}) -> {real} {{\n    \
         let below = if HALF_TURN < angle {{ angle - 2.0 * HALF_TURN }} else {{ angle }};\n    \
         if -HALF_TURN < below {{ below }} else {{ below + 2.0 * HALF_TURN }}\n}}\n"
    )
}
