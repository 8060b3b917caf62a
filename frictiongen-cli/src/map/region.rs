//! Names the regions of a map.

use crate::asked::no_answer;
use frictiongen::study::Pattern;
use frictiongen::{Error, Regime};
use std::borrow::Cow;

/// What a region is called.
pub fn name(found: Result<Pattern, Error>) -> Cow<'static, str> {
    let pattern = match found {
        Ok(pattern) => pattern,
        Err(error) => return no_answer(error).into(),
    };
    match (pattern.regime, pattern.period, pattern.stops) {
        (Regime::Continuous, ..) => "continuous".into(),
        (Regime::Stuck, ..) => "stuck".into(),
        (_, 0, _) => "unsettled".into(),
        (_, 1, 0) => "sliding reversals".into(),
        (_, 1, 1) => "1 stop".into(),
        (_, 1, stops) => format!("{stops} stops").into(),
        _ => "subharmonic".into(),
    }
}
