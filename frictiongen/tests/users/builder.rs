//! A builder reports all errors of a description together, and needs no type annotation.

use frictiongen::System;
use frictiongen::study::{InvalidScene, StudyError, scene::Damping};

fn lines(error: &InvalidScene) -> Vec<String> {
    error.to_string().lines().map(str::to_owned).collect()
}

/// An unknown node and a missing contact do not hide a negative mass.
#[test]
fn everything_that_is_wrong() {
    let error = System::builder()
        .mass("a", -1.0)
        .mass("a", 2.0)
        .mass("time", 1.0)
        .spring("base", "a", 1.0)
        .spring("a", "roof", -3.0)
        .spring("a", "time", 0.0)
        .excitation("wall")
        .damping(Damping::Uniform(-0.1))
        .stiction(0.5)
        .build()
        .expect_err("much is wrong");
    let told = lines(&error);
    println!("{error}");
    let parts = [
        "the spring `a - roof` names `roof`",
        "there is no contact",
        "the excitation names `wall`",
        "the mass `a` is -1.0",
        "two masses are called `a`",
        "`time` already means something else",
        "the spring `a - time` has the stiffness 0.0",
        "negative damping",
        "the stiction",
    ];
    for part in parts {
        let count = told.iter().filter(|line| line.contains(part)).count();
        assert_eq!(count, 1, "{part}: {told:#?}");
    }
    assert_eq!(told.len(), parts.len(), "{told:#?}");
}

/// One cause gives one error: a mass is not reported as loose if its spring could not be read.
#[test]
fn no_second_error_of_one_cause() {
    let scene = || {
        System::builder()
            .mass("a", 1.0)
            .mass("b", 1.0)
            .spring("base", "a", 1.0)
    };
    let cases = [
        scene()
            .spring("a", "c", 1.0)
            .contact("b", "wall")
            .excitation("a"),
        scene()
            .spring("a", "b", 1.0)
            .contact("c", "wall")
            .excitation("a"),
        scene()
            .spring("a", "b", 1.0)
            .contact("b", "wall")
            .excitation("c"),
        scene().spring("a", "b", 1.0).excitation("a"),
        scene().spring("a", "b", 1.0).contact("b", "wall"),
    ];
    for case in cases {
        let error = case.build().expect_err("one thing is wrong");
        assert_eq!(lines(&error).len(), 1, "{error}");
        assert!(error.errors.is_empty() && error.unknown.len() == 1);
    }
}

fn block() -> frictiongen::study::Builder {
    let builder = System::builder().mass("block", 1.0);
    let builder = builder.spring("base", "block", 1.0);
    builder.contact("block", "wall").excitation("block")
}

/// The next call follows `build` without a type annotation, and must not fail with E0283.
#[test]
fn a_call_may_follow_at_once() -> Result<(), StudyError> {
    let limit = block().build()?.at(0.9)?.continuous_limit();
    let single = block().build_in::<f32>()?.at(0.9)?.continuous_limit();
    assert!((limit - f64::from(single)).abs() < 1e-6);
    Ok(())
}
