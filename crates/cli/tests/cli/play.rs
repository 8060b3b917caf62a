//! Tests `frictiongen play` and `frictiongen report --live`, which put a description into the playground.
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

#[test]
#[cfg(feature = "report")]
fn a_live_report_contains_the_playground() {
    let page = file("live.html", PAGE);
    let asked = ["report", FRAME, "--r", "0.5:2", "--live", "--page", &page];
    let report = output("", &asked);
    let (_, rest) = report.split_once("srcdoc=\"").unwrap();
    let (frame, _) = rest.split_once('"').unwrap();
    let frame = frame
        .replace("&lt;", "<")
        .replace("&gt;", ">")
        .replace("&quot;", "\"")
        .replace("&amp;", "&");
    assert_eq!(given(&frame), fs::read_to_string(FRAME).unwrap());
    assert!(frame.contains("\"from\":0.5,"), "{frame}");
    assert!(frame.contains("\"to\":2.0}"), "{frame}");
    assert!(report.contains("'wasm-unsafe-eval'"));
    // Without --live the page permits no script but its own.
    let report = output("", &["report", FRAME, "--r", "0.5:2"]);
    assert!(!report.contains("unsafe-eval") && !report.contains("<iframe"));
}

#[test]
#[cfg(feature = "report")]
fn a_live_report_without_playground_says_what_is_missing() {
    for (arguments, words) in [
        (vec!["report", FRAME, "--live"], "scripts/playground"),
        (
            vec!["report", FRAME, "--live", "--page", "none.html"],
            "cannot read the page none.html",
        ),
        (vec!["report", FRAME, "--page", "a.html"], "--live"),
    ] {
        let said = failure("", &arguments).join("\n");
        assert!(said.contains(words), "{arguments:?}: {said}");
    }
}
