//! Limits on the size of a scene.

use frictiongen_model::validate::MOST_MASSES;

/// Limits on the size of a scene and on the work for its tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SizeLimits {
    /// The largest number of masses of a scene.
    pub masses: usize,
    /// True if the tables of a declared accuracy are built.
    pub tables: bool,
    /// Selects whether the generator proves that the tables have the declared accuracy.
    pub proof: ProofAt,
    /// True if the generator must be able to emit code for the scene. This restricts the names of masses and contacts,
    /// the field `provide`, and `contacts` and `dampers`.
    pub emitted: bool,
}

/// Selects whether the generator proves that the tables have the declared accuracy.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ProofAt {
    /// The generator does not prove the accuracy of tables, for example if the caller only checks a description.
    Never,
    /// The proof that the description requests. It requires the feature `proof`.
    Requested,
    /// No proof, because this build lacks the feature `proof`. `proof: whole` in a description is then an error that
    /// names the feature.
    Missing,
}

impl ProofAt {
    /// The selection in a macro: `Requested` if frictiongen has the feature `proof`, otherwise `Missing`.
    pub const MACRO: Self = if cfg!(feature = "proof") {
        Self::Requested
    } else {
        Self::Missing
    };
}

impl SizeLimits {
    /// Limits for a macro expansion. The number of masses is limited, because each mass adds a method and much code.
    pub const MACRO: Self = Self {
        masses: 64,
        tables: true,
        proof: ProofAt::MACRO,
        emitted: true,
    };
    /// Limits for a check of a description, which discards the emitted code. They are the limits for a macro
    /// expansion, but without a proof.
    pub const CHECK: Self = Self {
        proof: ProofAt::Never,
        ..Self::MACRO
    };
    /// Limits for a scene that is solved at run time, without tables.
    pub const RUN_TIME: Self = Self {
        masses: MOST_MASSES,
        tables: false,
        proof: ProofAt::Never,
        emitted: false,
    };
}
