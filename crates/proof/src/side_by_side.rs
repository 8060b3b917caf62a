//! Computes the answers to a list of questions in parallel, with as many threads as the machine can run
//! simultaneously.
//!
//! The result does not depend on the number of threads. It contains the answers in the order of the questions, until
//! their work reaches the permitted work.

use std::num::NonZero;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread::{self, Builder};

/// Data that the threads share.
struct Shared<A> {
    /// Index of the next question that no thread has taken yet.
    next: usize,
    /// The answers, each with the work that it took. `None` for a question that has no answer yet.
    answers: Vec<Option<(usize, A)>>,
    /// Number of answers before the first missing answer (`known`), and the work that they took (`spent`).
    known: usize,
    spent: usize,
}

impl<A> Shared<A> {
    /// Returns the index of the next question for a thread. Returns `None` if no question is left, or if the
    /// permitted work `most` is spent.
    fn question(&mut self, count: usize, most: usize) -> Option<usize> {
        if self.next == count || most <= self.spent {
            return None;
        }
        self.answers.push(None);
        self.next += 1;
        Some(self.next - 1)
    }

    /// Stores the answer to the question with the index `place`, and the work that it took.
    fn take(&mut self, place: usize, answer: Option<(usize, A)>) {
        if let Some(own) = self.answers.get_mut(place) {
            *own = answer;
        }
        while let Some(Some((work, _))) = self.answers.get(self.known) {
            self.known += 1;
            self.spent += work;
        }
    }

    /// Returns the answers before the first missing one, until their work reaches the permitted work `most`.
    fn counted(self, most: usize) -> Vec<A> {
        let mut spent = 0;
        let known = self.answers.into_iter().map_while(|answer| answer);
        let counted = known.take_while(|(work, _)| {
            let counts = spent < most;
            spent += work;
            counts
        });
        counted.map(|(_, answer)| answer).collect()
    }
}

/// Locks the data that the threads share, even if another thread has panicked. The panic of a thread ends the whole
/// call, so that the data is not used afterwards.
fn locked<T>(shared: &Mutex<T>) -> MutexGuard<'_, T> {
    shared.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Computes the answers to `questions` in parallel, and returns them in the order of the questions. The list ends when
/// the work of the answers so far reaches `most`, or at a question without an answer.
///
/// `begin` creates the data that a thread needs. `one` returns the answer to a question, with the work that it took.
pub(crate) fn answered<State, A: Send>(
    questions: &[usize],
    most: usize,
    begin: impl Fn() -> State + Sync,
    one: impl Fn(&mut State, usize) -> Option<(usize, A)> + Sync,
) -> Vec<A> {
    let threads = thread::available_parallelism().map_or(1, NonZero::get);
    answered_by(threads, questions, most, begin, one)
}

fn answered_by<State, A: Send>(
    threads: usize,
    questions: &[usize],
    most: usize,
    begin: impl Fn() -> State + Sync,
    one: impl Fn(&mut State, usize) -> Option<(usize, A)> + Sync,
) -> Vec<A> {
    let shared = Mutex::new(Shared {
        next: 0,
        answers: Vec::new(),
        known: 0,
        spent: 0,
    });
    let work = || {
        let mut state = begin();
        loop {
            let Some(place) = locked(&shared).question(questions.len(), most) else {
                return;
            };
            let question = questions.get(place).copied();
            let answer = question.and_then(|question| one(&mut state, question));
            locked(&shared).take(place, answer);
        }
    };
    thread::scope(|scope| {
        for _ in 1..threads.min(questions.len()) {
            // If no further thread can start, the current thread does all the work.
            if Builder::new().spawn_scoped(scope, work).is_err() {
                break;
            }
        }
        work();
    });
    let shared = shared.into_inner().unwrap_or_else(PoisonError::into_inner);
    shared.counted(most)
}

#[cfg(test)]
mod tests {
    use super::answered_by;
    use std::sync::atomic::{AtomicUsize, Ordering};
    use std::time::Duration;

    /// Checks that the result depends neither on the number of threads, nor on the order in which they finish.
    #[test]
    fn as_many_as_one_thread_would() {
        let questions: Vec<usize> = (3..40).collect();
        for most in [0, 1, 7, 100, 1_000_000] {
            let asked = |threads| {
                let asked = AtomicUsize::new(0);
                let one = |own: &mut usize, question: usize| {
                    asked.fetch_add(1, Ordering::Relaxed);
                    *own += 1;
                    let work = question * 7 % 11;
                    std::thread::sleep(Duration::from_micros(50 * work as u64));
                    Some((work, question * question))
                };
                let answers = answered_by(threads, &questions, most, || 0, one);
                (answers, asked.into_inner())
            };
            let (alone, needed) = asked(1);
            let mut spent = 0;
            let expected = questions.iter().take_while(|question| {
                let counts = spent < most;
                spent += *question * 7 % 11;
                counts
            });
            let expected: Vec<usize> = expected.map(|question| question * question).collect();
            assert_eq!(alone, expected, "{most}");
            assert_eq!(needed, alone.len(), "{most}");
            for threads in [2, 3, 8, 100] {
                let (together, needed) = asked(threads);
                assert_eq!(together, alone, "{most}, {threads} threads");
                // If the permitted work is spent early, the code does not take all questions.
                assert!(
                    needed <= alone.len() + 37.min(12 * threads),
                    "{most}, {threads} threads: {needed}"
                );
            }
        }
    }

    /// Checks that a question without an answer ends the list, as with one thread.
    #[test]
    fn up_to_a_gap() {
        let one = |_: &mut (), question: usize| (question != 5).then_some((1, question));
        for threads in [1, 4] {
            let answers = answered_by(threads, &[1, 3, 5, 7], 100, || (), one);
            assert_eq!(answers, [1, 3]);
        }
    }
}
