//! Errors of a description. The reader collects them and returns all at once.

use core::fmt;

use frictiongen_model::scene::Precision;
use proc_macro2::{Ident, Span};

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

/// Errors of a macro call whose tokens are not a valid scene.
#[derive(Debug)]
pub struct Failure {
    /// All errors, each on the token that caused it.
    pub errors: syn::Error,
    /// The fields of the description that could be read in spite of the errors.
    pub partial: Partial,
}

/// The fields of a faulty description that could be read. They are enough for a macro to emit a
/// type with the expected methods, so that calls to those methods do not add errors.
pub struct Partial {
    /// The attributes before the struct.
    pub attributes: Vec<syn::Attribute>,
    /// The visibility of the struct.
    pub visibility: syn::Visibility,
    /// The name of the struct; `None` if it is not usable.
    pub name: Option<Ident>,
    /// The path under which the user's crate imports the facade crate `frictiongen`.
    pub facade: syn::Path,
    /// The masses whose names are valid method names.
    pub mass_names: Vec<Ident>,
    /// The scalar type of the scene.
    pub precision: Precision,
    /// True if the base is excited.
    pub on_base: bool,
    /// The masses that the stepper may load, as indices into `mass_names`.
    pub forces: Vec<usize>,
    /// True if the description declares a step.
    pub has_step: bool,
}

impl fmt::Debug for Partial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Partial")
            .field("name", &self.name)
            .field("mass_names", &self.mass_names)
            .field("precision", &self.precision)
            .finish_non_exhaustive()
    }
}

/// Position of a token in the compiler's source or in a text that this crate reads.
///
/// Inside a macro, all tokens made from a text carry the span of the call. `Text` therefore keeps
/// the line and column in that text.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Place {
    /// A token from the compiler.
    Span(Span),
    /// A position in a text. Line and column count from 1.
    Text {
        /// The line, counted from 1.
        line: usize,
        /// The column, counted in characters from 1.
        column: usize,
    },
}

impl Place {
    /// Returns the span for emitted tokens.
    pub(crate) fn span(self) -> Span {
        match self {
            Self::Span(span) => span,
            Self::Text { .. } => Span::call_site(),
        }
    }

    fn line_column(self) -> (usize, usize) {
        match self {
            Self::Span(span) => (span.start().line, span.start().column + 1),
            Self::Text { line, column } => (line, column),
        }
    }
}

struct Problem {
    place: Place,
    message: String,
}

/// Marks an error as reported, so that the caller does not report it again.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reported;

/// The errors found so far.
#[derive(Default)]
pub(crate) struct Problems {
    list: Vec<Problem>,
}

impl Problems {
    /// Adds an error to the list.
    pub(crate) fn report(&mut self, place: Place, message: impl Into<String>) -> Reported {
        self.list.push(Problem {
            place,
            message: message.into(),
        });
        Reported
    }

    /// Returns whether the list has no error.
    pub(crate) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Returns whether the list has more than 100 errors. Advice for further errors would then help
    /// nobody.
    pub(crate) fn are_many(&self) -> bool {
        self.list.len() > 100
    }

    /// Returns the errors with lines and columns, in the order of the text.
    pub(crate) fn into_diagnostics(self) -> Diagnostics {
        let mut list: Vec<_> = self
            .list
            .into_iter()
            .map(|problem| {
                let (line, column) = problem.place.line_column();
                Diagnostic {
                    line,
                    column,
                    message: problem.message,
                }
            })
            .collect();
        list.sort_by_key(|diagnostic| (diagnostic.line, diagnostic.column));
        Diagnostics { list }
    }

    /// Returns the errors as one `syn::Error`, which becomes a `compile_error!` for each, in the
    /// order of the source.
    pub(crate) fn into_error(mut self) -> syn::Error {
        self.list
            .sort_by_cached_key(|problem| problem.place.line_column());
        self.list
            .into_iter()
            .map(|problem| syn::Error::new(problem.place.span(), problem.message))
            .reduce(|mut all, next| {
                all.combine(next);
                all
            })
            .unwrap_or_else(|| syn::Error::new(Span::call_site(), "this is not a scene"))
    }
}
