//! Writes the motion of the contact in C.

use super::super::formulas::Formulas;
use super::super::{NumberFormat, Source};
use super::{outside, refusal, status};
use frictiongen_kernel::Float;

/// Writes the function for the amplitude and the phase of the contact's relative motion.
pub(super) fn source<S: Float>(source: &Source<'_, S>, formulas: &Formulas, name: &str) -> String {
    let numbers = formulas.numbers;
    let NumberFormat { real, .. } = numbers;
    let letter = numbers.letter();
    let excitation = match &formulas.excitation {
        Some(product) => product.clone(),
        None => "polynomial(piece->abs_v, t)".to_owned(),
    };
    let (one, zero) = (numbers.write(1.0), numbers.write(0.0));
    let pi = numbers.write(std::f64::consts::PI);
    let turn = numbers.write(if numbers.single {
        f64::from(2.0 * std::f32::consts::PI)
    } else {
        2.0 * std::f64::consts::PI
    });
    let (shares, in_motion, direction) = if source.tables.functions >= 4 {
        (
            format!(
                "    const {real} quadrature = polynomial(piece->a, t);\n    \
                 const {real} displacement = polynomial(piece->g, t);\n    \
                 const {real} direction = polynomial(piece->arg_v, t);\n"
            ),
            "(in_phase - (share * displacement))",
            "direction".to_owned(),
        )
    } else {
        (
            format!(
                "    const {real} signed_quadrature = polynomial(piece->a, t);\n    \
                 const bool negative = excitation < {zero};\n    \
                 const {real} quadrature = negative ? -signed_quadrature : signed_quadrature;\n"
            ),
            "in_phase",
            format!("(negative ? HALF_TURN : {zero})"),
        )
    };
    let status = |of: &str| status(name, of);
    let [_, outside] = outside(name);
    let unbounded = Formulas::on(&formulas.unbounded);
    let unbounded = unbounded.map_or_else(String::new, |on| refusal(&on, &status("Unbounded")));
    format!(
        "\n#define HALF_TURN {pi}\n#define TURN {turn}\n\n\
         /* Moves an angle outside (-pi, pi] by one turn towards this interval. */\n\
         static {real} wrapped({real} angle)\n{{\n    \
         const {real} below = (HALF_TURN < angle) ? (angle - TURN) : angle;\n    \
         return (-HALF_TURN < below) ? below : (below + TURN);\n}}\n\n\
         /* With rho = beta/beta_lim the amplitude is |V| (sqrt(1 - rho^2 a^2) - rho g), by (2.21, 5.35, 7.20).  The phase is\n \
         * atan2(-rho a, sqrt(1 - rho^2 a^2)) - arg V, by (5.38, 7.21).  Without damping g is 0. */\n\
         enum {name}_status {name}_contact({real} r, {real} beta, {real} *amplitude, {real} *phase)\n{{\n\
         {outside}    \
         const struct piece *const piece = found(r);\n    \
         const {real} t = r - piece->origin;\n    \
         const {real} continuous = polynomial(piece->beta_lim, t);\n    \
         if (!(beta < continuous)) {{\n        return (beta < sliding_limit(r)) ? {stick_slip} : {stuck};\n    }}\n\
         {unbounded}    \
         const {real} excitation = {excitation};\n{shares}    \
         const {real} share = beta / continuous;\n    \
         const {real} turned = share * quadrature;\n    \
         const {real} product = ({one} - turned) * ({one} + turned);\n    \
         /* Only errors of the tables make the product negative. */\n    \
         const {real} in_phase = sqrt{letter}(fabs{letter}(product));\n    \
         *amplitude = fabs{letter}(excitation) * {in_motion};\n    \
         /* 0 - turned avoids -0 and thus the angle -0.  arg V is continuous within a piece and may lie outside (-pi, pi].\n     \
     * The lag is wrapped twice, which suffices up to 5 pi. */\n    \
         *phase = wrapped(wrapped(atan2{letter}({zero} - turned, in_phase) - {direction}));\n    \
         return {ok};\n}}\n",
        outside = refusal(&outside, &status("OutOfDomain")),
        stick_slip = status("StickSlip"),
        stuck = status("Stuck"),
        ok = status("Ok"),
    )
}
