//! Tests the commands on a scene with an elastic contact.

#![allow(
    clippy::expect_used,
    clippy::indexing_slicing,
    reason = "a test may fail"
)]

use crate::common::{column, column_with_gaps, failure, file, output, texts, words};
use crate::report::page;

/// Description of two floors with a damper on a brace.
const BRACED: &str = "struct Braced { masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 }, contact: upper - wall, stiffness: 5.0e3,
    excitation: base, damping: modal[0.010, 0.012] }";

/// Checks that the commands agree with each other at one operating point. A difference over a millionth of the stiffness
/// has an error of about 1e-6 of the derivative.
#[test]
fn commands_agree() {
    let point = "--r 0.9 --beta 0.3 --of lower --csv";
    let asked = |command: &str, scene: &str| output(scene, &words(&format!("{command} {point}")));
    let amplitude = |scene: &str| column(&asked("orbit", scene), "lower.amplitude")[0];
    let orbit = asked("orbit", BRACED);
    assert_eq!(texts(&orbit, "regime"), ["stick-slip"]);
    assert_eq!(column(&orbit, "stops"), [2.0]);
    let response = asked("response", BRACED);
    assert_eq!(column(&response, "lower.amplitude")[0], amplitude(BRACED));
    let map = asked("map", BRACED);
    assert_eq!(column(&map, "lower.amplitude")[0], amplitude(BRACED));
    let limits = output(BRACED, &words("limits --r 0.9 --csv"));
    assert_eq!(column(&limits, "continuous_limit"), [0.0]);
    let sliding = column(&limits, "sliding_limit")[0];
    let line = format!("response --r 0.9 --beta {:?} --csv", 4.0 * sliding);
    assert_eq!(texts(&output(BRACED, &words(&line)), "regime"), ["stuck"]);

    let sensitivity = asked("sensitivity", BRACED);
    let parameters = texts(&sensitivity, "parameter");
    let place = parameters.iter().position(|name| *name == "stiffness");
    let derivative = place.map(|place| column(&sensitivity, "amplitude.derivative")[place]);
    let [above, below] = ["5000.5", "4999.5"].map(|k| amplitude(&BRACED.replace("5.0e3", k)));
    let difference = above - below;
    assert!(
        derivative.is_some_and(|one| (one - difference).abs() < 1e-6 * one.abs()),
        "{derivative:?} for {difference}"
    );
    let curve = output(
        BRACED,
        &words("curve --r 0.8:1.0 --beta 0.3 --of lower --accuracy 1e-2 --csv"),
    );
    let largest = column(&curve, "lower.amplitude")
        .into_iter()
        .fold(0.0, f64::max);
    assert!(amplitude(BRACED) <= largest, "{largest}");
}

/// A force that grows as p = at drives a block of mass m on a spring k₁ with an elastic contact. While the contact sticks,
/// x = a/(k₁ + k) (t − sin Ωt/Ω) with Ω² = (k₁ + k)/m, and the friction force is kx. Then it is F.
#[test]
fn drive_follows_the_closed_form_of_a_ramp() {
    let block = file(
        "ramp.friction",
        "struct Block { masses: { block: 2 }, springs: { base - block: 50 }, contact: block - wall,
            stiffness: 400, excitation: block }",
    );
    let (rate, spring, contact, mass, friction) = (2.0_f64, 50.0, 400.0, 2.0, 1.0);
    let samples = (0..100).map(|i| (0.01 * f64::from(i), 0.01 * rate * f64::from(i)));
    let lines = samples.map(|(time, force)| format!("{time},{force}\n"));
    let head = "time_s,force_N\n".to_owned();
    let ramp = file("ramp.csv", &(head + &lines.collect::<String>()));
    let text = output("", &["drive", &block, &ramp, "--friction", "1", "--csv"]);
    let omega = f64::sqrt((spring + contact) / mass);
    let places = column(&text, "contact.displacement_m");
    let forces = column(&text, "contact.friction_N");
    let states = texts(&text, "contact.state");
    let mut stuck = 0;
    for (index, ((place, force), state)) in places.iter().zip(&forces).zip(&states).enumerate() {
        let time = 0.01 * index as f64;
        let exact = rate / (spring + contact) * (time - (omega * time).sin() / omega);
        if contact * exact < friction {
            // The step's tables have a rounding error of about 1e-16 of the largest displacement.
            assert!((place - exact).abs() < 1e-15, "{time}: {place} for {exact}");
            assert!((force - contact * exact).abs() < 1e-12, "{time}: {force}");
            assert_eq!(*state, "stuck");
            stuck += 1;
        } else {
            assert_eq!((*force, *state), (friction, "forward"), "{time}");
        }
    }
    // kx reaches F after 0.56 s.
    assert!((50..65).contains(&stuck), "{stuck}");
}

/// A recording of a motion that `time` prints gives the force and the stiffness that `time` had.
#[test]
fn identify_finds_force_and_stiffness() {
    let text = |hertz: f64| {
        let line = format!(
            "time --hz {hertz:?} --base 0.002 --friction 0.8 --skip 200 --cycles 20 --samples 64 --csv"
        );
        output(BRACED, &words(&line))
    };
    let recordings = [1.7, 2.2, 2.8].map(|hertz| {
        let text = text(hertz);
        let times = column(&text, "time_s");
        let motions =
            ["lower", "upper"].map(|name| column(&text, &format!("{name}.displacement_m")));
        let [lower, upper] = &motions;
        let mut lines = "time_s,base_mm,lower_mm,upper_mm\n".to_owned();
        for (index, time) in times.iter().enumerate() {
            let base = 2.0 * (std::f64::consts::TAU * hertz * time).cos();
            // Rounding to 0.1 µm acts as noise.
            let row = format!(
                "{time},{base:.4},{:.4},{:.4}\n",
                1e3 * lower[index],
                1e3 * upper[index]
            );
            lines += &row;
        }
        file(&format!("{hertz}.csv"), &lines)
    });
    let guess = file("guess.friction", &BRACED.replace("5.0e3", "2.0e3"));
    let [one, two, three] = &recordings;
    let asked = [
        "identify",
        &guess,
        one,
        two,
        three,
        "--also",
        "stiffness",
        "--csv",
    ];
    let found = output("", &asked);
    let value = |name: &str| {
        let place = texts(&found, "quantity")
            .iter()
            .position(|key| *key == name);
        place.map(|place| column_with_gaps(&found, "value")[place])
    };
    let (force, stiffness) = (value("friction force"), value("stiffness"));
    assert!(
        force.is_some_and(|force| (force / 0.8 - 1.0).abs() < 1e-3),
        "{found}"
    );
    assert!(
        stiffness.is_some_and(|stiffness| (stiffness / 5e3 - 1.0).abs() < 1e-2),
        "{found}"
    );
    // A rigid contact has no stiffness that could be fitted.
    let rigid = file("rigid.friction", &BRACED.replace(", stiffness: 5.0e3", ""));
    let told = failure("", &["identify", &rigid, one, "--also", "stiffness"]);
    assert!(
        told[0].contains("add `stiffness` to the description"),
        "{told:?}"
    );
    let told = failure("", &["identify", &guess, one, "--decay"]);
    assert!(told[0].contains("only for a scene with one mass") || told[0].contains("`stiffness`"));
    let table = output("", &["transmissibility", &guess, one, "--csv"]);
    assert!(column(&table, "upper.transmissibility")[0] > 0.0);
}

/// The lists of features and the page of a report have no limit of continuous motion, and say for how long the contact
/// sticks.
#[test]
fn features_and_report_say_how_long_the_contact_sticks() {
    let features = output(BRACED, &words("features --r 0.5:2 --beta 0.3 --csv"));
    let details = texts(&features, "detail");
    let told = details
        .iter()
        .filter(|text| text.contains("of the period"))
        .count();
    // One regime, and peaks of the contact and of the lower mass at two resonances.
    assert_eq!(told, 5, "{features}");
    let orbit = output(BRACED, &words("orbit --r 1.25 --beta 0.3 --csv"));
    let share = 100.0 * column(&orbit, "stuck_fraction")[0];
    let regime = format!("stick-slip (sticks {share:.0} % of the period in mid-range)");
    assert!(details.contains(&regime.as_str()), "{regime}: {features}");
    for part in ["slides all the time", "continuous", "quasi-static"] {
        assert!(!features.contains(part), "{part}: {features}");
    }
    let line = "--hz 1:6 --base 0.002 --friction 0.8";
    let (page, data) = page(BRACED, &words(line));
    assert!(
        page.contains("stiffness of the contact") && page.contains("sticks after each reversal")
    );
    assert!(!page.contains("never a stop in the range"));
    assert_eq!(data["scene"]["contact_N_per_m"], 5000.0);
}

/// Checks that commands without an answer for an elastic contact name the field and another command.
#[test]
fn other_commands_are_refused_by_name() {
    let told = failure(BRACED, &words("compile --accuracy 1e-4 --r 0.2:2.5"));
    assert!(
        told[0].contains("has `stiffness`") && told[0].contains("`frictiongen orbit`"),
        "{told:?}"
    );
}
