//! Writes the documentation about the work of one step of the stepper.

use frictiongen_kernel::motion::AnyContact;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::stepper::{
    Cost, MAX_EVENTS, MAX_PARTS, MAX_STRETCHES, StepScene, series_terms,
};
use frictiongen_model::scene::Precision;

/// Returns documentation lines about the equal parts into which the stepper divides a step.
pub(super) fn parts(scene: &StepScene<'_, Dd, AnyContact<Dd>>, step: Option<f64>) -> Vec<String> {
    let fastest = scene.fastest().to_f64();
    let shown = if (0.1..1e7).contains(&fastest) {
        format!("{fastest:.2}")
    } else {
        format!("{fastest:.3e}")
    };
    let mut parts = format!(" A step of dt, in s, has ⌈{shown}·dt⌉ parts, at most {MAX_PARTS}");
    if let Some(step) = step {
        parts += &format!(": `STEP` has {}", (fastest * step).ceil().max(1.0));
    }
    let lines = if scene.law.is_empty() {
        String::new()
    } else {
        format!(" (the friction law adds up to {MAX_STRETCHES} changes of its line)")
    };
    vec![
        parts + &format!(".  {shown} is the largest ω(1 + 2ζ) of a mode, in rad/s: in a part, the phase of the fastest mode advances by at most 1 rad."),
        " A part in which the contact certainly keeps sliding, or keeps sticking, is a product of its state with tables.".to_owned(),
        format!(" In any other part the stepper searches the events, at most {MAX_EVENTS}{lines}."),
        " After these events, a contact at rest stays stuck to the end of the part, and in any other contact the friction force is constant there.  This force opposes the displacement of the contact in the part, so that it creates no energy.  `exceeded()` counts the step.".to_owned(),
    ]
}

/// Returns upper bounds on the cost of a step, and the number of equal parts into which the stepper divides the step.
/// Without a declared step, the bounds are those of a step with a single part.
pub(super) fn cost(
    scene: &StepScene<'_, Dd, AnyContact<Dd>>,
    step: Option<f64>,
    coefficients: usize,
    precision: Precision,
) -> (Cost, u32) {
    let angle = step.map_or(1.0, |step| scene.fastest().to_f64() * step);
    let parts = angle.ceil().clamp(1.0, f64::from(MAX_PARTS));
    let epsilon = match precision {
        Precision::F32 => f64::from(f32::EPSILON),
        Precision::F64 => f64::EPSILON,
    };
    let terms = series_terms(angle / parts, epsilon);
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "from 1 to MAX_PARTS"
    )]
    let parts = parts as u32;
    (scene.cost(coefficients, parts, terms), parts)
}

/// Returns documentation lines about the number of operations of a step.
pub(super) fn operations(
    scene: &StepScene<'_, Dd, AnyContact<Dd>>,
    step: Option<f64>,
    coefficients: usize,
    precision: Precision,
) -> Vec<String> {
    let (cost, _) = cost(scene, step, coefficients, precision);
    let of = if step.is_some() {
        "step of `STEP`"
    } else {
        "part"
    };
    let Cost {
        tables,
        one_event,
        most,
        ..
    } = cost;
    let (each, beside) = (Cost::INSTRUCTIONS, Cost::FIXED);
    let processor = match precision {
        Precision::F32 => format!(
            "  A Cortex-M4F takes up to {each} instructions for each operation, and {beside} more for a part."
        ),
        // A Cortex-M4F has no registers for doubles, so the text states no number of instructions.
        Precision::F64 => String::new(),
    };
    vec![
        String::new(),
        format!(
            " A {of} has at most {tables} floating-point operations if all parts are such products, about {one_event} with one event, never"
        ),
        format!(
            " more than {most}.  `set_event_budget(n)` limits the events of a step to n, and `cost().most` is then the bound.{processor}"
        ),
    ]
}
