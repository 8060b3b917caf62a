//! Shorter SVG.

use std::fmt::Write as _;

/// Joins strokes of one style that follow each other, such as the dashes of a line, into one path.
#[must_use]
pub fn joined(text: &str) -> String {
    let mut out = String::new();
    let mut current: Option<&str> = None;
    for line in text.lines() {
        let stroke = line
            .strip_prefix("<polyline ")
            .and_then(|rest| rest.strip_suffix(" \"/>"))
            .and_then(|rest| rest.split_once(" points=\""));
        let style = stroke.map(|(style, _)| style);
        if current.is_some() && current != style {
            out.push_str("\"/>\n");
        }
        if let Some((style, points)) = stroke {
            if current != Some(style) {
                // Writing to a string cannot fail.
                let _ = write!(out, "<path {style} d=\"");
            }
            // Pairs after the first are lines.
            let _ = write!(out, "M{points}");
        } else {
            out.push_str(line);
            out.push('\n');
        }
        current = style;
    }
    out
}

#[cfg(test)]
mod tests {
    #[test]
    fn joins_strokes_of_one_style_only() {
        let text = "<svg>\n<polyline a=\"1\" points=\"1,2 3,4 \"/>\n<polyline a=\"1\" points=\"5,6 7,8 \"/>\n\
                    <polyline a=\"2\" points=\"9,9 8,8 \"/>\n</svg>\n";
        assert_eq!(
            super::joined(text),
            "<svg>\n<path a=\"1\" d=\"M1,2 3,4M5,6 7,8\"/>\n<path a=\"2\" d=\"M9,9 8,8\"/>\n</svg>\n"
        );
    }
}
