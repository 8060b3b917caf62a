//! Typeface and vertical level of a piece of text.

/// The typeface of a piece of text: regular, italic or bold.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Face {
    /// Upright letters.
    #[default]
    Regular,
    /// Italic letters, for symbols.
    Italic,
    /// Bold letters, for headings.
    Bold,
}

/// The vertical level of a piece of text: normal, subscript or superscript.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Level {
    /// Normal text, on the base line.
    #[default]
    Base,
    /// Subscript: smaller letters below the base line.
    Sub,
    /// Superscript: smaller letters above the base line.
    Sup,
}

impl Level {
    /// Returns the size of the letters at this level, relative to letters on the base line.
    pub(crate) const fn size(self) -> f64 {
        match self {
            Self::Base => 1.0,
            Self::Sub | Self::Sup => 0.74,
        }
    }

    /// Returns the distance of the letters at this level below the base line, relative to the size of letters on the
    /// base line.
    pub(crate) const fn drop(self) -> f64 {
        match self {
            Self::Base => 0.0,
            Self::Sub => 0.22,
            Self::Sup => -0.36,
        }
    }
}
