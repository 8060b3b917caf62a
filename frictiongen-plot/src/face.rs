//! Style and level of a run of text.

/// Style of a run of text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Face {
    /// Upright.
    #[default]
    Regular,
    /// Italic, for symbols.
    Italic,
    /// Bold, for headings.
    Bold,
}

/// Vertical level of a run of text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Level {
    /// On the base line.
    #[default]
    Base,
    /// Subscript: smaller, below the base line.
    Sub,
    /// Superscript: smaller, above the base line.
    Sup,
}

impl Level {
    /// Returns the size of the letters relative to those on the base line.
    pub(crate) const fn size(self) -> f64 {
        match self {
            Self::Base => 1.0,
            Self::Sub | Self::Sup => 0.74,
        }
    }

    /// Returns the distance below the base line, relative to the size of its letters.
    pub(crate) const fn drop(self) -> f64 {
        match self {
            Self::Base => 0.0,
            Self::Sub => 0.22,
            Self::Sup => -0.36,
        }
    }
}
