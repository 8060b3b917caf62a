//! Tests `frictiongen time` with a kinetic friction level that depends on the speed.

#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::panic,
    reason = "a test may fail"
)]

use crate::common::{cells, column, failure, output, words};
use frictiongen::study::history::HistoryRequest;
use frictiongen::{Of, System};

/// Returns the description of a frame with a given friction law.
fn frame(friction: &str) -> String {
    format!(
        "struct Frame {{
            masses: {{ lower: 3.27, upper: 3.25 }},
            springs: {{ base - lower: 1190.0, lower - upper: 1323.0 }},
            contact: upper - wall,
            excitation: base,
            damping: modal[0.010, 0.012],
            stiction: 1.3,
            friction: {friction},
        }}"
    )
}

const STRIBECK: &str = "stribeck(0.01: 0.7, 0.04: 0.55)";

/// Checks that samples and events equal those of the library, in m, m/s and N.
#[test]
fn samples_and_events_are_those_of_the_library() {
    let text = frame(STRIBECK);
    let line = "time --hz 1.2 --friction 1.2 --base 0.002 --cycles 4 --skip 2 --samples 100 --csv";
    let csv = output(&text, &words(line));
    let system: System = text.parse().unwrap();
    let r = system.frequency_ratio_at_hertz(1.2);
    let load = frictiongen::study::units::Load::Base(0.002);
    let scale = system.load_scale(load).unwrap();
    let omega = system.angular_frequency(r);
    let request = HistoryRequest {
        amplitude: Some(load.amplitude()),
        skip: 2,
        cycles: 4,
        samples: 100,
        ..HistoryRequest::new(&[Of::Contact, Of::Mass(0), Of::Mass(1)])
    };
    let history = system
        .history(r, scale.friction_ratio(1.2), &request)
        .unwrap();
    let close = |found: Vec<f64>, want: Vec<f64>| {
        assert_eq!(found.len(), want.len());
        for (found, want) in found.iter().zip(&want) {
            // The compared numbers are products whose factors are multiplied in different orders.
            assert!(
                (found - want).abs() <= 1e-14 * want.abs(),
                "{found}, {want}"
            );
        }
        found.len()
    };
    let mut compared = 0;
    for (name, track) in ["contact", "lower", "upper"].iter().zip(&history.tracks) {
        let x = track.displacement.iter().map(|x| scale.displacement(*x));
        let v = track.velocity.iter().map(|v| scale.velocity(*v, omega));
        compared += close(column(&csv, &format!("{name}.displacement_m")), x.collect());
        compared += close(column(&csv, &format!("{name}.velocity_m_s")), v.collect());
    }
    let force: Vec<f64> = history
        .friction
        .iter()
        .map(|f| scale.friction(*f))
        .collect();
    compared += close(column(&csv, "contact.friction_N"), force.clone());
    assert_eq!(compared, 7 * 401);
    // While the contact slides, the force takes many values between the levels of the law.
    let within = force
        .iter()
        .filter(|force| (0.67..1.19).contains(&force.abs()));
    assert!(within.count() > 50);
    let csv = output(&text, &words(&format!("{line} --events")));
    let events: Vec<f64> = history.events.iter().map(|event| event.tau).collect();
    assert_eq!(column(&csv, "tau"), events);
    assert!(events.len() > 7);
}

/// Checks that a constant level gives the results of Coulomb's law, and that the spectrum of a run is that of its
/// samples.
#[test]
fn a_level_that_does_not_change() {
    for rest in ["", " --spectrum", " --from 0.001,0.002;0,0.01"] {
        let line = format!("time --hz 1.2 --friction 1.2 --base 0.002 --cycles 3 --csv{rest}");
        let [lines, plain] = ["stribeck(0.01: 1, 0.5: 1)", "coulomb"]
            .map(|friction| output(&frame(friction), &words(&line)));
        let (lines, plain) = (cells(&lines), cells(&plain));
        assert_eq!(lines[0], plain[0]);
        assert_eq!(lines.len(), plain.len());
        let mut compared = 0;
        for (lines, plain) in lines[1..].iter().zip(&plain[1..]) {
            for (found, want) in lines.iter().zip(plain) {
                let number = |text: &str| text.parse::<f64>().ok();
                let (Some(a), Some(b)) = (number(found), number(want)) else {
                    assert_eq!(found, want);
                    continue;
                };
                // The largest value is 1.2 N. Lags in degrees are not compared for spectral lines that are zero up to
                // rounding.
                let lag = rest.contains("spectrum");
                assert!((a - b).abs() < 1e-11 || lag, "{a}, {b}");
                compared += 1;
            }
        }
        assert!(compared > 300, "{compared}");
    }
}

#[test]
fn refused() {
    let text = frame(STRIBECK);
    let told = |line: &str| failure(&text, &words(line))[0].clone();
    let told = |line: &str| told(line).replace("frictiongen: ", "");
    assert_eq!(
        told("time --r 1 --beta 0.3"),
        "<stdin>: the scene has lengths, speeds or constant forces, so that the load is needed; give it by --base"
    );
    assert!(told("time --r 1 --beta 0.3 --steady").contains("the amplitude of the load is needed"));
    assert!(told("time --r 1 --beta 0.3 --base 0").contains("above 0 and finite"));
    assert!(told("time --r 0 --beta 0.3 --base 0.002").contains("--r `0`"));
    let steep = frame("stribeck(1e-9: 1.3)");
    let told = failure(&steep, &words("time --r 1 --beta 0.3 --base 0.002"));
    assert!(told[0].contains("4096 times as fast"), "{told:?}");
}
