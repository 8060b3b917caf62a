//! Counts the results for each kind of answer, and the points that the test leaves out.

use crate::backward::judge::{Answer, Judged, Verdict};
use std::collections::BTreeMap;

/// Condition number up to which the tally records the worst error of all answers together.
const ORDINARY: f64 = 100.0;

/// Results for one kind of answer.
#[derive(Default)]
struct Kind {
    count: u64,
    /// Number of answers whose backward error, with the answer taken alone, exceeds the accepted error.
    above: u64,
    /// Number of answers of far masses whose error exceeds the accepted error. The size that measures the error is
    /// the answer itself, or a thousandth of the largest motion if that is larger.
    far: u64,
    direct: Worst,
    of_its_own: Worst,
    alone: Worst,
}

/// The worst error so far, and the point where it occurred.
#[derive(Default)]
struct Worst(f64, String);

impl Worst {
    fn note(&mut self, value: f64, place: impl FnOnce() -> String) {
        if !(value <= self.0) {
            *self = Self(value, place());
        }
    }

    fn join(&mut self, other: Self) {
        self.note(other.0, || other.1);
    }
}

/// Results for all kinds of answers.
#[derive(Default)]
pub struct Tally {
    kinds: BTreeMap<&'static str, Kind>,
    pub scenes: u64,
    places: u64,
    worst: Worst,
    /// Worst backward error of all answers of a point together, among points with a condition number below
    /// [`ORDINARY`].
    together: Worst,
    /// Number of points whose answers are not exact for a common displacement of the inputs.
    disagreeing: u64,
    /// Points above the accepted error.
    pub above: Vec<String>,
    /// Number of points above the accepted error whose answers no displacement explains.
    pub wrong: u64,
    skipped: BTreeMap<&'static str, u64>,
}

impl Tally {
    pub fn note(
        &mut self,
        told: &[Answer],
        verdict: &Verdict,
        bar: f64,
        place: impl Fn() -> String,
    ) {
        self.places += 1;
        self.worst.note(verdict.alone, &place);
        if verdict.condition < ORDINARY {
            self.together.note(verdict.together, &place);
        }
        self.disagreeing += u64::from(!(verdict.together <= bar));
        self.wrong += u64::from(verdict.is_wrong());
        if !verdict.keeps(bar) {
            let mut line = format!(
                "{:.3e} alone, {:.3e} together, condition {:.1e}: {}",
                verdict.alone,
                verdict.together,
                verdict.condition,
                place()
            );
            for (answer, judged) in told.iter().zip(&verdict.answers) {
                if !(judged.direct <= bar) {
                    let Judged { direct, alone, .. } = judged;
                    let [got, exact] =
                        [answer.got, judged.exact].map(|z| (z.re.to_f64(), z.im.to_f64()));
                    line += &format!(
                        "\n    {:?}: {got:?} for {exact:?}, {direct:.2e}, by its inputs {alone:.2e}",
                        answer.watched
                    );
                }
            }
            println!("above {line}");
            self.above.push(line);
        }
        for (answer, judged) in told.iter().zip(&verdict.answers) {
            let asked = answer.watched.asked;
            let kind = self.kinds.entry(asked.kind()).or_default();
            kind.count += 1;
            kind.above += u64::from(!(judged.alone <= bar));
            kind.far += u64::from(judged.is_far(answer) && !(judged.strict <= bar));
            let place = || format!("{asked:?} at {}", place());
            kind.direct.note(judged.direct, place);
            kind.of_its_own.note(judged.of_its_own, place);
            kind.alone.note(judged.alone, place);
        }
    }

    pub fn skip(&mut self, reason: &'static str) {
        *self.skipped.entry(reason).or_default() += 1;
    }

    pub fn join(&mut self, other: Self) {
        self.scenes += other.scenes;
        self.places += other.places;
        self.worst.join(other.worst);
        self.together.join(other.together);
        self.disagreeing += other.disagreeing;
        self.wrong += other.wrong;
        self.above.extend(other.above);
        for (reason, count) in other.skipped {
            *self.skipped.entry(reason).or_default() += count;
        }
        for (name, of) in other.kinds {
            let kind = self.kinds.entry(name).or_default();
            kind.count += of.count;
            kind.above += of.above;
            kind.far += of.far;
            kind.direct.join(of.direct);
            kind.of_its_own.join(of.of_its_own);
            kind.alone.join(of.alone);
        }
    }

    pub fn answers(&self) -> u64 {
        self.kinds.values().map(|kind| kind.count).sum()
    }

    pub fn counts(&self) -> impl Iterator<Item = (&'static str, u64)> {
        self.kinds.iter().map(|(name, kind)| (*name, kind.count))
    }

    /// Returns three fractions of all points: points above the accepted error, points whose answers have no common
    /// displacement, and points whose answers no displacement explains.
    pub fn shares(&self) -> [f64; 3] {
        let counts = [
            self.above.len() as f64,
            self.disagreeing as f64,
            self.wrong as f64,
        ];
        counts.map(|count| count / self.places as f64)
    }

    pub fn print(&self, title: &str) {
        println!(
            "{title}: {} answers, {} places, {} scenes; {} places above, {} of them wrong altogether; worst {:.2} at {}",
            self.answers(),
            self.places,
            self.scenes,
            self.above.len(),
            self.wrong,
            self.worst.0,
            self.worst.1
        );
        println!(
            "all answers of a place together: worst {:.2} at {}; {} places without one displacement for all",
            self.together.0, self.together.1, self.disagreeing
        );
        for (name, kind) in &self.kinds {
            println!(
                "{name:>22}: {:>8} answers, {} above, {} far; roundings of the inputs {:.2} ({})",
                kind.count, kind.above, kind.far, kind.alone.0, kind.alone.1
            );
            println!(
                "{:>22}  forward {:.2e}, of its own {:.2e} ({})",
                "", kind.direct.0, kind.of_its_own.0, kind.of_its_own.1
            );
        }
        for (reason, count) in &self.skipped {
            println!("{:>22}: {count}", format!("skipped, {reason}"));
        }
    }
}
