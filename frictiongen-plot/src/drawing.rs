//! Where the parts of a sketch lie, and how they look.

use crate::geometry::Point;
use crate::label::Label;
use crate::layer::Anchor;
use crate::palette::{INK, Rgb};
use crate::pen::{Pen, TEXT};
use crate::sketch::{Contact, End, Excitation, Sketch, Spring};
use crate::svg::Canvas;

const WIDTH: f64 = 46.0;
const HEIGHT: f64 = 44.0;
const GAP: f64 = 58.0;
/// What a mass and a gap shrink to at most.
const LEAST: f64 = 0.48;
/// A spring above the masses with its label.
const LANE: f64 = 34.0;
const HATCH: f64 = 7.0;
/// Between a mass and what it rubs on.
const PAD: f64 = 7.0;
/// How far a spring above stands from its mass's middle.
const RISER: f64 = 11.0;
const MASS: Rgb = Rgb(0xe9, 0xee, 0xf4);
const FRICTION: Rgb = Rgb(0xb3, 0x3a, 0x1e);
const FORCE: Rgb = Rgb(0x00, 0x5f, 0xad);

/// A sketch with the places of its parts, from its upper left corner.
#[derive(Debug)]
pub(crate) struct Drawing<'a> {
    sketch: &'a Sketch,
    /// Springs in the row, by the gap they fill.
    direct: Vec<(usize, &'a Spring)>,
    /// Springs above it: from which station to which, and in which lane.
    above: Vec<(usize, usize, usize, &'a Spring)>,
    contact: Option<&'a Contact>,
    base: bool,
    wall: bool,
    lanes: usize,
    /// The widths of a mass and of a gap.
    pitch: (f64, f64),
}

impl<'a> Drawing<'a> {
    /// Parts come nearer to each other where there is less room than they would take.
    pub(crate) fn new(sketch: &'a Sketch, room: f64) -> Option<Self> {
        let count = sketch.masses.len();
        if !(1..=Sketch::MOST).contains(&count) {
            return None;
        }
        // Stations from left to right: the base, the masses, the wall.
        let station = |end: End| match end {
            End::Base => Some(0),
            End::Mass(index) => (index < count).then_some(index + 1),
            End::Wall => Some(count + 1),
        };
        let stations = |(a, b): (End, End)| {
            let (a, b) = (station(a)?, station(b)?);
            let (low, high) = (a.min(b), a.max(b));
            (low != high && (low, high) != (0, count + 1)).then_some((low, high))
        };
        let mut drawing = Self {
            sketch,
            direct: Vec::new(),
            above: Vec::new(),
            contact: sketch
                .contact
                .as_ref()
                .filter(|contact| stations(contact.between).is_some()),
            base: matches!(sketch.excitation, Excitation::Base { .. }),
            wall: false,
            lanes: 0,
            pitch: (WIDTH, GAP),
        };
        let mut far: Vec<(usize, usize, &Spring)> = Vec::new();
        for spring in &sketch.springs {
            let Some((low, high)) = stations(spring.between) else {
                continue;
            };
            drawing.base |= low == 0;
            drawing.wall |= high == count + 1;
            if high == low + 1 && drawing.direct.iter().all(|(gap, _)| *gap != low) {
                drawing.direct.push((low, spring));
            } else {
                far.push((low, high, spring));
            }
        }
        if let Some(contact) = drawing.contact {
            drawing.base |= [contact.between.0, contact.between.1].contains(&End::Base);
        }
        far.sort_by_key(|(low, high, _)| (high - low, *low));
        for (low, high, spring) in far {
            // The longer a spring, the higher: none crosses another's risers needlessly.
            let taken = drawing
                .above
                .iter()
                .filter(|(a, b, ..)| *a < high && low < *b)
                .map(|(_, _, lane, _)| lane + 1);
            let lane = taken.max().unwrap_or(0);
            drawing.lanes = drawing.lanes.max(lane + 1);
            drawing.above.push((low, high, lane, spring));
        }
        let (wide, _) = drawing.size();
        let (last, _) = drawing.sides(count);
        if room < wide {
            // All but what stands to the right of the last mass and the base shrinks.
            let share = ((room - (wide - last)) / last).clamp(LEAST, 1.0);
            drawing.pitch = (share * WIDTH, share * GAP);
        }
        Some(drawing)
    }

    fn count(&self) -> usize {
        self.sketch.masses.len()
    }

    /// The left edge of the first mass.
    fn start(&self) -> f64 {
        if self.base { HATCH + self.pitch.1 } else { 2.0 }
    }

    /// The two sides of a station.
    fn sides(&self, station: usize) -> (f64, f64) {
        let left = self.start() + (self.pitch.0 + self.pitch.1) * (station as f64 - 1.0);
        match station {
            0 => (HATCH, HATCH),
            _ if station == self.count() + 1 => (left, left),
            _ => (left, left + self.pitch.0),
        }
    }

    fn top(&self) -> f64 {
        LANE * self.lanes as f64 + 6.0 + self.over()
    }

    fn force(&self) -> Option<(usize, &'a Label)> {
        match &self.sketch.excitation {
            Excitation::Force { mass, label } if *mass < self.count() => Some((*mass, label)),
            _ => None,
        }
    }

    /// What stands under the masses.
    fn under(&self) -> f64 {
        let contact = match self.contact {
            Some(_) => PAD + HATCH + TEXT + 6.0,
            None => 2.0,
        };
        let base = match &self.sketch.excitation {
            Excitation::Base { .. } => PAD + HATCH + TEXT + 10.0,
            _ => 2.0,
        };
        contact.max(base)
    }

    pub(crate) fn size(&self) -> Point {
        let (_, last) = self.sides(self.count());
        let wall = if self.wall {
            last + self.pitch.1 + HATCH
        } else {
            last + 2.0
        };
        let force = self.force().map_or(0.0, |(mass, label)| {
            self.sides(mass + 1).1
                + 46.0
                + if self.is_free(mass) {
                    label.width(TEXT)
                } else {
                    0.0
                }
        });
        (wall.max(force), self.top() + HEIGHT + self.under())
    }

    /// Whether nothing stands to the right of a mass.
    fn is_free(&self, mass: usize) -> bool {
        mass + 1 == self.count() && !self.wall
    }

    pub(crate) fn draw(&self, canvas: &mut Canvas, (left, top): Point) {
        let mut pen = Pen::new(canvas, (left, top));
        let row = self.top();
        self.ground(&mut pen, row);
        for (gap, spring) in &self.direct {
            let (from, to) = (self.sides(*gap).1, self.sides(gap + 1).0);
            let middle = row + 0.5 * HEIGHT;
            pen.spring(from, to, middle);
            pen.text(
                &spring.label,
                (0.5 * (from + to), middle + 21.0),
                Anchor::Middle,
                INK,
            );
        }
        for (low, high, lane, spring) in &self.above {
            self.far_spring(&mut pen, (*low, *high), *lane, &spring.label);
        }
        if let Some(contact) = self.contact {
            self.friction(&mut pen, contact, row);
        }
        for (index, mass) in self.sketch.masses.iter().enumerate() {
            let (left, _) = self.sides(index + 1);
            pen.rect((left, row, self.pitch.0, HEIGHT), MASS, Some(INK));
            pen.text(
                mass,
                (left + 0.5 * self.pitch.0, row + 0.5 * HEIGHT + 5.0),
                Anchor::Middle,
                INK,
            );
        }
        self.excitation(&mut pen, row);
    }

    /// The base and the wall.
    fn ground(&self, pen: &mut Pen<'_>, row: f64) {
        let lowest = row + HEIGHT + PAD;
        let highest = |station: usize| {
            let lanes = self
                .above
                .iter()
                .filter(|(low, high, ..)| *low == station || *high == station);
            lanes
                .map(|(_, _, lane, _)| self.lane(*lane) - 8.0)
                .fold(row - 4.0, f64::min)
        };
        if self.base {
            pen.hatched((HATCH, highest(0)), (HATCH, lowest), (-1.0, 0.0));
        }
        if self.wall {
            let station = self.count() + 1;
            let x = self.sides(station).0;
            pen.hatched((x, highest(station)), (x, lowest), (1.0, 0.0));
        }
    }

    /// What an arrow over the row takes.
    fn over(&self) -> f64 {
        let over = self.force().is_some_and(|(mass, _)| !self.is_free(mass));
        if over { 10.0 } else { 0.0 }
    }

    /// The height of a lane's springs.
    fn lane(&self, lane: usize) -> f64 {
        self.top() - 14.0 - self.over() - LANE * lane as f64
    }

    fn far_spring(
        &self,
        pen: &mut Pen<'_>,
        (low, high): (usize, usize),
        lane: usize,
        label: &Label,
    ) {
        let (row, y) = (self.top(), self.lane(lane));
        // Springs of one mass rise beside each other.
        let shift = (RISER - 4.0 * (lane % 4) as f64) * self.pitch.0 / WIDTH;
        let end = |station: usize, sign: f64| {
            let (left, right) = self.sides(station);
            if left == right {
                left
            } else {
                0.5 * (left + right) + sign * shift
            }
        };
        let (from, to) = (end(low, 1.0), end(high, -1.0));
        for (station, x) in [(low, from), (high, to)] {
            let (left, right) = self.sides(station);
            if left != right {
                pen.line(&[(x, row), (x, y)], INK, 1.2);
            }
        }
        // The zigzag is over a gap, where nothing rises.
        let (low, high) = (low as f64, high as f64);
        let gap = (0.5 * (low + high) - 0.5).floor().max(low) as usize;
        let middle = 0.5 * (self.sides(gap).1 + self.sides(gap + 1).0);
        let half = 0.5 * self.pitch.1;
        pen.line(&[(from, y), (middle - half, y)], INK, 1.2);
        pen.line(&[(middle + half, y), (to, y)], INK, 1.2);
        pen.spring(middle - half, middle + half, y);
        pen.text(label, (middle, y - 11.0), Anchor::Middle, INK);
    }

    fn friction(&self, pen: &mut Pen<'_>, contact: &Contact, row: f64) {
        let masses: Vec<usize> = [contact.between.0, contact.between.1]
            .into_iter()
            .filter_map(|end| match end {
                End::Mass(index) => Some(index + 1),
                End::Base | End::Wall => None,
            })
            .collect();
        let bottom = row + HEIGHT;
        let (Some(first), Some(last)) = (masses.iter().min(), masses.iter().max()) else {
            return;
        };
        let (left, right) = self.sides(*first);
        let middle = 0.5 * (left + right);
        let floor = bottom + PAD;
        pen.rect((middle - 13.0, bottom, 26.0, PAD), FRICTION, None);
        if first != last {
            // An arm of the farther mass reaches under the nearer one.
            let (_, end) = self.sides(*last);
            let arm = end - 0.5 * self.pitch.0;
            pen.rect(
                (middle - 18.0, floor, arm - middle + 18.0, 4.0),
                MASS,
                Some(INK),
            );
            pen.rect((arm - 4.0, bottom, 4.0, PAD + 4.0), MASS, Some(INK));
        } else if [contact.between.0, contact.between.1].contains(&End::Base) {
            pen.hatched((right, floor), (HATCH, floor), (0.0, 1.0));
        } else {
            pen.hatched((right + 4.0, floor), (left - 4.0, floor), (0.0, 1.0));
        }
        pen.text(
            &contact.label,
            (middle, floor + HATCH + TEXT),
            Anchor::Middle,
            FRICTION,
        );
    }

    fn excitation(&self, pen: &mut Pen<'_>, row: f64) {
        if let Some((mass, label)) = self.force() {
            let x = self.sides(mass + 1).1;
            if self.is_free(mass) {
                let y = row + 0.5 * HEIGHT;
                pen.arrow((x, y), (x + 38.0, y), FORCE);
                pen.text(label, (x + 43.0, y + 5.0), Anchor::Start, FORCE);
            } else {
                let y = row + 8.0;
                pen.arrow((x, y), (x + 36.0, y), FORCE);
                pen.text(label, (x + 3.0, row - 4.0), Anchor::Start, FORCE);
            }
        }
        if let Excitation::Base { label } = &self.sketch.excitation {
            let y = row + HEIGHT + PAD + HATCH + 5.0;
            let middle = HATCH + 18.0;
            pen.arrow((middle, y), (middle + 18.0, y), FORCE);
            pen.arrow((middle, y), (middle - 18.0, y), FORCE);
            pen.text(label, (HATCH, y + TEXT), Anchor::Start, FORCE);
        }
    }
}
