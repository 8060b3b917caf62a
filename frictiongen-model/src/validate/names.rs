//! The names that a mass may bear.

/// Words that mean something else in a description, and every method of the generated types: a
/// mass's name becomes a method beside them. The one place where they are listed.
pub const RESERVED: &[&str] = &[
    // parts of a description
    "base",
    "contact",
    "mass",
    "wall",
    // the scene itself
    "at",
    "friction_ratio",
    "frequency_ratio",
    "limits_into",
    "limits_without_search",
    "simulation",
    "simulation_from",
    "stepper",
    "stepper_from",
    // at one frequency ratio
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
    // a motion
    "amplitude",
    "amplitude_monoharmonic",
    "displacement",
    "harmonic",
    "largest",
    "phase",
    "velocity",
    // an orbit
    "is_marginal",
    "is_stable",
    "is_symmetric",
    "multipliers",
    "reversals",
    "stops",
    "stuck_fraction",
    // a stepper and its input
    "advance",
    "begin",
    "begin_with",
    "cost",
    "dt",
    "exceeded",
    "restore",
    "save",
    "set_stiction",
    "step",
    "steps",
    "stiction",
    "time",
    "work",
    // what a derive puts on the types: a mass of that name would hide it
    "clone",
    "eq",
    "fmt",
    "ne",
    // what the prelude puts on every type, by value: it would hide a mass of that name
    "into",
    "try_into",
];

/// The keywords of Rust, those reserved for later included, and the lone underscore.
const KEYWORDS: &[&str] = &[
    "Self", "_", "abstract", "as", "async", "await", "become", "box", "break", "const", "continue",
    "crate", "do", "dyn", "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if",
    "impl", "in", "let", "loop", "macro", "match", "mod", "move", "mut", "override", "priv", "pub",
    "ref", "return", "self", "static", "struct", "super", "trait", "true", "try", "type", "typeof",
    "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
];

/// Whether a word is a keyword of Rust.
#[must_use]
pub fn is_keyword(word: &str) -> bool {
    KEYWORDS.contains(&word)
}

/// Whether a word is taken by a description or by a method of the generated types.
#[must_use]
pub fn is_reserved(word: &str) -> bool {
    RESERVED.contains(&word)
}

/// Whether a mass may bear this name.
#[must_use]
pub fn may_name(word: &str) -> bool {
    is_name(word) && !is_keyword(word) && !is_reserved(word)
}

/// Whether a word has the shape of a Rust identifier.
#[must_use]
pub fn is_name(word: &str) -> bool {
    let mut letters = word.chars();
    letters
        .next()
        .is_some_and(|first| first == '_' || first.is_alphabetic())
        && letters.all(|letter| letter == '_' || letter.is_alphanumeric())
}
