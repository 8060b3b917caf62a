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

/// A block on the floor, whose friction falls from 1.3 F to F.
fn decaying(law: &str, spring: &str) -> String {
    format!(
        "struct Block {{ masses: {{ block: 1 }}, {spring} contacts: {{ floor: block - wall }},
            excitation: block, stribeck: {law} }}"
    )
}

/// Integrates the motion of the block under the smooth law with F = 5 N, by Runge and Kutta with small steps, until `ends`.
/// Returns time, displacement and velocity.
fn integrated(
    (force, stiffness): (f64, f64),
    start: [f64; 2],
    ends: impl Fn(f64, [f64; 2]) -> bool,
) -> (f64, [f64; 2]) {
    let side = (force - stiffness * start[0]).signum();
    let slope = |[x, v]: [f64; 2]| {
        let friction = 5.0 * (1.0 + 0.3 * (-(side * v).max(0.0) / 0.05).exp());
        [v, force - stiffness * x - side * friction]
    };
    let add = |y: [f64; 2], k: [f64; 2], h: f64| [y[0] + h * k[0], y[1] + h * k[1]];
    let (mut y, h, mut step) = (start, 1e-5, 0);
    loop {
        let time = h * f64::from(step);
        if step > 0 && ends(time, y) {
            return (time, y);
        }
        let a = slope(y);
        let b = slope(add(y, a, 0.5 * h));
        let c = slope(add(y, b, 0.5 * h));
        let d = slope(add(y, c, h));
        for (k, weight) in [(a, 1.0), (b, 2.0), (c, 2.0), (d, 1.0)] {
            y = add(y, k, h * weight / 6.0);
        }
        step += 1;
    }
}

/// The motion on straight lines differs from that under the smooth law by no more than their errors can cause.
#[test]
fn a_smooth_law_is_that_of_a_plain_integrator() {
    for (law, accuracy) in [("exp(1.3, 0.05)", 1e-3), ("exp(1.3, 0.05, 1e-5)", 1e-5)] {
        let force = ["--input", "step 8 N", "--until", "0.5", "--samples", "50"];
        let line = [&["time", "-", "--friction", "5", "--csv"], &force[..]].concat();
        let csv = output(&decaying(law, ""), &line);
        let v = column(&csv, "block.velocity_m_s");
        let (_, [_, expected]) = integrated((8.0, 0.0), [0.0; 2], |time, _| time > 0.5 - 5e-6);
        let error = (v[50] - expected).abs();
        println!("{law}: {error:.1e} m/s");
        assert!(error < 5.0 * accuracy * 0.5, "{law}: {error}");
        assert!(1e-3 * accuracy < error, "{law}: the lines have no error");

        // Released at 0.2 m, the block slides back until it stops at the other side.
        let line = [
            "time",
            "-",
            "--friction",
            "5",
            "--from",
            "0.2;0",
            "--until",
            "1",
            "--events",
            "--csv",
        ];
        let csv = output(&decaying(law, "springs: { block - wall: 100 },"), &line);
        let (time, place) = (column(&csv, "time_s"), column(&csv, "block.displacement_m"));
        let (expected, [x, _]) = integrated((0.0, 100.0), [0.2, 0.0], |_, [_, v]| v >= 0.0);
        let index = usize::from(time[0] == 0.0);
        // Between the instants the integrator has a step of 1e-5 s. The velocity is small there.
        assert!(
            (time[index] - expected).abs() < 2e-5 + accuracy,
            "{time:?}, {expected}"
        );
        assert!(
            (place[index] - x).abs() < 1e-8 + accuracy * 0.1,
            "{place:?}, {x}"
        );
    }
}

/// The static friction is that at rest, or that of `stiction`. The block breaks away at it.
#[test]
fn static_friction_of_a_smooth_law() {
    for (stiction, limit) in [("", 1.3), ("stiction: 1.3,", 1.3), ("stiction: 1.5,", 1.5)] {
        let scene = "struct S { masses: { m: 1 }, springs: { m - wall: 1 }, contact: m - wall, excitation: m,
            stribeck: exp(1.3, 0.05), ";
        let line = "time --friction 2 --input ramp_4_N_for_1_s --until 1 --events --csv";
        let line: Vec<String> = line.split(' ').map(|word| word.replace('_', " ")).collect();
        let line: Vec<&str> = line.iter().map(String::as_str).collect();
        let csv = output(&format!("{scene}{stiction} }}"), &line);
        assert!(
            (column(&csv, "time_s")[0] - limit / 2.0).abs() < 1e-12,
            "{csv}"
        );
    }
}

#[test]
fn smooth_laws_that_are_refused() {
    let scene = |law: &str| {
        format!(
            "struct S {{ masses: {{ m: 1 }}, springs: {{ m - wall: 1 }}, contact: m - wall, excitation: m, {law} }}"
        )
    };
    for (law, says) in [
        (
            "stribeck: exp(0.9, 0.05)",
            "the friction at rest is 0.9 times F, but must be above 1",
        ),
        (
            "stribeck: exp(1.3, 0)",
            "the speed of the decay must be above zero",
        ),
        (
            "stribeck: exp(1.3, 0.05, 1e-9)",
            "the accuracy of `stribeck` is a fraction of F",
        ),
        (
            "stribeck: exp(1.3)",
            "`exp` takes two or three numbers, not 1",
        ),
        ("stribeck: 1.3", "write `stribeck: exp(fs, vs)`"),
        (
            "stribeck: exp(1.3, 0.05), stiction: 1.1",
            "is below the friction at rest of `stribeck`, 1.3 times F",
        ),
        (
            "friction: coulomb, stribeck: exp(1.3, 0.05)",
            "`stribeck` is given twice",
        ),
        (
            "friction: stribeck(exp(1.3, 0.05))",
            "write the field `stribeck: exp(1.3, 0.05)`",
        ),
        ("friction: dahl(1e5)", "elastic contacts answer most of it"),
        (
            "friction: LuGre(1e5, 300)",
            "elastic contacts answer most of it",
        ),
        (
            "stribeck: exp(1.3, 0.05), stiffness: 10",
            "`stiffness` and `stribeck` exclude each other",
        ),
    ] {
        let message = failure(scene(law), &["check"]).join("\n");
        assert!(message.contains(says), "{law}: {message}");
        assert_eq!(message.matches("error: ").count(), 1, "{law}: {message}");
    }
    let text = output(&scene("stribeck: exp(1.3, 0.05)"), &["check"]);
    let says = "stribeck: 12 straight lines from 1.3 F to F, with errors of at most 1.00000e-3 F";
    assert!(text.contains(says), "{text}");
    let json = output(
        &scene("stribeck: exp(1.3, 0.05, 1e-2)"),
        &["check", "--json"],
    );
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(json["stribeck"]["lines"], 4);
}
