//! Writes the motion of the contact in C.

use super::super::{Asked, quotient};
use super::status;
use frictiongen_kernel::Float;
use frictiongen_model::table::Tables;

/// Writes the function for the amplitude and the phase of the contact's relative motion.
pub(super) fn source<S: Float>(
    name: &str,
    (real, letter): (&str, &str),
    asked: &Asked,
    tables: &Tables<S>,
) -> String {
    let numbers = asked.numbers;
    let excitation = match &tables.excitation {
        Some(product) => quotient(numbers, product, &format!("sqrt{letter}")),
        None => "polynomial(piece->c[4], t)".to_owned(),
    };
    let (one, zero) = (numbers.write(1.0), numbers.write(0.0));
    let pi = numbers.write(std::f64::consts::PI);
    let turn = numbers.write(if numbers.single {
        f64::from(2.0 * std::f32::consts::PI)
    } else {
        2.0 * std::f64::consts::PI
    });
    let (shares, displacement, direction) = if tables.functions >= 4 {
        (
            format!(
                "    const {real} quadrature = polynomial(piece->c[1], t);\n    \
                 const {real} displacement = polynomial(piece->c[2], t);\n    \
                 const {real} direction = polynomial(piece->c[3], t);\n"
            ),
            "displacement".to_owned(),
            "direction".to_owned(),
        )
    } else {
        (
            format!(
                "    const {real} signed_quadrature = polynomial(piece->c[1], t);\n    \
                 const int negative = excitation < {zero};\n    \
                 const {real} quadrature = negative ? -signed_quadrature : signed_quadrature;\n"
            ),
            zero.clone(),
            format!("(negative ? {pi} : {zero})"),
        )
    };
    let status = |of: &str| status(name, of);
    let unbounded = asked.unbounded.as_ref().map_or_else(String::new, |on| {
        format!("    if ({on})\n        return {};\n", status("Unbounded"))
    });
    format!(
        "\n/* An angle moved by a turn into (-pi, pi]. */\n\
         static {real} wrapped({real} angle)\n{{\n    \
         angle = {pi} < angle ? angle - {turn} : angle;\n    \
         return -{pi} < angle ? angle : angle + {turn};\n}}\n\n\
         enum {name}_status {name}_contact({real} r, {real} beta, {real} *amplitude, {real} *phase)\n{{\n    \
         if ({outside})\n        return {};\n    \
         const struct piece *piece = found(r);\n    \
         const {real} t = r - piece->origin;\n    \
         const {real} continuous = polynomial(piece->c[0], t);\n    \
         if (!(beta < continuous))\n        return beta < sliding_limit(r) ? {} : {};\n\
         {unbounded}    \
         const {real} excitation = {excitation};\n{shares}    \
         const {real} share = beta / continuous;\n    \
         const {real} turned = share * quadrature;\n    \
         const {real} product = ({one} - turned) * ({one} + turned);\n    \
         const {real} in_phase = sqrt{letter}(fabs{letter}(product));\n    \
         *amplitude = fabs{letter}(excitation) * (in_phase - share * {displacement});\n    \
         *phase = wrapped(wrapped(atan2{letter}(-turned + {zero}, in_phase + {zero}) - {direction}));\n    \
         return {};\n}}\n",
        status("OutOfDomain"),
        status("StickSlip"),
        status("Stuck"),
        status("Ok"),
        outside = asked.outside,
    )
}
