//! Checks whether the generator emits code for a scene with several contacts, dashpots, stops or constant forces.

use frictiongen_model::scene::Provide;
use frictiongen_model::validate::Path;
use frictiongen_syntax::{Located, Problems};

/// Largest number of contacts of a scene for which the generator emits code.
pub(super) const MOST_CONTACTS: usize = 4;

/// Reports the properties of a scene with several contacts, dashpots, stops or constant forces for which the generator
/// emits no code.
pub(super) fn check(located: &Located<'_>, problems: &mut Problems) {
    let scene = &located.scene;
    let contacts = scene.joints.contacts.len();
    let count = contacts + scene.joints.stops.len();
    if count > MOST_CONTACTS {
        let message = format!(
            "the macro emits code for at most {MOST_CONTACTS} contacts and stops, and this scene has {count}; leave some out, or solve this scene at run time with `frictiongen::System`"
        );
        let path = match MOST_CONTACTS.checked_sub(contacts) {
            Some(stop) => Path::StopName(stop),
            None => Path::JointName(MOST_CONTACTS),
        };
        problems.report(located.place(path), message);
    }
    for (index, provide) in scene.provide.iter().enumerate() {
        let place = located.place(Path::Provide(Some(index)));
        let message = match provide {
            Provide::Simulation | Provide::Stuck | Provide::Orbit if scene.springs.is_empty() => {
                "a scene without springs has no r and β, because they refer to the first spring; write `provide: [stepper]`, or write a spring"
            }
            Provide::Stuck | Provide::Orbit if !scene.has_linear_states() => {
                "emitted steady states take ratios without the amplitude of the load, which stops, moving surfaces and constant forces need; write `simulation` or `stepper`, or use `frictiongen orbit`"
            }
            Provide::Stepper | Provide::Simulation | Provide::Stuck | Provide::Orbit => continue,
            _ => {
                "the macro does not emit this for a scene with `contacts`, `dampers`, `stops` or `constant`; write `stepper`, `simulation`, `stuck` or `orbit`"
            }
        };
        problems.report(place, message);
    }
}
