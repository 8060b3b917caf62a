//! Exported functions that compute steady states, with or without stops of the contact.

use super::face::{
    ExportedFunction, ExportedItems, ExportedStruct, FieldType, Passed, StructField,
};
use super::names::{mass_fields, of_masses};
use frictiongen::study::scene::Scene;

const R: (&str, Passed) = ("r", Passed::Value(FieldType::Real));
const BETA: (&str, Passed) = ("beta", Passed::Value(FieldType::Real));

/// Rust statements that fill the struct `orbit` from the steady state `found`.
const WRITTEN: &str = "let count = |count: usize| u32::try_from(count).unwrap_or(u32::MAX);
orbit.write(Orbit {
    period: found.period(),
    stops: count(found.stops()),
    reversals: count(found.reversals()),
    multipliers: count(found.multipliers().len()),
    is_symmetric: i32::from(found.is_symmetric()),
    is_stable: i32::from(found.is_stable()),
    is_marginal: i32::from(found.is_marginal()),
    stuck_fraction: found.stuck_fraction(),
});
Ok(())";

/// Adds the functions that return the numbers of a steady state. One function starts the motion from rest, another
/// function from a given state. `unit` is the unit of displacements.
pub fn add(face: &mut ExportedItems, scene: &Scene, unit: &str) {
    records(face, scene, unit);
    let output = ("orbit", Passed::Output(FieldType::Record("orbit")));
    face.functions.push(ExportedFunction {
        name: "orbit",
        about: "Returns the steady state that motion from rest reaches, in any regime. A contact that never slides is in the middle of the interval in which it may rest.".to_owned(),
        parameters: vec![R, BETA, output.clone()],
        body: format!(
            "let found = Scene::at(r).map_err(domain)?.orbit(beta).map_err(no_orbit)?;\n{WRITTEN}"
        ),
    });
    let list = |of: &str| of_masses(scene, |field, _| format!("start.{field}.{of}")).join(", ");
    face.functions.push(ExportedFunction {
        name: "orbit_from",
        about: "Returns the steady state that motion from another state reaches. With mu > 1 several states may exist. A contact that never slides stays where the motion leaves it."
            .to_owned(),
        parameters: vec![R, BETA, ("start", Passed::Input("orbit_start")), output],
        body: format!(
            "let state = (&[{}], &[{}]);\nlet found = Scene::at(r).map_err(domain)?.orbit_from(beta, state).map_err(no_orbit)?;\n{WRITTEN}",
            list("displacement"),
            list("velocity")
        ),
    });
    face.functions.push(ExportedFunction {
        name: "orbit_multiplier",
        about: "Returns a Floquet multiplier of the steady state from rest: the factor by which a small deviation grows in a period. The index is less than the number of multipliers in struct orbit."
            .to_owned(),
        parameters: vec![
            R,
            BETA,
            ("index", Passed::Value(FieldType::Count)),
            ("multiplier", Passed::Output(FieldType::Record("complex"))),
        ],
        body: "let found = Scene::at(r).map_err(domain)?.orbit(beta).map_err(no_orbit)?;\nlet index = usize::try_from(index).map_err(|_| NO_MULTIPLIER)?;\nlet found = found.multipliers().get(index).ok_or(NO_MULTIPLIER)?;\nmultiplier.write(complex(*found));\nOk(())"
            .to_owned(),
    });
}

fn records(face: &mut ExportedItems, scene: &Scene, unit: &str) {
    let flag = |name: &str, about: &str| StructField::new(name, FieldType::Int, about);
    let number = |name: &str, about: &str| StructField::new(name, FieldType::Count, about);
    face.records.push(ExportedStruct {
        name: "orbit",
        about: "A steady state in any regime.".to_owned(),
        fields: vec![
            number(
                "period",
                "in cycles of the excitation; all counts are for one period",
            ),
            number("stops", "number of stops"),
            number("reversals", "number of reversals without a stop"),
            number("multipliers", "number of Floquet multipliers"),
            flag(
                "is_symmetric",
                "1 if the second half of a period is minus the first",
            ),
            flag("is_stable", "1 if small changes of the state decay"),
            flag(
                "is_marginal",
                "1 if the state is one of a continuum, or is approached only algebraically",
            ),
            StructField::new(
                "stuck_fraction",
                FieldType::Real,
                "fraction of the period in which the contact sticks",
            ),
        ],
    });
    face.records.push(ExportedStruct {
        name: "orbit_start",
        about: format!("State of all masses at a maximum of the excitation, over {unit}."),
        fields: mass_fields(scene, "instant"),
    });
}
