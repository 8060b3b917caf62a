//! Compares steady states that start from a neighbouring one with those from rest.

use super::{FRAME, apart, system};
use crate::study::joined::JoinedOrbit;

/// Checks that the neighbour has no influence on the result: from contacts without friction to contacts that never
/// slide, in both directions, over friction and over frequency.
#[test]
fn a_neighbour_changes_no_answer() {
    let single = FRAME.replace(", stiction: 1.2", "");
    let rigid = single.replace("stiffness: 4.0e3", "");
    for text in [single, rigid] {
        let frame = system(&text);
        let joined = frame.joined().expect("answers");
        let mut near: Option<JoinedOrbit<'_>> = None;
        for r in [0.4, 0.6, 1.0, 1.4, 0.3] {
            let at = joined.at(r).expect("r");
            for beta in [0.0, 0.1, 0.3, 2.0, 0.8, 0.3, 5.0, 0.0] {
                let expected = at.orbit(beta).expect("a state");
                if let Some(near) = &near {
                    let orbit = at.orbit_near(beta, near).expect("a state");
                    assert_eq!(orbit.regime(), expected.regime(), "r {r}, beta {beta}");
                    let pairs = orbit.contacts().zip(expected.contacts());
                    for (got, want) in pairs {
                        assert_eq!((got.stops(), got.regime()), (want.stops(), want.regime()));
                    }
                    let amplitudes = orbit.amplitudes().into_iter();
                    for (got, want) in amplitudes.zip(expected.amplitudes()) {
                        assert!(apart(got, want) < 1e-10, "r {r}, beta {beta}: {got} {want}");
                    }
                }
                near = Some(expected);
            }
        }
    }
}
