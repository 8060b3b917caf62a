//! Where the parts of a sketch lie, and how they look.

use crate::geometry::{Point, Rect};
use crate::label::Label;
use crate::layer::Anchor;
use crate::palette::{INK, Rgb, SOFT};
use crate::sketch::{Contact, End, Excitation, Sketch, Spring};
use crate::svg::{Canvas, Style};

const WIDTH: f64 = 46.0;
const HEIGHT: f64 = 44.0;
const GAP: f64 = 58.0;
/// A spring above the masses with its label.
const LANE: f64 = 30.0;
const TEXT: f64 = 14.0;
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
    /// What stands above it.
    above: Vec<Above<'a>>,
    contact: Option<&'a Contact>,
    base: bool,
    wall: bool,
    lanes: usize,
}

/// A spring or a dashpot above the row.
#[derive(Clone, Copy, Debug)]
struct Above<'a> {
    low: usize,
    high: usize,
    lane: usize,
    label: &'a Label,
    dashpot: bool,
}

impl<'a> Drawing<'a> {
    pub(crate) fn new(sketch: &'a Sketch) -> Option<Self> {
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
        };
        let mut far: Vec<(usize, usize, &Label, bool)> = Vec::new();
        for spring in &sketch.springs {
            let Some((low, high)) = stations(spring.between) else {
                continue;
            };
            drawing.base |= low == 0;
            drawing.wall |= high == count + 1;
            if high == low + 1 && drawing.direct.iter().all(|(gap, _)| *gap != low) {
                drawing.direct.push((low, spring));
            } else {
                far.push((low, high, &spring.label, false));
            }
        }
        for dashpot in &sketch.dashpots {
            let Some((low, high)) = stations(dashpot.between) else {
                continue;
            };
            drawing.base |= low == 0;
            drawing.wall |= high == count + 1;
            far.push((low, high, &dashpot.label, true));
        }
        if let Some(contact) = drawing.contact {
            drawing.base |= [contact.between.0, contact.between.1].contains(&End::Base);
        }
        far.sort_by_key(|(low, high, ..)| (high - low, *low));
        for (low, high, label, dashpot) in far {
            // The longer a spring, the higher: none crosses another's risers needlessly.
            let taken = drawing
                .above
                .iter()
                .filter(|other| other.low < high && low < other.high)
                .map(|other| other.lane + 1);
            let lane = taken.max().unwrap_or(0);
            drawing.lanes = drawing.lanes.max(lane + 1);
            drawing.above.push(Above {
                low,
                high,
                lane,
                label,
                dashpot,
            });
        }
        Some(drawing)
    }

    fn count(&self) -> usize {
        self.sketch.masses.len()
    }

    /// The left edge of the first mass.
    fn start(&self) -> f64 {
        if self.base { HATCH + GAP } else { 2.0 }
    }

    /// The two sides of a station.
    fn sides(&self, station: usize) -> (f64, f64) {
        let pitch = WIDTH + GAP;
        let left = self.start() + pitch * (station as f64 - 1.0);
        match station {
            0 => (HATCH, HATCH),
            _ if station == self.count() + 1 => (left, left),
            _ => (left, left + WIDTH),
        }
    }

    fn top(&self) -> f64 {
        // The label of a force between masses stands over its arrow.
        let label = match self.force() {
            Some((mass, _)) if !self.is_free(mass) => 10.0,
            _ => 0.0,
        };
        LANE * self.lanes as f64 + 6.0 + label
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
            last + GAP + HATCH
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
        let mut pen = Pen { canvas, left, top };
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
        for above in &self.above {
            self.far(&mut pen, above);
        }
        if let Some(contact) = self.contact {
            self.friction(&mut pen, contact, row);
        }
        for (index, mass) in self.sketch.masses.iter().enumerate() {
            let (left, _) = self.sides(index + 1);
            pen.rect((left, row, WIDTH, HEIGHT), MASS, Some(INK));
            pen.text(
                mass,
                (left + 0.5 * WIDTH, row + 0.5 * HEIGHT + 5.0),
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
                .filter(|above| above.low == station || above.high == station);
            lanes
                .map(|above| self.lane(above.lane) - 8.0)
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

    /// The height of a lane's springs.
    fn lane(&self, lane: usize) -> f64 {
        self.top() - 13.0 - LANE * lane as f64
    }

    fn far(&self, pen: &mut Pen<'_>, above: &Above<'_>) {
        let (low, high, lane) = (above.low, above.high, above.lane);
        let (row, y) = (self.top(), self.lane(lane));
        // Springs of one mass rise beside each other.
        let shift = RISER - 4.0 * (lane % 4) as f64;
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
        let half = f64::min(0.5 * GAP, 0.5 * (to - from));
        // Where the row has its own spring, the label stands apart from the middle of others.
        let middle = 0.5 * (from + to);
        pen.line(&[(from, y), (middle - half, y)], INK, 1.2);
        pen.line(&[(middle + half, y), (to, y)], INK, 1.2);
        if above.dashpot {
            pen.dashpot(middle - half, middle + half, y);
        } else {
            pen.spring(middle - half, middle + half, y);
        }
        pen.text(
            above.label,
            (middle + half + 2.0, y - 5.0),
            Anchor::Start,
            INK,
        );
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
            let arm = end - 0.5 * WIDTH;
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
                let y = row + 7.0;
                pen.arrow((x, y), (x + 36.0, y), FORCE);
                pen.text(label, (x + 2.0, y - 6.0), Anchor::Start, FORCE);
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

/// Draws from a corner.
struct Pen<'c> {
    canvas: &'c mut Canvas,
    left: f64,
    top: f64,
}

impl Pen<'_> {
    fn line(&mut self, points: &[Point], colour: Rgb, width: f64) {
        let moved = points
            .iter()
            .map(|(x, y)| (x + self.left, y + self.top))
            .collect();
        self.canvas.path(&[moved], colour, width, "");
    }

    fn rect(
        &mut self,
        (left, top, width, height): (f64, f64, f64, f64),
        fill: Rgb,
        edge: Option<Rgb>,
    ) {
        let rect = Rect {
            left: left + self.left,
            top: top + self.top,
            width,
            height,
        };
        self.canvas
            .rect(rect, Some(fill), edge.map(|edge| (edge, 1.2)));
    }

    fn text(&mut self, label: &Label, (x, y): Point, anchor: Anchor, colour: Rgb) {
        let style = Style::new(TEXT, anchor).coloured(colour);
        self.canvas
            .text(label, (x + self.left, y + self.top), style);
    }

    /// A zigzag from left to right, with straight ends.
    fn spring(&mut self, from: f64, to: f64, y: f64) {
        let turns = 8;
        let lead = f64::min(9.0, 0.15 * (to - from));
        let step = (to - from - 2.0 * lead) / f64::from(turns);
        let mut points = vec![(from, y), (from + lead, y)];
        for turn in 0..turns {
            let side = if turn % 2 == 0 { -5.5 } else { 5.5 };
            points.push((from + lead + step * (f64::from(turn) + 0.5), y + side));
        }
        points.extend([(to - lead, y), (to, y)]);
        self.line(&points, INK, 1.2);
    }

    /// A piston in a cylinder that is open to the right.
    fn dashpot(&mut self, from: f64, to: f64, y: f64) {
        let middle = 0.5 * (from + to);
        let (left, right) = (middle - 9.0, middle + 8.0);
        self.line(&[(from, y), (left, y)], INK, 1.2);
        let cylinder = [
            (right, y - 7.0),
            (left, y - 7.0),
            (left, y + 7.0),
            (right, y + 7.0),
        ];
        self.line(&cylinder, INK, 1.2);
        self.line(&[(middle, y - 5.0), (middle, y + 5.0)], INK, 2.4);
        self.line(&[(middle, y), (to, y)], INK, 1.2);
    }

    /// A line with hatching on one side.
    fn hatched(&mut self, from: Point, to: Point, side: Point) {
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let length = dx.abs().max(dy.abs());
        let count = (length / 6.0).floor().max(1.0);
        for index in 0..count as usize {
            let share = (index as f64 + 1.0) / count;
            let at = (from.0 + share * dx, from.1 + share * dy);
            let back = 5.0 / length;
            let end = (
                at.0 - back * dx + 6.0 * side.0,
                at.1 - back * dy + 6.0 * side.1,
            );
            self.line(&[at, end], SOFT, 0.8);
        }
        self.line(&[from, to], INK, 1.6);
    }

    fn arrow(&mut self, from: Point, to: Point, colour: Rgb) {
        let sign = if from.0 < to.0 { 1.0 } else { -1.0 };
        self.line(&[from, (to.0 - 5.0 * sign, to.1)], colour, 1.6);
        let (x, y) = (to.0 + self.left, to.1 + self.top);
        let head = vec![(x, y), (x - 8.0 * sign, y - 3.6), (x - 8.0 * sign, y + 3.6)];
        self.canvas.areas(&[head], colour);
    }
}
