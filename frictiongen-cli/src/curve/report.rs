//! Writes curves: one line for each point, with the number of its piece.

use crate::asked::Part;
use crate::failure::Failure;
use crate::frequency::{Band, Frequency};
use crate::friction::{Friction, Frictions};
use crate::harmonics;
use crate::measure::Measure;
use crate::number::Value;
use crate::output::{Report, Visitor};
use crate::table::Column;
use frictiongen::study::{Curve, CurvePoint, CurveRequest, CurveStart, Movement, words};
use frictiongen::{Error, System};
use serde_json::Value as Json;

/// The curves with everything needed to write them.
pub struct CurveReport {
    /// The system.
    pub system: System,
    /// The range of frequencies.
    pub band: Band,
    /// The frictions.
    pub frictions: Frictions,
    /// The units of the answers.
    pub measure: Measure,
    /// The motions to write.
    pub parts: Vec<Part>,
    /// The request that made the curves.
    pub request: CurveRequest,
    /// The curves, one for each friction and start.
    pub curves: Vec<(Friction, Curve)>,
    /// True if the user asked for a start other than rest.
    pub swept: bool,
}

/// A line of the output: a point of a piece, or an end point of a gap.
pub struct Line {
    friction: Friction,
    start: CurveStart,
    frequency: Frequency,
    /// Number of the piece, counted from 1 along the frequency.
    piece: Option<usize>,
    found: Result<CurvePoint, Error>,
}

impl CurveReport {
    /// Returns the lines of one curve, with ascending frequency.
    fn lines(&self, friction: Friction, curve: &Curve) -> Vec<Line> {
        let at = |r| self.band.frequency(&self.system, r);
        let pieces = (1..).zip(&curve.pieces);
        let mut lines: Vec<Line> = pieces
            .flat_map(|(piece, found)| {
                found.points.iter().map(move |point| Line {
                    friction,
                    start: curve.start,
                    frequency: at(point.r),
                    piece: Some(piece),
                    found: Ok(point.clone()),
                })
            })
            .collect();
        for gap in &curve.gaps {
            let ends = [gap.from, gap.to];
            let ends = ends.iter().take(if gap.from < gap.to { 2 } else { 1 });
            lines.extend(ends.map(|r| Line {
                friction,
                start: curve.start,
                frequency: at(*r),
                piece: None,
                found: Err(gap.reason),
            }));
        }
        lines.sort_by(|a, b| a.frequency.r.total_cmp(&b.frequency.r));
        lines
    }

    fn answer(&self, line: &Line) -> &'static str {
        words::on_curve(line.found.as_ref().map_err(|error| *error))
    }

    /// Returns the values that a line contains once, and not for each motion.
    fn once(&self, line: &Line) -> Vec<Value<'static>> {
        let mut values = line.friction.values();
        if self.swept {
            values.push(words::start(line.start).into());
        }
        values.extend(line.frequency.values());
        values.push(line.piece.map_or(Value::Missing, Value::Count));
        let point = line.found.as_ref().ok();
        values.push(point.map_or(Value::Missing, |point| words::regime(point.regime).into()));
        values.push(self.answer(line).into());
        values.push(point.map_or(Value::Missing, |point| point.stops.into()));
        values.push(point.map_or(Value::Missing, |point| (point.period as usize).into()));
        let omega = self.system.angular_frequency(line.frequency.r);
        values.push(
            point
                .map(|point| self.measure.force(point.contact_force))
                .into(),
        );
        values.push(
            point
                .map(|point| self.measure.power(point.friction_work, omega))
                .into(),
        );
        let sign = if self.request.turned { -1.0 } else { 1.0 };
        values.extend([
            point
                .map(|point| self.measure.length(sign * point.offset))
                .into(),
            point.map(|point| point.marginal).into(),
            point.map(|point| point.from_rest).into(),
        ]);
        values
    }

    fn once_names(&self) -> Vec<String> {
        let start: &[&str] = if self.swept { &["from"] } else { &[] };
        let groups = [self.frictions.names(), start, self.band.names()].concat();
        let mut names: Vec<String> = groups.into_iter().map(str::to_owned).collect();
        let words = ["piece", "regime", "answer", "stops", "period"];
        names.extend(words.map(str::to_owned));
        names.push(self.measure.name("contact_force", "contact_force_N"));
        names.push(self.measure.name("friction_work", "friction_power_W"));
        names.push(self.measure.length_name("offset"));
        names.extend(["marginal", "from_rest"].map(str::to_owned));
        names
    }

    fn movement(&self, line: &Line, movement: Option<&Movement>) -> Vec<Value<'static>> {
        let measure = &self.measure;
        let omega = self.system.angular_frequency(line.frequency.r);
        let swing = movement.map(|movement| movement.swing);
        let mut values: Vec<Value<'static>> = vec![
            swing.map(|swing| measure.length(swing.amplitude)).into(),
            movement
                .map(|movement| measure.length(movement.centred))
                .into(),
            swing
                .and_then(|swing| swing.phase)
                .map(|phase| measure.angle(phase))
                .into(),
            movement
                .and_then(|movement| movement.fundamental_phase)
                .map(|phase| measure.angle(phase))
                .into(),
        ];
        if self.request.rates {
            let rates = movement.and_then(|movement| movement.rates);
            values.push(
                rates
                    .map(|(velocity, _)| measure.velocity(velocity, omega))
                    .into(),
            );
            values.push(
                rates
                    .map(|(_, rate)| measure.acceleration(rate, omega))
                    .into(),
            );
        }
        for index in 0..self.request.harmonics.len() {
            let harmonic = movement.and_then(|movement| movement.harmonics.get(index));
            let missing = [Value::Missing, Value::Missing];
            values
                .extend(harmonic.map_or(missing, |harmonic| harmonics::values(*harmonic, measure)));
        }
        values
    }

    /// Returns the movements of a line in the order of the parts. The contact's movement has the sign that the scene
    /// gives.
    fn movements(&self, line: &Line) -> Vec<Vec<Value<'static>>> {
        let places = 0..self.parts.len();
        let found = places.map(|index| {
            line.found
                .as_ref()
                .ok()
                .and_then(|point| point.movements.get(index))
        });
        found
            .map(|movement| self.movement(line, movement))
            .collect()
    }

    fn names_of(&self, part: &str) -> Vec<String> {
        let measure = &self.measure;
        let mut names = vec![
            measure.length_name(&format!("{part}.amplitude")),
            measure.length_name(&format!("{part}.centred")),
            measure.angle_name(&format!("{part}.phase")),
            measure.angle_name(&format!("{part}.fundamental_phase")),
        ];
        if self.request.rates {
            let velocity = measure.name("velocity", "velocity_m_s");
            let acceleration = measure.name("acceleration", "acceleration_m_s2");
            names.extend([velocity, acceleration].map(|name| format!("{part}.{name}")));
        }
        names.extend(harmonics::names(part, &self.request.harmonics, measure));
        names
    }
}

impl Report for CurveReport {
    type Point = Line;

    fn len(&self) -> usize {
        let points = |curve: &Curve| {
            curve
                .pieces
                .iter()
                .map(|piece| piece.points.len())
                .sum::<usize>()
        };
        self.curves.iter().map(|(_, curve)| points(curve)).sum()
    }

    fn each(&self, visit: Visitor<'_, Line>) -> Result<(), Failure> {
        for (friction, curve) in &self.curves {
            for line in self.lines(*friction, curve) {
                visit(&line)?;
            }
        }
        Ok(())
    }

    fn columns(&self) -> Vec<Column> {
        let measure = &self.measure;
        let mut columns = self.frictions.columns();
        if self.swept {
            columns.push(Column::words(&["from"], ["down"]));
        }
        columns.extend(self.band.columns());
        let physical = measure.scale().is_some();
        columns.extend([
            Column::counts(&["piece"]),
            Column::words(&["regime"], ["continuous"]),
            Column::words(&["answer"], ["last 64 cycles"]),
            Column::counts(&["stops"]),
            Column::counts(&["period"]),
            Column::computed(&["force", if physical { "(N)" } else { "" }]),
            Column::computed(if physical {
                &["power", "(W)"]
            } else {
                &["work", ""]
            }),
            Column::computed(&["offset", measure.length_title()]),
            Column::words(&["marginal"], ["false"]),
            Column::words(&["from", "rest"], ["false"]),
        ]);
        for part in &self.parts {
            let names = self.names_of(&part.name);
            let named = names.iter().map(|name| {
                let name = name
                    .strip_prefix(&format!("{}.", part.name))
                    .unwrap_or(name);
                Column::computed(&[&part.name, name])
            });
            columns.extend(named);
        }
        columns
    }

    fn rows<'a>(&'a self, line: &'a Line) -> Vec<Vec<Value<'a>>> {
        vec![self.record(line)]
    }

    fn names(&self) -> Vec<String> {
        let parts = self.parts.iter().flat_map(|part| self.names_of(&part.name));
        self.once_names().into_iter().chain(parts).collect()
    }

    fn record<'a>(&'a self, line: &'a Line) -> Vec<Value<'a>> {
        let movements = self.movements(line).into_iter().flatten();
        self.once(line).into_iter().chain(movements).collect()
    }

    fn json(&self, line: &Line) -> Json {
        let once = self.once_names().into_iter().zip(self.once(line));
        let mut fields: serde_json::Map<String, Json> =
            once.map(|(name, value)| (name, value.json())).collect();
        for (part, values) in self.parts.iter().zip(self.movements(line)) {
            let prefix = format!("{}.", part.name);
            let names = self.names_of(&part.name).into_iter();
            let names = names.map(|name| name.strip_prefix(&prefix).unwrap_or(&name).to_owned());
            let object: serde_json::Map<String, Json> = names
                .zip(values)
                .map(|(name, value)| (name, value.json()))
                .collect();
            fields.insert(part.name.clone(), Json::Object(object));
        }
        Json::Object(fields)
    }
}
