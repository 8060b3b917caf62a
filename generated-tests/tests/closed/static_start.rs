//! Compares `quasi_static_start` with a linear solve of the chain: K x = p − βw while the contact slides.

use frictiongen::System;
use generated_tests::larger;
use nalgebra::{DMatrix, DVector};

/// A scene with its stiffness matrix divided by k₁, its load vector p, and the direction vector w of its contact.
struct Case {
    text: &'static str,
    stiffness: &'static [&'static [f64]],
    load: &'static [f64],
    contact: &'static [f64],
}

const CASES: [Case; 3] = [
    Case {
        text: "struct Chain {
            masses: { a: 1, b: 2, c: 0.5 },
            springs: { base - a: 2, a - b: 1, b - c: 3 },
            contact: b - wall,
            excitation: a,
        }",
        stiffness: &[&[1.5, -0.5, 0.0], &[-0.5, 2.0, -1.5], &[0.0, -1.5, 1.5]],
        load: &[1.0, 0.0, 0.0],
        contact: &[0.0, 1.0, 0.0],
    },
    Case {
        text: "struct Moved {
            masses: { a: 1, b: 1 },
            springs: { base - a: 1, a - b: 2, b - wall: 0.5 },
            contact: a - wall,
            excitation: base,
            damping: modal(0.03),
            stiction: 1.25,
        }",
        stiffness: &[&[3.0, -2.0], &[-2.0, 2.5]],
        load: &[1.0, 0.0],
        contact: &[1.0, 0.0],
    },
    Case {
        text: "struct Between {
            masses: { a: 1, b: 1 },
            springs: { base - a: 1, a - b: 0.25, b - wall: 2 },
            contact: a - b,
            excitation: b,
        }",
        stiffness: &[&[1.25, -0.25], &[-0.25, 2.25]],
        load: &[0.0, 1.0],
        contact: &[-1.0, 1.0],
    },
];

#[test]
fn starts_are_static_displacements() {
    let (mut compared, mut stuck, mut worst) = (0, 0, 0.0);
    for case in &CASES {
        let system: System = case.text.parse().expect("a scene");
        let n = case.load.len();
        let k = DMatrix::from_fn(n, n, |row, column| case.stiffness[row][column]);
        let k = k.lu();
        let (p, w) = (
            DVector::from_column_slice(case.load),
            DVector::from_column_slice(case.contact),
        );
        // The force in the stuck contact, divided by P, is wᵀK⁻¹p/wᵀK⁻¹w.
        let free = k.solve(&p).expect("a chain that is held");
        let by_contact = k.solve(&w).expect("a chain that is held");
        let holding = (w.dot(&free) / w.dot(&by_contact)).abs();
        let direction = w.dot(&free).signum();
        let sliding = holding / system.modal().stiction.to_f64();
        for step in 0..20 {
            let beta = 0.0625 * (f64::from(step) + 0.5) * sliding;
            let Some(start) = system.quasi_static_start(beta) else {
                assert!(
                    beta >= sliding * (1.0 - 1e-12),
                    "stuck at {beta} below {sliding}"
                );
                stuck += 1;
                continue;
            };
            assert!(
                beta <= sliding * (1.0 + 1e-12),
                "slides at {beta} beyond {sliding}"
            );
            let expected = &free - &by_contact * (beta * direction);
            for (found, expected) in start.iter().zip(expected.iter()) {
                worst = larger(worst, (found - expected).abs());
                compared += 1;
            }
        }
    }
    println!("{compared} values compared, worst {worst:.1e}; {stuck} of stuck contacts");
    // The displacements are of order 1 and the solve is well conditioned, so few digits are lost.
    assert!(worst < 1e-14);
    assert_eq!(compared, 16 * (3 + 2 + 2));
    assert_eq!(stuck, 3 * 4);
}
