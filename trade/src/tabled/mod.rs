//! Scenes of a declared accuracy: limits and the contact's amplitude from tables.

mod scenes;

use crate::methods::{Fill, Method};
use crate::scenes::Label;
use frictiongen::System;
use frictiongen::study::scene::Side;
use frictiongen::study::table::{Request, TableError, Tables};

/// The frequency ratios of the tables.
const RANGE: (f64, f64) = (0.2, 2.5);
/// The exponent of the accuracy that not every scene can have; its tables are built at run time.
pub const FINEST: u8 = 12;
/// The exponent of the accuracy that is spoken of most.
pub const USUAL: u8 = 4;

/// What a table takes.
#[derive(Clone, Copy, Debug)]
pub struct Figures {
    /// Pieces, buckets, zeros and poles.
    pub bytes: usize,
    /// How many pieces.
    pub pieces: usize,
    /// How many comparisons find a piece.
    pub comparisons: u32,
}

/// One table of a scene.
pub struct Tabled {
    /// The accuracy is 10 to the minus this.
    pub exponent: u8,
    /// What is asked of it.
    pub method: Method,
    /// Its answers.
    pub fill: Fill<f64>,
    /// What it takes.
    pub figures: Figures,
}

/// Why the finest accuracy cannot be had in a scene.
#[derive(Clone, Copy, Debug)]
pub struct Refused {
    /// The scene.
    pub label: Label,
    /// Where it fails.
    pub at: f64,
    /// The finest that can be met.
    pub reached: Option<f64>,
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

/// The tables of a scene, emitted but for the finest, and why that cannot be had.
pub fn of(label: &Label, system: &System) -> (Vec<Tabled>, Option<Refused>) {
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
    // For as long as the program runs: jobs own what they call.
    let system: &'static System = Box::leak(Box::new(system.clone()));
    let refused = match system.compile_for(request(FINEST, false)) {
        Ok(built) => {
            all.push(Tabled {
                exponent: FINEST,
                method: Method::Limits,
                figures: figures(built.tables()),
                fill: scenes::both(built),
            });
            None
        }
        Err(TableError::NotMet { at, reached, .. }) => Some(Refused {
            label: *label,
            at,
            reached,
        }),
        // A request that makes sense has no other error.
        Err(_) => None,
    };
    (all, refused)
}
