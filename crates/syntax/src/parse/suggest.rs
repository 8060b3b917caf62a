//! Suggests a correction for a misspelt word: "Did you mean …?"

/// Length, in letters, of the longest word for which the function searches a correction. A longer word is hardly a
/// misspelling, and the search would be slow.
const LONGEST: usize = 64;
/// Length, in letters, of the shortest word that counts as an abbreviation of a longer word.
const SHORTEST: usize = 3;

/// Returns the candidate that the author of a misspelt word most likely means, or `None`.
pub(crate) fn closest<'c>(
    word: &str,
    candidates: impl IntoIterator<Item = &'c str>,
) -> Option<&'c str> {
    let length = word.chars().count();
    if length > LONGEST {
        return None;
    }
    // In a word of up to five letters only one letter may differ. With two wrong letters, `brace` would suggest
    // `crate`.
    let allowed = (length / 3).max(1);
    candidates
        .into_iter()
        .filter(|candidate| candidate.chars().count() <= LONGEST)
        .map(|candidate| {
            (
                distance(&word.to_lowercase(), &candidate.to_lowercase()),
                candidate,
            )
        })
        // A candidate that differs from the word in every letter is not a likely correction.
        .filter(|&(steps, candidate)| {
            let abbreviates = SHORTEST <= length && candidate.starts_with(word);
            (steps <= allowed || abbreviates) && steps < candidate.chars().count()
        })
        // At the same distance, a letter that is missing or surplus at the end is the likeliest mistake: `stop` means
        // `stops`, and `steps` means `step`.
        .min_by_key(|&(steps, candidate)| {
            let begins_same = candidate.starts_with(word) || word.starts_with(candidate);
            (steps, !begins_same)
        })
        .map(|(_, candidate)| candidate)
}

/// Returns `; did you mean …?` with the closest candidate, or the text of `otherwise` if no candidate is close.
pub(crate) fn hint<'c>(
    word: &str,
    candidates: impl IntoIterator<Item = &'c str>,
    otherwise: impl FnOnce() -> String,
) -> String {
    closest(word, candidates).map_or_else(
        || format!("; {}", otherwise()),
        |meant| format!("; did you mean `{meant}`?"),
    )
}

/// Returns the number of edits from one word to another. An edit inserts, deletes or replaces a letter, or swaps two
/// neighbouring letters.
fn distance(from: &str, to: &str) -> usize {
    let to: Vec<char> = to.chars().collect();
    let mut before: Vec<usize> = Vec::new();
    let mut above: Vec<usize> = (0..=to.len()).collect();
    let mut last = None;
    for (row, letter) in from.chars().enumerate() {
        let mut current = vec![row + 1];
        let mut left = row + 1;
        for (column, &other) in to.iter().enumerate() {
            let at =
                |line: &[usize], place: usize| line.get(place).copied().unwrap_or(usize::MAX / 2);
            let replace = at(&above, column) + usize::from(letter != other);
            let mut best = replace.min(at(&above, column + 1) + 1).min(left + 1);
            let previous = column.checked_sub(1).and_then(|place| to.get(place));
            if last == Some(other) && previous == Some(&letter) && letter != other {
                best = best.min(at(&before, column - 1) + 1);
            }
            current.push(best);
            left = best;
        }
        last = Some(letter);
        before = core::mem::replace(&mut above, current);
    }
    above.last().copied().unwrap_or(0)
}
