//! Counts the operations of an emitted solver, as its documentation lists them.

use crate::methods::Method;
use crate::scenes::Label;
use frictiongen_codegen::{SizeLimits, emit, parse_text};

/// Number of operations of a call that computes both limits from r. Those of a search are left out.
#[derive(Clone, Copy, Debug, Default)]
pub struct Operations {
    /// All operations that the documentation lists for the call. If the quantity needs a search, they are those of
    /// the stage that depends on the frequency.
    pub total: usize,
    /// Number of divisions, including those for 1/r and for the two limits.
    pub divisions: usize,
    /// Number of square roots, including those for the two limits.
    pub roots: usize,
    /// Number of pairs of a sine and a cosine.
    pub circular: usize,
    /// Number of evaluations of e^x − 1, 1 − sin(x)/x and 1 − e^{−2a} − 2a·e^{−a}. Each is a polynomial.
    pub exponential: usize,
}

/// Returns the operations of a call that computes both limits from r, without those of a search.
pub fn of(label: &Label, method: Method) -> Option<Operations> {
    if !matches!(
        method,
        Method::Limits | Method::WithoutSearch | Method::PerMode
    ) {
        return None;
    }
    let description = parse_text(label.text, &SizeLimits::MACRO).ok()?;
    let code = emit(&description).to_string();
    let stage = list(&code, "functions").or_else(|| list(&code, "frequency_stage"))?;
    if method == Method::WithoutSearch {
        let limits = ["break_away", "continuous_limit", "sliding_limit"];
        let all = limits.iter().filter_map(|name| list(&code, name));
        let all = all.fold(stage, |sum, one| Operations {
            total: sum.total + one.total,
            divisions: sum.divisions + one.divisions,
            roots: sum.roots + one.roots,
            circular: sum.circular + one.circular,
            exponential: sum.exponential + one.exponential,
        });
        return Some(Operations {
            divisions: all.divisions + 1,
            ..all
        });
    }
    // The divisions beyond the list are those of 1/r, |V|/√(…) and |V|/(μ|H|). The modulus of a complex number takes
    // a division and a root.
    let moduli = if label.zeta > 0.0 { 2 } else { 0 };
    Some(Operations {
        divisions: stage.divisions + 3 + moduli,
        roots: stage.roots + 1 + moduli,
        ..stage
    })
}

const MARK: &str = "Operations: ";

/// Finds the list of operations in the documentation of an emitted function.
fn list(code: &str, function: &str) -> Option<Operations> {
    let lists = code.split(MARK).skip(1);
    let mut of_function = lists.filter(|list| {
        let name = list.split_once("fn ").map(|(_, rest)| rest);
        name.and_then(|rest| rest.split([' ', '(', '<']).next()) == Some(function)
    });
    of_function.next().and_then(listed)
}

/// Parses the list of operations in a function's documentation, for example `12: 5 ×, 3 +, 1 ÷, 1 sin_cos_pi.`
fn listed(text: &str) -> Option<Operations> {
    let (text, _) = text.split_once('.')?;
    let (total, parts) = text.split_once(": ").unwrap_or((text, ""));
    let mut operations = Operations {
        total: total.parse().ok()?,
        ..Operations::default()
    };
    for part in parts.split(", ") {
        let (count, kind) = part.split_once(' ')?;
        let count: usize = count.parse().ok()?;
        match kind {
            "÷" => operations.divisions += count,
            "√" => operations.roots += count,
            // A complex modulus takes a division and a root.
            "hypot" => {
                operations.divisions += count;
                operations.roots += count;
            }
            "sin_cos_pi" => operations.circular += count,
            "exp" | "exp_m1" | "one_minus_sinc_pi" | "scaled_sinh_defect" => {
                operations.exponential += count;
            }
            _ => {}
        }
    }
    Some(operations)
}
