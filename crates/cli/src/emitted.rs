//! Reads emitted code as text, and lists the functions whose documentation states a number of operations.

/// A function of the emitted code, as its documentation describes it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EmittedFunction {
    /// Name of the function.
    pub name: String,
    /// First line of the function's documentation.
    pub about: String,
    /// Number of operations, as the documentation of the function states it.
    pub operations: String,
}

/// Returns the functions of the emitted code whose documentation states a number of operations.
pub fn functions(source: &str) -> Vec<EmittedFunction> {
    let (mut found, mut about, mut operations) = (Vec::new(), String::new(), None);
    for line in source.lines().map(str::trim) {
        if let Some(words) = line.strip_prefix("///").map(str::trim) {
            match words.strip_prefix("Operations: ") {
                Some(counts) => operations = Some(counts.trim_end_matches('.').to_owned()),
                None if about.is_empty() => words.clone_into(&mut about),
                None => {}
            }
            continue;
        }
        if let Some((name, _)) = line
            .split_once("fn ")
            .and_then(|(_, rest)| rest.split_once(['(', '<']))
            && let Some(operations) = operations.take()
        {
            found.push(EmittedFunction {
                name: name.to_owned(),
                about: about.clone(),
                operations,
            });
        }
        if !line.starts_with("#[") {
            about.clear();
            operations = None;
        }
    }
    found
}
