//! Names that a mass may have, and names that are reserved.

use crate::scene::CONTACT;

/// Words of a description and of its results, which cannot be the name of a mass or of a contact: the two supports, and
/// the column of the time in a recording.
const WORDS: [&str; 3] = ["base", "wall", "time"];

/// All methods of the emitted types. In emitted code, the name of a mass or of a contact becomes a method of these
/// types, so it must differ from their other methods. The method `contact` may belong to a contact of this name.
const METHODS: &[&str] = &[
    "mass",
    // Methods of the scene.
    "at",
    "friction_ratio",
    "frequency_ratio",
    "limits_into",
    "limits_without_search",
    "self_check",
    "simulation",
    "simulation_from",
    "stepper",
    "stepper_from",
    "stepper_from_image",
    // Methods of the scene at one frequency ratio.
    "continuous_limit",
    "continuous_limit_per_mode",
    "continuous_limit_without_search",
    "limits",
    "limits_searched",
    "margin",
    "motion",
    "orbit",
    "orbit_from",
    "regime",
    "sliding_limit",
    "stuck",
    // Methods of a motion.
    "amplitude",
    "amplitude_monoharmonic",
    "displacement",
    "harmonic",
    "largest",
    "phase",
    "velocity",
    // Methods of an orbit.
    "is_marginal",
    "is_stable",
    "is_symmetric",
    "multipliers",
    "reversals",
    "stops",
    "stuck_fraction",
    // Methods of a stepper, and fields of the stepper's input.
    "advance",
    "all_masses",
    "begin",
    "begin_with",
    "cost",
    "dt",
    "exceeded",
    "image",
    "image_len",
    "IMAGE",
    "last_event",
    "read_masses",
    "restore",
    "restore_image",
    "save",
    "set_base_velocity",
    "set_event_budget",
    "set_stiction",
    "step",
    "steps",
    "stiction",
    "work",
    "write_image",
    // Methods of derived traits. A mass with the name of a method would hide the method.
    "clone",
    "eq",
    "fmt",
    "ne",
    // Methods that the prelude gives every type, and that take the value itself. One of these methods would hide a mass
    // with the same name.
    "into",
    "try_into",
];

/// Rust keywords, including keywords reserved for later use, and the single underscore.
const KEYWORDS: &[&str] = &[
    "Self", "_", "abstract", "as", "async", "await", "become", "box", "break", "const", "continue",
    "crate", "do", "dyn", "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if",
    "impl", "in", "let", "loop", "macro", "match", "mod", "move", "mut", "override", "priv", "pub",
    "ref", "return", "self", "static", "struct", "super", "trait", "true", "try", "type", "typeof",
    "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
];

/// Returns true if a word is a Rust keyword.
#[must_use]
pub fn is_keyword(word: &str) -> bool {
    KEYWORDS.contains(&word)
}

/// Returns true if a description, its results or, in emitted code, a method reserves a word, so that no mass and no
/// contact may have it as its name.
#[must_use]
pub(super) fn is_reserved(word: &str, emitted: bool) -> bool {
    WORDS.contains(&word) || (emitted && METHODS.contains(&word))
}

/// Returns true if a mass may have this name, in emitted code or at run time.
#[must_use]
pub fn may_name(word: &str, emitted: bool) -> bool {
    is_name(word)
        && word != CONTACT
        && !(emitted && is_keyword(word))
        && !is_reserved(word, emitted)
}

/// Returns true if a word has the form of a Rust identifier.
#[must_use]
pub fn is_name(word: &str) -> bool {
    let mut letters = word.chars();
    word != "_"
        && letters
            .next()
            .is_some_and(|first| first == '_' || first.is_alphabetic())
        && letters.all(|letter| letter == '_' || letter.is_alphanumeric())
}
