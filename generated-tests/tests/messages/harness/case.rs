//! A case: a faulty description and its messages.

use std::path::Path;

/// Ways in which a description can be given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Door {
    /// The description is given as text, and to the macro.
    Every,
    /// The description is given as text only, because the compiler itself refuses its tokens.
    Text,
    /// The description is given to the macro only, because the case concerns the macro's tokens.
    Macro,
    /// The description is given as text, and to the macro, for emitted code. A system at run time accepts the
    /// description.
    Emitted,
    /// The path of a file is given.
    File,
    /// A scene is built in code.
    Code,
}

impl Door {
    /// Returns `true` if the parser of texts gives the messages of the case.
    pub fn takes_text(self) -> bool {
        matches!(self, Self::Every | Self::Text | Self::Emitted)
    }

    /// Returns `true` if the compiler reads the case.
    pub fn takes_tokens(self) -> bool {
        matches!(self, Self::Every | Self::Macro | Self::Emitted)
    }

    /// Returns `true` if the case has a description.
    pub fn is_description(self) -> bool {
        !matches!(self, Self::File | Self::Code)
    }
}

/// A file of `tests/messages/`.
pub struct Case {
    /// Name of the file without its extension.
    pub name: String,
    /// Cause of the message, in a sentence.
    pub cause: String,
    /// Way in which the description is given.
    pub door: Door,
    /// Faulty description.
    pub faulty: String,
    /// Messages as `line:column: message`, in the order of the text. For a case without a text they have no position.
    pub told: Vec<String>,
    /// Messages of the compiler, if their positions differ from those in `told`. Line 0 is the line of the macro
    /// call.
    pub told_by_rustc: Option<Vec<String>>,
    /// Corrected description.
    pub cured: String,
}

impl Case {
    /// Returns the message of a line without its position.
    pub fn message<'t>(&self, line: &'t str) -> &'t str {
        if self.door.is_description() {
            let mut parts = line.splitn(3, ':');
            parts.nth(2).expect("line:column: message").trim_start()
        } else {
            line
        }
    }
}

/// Returns all cases in the order of their numbers.
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
            ("door", "emitted") => case.door = Door::Emitted,
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
