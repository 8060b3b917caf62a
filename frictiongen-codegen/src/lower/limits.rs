//! Limits on the size of a scene.

use frictiongen_model::validate::MOST_MASSES;

/// Limits on the size of a scene and on the work for its tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// The largest number of masses of a scene.
    pub masses: usize,
    /// True if the tables of a declared accuracy are built.
    pub tables: bool,
    /// True if the tables are proven. A check of the description needs no proof.
    pub proof: bool,
}

impl Limits {
    /// Limits of a macro expansion, in which each mass becomes a method and a stretch of code.
    pub const MACRO: Self = Self {
        masses: 64,
        tables: true,
        proof: true,
    };
    /// Limits of a macro expansion without a proof, for checks that discard the emitted code.
    pub const CHECK: Self = Self {
        proof: false,
        ..Self::MACRO
    };
    /// Limits of a scene that is solved at run time, without tables.
    pub const RUN_TIME: Self = Self {
        masses: MOST_MASSES,
        tables: false,
        proof: false,
    };
}
