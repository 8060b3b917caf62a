//! How many operations an emitted solver performs, as its documentation says.

use crate::methods::Method;
use crate::scenes::Label;
use frictiongen_codegen::{Limits, emit, parse_text};

/// Operations of the frequency stage, and what both limits need besides.
#[derive(Clone, Copy, Debug, Default)]
pub struct Operations {
    /// All of the frequency stage.
    pub total: usize,
    /// Divisions, with those of the two limits.
    pub divisions: usize,
    /// Square roots, with those of the two limits.
    pub roots: usize,
    /// Pairs of sine and cosine.
    pub circular: usize,
    /// e^x − 1, 1 − sin(x)/x and 1 − e^{−2a} − 2a·e^{−a}, a polynomial each.
    pub exponential: usize,
}

/// Operations of a call from r on that gives both limits; what a search needs comes on top.
pub fn of(label: &Label, method: Method) -> Option<Operations> {
    if !matches!(
        method,
        Method::Limits | Method::WithoutSearch | Method::PerMode
    ) {
        return None;
    }
    let description = parse_text(label.text, &Limits::MACRO).ok()?;
    let code = emit(&description).to_string();
    let mut operations = listed(&code)?;
    // 1/r, |V|/√(…) and |V|/(μ|H|); a complex modulus takes a division and a root.
    let moduli = if label.zeta > 0.0 { 2 } else { 0 };
    operations.divisions += 3 + moduli;
    operations.roots += 1 + moduli;
    Some(operations)
}

/// The documentation of the frequency stage: `Operations: 12: 5 ×, 3 +, 1 ÷, 1 sin_cos_pi.`
fn listed(code: &str) -> Option<Operations> {
    const MARK: &str = "Operations: ";
    let start = code.find(MARK)? + MARK.len();
    let (text, _) = code.get(start..)?.split_once('.')?;
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
            "sin_cos_pi" => operations.circular += count,
            "exp" | "exp_m1" | "one_minus_sinc_pi" | "scaled_sinh_defect" => {
                operations.exponential += count;
            }
            _ => {}
        }
    }
    Some(operations)
}
