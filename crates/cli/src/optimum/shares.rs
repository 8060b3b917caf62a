//! The option `--vary share` of `frictiongen optimum`, which also chooses the shares of several contacts.

use crate::failure::Failure;
use crate::vary::Vary;
use frictiongen::System;
use frictiongen::study::columns::{OptimumLine, OptimumTable};
use frictiongen::study::joined::JoinedError;
use frictiongen::study::optimum::{OptimumRequest, ShareRange};

/// Returns the shares that `--vary` names, each with its interval. A share is the friction of a contact, relative to the
/// common friction. Returns `None` if the option names another number, or if the scene has a single contact.
pub fn ranges(system: &System, text: &str) -> Result<Option<Vec<ShareRange>>, Failure> {
    let vary = Vary::parsed(text)?;
    let named = system.shares_named(vary.name);
    let Some(indices) = named.map_err(|problem| vary.wrong(&problem))? else {
        return Ok(None);
    };
    let (from, to) = vary.ends()?;
    if !(0.0 < from && from < to && to.is_finite()) {
        return Err(vary.wrong(&JoinedError::Shares));
    }
    let ranges = indices.into_iter();
    let ranges = ranges.map(|contact| ShareRange { contact, from, to });
    Ok(Some(ranges.collect()))
}

/// Finds the best common friction together with the best shares, and returns the lines of the result.
pub fn lines(
    table: &OptimumTable<'_>,
    request: &OptimumRequest,
    ranges: &[ShareRange],
    watch: &(dyn Fn() -> bool + Sync),
) -> Result<Vec<OptimumLine>, Failure> {
    let found = table.setting.system.best_shares(request, ranges, watch);
    let found = found.map_err(Failure::new)?;
    let mut lines = table.share_lines(&found);
    lines.extend(table.lines(&found.optimum, None));
    Ok(lines)
}
