//! How a run of text is cut, and where it stands.

/// How a run of text is cut.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Face {
    /// Upright.
    #[default]
    Regular,
    /// Slanted, for symbols.
    Italic,
    /// Heavy, for headings.
    Bold,
}

/// Where a run of text stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Level {
    /// On the line.
    #[default]
    Base,
    /// Below it, smaller.
    Sub,
    /// Above it, smaller.
    Sup,
}

impl Level {
    /// The size of its letters, relative to the line's.
    pub(crate) const fn size(self) -> f64 {
        match self {
            Self::Base => 1.0,
            Self::Sub | Self::Sup => 0.74,
        }
    }

    /// How far below the line it stands, relative to the line's size.
    pub(crate) const fn drop(self) -> f64 {
        match self {
            Self::Base => 0.0,
            Self::Sub => 0.22,
            Self::Sup => -0.36,
        }
    }
}
