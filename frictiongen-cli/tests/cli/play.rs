//! Tests `frictiongen play`, which puts a description into the playground.
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    reason = "a test may fail"
)]

use crate::common::{FRAME, failure, output};
use serde_json::Value;
use std::fs;
use std::path::PathBuf;

/// A page with the element that `scripts/playground` leaves empty.
const PAGE: &str =
    "<html><script id=\"given\" type=\"application/json\">null</script><p>page</p></html>";

/// Writes a file into a folder of this test program.
fn file(name: &str, text: &str) -> String {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("play");
    fs::create_dir_all(&folder).unwrap();
    let path = folder.join(name);
    fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

/// Returns the description in a page.
fn given(page: &str) -> String {
    let (_, rest) = page.split_once("type=\"application/json\">").unwrap();
    let (data, rest) = rest.split_once("</script>").unwrap();
    assert_eq!(rest, "<p>page</p></html>");
    let data: Value = serde_json::from_str(data).unwrap();
    data["text"].as_str().unwrap().to_owned()
}

#[test]
fn the_page_has_the_description() {
    let page = file("page.html", PAGE);
    let frame = fs::read_to_string(FRAME).unwrap();
    assert_eq!(given(&output("", &["play", FRAME, "--page", &page])), frame);
    // A comment may have any text, also one that would end the element.
    let text = format!("// </script><script>alert(1)</script> \" \\ é\n{frame}");
    assert_eq!(given(&output(&text, &["play", "-", "--page", &page])), text);
    let written = file("written.html", "");
    output("", &["play", FRAME, "--page", &page, "-o", &written]);
    assert_eq!(given(&fs::read_to_string(&written).unwrap()), frame);
}

#[test]
fn what_is_missing_is_named() {
    let page = file("empty.html", PAGE);
    let other = file("other.html", "<html></html>");
    for (arguments, words) in [
        (vec!["play", FRAME], "scripts/playground"),
        (vec!["play", FRAME, "--page", &other], "not a playground"),
        (
            vec!["play", FRAME, "--page", "none.html"],
            "cannot read the page none.html",
        ),
        (
            vec!["play", FRAME, "--page", &page, "-o", "a.svg"],
            "must end in .html",
        ),
        (vec!["play", "-", "--page", &page], "<stdin>:1:"),
    ] {
        let said = failure("struct A {", &arguments).join("\n");
        assert!(said.contains(words), "{arguments:?}: {said}");
    }
}
