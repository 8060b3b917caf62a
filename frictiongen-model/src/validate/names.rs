//! Names that a mass may have, and names that are reserved.

/// Reserved words, which cannot be the name of a mass: the words of a description, and all methods of the generated
/// types. The name of a mass becomes a method of the generated types. This is the only list of reserved words.
pub const RESERVED: &[&str] = &[
    // These are the words of a description.
    "base",
    "contact",
    "mass",
    "wall",
    // These are methods of the scene.
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
    // These are methods of the scene at one frequency ratio.
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
    // These are methods of a motion.
    "amplitude",
    "amplitude_monoharmonic",
    "displacement",
    "harmonic",
    "largest",
    "phase",
    "velocity",
    // These are methods of an orbit.
    "is_marginal",
    "is_stable",
    "is_symmetric",
    "multipliers",
    "reversals",
    "stops",
    "stuck_fraction",
    // These are methods of a stepper, and fields of its input.
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
    "read_masses",
    "restore",
    "restore_image",
    "save",
    "set_event_budget",
    "set_stiction",
    "step",
    "steps",
    "stiction",
    "time",
    "work",
    "write_image",
    // These are methods of derived traits. A mass of the same name would hide them.
    "clone",
    "eq",
    "fmt",
    "ne",
    // The prelude gives every type these methods, which take the value itself. They would hide a mass of the same name.
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

/// Returns true if a word is reserved by a description or by a method of the generated types.
#[must_use]
pub fn is_reserved(word: &str) -> bool {
    RESERVED.contains(&word)
}

/// Returns true if a mass may have this name.
#[must_use]
pub fn may_name(word: &str) -> bool {
    is_name(word) && !is_keyword(word) && !is_reserved(word)
}

/// Returns true if a word has the form of a Rust identifier.
#[must_use]
pub fn is_name(word: &str) -> bool {
    let mut letters = word.chars();
    letters
        .next()
        .is_some_and(|first| first == '_' || first.is_alphabetic())
        && letters.all(|letter| letter == '_' || letter.is_alphanumeric())
}
