//! `reference/closed_form.json`, and a comparison of any system with it.

use frictiongen::{ContinuousMotion, FrictionSystem, LimitsAt, MotionAt, Of, Steady, StuckAt};
use frictiongen_kernel::Float;
use serde_json::Value;
use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

/// The reference's scenes.
pub fn closed_form() -> Vec<Value> {
    let text = include_str!("../reference/closed_form.json");
    serde_json::from_str(text).expect("the reference is JSON")
}

/// A number of the reference, in quotes or not.
pub fn number(value: &Value) -> f64 {
    match value {
        Value::String(text) => text.parse().expect("a number in quotes"),
        value => value.as_f64().expect("a number"),
    }
}

fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

/// The largest error of each kind of quantity, and where it is.
#[derive(Clone, Debug, Default)]
pub struct Worst(pub BTreeMap<&'static str, (f64, String)>);

impl Worst {
    /// Notes an error, relative to `scale`.  References below 1e-30 are zeros.
    fn note(&mut self, kind: &'static str, got: f64, want: f64, scale: f64, place: &str) {
        let zeros = got.abs() < 1e-30 && want.abs() < 1e-30;
        let mut error = if got == want || zeros {
            0.0
        } else {
            (got - want).abs() / scale
        };
        if error.is_nan() {
            error = f64::INFINITY;
        }
        let worst = self.0.entry(kind).or_insert_with(|| (0.0, String::new()));
        if worst.0 < error {
            *worst = (error, format!("{place}: {got:e}, reference {want:e}"));
        }
    }

    /// The larger of both, kind by kind.
    pub fn join(&mut self, other: Self) {
        for (kind, (error, place)) in other.0 {
            let worst = self.0.entry(kind).or_insert_with(|| (0.0, String::new()));
            if worst.0 <= error {
                *worst = (error, place);
            }
        }
    }

    /// What exceeds its tolerance, readable; `tolerance` is by kind of quantity.
    pub fn beyond(&self, tolerance: impl Fn(&str) -> f64) -> Vec<String> {
        let all = self.0.iter();
        all.filter(|(kind, (error, _))| *error > tolerance(kind))
            .map(|(kind, (error, place))| format!("{kind}: {error:.2e} at {place}"))
            .collect()
    }
}

impl std::fmt::Display for Worst {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for (kind, (error, place)) in &self.0 {
            writeln!(f, "{kind:>26}: {error:.2e}  {place}")?;
        }
        Ok(())
    }
}

fn angle(got: f64, want: f64) -> f64 {
    let difference = (got - want).rem_euclid(TAU);
    if difference > PI {
        difference - TAU
    } else {
        difference
    }
}

/// Every value of one reference scene against a system.
pub fn compare<S: Float, F: FrictionSystem<Scalar = S>>(system: &F, reference: &Value) -> Worst
where
    for<'a> F::At<'a>: MotionAt<Scalar = S> + StuckAt,
{
    let mut worst = Worst::default();
    let ratios = list(&reference["natural_frequency_ratios"]);
    for (resonance, want) in system.resonances().iter().zip(ratios) {
        let want = number(want);
        worst.note("natural frequency", resonance.to_f64(), want, want, "");
    }
    for point in list(&reference["points"]) {
        let r = number(&point["r"]);
        let place = format!("r = {r}");
        let at = system.at(S::constant(r)).expect("a ratio in the domain");
        let limits = [
            (
                "continuous limit",
                at.continuous_limit(),
                "continuous_limit",
            ),
            (
                "without search",
                at.continuous_limit_without_search(),
                "continuous_limit_without_search",
            ),
            ("sliding limit", at.sliding_limit(), "sliding_limit"),
        ];
        for (kind, got, key) in limits {
            let want = number(&point[key]);
            worst.note(kind, got.to_f64(), want, want.abs(), &place);
        }
        let stuck = list(&point["stuck"]);
        let amplitude = |value: &Value| number(&value[0]).hypot(number(&value[1]));
        let largest = stuck.iter().map(amplitude).fold(1e-300, f64::max);
        for (mass, want) in stuck.iter().enumerate() {
            let got = at.stuck_mass(mass).expect("no resonance").expect("a mass");
            worst.note("stuck", got.re.to_f64(), number(&want[0]), largest, &place);
            worst.note("stuck", got.im.to_f64(), number(&want[1]), largest, &place);
        }
        for motion in list(&point["motions"]) {
            compare_motion(&at, motion, &place, &mut worst);
        }
    }
    worst
}

fn compare_motion<S: Float>(
    at: &impl MotionAt<Scalar = S>,
    reference: &Value,
    place: &str,
    worst: &mut Worst,
) {
    let beta = number(&reference["beta"]);
    let place = format!("{place}, beta = {beta}");
    let motion = at.motion(S::constant(beta)).expect("a continuous motion");
    let (amplitude, phase) = motion
        .ask(Of::Contact, |contact| {
            (contact.amplitude().to_f64(), contact.phase().to_f64())
        })
        .expect("the contact");
    let want = number(&reference["contact_amplitude"]);
    worst.note("contact amplitude", amplitude, want, want, &place);
    let want = number(&reference["contact_phase"]);
    worst.note("contact phase", angle(phase, want), 0.0, 1.0, &place);
    for (mass, want) in list(&reference["masses"]).iter().enumerate() {
        let place = format!("{place}, mass {}", mass + 1);
        let asked = motion.ask(Of::Mass(mass), |steady| {
            compare_mass(steady, want, &place, worst)
        });
        assert!(asked.is_some(), "mass {mass} is provided");
    }
}

fn compare_mass<S: Float>(
    steady: &dyn Steady<Scalar = S>,
    reference: &Value,
    place: &str,
    worst: &mut Worst,
) {
    let scale = number(&reference["amplitude"]);
    worst.note(
        "amplitude",
        steady.amplitude().to_f64(),
        scale,
        scale,
        place,
    );
    let phase = steady.phase().to_f64();
    worst.note(
        "phase",
        angle(phase, number(&reference["phase"])),
        0.0,
        1.0,
        place,
    );
    for (tau, want) in [0.5, 1.7, 3.0]
        .into_iter()
        .zip(list(&reference["displacement"]))
    {
        let got = steady.displacement(S::constant(tau)).to_f64();
        worst.note(
            "displacement",
            got,
            number(want),
            scale,
            &format!("{place}, tau = {tau}"),
        );
    }
    for (n, want) in [1, 3, 5].into_iter().zip(list(&reference["harmonics"])) {
        let got = steady.harmonic(n);
        let place = format!("{place}, n = {n}");
        worst.note("harmonic", got.re.to_f64(), number(&want[0]), scale, &place);
        worst.note("harmonic", got.im.to_f64(), number(&want[1]), scale, &place);
    }
}
