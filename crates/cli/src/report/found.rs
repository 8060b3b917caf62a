//! Computes the motion at one frequency and one friction, and runs several computations in parallel.

use super::asked::ReportRequest;
use frictiongen::study::{
    response::{Swing, SystemResponse},
    units,
};
use frictiongen::{Error, Of, Regime};

/// Friction ratio β that is large enough to keep the contact stuck, except very close to a resonance of the stuck
/// chain.
pub const STUCK: f64 = 1e9;

/// Regime, amplitude and phase of a motion, or the reason why no motion was found.
pub type FoundMotion = Result<(Regime, Swing), Error>;

/// Returns the motion `of` at the frequency ratio `r` and the friction ratio `beta`. If `beta` is [`STUCK`], the
/// contact is stuck at every frequency.
pub fn found(asked: &ReportRequest, r: f64, beta: f64, of: Of) -> FoundMotion {
    let at = asked.system.at(r)?;
    let response = at.response(beta)?;
    let turned = asked.words.measure.turns_contact() && of == Of::Contact;
    let mut swing = response.swing(of).unwrap_or(Swing::REST);
    if turned {
        swing.phase = swing.phase.map(|phase| match &response {
            SystemResponse::StickSlip(orbit) => orbit.reversed_contact_phase(),
            _ => units::reversed_phase(phase),
        });
    }
    Ok((response.regime(), swing))
}

/// Returns a text with the meaning of the line styles in a picture.
pub fn line_styles(elastic: bool) -> &'static str {
    if elastic {
        "A dash-dotted line is motion in which the contact slides, and sticks after each reversal. A dotted line is a contact that never slides."
    } else {
        "A solid line is motion without stops, a dash-dotted line is motion with stops, and a dotted line is a stuck contact."
    }
}

/// Computes the answers to several questions in parallel. Each question has its own thread, because there are only a
/// few questions, and each question takes seconds.
pub fn at_once<Q: Send, A: Send>(questions: Vec<Q>, answer: impl Fn(Q) -> A + Sync) -> Vec<A> {
    let answer = &answer;
    std::thread::scope(|scope| {
        let threads = questions
            .into_iter()
            .map(|question| scope.spawn(move || answer(question)));
        let threads: Vec<_> = threads.collect();
        let answers = threads.into_iter().map(|thread| match thread.join() {
            Ok(answer) => answer,
            // If the thread of a question has panicked, the calling thread panics with the same message.
            Err(panic) => std::panic::resume_unwind(panic),
        });
        answers.collect()
    })
}
