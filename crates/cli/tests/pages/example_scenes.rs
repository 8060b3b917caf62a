//! Tests the commands in the scene files of the examples.

#![allow(clippy::expect_used, reason = "a test may fail")]

use crate::common::output;

/// The commands in the scene files of the examples run, except those that need a recording.
#[test]
fn scenes_of_the_examples_have_answers() {
    let mut run = 0;
    for name in ["clutches", "robot", "iwan", "storeys"] {
        let root = env!("CARGO_MANIFEST_DIR");
        let path = format!("{root}/../../examples/scenes/{name}.friction");
        let scene = std::fs::read_to_string(path).expect("a scene");
        let commands = scene
            .lines()
            .filter_map(|line| line.strip_prefix("//   frictiongen "));
        for command in commands.filter(|command| !command.contains(" -o ")) {
            let words = command.split_whitespace();
            let words: Vec<&str> = words.filter(|word| !word.ends_with(".friction")).collect();
            let csv = output(&scene, &[words.as_slice(), &["--csv"]].concat());
            assert!(csv.lines().count() > 1, "{command}: {csv}");
            run += 1;
        }
    }
    assert_eq!(run, 4);
}
