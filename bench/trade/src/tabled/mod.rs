//! Scenes of a declared accuracy. Their limits and the amplitude of their contact come from tables.

mod scenes;

use crate::methods::{Fill, Method};
use crate::scenes::Label;
use frictiongen::System;
use frictiongen::study::scene::Side;
use frictiongen::study::table::{Request, Tables};

/// Range of frequency ratios r that the tables cover.
const RANGE: (f64, f64) = (0.2, 2.5);
/// The number n of the finest accuracy 10⁻ⁿ. Not every scene can reach it. Its tables are built at run time.
pub const FINEST: u8 = 12;
/// The number n of the accuracy 10⁻ⁿ of the tables that also contain the motion of the contact.
pub const USUAL: u8 = 4;

/// Size of a table, and number of comparisons of a look-up.
#[derive(Clone, Copy, Debug)]
pub struct Figures {
    /// Number of bytes of the table: those of its pieces, buckets, zeros and poles.
    pub bytes: usize,
    /// Number of pieces of the table.
    pub pieces: usize,
    /// Number of comparisons by which a look-up finds a piece.
    pub comparisons: u32,
}

/// One table of a scene.
pub struct Tabled {
    /// The number n of the table's accuracy 10⁻ⁿ.
    pub exponent: u8,
    /// Quantity that the table contains.
    pub method: Method,
    /// Function that evaluates the table.
    pub fill: Fill<f64>,
    /// Size of the table, and the cost of a look-up.
    pub figures: Figures,
}

fn request(exponent: u8, motion: bool) -> Request {
    Request {
        r: RANGE,
        accuracy: format!("1e-{exponent}").parse().expect("a number"),
        side: Side::Near,
        motion,
        stuck: false,
    }
}

fn figures(tables: &Tables<f64>) -> Figures {
    Figures {
        bytes: tables.report.bytes,
        pieces: tables.pieces.len(),
        comparisons: tables.index.halvings,
    }
}

/// Returns the tables of a scene. All tables except the finest are emitted. Prints the reason if the scene has no
/// tables of the finest accuracy.
pub fn of(label: &Label, system: &System) -> Vec<Tabled> {
    let (limits, contact) = scenes::emitted(label.name, label.zeta > 0.0).expect("a scene");
    let figures_of = |exponent, motion| {
        let built = system.compile_for(request(exponent, motion));
        figures(built.expect("emitted").tables())
    };
    let mut all: Vec<Tabled> = limits
        .into_iter()
        .map(|(exponent, fill)| Tabled {
            exponent,
            method: Method::Limits,
            fill,
            figures: figures_of(exponent, false),
        })
        .collect();
    all.push(Tabled {
        exponent: USUAL,
        method: Method::Contact,
        fill: contact,
        figures: figures_of(USUAL, true),
    });
    // Jobs need functions that live as long as the program. The leaked system does.
    let system: &'static System = Box::leak(Box::new(system.clone()));
    match system.compile_for(request(FINEST, false)) {
        Ok(built) => all.push(Tabled {
            exponent: FINEST,
            method: Method::Limits,
            figures: figures(built.tables()),
            fill: scenes::both(built),
        }),
        Err(error) => eprintln!("no table of 1e-{FINEST}: {error}"),
    }
    all
}
