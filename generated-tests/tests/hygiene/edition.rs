//! A user's crate, which is compiled with every edition.
#![no_std]
#![deny(
    warnings,
    missing_docs,
    unused,
    nonstandard_style,
    rust_2018_idioms,
    future_incompatible
)]
#![deny(
    unreachable_pub,
    unused_qualifications,
    unused_results,
    unused_lifetimes
)]
#![deny(
    missing_debug_implementations,
    missing_copy_implementations,
    single_use_lifetimes
)]
#![forbid(unsafe_code)]

friction::friction_system! {
    /// A damped scene that is emitted as straight-line code.
    pub struct Frame {
        crate: ::friction,
        masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 },
        contact: upper - wall,
        excitation: base,
        damping: modal[0.010, 0.012],
        stiction: 1.2,
        provide: [limits, motion, stuck, orbit, simulation, stepper, self_check],
    }
}

friction::friction_system! {
    /// A scene in single precision that is emitted as loops over the modes ("passes").
    pub struct Five {
        crate: ::friction,
        masses: { a: 1.0, b: 1.0, c: 1.0, d: 1.0, e: 1.0 },
        springs: { base - a: 1.0, a - b: 1.0, b - c: 1.0, c - d: 1.0, d - e: 1.0 },
        contact: b - d,
        excitation: c,
        scalar: f32,
        provide: [limits, motion, stuck, orbit, simulation, stepper, self_check],
    }
}

/// One mass that rubs on the moving base, without a doc comment of its own.
pub mod block {
    friction::friction_system! {
        pub struct Block {
            crate: friction,
            masses: { block: 1.0 },
            springs: { base - block: 1.0 },
            contact: block - base,
            excitation: base,
        }
    }
}

/// Returns the largest displacement of the upper floor.
///
/// # Errors
/// Fails if the contact stops.
pub fn upper_floor(r: f64, beta: f64) -> Result<f64, friction::Error> {
    Ok(Frame::at(r)?.motion(beta)?.upper().amplitude())
}

#[test]
fn answers() {
    assert!(upper_floor(0.9, 0.3).map_or(false, |amplitude| amplitude > 0.1));
    assert!(Five::at(0.5).map_or(false, |at| at.sliding_limit() > 0.0));
    assert!(block::Block::at(0.5).map_or(false, |at| at.sliding_limit() > 0.0));
}
