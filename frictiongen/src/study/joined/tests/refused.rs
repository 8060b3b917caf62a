//! Checks that a scene with several contacts rejects requests that have no result, and that the message names the
//! reason.

use super::super::JoinedInput;
use super::{FRAME, system};
use crate::study::scene::JointLaw;
use crate::{System, Unsupported};

/// Checks that methods for a single contact return an error for a scene with several contacts. The error must name the
/// fields `contacts` and `dampers`.
#[test]
fn other_calls_name_the_fields() {
    let frame = system(FRAME);
    let mut told: Vec<String> = Vec::new();
    let mut ask = |answer: Result<(), String>| told.push(answer.expect_err("a refusal"));
    fn text<T, E: std::fmt::Display>(answer: Result<T, E>) -> Result<(), String> {
        answer.map(|_| ()).map_err(|error| error.to_string())
    }
    ask(text(frame.at(0.9)));
    ask(text(frame.limits_without_search(0.9)));
    ask(text(frame.simulation(0.9, 0.3)));
    ask(text(frame.simulation_under(0.9, 0.3, 1.0)));
    ask(text(frame.stepper(1e-3)));
    ask(text(frame.steady_state(0.9, 0.3)));
    ask(text(frame.stuck_limit(0.9)));
    ask(text(frame.stuck_amplitudes(0.9)));
    ask(text(frame.compile(0.2..2.5, 1e-4)));
    ask(text(frame.features(None)));
    let point = crate::study::sensitivity::OperatingPoint::Groups { r: 0.9, beta: 0.3 };
    ask(text(
        frame.response_sensitivities(point, crate::Of::Mass(0)),
    ));
    for told in &told {
        assert!(told.contains("`contacts` or `dampers`"), "{told}");
    }
    assert_eq!(frame.resonance_thresholds(), [None, None]);
    assert_eq!(frame.quasi_static_start(0.1), None);
    assert_eq!(frame.resonant_peak_estimate(0, 0, 0.1), None);
    assert!(frame.high_frequency_limits().0.is_nan());
    assert_eq!(frame.single(), Err(Unsupported::SeveralContacts));
}

#[cfg(feature = "desk")]
#[test]
fn curves_maps_and_histories_name_the_fields() {
    let frame = system(FRAME);
    let of = [crate::Of::Mass(0)];
    let curve = crate::study::curve::CurveRequest::new(0.5, 1.5, &of);
    let told = frame.curve(&curve, 0.3).expect_err("a refusal").to_string();
    assert!(told.contains("`contacts` or `dampers`"), "{told}");
    let map = crate::study::map::MapRequest {
        r: vec![0.9],
        beta: vec![0.3],
        of: of.to_vec(),
    };
    let told = frame
        .map(&map, |_| true)
        .expect_err("a refusal")
        .to_string();
    assert!(told.contains("`contacts` or `dampers`"), "{told}");
    let history = crate::study::history::HistoryRequest::new(&of);
    let told = frame.history(0.9, 0.3, &history).expect_err("a refusal");
    assert!(
        told.to_string().contains("`contacts` or `dampers`"),
        "{told}"
    );
}

/// Checks that a builder creates the same scene as a text, and that it rejects invalid contacts.
#[test]
fn builders_take_contacts_and_dashpots() {
    let builder = || {
        System::builder()
            .name("Frame")
            .mass("lower", 2.0)
            .mass("upper", 1.5)
            .spring("base", "lower", 1500.0)
            .spring("lower", "upper", 1200.0)
            .damping(crate::study::scene::Damping::Uniform(0.01))
            .excitation("base")
    };
    let brace = JointLaw {
        stiffness: Some(4.0e3),
        ..JointLaw::default()
    };
    let pads = JointLaw {
        share: 0.6,
        stiction: 1.2,
        ..JointLaw::default()
    };
    let built = builder()
        .contact_named("brace", "base", "lower", brace)
        .contact_named("pads", "lower", "upper", pads)
        .damper("lower", "upper", 1.5)
        .build()
        .expect("a scene");
    assert_eq!(built.scene().joints, system(FRAME).scene().joints);
    for (stiffness, part) in [
        (f64::NAN, "not a finite number"),
        (f64::INFINITY, "leave `stiffness` out"),
        (0.0, "must be greater than zero"),
    ] {
        let law = JointLaw {
            stiffness: Some(stiffness),
            ..JointLaw::default()
        };
        let error = builder()
            .contact_named("brace", "base", "lower", law)
            .build();
        let told = error.map(|_| ()).expect_err("a refusal").to_string();
        assert!(told.contains(part), "{told}");
    }
    for share in [f64::NAN, f64::INFINITY, -1.0] {
        let law = JointLaw {
            share,
            ..JointLaw::default()
        };
        let error = builder()
            .contact_named("brace", "base", "lower", law)
            .build();
        let told = error.map(|_| ()).expect_err("a refusal").to_string();
        assert!(told.contains("the share of the contact `brace`"), "{told}");
    }
    let both = builder().contact("upper", "wall");
    let both = both.contact_named("brace", "base", "lower", brace).build();
    let told = both.map(|_| ()).expect_err("a refusal").to_string();
    assert!(told.contains("exclude each other"), "{told}");
}

/// Checks the errors for numbers outside their domain.
#[test]
fn bad_numbers_are_refused() {
    let frame = system(FRAME);
    let joined = frame.joined().expect("answers");
    for r in [f64::NAN, 0.0, -1.0, f64::INFINITY] {
        assert!(joined.at(r).is_err(), "{r}");
        assert!(joined.under(r, 1.0).is_err(), "{r}");
        assert!(joined.under(1.0, r).is_err(), "{r}");
    }
    let at = joined.at(0.9).expect("r");
    for beta in [f64::NAN, -0.1, f64::INFINITY] {
        assert!(at.orbit(beta).is_err(), "{beta}");
    }
    assert!(at.orbit_from(0.1, (&[0.0], &[0.0])).is_err());
    assert!(at.orbit_from(0.1, (&[0.0, f64::NAN], &[0.0, 0.0])).is_err());
    assert!(at.simulation(0.1).expect("a motion").advance(-1.0).is_err());
    let mut stepper = joined.stepper(0.01).expect("a step");
    let input = JoinedInput {
        frictions: &[("pads", -1.0)],
        ..JoinedInput::default()
    };
    let told = stepper.advance(input).expect_err("a refusal").to_string();
    assert!(
        told.starts_with("the friction force of the contact `pads` is negative"),
        "{told}"
    );
    let stribeck =
        "struct B { masses: { b: 1 }, springs: { base - b: 1 }, contact: b - wall, excitation: b,
        friction: stribeck(0.1: 0.8), provide: [simulation] }";
    let system = system(stribeck);
    let joined = system.joined().expect("answers");
    assert_eq!(
        joined.at(0.9).err(),
        Some(super::super::JoinedError::NoAmplitude)
    );
    assert!(joined.with_length(0.1).at(0.9).is_ok() && joined.under(1.0, 0.1).is_ok());
}

/// Checks that evaluations of recordings return an error for a scene with several contacts.
#[cfg(feature = "measure")]
#[test]
fn recordings_name_the_fields() {
    use crate::measure::{Channel, IdentifyRequest, Recording, Unit};
    let frame = system(FRAME);
    let channel = Channel {
        name: "lower".into(),
        unit: Unit::METRE,
        samples: (0..100).map(|i| f64::from(i).sin()).collect(),
    };
    let recording = Recording::new(100.0, vec![channel]).expect("a recording");
    let told = [
        frame.identify(&[], &IdentifyRequest::default()).map(|_| ()),
        frame.fit_sweep(&[], false).map(|_| ()),
        frame.free_decay(&recording, None).map(|_| ()),
    ];
    for told in told {
        let told = told.expect_err("a refusal").to_string();
        assert!(told.contains("`contacts` or `dampers`"), "{told}");
    }
}
