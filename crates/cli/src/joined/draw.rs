//! Draws results of scenes with several contacts.

use super::Question;
use crate::args::ShadeArgument;
use crate::asked::MovingPart;
use crate::destination::OutputFormat;
use crate::failure::Failure;
use crate::interrupt;
use crate::picture;
use crate::progress::Progress;
use frictiongen::Regime;
use frictiongen::study::columns::{Frequency, FrictionSetting, JoinedRow};
use frictiongen::study::joined::JoinedHistory;
use frictiongen::study::response::MotionQuantity;
use frictiongen_plot::desk::{
    ContactTrack, JoinedCells, JoinedClasses, JoinedCurve, JoinedMotion, Scales,
    joined_curve_figure, joined_map_figure, joined_motion_figure,
};
use frictiongen_plot::{Figure, Label};
use std::io::Write;

/// Number of steps in r along the line of the smallest friction at which no contact slides.
const LINE: usize = 400;

/// Type of a picture of steady states: response curves over frequency, or a map.
#[derive(Clone, Copy, Debug)]
pub enum Picture {
    /// Amplitudes over frequency. The first flag is true for a logarithmic frequency axis, the second for logarithmic
    /// amplitude axes.
    Curve(bool, bool),
    /// A map over frequency and friction. The colours of the map show the regimes, or the amplitude of the first mass.
    Map(ShadeArgument),
}

/// Draws a motion of a scene with several contacts over time.
pub fn motion(
    question: &Question<'_>,
    motion: (&JoinedHistory, Frequency),
    caption: &str,
    (form, out): (OutputFormat, &mut dyn Write),
) -> Result<(), Failure> {
    let figure = motion_figure(question, motion, caption);
    picture::write_motion(figure, question.system, &question.measure, (form, out))
}

/// Returns the figure of a motion over time in a scene with several contacts.
pub fn motion_figure(
    question: &Question<'_>,
    (history, frequency): (&JoinedHistory, Frequency),
    caption: &str,
) -> Figure {
    let mut scales = picture::scales(question.system, false, &question.measure);
    let in_seconds = question.frequencies.are_physical() || question.measure.scale().is_some();
    if in_seconds {
        scales = scales.at(frequency.omega);
    }
    let taus = history.taus.iter();
    let names = question.joined.contact_names().into_iter().enumerate();
    let contacts = names.map(|(index, name)| {
        let sign = question.table().sign(index);
        let states = || {
            let states = history.contacts.iter().filter_map(|all| all.get(index));
            states.map(|now| now.signed(sign))
        };
        ContactTrack {
            name,
            displacement: states()
                .map(|now| scales.length(now.displacement))
                .collect(),
            force: states().map(|now| scales.friction(now.force)).collect(),
            sticks: states().map(|now| now.is_sticking).collect(),
        }
    });
    let masses = question.parts.iter().filter_map(|part| {
        let states = history.states.iter();
        let x = states.map(|(x, _)| Some(scales.length(part.among(x)?)));
        Some((part.name.clone(), x.collect::<Option<_>>()?))
    });
    let motion = JoinedMotion {
        times: taus.map(|tau| scales.time(*tau)).collect(),
        time_label: scales.time_label(),
        displacement_label: scales.displacement_label(),
        force_label: scales.force_label(),
        masses: masses.collect(),
        springs: Vec::new(),
        contacts: contacts.collect(),
    };
    let title = Label::verbatim(&question.system.scene().name);
    let figure = joined_motion_figure(title, &motion);
    picture::under_load(figure, &question.measure, caption)
}

/// Computes steady states over frequency and friction, and draws them as curves or as a map.
pub fn steady(
    question: &Question<'_>,
    picture: Picture,
    (form, out): (OutputFormat, &mut dyn Write),
) -> Result<(), Failure> {
    let frequencies: Vec<Frequency> = question.frequencies.all(question.system).collect();
    let frictions: Vec<FrictionSetting> = question.frictions.all().collect();
    if frequencies.len() < 2 || (matches!(picture, Picture::Map(_)) && frictions.len() < 2) {
        return Err(Failure::new(match picture {
            Picture::Map(_) => "a picture of a map needs two frequencies and two frictions",
            Picture::Curve(..) => "a picture of a curve needs two frequencies",
        }));
    }
    let rows = rows(question)?;
    let figure = steady_figure(question, picture, &rows)?;
    picture::write(figure, question.system, form, out)
}

/// Steady states at one friction for all frequencies.
pub type CurveRows = (FrictionSetting, Vec<JoinedRow>);

/// Computes the steady states of a picture at every frequency and friction.
pub fn rows(question: &Question<'_>) -> Result<Vec<CurveRows>, Failure> {
    let frequencies: Vec<Frequency> = question.frequencies.all(question.system).collect();
    let frictions: Vec<FrictionSetting> = question.frictions.all().collect();
    interrupt::watch();
    let mut progress = Progress::new(frequencies.len() * frictions.len(), "points");
    let mut lines: Vec<CurveRows> = frictions.iter().map(|of| (*of, Vec::new())).collect();
    let table = question.table();
    table.rows(&frequencies, &frictions, |rows| {
        if interrupt::pressed() {
            return Err(Failure::new(
                "stopped: a picture needs all points, so that nothing is written",
            ));
        }
        for ((_, line), row) in lines.iter_mut().zip(rows) {
            line.push(row);
            progress.step();
        }
        Ok(())
    })?;
    Ok(lines)
}

/// Returns the figure of steady states, as curves over frequency or as a map.
pub fn steady_figure(
    question: &Question<'_>,
    picture: Picture,
    rows: &[CurveRows],
) -> Result<Figure, Failure> {
    let frequencies: Vec<Frequency> = question.frequencies.all(question.system).collect();
    let frictions: Vec<FrictionSetting> = question.frictions.all().collect();
    let physical = question.frequencies.are_physical();
    let scales = picture::scales(question.system, physical, &question.measure);
    let title = Label::verbatim(&question.system.scene().name);
    let figure = match picture {
        Picture::Curve(frequency, amplitude) => {
            let scales = scales.with_log(frequency, amplitude);
            let (titles, curves) = curves(question, rows, &scales);
            joined_curve_figure(title, &titles, &curves, &scales)
        }
        Picture::Map(shade) => {
            let axes = (
                frequencies
                    .iter()
                    .map(|at| scales.frequency(at.r))
                    .collect(),
                frictions
                    .iter()
                    .map(|at| scales.friction(at.beta))
                    .collect(),
            );
            let (across, up): (Vec<f64>, Vec<f64>) = axes;
            let cells = cells(question, rows, shade, &scales);
            let limit = limit(question, (&frequencies, &up), &scales)?;
            joined_map_figure(title, (&across, &up), &cells, limit, &scales)
        }
    };
    Ok(picture::under_load(figure, &question.measure, ""))
}

/// Returns the panels of a picture and the curves in the panels. The curves show the amplitude of each motion, and the
/// fraction of the period during which each contact sticks.
fn curves(
    question: &Question<'_>,
    rows: &[CurveRows],
    scales: &Scales,
) -> (Vec<(Label, Label)>, Vec<JoinedCurve>) {
    let held = question.joined.contact_names();
    let contacts = held.len();
    let titles = question.parts.iter().map(|part| {
        let label = scales.showing(part.of).size_label(part.size);
        (Label::verbatim(&part.name), label)
    });
    let held = held.iter().map(|name| {
        let label = "stuck fraction of the period".into();
        (Label::verbatim(&format!("contact {name}")), label)
    });
    let titles: Vec<(Label, Label)> = titles.chain(held).collect();
    let curves = rows.iter().map(|(friction, line)| {
        let motions = question.parts.iter().enumerate().map(|(index, part)| {
            let sizes = line.iter();
            let sizes = sizes.map(|row| scaled(row, (contacts + index, part), scales));
            sizes.collect()
        });
        let held = (0..contacts).map(|index| {
            let fractions = line.iter();
            let fractions = fractions.map(move |row| row.stuck_fraction(index).unwrap_or(f64::NAN));
            fractions.collect()
        });
        let points = line.iter();
        JoinedCurve {
            name: scales.friction_name(friction.beta),
            points: points
                .map(|row| (scales.frequency(row.frequency.r), row.kind()))
                .collect(),
            values: motions.chain(held).collect(),
        }
    });
    (titles, curves.collect())
}

/// Returns the amplitude of the motion with this index in a row, in the unit of its axis.
fn scaled(row: &JoinedRow, (index, part): (usize, &MovingPart), scales: &Scales) -> f64 {
    let size = row.amplitude(index).unwrap_or(f64::NAN);
    in_unit(size, part, (row.frequency.r, scales))
}

/// Converts the amplitude of a motion at the frequency ratio r to the unit of its axis.
pub fn in_unit(size: f64, part: &MovingPart, (r, scales): (f64, &Scales)) -> f64 {
    let scales = scales.showing(part.of);
    match part.size {
        MotionQuantity::Displacement => scales.length_at(r, size),
        rate => scales.rate_at(rate, r, size),
    }
}

/// Returns the contents of a map's cells, row by row from the lowest friction to the highest.
fn cells(
    question: &Question<'_>,
    rows: &[CurveRows],
    shade: ShadeArgument,
    scales: &Scales,
) -> JoinedCells {
    let all = rows.iter().flat_map(|(_, line)| line);
    if shade == ShadeArgument::Amplitude {
        let contacts = question.joined.contact_names().len();
        let Some(part) = question.parts.first() else {
            return JoinedCells::Values(Label::verbatim(""), Vec::new());
        };
        let sizes = all.map(|row| scaled(row, (contacts, part), scales));
        let label = scales.showing(part.of).size_label(part.size);
        let label = Label::verbatim(&format!("{}: ", part.name)).then(&label);
        return JoinedCells::Values(label, sizes.collect());
    }
    let classes = all.map(|row| match row.kind() {
        None => JoinedClasses::Unsettled,
        Some(Regime::Stuck) => JoinedClasses::Stuck,
        Some(Regime::Continuous) => JoinedClasses::Slide,
        Some(_) if row.marginal().is_empty() => JoinedClasses::Stick,
        Some(_) => JoinedClasses::Held(row.marginal().replace(' ', ", ")),
    });
    JoinedCells::Regimes(classes.collect())
}

/// Returns the smallest friction at which no contact slides as a line over frequency. The code caps this friction at
/// four times the largest friction of the map.
fn limit(
    question: &Question<'_>,
    (frequencies, frictions): (&[Frequency], &[f64]),
    scales: &Scales,
) -> Result<Vec<(f64, f64)>, Failure> {
    let ends = frequencies.iter().map(|at| at.r);
    let (low, high) = ends.fold((f64::INFINITY, 0.0_f64), |(low, high), r| {
        (low.min(r), high.max(r))
    });
    let top = 4.0 * frictions.iter().copied().fold(0.0, f64::max);
    let mut points = Vec::new();
    for place in 0..=LINE {
        let r = low + (high - low) * place as f64 / LINE as f64;
        let frequency = Frequency::at(question.system, r);
        let at = question.table().at(frequency).map_err(Failure::new)?;
        // At an undamped resonance, no friction keeps all contacts stuck, so the limit is infinite.
        let limit = at.stuck().map_or(f64::INFINITY, |stuck| stuck.limit());
        points.push((scales.frequency(r), scales.friction(limit).min(top)));
    }
    Ok(points)
}
