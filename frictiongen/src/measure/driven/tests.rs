//! Tests that a record with uneven steps gives the motion of the even record whose straight lines it has.
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    reason = "a test may fail"
)]

use super::Drive as _;
use crate::measure::{Channel, Inputs, MeasureError, Recording, response_spectrum};
use crate::study::System;
use crate::study::joined::JoinedContactNow;

const DT: f64 = 0.01;

/// Samples of the corners of the record. Straight lines join them.
const CORNERS: [(usize, f64); 9] = [
    (0, 0.0),
    (12, 1.0),
    (13, -0.6),
    (50, 0.7),
    (51, 0.7),
    (80, -1.2),
    (123, 0.4),
    (124, 1.5),
    (200, -0.3),
];

/// Returns the value of the record at an even sample.
fn value(sample: usize) -> f64 {
    let next = CORNERS.iter().position(|(corner, _)| sample <= *corner);
    let next = next.unwrap().max(1);
    let ((from, a), (to, b)) = (CORNERS[next - 1], CORNERS[next]);
    a + (b - a) * (sample - from) as f64 / (to - from) as f64
}

/// Channels of a record, each with its name, its unit, its mean and its size.
type Tracks<'t> = &'t [(&'t str, &'t str, [f64; 2])];

type Motion = (Vec<[f64; 2]>, Vec<JoinedContactNow>);

/// Follows a scene under channels with a name, a unit and a size, sampled at the given samples of the even record.
/// Returns the motion at each of these samples, and the work of the load.
fn motion(scene: &str, channels: Tracks<'_>, at: &[usize]) -> (Vec<Motion>, f64) {
    let system: System = scene.parse().unwrap();
    let channels = channels.iter().map(|(name, unit, [mean, size])| Channel {
        name: (*name).to_owned(),
        unit: unit.parse().unwrap(),
        samples: at.iter().map(|at| mean + size * value(*at)).collect(),
    });
    let times: Vec<f64> = at.iter().map(|at| 3.0 + DT * *at as f64).collect();
    let recording = Recording::inputs_at(&times, channels.collect()).unwrap();
    let friction = recording.channel("friction").is_none().then_some(2.0);
    let inputs = Inputs::of(&recording, &system, friction).unwrap();
    let inputs = inputs.followed_by(0.5).unwrap();
    let joined = system.joined().unwrap();
    let mut step = inputs.joined_stepper(&joined, None).unwrap();
    let mut motions = Vec::new();
    inputs
        .follow(&mut step, &joined, &mut |step, _, _| {
            motions.push((step.masses(), step.contacts()));
            true
        })
        .unwrap();
    assert_eq!(step.exceeded(), 0);
    assert!((step.time() - 2.5).abs() < 1e-12);
    (motions, step.work().load)
}

#[test]
fn samples_on_straight_lines_change_nothing() {
    let frame = "struct F { masses: { lower: 3, upper: 2 }, springs: { base - lower: 1200, lower - upper: 900 },
        contacts: { pads: upper - wall { stiction: 1.2 }, brace: lower - base { stiffness: 4000, share: 2 } },
        damping: modal(0.02), excitation: base }";
    let block =
        "struct B { masses: { m: 2 }, springs: { m - wall: 300 }, contact: m - wall, excitation: m,
        stiction: 1.3 }";
    let held = block.replace("excitation: m,", "excitation: m, input: hold,");
    let cases: [(&str, Tracks<'_>); 6] = [
        (frame, &[("base", "mm", [0.0, 8.0])]),
        (frame, &[("base", "m/s", [0.0, 0.2])]),
        (
            frame,
            &[("base", "g", [0.0, 0.3]), ("upper", "N", [0.0, 5.0])],
        ),
        (block, &[("force", "N", [0.0, 9.0])]),
        (
            block,
            &[("force", "N", [0.0, 9.0]), ("friction", "N", [2.0, 1.0])],
        ),
        (&held, &[("force", "N", [0.0, 9.0])]),
    ];
    let all: Vec<usize> = (0..=200).collect();
    for (index, (scene, channels)) in cases.into_iter().enumerate() {
        // A sample that is held must stay, but the first case of the hold has a step that does not change its force.
        let kept: Vec<usize> = match index {
            5 => all.iter().copied().filter(|sample| *sample != 51).collect(),
            _ => CORNERS.iter().map(|corner| corner.0).collect(),
        };
        let (even, work) = motion(scene, channels, &all);
        let (uneven, other) = motion(scene, channels, &kept);
        let after = (201..even.len()).chain([]);
        let samples: Vec<usize> = kept.iter().copied().chain(after).collect();
        assert_eq!(samples.len(), uneven.len(), "case {index}");
        let size = even.iter().flat_map(|(masses, _)| masses.iter().flatten());
        let size = size.fold(0.0_f64, |size, value| size.max(value.abs()));
        let mut worst = (work - other).abs() / work.abs();
        for (sample, (masses, contacts)) in samples.iter().zip(&uneven) {
            let (expected, states) = &even[*sample];
            for (a, b) in masses.iter().flatten().zip(expected.iter().flatten()) {
                worst = worst.max((a - b).abs() / size);
            }
            for (a, b) in contacts.iter().zip(states) {
                assert_eq!(
                    a.is_sticking, b.is_sticking,
                    "case {index}, sample {sample}"
                );
                worst = worst.max((a.energy - b.energy).abs() / work.abs());
            }
        }
        let slid = uneven.last().unwrap().1.iter().map(|now| now.slip);
        assert!(0.0 < slid.fold(0.0, f64::max), "case {index} never slides");
        println!("case {index}: {worst:.1e}");
        assert!(worst < 1e-12, "case {index}: {worst:e}");
    }
}

#[test]
fn what_needs_even_steps_is_refused() {
    let base = |samples: Vec<f64>| {
        let unit = "mm".parse().unwrap();
        let name = "base".to_owned();
        vec![Channel {
            name,
            unit,
            samples,
        }]
    };
    let uneven = Recording::inputs_at(&[1.0, 1.1, 1.3], base(vec![0.0, 1.0, 0.0])).unwrap();
    assert_eq!(uneven.uneven_times().unwrap().len(), 3);
    assert!((uneven.rate() - 10.0).abs() < 1e-12);
    assert!(uneven.to_csv().ends_with("0.30000000000000004,0.0\n"));
    let error = response_spectrum(&uneven, 0.05, &[1.0]).unwrap_err();
    assert!(matches!(error, MeasureError::MixedRates { .. }), "{error}");
    let system: System = "struct B { masses: { m: 2 }, springs: { m - base: 300 }, contact: m - wall, excitation: base }"
        .parse()
        .unwrap();
    assert!(
        Inputs::of(&uneven, &system, Some(1.0))
            .unwrap()
            .stepper(&system)
            .is_err()
    );
    for times in [
        [0.0, 1.0, 1.0],
        [0.0, 1.0, 0.5],
        [0.0, f64::NAN, 1.0],
        [0.0, 1.0, f64::INFINITY],
    ] {
        let error = Recording::inputs_at(&times, base(vec![0.0; 3])).unwrap_err();
        assert!(
            matches!(error, MeasureError::MixedRates { .. }),
            "{times:?}: {error}"
        );
    }
    let error = Recording::inputs_at(&[0.0, 1.0, 3.0], base(vec![0.0; 4])).unwrap_err();
    assert!(matches!(error, MeasureError::Lengths(_)), "{error}");
    let even = Recording::inputs_at(&[0.0, 1.0, 2.0], base(vec![0.0; 3])).unwrap();
    assert!(even.uneven_times().is_none() && even.even_rate() == Ok(1.0));
}
