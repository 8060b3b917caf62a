//! Units that are wrong by a power of 1000, and motions that belong to another scene.

use crate::force::seen;
use crate::made::rig;
use frictiongen::measure::{IdentifyRequest, MeasureError, Unknown, Using, Verdict};

/// An amplitude that is 1000 times too small belongs to a contact that is all but stuck, or its unit is wrong. The
/// verdict reports this doubt and does not decide. An ordinary amplitude is identified without doubt, and so is a small
/// one with its phase.
#[test]
fn amplitudes_in_a_doubtful_unit() {
    let system = rig("");
    let request = IdentifyRequest {
        using: Using::Amplitude,
        ..IdentifyRequest::default()
    };
    let (mut doubted, mut believed) = (0, 0);
    for r in [0.7, 1.3, 1.7, 2.3] {
        for beta in [0.05, 0.2, 0.4, 0.6] {
            let good = seen(&system, r, beta, &[0], 1e-4);
            for factor in [1e-3, 1e-6] {
                let mut small = good.clone();
                small.motions[0].value *= factor;
                small.motions[0].deviation *= factor;
                let verdict = system.identify(&[small], &request).unwrap().verdict;
                assert_eq!(verdict, Verdict::AlmostStuck, "{r} {beta} {factor}");
                doubted += 1;
            }
            let verdict = system.identify(&[good], &request).unwrap().verdict;
            assert!(!matches!(verdict, Verdict::AlmostStuck), "{r} {beta}");
            believed += 1;
        }
    }
    assert_eq!((doubted, believed), (32, 16));
    // The contact is all but stuck, and its phase confirms it.
    let close = seen(&system, 1.3, 0.999, &[0], 1e-6);
    let found = system.identify(&[close], &IdentifyRequest::default());
    assert_ne!(found.unwrap().verdict, Verdict::AlmostStuck);
}

/// Units wrong by 1000, of the base and of the mass, and a motion of another scene.
#[test]
fn wrong_units_and_other_motions() {
    let system = rig("");
    let good = seen(&system, 1.3, 0.4, &[0], 1e-4);
    let scaled = |factor: f64, r: f64| {
        let mut seen = good.clone();
        seen.motions[0].value *= factor;
        seen.motions[0].deviation *= factor;
        seen.hertz *= r;
        seen
    };
    for using in [Using::Complex, Using::Amplitude, Using::Phase] {
        let request = IdentifyRequest {
            using,
            ..IdentifyRequest::default()
        };
        // With an amplitude alone a small value is only doubted, which the previous test checks.
        let factors: &[f64] = if using == Using::Amplitude {
            &[1e3]
        } else {
            &[1e3, 1e-3, 1e-6]
        };
        for factor in factors.iter().copied() {
            let error = system
                .identify(&[scaled(factor, 1.0)], &request)
                .unwrap_err();
            assert!(
                matches!(error, MeasureError::WrongUnit { factor: found, .. } if found == factor),
                "{using:?}: {error}"
            );
        }
    }
    let error = system
        .identify(&[scaled(30.0, 1.0)], &IdentifyRequest::default())
        .unwrap_err();
    assert!(
        matches!(error, MeasureError::NotExplained { .. }),
        "{error}"
    );
    assert!(matches!(
        system.identify(&[], &IdentifyRequest::default()),
        Err(MeasureError::NoObservation)
    ));
    let request = IdentifyRequest {
        unknowns: vec![Unknown::Damping, Unknown::Frequencies],
        ..IdentifyRequest::default()
    };
    let error = system.identify(&[scaled(1.0, 1.0)], &request).unwrap_err();
    assert!(
        matches!(
            error,
            MeasureError::TooFewData {
                data: 2,
                unknowns: 3
            }
        ),
        "{error}"
    );
}
