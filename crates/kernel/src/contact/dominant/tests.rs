//! Tests of the choice of the dominant mode, and of the response V that serves as the reference for the phase of the
//! mode.
//!
//! The tests check the choice itself, because no result shows a wrong choice. A wrong choice causes only rounding
//! errors close to a resonance, where the rounding of r changes every result by more.

use super::{DominantSums, ModalTerms, Partner, Which};
use crate::contact::quadrature::InPhase;
use crate::contact::sums::{Chain, ContactAt, ModeAt};
use crate::number::complex::Complex;
use crate::oscillator::mode::{Kind, Mode};

fn chain(on_moving_base: Option<f64>) -> Chain<f64> {
    Chain {
        damped: false,
        on_moving_base,
        inverse_mass: 1.0,
        stiction: 1.0,
    }
}

/// Returns an undamped mode at twice the excitation frequency, with the mode's functions at this frequency. `terms` is
/// the mode's term in V (the response to the load), and also its term in U (the damping function).
fn mode(terms: f64) -> (Mode<f64>, ModeAt<f64>) {
    let mode = Mode {
        kind: Kind::Undamped,
        in_contact: true,
        resonance: 2.0,
        zeta: 0.0,
        q: 1.0,
        q_defect: 0.0,
        load: 1.0,
        contact: 1.0,
        residue: 1.0,
        contact_squared: 1.0,
        static_residue: 0.0,
    };
    let at = ModeAt {
        x: 2.0,
        response: Complex::new(terms, 0.0),
        u: terms,
        g: 0.0,
    };
    (mode, at)
}

fn contact(v: Complex<f64>) -> ContactAt<f64> {
    ContactAt {
        v,
        ..ContactAt::zero(1.0)
    }
}

/// Returns the index of the dominant mode of three modes, or `None` if no mode is dominant.
fn taken(terms: [f64; 3], on_moving_base: Option<f64>) -> Option<usize> {
    let mut modes = terms.map(mode);
    // On a moving base V contains the static residue instead of the residue, and v − 1 instead of the response v of a
    // mode.
    for (mode, at) in &mut modes {
        if on_moving_base.is_some() {
            (mode.static_residue, at.response) = (at.response.re, Complex::new(1.0, 0.0));
        }
    }
    let modes = modes.iter().map(|(mode, at)| (mode, *at));
    let all = contact(Complex::new(terms.iter().sum(), 0.0));
    let sums = chain(on_moving_base).dominant_sums((modes, InPhase), Partner::U, &all, 1.0);
    match sums.which {
        Which::Numbered(number) if number >= 0.0 => Some(number as usize),
        _ => None,
    }
}

#[test]
fn the_mode_that_outweighs_the_others() {
    assert_eq!(taken([1.0, 1e3, 1.0], None), Some(1));
    assert_eq!(taken([1e3, -1.0, 1.0], None), Some(0));
    assert_eq!(taken([1.0, 1.2, 1.0], None), None);
}

/// Checks the choice of the dominant mode on a moving base, where V has a static term. The static term must count among
/// the terms of the other modes.
#[test]
fn beside_what_stands_at_rest() {
    assert_eq!(taken([1.0, 1e3, 1.0], Some(1e3)), Some(1));
    assert_eq!(taken([1.0, 1e3, 1.0], Some(1e6)), None);
    assert_eq!(taken([1.0, 1e3, 1.0], Some(-1e6)), None);
}

/// Checks the reference for the phase of a mode. The reference is the smaller of two numbers: the full response V, or V
/// without the term of that mode. A mode is in phase with its own term of V.
#[test]
fn turned_against_what_the_others_leave() {
    let terms = |v| ModalTerms {
        v,
        ..ModalTerms::zero()
    };
    let (large, small) = (Complex::new(3e8, -4e8), Complex::new(0.1, 0.2));
    for (others, all, least) in [(small, large, small), (large, small, small)] {
        for which in [Which::Only, Which::First, Which::Numbered(1.0)] {
            let sums = DominantSums {
                which,
                own: terms(others),
                others: terms(all),
            };
            let (own, others) = sums.turning(&contact(all));
            assert_eq!((own, others), (least, all));
        }
    }
}
