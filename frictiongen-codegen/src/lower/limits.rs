//! Limits on the size of a scene.

use frictiongen_model::validate::MOST_MASSES;

/// Limits on the size of a scene and on the work for its tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// The largest number of masses of a scene.
    pub masses: usize,
    /// True if the tables of a declared accuracy are built.
    pub tables: bool,
    /// The proof of the tables.
    pub proof: ProofAt,
    /// True if a scene may have `contacts` and `dampers`, for which no code is emitted.
    pub joints: bool,
}

/// The proof of tables, as a caller of the parser wants it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ProofAt {
    /// The tables are not proven. A check of a description needs no proof.
    Never,
    /// The tables are proven as far as the description requests. It needs the feature `proof`.
    Requested,
    /// The tables are not proven, and `proof: whole` is an error that names the feature `proof`.
    Missing,
}

impl ProofAt {
    /// The proof in a macro of this build.
    pub const MACRO: Self = if cfg!(feature = "proof") {
        Self::Requested
    } else {
        Self::Missing
    };
}

impl Limits {
    /// Limits of a macro expansion. Each mass becomes a method and a stretch of code.
    pub const MACRO: Self = Self {
        masses: 64,
        tables: true,
        proof: ProofAt::MACRO,
        joints: false,
    };
    /// Limits of a macro expansion without a proof, for checks that discard the emitted code.
    pub const CHECK: Self = Self {
        proof: ProofAt::Never,
        joints: true,
        ..Self::MACRO
    };
    /// Limits of a scene that is solved at run time, without tables.
    pub const RUN_TIME: Self = Self {
        masses: MOST_MASSES,
        tables: false,
        proof: ProofAt::Never,
        joints: true,
    };
}
