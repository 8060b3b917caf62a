//! Tests of zeros, lookups and digits. The crate `generated-tests` compares whole tables.

use super::digits::{above, to_decimals};
use super::evidence::Evidence;
use super::zeros::Zeros;
use super::{Fitted, Request, TableError, Tables};
use crate::modal::Modal;
use crate::scene::{
    CONTACT, ContactSides, Damping, Declared, Excitation, FrictionLaw, Mass, Node, Precision,
    Provide, Scene, Side, Spring, StepperOptions,
};
use frictiongen_kernel::table::{Piece, Table};

/// Returns a chain of equal masses and springs. The load acts on the last mass, and the contact joins the first two.
fn chain(count: usize, damping: Damping) -> Scene {
    let mass = |index: usize| Mass {
        name: format!("m{index}"),
        value: 1.0,
    };
    let spring = |mass: usize| Spring {
        from: mass.checked_sub(1).map_or(Node::Base, Node::Mass),
        to: Node::Mass(mass),
        stiffness: 1.0,
    };
    Scene {
        name: "Chain".to_owned(),
        masses: (0..count).map(mass).collect(),
        springs: (0..count).map(spring).collect(),
        contact: ContactSides {
            from: Node::Mass(0),
            to: Node::Mass(1),
        },
        contact_name: CONTACT.to_owned(),
        excitation: Excitation::Force(count - 1),
        damping,
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

fn request(r: (f64, f64), accuracy: f64) -> Request {
    Request {
        r,
        accuracy,
        side: Side::Near,
        motion: false,
        stuck: false,
    }
}

/// Checks the zeros of chains of equal masses. At r² = 1 the first two masses move alike, whatever masses follow in the
/// chain.
#[test]
fn zeros_of_equal_masses() {
    for count in [2, 3, 5, 9] {
        let zeros = Zeros::of(&Modal::of(&chain(count, Damping::None))).expect("told apart");
        let places: Vec<f64> = zeros
            .excitation
            .iter()
            .map(|zero| zero.y.to_f64())
            .collect();
        assert_eq!(places.len(), 1, "{count} masses: {places:?}");
        assert!((places[0] - 1.0).abs() < 1e-28, "{places:?}");
        // H, the receptance of the contact, has one zero between each two neighbouring resonances.
        assert_eq!(zeros.receptance.len() + zeros.common.len(), count - 1);
        assert_eq!(zeros.loaded.len() + zeros.unloaded.len(), count);
    }
}

#[test]
fn damped_zeros_lie_beside_the_axis() {
    let zeros = Zeros::of(&Modal::of(&chain(5, Damping::Uniform(0.02)))).expect("told apart");
    let beside = |zero: &super::zeros::Zero| zero.x.to_f64() < 0.0 && !zero.is_on_axis();
    assert!(zeros.receptance.iter().all(beside));
    assert!(zeros.loaded.iter().all(beside));
}

/// Returns a fitted piece in arrays, as emitted code has it, for a table of β_lim to an accuracy of 1e-4.
fn piece(fitted: &Fitted<f64>) -> Piece<f64, 1, 6> {
    let of = fitted.coefficients[0].as_slice();
    Piece {
        from: fitted.from,
        origin: fitted.origin,
        coefficients: [of.try_into().expect("degree 5")],
    }
}

/// Checks that a lookup finds the piece that contains r, for every r. The test includes bounds of the range, boundaries
/// of pieces and their neighbouring numbers.
#[test]
fn every_r_finds_its_piece() {
    for count in [2, 5] {
        let modal = Modal::of(&chain(count, Damping::None));
        let tables = Tables::<f64>::build(&modal, request((0.2, 2.5), 1e-4)).expect("a table");
        let index = &tables.index;
        let pieces: Vec<Piece<f64, 1, 6>> = tables.pieces.iter().map(piece).collect();
        let table = Table {
            low: index.low,
            density: index.density,
            halvings: index.halvings,
            buckets: &index.buckets,
            pieces: &pieces,
        };
        let found = |r: f64| {
            let from = table.piece(r).expect("a piece").from;
            pieces.iter().position(|piece| piece.from == from)
        };
        let mut looked = 0;
        for (place, piece) in tables.pieces.iter().enumerate() {
            assert_eq!(found(piece.from), Some(place));
            if place > 0 {
                assert_eq!(found(piece.from.next_down()), Some(place - 1));
            }
            let next = tables.pieces.get(place + 1).map_or(2.5, |next| next.from);
            for k in 1..50 {
                let r = piece.from + (next - piece.from) * f64::from(k) / 50.0;
                assert_eq!(found(r), Some(place));
                looked += 1;
            }
        }
        assert!(looked >= 49 * tables.pieces.len());
        assert!(index.halvings <= 4, "{}", index.halvings);
    }
}

#[test]
fn digits() {
    assert_eq!(to_decimals(1.234_567, 1e-3), 1.235);
    assert_eq!(to_decimals(123_456.0, 100.0), 123_500.0);
    assert_eq!(to_decimals(1.0 / 3.0, 1e-60), 1.0 / 3.0);
    for value in [1.0_f64, 0.2, 1.999_999, 0.500_000_1, 3e-5] {
        let next: f32 = above(value);
        assert!(f64::from(next) > value);
        assert!(f64::from(next.next_down()) <= value);
        assert_eq!(above::<f64>(value), value.next_up());
    }
}

#[test]
fn what_cannot_be_had() {
    let modal = Modal::of(&chain(5, Damping::None));
    let build = |request| Tables::<f64>::build(&modal, request).map(|_| ());
    assert_eq!(
        build(request((0.0, 1.0), 1e-3)),
        Err(TableError::Range(0.0, 1.0))
    );
    assert_eq!(
        build(request((2.0, 1.0), 1e-3)),
        Err(TableError::Range(2.0, 1.0))
    );
    assert!(build(request((0.5, f64::INFINITY), 1e-3)).is_err());
    for accuracy in [0.0, 1.0, 1e-20, f64::NAN, -1e-3] {
        let error = build(request((0.5, 1.0), accuracy)).expect_err("no accuracy");
        assert!(matches!(error, TableError::Accuracy { .. }), "{error}");
    }
    let too_few = Tables::<f64>::within(&modal, request((0.2, 2.5), 1e-3), 64);
    let error = too_few.expect_err("too few bytes").to_string();
    assert!(error.contains("no table fits into 64 bytes"), "{error}");
}

/// Checks that a larger budget of bytes never gives a coarser accuracy.
#[test]
fn a_budget_of_bytes() {
    let modal = Modal::of(&chain(2, Damping::Uniform(0.02)));
    let mut last = 1.0;
    for bytes in [1200, 2400, 4800, 9600] {
        let request = request((0.3, 2.0), 0.1);
        let tables = Tables::<f64>::within(&modal, request, bytes).expect("a table");
        assert!(tables.report.bytes <= bytes);
        assert!(tables.request.accuracy < last, "{bytes} bytes");
        last = tables.request.accuracy;
    }
}

/// Checks that |V|, the amplitude of the contact without friction, becomes a product if its polynomials need too many
/// bytes.
#[test]
fn a_budget_below_the_polynomials() {
    let modal = Modal::of(&chain(2, Damping::Uniform(0.02)));
    let request = Request {
        motion: true,
        ..request((0.3, 2.0), 0.1)
    };
    let tabled = Tables::<f64>::build(&modal, request).expect("tables");
    let bytes = tabled.report.bytes - 1;
    let tables = Tables::<f64>::within(&modal, request, bytes).expect("smaller ones");
    assert!(tables.report.bytes <= bytes);
}

/// Checks scenes whose damping acts relative to the moving base. Each has tables, and β*_lim as a product. The products
/// are proven, except for a contact that slides on the base. Its double zero at s = 0 has no proof.
#[test]
fn damping_from_the_base_has_tables() {
    for (kind, count, zeta, stiction) in [
        ("Shaken", 1, 0.2, 1.0),
        ("Shaken", 5, 0.02, 1.2),
        ("Shaken", 2, 1.7, 1.0),
        ("Apart", 3, 0.3, 1.0),
        ("Apart", 5, -0.02, 1.2),
        ("Carried", 2, 0.02, 1.2),
    ] {
        let modal = crate::samples::scene(kind, count, zeta, stiction);
        for motion in [false, true] {
            let asked = Request {
                motion,
                ..request((0.2, 2.5), 1e-3)
            };
            let tables = Tables::<f64>::build(&modal, asked).expect("tables");
            assert!(tables.sliding.is_some(), "{kind}{count}");
            assert_eq!(tables.moves(), motion, "{kind}{count}");
            let expected = match kind {
                "Carried" => Evidence::Checked,
                _ => Evidence::Proven,
            };
            let found = tables.sliding_proof.evidence;
            assert_eq!(found, expected, "{kind}{count}");
        }
    }
}
