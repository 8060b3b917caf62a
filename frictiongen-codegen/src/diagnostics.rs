//! Errors of a description: collected while it is read, handed out all at once.

use core::fmt;

use frictiongen_model::scene::Precision;
use proc_macro2::{Ident, Span};

/// One error in a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// The line, counted from 1.
    pub line: usize,
    /// The column in characters, counted from 1.
    pub column: usize,
    /// What is wrong and what to write instead.
    pub message: String,
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}", self.line, self.column, self.message)
    }
}

/// Every error in a text, in the order of the text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostics {
    /// The errors; at least one.
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

/// Why the tokens of a macro call are no scene.
#[derive(Debug)]
pub struct Failure {
    /// Every error, each on the token it is about.
    pub errors: syn::Error,
    /// What could be read all the same.
    pub partial: Partial,
}

/// What could be read of a faulty description: enough for a macro to emit something of the right
/// shape, so that the calls to it do not add errors of their own.
pub struct Partial {
    /// The attributes before the struct.
    pub attributes: Vec<syn::Attribute>,
    /// Its visibility.
    pub visibility: syn::Visibility,
    /// Its name, if it has a usable one.
    pub name: Option<Ident>,
    /// The path of the facade.
    pub facade: syn::Path,
    /// The masses whose names can name methods.
    pub mass_names: Vec<Ident>,
    /// The scalar.
    pub precision: Precision,
    /// Whether the base is excited.
    pub on_base: bool,
    /// The masses that the stepper may load, by their places among `mass_names`.
    pub forces: Vec<usize>,
    /// Whether a step is declared.
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

/// Where a token stands: in the source that the compiler reads, or in a text of our own.
///
/// Inside a macro, tokens made from a text all carry the span of the call, so a text's lines and
/// columns are kept beside the span.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Place {
    /// A token from the compiler.
    Span(Span),
    /// A place in a text, both counted from 1.
    Text {
        /// The line.
        line: usize,
        /// The column, in characters.
        column: usize,
    },
}

impl Place {
    /// The span that emitted tokens carry.
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

/// That an error has been reported and the caller need not do so again.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reported;

/// The errors found so far.
#[derive(Default)]
pub(crate) struct Problems {
    list: Vec<Problem>,
}

impl Problems {
    /// Takes note of an error.
    pub(crate) fn report(&mut self, place: Place, message: impl Into<String>) -> Reported {
        self.list.push(Problem {
            place,
            message: message.into(),
        });
        Reported
    }

    /// Whether there is none.
    pub(crate) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Whether there are so many that working out advice for more is no help to anyone.
    pub(crate) fn are_many(&self) -> bool {
        self.list.len() > 100
    }

    /// The errors as a list of lines and columns, in the order of the text.
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

    /// The errors as one that becomes a `compile_error!` for each, in the order of the source.
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
