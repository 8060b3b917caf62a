//! Chapter 4: the theory curves of the one-storey rig, by the first harmonic.
//! `cargo run --release --example chapter4`

use frictiongen::friction_system;
use frictiongen_examples::album::Album;
use frictiongen_examples::figure::Figure;
use frictiongen_examples::panels::Sweep;
use frictiongen_examples::scene;
use frictiongen_examples::scene::{Measure, Of};
use std::error::Error;

friction_system! {
    /// The storey rubs on a disc that stands still.
    pub struct Fixed {
        masses: { plate: 1.0 },
        springs: { base - plate: 1.0 },
        contact: plate - wall,
        excitation: base,
        provide: [limits, motion, stuck, orbit, simulation],
    }
}

friction_system! {
    /// The disc moves with the base.
    pub struct Joined {
        masses: { plate: 1.0 },
        springs: { base - plate: 1.0 },
        contact: plate - base,
        excitation: base,
        provide: [limits, motion, stuck, orbit, simulation],
    }
}

scene!(Fixed, Joined);

fn main() -> Result<(), Box<dyn Error>> {
    let mut album = Album::open(2)?;
    let plate = Of::Mass(0);
    let fixed = Sweep {
        scene: &Fixed,
        from: 0.0,
        to: 2.5,
        betas: &[0.2, 0.4, 0.6],
        measure: Measure::Fundamental,
        markers: 0.1,
        beyond: true,
    };
    let joined = Sweep {
        scene: &Joined,
        betas: &[0.5, 0.75, 1.0, 2.0],
        ..fixed
    };
    for (number, title, sweep) in [
        ("4.7", "one storey, fixed wall, first harmonic", fixed),
        (
            "4.9",
            "one storey, joined base and wall, first harmonic",
            joined,
        ),
    ] {
        Figure::new(
            number,
            title,
            2,
            vec![
                sweep.amplitude("(a) transmissibility", "X̄", plate, 5.0),
                sweep.lag("(b) phase", "lag, degrees", plate, -90.0, 180.0),
            ],
        )
        .save(&mut album)?;
    }
    album.close()
}
