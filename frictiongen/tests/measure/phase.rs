//! Identification from phases alone, for motions whose size was not measured.

use crate::force::{scale, seen};
use crate::made::rig;
use frictiongen::measure::{IdentifyRequest, MeasureError, Using, Verdict};

fn by(using: Using) -> IdentifyRequest {
    IdentifyRequest {
        using,
        ..IdentifyRequest::default()
    }
}

/// The size of the motion, of any order of magnitude, changes neither the force nor its interval. `Using::Phase` also
/// uses the size, and refuses one that is wrong by 10⁴.
#[test]
fn no_size_counts() {
    let system = rig("");
    let truth = 0.4 * scale(&system);
    for deviation in [0.0, 1e-5] {
        let sized = |factor: f64| {
            let mut seen = seen(&system, 1.3, 0.4, &[0], 1e-3);
            seen.load_deviation = deviation;
            seen.motions[0].value *= factor;
            seen.motions[0].deviation *= factor;
            [seen]
        };
        let plain = system.identify(&sized(1.0), &by(Using::Phase)).unwrap();
        for factor in [1.0, 1e-4, 1e4] {
            let found = system
                .identify(&sized(factor), &by(Using::PhaseAlone))
                .unwrap();
            assert_eq!(found.verdict, Verdict::Determined);
            assert!(
                (found.friction.value / truth - 1.0).abs() < 1e-6 && found.friction.holds(truth)
            );
            // The golden-section search ends within 1e-9 of the range.
            for (one, other) in [
                (found.friction.from, plain.friction.from),
                (found.friction.to, plain.friction.to),
            ] {
                assert!((one / other - 1.0).abs() < 1e-6, "{one} {other}");
            }
        }
        assert!(matches!(
            system.identify(&sized(1e4), &by(Using::Phase)),
            Err(MeasureError::WrongUnit { .. } | MeasureError::NotExplained { .. })
        ));
    }
}

#[test]
fn a_phase_with_the_wrong_sign() {
    let system = rig("");
    let mut seen = seen(&system, 1.3, 0.4, &[0], 1e-3);
    seen.motions[0].value = seen.motions[0].value.conj();
    let error = system
        .identify(&[seen], &by(Using::PhaseAlone))
        .unwrap_err();
    assert!(
        matches!(&error, MeasureError::PhaseNotExplained { mass, measured, .. }
            if mass == "plate" && *measured < 0.0),
        "{error}"
    );
    assert!(error.to_string().contains("check the sign of the channel"));
}
