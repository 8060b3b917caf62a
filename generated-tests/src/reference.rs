//! Reads the references `reference/closed_form.json`, `reference/extremes.json` and the wedges of
//! `reference/several_states.json`, and compares any system with them.
//!
//! A wedge is the range of friction ratios between β*_lim and β_lim. A comparison counts the compared values of each
//! kind. A missing key, or a list of another length, panics, because a gap in the reference must not shorten a
//! comparison.

use frictiongen::{
    ContinuousMotion, FrictionSystem, LimitsAt, MotionAt, Of, Regime, Steady, StuckAt,
};
use frictiongen_kernel::Float;
use frictiongen_kernel::number::dd::Dd;
use serde_json::Value;
use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

/// Returns the scenes of `closed_form.json`.
pub fn closed_form() -> Vec<Value> {
    let text = include_str!("../reference/closed_form.json");
    serde_json::from_str(text).expect("the reference is JSON")
}

/// Returns the scenes of `extremes.json`.
pub fn extremes() -> Vec<Value> {
    let text = include_str!("../reference/extremes.json");
    serde_json::from_str(text).expect("the reference is JSON")
}

/// Returns the scenes of `several_states.json` at friction ratios between β*_lim and β_lim.
pub fn wedges() -> Vec<Value> {
    let text = include_str!("../reference/several_states.json");
    let all: Value = serde_json::from_str(text).expect("the reference is JSON");
    list(&all["wedge"], "wedges").to_vec()
}

/// Reads a number of the reference, with or without quotes.
pub fn number(value: &Value) -> f64 {
    match value {
        Value::String(text) => text.parse().expect("a number in quotes"),
        value => value.as_f64().expect("a number"),
    }
}

/// Reads a number of the reference with all of its 20 digits, as a double-double number.
pub fn exact(value: &Value) -> Dd {
    let text = match value {
        Value::String(text) => text.clone(),
        Value::Number(number) => number.to_string(),
        other => panic!("{other} is no number"),
    };
    if text == "inf" {
        return Dd::from(f64::INFINITY);
    }
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((&text, "0"));
    let exponent: i32 = exponent.parse().expect("an exponent");
    let (negative, mantissa) = match mantissa.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, mantissa),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let ten = Dd::from(10.0);
    let mut sum = Dd::from(0.0);
    for digit in whole.chars().chain(fraction.chars()) {
        sum = sum * ten + Dd::from(f64::from(digit.to_digit(10).expect("a digit")));
    }
    let places = exponent - i32::try_from(fraction.len()).expect("few digits");
    for _ in 0..places.abs() {
        sum = if places < 0 { sum / ten } else { sum * ten };
    }
    if negative { -sum } else { sum }
}

/// Returns the description of a scene of the reference.
pub fn description(scene: &Value) -> &str {
    scene["description"].as_str().expect("a description")
}

/// Returns a list of the reference. Panics if the list is missing; `what` names the list in the message.
pub fn list<'a>(value: &'a Value, what: &str) -> &'a [Value] {
    let list = value.as_array().map(Vec::as_slice);
    list.unwrap_or_else(|| panic!("the reference has no list of {what}"))
}

/// Returns a list of the reference. Panics if the list is missing or has another length; `what` names it in the
/// message.
pub fn list_of<'a>(value: &'a Value, length: usize, what: &str) -> &'a [Value] {
    let list = list(value, what);
    assert_eq!(list.len(), length, "the reference's list of {what}");
    list
}

/// Result of a comparison with the reference for one kind of quantity.
#[derive(Clone, Debug, Default)]
pub struct Kind {
    /// Number of compared values.
    pub compared: usize,
    /// Largest error.
    pub error: f64,
    /// Scene and point of the largest error.
    pub place: String,
}

/// Results of a comparison for each kind of quantity.
#[derive(Clone, Debug, Default)]
pub struct Worst(pub BTreeMap<&'static str, Kind>);

/// Converts a value of any scalar to double-double.
fn wide<S: Float>(value: S) -> Dd {
    let high = value.to_f64();
    if !high.is_finite() {
        return Dd::from(high);
    }
    Dd::from(high) + Dd::from((value - S::constant(high)).to_f64())
}

impl Worst {
    /// Records the error of a value, divided by `scale`. If the value and its reference are both below 1e-30, the
    /// error is 0.
    pub fn note<S: Float>(
        &mut self,
        kind: &'static str,
        got: S,
        want: &Value,
        scale: f64,
        place: &str,
    ) {
        let (got, want) = (wide(got), exact(want));
        let zeros = got.to_f64().abs() < 1e-30 && want.to_f64().abs() < 1e-30;
        let same = got.to_f64() == want.to_f64() && !got.to_f64().is_finite();
        let error = if same || zeros {
            0.0
        } else {
            (got - want).to_f64().abs() / scale
        };
        self.put(
            kind,
            error,
            format_args!("{place}: {got:?}, reference {want:?}"),
        );
    }

    /// Records the error of an angle, which may differ from its reference by a whole turn.
    pub fn note_angle<S: Float>(&mut self, kind: &'static str, got: S, want: &Value, place: &str) {
        let (got, want) = (wide(got), exact(want));
        let mut error = got - want;
        if error.to_f64().abs() > PI {
            let turn = Dd::PI + Dd::PI;
            error = error - turn * Dd::from((error.to_f64() / TAU).round());
        }
        let place = format_args!("{place}: {got:?}, reference {want:?}");
        self.put(kind, error.to_f64().abs(), place);
    }

    fn put(&mut self, kind: &'static str, error: f64, place: std::fmt::Arguments<'_>) {
        let error = if error.is_nan() { f64::INFINITY } else { error };
        let worst = self.0.entry(kind).or_default();
        worst.compared += 1;
        if worst.error < error {
            (worst.error, worst.place) = (error, place.to_string());
        }
    }

    /// Merges another comparison: adds the counts, and keeps the larger error of each kind.
    pub fn join(&mut self, other: Self) {
        for (kind, other) in other.0 {
            let worst = self.0.entry(kind).or_default();
            worst.compared += other.compared;
            if worst.error < other.error {
                (worst.error, worst.place) = (other.error, other.place);
            }
        }
    }

    /// Returns the number of compared values of each kind.
    pub fn compared(&self) -> Vec<(&'static str, usize)> {
        let all = self.0.iter();
        all.map(|(kind, worst)| (*kind, worst.compared)).collect()
    }

    /// Returns one readable line for each kind of quantity whose error exceeds `tolerance` of that kind.
    pub fn beyond(&self, tolerance: impl Fn(&str) -> f64) -> Vec<String> {
        let all = self.0.iter();
        all.filter(|(kind, worst)| !(worst.error <= tolerance(kind)))
            .map(|(kind, worst)| format!("{kind}: {:.2e} at {}", worst.error, worst.place))
            .collect()
    }
}

impl std::fmt::Display for Worst {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for (kind, worst) in &self.0 {
            writeln!(
                f,
                "{kind:>26}: {} compared, none skipped; worst {:.2e}  {}",
                worst.compared, worst.error, worst.place
            )?;
        }
        Ok(())
    }
}

/// Compares β_lim, β*_lim and β_lim without search with those that the reference contains.
fn compare_limits<S: Float>(
    at: &impl LimitsAt<Scalar = S>,
    point: &Value,
    place: &str,
    worst: &mut Worst,
) {
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
        let want = &point[key];
        if !want.is_null() {
            worst.note(kind, got, want, number(want).abs(), place);
        }
    }
}

fn compare_frequencies<F: FrictionSystem>(system: &F, reference: &Value, worst: &mut Worst)
where
    F::Scalar: Float,
{
    let resonances = system.resonances();
    let ratios = &reference["natural_frequency_ratios"];
    for (resonance, want) in resonances
        .iter()
        .zip(list_of(ratios, resonances.len(), "frequencies"))
    {
        worst.note("natural frequency", *resonance, want, number(want), "");
    }
}

/// Compares a system with every value of one scene of `closed_form.json`.
pub fn compare<S: Float, F: FrictionSystem<Scalar = S>>(system: &F, reference: &Value) -> Worst
where
    for<'a> F::At<'a>: MotionAt<Scalar = S> + StuckAt,
{
    let mut worst = Worst::default();
    compare_frequencies(system, reference, &mut worst);
    let points = list_of(&reference["points"], 3, "points");
    compare_points(system, points, &mut worst);
    worst
}

/// Compares a system with every value of one scene of [`wedges`], and checks that its regime there is bistable.
pub fn compare_wedge<S: Float, F: FrictionSystem<Scalar = S>>(
    system: &F,
    reference: &Value,
) -> Worst
where
    for<'a> F::At<'a>: MotionAt<Scalar = S> + StuckAt,
{
    let mut worst = Worst::default();
    let points = list(&reference["points"], "points");
    compare_points(system, points, &mut worst);
    for point in points {
        let at = system.at(S::constant(number(&point["r"])));
        let at = at.expect("a ratio in the domain");
        for motion in list(&point["motions"], "motions") {
            let regime = at.regime(S::constant(number(&motion["beta"])));
            assert_eq!(regime, Ok(Regime::Bistable), "{motion}");
        }
    }
    worst
}

fn compare_points<S: Float, F: FrictionSystem<Scalar = S>>(
    system: &F,
    points: &[Value],
    worst: &mut Worst,
) where
    for<'a> F::At<'a>: MotionAt<Scalar = S> + StuckAt,
{
    let masses = system.masses();
    for point in points {
        let r = number(&point["r"]);
        let place = format!("r = {r}");
        let at = system.at(S::constant(r)).expect("a ratio in the domain");
        compare_limits(&at, point, &place, worst);
        let stuck = list_of(&point["stuck"], masses, "stuck amplitudes");
        let amplitude = |value: &Value| number(&value[0]).hypot(number(&value[1]));
        let largest = stuck.iter().map(amplitude).fold(1e-300, f64::max);
        for (mass, want) in stuck.iter().enumerate() {
            let got = at.stuck_mass(mass).expect("no resonance").expect("a mass");
            worst.note("stuck", got.re, &want[0], largest, &place);
            worst.note("stuck", got.im, &want[1], largest, &place);
        }
        for reference in list_of(&point["motions"], 2, "motions") {
            compare_motion(&at, reference, masses, &place, worst);
        }
    }
}

fn compare_contact<S: Float>(
    motion: &impl ContinuousMotion<Scalar = S>,
    reference: &Value,
    place: &str,
    worst: &mut Worst,
) {
    let (amplitude, phase) = motion
        .ask(Of::Contact, |contact| {
            (contact.amplitude(), contact.phase())
        })
        .expect("the contact");
    let want = &reference["contact_amplitude"];
    worst.note("contact amplitude", amplitude, want, number(want), place);
    worst.note_angle("contact phase", phase, &reference["contact_phase"], place);
}

fn compare_motion<S: Float>(
    at: &impl MotionAt<Scalar = S>,
    reference: &Value,
    masses: usize,
    place: &str,
    worst: &mut Worst,
) {
    let beta = number(&reference["beta"]);
    let place = format!("{place}, beta = {beta}");
    let motion = at.motion(S::constant(beta)).expect("a continuous motion");
    compare_contact(&motion, reference, &place, worst);
    let wanted = list_of(&reference["masses"], masses, "masses");
    for (mass, want) in wanted.iter().enumerate() {
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
    let want = &reference["amplitude"];
    let scale = number(want);
    worst.note("amplitude", steady.amplitude(), want, scale, place);
    worst.note_angle("phase", steady.phase(), &reference["phase"], place);
    let displacements = list_of(&reference["displacement"], 3, "displacements");
    for (tau, want) in [0.5, 1.7, 3.0].into_iter().zip(displacements) {
        let got = steady.displacement(S::constant(tau));
        let place = format!("{place}, tau = {tau}");
        worst.note("displacement", got, want, scale, &place);
    }
    let harmonics = list_of(&reference["harmonics"], 3, "harmonics");
    for (n, want) in [1, 3, 5].into_iter().zip(harmonics) {
        let got = steady.harmonic(n);
        let place = format!("{place}, n = {n}");
        worst.note("harmonic", got.re, &want[0], scale, &place);
        worst.note("harmonic", got.im, &want[1], scale, &place);
    }
}

/// Compares a system with every value of one scene of `extremes.json`. At both bounds of the range of r, and where r
/// is too small for a search, the reference of a point may lack β_lim or the motions.
pub fn compare_extremes<S: Float, F: FrictionSystem<Scalar = S>>(
    system: &F,
    reference: &Value,
) -> Worst
where
    for<'a> F::At<'a>: MotionAt<Scalar = S>,
{
    let mut worst = Worst::default();
    compare_frequencies(system, reference, &mut worst);
    for point in list(&reference["points"], "points") {
        let r = number(&point["r"]);
        let place = format!("{}, r = {r}", reference["name"]);
        let at = system.at(S::constant(r)).expect("a ratio in the domain");
        compare_limits(&at, point, &place, &mut worst);
        if point["motions"].is_null() {
            continue;
        }
        for reference in list_of(&point["motions"], 2, "motions") {
            let beta = number(&reference["beta"]);
            let place = format!("{place}, beta = {beta}");
            let motion = at.motion(S::constant(beta)).expect("a continuous motion");
            compare_contact(&motion, reference, &place, &mut worst);
            let wanted = &reference["displacement_at_1"];
            let wanted = list_of(wanted, system.masses(), "displacements");
            let scale = wanted.iter().map(|want| number(want).abs());
            let scale = scale.fold(number(&reference["contact_amplitude"]), f64::max);
            for (mass, want) in wanted.iter().enumerate() {
                let got = motion
                    .ask(Of::Mass(mass), |steady| {
                        steady.displacement(S::constant(1.0))
                    })
                    .expect("a mass");
                let place = format!("{place}, mass {}", mass + 1);
                worst.note("displacement", got, want, scale, &place);
            }
        }
    }
    worst
}
