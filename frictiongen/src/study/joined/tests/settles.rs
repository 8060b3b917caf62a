//! Tests steady states that rounding could hide. The force of an elastic contact is at its limit while a rigid contact
//! holds its sides together, or a part of the chain without damping could vibrate for ever beyond a contact that sticks.

use super::system;

/// Scenes of a random search, each with r and β.
const SCENES: [(&str, f64, f64); 6] = [
    (
        "struct S { masses: { m0: 1.126 }, springs: { base - m0: 0.717, m0 - wall: 1.976 }, contacts: {
        c0: base - m0 { share: 0.204, stiction: 1.095, stiffness: 3.465 },
        c1: base - m0 { share: 0.806, stiffness: 3.567 }, c2: base - m0 { share: 0.634, stiction: 1.250 } },
        excitation: base, damping: modal(0.0212) }",
        0.3677235017547254,
        1.6221140750867602,
    ),
    (
        "struct S { masses: { m0: 1.425, m1: 0.378 }, springs: { base - m0: 0.426, m0 - m1: 1.011, m1 - wall: 0.474 },
        contacts: { c0: m0 - wall { share: 0.771 }, c1: base - m1 { share: 0.233, stiffness: 2.990 },
        c2: m1 - wall { share: 0.564, stiffness: 1.178 }, c3: base - m1 { share: 0.445, stiction: 1.727 } },
        excitation: base, damping: rayleigh(0.0021, 0.0194) }",
        0.20282581750044731,
        4.573100064099574,
    ),
    (
        "struct S { masses: { m0: 2.183, m1: 1.588, m2: 0.343 },
        springs: { base - m0: 0.336, m0 - m1: 1.563, m1 - m2: 1.331 },
        contacts: { c0: m0 - m1 { share: 0.370, stiction: 1.251 }, c1: base - m1 { share: 0.473, stiffness: 4.802 },
        c2: m0 - wall { share: 0.570, stiction: 1.171 },
        c3: m2 - wall { share: 0.406, stiction: 1.769, stiffness: 2.343 } },
        excitation: m1, damping: rayleigh(0.0121, 0.0146) }",
        0.23121467623729355,
        0.8977972681348817,
    ),
    (
        "struct S { masses: { m0: 1.579, m1: 0.589, m2: 2.606, m3: 0.378 },
        springs: { base - m0: 1.628, m0 - m1: 0.838, m1 - m2: 0.685, m2 - m3: 1.293 },
        contacts: { c0: m0 - m1 { share: 0.324, stiction: 1.809 }, c1: m1 - wall { share: 0.751, stiffness: 1.514 },
        c2: m0 - wall { share: 0.345 }, c3: m2 - m3 { share: 0.259, stiffness: 15.140 } },
        excitation: base, damping: rayleigh(0.0395, 0.0097) }",
        0.2538663851717231,
        0.5222563523764179,
    ),
    (
        "struct S { masses: { m0: 0.392, m1: 0.403, m2: 1.444, m3: 0.590 },
        springs: { base - m0: 0.359, m0 - m1: 2.757, m1 - m2: 0.479, m2 - m3: 0.793 },
        contacts: { c0: m0 - m2 { share: 0.337 }, c1: base - m0 { share: 0.397, stiction: 1.626, stiffness: 2.965 },
        c2: m2 - wall { share: 0.423 } }, excitation: base }",
        2.8459047805788646,
        2.9719991233258853,
    ),
    (
        // A contact has an event at the start of each period, where the base turns.
        "struct S { masses: { m0: 0.648, m1: 0.326, m2: 0.579 },
        springs: { base - m0: 1.571, m0 - m1: 1.238, m1 - m2: 2.778 },
        contacts: { c0: m1 - m2 { share: 0.491, stiction: 1.651 }, c1: base - m0 { share: 0.215, stiction: 1.842 },
        c2: m0 - wall { share: 0.451, stiffness: 0.757 }, c3: base - m2 { share: 0.942 } },
        excitation: base, damping: modal(0.0024) }",
        0.8156021176790658,
        0.9227316134245567,
    ),
];

/// Checks that the steady state is the motion from rest after 600 cycles, in the largest displacements of a period.
#[test]
fn motions_that_settle_have_a_steady_state() {
    for (text, r, beta) in SCENES {
        let scene = system(text);
        let joined = scene.joined().expect("answers");
        let at = joined.at(r).expect("r");
        assert!(at.orbit(beta).is_ok(), "r {r}");
        // A contact that never slides stays where the motion has left it.
        let rest = vec![0.0; scene.scene().masses.len()];
        let orbit = at.orbit_from(beta, (&rest, &rest)).expect("a steady state");
        let mut run = at.simulation(beta).expect("a motion");
        let period = orbit.period() as u32;
        let history = run
            .history(600 / period * period, period, 64)
            .expect("a motion");
        let (x, v) = &history.states[0];
        let (expected, speeds) = orbit.state();
        let size = orbit.amplitudes().into_iter().fold(0.0, f64::max);
        for (got, want) in x.iter().chain(v).zip(expected.iter().chain(&speeds)) {
            assert!((got - want).abs() < 1e-8 * size, "r {r}: {got} {want}");
        }
        assert!(
            history
                .states
                .iter()
                .flat_map(|(x, _)| x)
                .all(|x| x.abs() <= size * (1.0 + 1e-9))
        );
    }
}

/// Scenes of one contact with r, β, period and stops, and the largest displacement in the contact. Another program has
/// followed the motion from rest for hundreds of cycles. On its way the motion passes a stable state of period one.
const PASSING: [(&str, f64, f64, usize, usize, f64); 5] = [
    (
        "struct S { masses: { m1: 1.0, m2: 0.04833 }, springs: { base - m1: 1.0, m1 - m2: 0.1056 }, contact: m1 - m2,
        excitation: base, damping: modal[0.0226, 0.001027], stiction: 3.0 }",
        0.3224,
        0.0008548,
        9,
        26,
        0.066_024_041_387_894_53,
    ),
    (
        "struct S { masses: { m1: 1.0, m2: 1.449 }, springs: { base - m1: 1.0, m1 - m2: 1.385 }, contact: m1 - wall,
        excitation: m1, stiction: 1.2 }",
        0.05155,
        0.1325,
        11,
        50,
        0.908_065_395_229_539_7,
    ),
    (
        "struct S { masses: { m1: 1.0, m2: 1.174 }, springs: { base - m1: 1.0, m1 - m2: 0.7833 }, contact: m1 - base,
        excitation: base, stiction: 1.2 }",
        0.1578,
        0.02786,
        15,
        40,
        0.040_604_315_548_365_02,
    ),
    (
        "struct S { masses: { m1: 1.0, m2: 0.0347 }, springs: { base - m1: 1.0, m1 - m2: 0.8789 }, contact: m2 - base,
        excitation: base, stiction: 1.2 }",
        0.1523,
        0.0005175,
        14,
        63,
        0.025_485_090_642_927_7,
    ),
    (
        "struct S { masses: { m1: 1.0, m2: 0.153811 }, springs: { base - m1: 1.0, m1 - m2: 2.92858 },
        contact: m1 - m2, excitation: m1, damping: modal[0.001131, 0.04421], stiction: 2.0 }",
        0.22565,
        0.00208766,
        1,
        6,
        0.002_525_629_989_206_718,
    ),
];

#[test]
fn a_motion_that_passes_a_stable_state_goes_on_to_its_own() {
    for (text, r, beta, period, stops, displacement) in PASSING {
        let scene = system(text);
        let at = scene.joined().expect("answers").at(r).expect("r");
        let orbit = at.orbit(beta).expect("a state");
        let contact = orbit.contacts().next().expect("a contact");
        assert_eq!((orbit.period(), contact.stops()), (period, stops), "r {r}");
        let error = (contact.displacement() - displacement).abs() / displacement;
        assert!(error < 1e-9, "r {r}: {error:e}");
        assert!(orbit.is_from_rest() && orbit.cycles_followed().is_none());
    }
}

/// Checks motions that wander for ever. The answer is a stable state that they have come close to, the state in which the
/// contact sticks, or the last 64 cycles.
#[test]
fn a_motion_that_wanders_has_another_answer() {
    let beside = system(
        "struct S { masses: { m1: 1.1224, m2: 0.5747, m3: 0.3675 },
        springs: { base - m1: 0.6325, m1 - m2: 0.4211, m2 - m3: 0.9743 }, contact: m2 - base, excitation: base,
        damping: modal[0.01507, 0.03030, 0.00682], stiction: 2.4722 }",
    );
    let held = system(
        "struct S { masses: { m1: 0.5038, m2: 0.3744 }, springs: { base - m1: 1.9422, m1 - m2: 0.5469 },
        contact: m2 - m1, excitation: m2, damping: rayleigh(0.0097, 0.0042), stiction: 2.6695 }",
    );
    let block = system(
        "struct S { masses: { block: 1 }, springs: { base - block: 1 }, contact: block - base, excitation: base,
        stiction: 3 }",
    );
    // The amplitudes of the first two are those of the program for a single contact.
    let asked = [
        (
            &beside,
            1.640_406_166_765_868,
            0.428_810_363_435_653_65,
            Some(0.686_795_557_251_6),
        ),
        (
            &held,
            0.212_731_920_642_770_4,
            0.494_356_720_780_849_1,
            Some(0.0),
        ),
        (&block, 1.0 / 3.0, 0.01395, None),
    ];
    for (scene, r, beta, displacement) in asked {
        let at = scene.joined().expect("answers").at(r).expect("r");
        let orbit = at.orbit_or_last_cycles(beta, None).expect("cycles");
        let followed = orbit.cycles_followed();
        assert!(followed > Some(4000), "r {r}: {followed:?}");
        assert!(!orbit.is_from_rest());
        assert!(orbit.period() == 1 || !orbit.is_settled(), "r {r}");
        assert_eq!(orbit.is_settled(), displacement.is_some(), "r {r}");
        assert_eq!(at.orbit(beta).is_ok(), displacement.is_some(), "r {r}");
        let contact = orbit.contacts().next().expect("a contact");
        match displacement {
            Some(expected) => assert!((contact.displacement() - expected).abs() < 1e-9, "r {r}"),
            None => assert!(orbit.period() == 64 && orbit.amplitudes()[0] > 1.0),
        }
    }
}

/// Checks a motion whose period starts at an event: the contact of the mass with the wall stops as the base turns back.
/// Contacts that never slide are in the middle of their intervals, and a pair of stops is counted.
#[test]
fn an_event_at_the_start_of_the_period_counts_once() {
    let scene = system(
        "struct S { masses: { m: 0.639 }, springs: { base - m: 2.296, m - wall: 0.398 }, excitation: base,
        damping: modal(0.0077), contacts: { a: m - wall { share: 0.486, stiction: 1.856, stiffness: 7.654 },
        b: base - m { share: 0.217 }, c: base - m { share: 0.389, stiction: 1.931, stiffness: 2.499 },
        d: base - m { share: 0.894, stiffness: 1.326 } } }",
    );
    let joined = scene.joined().expect("answers");
    let at = joined.at(0.323_693_488_555_970_6).expect("r");
    let orbit = at.orbit(0.165_142_260_584_432_07).expect("a state");
    assert!(orbit.is_symmetric().expect("a motion"));
    let counts: Vec<_> = orbit
        .contacts()
        .map(|own| (own.stops(), own.slip() > 0.0))
        .collect();
    assert_eq!(counts, [(2, true), (4, true), (0, false), (0, false)]);
    assert!((orbit.amplitudes()[0] - 0.955_692_619_116_388).abs() < 1e-12);
}
