//! Tests the page of `frictiongen report`. It must be well-formed, must not execute any part of a name, and must show
//! the library's numbers.
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    reason = "a test may fail"
)]

use crate::common::{BLOCK, FRAME, failure, json, output};
use frictiongen::System;
use frictiongen::study::optimum::{FrequencyBand, OptimumRequest};
use frictiongen::study::response::MotionQuantity;
use frictiongen::{Of, Regime};
use serde_json::Value;

/// HTML elements without an end tag.
const VOID: [&str; 3] = ["meta", "br", "input"];

/// Creates a page, and checks its elements, its quoted attributes and its data. Returns the text and the data.
pub fn page(input: &str, arguments: &[&str]) -> (String, Value) {
    let arguments = [&["report"], arguments].concat();
    let page = output(input, &arguments);
    let mut rest = page.strip_prefix("<!DOCTYPE html>").unwrap();
    let mut open: Vec<String> = Vec::new();
    let mut scripts = 0;
    while let Some(at) = rest.find('<') {
        assert!(
            !rest[..at].contains('>'),
            "a bracket in a text: {}",
            &rest[..at]
        );
        rest = &rest[at + 1..];
        let end = tag_end(rest);
        let (tag, after) = (&rest[..end], &rest[end + 1..]);
        rest = after;
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop().as_deref(), Some(name));
            continue;
        }
        let name = tag.split([' ', '\n', '/']).next().unwrap();
        assert!(name.chars().all(|c| c.is_ascii_alphanumeric()), "<{tag}>");
        if tag.ends_with('/') || VOID.contains(&name) {
            continue;
        }
        if name == "script" || name == "style" {
            scripts += usize::from(name == "script");
            let close = rest.find(&format!("</{name}>")).unwrap();
            rest = &rest[close + name.len() + 3..];
            continue;
        }
        // Only the handlers of the page's script may run, so no attribute may contain one.
        assert!(!tag.contains(" on"), "<{tag}>");
        open.push(name.to_owned());
    }
    assert!(open.is_empty(), "{open:?}");
    assert_eq!(scripts, 2);
    let (_, data) = page.split_once("type=\"application/json\">").unwrap();
    let (data, _) = data.split_once("</script>").unwrap();
    let data = json(data);
    assert_eq!(data["version"], 1);
    (page, data)
}

/// Returns the position of the end of a tag. A `>` within quotes does not end the tag.
fn tag_end(text: &str) -> usize {
    let mut quoted = false;
    text.find(|c| {
        quoted ^= c == '"';
        c == '>' && !quoted
    })
    .unwrap()
}

#[test]
fn the_numbers_are_the_librarys() {
    let arguments = ["--r", "0.5:2", "--beta", "0.2,0.6", "--of", "block"];
    let (text, data) = page(BLOCK, &arguments);
    let system: System = BLOCK.parse().unwrap();
    let (mut compared, mut regimes) = (0, Vec::new());
    for point in data["limits"]["points"].as_array().unwrap() {
        let limits = system.at(point["r"].as_f64().unwrap()).unwrap().limits();
        assert_eq!(point["continuous_limit"], limits.continuous);
        assert_eq!(point["sliding_limit"], limits.sliding);
        compared += 2;
    }
    for level in data["responses"].as_array().unwrap() {
        let Some(beta) = level["beta"].as_f64() else {
            assert_eq!(level["name"], "contact stuck");
            continue;
        };
        for point in level["points"].as_array().unwrap() {
            let at = system.at(point["r"].as_f64().unwrap()).unwrap();
            match at.response(beta) {
                Ok(response) => {
                    let swing = response.swing(Of::Mass(0)).unwrap();
                    assert_eq!(point["block"]["amplitude"], swing.amplitude);
                    regimes.push(response.regime());
                    compared += 1;
                }
                Err(_) => assert!(point["block"]["none"].is_string(), "{point}"),
            }
        }
    }
    // The lines of a picture must be correct to a thousandth.
    let plot = |id: &str| {
        let plots = data["plots"].as_array().unwrap();
        plots.iter().find(|plot| plot["id"] == id).unwrap()["panels"][0].clone()
    };
    for series in plot("response-block")["series"].as_array().unwrap() {
        let Some(beta) = series["name"].as_str().unwrap().strip_prefix("β = ") else {
            continue;
        };
        let beta: f64 = beta.parse().unwrap();
        for run in series["runs"].as_array().unwrap() {
            let (x, y) = (run["x"].as_array().unwrap(), run["y"].as_array().unwrap());
            for (x, y) in x.iter().zip(y).skip(1).step_by(5) {
                let (r, y) = (x.as_f64().unwrap(), y.as_f64().unwrap());
                let Ok(response) = system.at(r).unwrap().response(beta) else {
                    continue;
                };
                let exact = response.swing(Of::Mass(0)).unwrap().amplitude;
                // Next to a pole or a bound, a change of the sixth digit of r changes the amplitude by more than the
                // tolerance. The test leaves out points next to a pole or a bound.
                if !(0.99..=1.01).contains(&r) && 0.05 < exact {
                    assert!((y - exact).abs() <= 2e-3 * exact, "{beta} {r}: {y} {exact}");
                    compared += 1;
                }
            }
        }
    }
    let request = OptimumRequest {
        of: Of::Mass(0),
        size: MotionQuantity::Displacement,
        band: FrequencyBand::Ratio(0.5, 2.0),
        load: None,
    };
    let optimum = system.optimum(&request).unwrap();
    assert_eq!(data["best"][0]["beta"], optimum.beta);
    assert_eq!(data["best"][0]["amplitude"], optimum.amplitude);
    assert!(150 < compared, "{compared}");
    assert!(regimes.contains(&Regime::Continuous) && regimes.contains(&Regime::StickSlip));
    for words in ["No load is given", "threshold", "limit of sliding"] {
        assert!(text.contains(words), "{words}");
    }
    println!("{compared} numbers compared");
}

/// Checks that the features are the lines of `frictiongen features --json` without their derivatives.
#[test]
fn features_are_those_of_the_command() {
    let undamped = [
        "--r", "0.62:2", "--beta", "0.2,0.4", "--of", "m1", "--of", "contact",
    ];
    let damped = [
        "--hz",
        "1:7",
        "--base",
        "0.001",
        "--friction",
        "0.4",
        "--of",
        "lower",
    ];
    let two = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/thesis/two_m2.friction");
    let mut compared = 0;
    for (file, arguments, told) in [
        (
            two,
            &undamped[..],
            &[
                "Invariant points",
                "Where friction makes it worse",
                "two frictions",
                "bounded from",
            ][..],
        ),
        (
            FRAME,
            &damped[..],
            &[
                "threshold without damping",
                "Peaks with 0.4 N",
                "no invariant points",
                "4.412 Hz",
            ][..],
        ),
    ] {
        let (text, data) = page("", &[&[file], arguments].concat());
        let lines = data["features"]["lines"].as_array().unwrap().clone();
        let command = [&["features", file], arguments, &["--json"]].concat();
        let own = json(&output("", &command));
        let own = own["points"].as_array().unwrap();
        assert_eq!(lines.len(), own.len(), "{file}");
        for (line, own) in lines.iter().zip(own) {
            for (name, value) in line.as_object().unwrap() {
                if !["per_cent_for_one", "parameter"].contains(&name.as_str()) {
                    assert_eq!(value, &own[name], "{name}");
                    compared += 1;
                }
            }
        }
        for words in told {
            assert!(text.contains(words), "{file}: {words}");
        }
        // The pictures of the curves must mark the features.
        let mark = if file == two {
            "invariant point"
        } else {
            "peak"
        };
        assert!(text.matches(mark).count() > 1, "{mark}");
    }
    println!("{compared} fields compared");
    assert!(300 < compared, "{compared}");
}

/// Returns a chain of `count` masses whose last mass rubs.
fn chain(count: usize) -> String {
    let masses: Vec<String> = (1..=count).map(|i| format!("m{i}: 1")).collect();
    let springs: Vec<String> = (2..=count)
        .map(|i| format!("m{} - m{i}: 1", i - 1))
        .collect();
    format!(
        "struct Long {{ masses: {{ {} }}, springs: {{ base - m1: 1, {} }}, contact: m{count} - wall, excitation: base,
         damping: modal(0.02) }}",
        masses.join(", "),
        springs.join(", ")
    )
}

/// Checks that the best friction of a longer chain equals that of the library's search, with its bracket.
#[test]
fn the_best_friction_is_the_optimum() {
    let (text, data) = page(&chain(6), &["--r", "0.15:1.2", "--of", "m3"]);
    let best = &data["best"][0];
    assert!(!text.contains("the best of some"));
    let system: System = chain(6).parse().unwrap();
    let optimum = system
        .optimum(&OptimumRequest {
            of: Of::Mass(2),
            size: MotionQuantity::Displacement,
            band: FrequencyBand::Ratio(0.15, 1.2),
            load: None,
        })
        .unwrap();
    assert_eq!(best["beta"], optimum.beta);
    assert_eq!(best["amplitude"], optimum.amplitude);
    assert_eq!(best["bracket"]["from"]["beta"], optimum.bracket[0]);
    assert_eq!(best["stuck_from"]["beta"], optimum.locked);
    // The page has one number for the friction at which the contact sticks over the whole range.
    assert_eq!(data["limits"]["stuck_from"], best["stuck_from"]);
    assert_eq!(
        data["limits"]["nothing_sticks_up_to"],
        best["nothing_sticks_up_to"]
    );
}

#[test]
fn nothing_runs_from_a_name_or_a_comment() {
    let evil = "</script><script>alert(1)</script><img src=x onerror=alert(1)> & \"quoted\"";
    let scene = format!("/// {evil}\n{BLOCK}");
    let folder = std::env::temp_dir().join(format!("frictiongen-report-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let file = folder.join("a<b>&\"onclick=.friction");
    std::fs::write(&file, scene).unwrap();
    let (text, data) = page(
        "",
        &[file.to_str().unwrap(), "--r", "0.5:0.9", "--beta", "0.3"],
    );
    std::fs::remove_dir_all(&folder).unwrap();
    assert!(!text.contains("<img") && !text.contains("<script>alert"));
    assert!(text.contains("&lt;img src=x onerror=alert(1)&gt; &amp;"));
    assert!(
        data["file"]
            .as_str()
            .unwrap()
            .ends_with("a<b>&\"onclick=.friction")
    );
    // Names in a description consist of letters of any alphabet. The longest chain has names with German letters, and
    // one scene has markup in its description.
    let masses: Vec<String> = (1..=64).map(|i| format!("größe_ß{i}: 1")).collect();
    let springs: Vec<String> = (1..=64).map(|i| format!("größe_ß{i} - base: 1")).collect();
    let scene = format!(
        "/// {evil}\nstruct Ünder {{ masses: {{ {} }}, springs: {{ {} }}, contact: größe_ß1 - wall, excitation: größe_ß1 }}",
        masses.join(", "),
        springs.join(", ")
    );
    let (text, data) = page(
        &scene,
        &["--r", "0.5:0.9", "--beta", "3", "--of", "größe_ß1"],
    );
    assert!(text.contains("größe_ß1") && !text.contains("<img"));
    assert_eq!(data["name"], "Ünder");
    let named = BLOCK.replace("block", "<script>alert(1)</script>");
    let lines = failure(&named, &["report"]);
    assert!(
        lines.iter().all(|line| line.starts_with("<stdin>:")),
        "{lines:?}"
    );
}

#[test]
fn scenes_without_an_answer_say_so() {
    let pair = "struct Pair { masses: { a: 1, b: 2 }, springs: { base - a: 1, a - b: 1 },
        contact: a - b, excitation: a, damping: modal[0.05, 0.05] }";
    let rubs_on_base = "struct Rig { masses: { m: 1 }, springs: { base - m: 1 },
        contact: m - base, excitation: base }";
    let (text, data) = page(
        pair,
        &["--force", "1", "--hz", "0.05:0.15", "--beta", "0.1"],
    );
    assert!(text.contains("mm") && data["scene"]["load_m_or_N"] == 1.0);
    let (text, _) = page(rubs_on_base, &["--r", "0.8:1.3", "--beta", "0"]);
    assert!(text.contains("unbounded"));
    let long = chain(64);
    // The friction exceeds every limit, because stick-slip of 64 masses would take long.
    let (text, data) = page(&long, &["--r", "0.01:0.02", "--beta", "1000", "--of", "m1"]);
    assert!(text.contains("A chain of 64 masses is not drawn"));
    assert_eq!(data["modes"].as_array().unwrap().len(), 64);
    assert!(data["best"]["none"].is_string() && data["features"]["none"].is_string());
    assert!(text.contains("The page does not list the features of more than 16 masses"));
}

#[test]
fn bad_options_are_refused() {
    for (arguments, told) in [
        (&["--r", "2:1"][..], "write 1:2"),
        (&["--r", "0.5:0.1:2"], "without a step"),
        (&["--friction", "1"], "give --force"),
        (&["--base", "1"], "--force"),
        (&["--force", "NaN"], "--force"),
        (&["--of", "nobody"], "nobody"),
        (&["--beta", "0.1:0.1:0.9"], "up to 6 frictions"),
        (&["-o", "/nowhere/at/all.html"], "no such file or folder"),
    ] {
        let lines = failure(BLOCK, &[&["report"], arguments].concat());
        assert!(
            lines.len() == 1 && lines[0].contains(told),
            "{arguments:?}: {lines:?}"
        );
    }
    assert!(failure("struct", &["report"])[0].starts_with("<stdin>:1"));
}

/// A block with two elastic contacts and a dashpot.
const PAIR: &str = "/// A block on two dampers.
struct Pair {
    masses: { block: 1.0 }, springs: { base - block: 100.0 },
    contacts: { brace: base - block { stiffness: 200.0 }, pads: block - wall { share: 0.6, stiffness: 100.0 } },
    dampers: { block - wall: 0.4 }, damping: modal(0.01), excitation: block,
}";

/// Checks the page of a scene with several contacts: its sections, the friction from which no contact slides against its
/// formula, and amplitudes against `orbit`.
#[test]
fn several_contacts_have_a_page() {
    let page = output(PAIR, &["report", "--r", "0.6:1.9"]);
    for text in [
        "<!DOCTYPE html>",
        "A block on two dampers.",
        "<caption>Contacts</caption>",
        "<caption>Dashpots</caption>",
        "id=\"closed\"",
        "all contacts stuck",
        "id=\"map\"",
        "brace: hysteresis loop, area = energy",
        "pads: hysteresis loop, area = energy",
        "The first contact that slides",
        "Damped modes",
        "<th scope=\"row\">brace + pads stuck</th>",
        "2 contacts and 1 mass, from r = 0.6 to r = 1.9.",
    ] {
        assert!(page.contains(text), "{text}: {page}");
    }
    assert!(!page.contains("NaN"));
    // The page has data, and no script that a browser would run.
    assert_eq!(page.matches("<script").count(), 1);
    let (_, data) = page.split_once("type=\"application/json\">").unwrap();
    let data = json(data.split_once("</script>").unwrap().0);
    let number = |value: &Value| value.as_f64().unwrap();
    let stuck = data["stuck"].as_array().unwrap();
    assert_eq!(stuck.len(), 401);
    for at in stuck {
        // Dashpot and modal damping add up to 0.6 N s/m. With r, the angular frequency is 10 r.
        let r = number(&at["r"]);
        let limit = 200.0 / f64::hypot(400.0 - 100.0 * r * r, 6.0 * r);
        let found = number(&at["stuck_from_beta"]);
        assert!((found / limit - 1.0).abs() < 1e-12, "{r}: {found} {limit}");
        assert_eq!(at["slides_first"], "brace");
    }
    let points = data["points"].as_array().unwrap();
    assert_eq!(points.len(), 3 * 40);
    let point = &points[60];
    let [r, beta] = ["r", "beta"].map(|name| point[name].to_string());
    let csv = output(PAIR, &["orbit", "--r", &r, "--beta", &beta, "--csv"]);
    for (name, cell) in [
        ("block.amplitude", &point["amplitude"]["block"]),
        ("pads.stuck_fraction", &point["stuck_fraction"]["pads"]),
    ] {
        let expected = crate::common::column(&csv, name)[0];
        assert!(
            (number(cell) - expected).abs() < 1e-12,
            "{name}: {cell} {expected}"
        );
    }
    let told = failure(PAIR, &["report", "--r", "0.6:0.1:1.9"]);
    assert!(told[0].contains("without a step"), "{told:?}");
    let free = "struct Free { masses: { a: 1, b: 1 }, contacts: { c: a - b }, excitation: a }";
    let told = failure(free, &["report", "--force", "1"]);
    assert!(told[0].contains("has no resonance"), "{told:?}");
}
