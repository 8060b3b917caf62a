//! Systems from their descriptions.

use frictiongen::System;

/// A system from its description, as `friction_system!` takes it.
///
/// # Panics
/// Where the description is wrong: the programs' own are not.
#[must_use]
pub fn system(text: &str) -> System {
    match text.parse() {
        Ok(system) => system,
        Err(error) => panic!("{error}\n{text}"),
    }
}

/// One block on one spring: what it rubs on, what is moved, and what else its description says.
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
