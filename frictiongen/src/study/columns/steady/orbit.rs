//! Rows and columns of the table of steady states over frequency and friction.

use super::MotionGroups;
use crate::study::columns::builder::Columns;
use crate::study::columns::column::{Column, ColumnKind, Head, Shown};
use crate::study::columns::measure::PhysicalQuantity;
use crate::study::columns::motion::{MotionColumns, MotionRow, PartMotion, motions};
use crate::study::columns::setting::{AtFriction, Frequency, FrictionSetting, Setting, at};
use crate::study::response::{MotionQuantity, equivalent_damping};
use crate::study::{SystemAt, orbit::SystemOrbit, words};
use crate::{Complex, NoOrbit, OutOfDomain};

/// A row of the table: the steady state at one frequency and one friction.
#[derive(Clone, Debug)]
pub struct OrbitRow {
    /// Frequency of the excitation, as ratio r, in Hz and in rad/s.
    pub frequency: Frequency,
    /// Friction in the contact, as ratio β and, under a load, as force in N.
    pub friction: FrictionSetting,
    /// Regime of the contact: continuous, stick-slip, stuck or unbounded.
    pub regime: &'static str,
    /// Word for the steady state: stable, marginal or unsettled. If there is no steady state, the text is the reason.
    pub state: &'static str,
    /// The steady state, if there is one.
    steady: Option<SteadyData>,
}

/// A steady state, or the last cycles of a motion that does not settle.
#[derive(Clone, Debug)]
struct SteadyData {
    /// Cycles, symmetry, stops and reversals of the motion. `None` if the motion does not repeat.
    period: Option<Period>,
    from_rest: bool,
    /// Number of cycles after which motion from rest has not settled. `None` if this motion settles.
    cycles_followed: Option<usize>,
    marginal: bool,
    offset: f64,
    stuck_fraction: f64,
    /// Stops of the contact, each with its start and its duration as phase τ = ωt.
    sticking: Vec<[f64; 2]>,
    multipliers: Vec<Complex<f64>>,
    motions: Vec<MotionGroups>,
}

/// Numbers that describe one period of a periodic motion.
#[derive(Clone, Copy, Debug)]
struct Period {
    cycles: usize,
    symmetric: bool,
    stops: usize,
    reversals: usize,
}

/// The table of steady states over frequency and friction.
#[derive(Clone, Copy)]
pub struct OrbitTable<'a> {
    /// System, units, and the contact or masses whose motions the table contains.
    pub setting: Setting<'a>,
    /// Orders n of the harmonics that the table contains.
    pub orders: &'a [u32],
}

at!(OrbitRow);

impl AtFriction for OrbitRow {
    fn friction(&self) -> FrictionSetting {
        self.friction
    }
}

impl MotionRow for OrbitRow {
    fn motion(&self, part: usize) -> Option<PartMotion<'_>> {
        let motions = &self.steady.as_ref()?.motions;
        motions.get(part).map(MotionGroups::view)
    }
}

impl SteadyData {
    /// Returns the duration of the contact's longest stop, as phase τ = ωt in rad. Returns `None` if there is no stop.
    fn longest_stop(&self) -> Option<f64> {
        let lengths = self.sticking.iter().map(|[_, length]| *length);
        lengths.reduce(f64::max)
    }

    /// Returns the largest modulus of the Floquet multipliers. Returns `None` if there are no multipliers.
    fn largest_multiplier(&self) -> Option<f64> {
        let moduli = self
            .multipliers
            .iter()
            .map(|value| value.re.hypot(value.im));
        moduli.reduce(f64::max)
    }
}

impl OrbitRow {
    /// Returns true if the row contains a steady state.
    #[must_use]
    pub fn is_known(&self) -> bool {
        self.steady.is_some()
    }

    /// Returns true if the row contains a motion that repeats.
    #[must_use]
    pub fn is_settled(&self) -> bool {
        self.period().is_some()
    }

    /// Returns the number of cycles over which the search followed the motion from rest without seeing it settle.
    /// Returns `None` if this motion settles.
    #[must_use]
    pub fn cycles_followed(&self) -> Option<usize> {
        self.steady.as_ref()?.cycles_followed
    }

    fn period(&self) -> Option<Period> {
        self.steady.as_ref()?.period
    }

    /// Converts an angle τ = ωt of the excitation, in rad, to seconds.
    fn seconds(&self, angle: f64) -> f64 {
        angle / self.frequency.omega
    }
}

impl<'a> OrbitTable<'a> {
    /// Computes the table row of the steady state that the motion from rest reaches.
    ///
    /// # Errors
    /// [`OutOfDomain`] for a friction outside the domain.
    pub fn row(
        &self,
        at: &SystemAt<'_>,
        frequency: Frequency,
        friction: FrictionSetting,
    ) -> Result<OrbitRow, OutOfDomain> {
        let friction = friction.at(&self.setting.measure, frequency);
        let beta = friction.beta;
        match at.orbit_or_last_cycles(beta) {
            Ok(orbit) => {
                let mut row = self.found(at, (frequency, friction), &orbit);
                // If the motion from rest does not settle, `response` returns another steady state. The row then
                // contains the regime of that steady state.
                if !orbit.is_settled()
                    && let Ok(response) = at.response_after(beta, || Ok(orbit))
                {
                    row.regime = words::regime(response.regime());
                }
                Ok(row)
            }
            Err(NoOrbit::OutOfDomain(error)) => Err(error),
            Err(error) => Ok(OrbitRow {
                frequency,
                friction,
                regime: words::regime_without_orbit(at, beta)?,
                state: words::reason(error),
                steady: None,
            }),
        }
    }

    /// Computes one table row for every steady state that the search finds. If the search finds no stable steady state,
    /// the first row is the [`row`](Self::row) of the motion from rest, which contains the reason.
    ///
    /// # Errors
    /// [`OutOfDomain`] for a friction outside the domain.
    pub fn states(
        &self,
        at: &SystemAt<'_>,
        frequency: Frequency,
        friction: FrictionSetting,
    ) -> Result<Vec<OrbitRow>, OutOfDomain> {
        let under_load = friction.at(&self.setting.measure, frequency);
        let states = at.every_state(under_load.beta)?;
        let is_reached = |orbit: &SystemOrbit<'_>| orbit.is_stable() || orbit.is_marginal();
        let mut rows = Vec::new();
        if !states.iter().any(is_reached) {
            rows.push(self.row(at, frequency, friction)?);
        }
        let states = states.iter();
        rows.extend(states.map(|orbit| self.found(at, (frequency, under_load), orbit)));
        Ok(rows)
    }

    fn found(
        &self,
        at: &SystemAt<'_>,
        (frequency, friction): (Frequency, FrictionSetting),
        orbit: &SystemOrbit<'_>,
    ) -> OrbitRow {
        OrbitRow {
            frequency,
            friction,
            regime: words::regime(at.regime_of(orbit)),
            state: words::state(orbit),
            steady: Some(self.steady(at, orbit)),
        }
    }

    fn steady(&self, at: &SystemAt<'_>, orbit: &SystemOrbit<'_>) -> SteadyData {
        let measure = &self.setting.measure;
        let contact = at.contact_of(orbit);
        let motions = self.setting.parts.iter().map(|part| {
            let motion = orbit.ask_of(part.of, |motion| {
                MotionGroups::of_orbit(motion, self.orders)
            });
            let mut motion = motion.unwrap_or_default();
            motion.contact = contact;
            if part.size == MotionQuantity::Damping
                && let Some((_, energy)) = contact
            {
                let centred = |of| orbit.ask_of(of, |motion| motion.centred_amplitude());
                motion.damping = equivalent_damping(self.setting.system, part.of, energy, centred);
            }
            if measure.turns(part.of) {
                motion.turn(Some(orbit.reversed_contact_phase()));
            }
            motion
        });
        SteadyData {
            period: orbit.is_settled().then(|| Period {
                cycles: orbit.period() as usize,
                symmetric: orbit.is_symmetric(),
                stops: orbit.stops(),
                reversals: orbit.reversals(),
            }),
            from_rest: orbit.is_from_rest(),
            cycles_followed: orbit.cycles_followed().map(|cycles| cycles as usize),
            marginal: orbit.is_marginal(),
            offset: measure.sign() * orbit.offset(),
            stuck_fraction: orbit.stuck_fraction(),
            sticking: orbit.sticking_intervals().map(<[f64; 2]>::from).collect(),
            multipliers: orbit.multipliers().to_vec(),
            motions: motions.collect(),
        }
    }

    /// Returns the columns of the table of steady states.
    #[must_use]
    pub fn columns(&self) -> Vec<Column<'a, OrbitRow>> {
        let mut columns = Columns::new(&self.setting.measure);
        self.setting.frequency(&mut columns);
        self.setting.friction(&mut columns);
        columns.word("regime", "continuous", |row: &OrbitRow| Some(row.regime));
        columns.word("state", "unsettled", |row| Some(row.state));
        columns.word("symmetry", "asymmetric", |row| {
            Some(words::symmetry(row.period()?.symmetric))
        });
        let head = Head::new("period").titled(&["period", "(cycles)"]);
        columns.count(head, |row| Some(row.period()?.cycles));
        columns.count("stops", |row| Some(row.period()?.stops));
        columns.count("reversals", |row| Some(row.period()?.reversals));
        let head = Head::new("stuck_fraction").titled(&["stuck", "(of period)"]);
        columns.number(head, |row| Some(row.steady.as_ref()?.stuck_fraction));
        let in_seconds = self.setting.frequency.has_hertz();
        if in_seconds {
            let head =
                Head::of("longest_stop", PhysicalQuantity::Time).titled(&["longest", "stop (s)"]);
            columns.number(head, |row| {
                let longest = row.steady.as_ref()?.longest_stop()?;
                Some(row.seconds(longest))
            });
        }
        let head = Head::new("largest_multiplier").titled(&["multiplier", "(largest)"]);
        columns.number(head, |row| row.steady.as_ref()?.largest_multiplier());
        columns.number(Head::of("offset", PhysicalQuantity::Length), |row| {
            Some(row.steady.as_ref()?.offset)
        });
        columns.show(Shown::Files);
        columns.flag("marginal", |row| Some(row.steady.as_ref()?.marginal));
        columns.flag("from_rest", |row| Some(row.steady.as_ref()?.from_rest));
        columns.count("cycles_followed", OrbitRow::cycles_followed);
        self.lists(&mut columns, in_seconds);
        columns.show(Shown::Everywhere);
        let extent = MotionColumns {
            monoharmonic: false,
            rates: false,
            orders: self.orders,
            complex: true,
        };
        motions(&mut columns, self.setting.parts, extent);
        columns.done()
    }

    /// Adds the columns with the list of Floquet multipliers and the list of stops.
    fn lists(&self, columns: &mut Columns<'a, OrbitRow>, in_seconds: bool) {
        columns.show(Shown::Objects);
        columns.list("multipliers", ColumnKind::Complex, |row| {
            let all = row.steady.as_ref()?.multipliers.iter();
            Some(all.map(|value| [value.re, value.im]).collect())
        });
        columns.list("sticking_intervals", ColumnKind::Intervals, |row| {
            Some(row.steady.as_ref()?.sticking.clone())
        });
        if in_seconds {
            let head = Head::of("sticking_intervals", PhysicalQuantity::Time);
            columns.list(head, ColumnKind::Intervals, |row| {
                let all = row.steady.as_ref()?.sticking.iter();
                Some(
                    all.map(|ends| ends.map(|angle| row.seconds(angle)))
                        .collect(),
                )
            });
        }
    }
}
