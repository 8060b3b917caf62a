//! Checks of the masses: their number, names and values.

use std::collections::HashSet;

use super::checks::{Checks, LARGEST, SMALLEST};
use super::error::SceneError;
use super::names::{is_keyword, is_name, is_reserved};
use super::path::Path;
use crate::scene::{CONTACT, Scene};

/// Reports errors in the number, the names and the values of the masses.
pub(super) fn check(scene: &Scene, checks: &Checks, errors: &mut Vec<SceneError>) {
    let count = scene.masses.len();
    if count == 0 && checks.masses {
        errors.push(SceneError::NoMasses { path: Path::Masses });
    }
    if count > checks.most_masses {
        let limit = checks.most_masses;
        errors.push(SceneError::TooManyMasses {
            path: Path::MassName(limit),
            count,
            limit,
        });
    }
    let mut seen = HashSet::new();
    for (index, mass) in scene.masses.iter().enumerate() {
        let name = mass.name.clone();
        let path = Path::MassName(index);
        if let Some(plain) = name.strip_prefix("r#") {
            errors.push(SceneError::RawName {
                path,
                plain: plain.to_owned(),
            });
        } else if checks.emitted && is_keyword(&name) {
            errors.push(SceneError::Keyword { path, name });
        } else if name == CONTACT || is_reserved(&name, checks.emitted) {
            errors.push(SceneError::Reserved { path, name });
        } else if !is_name(&name) {
            errors.push(SceneError::NotAName { path, name });
        } else if !seen.insert(mass.name.as_str()) {
            errors.push(SceneError::DuplicateName { path, name });
        }

        let (name, value, path) = (mass.name.clone(), mass.value, Path::Mass(index));
        if !value.is_finite() {
            errors.push(SceneError::NotFinite {
                path,
                what: format!("the mass `{name}`"),
                value,
            });
        } else if value <= 0.0 {
            errors.push(SceneError::MassNotPositive { path, name, value });
        } else if !(SMALLEST..=LARGEST).contains(&value) {
            errors.push(SceneError::OutOfScale {
                path,
                what: format!("the mass `{name}`"),
                value,
            });
        }
    }
}
