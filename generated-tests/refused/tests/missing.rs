//! A method that the scene does not provide is told with the field that it is short of, and no error of its
//! own follows.  After a change: `TRYBUILD=overwrite cargo test -p refused-scenes --test missing`.

#[test]
fn what_is_not_provided_says_where_to_add_it() {
    trybuild::TestCases::new().compile_fail("tests/missing/*.rs");
    let told = std::fs::read_to_string("tests/missing/methods.stderr").expect("the record");
    for (item, count) in [
        ("motion", 1),
        ("orbit", 2),
        ("simulation", 2),
        ("stepper", 2),
        ("limits", 1),
    ] {
        let label = format!("add `{item}` to the scene's `provide: [...]`");
        assert_eq!(told.matches(&label).count(), count, "{item}");
    }
    for name in ["AddStuckToProvide", "AddMassToMotion"] {
        assert!(told.contains(name), "{name}");
    }
    // One error for each call, and none of its own after it.
    let errors = told.lines().filter(|line| line.starts_with("error"));
    assert_eq!(errors.count(), 10, "{told}");
}
