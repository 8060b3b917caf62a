//! A case: a faulty description and what is told of it.

use std::path::Path;

/// Through which doors a case can go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Door {
    /// Text and macro.
    Every,
    /// Text alone: the compiler refuses such tokens itself.
    Text,
    /// The macro alone, from the tokens that it is given.
    Macro,
    /// The path of a file.
    File,
    /// A scene put together in code.
    Code,
}

impl Door {
    /// Whether a text is told what the case says.
    pub fn takes_text(self) -> bool {
        matches!(self, Self::Every | Self::Text)
    }

    /// Whether the compiler is to read the case.
    pub fn takes_tokens(self) -> bool {
        matches!(self, Self::Every | Self::Macro)
    }

    /// Whether there is a description at all.
    pub fn is_description(self) -> bool {
        !matches!(self, Self::File | Self::Code)
    }
}

/// A file of `tests/messages/`.
pub struct Case {
    /// The file's name, without its ending.
    pub name: String,
    /// Why the message comes, in a sentence.
    pub cause: String,
    /// Where it comes.
    pub door: Door,
    /// The faulty description.
    pub faulty: String,
    /// `line:column: message`, in the order of the text; a message alone where there is no text.
    pub told: Vec<String>,
    /// The same as the compiler tells it, where the places differ; line 0 is that of the call.
    pub told_by_rustc: Option<Vec<String>>,
    /// The description as it should be.
    pub cured: String,
}

impl Case {
    /// The message of a line without its place.
    pub fn message<'t>(&self, line: &'t str) -> &'t str {
        if self.door.is_description() {
            let mut parts = line.splitn(3, ':');
            parts.nth(2).expect("line:column: message").trim_start()
        } else {
            line
        }
    }
}

/// All cases in the order of their numbers.
pub fn cases() -> Vec<Case> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/messages");
    let mut cases: Vec<_> = std::fs::read_dir(folder)
        .expect("the folder of the cases")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| {
            path.extension()
                .is_some_and(|extension| extension == "friction")
        })
        .map(|path| read(&path))
        .collect();
    cases.sort_by(|one, other| one.name.cmp(&other.name));
    cases
}

fn read(path: &Path) -> Case {
    let name = path
        .file_stem()
        .and_then(|stem| stem.to_str())
        .expect("a name")
        .to_owned();
    let text = std::fs::read_to_string(path).expect("a text");
    let mut sections = text.split("--- ");
    let head = sections.next().unwrap_or_default();
    let mut case = Case {
        name: name.clone(),
        cause: String::new(),
        door: Door::Every,
        faulty: String::new(),
        told: Vec::new(),
        told_by_rustc: None,
        cured: String::new(),
    };
    for line in head.lines() {
        match line.split_once(": ").expect("key: value") {
            ("cause", cause) => case.cause = cause.to_owned(),
            ("door", "text") => case.door = Door::Text,
            ("door", "macro") => case.door = Door::Macro,
            ("door", "file") => case.door = Door::File,
            ("door", "code") => case.door = Door::Code,
            other => panic!("{name}: what is {other:?}?"),
        }
    }
    for section in sections {
        let (title, body) = section.split_once('\n').expect("a title and a body");
        let lines = || body.lines().map(str::to_owned).collect();
        match title {
            "faulty" => body.clone_into(&mut case.faulty),
            "told" => case.told = lines(),
            "told by rustc" => case.told_by_rustc = Some(lines()),
            "cured" => body.clone_into(&mut case.cured),
            other => panic!("{name}: what is {other:?}?"),
        }
    }
    case
}
