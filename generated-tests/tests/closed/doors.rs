//! Tests a description in a file, a description within a function, and several descriptions in one module.

use frictiongen::{System, friction_system};
use generated_tests::shown::Braced;

mod from_file {
    frictiongen::friction_system!("scenes/braced.friction");
}

/// Checks that a description in a file gives the same solver as the same scene in the source: their limits are
/// exactly equal.
#[test]
fn a_file_is_a_description() {
    let mut compared = 0;
    for r in [0.3, 1.1, 4.0] {
        let at = from_file::BracedFile::at(r).expect("in the domain");
        let in_place = Braced::at(r).expect("in the domain");
        assert_eq!(at.continuous_limit(), in_place.continuous_limit());
        assert_eq!(at.sliding_limit(), in_place.sliding_limit());
        compared += 2;
    }
    println!("{compared} values compared, none skipped");
    assert_eq!(compared, 3 * 2);
    let text = include_str!("../../scenes/braced.friction");
    let system: System = text.parse().expect("a valid scene");
    let at = system.at(0.3).expect("in the domain");
    assert_eq!(
        at.continuous_limit(),
        Braced::at(0.3).expect("in the domain").continuous_limit()
    );
}

#[test]
fn a_scene_inside_a_function() {
    friction_system! {
        struct Local {
            masses: { block: 1.0 },
            springs: { base - block: 1.0 },
            contact: block - wall,
            excitation: block,
        }
    }
    let limit = Local::at(1.0).expect("in the domain").continuous_limit();
    assert!((limit - std::f64::consts::FRAC_PI_4).abs() < 1e-15);
}
