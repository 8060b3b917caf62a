//! The causes of an error of an exported function, each with its number in C.

/// Cause of an error: its name and number in C, its meaning, and the error in Rust to which it corresponds.
#[derive(Debug)]
pub struct StatusCode {
    /// Name of the error's cause, without the prefix of the export.
    pub name: &'static str,
    /// Number of the cause. It stays the same in every version and for every scene.
    pub number: i32,
    /// Meaning of the error's cause, for a comment in the header.
    pub about: &'static str,
    /// Variant of `OutOfDomain` with the same meaning, as a Rust pattern.
    pattern: Option<&'static str>,
}

const fn status(
    name: &'static str,
    number: i32,
    about: &'static str,
    pattern: Option<&'static str>,
) -> StatusCode {
    StatusCode {
        name,
        number,
        about,
        pattern,
    }
}

/// All causes of an error, in the order of their numbers.
pub const STATUSES: [StatusCode; 35] = [
    status("OK", 0, "success", None),
    status("NULL_POINTER", 1, "a pointer is null", None),
    status(
        "NOT_STARTED",
        2,
        "the memory holds no started stepper or no saved state",
        None,
    ),
    status(
        "SELF_CHECK",
        3,
        "a constant or an answer of the self-check is wrong",
        None,
    ),
    status(
        "OTHER",
        4,
        "a cause that this version of the export does not list",
        None,
    ),
    status(
        "FREQUENCY_RATIO",
        10,
        "the frequency ratio r is NaN or negative",
        Some("FrequencyRatio(_)"),
    ),
    status(
        "FREQUENCY_RATIO_IN_TIME",
        11,
        "the frequency ratio r of a motion in time is zero, negative or not finite",
        Some("FrequencyRatioInTime(_)"),
    ),
    status(
        "FRICTION_RATIO",
        12,
        "the friction ratio beta is negative or not finite",
        Some("FrictionRatio(_)"),
    ),
    status(
        "OUTSIDE_TABLES",
        13,
        "r or beta is outside the range of the scene's tables",
        Some("OutsideTables(_)"),
    ),
    status(
        "STATE",
        14,
        "a displacement or velocity of the initial state is not finite or too large",
        Some("State"),
    ),
    status(
        "START",
        15,
        "a number of the initial state of a steady state is not finite",
        Some("Start | StuckStart"),
    ),
    status(
        "DURATION",
        16,
        "the reach of an advance is negative or not finite",
        Some("Duration(_)"),
    ),
    status(
        "LOAD_AMPLITUDE",
        17,
        "the amplitude of the load is not positive and finite, or too small or too large for the friction law",
        Some("LoadAmplitude(_)"),
    ),
    status(
        "STEP",
        20,
        "the step dt is not positive and finite, or too long",
        Some("Step(_)"),
    ),
    status(
        "FORCE",
        21,
        "a force on a mass is not finite or too large",
        Some("Force(_)"),
    ),
    status(
        "BASE_MOTION",
        22,
        "a displacement or velocity of the base is not finite or too large",
        Some("BaseMotion(_)"),
    ),
    status(
        "FRICTION",
        23,
        "the friction force is negative, not finite or too large",
        Some("Friction(_)"),
    ),
    status(
        "STICTION",
        24,
        "mu is less than 1, not finite or too large",
        Some("Stiction(_)"),
    ),
    status(
        "BEGUN",
        25,
        "the stepper has already taken a step",
        Some("Begun"),
    ),
    status(
        "SAVED",
        26,
        "the saved state belongs to another scene or another step dt",
        Some("Saved"),
    ),
    status(
        "WORK",
        27,
        "the work would overflow in one more step",
        Some("Work"),
    ),
    status(
        "STEP_STEEPNESS",
        28,
        "the friction law is too steep for this step and friction force",
        Some("StepSteepness"),
    ),
    status(
        "STEEPNESS",
        29,
        "the friction law is too steep",
        Some("Steepness"),
    ),
    status(
        "UNSUPPORTED",
        30,
        "the scene does not support the request",
        Some("Unsupported(_)"),
    ),
    status(
        "IMAGE_DAMAGED",
        31,
        "the image of a stepper is too short, or some of its bytes have changed",
        Some("ImageDamaged"),
    ),
    status(
        "IMAGE_VERSION",
        32,
        "another version of frictiongen wrote the image of a stepper",
        Some("ImageVersion"),
    ),
    status(
        "STICK_SLIP",
        40,
        "no motion slides all the time: the contact sticks and slides",
        None,
    ),
    status(
        "STUCK",
        41,
        "no motion slides all the time: the contact may stick for ever",
        None,
    ),
    status(
        "UNBOUNDED",
        42,
        "the excitation is on an undamped resonance, and friction does not bound the amplitude",
        None,
    ),
    status(
        "STUCK_RESONANCE",
        43,
        "the excitation is on an undamped resonance of the chain with its contact stuck",
        None,
    ),
    status(
        "TOO_MANY_EVENTS",
        44,
        "a cycle has more than 64 segments",
        None,
    ),
    status(
        "UNDAMPED",
        45,
        "the load drives a mode that nothing damps",
        None,
    ),
    status(
        "UNSTABLE",
        46,
        "every steady state that the search found is unstable",
        None,
    ),
    status("UNSETTLED", 47, "the motion does not become periodic", None),
    status(
        "MULTIPLIER",
        48,
        "the steady state has no Floquet multiplier with this index",
        None,
    ),
];

/// Returns the Rust functions that convert the library's errors to numbers.
pub fn conversions() -> String {
    let number = |name: &str| {
        let found = STATUSES.iter().find(|status| status.name == name);
        found.map_or(4, |status| status.number)
    };
    let domain = STATUSES.iter().filter_map(|status| {
        let pattern = status.pattern?;
        let variants = pattern
            .split(" | ")
            .map(|variant| format!("OutOfDomain::{variant}"));
        let variants: Vec<String> = variants.collect();
        Some(format!(
            "            {} => {},\n",
            variants.join(" | "),
            status.number
        ))
    });
    let domain: String = domain.collect();
    let texts = STATUSES
        .iter()
        .map(|status| format!("        {} => c\"{}\",\n", status.number, status.about));
    let texts: String = texts.collect();
    format!(
        "    const NULL_POINTER: i32 = {null};\n    const NOT_STARTED: i32 = {not_started};\n    \
         const SELF_CHECK: i32 = {self_check};\n    const STUCK_RESONANCE: i32 = {resonance};\n    \
         const OTHER: i32 = {other};\n    \
         const NO_MULTIPLIER: i32 = {multiplier};\n\n    \
         fn domain(error: OutOfDomain) -> i32 {{\n        match error {{\n{domain}            _ => OTHER,\n        }}\n    }}\n\n    \
         fn not_continuous(error: NotContinuous) -> i32 {{\n        match error {{\n            \
         NotContinuous::StickSlip => {stick_slip},\n            NotContinuous::Stuck => {stuck},\n            \
         NotContinuous::Unbounded => {unbounded},\n            \
         NotContinuous::OutOfDomain => {friction_ratio},\n            _ => OTHER,\n        }}\n    }}\n\n    \
         fn no_orbit(error: NoOrbit) -> i32 {{\n        match error {{\n            \
         NoOrbit::OutOfDomain(error) => domain(error),\n            NoOrbit::TooManyEvents => {events},\n            \
         NoOrbit::Unbounded => {unbounded},\n            NoOrbit::Undamped(_) => {undamped},\n            \
         NoOrbit::Unstable => {unstable},\n            NoOrbit::Unsettled => {unsettled},\n            \
         _ => OTHER,\n        }}\n    }}\n\n    \
         fn text(status: i32) -> &'static CStr {{\n        match status {{\n{texts}        _ => c\"not a status\",\n        }}\n    }}\n",
        null = number("NULL_POINTER"),
        not_started = number("NOT_STARTED"),
        self_check = number("SELF_CHECK"),
        resonance = number("STUCK_RESONANCE"),
        other = number("OTHER"),
        multiplier = number("MULTIPLIER"),
        stick_slip = number("STICK_SLIP"),
        stuck = number("STUCK"),
        unbounded = number("UNBOUNDED"),
        friction_ratio = number("FRICTION_RATIO"),
        events = number("TOO_MANY_EVENTS"),
        undamped = number("UNDAMPED"),
        unstable = number("UNSTABLE"),
        unsettled = number("UNSETTLED"),
    )
}
