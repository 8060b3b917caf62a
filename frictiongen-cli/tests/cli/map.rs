//! Tests pictures of maps. Their legend states which values lie beyond the colour scale.
#![allow(clippy::unwrap_used, reason = "a test may fail")]

use crate::common::{FRAME, output};
use std::path::PathBuf;

/// Returns the text of a drawn map, and the amplitudes of `lower` in mm from the CSV of the same map.
fn drawn(hz: &str, shade: &str) -> (String, Vec<f64>) {
    let grid = [
        "--hz",
        hz,
        "--friction",
        "0.05:0.1:2.05",
        "--base",
        "0.001",
        "--of",
        "lower",
    ];
    let name = format!("map-{}-{shade}.svg", hz.replace(':', "-"));
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let path = path.to_str().unwrap();
    let options = ["--shade", shade, "-o", path];
    output("", &[&["map", FRAME][..], &grid, &options].concat());
    let csv = output("", &[&["map", FRAME, "--csv"][..], &grid].concat());
    let mut lines = csv.lines();
    let names = lines.next().unwrap().split(',');
    let place = names
        .clone()
        .position(|name| name == "lower.amplitude_m")
        .unwrap();
    let cell = |line: &str| line.split(',').nth(place).unwrap().parse::<f64>().ok();
    let sizes = lines.filter_map(cell).map(|metres| 1e3 * metres).collect();
    (std::fs::read_to_string(path).unwrap(), sizes)
}

/// Returns the number after a word in a picture without its tags.
fn after(picture: &str, word: &str) -> Option<f64> {
    let (_, rest) = picture.split_once(word)?;
    let digits = |letter: char| letter.is_ascii_digit() || letter == '.';
    let text: String = rest
        .trim_start()
        .chars()
        .take_while(|c| digits(*c))
        .collect();
    text.parse().ok()
}

/// Checks that next to a resonance the colours end below the largest amplitude. The legend states the value of the last
/// colour and the largest amplitude.
#[test]
fn a_clipped_scale_says_so() {
    let (picture, sizes) = drawn("1:0.05:4", "amplitude");
    let most = sizes.iter().copied().fold(0.0, f64::max);
    let end = after(&picture, "top colour ≥").unwrap();
    let largest = after(&picture, "largest").unwrap();
    // The legend prints four digits.
    assert!((largest / most - 1.0).abs() < 1e-3, "{largest} for {most}");
    assert!(end < 0.7 * most, "{end} of {most}: nothing is clipped");
    let beyond = sizes.iter().filter(|size| end < **size).count();
    assert!(
        0 < beyond && beyond * 10 <= sizes.len(),
        "{beyond} of {}",
        sizes.len()
    );
}

/// Checks that without a resonance the colour scale covers all values, and that the legend has no remark about it.
#[test]
fn a_whole_scale_says_nothing() {
    for (hz, shade) in [("4.6:0.1:5", "amplitude"), ("1:0.05:4", "stuck")] {
        let (picture, _) = drawn(hz, shade);
        assert!(!picture.contains("top colour"), "{hz}, {shade}");
    }
}
