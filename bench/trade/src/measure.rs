//! Measures every method in every scene.

use crate::clock::{Job, Time, interleaved};
use crate::methods::{Fill, Method, Pair, filler};
use crate::peers::{Modal, balance, textbook};
#[cfg(with_c)]
use crate::peers::{by_hand, stepper};
use crate::points::{EXTREME, Errors, Extent, Set, USUAL, asked, edges, usual};
use crate::scenes::{Label, Orbit, Visitor};
use crate::tabled::{self, Figures};
use crate::tails::{self, Tail};
use frictiongen::kernel::Float;
use frictiongen::kernel::number::dd::Dd;
use frictiongen::{FrictionSystem, MotionAt, System};

/// A method by which a quantity is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum By {
    /// The emitted code of the scene, in double precision.
    Double,
    /// The emitted code of the scene, in single precision.
    Single,
    /// The type `System` of this library, at run time.
    RunTime,
    /// The formulas of the thesis, written by hand in C.
    Hand,
    /// The eigenproblem, solved at each frequency ratio r by nalgebra.
    Textbook,
    /// Harmonic balance. The number is its highest harmonic.
    Balance(usize),
    /// The event stepper, written in C.
    Stepper,
    /// Emitted scene with tables in double precision. With the number n, the accuracy of the tables is 10⁻ⁿ. The
    /// tables of the finest accuracy are built at run time.
    Table(u8),
}

impl By {
    /// Returns the name of the method in printed tables.
    pub fn name(self) -> String {
        match self {
            Self::Double => "emitted f64".into(),
            Self::Single => "emitted f32".into(),
            Self::RunTime => "System f64".into(),
            Self::Hand => "C by hand".into(),
            Self::Textbook => "eigenproblem at each r".into(),
            Self::Balance(order) => format!("harmonic balance {order}"),
            Self::Stepper => "C event stepper".into(),
            Self::Table(tabled::FINEST) => format!("System's table 1e-{}", tabled::FINEST),
            Self::Table(exponent) => format!("table 1e-{exponent}"),
        }
    }
}

/// Measurement of one quantity by one method in one scene.
#[derive(Clone, Debug)]
pub struct Row {
    /// Scene that was measured.
    pub label: Label,
    /// Method that computed the quantity.
    pub by: By,
    /// Quantity that was computed.
    pub method: Method,
    /// Time of a call, in ns.
    pub time: Time,
    /// Relative errors against the same formula in double-double, at all points.
    pub rounding: Errors,
    /// Relative errors against the exact value, at usual points of the domain.
    pub usual: Errors,
    /// Relative errors against the exact value, at all points.
    pub error: Errors,
    /// Size and look-up cost of a table. Only scenes with tables have them.
    pub table: Option<Figures>,
}

/// Measures the scenes that it visits, and collects the results.
pub struct Measure {
    /// Extent of the measurement.
    pub extent: Extent,
    /// Results of the measurement, one row for each quantity, method and scene.
    pub rows: Vec<Row>,
    /// Distributions of the times of single calls.
    pub tails: Vec<Tail>,
}

/// Points for a scene, rounded to one scalar: for the time, for the errors at usual points and at the edges of the
/// domain, and with stops.
struct Sets<S> {
    timed: Set<S>,
    usual: Set<S>,
    edges: Set<S>,
    stops: Set<S>,
}

/// A scene in double-double. It gives the exact values.
struct Reference {
    system: System<Dd>,
    fill: Fill<Dd>,
}

fn amplitude_with_stops(system: &System<Dd>, [r, beta]: Pair<Dd>) -> Option<Dd> {
    let at = system.at(r).ok()?;
    Some(at.orbit(beta).ok()?.contact().amplitude())
}

impl Reference {
    fn of(label: &Label) -> Self {
        let system: System<Dd> = label.text.parse().expect("a scene");
        let closed = filler(system.clone(), label.watched, None);
        let stops = system.clone();
        let fill: Fill<Dd> = Box::new(move |method, points, out| {
            if method != Method::Orbit {
                return closed(method, points, out);
            }
            for (point, out) in points.iter().zip(out) {
                if let Some(amplitude) = amplitude_with_stops(&stops, *point) {
                    *out = [amplitude; 2];
                }
            }
        });
        Self { system, fill }
    }

    fn sets<S: Float>(&self, extent: &Extent, resonances: &[f64], stops: bool) -> Sets<S> {
        Sets {
            timed: Set::continuous(&usual(extent.timed), &self.fill, &USUAL[..1]),
            usual: Set::continuous(&usual(extent.usual), &self.fill, &USUAL),
            edges: Set::continuous(&edges(resonances), &self.fill, &EXTREME),
            stops: Set::with_stops(
                &self.system,
                &self.fill,
                if stops { extent.orbits } else { 0 },
            ),
        }
    }
}

/// A quantity and a method that computes it, before its time is measured.
struct Entry<'a, S> {
    by: By,
    method: Method,
    fill: &'a Fill<S>,
    table: Option<Figures>,
}

impl<'a, S> Entry<'a, S> {
    fn new(by: By, method: Method, fill: &'a Fill<S>) -> Self {
        Self {
            by,
            method,
            fill,
            table: None,
        }
    }
}

fn judged<S: Float>(label: Label, entry: &Entry<'_, S>, sets: &Sets<S>, time: Time) -> Row {
    let (method, exact) = (entry.method, entry.method.exact());
    let errors = |set: &Set<S>, truth| set.errors(&asked(entry.fill, method, &set.points), truth);
    let stops = method == Method::Orbit;
    let first = if stops { &sets.stops } else { &sets.usual };
    let (mut rounding, usual) = (errors(first, method), errors(first, exact));
    let mut error = usual.clone();
    if entry.table.is_some() {
        // The points at the edges lie outside the range of the tables. The points of the timed calls lie inside.
        error = error.with(&errors(&sets.timed, exact));
    } else if !stops {
        rounding = rounding.with(&errors(&sets.edges, method));
        error = error.with(&errors(&sets.edges, exact));
    }
    Row {
        label,
        by: entry.by,
        method,
        time,
        rounding,
        usual,
        error,
        table: entry.table,
    }
}

fn job<'a, S: Float>(entry: &Entry<'a, S>, sets: &'a Sets<S>) -> Job<'a> {
    let set = if entry.method == Method::Orbit {
        &sets.stops
    } else {
        &sets.timed
    };
    let (method, fill) = (entry.method, entry.fill);
    let mut out = vec![[S::constant(0.0); 2]; set.points.len()];
    Job::new(set.points.len(), move |count| {
        fill(method, &set.points[..count], &mut out[..count])
    })
}

impl Visitor for Measure {
    fn scene<D, S>(
        &mut self,
        label: Label,
        double: D,
        single: S,
        orbit: Orbit<f64>,
        orbit_single: Orbit<f32>,
    ) where
        D: FrictionSystem<Scalar = f64> + 'static,
        S: FrictionSystem<Scalar = f32> + 'static,
        for<'a> D::At<'a>: MotionAt<Scalar = f64>,
        for<'a> S::At<'a>: MotionAt<Scalar = f32>,
    {
        if label.masses > self.extent.masses {
            return;
        }
        eprintln!("{}, ζ = {}", label.name, label.zeta);
        let system: System = label.text.parse().expect("a scene");
        let modal = Modal::of(&label, &system);
        let reference = Reference::of(&label);
        let wide: Sets<f64> = reference.sets(&self.extent, &modal.root, orbit.is_some());
        let narrow: Sets<f32> = reference.sets(&self.extent, &modal.root, orbit.is_some());

        let doubles = filler(double, label.watched, orbit);
        let singles = filler(single, label.watched, orbit_single);
        let run_time = filler(system.clone(), label.watched, None);
        let textbook = textbook::filler(label);
        let balances = balance::ORDERS.map(|order| (order, balance::filler(modal.clone(), order)));
        #[cfg(with_c)]
        let by_hand = by_hand::filler(&modal);

        let mut entries = Vec::new();
        let mut entries_single = Vec::new();
        for method in Method::CLOSED {
            entries.push(Entry::new(By::Double, method, &doubles));
            entries.push(Entry::new(By::RunTime, method, &run_time));
            entries_single.push(Entry::new(By::Single, method, &singles));
            #[cfg(with_c)]
            if by_hand::METHODS.contains(&method) {
                entries.push(Entry::new(By::Hand, method, &by_hand));
            }
        }
        if orbit.is_some() && !wide.stops.points.is_empty() && !narrow.stops.points.is_empty() {
            entries.push(Entry::new(By::Double, Method::Orbit, &doubles));
            entries_single.push(Entry::new(By::Single, Method::Orbit, &singles));
        }
        let tables = tabled::of(&label, &system);
        entries.push(Entry::new(By::Double, Method::Contact, &doubles));
        entries.extend(tables.iter().map(|table| Entry {
            table: Some(table.figures),
            ..Entry::new(By::Table(table.exponent), table.method, &table.fill)
        }));
        for method in textbook::METHODS {
            entries.push(Entry::new(By::Textbook, method, &textbook));
        }
        for (order, fill) in &balances {
            entries.push(Entry::new(By::Balance(*order), Method::Amplitude, fill));
        }

        let mut jobs: Vec<Job<'_>> = entries.iter().map(|entry| job(entry, &wide)).collect();
        jobs.extend(entries_single.iter().map(|entry| job(entry, &narrow)));
        let times = interleaved(&mut jobs, self.extent.rounds);
        drop(jobs);
        self.tails
            .push(tails::of(label, &doubles, &system, self.extent.tail));
        let (times, times_single) = times.split_at(entries.len());
        let rows = entries
            .iter()
            .zip(times)
            .map(|(e, t)| judged(label, e, &wide, *t));
        self.rows.extend(rows);
        let rows = entries_single
            .iter()
            .zip(times_single)
            .map(|(e, t)| judged(label, e, &narrow, *t));
        self.rows.extend(rows);
        #[cfg(with_c)]
        {
            // The event stepper gives no amplitude except that of the contact, so its error is that of this
            // amplitude.
            let contact = contact_amplitudes(&reference, &wide.timed, self.extent.stepped);
            self.stepped(label, Method::Amplitude, &contact);
            let stops = asked(
                &reference.fill,
                Method::Orbit,
                &wide_points(&wide.stops, self.extent.stepped),
            );
            let stops: Vec<_> = wide
                .stops
                .points
                .iter()
                .zip(stops)
                .map(|(p, a)| (*p, a[0]))
                .collect();
            self.stepped(label, Method::Orbit, &stops);
        }
    }
}

#[cfg(with_c)]
fn wide_points(set: &Set<f64>, count: usize) -> Vec<Pair<Dd>> {
    set.points
        .iter()
        .take(count)
        .map(|p| p.map(Dd::from))
        .collect()
}

#[cfg(with_c)]
fn contact_amplitudes(reference: &Reference, set: &Set<f64>, count: usize) -> Vec<(Pair<f64>, Dd)> {
    let answer = |point: &Pair<f64>| {
        let [r, beta] = point.map(Dd::from);
        let amplitude = reference
            .system
            .at(r)
            .ok()?
            .motion(beta)
            .ok()?
            .contact()
            .amplitude();
        Some((*point, amplitude))
    };
    set.points.iter().take(count).filter_map(answer).collect()
}

#[cfg(with_c)]
impl Measure {
    /// Runs the event stepper at the given points, and compares its results with the exact amplitude of the contact.
    fn stepped(&mut self, label: Label, method: Method, points: &[(Pair<f64>, Dd)]) {
        let mut runs = Vec::new();
        let mut error = Errors::default();
        for (point, exact) in points {
            let Some(run) = stepper::run(&label, *point) else {
                return;
            };
            let off = ((Dd::from(run.amplitude) - *exact) / *exact).to_f64().abs();
            error.and(&Errors {
                sorted: vec![off],
                none: 0,
            });
            runs.push(run);
        }
        if runs.is_empty() {
            return;
        }
        self.rows.push(Row {
            label,
            by: By::Stepper,
            method,
            time: stepper::time(&runs),
            rounding: error.clone(),
            usual: error.clone(),
            error,
            table: None,
        });
    }
}
