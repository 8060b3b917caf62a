//! Converts a syntax tree to a scene, and checks that the scene makes physical sense.

mod joints;
mod places;
mod readable;
mod resolve;
mod settings;
mod stepping;
#[cfg(test)]
mod tests;

use frictiongen_model::scene::Scene;
use frictiongen_model::stribeck::SmoothLaw;
use frictiongen_model::validate::{Checks, Path};

use self::places::Places;
use crate::diagnostics::{Problems, TokenPosition};
use crate::parse::syntax::Syntax;

pub use readable::Readable;

/// A scene, with the positions of its springs, masses and fields in the description.
pub struct Located<'s> {
    /// The scene that the description defines. It is valid if no error was reported.
    pub scene: Scene,
    /// The smooth friction law that the lines of the scene replace, if the description has one.
    pub law: Option<SmoothLaw>,
    places: Places<'s>,
}

impl Located<'_> {
    /// Returns the position of an item of the scene in the description. If the description does not contain the item,
    /// returns the position of the scene's name.
    #[must_use]
    pub fn place(&self, path: Path) -> TokenPosition {
        self.places.of(path)
    }

    /// Returns the position of an item of the scene in the description, or `None` if the description does not contain
    /// the item.
    #[must_use]
    pub fn written(&self, path: Path) -> Option<TokenPosition> {
        self.places.find(path)
    }
}

impl Syntax {
    /// Converts the syntax tree to a scene, and reports all errors. If `emitted` is true, the scene is for emitted code,
    /// which restricts its names and the field `provide`. Returns `None` for a description without fields.
    pub fn lower(
        &self,
        most_masses: usize,
        emitted: bool,
        problems: &mut Problems,
    ) -> Option<Located<'_>> {
        let checks = Checks {
            most_masses,
            emitted,
            ..Checks::default()
        };
        self.has_body
            .then(|| resolve::resolve(self, checks, problems))
    }
}
