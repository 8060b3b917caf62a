//! Errors of a scene description. The parser collects all errors and returns them together.

use core::fmt;

/// An error in a text, with its position.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// The line of the error, counted from 1.
    pub line: usize,
    /// The column of the error, counted in characters from 1.
    pub column: usize,
    /// The message: the error and what to write instead.
    pub message: String,
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}", self.line, self.column, self.message)
    }
}

/// All errors in a text, in the order of the text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostics {
    /// The errors of the text, at least one.
    pub list: Vec<Diagnostic>,
}

impl fmt::Display for Diagnostics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, diagnostic) in self.list.iter().enumerate() {
            if index > 0 {
                writeln!(f)?;
            }
            write!(f, "{diagnostic}")?;
        }
        Ok(())
    }
}

impl core::error::Error for Diagnostics {}

/// Position of a token in a description.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TokenPosition {
    /// The line of the token, counted from 1.
    pub line: usize,
    /// The column at which the token begins, counted in characters from 1.
    pub column: usize,
    /// Index of the token in the list that the caller passed, or `None` if the description is a text.
    pub token: Option<usize>,
}

/// An error of a description, at the position of a token.
#[derive(Clone, Debug)]
pub struct Problem {
    /// The position of the token that caused the error.
    pub place: TokenPosition,
    /// The message: the error and what to write instead.
    pub message: String,
}

/// Proof that a function has already reported its error. The caller of the function must not report the error again.
#[derive(Clone, Copy, Debug)]
pub struct Reported;

/// The errors of a description that the parser has found so far.
#[derive(Debug, Default)]
pub struct Problems {
    list: Vec<Problem>,
}

impl Problems {
    /// Adds an error at a position to the list of errors.
    pub fn report(&mut self, place: TokenPosition, message: impl Into<String>) -> Reported {
        self.list.push(Problem {
            place,
            message: message.into(),
        });
        Reported
    }

    /// Returns true if no function has reported an error so far.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Returns true after more than 100 errors. Messages of further errors then contain no advice.
    pub(crate) fn are_many(&self) -> bool {
        self.list.len() > 100
    }

    /// Returns the errors in the order of the description.
    #[must_use]
    pub fn into_sorted(mut self) -> Vec<Problem> {
        self.list
            .sort_by_key(|Problem { place, .. }| (place.line, place.column));
        self.list
    }

    /// Returns the errors in the order of the text, each with line and column.
    #[must_use]
    pub fn into_diagnostics(self) -> Diagnostics {
        let list = self.into_sorted().into_iter();
        let list = list.map(|Problem { place, message }| Diagnostic {
            line: place.line,
            column: place.column,
            message,
        });
        Diagnostics {
            list: list.collect(),
        }
    }
}
