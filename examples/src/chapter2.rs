//! Chapter 2: one mass against a fixed wall, Den Hartog's problem.
//! `cargo run --release --example chapter2`

use frictiongen::friction_system;
use frictiongen_examples::album::Album;
use frictiongen_examples::figure::Figure;
use frictiongen_examples::panels::{Sweep, cycle, regimes};
use frictiongen_examples::scene;
use frictiongen_examples::scene::{Measure, Of};
use std::error::Error;
use std::f64::consts::TAU;

friction_system! {
    /// A loaded block on a spring rubs on a fixed wall.
    pub struct Block {
        masses: { block: 1.0 },
        springs: { base - block: 1.0 },
        contact: block - wall,
        excitation: block,
        provide: [limits, motion, stuck, orbit, simulation],
    }
}

friction_system! {
    /// The same with a dashpot, ζ = 0.2.
    pub struct Damped {
        masses: { block: 1.0 },
        springs: { base - block: 1.0 },
        contact: block - wall,
        excitation: block,
        damping: modal(0.2),
        provide: [limits, motion, stuck, orbit, simulation],
    }
}

scene!(Block, Damped);

const BLOCK: Of = Of::Mass(0);

fn main() -> Result<(), Box<dyn Error>> {
    let mut album = Album::open(4)?;
    let sweep = Sweep {
        scene: &Block,
        from: 0.0,
        to: 2.5,
        betas: &[0.0, 0.2, 0.4, 0.6, 0.8],
        measure: Measure::Peak,
        markers: 0.0,
        beyond: false,
    };
    Figure::new(
        "2.4",
        "continuous response of one mass against a fixed wall",
        2,
        vec![
            sweep.amplitude("(a) amplitude", "X̄", BLOCK, 5.0),
            sweep.lag("(b) phase", "lag, degrees", BLOCK, -90.0, 180.0),
        ],
    )
    .save(&mut album)?;
    Figure::new(
        "2.5",
        "motion regimes against a fixed wall",
        1,
        vec![regimes("μ = 1", &Block, 2.5, 1.2)],
    )
    .save(&mut album)?;
    Figure::new(
        "2.6",
        "a response with two stops, r = 0.6, β = 0.6",
        1,
        vec![cycle(
            "r = 0.6, β = 0.6",
            &Block,
            (0.6, 0.6),
            &[("block x̄", BLOCK)],
            (TAU, 1.5),
        )],
    )
    .save(&mut album)?;
    let damped = Sweep {
        scene: &Damped,
        betas: &[0.0, 0.1, 0.2, 0.3, 0.4, 0.5],
        ..sweep
    };
    Figure::new(
        "2.7",
        "with viscous damping as well, ζ = 0.2",
        1,
        vec![damped.amplitude("ζ = 0.2", "X̄", BLOCK, 3.0)],
    )
    .save(&mut album)?;
    album.close()
}
