//! Computes the positions of the elements of a sketch.

use crate::geometry::Point;
use crate::label::Label;
use crate::pen::TEXT;
use crate::sketch::{ConstantArrow, End, Excitation, Sketch, SketchContact, SliderType, Spring};

/// Usual width of a mass in a sketch, in pixels.
pub(crate) const WIDTH: f64 = 46.0;
/// Height of a mass in a sketch, in pixels.
pub(crate) const HEIGHT: f64 = 44.0;
/// Usual width of a gap between two masses of a sketch, in pixels.
pub(crate) const GAP: f64 = 58.0;
/// Smallest factor by which the masses and gaps of a sketch shrink to fit into the available width.
pub(crate) const LEAST: f64 = 0.48;
/// Height of one level above the row of masses, in pixels. A level contains springs with their labels.
pub(crate) const LANE: f64 = 34.0;
/// Width of the hatching of the base and the wall in a sketch, in pixels.
pub(crate) const HATCH: f64 = 7.0;
/// Height of the pad between a mass and the surface on which it slides, in pixels.
pub(crate) const PAD: f64 = 7.0;

/// Kind of an element that is drawn above the row of masses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Element {
    Spring,
    Dashpot,
    /// A friction contact or a stop.
    Slider(SliderType, i8),
}

/// A spring, a dashpot or a contact that a sketch shows above the row of masses.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Above<'a> {
    /// Index of the element at the left end of the spring, dashpot or contact. The base has the index 0, the masses
    /// follow from 1, and the wall is last.
    pub low: usize,
    /// Index of the element at the right end of the spring, dashpot or contact. The base has the index 0, the masses
    /// follow from 1, and the wall is last.
    pub high: usize,
    /// Level of the spring, dashpot or contact above the row of masses, counted from 0.
    pub lane: usize,
    pub label: &'a Label,
    pub element: Element,
}

/// Positions of the elements of a sketch, relative to its upper left corner.
#[derive(Debug)]
pub(crate) struct Plan<'a> {
    pub sketch: &'a Sketch,
    /// Springs between neighbouring elements of the row. The number is the index of the element at the left end of the
    /// spring.
    pub direct: Vec<(usize, &'a Spring)>,
    /// Springs, dashpots and contacts above the row of masses.
    pub above: Vec<Above<'a>>,
    pub contact: Option<&'a SketchContact>,
    pub base: bool,
    pub wall: bool,
    pub lanes: usize,
    /// Width of a mass and width of a gap between masses, in pixels.
    pub pitch: (f64, f64),
}

impl<'a> Plan<'a> {
    /// Computes the positions of a sketch's elements in the width `room`. If the width is too small, masses and gaps
    /// shrink. Returns `None` if the sketch has no masses or too many.
    pub(crate) fn new(sketch: &'a Sketch, room: f64) -> Option<Self> {
        let count = sketch.masses.len();
        let valued = !sketch.values.is_empty();
        let most = if valued {
            Sketch::MOST_WITH_VALUES
        } else {
            Sketch::MOST
        };
        if !(1..=most).contains(&count) {
            return None;
        }
        // The elements from left to right are the base, the masses and the wall. In the code, each element is a station
        // with an index.
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
        let mut plan = Self {
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
            pitch: if valued { pitch(sketch) } else { (WIDTH, GAP) },
        };
        let mut far: Vec<(usize, usize, &Label, Element)> = Vec::new();
        for spring in &sketch.springs {
            let Some((low, high)) = stations(spring.between) else {
                continue;
            };
            plan.base |= low == 0;
            plan.wall |= high == count + 1;
            if high == low + 1 && plan.direct.iter().all(|(gap, _)| *gap != low) {
                plan.direct.push((low, spring));
            } else {
                far.push((low, high, &spring.label, Element::Spring));
            }
        }
        let dashpots = sketch.dashpots.iter();
        let dashpots = dashpots.map(|one| (one.between, &one.label, Element::Dashpot));
        let sliders = sketch.sliders.iter();
        let sliders = sliders.map(|one| {
            let element = Element::Slider(one.slider_type, one.direction);
            (one.between, &one.label, element)
        });
        for (between, label, element) in dashpots.chain(sliders) {
            let Some((low, high)) = stations(between) else {
                continue;
            };
            plan.base |= low == 0;
            plan.wall |= high == count + 1;
            far.push((low, high, label, element));
        }
        if let Some(contact) = plan.contact {
            plan.base |= [contact.between.0, contact.between.1].contains(&End::Base);
        }
        far.sort_by_key(|(low, high, ..)| (high - low, *low));
        for (low, high, label, element) in far {
            // A longer spring is placed above the shorter springs over which it passes. Springs then rarely cross the
            // vertical ends of other springs.
            let taken = plan
                .above
                .iter()
                .filter(|other| other.low < high && low < other.high)
                .map(|other| other.lane + 1);
            let lane = taken.max().unwrap_or(0);
            plan.lanes = plan.lanes.max(lane + 1);
            plan.above.push(Above {
                low,
                high,
                lane,
                label,
                element,
            });
        }
        let (wide, _) = plan.size();
        let (last, _) = plan.sides(count);
        if room < wide && !valued {
            // Only the masses and the gaps between them shrink. The drawing to the right of the last mass keeps its
            // width.
            let share = ((room - (wide - last)) / last).clamp(LEAST, 1.0);
            plan.pitch = (share * WIDTH, share * GAP);
        }
        Some(plan)
    }

    pub(crate) fn count(&self) -> usize {
        self.sketch.masses.len()
    }

    /// Returns the horizontal position of the left edge of the first mass, in pixels.
    pub(crate) fn start(&self) -> f64 {
        if self.base { HATCH + self.pitch.1 } else { 2.0 }
    }

    /// Returns the horizontal positions of the left and the right side of an element of the row. `station` is the
    /// index of the element: 0 for the base, then the masses, then the wall.
    pub(crate) fn sides(&self, station: usize) -> (f64, f64) {
        let left = self.start() + (self.pitch.0 + self.pitch.1) * (station as f64 - 1.0);
        match station {
            0 => (HATCH, HATCH),
            _ if station == self.count() + 1 => (left, left),
            _ => (left, left + self.pitch.0),
        }
    }

    pub(crate) fn top(&self) -> f64 {
        LANE * self.lanes as f64 + 6.0 + self.over()
    }

    pub(crate) fn force(&self) -> Option<(usize, &'a Label)> {
        match &self.sketch.excitation {
            Excitation::Force { mass, label } if *mass < self.count() => Some((*mass, label)),
            _ => None,
        }
    }

    /// Returns the constant forces whose masses exist.
    pub(crate) fn constant(&self) -> impl Iterator<Item = &'a ConstantArrow> {
        let count = self.count();
        let constant = self.sketch.constant.iter();
        constant.filter(move |own| own.mass < count)
    }

    /// Returns the height needed below the masses, for the contact, for constant forces and for the arrow of the base's
    /// motion, in pixels.
    pub(crate) fn under(&self) -> f64 {
        let contact = match self.contact {
            Some(_) => PAD + HATCH + TEXT + 6.0,
            None => 2.0,
        };
        let base = match &self.sketch.excitation {
            Excitation::Base { .. } => PAD + HATCH + TEXT + 10.0,
            _ => 2.0,
        };
        let constant = self.constant().map(|_| PAD + TEXT + 12.0);
        constant.fold(contact.max(base), f64::max)
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

    /// Returns true if the sketch shows nothing to the right of a mass. `mass` is the index of the mass, from 0.
    pub(crate) fn is_free(&self, mass: usize) -> bool {
        mass + 1 == self.count() && !self.wall
    }

    /// Returns the height needed above the row of masses for the arrow of a force, in pixels. The height is 0 without a
    /// force, or if the arrow is to the right of the last mass.
    pub(crate) fn over(&self) -> f64 {
        let over = self.force().is_some_and(|(mass, _)| !self.is_free(mass));
        if over { 10.0 } else { 0.0 }
    }

    /// Returns the vertical position of the springs at a level above the row of masses. `lane` is the level, counted
    /// from 0.
    pub(crate) fn lane(&self, lane: usize) -> f64 {
        self.top() - 14.0 - self.over() - LANE * lane as f64
    }
}

/// Returns the width of a mass and the width of a gap that leave space for every label of the sketch, in pixels.
fn pitch(sketch: &Sketch) -> (f64, f64) {
    let widest = |labels: &mut dyn Iterator<Item = &Label>| {
        labels.map(|label| label.width(TEXT)).fold(0.0, f64::max)
    };
    let constant = sketch.constant.iter().map(|own| &own.label);
    let masses = sketch.masses.iter().chain(&sketch.values);
    let mass = widest(&mut masses.chain(constant));
    let springs = sketch.springs.iter().map(|spring| &spring.label);
    let sliders = sketch.sliders.iter().map(|slider| &slider.label);
    let gap = widest(&mut springs.chain(sliders));
    (f64::max(WIDTH, mass + 12.0), f64::max(GAP, gap + 14.0))
}
