//! The option `--vary share` of `frictiongen optimum`, which also chooses the shares of several contacts.

use crate::failure::Failure;
use crate::vary::Vary;
use frictiongen::System;
use frictiongen::study::columns::{OptimumLine, OptimumTable};
use frictiongen::study::joined::JoinedError;
use frictiongen::study::optimum::{OptimumRequest, ShareRange};

/// Returns the shares that `--vary` names. A share is the friction of a contact, relative to the common friction. `share
/// pads=a:b` varies the share of one contact. `share=a:b` varies the shares of all contacts but the first, because a
/// common factor on all shares has the effect of the common friction. Returns `None` if the option names another number,
/// or if the scene has a single contact.
pub fn ranges(system: &System, text: &str) -> Result<Option<Vec<ShareRange>>, Failure> {
    let vary = Vary::parsed(text)?;
    let mut words = vary.name.split_whitespace();
    if !system.scene().is_joined() || words.next() != Some("share") {
        return Ok(None);
    }
    let contacts = system.scene().named_contacts();
    let names = || contacts.iter().map(|contact| contact.name.as_str());
    let name: Vec<&str> = words.collect();
    let indices: Vec<usize> = match name.as_slice() {
        [] => (1..contacts.len()).collect(),
        name => {
            let name = name.join(" ");
            let found = names().position(|contact| contact == name);
            let missing = || {
                let known = names().collect::<Vec<_>>().join(", ");
                let problem = format!("there is no contact `{name}`; the contacts are {known}");
                vary.wrong(&problem)
            };
            vec![found.ok_or_else(missing)?]
        }
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
