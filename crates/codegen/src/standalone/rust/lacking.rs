//! Writes the square root and the arc tangent, which `core` lacks.

use super::super::NumberFormat;

/// Number of equal steps from 0 to 1 at which the arc tangent is tabulated. The power series then needs arguments of at
/// most 1/16.
const PARTS: u32 = 8;

/// Writes a trait with the square root and the arc tangent, for a file that may be built without std. Methods of the
/// type take precedence over methods of a trait, so a build with std uses the methods of std.
pub(super) fn source(numbers: NumberFormat) -> String {
    // Constants of the number format: the bits of the fraction, the exponent bias, and two integer types. The code
    // shifts the fraction by `shift` or one more bit before the integer root. It multiplies a subnormal number by 2 to
    // the power `scale`.
    let (real, fraction, bias, bits, wide, shift, scale) = if numbers.single {
        ("f32", 23, 127, "u32", "u64", 25, 24)
    } else {
        ("f64", 52, 1023, "u64", "u128", 54, 54)
    };
    // The power series has odd terms up to t¹³, or up to t⁷ in single precision. Its remainder, divided by t, is below
    // 1e-18, or below 3e-11 in single precision.
    let terms = if numbers.single { 4 } else { 7 };
    let last = 2 * terms - 1;
    let series = (1..terms - 1)
        .rev()
        .fold(format!("1.0 / {last}.0"), |inner, k| {
            format!("1.0 / {}.0 - square * ({inner})", 2 * k + 1)
        });
    let arcs = (0..=PARTS).map(|k| (f64::from(k) / f64::from(PARTS)).atan());
    let arcs = numbers.list(arcs);
    let parts = numbers.write(f64::from(PARTS));
    let one_more = PARTS + 1;
    format!(
        "/// Square root and arc tangent, which `core` lacks.  If std is linked, its methods of these names take precedence.\n\
         trait Lacking {{\n    fn sqrt(self) -> Self;\n    fn atan2(self, x: Self) -> Self;\n}}\n\n\
         #[allow(\n    clippy::cast_possible_truncation,\n    clippy::cast_possible_wrap,\n    clippy::cast_precision_loss,\n    \
         clippy::cast_sign_loss,\n    reason = \"the casts convert bits of a number, and an index of at most {PARTS}\"\n)]\n\
         #[allow(\n    clippy::approx_constant,\n    clippy::excessive_precision,\n    clippy::unreadable_literal,\n    \
         reason = \"the generator writes all digits of the arc tangents\"\n)]\n\
         impl Lacking for {real} {{\n    \
         /// Returns the correctly rounded square root of a number that is not negative.  The integer root has one binary\n    \
         /// digit more than the result, and is rounded to the nearest.\n    \
         fn sqrt(self) -> {real} {{\n        \
         if !(0.0 < self && self < {real}::INFINITY) {{\n            return self;\n        }}\n        \
         let subnormal = self < {real}::MIN_POSITIVE;\n        \
         let scale = (1_{bits} << {scale}) as {real};\n        \
         let bits = (if subnormal {{ self * scale }} else {{ self }}).to_bits();\n        \
         let fraction = (bits & ((1 << {fraction}) - 1)) | (1 << {fraction});\n        \
         let exponent = (bits >> {fraction}) as i32 - {bias} - {fraction} - if subnormal {{ {scale} }} else {{ 0 }};\n        \
         let shift = {shift} + ((exponent - {shift}) & 1);\n        \
         let root = (({wide}::from(fraction) << shift).isqrt() + 1) >> 1;\n        \
         let exponent = (exponent - shift) / 2 + 1 + {bias};\n        \
         root as {real} * {real}::from_bits((exponent as {bits}) << {fraction})\n    }}\n\n    \
         /// Returns the angle of a point with x ≥ 0.  With s the smaller and l the larger coordinate,\n    \
         /// atan(s/l) = atan(k/{PARTS}) + atan((s − l·k/{PARTS})/(l + s·k/{PARTS})).\n    \
         /// With k nearest to {PARTS}·s/l, the modulus of the last argument t is at most 1/16.  Then {terms} terms of its series suffice.\n    \
         fn atan2(self, x: {real}) -> {real} {{\n        \
         const ARCS: [{real}; {one_more}] = [{arcs}];\n        \
         let y = {real}::abs(self);\n        \
         let (small, large) = if y <= x {{ (y, x) }} else {{ (x, y) }};\n        \
         if small == 0.0 && large == 0.0 {{\n            return self;\n        }}\n        \
         let k = ({parts} * (small / large) + 0.5) as usize;\n        \
         let node = k as {real} / {parts};\n        \
         let t = (small - node * large) / (large + node * small);\n        \
         let square = t * t;\n        \
         let arc = ARCS[k] + (t - t * square * ({series}));\n        \
         let arc = if y <= x {{ arc }} else {{ core::{real}::consts::FRAC_PI_2 - arc }};\n        \
         if self < 0.0 {{ -arc }} else {{ arc }}\n    }}\n}}\n\n"
    )
}
