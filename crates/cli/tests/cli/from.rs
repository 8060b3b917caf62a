//! Tests the option `--from`, and the answers of a contact that never slides.

#![allow(clippy::indexing_slicing, reason = "a test may fail")]

use crate::common::{cells, column, failure, json, output, words};

/// A mass on a moving base, with an elastic contact beside the spring. Friction of 50 k₁Y locks the contact.
const BRACED: &str = "struct Braced { masses: { m: 1 }, springs: { base - m: 1 },
    contact: m - base, stiffness: 4, excitation: base, provide: [orbit] }";
/// A mass on a moving base. At r = 1.1 and β = 0.65 it slides from rest, and it moves with the base from x = 1.
const STUBBORN: &str = "struct Block { masses: { m: 1 }, springs: { base - m: 1 },
    contact: m - base, excitation: base, stiction: 2 }";

/// Amplitude of the locked chain over Y: the spring and the contact act side by side, with the stiffness 5.
fn locked(r: f64) -> f64 {
    5.0 / (5.0 - r * r)
}

/// Every command gives the same amplitude of a contact that never slides: that of the locked chain, and from a state that
/// amplitude plus the constant displacement. The contact has no force at its initial relative displacement z₀ = x₀ − Y.
/// Its constant displacement is then 4z₀/5.
#[test]
fn every_command_starts_where_it_is_told() {
    let commands = [
        "orbit --r 0.5,0.9 --beta 50",
        "orbit --r 0.5,0.9 --beta 50 --states",
        "response --r 0.5,0.9 --beta 50",
        "curve --r 0.5:0.9 --beta 50",
        "map --r 0.5,0.9 --beta 50",
    ];
    for (from, middle, offset) in [
        ("", 0.0, -0.8),
        (" --from rest", -0.8, -0.8),
        (" --from 1.5;0", 0.4, 0.4),
    ] {
        let amplitude = |r: f64| locked(r) + f64::abs(middle);
        for command in commands {
            let text = output(BRACED, &words(&format!("{command} --csv{from}")));
            let [rs, found, offsets] =
                ["r", "m.amplitude", "offset"].map(|name| column(&text, name));
            assert!(2 <= rs.len());
            for ((r, found), offset_found) in rs.iter().zip(&found).zip(&offsets) {
                let what = format!("{command}{from}: {found} for {}", amplitude(*r));
                assert!((found - amplitude(*r)).abs() < 1e-12, "{what}");
                assert!(
                    (offset_found - offset).abs() < 1e-12,
                    "{what}: {offset_found}"
                );
            }
        }
        let force = format!("response --r 0.9 --beta 50 --of force(contact) --csv{from}");
        let found = column(&output(BRACED, &words(&force)), "force(contact).amplitude")[0];
        let expected = 4.0 * (locked(0.9) - 1.0) + f64::abs(middle);
        assert!((found - expected).abs() < 1e-12, "{found} for {expected}");
        let steady = format!("time --r 0.9 --beta 50 --steady --csv{from}");
        let moved = column(&output(BRACED, &words(&steady)), "m.displacement");
        let largest = moved
            .into_iter()
            .fold(0.0, |most: f64, x| most.max(x.abs()));
        assert!((largest - amplitude(0.9)).abs() < 1e-12, "{largest}");
    }
}

/// The objective of `optimum` is the amplitude of the same state. Below its resonance, the locked chain moves most at the
/// upper bound of the band.
#[test]
fn optimum_means_the_same_state() {
    for (from, constant) in [("", 0.0), (" --from 1;0", 0.0), (" --from 1.5;0", 0.4)] {
        let line = format!("optimum --r 0.5:0.9 --of m --json{from}");
        let found = json(&output(BRACED, &words(&line)));
        let lines = found["points"].as_array().unwrap();
        let value = |key: &str| {
            let line = lines.iter().find(|line| line["key"] == key).unwrap();
            line["value"].as_f64().unwrap()
        };
        let expected = locked(0.9) + constant;
        assert!(
            (value("with_contact_locked") - expected).abs() < 1e-9,
            "{found}"
        );
        assert!(value("amplitude") < expected + 1e-9, "{found}");
    }
}

/// Of several states, an initial state decides. In a continuous motion with μ = 1 it decides nothing. A state in m and
/// m/s is the same at every frequency, also under a load whose amplitude depends on frequency.
#[test]
fn a_state_selects_among_several() {
    for command in ["orbit", "response", "map"] {
        for (from, regime) in [
            ("", "continuous"),
            (" --from rest", "continuous"),
            (" --from 1;0", "stuck"),
        ] {
            let line = format!("{command} --r 1.1 --beta 0.65 --csv{from}");
            let text = output(STUBBORN, &words(&line));
            let place = cells(&text)[0]
                .iter()
                .position(|name| *name == "regime")
                .unwrap();
            assert_eq!(cells(&text)[1][place], regime, "{line}");
        }
    }
    let wall = STUBBORN
        .replace("m - base", "m - wall")
        .replace(", stiction: 2", "");
    for command in ["response --r 0.7", "curve --r 0.7:0.8", "map --r 0.7"] {
        let asked = |from| output(&wall, &words(&format!("{command} --beta 0.1 --csv{from}")));
        assert_eq!(asked(" --from -3;2"), asked(""), "{command}");
    }
    // The mass starts with the base, which is at Y = 0.1 m/s² / ω². With ω = 0.5 rad/s, Y is 0.4 m.
    let physical = "orbit --omega 0.5 --friction 50 --base 0.1m/s2 --csv --from 0.4;0";
    let offset = column(&output(BRACED, &words(physical)), "offset_m")[0];
    assert!(offset.abs() < 1e-15, "{offset}");
    let other = physical.replace("0.5", "1").replace("0.4;", "0.35;");
    // With ω = 1 rad/s, Y is 0.1 m, and the mass starts 0.25 m from the base.
    let offset = column(&output(BRACED, &words(&other)), "offset_m")[0];
    assert!((offset - 0.2).abs() < 1e-15, "{offset}");
}

/// A wrong initial state gives one line that says what to write.
#[test]
fn wrong_states() {
    let joined = "struct S { masses: { m: 1 }, springs: { base - m: 1 }, excitation: base,
        contacts: { brace: m - base { stiffness: 4, share: 0.5 } } }";
    let form = "x1,...;v1,...: the displacements of all masses, a semicolon, their velocities";
    let needs = "has no answer for a scene with several `contacts`, `dampers` or `friction: stribeck`; leave it out";
    let cases = [
        ("orbit --r 1 --from 1", format!("--from `1`: write rest, or {form}")),
        ("response --r 1 --from up", format!("--from `up`: write rest, or {form}")),
        ("map --r 1 --from 1,2;3", "--from `1,2;3`: the number of displacements is 2, but the number of masses is 1".to_owned()),
        ("optimum --r 1:2 --of m --from 1;inf", "--from `1;inf`: `inf` is not a finite number".to_owned()),
        ("curve --r 1:2 --from 1;nan", "--from `1;nan`: `nan` is not a finite number".to_owned()),
        ("curve --r 1:2 --from up,side", format!("--from `side`: write rest, up, down, or {form}")),
        ("curve --r 1:2 --from up,up", "--from: `up` is given twice".to_owned()),
        ("curve --r 1:2 --from up --from 1;0", "--from `1;0`: give a state alone, without another --from".to_owned()),
        ("response --r 0,1 --from rest", "--from: a motion needs a frequency above 0 and below infinity; leave 0 and inf out of --r".to_owned()),
    ];
    let beta = |line: &str| match line.starts_with("optimum") {
        true => line.to_owned(),
        false => format!("{line} --beta 1"),
    };
    for (line, told) in cases {
        assert_eq!(
            failure(BRACED, &words(&beta(line))),
            [format!("frictiongen: {told}")],
            "{line}"
        );
    }
    for line in [
        "limits --r 1",
        "sensitivity --r 1 --beta 1 --of m",
        "features --r 1:2 --beta 1",
        "report --r 1:2 -o page.html",
    ] {
        let told = failure(BRACED, &words(&format!("{line} --from rest")));
        let expected = "frictiongen: --from: only `orbit`, `response`, `curve`, `map`, `time`, `optimum`, `branch` and `limit-cycle` take an initial state; leave it out of this command";
        assert_eq!(told, [expected], "{line}");
    }
    for line in [
        "curve --r 1:2 --beta 1 --from up",
        "curve --r 1:2 --beta 1 --from rest,down",
    ] {
        let told = failure(joined, &words(line));
        assert!(
            told[0].ends_with(needs) && told.len() == 1,
            "{line}: {told:?}"
        );
    }
}

/// A contact has the same amplitudes with the solver for several contacts, without a start and from rest. With a share of
/// one half, this solver needs twice the friction.
#[test]
fn several_contacts_have_the_same_starts() {
    let several = BRACED.replace(
        "contact: m - base, stiffness: 4",
        "contacts: { brace: m - base { stiffness: 4, share: 0.5 } }",
    );
    for command in ["orbit", "response", "map"] {
        let line = format!("{command} --r 0.5,0.75,1 --beta 50 --of m --csv");
        let from_rest = format!("{line} --from rest");
        let [centred, kept] = [&line, &from_rest].map(|line| {
            let expected = column(&output(BRACED, &words(line)), "m.amplitude");
            let line = line.replace("--beta 50", "--beta 100");
            let found = column(&output(&several, &words(&line)), "m.amplitude");
            for (expected, found) in expected.iter().zip(&found) {
                assert!(
                    (found / expected - 1.0).abs() < 1e-9,
                    "{line:?}: {found} {expected}"
                );
            }
            found
        });
        // The base starts at Y, and the mass at 0, which leaves a force in the contact that never slides.
        assert!((kept[0] / centred[0] - 1.0).abs() > 0.1, "{command}");
    }
}
