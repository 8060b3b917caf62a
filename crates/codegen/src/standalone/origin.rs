//! Writes the origin of an emitted file: its description, the command that made it, the version, and the hash of the
//! scene.

use crate::comment::rust_text;
use crate::emit::fingerprint;
use frictiongen_model::scene::Scene;

/// Request to the reader in the first lines of an emitted file.
pub const NOTICE: &str = "generated: change the description, not this file";

/// The description and the command of an emitted file.
#[derive(Clone, Copy, Debug)]
pub struct Origin<'a> {
    /// The description as it was written.
    pub description: &'a str,
    /// The command that wrote the file, with its options.
    pub command: &'a str,
}

/// Returns the hash of a scene in hexadecimal digits. Descriptions that differ only in layout have the same hash.
#[must_use]
pub fn scene_hash(scene: &Scene) -> String {
    format!("{:016x}", fingerprint(scene))
}

impl Origin<'_> {
    /// Returns three lines with the version, the command and the scene of a file.
    fn head(&self, scene: &Scene) -> [String; 3] {
        [
            format!(
                "{} {}: {NOTICE}.",
                env!("CARGO_PKG_NAME").trim_end_matches("-codegen"),
                env!("CARGO_PKG_VERSION")
            ),
            format!("Command: {}", self.command),
            format!(
                "Scene {} with the hash {}, which emitted Rust calls `SCENE_HASH`.",
                scene.name,
                scene_hash(scene)
            ),
        ]
    }

    /// Returns the origin as line comments in Rust, without the description. Files whose documentation already contains
    /// the description use this function.
    #[must_use]
    pub fn rust_head(&self, scene: &Scene) -> String {
        let head = self.head(scene);
        let lines = head.iter().map(|line| format!("// {}\n", rust_text(line)));
        lines.collect()
    }

    /// Returns the comment lines at the beginning of a file.
    fn lines(&self, scene: &Scene) -> Vec<String> {
        let mut lines = self.head(scene).to_vec();
        if let Some(last) = lines.last_mut() {
            last.push_str("  Its description:");
        }
        lines.push(String::new());
        let text = self.description.trim_start_matches('\u{feff}').trim_end();
        lines.extend(text.lines().map(|line| format!("    {}", line.trim_end())));
        lines
    }

    /// Returns the origin as a block comment in C, in ASCII.
    pub fn c_comment(&self, scene: &Scene) -> String {
        let lines = self.lines(scene);
        let lines = lines.iter().map(|line| c_text(line));
        let lines: Vec<String> = lines
            .map(|line| format!(" * {line}").trim_end().to_owned())
            .collect();
        let text = lines.join("\n");
        format!("/*{} */\n", text.strip_prefix(" *").unwrap_or(&text))
    }

    /// Returns the origin as line comments in Rust.
    pub(super) fn rust_comment(&self, scene: &Scene) -> String {
        let lines = self.lines(scene);
        let lines = lines.iter().map(|line| format!("// {}", rust_text(line)));
        lines.map(|line| format!("{}\n", line.trim_end())).collect()
    }
}

/// Returns a text that is safe in a comment of C. The text is in ASCII, without trigraphs and without the marks that
/// begin or end a comment. Subscript digits become digits, and all other characters become escapes. The function adds a
/// full stop after a backslash at the end of a line, because the compiler would otherwise join this line with the next.
pub fn c_text(text: &str) -> String {
    let mut out = String::new();
    for letter in text.chars() {
        let last = out.chars().next_back();
        if matches!(
            (last, letter),
            (Some('*'), '/') | (Some('/'), '*') | (Some('?'), '?')
        ) {
            out.push(' ');
        }
        match letter {
            '\t' => out.push_str("    "),
            ' '..='~' => out.push(letter),
            '₀'..='₉' => out.push(digit(letter)),
            _ if u32::from(letter) <= 0xffff => {
                out.push_str(&format!("\\u{:04x}", u32::from(letter)))
            }
            _ => out.push_str(&format!("\\U{:08x}", u32::from(letter))),
        }
    }
    if out.ends_with('\\') {
        out.push('.');
    }
    out
}

/// Returns the digit of a subscript digit.
fn digit(subscript: char) -> char {
    let value = u32::from(subscript) - u32::from('₀');
    char::from_digit(value, 10).unwrap_or(subscript)
}
