//! Tables of the steady states of scenes with several contacts.

use super::branch::BranchPlace;
use super::builder::Columns;
use super::column::{Column, Head, Shown};
use super::measure::PhysicalQuantity;
use super::motion::{MotionRow, PartMotion, harmonics, phases};
use super::setting::{AtFriction, Frequency, FrictionSetting, MovingPart, Setting, at};
use super::steady::MotionGroups;
use crate::Regime;
use crate::study::joined::{Course, FoundBy, Joined, JoinedAt, JoinedError, JoinedOrbit, Waveform};
use crate::study::joints::JointError;
use crate::study::response::MotionQuantity;
use crate::study::words;
#[cfg(feature = "desk")]
use rayon::prelude::*;

/// Largest offset of a contact that rounding can cause, divided by its amplitude.
const ROUNDING: f64 = 1e-12;
/// Number of neighbouring frequencies of a curve that one core computes one after the other.
#[cfg(feature = "desk")]
const CURVE_RUN: usize = 8;
/// Number of such runs of a core between two calls that receive rows.
#[cfg(feature = "desk")]
const GROUP_RUNS: usize = 4;

/// Row of the table of steady states: the state of a scene with several contacts at one frequency and one friction.
#[derive(Clone, Debug)]
pub struct JoinedRow {
    /// Frequency of the excitation, as ratio r, in Hz and in rad/s.
    pub frequency: Frequency,
    /// The common friction of all contacts, as friction ratio β and, under a load, as force in N.
    pub friction: FrictionSetting,
    /// Regime of the steady state: continuous, stick-slip or stuck. If there is no steady state, the text is empty.
    pub regime: &'static str,
    /// Stability of the steady state: stable or marginal. If there is no steady state, the text is the reason.
    pub state: &'static str,
    /// The smallest common friction at which no contact slides, and the name of the contact that slides first below
    /// this friction.
    stuck: Option<(f64, String)>,
    steady: Option<SteadyNumbers>,
    /// The place on a branch, if the row belongs to a table of branches.
    branch: Option<BranchPlace>,
}

/// Numbers of a steady state with several contacts.
#[derive(Clone, Debug)]
struct SteadyNumbers {
    regime: Regime,
    /// Cycles of the load in a period. `None` if the motion does not settle, and the numbers are those of its last
    /// cycles.
    period: Option<usize>,
    /// True if the motion repeats with the opposite sign after half a period. `None` in a table without phases.
    symmetric: Option<bool>,
    multiplier: Option<f64>,
    marginal: String,
    found: FoundBy,
    from_rest: bool,
    cycles_followed: Option<usize>,
    parts: Vec<ContactNumbers>,
}

/// Numbers of the motion of a contact, or of another motion, over a period.
#[derive(Clone, Debug)]
struct ContactNumbers {
    motion: MotionGroups,
    contact: Option<ContactPart>,
}

/// Numbers over a period that a contact has and another motion does not have.
#[derive(Clone, Copy, Debug)]
struct ContactPart {
    regime: &'static str,
    stops: usize,
    reversals: usize,
    stuck_fraction: f64,
    slip: f64,
    force: f64,
    energy: f64,
    /// Mean of the largest and the smallest relative displacement. `None` in a table without phases.
    offset: Option<f64>,
}

at!(JoinedRow);

impl AtFriction for JoinedRow {
    fn friction(&self) -> FrictionSetting {
        self.friction
    }
}

impl JoinedRow {
    /// Returns true if the row contains a steady state.
    #[must_use]
    pub fn is_known(&self) -> bool {
        self.steady.is_some()
    }

    /// Returns the regime: *stuck* if no contact slides, *continuous* if all contacts slide all the time, and otherwise
    /// *stick-slip*. Returns `None` without a steady state.
    #[must_use]
    pub fn kind(&self) -> Option<Regime> {
        let steady = self.steady.as_ref()?;
        steady.period.map(|_| steady.regime)
    }

    /// Returns the number of cycles over which the search followed the motion from rest without seeing it settle.
    /// Returns `None` if this motion settles.
    #[must_use]
    pub fn cycles_followed(&self) -> Option<usize> {
        self.steady.as_ref()?.cycles_followed
    }

    /// Returns the names of the contacts that never slide, separated by blanks.
    #[must_use]
    pub fn marginal(&self) -> &str {
        self.steady.as_ref().map_or("", |steady| &steady.marginal)
    }

    /// Returns the amplitude of a contact or of another motion in non-dimensional groups. `index` counts all contacts
    /// first, and then the motions of the table.
    #[must_use]
    pub fn amplitude(&self, index: usize) -> Option<f64> {
        Some(self.part(index)?.motion.view().swing?.amplitude)
    }

    /// Returns the fraction of the period during which a contact sticks.
    #[must_use]
    pub fn stuck_fraction(&self, index: usize) -> Option<f64> {
        Some(self.contact(index)?.stuck_fraction)
    }

    /// Returns the place of the row on a branch, if it belongs to a table of branches.
    #[must_use]
    pub fn branch(&self) -> Option<&BranchPlace> {
        self.branch.as_ref()
    }

    fn part(&self, index: usize) -> Option<&ContactNumbers> {
        self.steady.as_ref()?.parts.get(index)
    }

    fn contact(&self, index: usize) -> Option<ContactPart> {
        self.part(index)?.contact
    }
}

impl MotionRow for JoinedRow {
    fn motion(&self, part: usize) -> Option<PartMotion<'_>> {
        Some(self.part(part)?.motion.view())
    }
}

/// The tables of the steady states of a scene with several contacts.
#[derive(Clone, Copy)]
pub struct JoinedTable<'a> {
    /// System and units, the frequencies and frictions as the user gave them, and the motions in the tables. The tables
    /// contain all contacts.
    pub setting: Setting<'a>,
    /// The scene's contacts and masses.
    pub joined: &'a Joined<'a>,
    /// Orders of the harmonics in the tables, which then also have the phases of all motions and the offsets of the
    /// contacts. `None` for tables with amplitudes alone.
    pub orders: Option<&'a [u32]>,
}

impl<'a> JoinedTable<'a> {
    /// Evaluates the scene at a frequency. A scene without springs needs a frequency in Hz or rad/s, and a load. For a
    /// scene without springs, the frequency ratio r is computed with k₁ = 1.
    ///
    /// # Errors
    /// Same errors as [`Joined::at`].
    pub fn at(&self, frequency: Frequency) -> Result<JoinedAt<'a>, JoinedError> {
        let physical =
            self.setting.frequency.is_physical() && self.setting.measure.scale().is_some();
        if !physical && self.joined.scene().springs.is_empty() {
            return Err(JoinedError::NoSpring);
        }
        let omega = self.setting.system.angular_frequency(frequency.r);
        match self.setting.measure.scale_at(omega) {
            Some(scale) => self.joined.with_length(scale.length()).at_any(frequency.r),
            None => self.joined.at_any(frequency.r),
        }
    }

    /// Computes the row of the steady state that the motion from rest reaches. If the motion does not settle, the row
    /// has no steady state, and its state is the word `unsettled`.
    ///
    /// # Errors
    /// [`JoinedError`] for a frequency or a friction outside the domain.
    pub fn row(
        &self,
        frequency: Frequency,
        friction: FrictionSetting,
    ) -> Result<JoinedRow, JoinedError> {
        let at = self.at(frequency)?;
        Ok(self.row_near(&at, (frequency, friction), None)?.0)
    }

    /// Computes the [`row`](Self::row) at a frequency, and the steady state in it. `near` is the steady state of a
    /// neighbouring row, which shortens the search.
    fn row_near<'s>(
        &self,
        at: &JoinedAt<'s>,
        (frequency, friction): (Frequency, FrictionSetting),
        near: Option<&JoinedOrbit<'_>>,
    ) -> Result<(JoinedRow, Option<JoinedOrbit<'s>>), JoinedError> {
        let friction = friction.at(&self.setting.measure, frequency);
        match at.orbit_or_last_cycles(friction.beta, near) {
            Ok(orbit) => {
                let row = self.found(at, (frequency, friction), &orbit)?;
                Ok((row, Some(orbit)))
            }
            Err(JoinedError::Engine(error)) => {
                let row = Self::without_state(at, (frequency, friction), &error);
                Ok((row, None))
            }
            Err(error) => Err(error),
        }
    }

    /// Computes the [`row`](Self::row)s of a grid on all cores, and passes those of one frequency after the other to
    /// `visit`, until `visit` fails.
    ///
    /// A search starts from the steady state of a neighbouring row. Which row this is depends on the grid alone, so that
    /// the number of cores has no influence on the results.
    ///
    /// # Errors
    /// Same errors as [`row`](Self::row), and the errors of `visit`.
    #[cfg(feature = "desk")]
    pub fn rows<E: From<JoinedError>>(
        &self,
        frequencies: &[Frequency],
        frictions: &[FrictionSetting],
        mut visit: impl FnMut(Vec<JoinedRow>) -> Result<(), E>,
    ) -> Result<(), E> {
        // Along the frictions a row has a neighbour at its own frequency.
        let run = if frictions.len() > 1 { 1 } else { CURVE_RUN };
        let group = run * rayon::current_num_threads().max(1) * GROUP_RUNS;
        for group in frequencies.chunks(group) {
            let runs = group.par_chunks(run).with_max_len(1);
            let runs: Vec<_> = runs.map(|run| self.run(run, frictions)).collect();
            for rows in runs {
                rows?.into_iter().try_for_each(&mut visit)?;
            }
        }
        Ok(())
    }

    /// Computes the rows at neighbouring frequencies, one after the other.
    #[cfg(feature = "desk")]
    fn run(
        &self,
        frequencies: &[Frequency],
        frictions: &[FrictionSetting],
    ) -> Result<Vec<Vec<JoinedRow>>, JoinedError> {
        let mut first = None;
        let of_frequency = |frequency: &Frequency| {
            let at = self.at(*frequency)?;
            let mut near: Option<JoinedOrbit<'_>> = first.take();
            let of_friction = |friction: &FrictionSetting| {
                let (row, found) = self.row_near(&at, (*frequency, *friction), near.as_ref())?;
                first = first.take().or_else(|| found.clone());
                near = found;
                Ok(row)
            };
            frictions.iter().map(of_friction).collect()
        };
        frequencies.iter().map(of_frequency).collect()
    }

    /// Computes one table row for every steady state that the search finds. If the search finds no stable steady state,
    /// the first row is the [`row`](Self::row) of the motion from rest, which contains the reason.
    ///
    /// # Errors
    /// Same errors as [`row`](Self::row).
    pub fn states(
        &self,
        frequency: Frequency,
        friction: FrictionSetting,
    ) -> Result<Vec<JoinedRow>, JoinedError> {
        let at = self.at(frequency)?;
        let friction = friction.at(&self.setting.measure, frequency);
        let states = match at.states(friction.beta) {
            Err(JoinedError::Engine(_)) => Vec::new(),
            states => states?,
        };
        let mut rows = Vec::new();
        if states.iter().all(JoinedOrbit::is_unstable) {
            rows.push(self.row(frequency, friction)?);
        }
        for orbit in &states {
            rows.push(self.found(&at, (frequency, friction), orbit)?);
        }
        Ok(rows)
    }

    fn without_state(
        at: &JoinedAt<'_>,
        (frequency, friction): (Frequency, FrictionSetting),
        error: &JointError,
    ) -> JoinedRow {
        JoinedRow {
            frequency,
            friction,
            regime: "",
            state: reason(error),
            stuck: limit(at),
            steady: None,
            branch: None,
        }
    }

    fn found(
        &self,
        at: &JoinedAt<'_>,
        (frequency, friction): (Frequency, FrictionSetting),
        orbit: &JoinedOrbit<'_>,
    ) -> Result<JoinedRow, JoinedError> {
        Ok(JoinedRow {
            stuck: limit(at),
            ..self.of_orbit((frequency, friction), orbit, None)?
        })
    }

    /// Returns the row of a steady state, with its place if it is a point of a branch.
    pub(super) fn of_orbit(
        &self,
        (frequency, friction): (Frequency, FrictionSetting),
        orbit: &JoinedOrbit<'_>,
        branch: Option<BranchPlace>,
    ) -> Result<JoinedRow, JoinedError> {
        Ok(JoinedRow {
            frequency,
            friction,
            regime: words::regime(orbit.regime()),
            state: words::joined_state(orbit),
            stuck: None,
            steady: Some(self.numbers(orbit)?),
            branch,
        })
    }

    /// Returns the numbers of a steady state or of a limit cycle.
    fn numbers(&self, orbit: &JoinedOrbit<'_>) -> Result<SteadyNumbers, JoinedError> {
        let mut courses = self.courses(orbit)?.into_iter();
        let mut motion = |amplitude| {
            let motion = MotionGroups::of_amplitude(amplitude);
            match (courses.next().flatten(), self.orders) {
                (Some(course), Some(orders)) => {
                    let offset = course.middle();
                    // A state that is symmetric to within rounding has no offset.
                    let is_offset = offset.abs() > ROUNDING * amplitude;
                    let offset = if is_offset { offset } else { 0.0 };
                    (motion.with_course(&course, orders), Some(offset))
                }
                _ => (motion, None),
            }
        };
        let mut parts = Vec::new();
        for contact in orbit.contacts() {
            let (motion, offset) = motion(contact.displacement());
            let contact = Some(ContactPart {
                regime: contact.word(),
                stops: contact.stops(),
                reversals: contact.reversals(),
                stuck_fraction: contact.stuck_fraction(),
                slip: contact.slip(),
                force: contact.force(),
                energy: contact.energy(),
                offset,
            });
            parts.push(ContactNumbers { motion, contact });
        }
        let quantities = self.setting.parts.iter();
        let quantities: Vec<_> = quantities.map(|part| (part.of, part.size)).collect();
        for amplitude in orbit.largest_of(&quantities)? {
            parts.push(ContactNumbers {
                motion: motion(amplitude).0,
                contact: None,
            });
        }
        let multipliers = orbit.multipliers().iter().map(|value| value.norm());
        let is_settled = orbit.is_settled();
        let symmetric = (is_settled && self.orders.is_some()).then(|| orbit.is_symmetric());
        Ok(SteadyNumbers {
            regime: orbit.regime(),
            period: is_settled.then(|| orbit.period()),
            symmetric: symmetric.transpose()?,
            multiplier: multipliers.reduce(f64::max),
            marginal: orbit.marginal_contacts().join(" "),
            found: orbit.found_by(),
            from_rest: orbit.is_from_rest(),
            cycles_followed: orbit.cycles_followed(),
            parts,
        })
    }

    /// Returns the courses of all contacts and of the displacements and forces in the table, in the order of
    /// [`parts`](Self::parts). Other quantities, and tables with amplitudes alone, have none.
    fn courses(&self, orbit: &JoinedOrbit<'_>) -> Result<Vec<Option<Waveform>>, JoinedError> {
        let parts = self.setting.parts.iter();
        if self.orders.is_none() {
            return Ok(Vec::new());
        }
        let contacts = 0..self.joined.contact_names().len();
        let of_contact = |index| Course::of_contact(self.joined, index);
        let of_part = |part: &MovingPart| match part.size {
            MotionQuantity::Displacement => Course::of(self.joined, part.of, part.size),
            _ => None,
        };
        let asked: Vec<_> = contacts.map(of_contact).chain(parts.map(of_part)).collect();
        let known: Vec<_> = asked.iter().flatten().cloned().collect();
        let mut found = orbit.waveforms(&known)?.into_iter();
        let courses = asked
            .iter()
            .map(|asked| asked.as_ref().and_then(|_| found.next()));
        Ok(courses.collect())
    }

    /// Returns the names of the contacts and motions in the table. The contacts come first.
    #[must_use]
    pub fn parts(&self) -> Vec<String> {
        let motions = self.setting.parts.iter().map(|part| part.name.clone());
        self.joined
            .contact_names()
            .into_iter()
            .chain(motions)
            .collect()
    }

    /// Returns the dimension of the amplitude of a contact or a motion. The contacts come first.
    fn dimension(&self, index: usize) -> PhysicalQuantity {
        let contacts = self.joined.contact_names().len();
        let part = index.checked_sub(contacts);
        let part = part.and_then(|index| self.setting.parts.get(index));
        part.map_or(PhysicalQuantity::Length, |part| part.dimension())
    }

    /// Returns the columns of the table of steady states.
    #[must_use]
    pub fn columns(&self) -> Vec<Column<'a, JoinedRow>> {
        let mut columns = Columns::new(&self.setting.measure);
        self.setting.frequency(&mut columns);
        self.setting.friction(&mut columns);
        columns.word("regime", "continuous", |row: &JoinedRow| Some(row.regime));
        columns.word("state", "unsettled", |row| Some(row.state));
        if self.orders.is_some() {
            columns.word("symmetry", "asymmetric", |row| {
                Some(words::symmetry(row.steady.as_ref()?.symmetric?))
            });
        }
        self.state_columns(&mut columns);
        columns.number(Head::of("stuck_from", PhysicalQuantity::Force), |row| {
            Some(row.stuck.as_ref()?.0)
        });
        columns.word("slides_first", "slides_first", |row| {
            Some(row.stuck.as_ref()?.1.as_str())
        });
        columns.show(Shown::Files);
        columns.word("found_by", "linear", |row| {
            Some(words::found_by(row.steady.as_ref()?.found))
        });
        columns.word("marginal", "marginal", |row| {
            Some(row.steady.as_ref()?.marginal.as_str())
        });
        columns.flag("from_rest", |row| Some(row.steady.as_ref()?.from_rest));
        columns.count("cycles_followed", JoinedRow::cycles_followed);
        columns.show(Shown::Everywhere);
        self.part_columns(&mut columns);
        columns.done()
    }

    /// Adds the columns of the period and of the largest multiplier.
    pub(super) fn state_columns(&self, columns: &mut Columns<'a, JoinedRow>) {
        let head = Head::new("period").titled(&["period", "(cycles)"]);
        columns.count(head, |row: &JoinedRow| row.steady.as_ref()?.period);
        let head = Head::new("largest_multiplier").titled(&["multiplier", "(largest)"]);
        columns.number(head, |row| row.steady.as_ref()?.multiplier);
    }

    /// Returns the columns of the table of limit cycles.
    #[must_use]
    pub fn cycle_columns(&self) -> Vec<Column<'a, JoinedRow>> {
        let mut columns = Columns::new(&self.setting.measure);
        self.setting.friction(&mut columns);
        columns.number(
            Head::of("period", PhysicalQuantity::Time),
            |row: &JoinedRow| Some(1.0 / row.frequency.hertz),
        );
        columns.number("frequency_hz", |row| Some(row.frequency.hertz));
        columns.word("regime", "continuous", |row: &JoinedRow| Some(row.regime));
        self.part_columns(&mut columns);
        columns.done()
    }

    /// Adds the columns of all contacts, and of the motions of the table.
    pub(super) fn part_columns(&self, columns: &mut Columns<'a, JoinedRow>) {
        let contacts = self.joined.contact_names().len();
        for (index, name) in self.parts().iter().enumerate() {
            if index < contacts {
                columns.begin_contact(name);
            } else {
                columns.begin_part(name);
            }
            let size = self.dimension(index);
            columns.number(Head::of("amplitude", size), move |row: &JoinedRow| {
                row.amplitude(index)
            });
            // The contacts come before the motions.
            let part = index.checked_sub(contacts);
            let part = part.and_then(|index| self.setting.parts.get(index));
            let is_course = part.is_none_or(|part| part.size == MotionQuantity::Displacement);
            let orders = self.orders.filter(|_| is_course);
            if orders.is_some() {
                phases(columns, index);
            }
            if part.is_none() {
                self.contact_columns(columns, index);
            }
            // The columns of a harmonic come last, because they are a list in JSON.
            harmonics(columns, index, (orders.unwrap_or_default(), size, true));
        }
        columns.end_parts();
    }

    /// Adds the columns that a contact has beside its amplitude and its phases.
    fn contact_columns(&self, columns: &mut Columns<'a, JoinedRow>, index: usize) {
        if self.orders.is_some() {
            let head = Head::of("offset", PhysicalQuantity::Length);
            columns.number(head, move |row: &JoinedRow| row.contact(index)?.offset);
        }
        columns.word("regime", "continuous", move |row: &JoinedRow| {
            Some(row.contact(index)?.regime)
        });
        // The last cycles of a motion that does not settle have no numbers per period.
        let periodic = move |row: &JoinedRow| row.contact(index).filter(|_| row.kind().is_some());
        columns.count("stops", move |row| Some(periodic(row)?.stops));
        columns.count("reversals", move |row| Some(periodic(row)?.reversals));
        let head = Head::new("stuck_fraction").titled(&["stuck", "(of period)"]);
        columns.number(head, move |row| Some(row.contact(index)?.stuck_fraction));
        columns.number(Head::of("slip", PhysicalQuantity::Length), move |row| {
            Some(row.contact(index)?.slip)
        });
        columns.number(Head::of("force", PhysicalQuantity::Force), move |row| {
            Some(row.contact(index)?.force)
        });
        columns.number(Head::of("energy", PhysicalQuantity::Energy), move |row| {
            Some(row.contact(index)?.energy)
        });
    }

    /// Computes the row of the limit cycle that the motion without a load reaches. Returns `None` if it reaches none.
    ///
    /// # Errors
    /// Same errors as [`Joined::limit_cycle`].
    pub fn cycle(&self, friction: FrictionSetting) -> Result<Option<JoinedRow>, JoinedError> {
        let Some(orbit) = self.joined.limit_cycle(friction.force())? else {
            return Ok(None);
        };
        let system = self.setting.system;
        let frequency = Frequency::at(system, orbit.omega() / system.angular_frequency(1.0));
        let steady = self.numbers(&orbit)?;
        Ok(Some(JoinedRow {
            frequency,
            friction,
            regime: words::regime(orbit.regime()),
            state: "",
            stuck: None,
            steady: Some(steady),
            branch: None,
        }))
    }
}

/// Returns the smallest common friction at which no contact slides, and the name of the contact that slides first
/// below this friction. Returns `None` on a resonance of the scene with all contacts stuck.
fn limit(at: &JoinedAt<'_>) -> Option<(f64, String)> {
    let stuck = at.stuck().ok()?;
    Some((stuck.limit(), stuck.first().to_owned()))
}

/// Returns the word with which the table gives the reason why there is no steady state.
pub(super) fn reason(error: &JointError) -> &'static str {
    match error {
        JointError::NotSteady => "unsettled",
        JointError::Events | JointError::Stretches | JointError::Patterns => "too long",
        JointError::NotFinite => "unbounded",
        _ => "no state",
    }
}
