//! Writes tables as code without dependencies: a Rust file, or C99.
//!
//! Both perform the kernel's operations in the same order, so that all three agree to the last bit. The arc tangent of
//! a phase is an exception. It is the platform's function, or the file's own in Rust without std.

mod c;
mod rust;
mod stuck;

pub use c::{c_header, c_name, c_source};
pub use rust::rust_source;

use frictiongen_kernel::Float;
use frictiongen_kernel::table::Factor;
use frictiongen_model::scene::{Excitation, Scene};
use frictiongen_model::table::{Product, Tables};

/// Format of numbers in the target language.
#[derive(Clone, Copy)]
struct Numbers {
    /// True if numbers are `f32`.
    single: bool,
    /// Suffix of each number.
    suffix: &'static str,
}

impl Numbers {
    /// Returns the number format of a scalar type.
    fn of<S: Float>(single_suffix: &'static str) -> Self {
        let single = S::EPSILON > f64::EPSILON;
        let suffix = if single { single_suffix } else { "" };
        Self { single, suffix }
    }

    #[allow(clippy::cast_possible_truncation, reason = "it is an f32")]
    fn write(self, value: f64) -> String {
        if self.single {
            format!("{:?}{}", value as f32, self.suffix)
        } else {
            format!("{value:?}{}", self.suffix)
        }
    }

    fn list(self, values: impl IntoIterator<Item = f64>) -> String {
        let values: Vec<String> = values.into_iter().map(|value| self.write(value)).collect();
        values.join(", ")
    }
}

/// Writes a list of indices in lines of at most 96 characters.
fn wrapped(places: &[usize]) -> String {
    let mut lines = vec![String::new()];
    for place in places {
        let word = format!("{place}, ");
        if lines
            .last()
            .is_some_and(|line| line.len() + word.len() > 96)
        {
            lines.push(String::new());
        }
        if let Some(line) = lines.last_mut() {
            line.push_str(&word);
        }
    }
    let lines: Vec<&str> = lines.iter().map(|line| line.trim_end()).collect();
    lines.join("\n    ")
}

/// Returns lines of text that describe the tables and their largest error.
fn about<S: Float>(tables: &Tables<S>) -> Vec<String> {
    let (low, high) = tables.request.r;
    let report = &tables.report;
    let mut about = vec![
        format!(
            "r from {low} to {high}, relative accuracy {:e}; {} pieces of degree {}, {} bytes.",
            tables.request.accuracy,
            tables.pieces.len(),
            tables.terms - 1,
            tables.report.bytes,
        ),
        format!(
            "Largest error {:.1e}, at r = {}: checked at {} points that the fit did not see.",
            report.worst.error, report.worst.at, report.points,
        ),
        format!("beta_lim: {}", tables.proof.told()),
    ];
    if tables.sliding.is_some() {
        about.push(format!("beta*_lim: {}", tables.sliding_proof.told()));
    }
    if tables.moves() {
        about.push(format!(
            "amplitude and phase of the contact: {}",
            tables.motion_proof.told()
        ));
    }
    if let Some(held) = &tables.held {
        about.push(format!("stuck responses: {}", held.told()));
    }
    about
}

/// Writes a factor as an expression in r.
fn factor<S: Float>(numbers: Numbers, factor: &Factor<S>) -> String {
    let write = |value: S| numbers.write(value.to_f64());
    match *factor {
        Factor::Zero { at, rest } => {
            let (at, rest) = (write(at), write(rest));
            format!("zero(r, {at}, {rest})")
        }
        Factor::Pair {
            at,
            rest,
            off,
            least,
        } => {
            let (at, rest, off, least) = (write(at), write(rest), write(off), write(least));
            format!("pair(r, {at}, {rest}, {off}, {least})")
        }
        Factor::Real { off } => format!("(r * r + {})", write(off)),
    }
}

/// Writes a product as an expression in r.
fn quotient<S: Float>(numbers: Numbers, product: &Product<S>, root: &str) -> String {
    let poles = factor_product(numbers, &product.denominator);
    quotient_over(numbers, product, &format!("({poles})"), root)
}

/// Writes a product of factors as an expression in r.
fn factor_product<S: Float>(numbers: Numbers, factors: &[Factor<S>]) -> String {
    let mut all = vec![numbers.write(1.0)];
    all.extend(factors.iter().map(|each| factor(numbers, each)));
    all.join("\n        * ")
}

/// Writes a product whose poles are the expression `poles`.
fn quotient_over<S: Float>(
    numbers: Numbers,
    product: &Product<S>,
    poles: &str,
    root: &str,
) -> String {
    let gain = numbers.write(product.gain.to_f64());
    if product.numerator.is_empty() && product.denominator.is_empty() {
        return gain;
    }
    let above = factor_product(numbers, &product.numerator);
    let value = if product.denominator.is_empty() {
        format!("({above})")
    } else {
        format!("({above})\n        / {poles}")
    };
    if product.squared {
        format!("{gain} * {root}({value})")
    } else {
        format!("{gain} * ({value})")
    }
}

/// Status values of the functions: name, number in C, meaning.
const STATUSES: [(&str, i32, &str); 5] = [
    ("OutOfDomain", -1, "r or beta is not in the domain"),
    ("Ok", 0, "the values are written"),
    (
        "StickSlip",
        1,
        "beta_lim <= beta < beta*_lim: the contact stops and slides in turn",
    ),
    (
        "Stuck",
        2,
        "beta is at or above both limits: no motion slides all the time, and a stuck state exists",
    ),
    (
        "Unbounded",
        3,
        "an undamped resonance; for a stuck response one of the chain with its contact stuck",
    ),
];

/// Argument checks, as expressions that both languages share.
struct Asked {
    numbers: Numbers,
    /// True if r is out of the domain.
    r_outside: String,
    /// True if r or beta is out of the domain.
    outside: String,
    /// True if r is on an undamped resonance that the load drives; `None` if the range has no such resonance.
    unbounded: Option<String>,
    /// Meaning of beta: F/P, or F/(k₁Y) where the base moves.
    beta: &'static str,
    /// Meaning of an amplitude, for the documentation.
    amplitude: &'static str,
    /// Load by which forces are divided, for the documentation.
    load: &'static str,
}

impl Asked {
    fn of<S: Float>(numbers: Numbers, scene: &Scene, tables: &Tables<S>) -> Self {
        let write = |value: f64| numbers.write(S::constant(value).to_f64());
        let (low, high) = tables.request.r;
        let largest = if numbers.single {
            f64::from(f32::MAX)
        } else {
            f64::MAX
        };
        let declared = scene.declared.range;
        let (least, most) = declared.map_or((0.0, largest), |range| range.beta);
        let r = format!("{} <= r && r <= {}", write(low), write(high));
        // An infinite friction ratio is out of the domain.
        let beta = format!(
            "{} <= beta && beta <= {}",
            write(least),
            write(most.min(largest))
        );
        let on = tables.unbounded.iter();
        let on = on.map(|own| format!("r == {}", numbers.write(own.to_f64())));
        let on: Vec<String> = on.collect();
        let moving = scene.excitation == Excitation::Base;
        Self {
            numbers,
            r_outside: format!("!({r})"),
            outside: format!("!({r} && {beta})"),
            unbounded: (!on.is_empty()).then(|| on.join(" || ")),
            beta: if moving { "F/(k1 Y)" } else { "F/P" },
            amplitude: if moving { "x/Y" } else { "x k1/P" },
            load: if moving { "k1 Y" } else { "P" },
        }
    }
}

/// Returns a name in snake case: `TwoStorey` becomes `two_storey`.
fn snake(name: &str) -> String {
    let mut snake = String::new();
    for letter in name.chars() {
        if letter.is_uppercase() && !snake.is_empty() && !snake.ends_with('_') {
            snake.push('_');
        }
        snake.extend(letter.to_lowercase());
    }
    snake
}
