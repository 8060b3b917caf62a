//! Tests that the check of a table detects a wrong table. One coefficient of the table is changed by ten times the
//! accuracy.

use super::scenes::scene;
use frictiongen::System;
use frictiongen::study::scene::Side;
use frictiongen::study::table::{Request, Tables};

#[test]
fn a_wrong_coefficient() {
    for (kind, count, damping) in [
        ("Wall", 1, "none"),
        ("Pair", 2, "none"),
        ("Wall", 5, "modal(0.02)"),
    ] {
        let system: System = scene(kind, count, damping, "1", "f64").parse().unwrap();
        for accuracy in [1e-2, 1e-4, 1e-6] {
            let request = Request {
                r: (0.2, 2.5),
                accuracy,
                side: Side::Near,
                motion: true,
                stuck: false,
            };
            let mut tables = Tables::<f64>::build(system.modal(), request).unwrap();
            let sound = tables.verify(system.modal());
            assert!(sound.error <= accuracy, "{}", sound.error);
            let functions = tables.functions;
            for place in 0..tables.pieces.len() {
                let next = tables.pieces.get(place + 1).map_or(2.5, |next| next.from);
                let piece = &tables.pieces[place];
                let middle = 0.5 * (piece.from + next);
                let t = middle - piece.origin;
                let far = t
                    .abs()
                    .max((next - piece.origin).abs())
                    .max((piece.from - piece.origin).abs());
                // The changed functions are β_lim, and |V| if the table contains it.
                for function in [0, 4].into_iter().filter(|place| *place < functions) {
                    let size = tables.pieces[place].value(function, middle).abs();
                    for power in 0..tables.terms {
                        let coefficient = tables.pieces[place].coefficients[function][power];
                        let wrong = 10.0 * accuracy * size / far.powi(power as i32);
                        tables.pieces[place].coefficients[function][power] = coefficient + wrong;
                        let found = tables.verify_piece(system.modal(), place);
                        assert!(
                            found.error > accuracy,
                            "{kind}{count} {accuracy:e}: coefficient {power} of function {function} of piece {place} passes with {:e}",
                            found.error
                        );
                        tables.pieces[place].coefficients[function][power] = coefficient;
                    }
                }
                if place > 4 {
                    break;
                }
            }
        }
    }
}
