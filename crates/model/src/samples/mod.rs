//! Chains, requests, random numbers and intervals for the tests of this crate and of the proofs.

mod intervals;

pub use intervals::{RandomNumbers, contains};

use crate::modal::Modal;
use crate::scene::{
    CONTACT, ContactSides, Damping, DampingFrom, Declared, Excitation, FrictionLaw, Mass, Node,
    Precision, Provide, Scene, Side, Spring, StepperOptions,
};
use crate::table::Request;

/// Returns a chain of equal masses and springs. `kind` selects the contact and the load:
///
/// | kind | contact | load |
/// |---|---|---|
/// | `Wall` | the last mass with a wall | a force on the first mass |
/// | `Base` | the first mass with the moving base | motion of the base |
/// | `Shaken` | the last mass with a wall | motion of the base, damping relative to the base |
/// | `Carried` | the first mass with the moving base | motion of the base, damping relative to the base |
/// | `Apart` | the first two masses | motion of the base, damping relative to the base |
/// | others | the first two masses | a force on the last mass |
#[must_use]
pub fn scene(kind: &str, count: usize, zeta: f64, stiction: f64) -> Modal {
    let mass = |place: usize| Mass {
        name: format!("m{place}"),
        value: 1.0,
    };
    let spring = |place: usize| Spring {
        from: place.checked_sub(1).map_or(Node::Base, Node::Mass),
        to: Node::Mass(place),
        stiffness: 1.0,
    };
    let (from, to, excitation) = match kind {
        "Wall" => (Node::Mass(count - 1), Node::Wall, Excitation::Force(0)),
        "Base" | "Carried" => (Node::Mass(0), Node::Base, Excitation::Base),
        "Shaken" => (Node::Mass(count - 1), Node::Wall, Excitation::Base),
        "Apart" => (Node::Mass(0), Node::Mass(1), Excitation::Base),
        _ => (Node::Mass(0), Node::Mass(1), Excitation::Force(count - 1)),
    };
    Modal::of(&Scene {
        name: kind.to_owned(),
        masses: (0..count).map(mass).collect(),
        springs: (0..count).map(spring).collect(),
        contact: ContactSides { from, to },
        contact_name: CONTACT.to_owned(),
        excitation,
        damping_from: match kind {
            "Shaken" | "Carried" | "Apart" => DampingFrom::Base,
            _ => DampingFrom::Rest,
        },
        stiffness: None,
        damping: if zeta < 0.0 {
            // Every second mode is damped.
            let of = (0..count).map(|mode| -zeta * (mode % 2) as f64);
            Damping::Modal(of.collect())
        } else if zeta > 0.0 {
            Damping::Uniform(zeta)
        } else {
            Damping::None
        },
        stiction,
        precision: Precision::F64,
        provide: vec![Provide::Limits],
        declared: Declared::default(),
        friction: FrictionLaw::default(),
        stepping: StepperOptions::default(),
        joints: Default::default(),
    })
}

/// Returns a request for the tables of the limits from r = 0.2 to 2.5.
#[must_use]
pub fn request(accuracy: f64, side: Side) -> Request {
    Request {
        r: (0.2, 2.5),
        accuracy,
        side,
        motion: false,
        stuck: false,
    }
}

/// Returns a random number from 0 to 1.
pub fn random(state: &mut u64) -> f64 {
    *state = state
        .wrapping_mul(6_364_136_223_846_793_005)
        .wrapping_add(1_442_695_040_888_963_407);
    (*state >> 11) as f64 / (1_u64 << 53) as f64
}
