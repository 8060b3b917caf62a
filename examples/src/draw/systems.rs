//! Builds systems from their descriptions.

use frictiongen::System;

/// Builds a system from its description, in the syntax of `friction_system!`.
///
/// # Panics
/// Panics if the description is wrong. All descriptions in these programs are right.
#[must_use]
pub fn system(text: &str) -> System {
    match text.parse() {
        Ok(system) => system,
        Err(error) => panic!("{error}\n{text}"),
    }
}

/// Returns a block on a spring. The arguments are the body on which the block rubs, the excitation, and further lines
/// of the description.
#[must_use]
pub fn block(contact: &str, excitation: &str, more: &str) -> System {
    system(&format!(
        "struct Block {{
            masses: {{ block: 1.0 }},
            springs: {{ base - block: 1.0 }},
            contact: block - {contact},
            excitation: {excitation},
            {more}
        }}"
    ))
}
