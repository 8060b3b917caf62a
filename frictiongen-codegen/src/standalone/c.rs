//! Tables as C99.

use super::stuck::{Expression, Function, Stuck};
use super::{Numbers, about, quotient, snake, sticks_late, wrapped};
use frictiongen_kernel::Float;
use frictiongen_model::scene::Scene;
use frictiongen_model::table::Tables;

/// What follows a `float`.
const FLOAT: &str = "f";

/// The header: what can be called.
#[must_use]
pub fn c_header<S: Float>(scene: &Scene, tables: &Tables<S>) -> String {
    let name = snake(&scene.name);
    let guard = format!("{}_H", name.to_uppercase());
    let real = if Numbers::of::<S>(FLOAT).single {
        "float"
    } else {
        "double"
    };
    let about = about(tables).join("\n * ");
    let contact = if tables.moves() {
        format!(
            "\n/* Amplitude (x k1/P; for base motion over Y) and phase (lag of the maximum behind the excitation's, rad) of the\n \
             * contact's relative motion at the friction ratio beta = F/P.  Returns 0; 1 for stick-slip, 2 for a stuck contact,\n \
             * -1 for r or beta out of the domain, and then neither is touched. */\n\
             int {name}_contact({real} r, {real} beta, {real} *amplitude, {real} *phase);\n"
        )
    } else {
        String::new()
    };
    let stuck = if tables.held.is_some() {
        let masses = scene.masses.iter().map(|mass| {
            format!(
                "int {name}_stuck_{}({real} r, {real} *re, {real} *im);\n",
                mass.name
            )
        });
        let masses: String = masses.collect();
        format!(
            "\n/* While the contact is stuck: the complex amplitude of a mass, so that its displacement (x k1/P; for base motion over\n \
             * Y) is Re((re + i im) e^(i tau)).  Returns 0; -1 for r out of the range, 1 on an undamped resonance of the chain\n \
             * with its contact stuck, and then neither is touched. */\n{masses}\n\
             /* The force over P that holds the contact, in the same way, positive against positive sliding.  Its modulus is mu\n \
             * beta*_lim. */\n\
             int {name}_holding_force({real} r, {real} *re, {real} *im);\n"
        )
    } else {
        String::new()
    };
    format!(
        "/* Emitted by frictiongen {version} for the scene {scene}.\n * {about} */\n\
         #ifndef {guard}\n#define {guard}\n\n#ifdef __cplusplus\nextern \"C\" {{\n#endif\n\n\
         /* Both limits at the frequency ratio r = omega sqrt(m1/k1): below `continuous` (beta_lim) the contact slides all the\n \
         * time, from `sliding` (beta*_lim) on it never does.  Returns 0; -1 for r out of the range, and then neither is\n \
         * touched. */\n\
         int {name}_limits({real} r, {real} *continuous, {real} *sliding);\n\
         {contact}{stuck}\n#ifdef __cplusplus\n}}\n#endif\n\n#endif\n",
        version = env!("CARGO_PKG_VERSION"),
        scene = scene.name,
    )
}

/// The source behind the header; with no header's name it holds the header's text itself.
///
/// None where β*_lim has no form of its own: only the exact formulas keep the accuracy then.
#[must_use]
pub fn c_source<S: Float>(
    scene: &Scene,
    tables: &Tables<S>,
    header: Option<&str>,
) -> Option<String> {
    let numbers = Numbers::of::<S>(FLOAT);
    let name = snake(&scene.name);
    let (real, letter) = if numbers.single {
        ("float", "f")
    } else {
        ("double", "")
    };
    let include = match header {
        Some(header) => format!("#include \"{header}\"\n"),
        None => c_header(scene, tables),
    };
    let (low, high) = tables.request.r;
    let write = |value: S| numbers.write(value.to_f64());
    let ends = [low, high].map(|end| write(S::constant(end)));
    let [low, high] = ends;
    let index = &tables.index;
    let (functions, terms) = (tables.functions, tables.terms);
    let narrow = if tables.pieces.len() <= 256 {
        "unsigned char"
    } else {
        "unsigned short"
    };
    let mut pieces = String::new();
    for piece in &tables.pieces {
        let (from, origin) = (write(piece.from), write(piece.origin));
        let of = piece.coefficients.iter().map(|of| {
            let list = numbers.list(of.iter().map(|coefficient| coefficient.to_f64()));
            format!("{{{list}}}")
        });
        let of: Vec<String> = of.collect();
        pieces.push_str(&format!(
            "    {{{from}, {origin}, {{{}}}}},\n",
            of.join(",\n        ")
        ));
    }
    let pairs = terms / 2;
    let sliding = quotient(numbers, tables.sliding.as_ref()?, &format!("sqrt{letter}"));
    let contact = tables.moves().then(|| {
        let excitation = match &tables.excitation {
            Some(product) => quotient(numbers, product, &format!("sqrt{letter}")),
            None => "polynomial(piece->c[4], t)".to_owned(),
        };
        let also = if sticks_late(scene) {
            ""
        } else {
            " && beta < sliding_limit(r)"
        };
        let (one, zero) = (numbers.write(1.0), numbers.write(0.0));
        let pi = numbers.write(std::f64::consts::PI);
        let turn = numbers.write(if numbers.single {
            f64::from(2.0 * std::f32::consts::PI)
        } else {
            2.0 * std::f64::consts::PI
        });
        let (shares, displacement, direction) = if functions >= 4 {
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
        format!(
            "\n/* An angle moved by a turn into (-pi, pi]. */\n\
             static {real} wrapped({real} angle)\n{{\n    \
             angle = {pi} < angle ? angle - {turn} : angle;\n    \
             return -{pi} < angle ? angle : angle + {turn};\n}}\n\n\
             int {name}_contact({real} r, {real} beta, {real} *amplitude, {real} *phase)\n{{\n    \
             if (!({low} <= r && r <= {high} && {zero} <= beta))\n        return -1;\n    \
             const struct piece *piece = found(r);\n    \
             const {real} t = r - piece->origin;\n    \
             const {real} continuous = polynomial(piece->c[0], t);\n    \
             if (!(beta < continuous{also}))\n        return beta < sliding_limit(r) ? 1 : 2;\n    \
             const {real} excitation = {excitation};\n{shares}    \
             const {real} share = beta / continuous;\n    \
             const {real} turned = share * quadrature;\n    \
             const {real} product = ({one} - turned) * ({one} + turned);\n    \
             const {real} in_phase = sqrt{letter}(fabs{letter}(product));\n    \
             *amplitude = fabs{letter}(excitation) * (in_phase - share * {displacement});\n    \
             *phase = wrapped(wrapped(atan2{letter}(-turned + {zero}, in_phase + {zero}) - {direction}));\n    \
             return 0;\n}}\n"
        )
    });
    let contact = contact.unwrap_or_default();
    let stuck = tables.held.as_ref();
    let stuck = stuck.map(|held| {
        let stuck = Stuck::of(numbers, scene, held);
        let outside = format!("!({low} <= r && r <= {high})");
        stuck_source(&name, (real, letter), numbers, &outside, &stuck)
    });
    let stuck = stuck.unwrap_or_default();
    Some(format!(
        "{include}\n#include <math.h>\n#include <stddef.h>\n\n\
         /* The digits are those of separate multiplications and additions: compile without contraction (-std=c99 or\n \
         * -ffp-contract=off) where they must agree with the Rust to the last one. */\n\n\
         #define PIECES {count}\n#define BUCKETS {buckets_count}\n\n\
         struct piece {{\n    {real} from;      /* the smallest r of the piece */\n    \
         {real} origin;    /* from where r is counted */\n    \
         {real} c[{functions}][{terms}];\n}};\n\n\
         /* The piece in which each bucket begins. */\n\
         static const {narrow} buckets[BUCKETS] = {{\n    {buckets}\n}};\n\n\
         static const struct piece pieces[PIECES] = {{\n{pieces}}};\n\n\
         static const struct piece *found({real} r)\n{{\n    \
         const size_t bucket = (size_t)((r - {index_low}) * {density});\n    \
         size_t index = buckets[bucket & (BUCKETS - 1)];\n    \
         for (size_t step = (size_t)1 << {halvings} >> 1; step > 0; step >>= 1) {{\n        \
         const size_t further = index + step;\n        \
         if (further < PIECES && pieces[further].from <= r)\n            index = further;\n    }}\n    \
         return &pieces[index];\n}}\n\n\
         static {real} polynomial(const {real} *c, {real} t)\n{{\n    \
         const {real} square = t * t;\n    \
         {real} sum = c[{last}] + c[{last} + 1] * t;\n    \
         for (int k = {last} - 2; k >= 0; k -= 2)\n        \
         sum = (c[k] + c[k + 1] * t) + sum * square;\n    \
         return sum;\n}}\n\n\
         /* (r - y)(r + y), y in two parts. */\n\
         static inline {real} zero({real} r, {real} at, {real} rest)\n{{\n    \
         return ((r - at) - rest) * (r + at);\n}}\n\n\
         /* Of a pair of zeros x + iy beside the axis: off = x^2, least = 4 x^2 y^2. */\n\
         static inline {real} pair({real} r, {real} at, {real} rest, {real} off, {real} least)\n{{\n    \
         const {real} beside = ((r - at) - rest) * (r + at) + off;\n    \
         return beside * beside + least;\n}}\n\n\
         /* beta*_lim at an r in the range. */\n\
         static {real} sliding_limit({real} r)\n{{\n    \
         (void)r;\n    (void)zero;\n    (void)pair;\n    return fabs{letter}({sliding});\n}}\n\n\
         int {name}_limits({real} r, {real} *continuous, {real} *sliding)\n{{\n    \
         if (!({low} <= r && r <= {high}))\n        return -1;\n    \
         const struct piece *piece = found(r);\n    \
         *continuous = polynomial(piece->c[0], r - piece->origin);\n    \
         *sliding = sliding_limit(r);\n    return 0;\n}}\n{contact}{stuck}",
        count = tables.pieces.len(),
        buckets_count = index.buckets.len(),
        buckets = wrapped(&index.buckets),
        index_low = write(index.low),
        density = write(index.density),
        halvings = index.halvings,
        last = 2 * (pairs - 1),
    ))
}

/// The responses while the contact is stuck, with the complex operations that they need.
fn stuck_source(
    name: &str,
    (real, letter): (&str, &str),
    numbers: Numbers,
    outside: &str,
    stuck: &Stuck,
) -> String {
    let (one, zero) = (numbers.write(1.0), numbers.write(0.0));
    let mut functions = String::new();
    for Function { name, value } in &stuck.poles {
        let (of, value) = match value {
            Expression::Real(value) => (real, value),
            Expression::Complex(value) => ("struct number", value),
        };
        functions.push_str(&format!(
            "\n/* The poles of responses. */\nstatic {of} {name}({real} r)\n{{\n    return {value};\n}}\n"
        ));
    }
    let resonances: Vec<String> = stuck
        .resonances
        .iter()
        .map(|own| format!("r == {own}"))
        .collect();
    let resonant = if resonances.is_empty() {
        String::new()
    } else {
        format!("    if ({})\n        return 1;\n", resonances.join(" || "))
    };
    let masses = stuck
        .masses
        .iter()
        .map(|mass| (format!("{name}_stuck_{}", mass.name), &mass.value));
    for (name, value) in masses.chain([(format!("{name}_holding_force"), &stuck.force)]) {
        let answer = match value {
            Expression::Real(value) => format!("    *re = {value};\n    *im = {zero};\n"),
            Expression::Complex(value) => format!(
                "    const struct number value = {value};\n    *re = value.re;\n    *im = value.im;\n"
            ),
        };
        functions.push_str(&format!(
            "\nint {name}({real} r, {real} *re, {real} *im)\n{{\n    \
             if ({outside})\n        return -1;\n{resonant}{answer}    return 0;\n}}\n"
        ));
    }
    let operations = [
        (
            "pair_root",
            format!("{real} r, {real} at, {real} rest, {real} off, {real} rate"),
            "    return (struct number){off - ((r - at) - rest) * (r + at), rate * r};\n"
                .to_owned(),
        ),
        (
            "real_root",
            format!("{real} r, {real} rate"),
            "    return (struct number){rate, r};\n".to_owned(),
        ),
        (
            "real_number",
            format!("{real} re"),
            format!("    return (struct number){{re, {zero}}};\n"),
        ),
        (
            "scaled",
            format!("struct number a, {real} k"),
            "    return (struct number){a.re * k, a.im * k};\n".to_owned(),
        ),
        (
            "times",
            "struct number a, struct number b".to_owned(),
            "    return (struct number){a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};\n"
                .to_owned(),
        ),
        (
            "inverse",
            "struct number a".to_owned(),
            format!(
                "    const {real} over = {one} / (fabs{letter}(a.re) + fabs{letter}(a.im));\n    \
                 const {real} re = a.re * over, im = a.im * over;\n    \
                 const {real} k = over / (re * re + im * im);\n    \
                 return (struct number){{re * k, -(im * k)}};\n"
            ),
        ),
    ];
    let mut source = String::new();
    for (name, takes, body) in operations {
        // What is not called would be a warning.
        if stuck.calls(name) {
            source.push_str(&format!(
                "\nstatic inline struct number {name}({takes})\n{{\n{body}}}\n"
            ));
        }
    }
    if !source.is_empty() {
        let about = "A pair of roots is (s - x)^2 + y^2 at s = ir: off = x^2, rate = -2x; a real one is s - x: rate = -x.";
        source = format!(
            "\n/* A complex number.  {about} */\nstruct number {{\n    {real} re, im;\n}};\n{source}"
        );
    }
    format!("{source}{functions}")
}
