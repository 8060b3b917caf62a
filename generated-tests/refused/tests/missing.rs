//! Tests the compiler message for a method that the scene does not provide. The message names the item to add to
//! `provide`. No further error follows. After a change run `TRYBUILD=overwrite cargo test -p refused-scenes --test
//! missing`.

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
        ("self_check", 1),
    ] {
        let label = format!("add `{item}` to the scene's `provide: [...]`");
        assert_eq!(told.matches(&label).count(), count, "{item}");
    }
    for name in ["AddStuckToProvide", "AddMassToMotion"] {
        assert!(told.contains(name), "{name}");
    }
    // Each call gives one error, and no further error follows.
    let errors = told.lines().filter(|line| line.starts_with("error"));
    assert_eq!(errors.count(), 11, "{told}");
}
