//! The amplitude to be made small, at one frequency and one friction ratio.

use crate::study::physical::swing;
use crate::study::sensitivity::Varied;
use crate::study::system::System;
use crate::study::{Sensitive, SystemResponse};
use crate::{Error, NoOrbit, NotContinuous, Of, Regime};
use std::cell::Cell;

/// How much friction there is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Friction {
    /// β.
    Ratio(f64),
    /// So much that the contact never slides.
    Locked,
}

/// The amplitude of one motion of a system.
pub(super) struct Amplitude<'s> {
    pub system: &'s System,
    pub of: Of,
    unvaried: Varied,
    /// How often it has been asked for.
    pub asked: Cell<usize>,
    /// How often there was no answer.
    pub silent: Cell<usize>,
}

impl<'s> Amplitude<'s> {
    pub(super) fn new(system: &'s System, of: Of) -> Self {
        Self {
            system,
            of,
            unvaried: system.unvaried(),
            asked: Cell::new(0),
            silent: Cell::new(0),
        }
    }

    fn response(&self, r: f64, friction: Friction) -> Result<SystemResponse<'s>, Error> {
        let at = self.system.at(r)?;
        match friction {
            Friction::Ratio(beta) => at.response(beta),
            Friction::Locked => Ok(SystemResponse::Stuck(at.stuck()?)),
        }
    }

    /// The amplitude over P/k₁, for base motion over Y; infinite on a resonance that nothing bounds, NaN where there is no
    /// answer.
    pub(super) fn at(&self, r: f64, friction: Friction) -> f64 {
        self.asked.set(self.asked.get() + 1);
        let found = self.response(r, friction).map(|response| {
            let swing = response.swing(self.of);
            swing.map_or(f64::NAN, |swing| swing.amplitude)
        });
        match found {
            Ok(amplitude) => amplitude,
            Err(
                Error::NotContinuous(NotContinuous::Unbounded)
                | Error::NoOrbit(NoOrbit::Unbounded)
                | Error::StuckResonance(_),
            ) => f64::INFINITY,
            Err(_) => {
                self.silent.set(self.silent.get() + 1);
                f64::NAN
            }
        }
    }

    /// What the contact does.
    pub(super) fn regime(&self, r: f64, friction: Friction) -> Regime {
        self.response(r, friction)
            .map_or(Regime::Stuck, |response| response.regime())
    }

    /// Exact derivatives with respect to r and β, where there are such.
    pub(super) fn slopes(&self, r: f64, beta: f64) -> Option<[f64; 2]> {
        let response = self.response(r, Friction::Ratio(beta)).ok()?;
        let (fixed_r, fixed_beta) = (Sensitive::fixed(r.into()), Sensitive::fixed(beta.into()));
        let slope = |r: Sensitive, beta: Sensitive| {
            let known = swing(&self.unvaried, &response, (r, beta), self.of, false);
            let slope = known.ok()?.0.slope.to_f64();
            slope.is_finite().then_some(slope)
        };
        Some([
            slope(Sensitive::variable(r.into()), fixed_beta)?,
            slope(fixed_r, Sensitive::variable(beta.into()))?,
        ])
    }
}
