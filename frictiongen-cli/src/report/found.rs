//! What a motion does at one frequency and one friction, and questions asked at once.

use super::asked::Asked;
use frictiongen::study::{Swing, SystemResponse, units};
use frictiongen::{Error, Of, Regime};

/// So much friction that nothing slides but beside a resonance of the chain with its contact stuck.
pub const STUCK: f64 = 1e9;

/// Regime, amplitude and phase, or why there are none.
pub type Found = Result<(Regime, Swing), Error>;

/// At one frequency and one friction; with the contact stuck at any frequency if that is [`STUCK`].
pub fn found(asked: &Asked, r: f64, beta: f64, of: Of) -> Found {
    let at = asked.system.at(r)?;
    let rest = Swing::REST;
    if beta == STUCK {
        let stuck = at.stuck()?;
        let swing = match of {
            Of::Contact => rest,
            Of::Mass(index) => stuck.mass_at(index).map_or(rest, |harmonic| {
                let (amplitude, phase) = units::polar(harmonic);
                Swing {
                    amplitude,
                    phase: (0.0 < amplitude).then_some(phase),
                }
            }),
        };
        return Ok((Regime::Stuck, swing));
    }
    let response = at.response(beta)?;
    let turned = asked.words.measure.turns_contact() && of == Of::Contact;
    let mut swing = response.swing(of).unwrap_or(rest);
    if turned {
        swing.phase = swing.phase.map(|phase| match &response {
            SystemResponse::StickSlip(orbit) => orbit.reversed_contact_phase(),
            _ => units::reversed_phase(phase),
        });
    }
    Ok((response.regime(), swing))
}

/// Answers questions at once, each in a thread: they take seconds, and there are a few.
pub fn at_once<Q: Send, A: Send>(questions: Vec<Q>, answer: impl Fn(Q) -> A + Sync) -> Vec<A> {
    let answer = &answer;
    std::thread::scope(|scope| {
        let threads = questions
            .into_iter()
            .map(|question| scope.spawn(move || answer(question)));
        let threads: Vec<_> = threads.collect();
        let answers = threads.into_iter().map(|thread| match thread.join() {
            Ok(answer) => answer,
            // As if it had been answered here.
            Err(panic) => std::panic::resume_unwind(panic),
        });
        answers.collect()
    })
}
