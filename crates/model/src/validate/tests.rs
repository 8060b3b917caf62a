//! Tests of the checks that need a scene built without a text, and of the checks on the graph of springs. The catalogue
//! of messages covers all other errors, with line and column.

use super::*;
use crate::scene::{
    Accuracy, CONTACT, ConstantForce, ContactSides, Damping, Declared, FrictionLaw, Impact,
    JointLaw, Mass, NamedContact, NamedStop, Precision, Provide, Range, Spring, StepperOptions,
    StopLaw,
};

fn mass(name: &str, value: f64) -> Mass {
    Mass {
        name: name.to_owned(),
        value,
    }
}

fn spring(from: Node, to: Node) -> Spring {
    Spring {
        from,
        to,
        stiffness: 1.0,
    }
}

fn chain(count: usize) -> Scene {
    let mut springs = vec![spring(Node::Base, Node::Mass(0))];
    springs.extend((1..count).map(|index| spring(Node::Mass(index - 1), Node::Mass(index))));
    Scene {
        name: "Chain".to_owned(),
        masses: (0..count)
            .map(|index| mass(&format!("m{index}"), 1.0))
            .collect(),
        springs,
        contact: ContactSides {
            from: Node::Mass(count - 1),
            to: Node::Wall,
        },
        contact_name: CONTACT.to_owned(),
        excitation: Excitation::Force(0),
        damping: Damping::None,
        damping_from: Default::default(),
        stiffness: None,
        stiction: 1.0,
        precision: Precision::F64,
        provide: vec![Provide::Limits],
        declared: Declared::default(),
        friction: FrictionLaw::default(),
        stepping: StepperOptions::default(),
        joints: Default::default(),
    }
}

fn messages(scene: &Scene) -> Vec<(Path, String)> {
    let errors = validate(scene).expect_err("the scene is faulty");
    errors
        .iter()
        .map(|error| (error.path(), error.to_string()))
        .collect()
}

#[test]
fn the_longest_chain_passes_and_a_longer_one_does_not() {
    assert_eq!(validate(&chain(MOST_MASSES)), Ok(()));
    let errors = validate(&chain(MOST_MASSES + 1)).expect_err("one too many");
    let path = Path::MassName(MOST_MASSES);
    assert_eq!(
        errors,
        [SceneError::TooManyMasses {
            path,
            count: 1001,
            limit: 1000
        }]
    );
}

#[test]
fn masses_that_do_not_exist_are_told_wherever_they_are_named() {
    let mut scene = chain(2);
    scene
        .springs
        .push(spring(Node::Mass(2), Node::Mass(usize::MAX)));
    scene.contact = ContactSides {
        from: Node::Wall,
        to: Node::Mass(5),
    };
    scene.excitation = Excitation::Force(6);
    scene.provide.push(Provide::Motion(Some(vec![0, 7])));
    scene.provide.push(Provide::Stepper);
    scene.stepping.forces = vec![1, 8];
    let paths: Vec<_> = messages(&scene).into_iter().map(|(path, _)| path).collect();
    assert_eq!(
        paths,
        [
            Path::SpringFrom(2),
            Path::SpringTo(2),
            Path::ContactTo,
            Path::Excitation,
            Path::Provide(Some(1)),
            Path::Force(Some(1))
        ]
    );
    let (_, message) = messages(&scene).swap_remove(3);
    assert_eq!(
        message,
        "there is no mass with the index 6; the scene has 2, and the first has the index 0"
    );
}

#[test]
fn numbers_that_are_not_finite_are_told_wherever_they_stand() {
    let mut scene = chain(1);
    scene.masses = vec![mass("upper floor", f64::NAN)];
    scene.springs = vec![Spring {
        from: Node::Base,
        to: Node::Mass(0),
        stiffness: f64::INFINITY,
    }];
    scene.damping = Damping::Rayleigh {
        mass: f64::NAN,
        stiffness: f64::NEG_INFINITY,
    };
    scene.stiction = f64::NAN;
    scene.declared.accuracy = Accuracy::Relative(f64::NAN);
    scene.declared.range = Some(Range {
        r: (0.0, f64::INFINITY),
        beta: (f64::NAN, 1.0),
    });
    scene.provide = vec![Provide::Stepper, Provide::Limits];
    scene.stepping.step = Some(f64::NAN);
    scene.friction = FrictionLaw::Stribeck(vec![[f64::NAN, 0.5], [1.0, f64::INFINITY]]);
    let paths: Vec<_> = messages(&scene).into_iter().map(|(path, _)| path).collect();
    assert_eq!(
        paths,
        [
            Path::MassName(0),
            Path::Mass(0),
            Path::Spring(0),
            Path::Damping(Some(0)),
            Path::Damping(Some(1)),
            Path::Stiction,
            Path::Accuracy,
            Path::RangeOfRatio,
            Path::RangeOfFriction,
            Path::Friction(Some(0)),
            Path::Friction(Some(3)),
            Path::Step
        ]
    );
    assert_eq!(
        messages(&scene)[0].1,
        "`upper floor` cannot name a mass: a name is made of letters, digits and `_`, and does not begin with a digit"
    );
    assert_eq!(
        messages(&scene)[1].1,
        "the mass `upper floor` is NaN, which is not a finite number; write a finite one"
    );
}

#[test]
fn the_load_reaches_a_contact_through_masses_but_not_through_supports() {
    let mut scene = chain(3);
    scene.springs[1] = spring(Node::Mass(1), Node::Wall);
    assert_eq!(messages(&scene)[0].0, Path::Contact);
    scene.contact = ContactSides {
        from: Node::Mass(0),
        to: Node::Mass(2),
    };
    assert_eq!(validate(&scene), Ok(()));
    // Only the component of the contact has springs to the base.
    scene.contact = ContactSides {
        from: Node::Mass(2),
        to: Node::Wall,
    };
    scene.excitation = Excitation::Base;
    assert_eq!(messages(&scene)[0].0, Path::Contact);
    scene.contact.to = Node::Base;
    assert_eq!(validate(&scene), Ok(()));
    scene.springs.push(spring(Node::Base, Node::Mass(1)));
    scene.contact.to = Node::Wall;
    assert_eq!(validate(&scene), Ok(()));
}

#[test]
fn every_part_that_floats_is_told_once() {
    let mut scene = chain(14);
    scene.springs.remove(4);
    let told = messages(&scene);
    assert_eq!(told.len(), 1);
    assert_eq!(told[0].0, Path::MassName(4));
    assert!(
        told[0]
            .1
            .contains("(`m5`, `m6`, `m7`, `m8`, `m9`, `m10`, `m11`, `m12`, …)")
    );
}

#[test]
fn words_of_the_language_and_of_the_results_are_no_names() {
    for word in ["self", "gen", "_", "type"] {
        assert!(is_keyword(word), "{word}");
    }
    for word in ["contact", "wall", "base", "time", "_"] {
        assert!(!may_name(word, false) && !may_name(word, true), "{word}");
    }
    // Only emitted code has methods.
    for word in [
        "at",
        "amplitude",
        "limits_into",
        "into",
        "cost",
        "stiction",
        "step",
        "begin_with",
        "box",
        "final",
    ] {
        assert!(may_name(word, false) && !may_name(word, true), "{word}");
    }
    for word in ["m1", "_x", "étage", "上"] {
        assert!(may_name(word, true), "{word}");
    }
    for word in ["", "1m", "a b", "a-b", "a'"] {
        assert!(!is_name(word), "{word}");
    }
}

/// Checks that a loaded mass may not be called `force` or `friction`, which are fields of the stepper's input.
#[test]
fn a_loaded_mass_has_no_name_of_the_input() {
    let mut scene = chain(3);
    scene.masses[1].name = "friction".to_owned();
    scene.provide = vec![Provide::Stepper];
    assert_eq!(validate(&scene), Ok(()));
    scene.stepping.forces = vec![2, 1];
    let path = Path::Force(Some(1));
    let name = "friction".to_owned();
    assert_eq!(validate(&scene), Ok(()));
    let emitted = Checks {
        emitted: true,
        ..Checks::default()
    };
    assert_eq!(
        validate_known(&scene, &emitted),
        Err(vec![SceneError::Reserved { path, name }])
    );
}

fn stop(name: &str, from: Node, to: Node, gap: f64, impact: Impact) -> NamedStop {
    NamedStop {
        name: name.to_owned(),
        sides: ContactSides { from, to },
        law: StopLaw { gap, impact },
    }
}

#[test]
fn faults_of_stops_belts_and_constant_forces_have_their_paths() {
    let mut scene = chain(2);
    let spring = |stiffness, damping| Impact::Spring { stiffness, damping };
    let (mass, wall) = (Node::Mass(1), Node::Wall);
    scene.provide = vec![Provide::Orbit];
    scene.joints.contacts = vec![NamedContact {
        name: "belt".to_owned(),
        sides: scene.contact,
        law: JointLaw {
            speed: f64::NAN,
            ..JointLaw::default()
        },
    }];
    scene.joints.stops = vec![
        stop(
            "a",
            mass,
            Node::Mass(7),
            f64::INFINITY,
            spring(f64::NAN, 0.0),
        ),
        stop("b", mass, wall, 0.0, spring(f64::INFINITY, f64::NAN)),
        stop("c", mass, wall, 0.0, Impact::Restitution(f64::NAN)),
        stop("d", wall, mass, 0.0, Impact::Restitution(1.0)),
        stop("belt", mass, wall, -1e-61, Impact::Restitution(0.0)),
    ];
    let force = |mass, force| ConstantForce { mass, force };
    scene.joints.constant = vec![force(9, 1.0), force(0, f64::NAN), force(0, 1.0)];
    let paths: Vec<_> = messages(&scene).into_iter().map(|(path, _)| path).collect();
    assert_eq!(
        paths,
        [
            Path::StopName(4),
            Path::JointSpeed(0),
            Path::StopTo(0),
            Path::StopGap(0),
            Path::StopStiffness(0),
            Path::StopStiffness(1),
            Path::StopDamping(1),
            Path::StopRestitution(2),
            Path::StopFrom(4),
            Path::StopGap(4),
            Path::ConstantMass(0),
            Path::Constant(1),
            Path::ConstantMass(2),
        ]
    );
    assert_eq!(
        messages(&scene)[12].1,
        "there is already a constant force on the mass `m0`; constant forces on one mass act as one, so add them and write a single force"
    );
}

/// Checks that a stop joins a mass to the chain, although it does not hold it, and that a constant force does not.
#[test]
fn a_stop_touches_a_mass() {
    let mut scene = chain(2);
    scene.masses.push(mass("loose", 1.0));
    scene.provide = vec![Provide::Orbit];
    scene.joints.constant = vec![ConstantForce {
        mass: 2,
        force: 1.0,
    }];
    assert_eq!(messages(&scene)[0].0, Path::MassName(2));
    let rigid = Impact::Restitution(0.5);
    scene.joints.stops = vec![stop("bumper", Node::Mass(1), Node::Mass(2), 0.1, rigid)];
    assert_eq!(validate(&scene), Ok(()));
}

#[test]
fn only_a_contact_alone_becomes_the_single_contact() {
    let mut scene = chain(1);
    let contact = |speed| NamedContact {
        name: "pads".to_owned(),
        sides: ContactSides {
            from: Node::Mass(0),
            to: Node::Wall,
        },
        law: JointLaw {
            speed,
            ..JointLaw::default()
        },
    };
    let unites = |scene: &Scene| {
        let mut united = scene.clone();
        united.unite();
        united.joints.is_empty()
    };
    scene.joints.contacts = vec![contact(0.0)];
    assert!(unites(&scene));
    for speed in [0.1, -0.1, f64::NAN] {
        scene.joints.contacts = vec![contact(speed)];
        assert!(!unites(&scene), "{speed}");
    }
    scene.joints.contacts = vec![contact(0.0)];
    let mut other = scene.clone();
    let rigid = Impact::Restitution(0.5);
    other.joints.stops = vec![stop("bumper", Node::Mass(0), Node::Wall, 0.1, rigid)];
    assert!(!unites(&other));
    scene.joints.constant = vec![ConstantForce {
        mass: 0,
        force: 0.0,
    }];
    assert!(!unites(&scene));
}
