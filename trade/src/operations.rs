//! How many operations an emitted function performs, as its documentation says.

use crate::methods::Method;
use crate::scenes::Label;
use frictiongen_codegen::{Limits, emit, parse_text};

/// Operations a call from r on; what a search needs comes on top.
pub fn of(label: &Label, method: Method) -> Option<usize> {
    let description = parse_text(label.text, &Limits::MACRO).ok()?;
    let code = emit(&description).to_string();
    let functions: &[&str] = match method {
        Method::Limits => &["at", "continuous_limit", "sliding_limit"],
        Method::WithoutSearch => &["at", "continuous_limit_without_search", "sliding_limit"],
        Method::PerMode => &["at", "continuous_limit_per_mode", "sliding_limit"],
        Method::Amplitude | Method::Monoharmonic | Method::Fundamental | Method::Orbit => {
            return None;
        }
    };
    functions.iter().map(|name| counted(&code, name)).sum()
}

/// The number in the documentation right before a function.
fn counted(code: &str, function: &str) -> Option<usize> {
    const MARK: &str = "Operations: ";
    let place = code.find(&format!("pub fn {function} ("))?;
    let text = code.get(..place)?;
    let start = text.rfind(MARK)? + MARK.len();
    let digits: String = text
        .get(start..)?
        .chars()
        .take_while(char::is_ascii_digit)
        .collect();
    digits.parse().ok()
}
