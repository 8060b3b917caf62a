//! Requests for a history that must fail.

use crate::scenes::{BLOCK, FRAME, system};
use frictiongen::study::history::{HistoryError, HistoryRequest, MOST_SAMPLES};
use frictiongen::{Error, NoOrbit, Of};

#[test]
fn requests() {
    let system = system(FRAME);
    let sound = HistoryRequest::new(&[Of::Contact]);
    let ask = |request: &HistoryRequest| system.history(0.5, 0.5, request).err();
    assert_eq!(ask(&sound), None);
    let cycles = |cycles| HistoryRequest {
        cycles,
        ..sound.clone()
    };
    assert_eq!(ask(&cycles(0)), Some(HistoryError::NoCycle));
    assert_eq!(ask(&cycles(u32::MAX)), Some(HistoryError::TooManySamples));
    for samples in [0, 1, 3, 201] {
        let request = HistoryRequest {
            samples,
            ..sound.clone()
        };
        assert_eq!(ask(&request), Some(HistoryError::Samples));
    }
    let skip = HistoryRequest {
        skip: MOST_SAMPLES + 1,
        ..sound.clone()
    };
    assert_eq!(ask(&skip), Some(HistoryError::TooManySkipped));
    let mass = HistoryRequest {
        of: vec![Of::Mass(1), Of::Mass(2)],
        ..sound.clone()
    };
    assert_eq!(ask(&mass), Some(HistoryError::NoSuchMotion(Of::Mass(2))));
    // The limit counts the samples of both motions together.
    let two = HistoryRequest {
        of: vec![Of::Mass(1), Of::Mass(0)],
        cycles: 3000,
        samples: 2000,
        ..sound.clone()
    };
    assert_eq!(ask(&two), Some(HistoryError::TooManySamples));
    for state in [
        (vec![0.0], vec![0.0, 0.0]),
        (vec![0.0, 0.0], vec![0.0, 0.0, 0.0]),
        (vec![0.0, f64::NAN], vec![0.0, 0.0]),
        (vec![0.0, 0.0], vec![f64::INFINITY, 0.0]),
    ] {
        let request = HistoryRequest {
            from: Some(state),
            ..sound.clone()
        };
        let error = ask(&request).expect("an error").to_string();
        assert!(
            error.starts_with("the state must have one finite displacement"),
            "{error}"
        );
    }
    for (r, beta, ratio) in [
        (0.0, 0.5, "frequency ratio r"),
        (f64::INFINITY, 0.5, "frequency ratio r"),
        (-1.0, 0.5, "frequency ratio r"),
        (f64::NAN, 0.5, "frequency ratio r"),
        (0.5, -0.1, "friction ratio beta"),
        (0.5, f64::NAN, "friction ratio beta"),
    ] {
        let error = system.history(r, beta, &sound).expect_err("an error");
        assert!(
            error.to_string().starts_with(&format!("the {ratio} is ")),
            "{error}"
        );
    }
}

#[test]
fn steady_states() {
    let block = system(BLOCK);
    for r in [0.0, f64::INFINITY] {
        for beta in [0.3, 2.0] {
            let Ok(response) = block.at(r).unwrap().response(beta) else {
                continue;
            };
            let error = response.history(&[Of::Contact], 20).expect_err("no cycle");
            assert!(
                error.to_string().starts_with("the frequency ratio r is "),
                "{error}"
            );
        }
    }
    let response = block.at(0.5).unwrap().response(0.3).unwrap();
    assert_eq!(
        response.history(&[Of::Mass(1)], 20),
        Err(HistoryError::NoSuchMotion(Of::Mass(1)))
    );
    assert_eq!(response.history(&[], 21), Err(HistoryError::Samples));
    let restless = system(
        "struct Block { masses: { block: 1 }, springs: { base - block: 1 }, contact: block - base,
         excitation: base, stiction: 3 }",
    );
    let response = restless.at(1.0 / 3.0).unwrap().response(0.01395).unwrap();
    let error = response.history(&[Of::Contact], 20);
    assert_eq!(
        error,
        Err(HistoryError::Solver(Error::NoOrbit(NoOrbit::Unsettled)))
    );
}
