//! The size of a scene.

use frictiongen_model::validate::MOST_MASSES;

/// How large a scene may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// The most masses.
    pub masses: usize,
    /// Whether the tables of a declared accuracy are built.
    pub tables: bool,
    /// Whether they are proven; what is only to be checked need not be.
    pub proof: bool,
}

impl Limits {
    /// What a macro expands: each mass becomes a method and a stretch of code.
    pub const MACRO: Self = Self {
        masses: 64,
        tables: true,
        proof: true,
    };
    /// The same where what is emitted is not what is asked for.
    pub const CHECK: Self = Self {
        proof: false,
        ..Self::MACRO
    };
    /// What is computed at run time.
    pub const RUN_TIME: Self = Self {
        masses: MOST_MASSES,
        tables: false,
        proof: false,
    };
}
