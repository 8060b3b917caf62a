//! The playground in the report, in which a reader can change numbers and see the results.

use super::asked::ReportRequest;
use crate::play;
use maud::{Markup, html};
use serde_json::json;

/// Security policy of a report with the playground. It permits the scripts, the WebAssembly and the worker of the
/// playground. The frame of the playground inherits the policy of the report.
pub const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline' \
     'wasm-unsafe-eval' blob:; worker-src blob:; img-src data:";

/// Returns the page of the playground with the scene description, the range of frequencies and the best friction ratio
/// of the report.
pub fn start(page: &str, text: &str, asked: &ReportRequest, best: Option<f64>) -> String {
    let [from, to] = [asked.band.from, asked.band.to];
    play::with(
        page,
        &json!({ "text": text, "from": from, "to": to, "beta": best }),
    )
}

/// Returns the section with the playground in a frame.
pub fn html(page: &str) -> Markup {
    html! {
        section #live {
            h2 { "Change the numbers" }
            p {
                "This frame has its own solver. Move a slider, or edit the description: the pictures follow. "
                "The sections above keep the numbers of the description as given."
            }
            iframe title="Playground with this scene" srcdoc=(page) {}
        }
    }
}
