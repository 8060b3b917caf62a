//! Questions of the page.

use frictiongen::{Of, System};
use frictiongen_plot::{Figure, Panel, PanelFrame};
use frictiongen_syntax::read_scene;
use serde::Deserialize;
use serde_json::{Value, json};
use std::cell::RefCell;
use std::rc::Rc;

/// Largest number of masses of a scene in the page.  More masses take too long for an answer within a second.
pub const MOST_MASSES: usize = 12;
/// Largest length of a description in bytes.
pub const LONGEST: usize = 20_000;

/// A question of the page.  Each kind of question uses some of the fields.
#[derive(Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Question {
    /// The kind of the question.
    pub ask: String,
    /// The description of the scene.
    pub text: String,
    /// Frequency ratio r.
    pub r: f64,
    /// Frequency ratios r.
    pub rs: Vec<f64>,
    /// Friction ratio β.
    pub beta: f64,
    /// Friction ratios β.
    pub betas: Vec<f64>,
    /// The lowest frequency ratio of the range.
    pub from: f64,
    /// The highest frequency ratio of the range.
    pub to: f64,
    /// The highest friction ratio of the map.
    pub top: Option<f64>,
    /// Index of the mass of which the answer tells the motion.  Without an index it is the contact.
    pub of: Option<usize>,
    /// Starts of the curves: `rest`, `up`, `down`.
    pub starts: Vec<String>,
    /// Bound on the work, in units of about 10 µs.
    pub work: usize,
    /// Points of a curve or rows of a map that were computed before: numbers r and amplitude, and the regime.
    pub points: Vec<(f64, Option<f64>, Option<usize>)>,
    /// Cells of a map that were computed before, as indices of regimes, row after row.
    pub cells: Vec<Option<usize>>,
    /// True to omit the pictures of an answer.
    pub bare: bool,
}

thread_local! {
    /// The last scene, because most questions are about the same scene as the question before.
    static LAST: RefCell<Option<(String, Rc<System>)>> = const { RefCell::new(None) };
}

impl Question {
    /// Returns the system of the description.
    pub fn system(&self) -> Result<Rc<System>, String> {
        let last = LAST.with_borrow(|last| {
            let known = last.as_ref().filter(|(text, _)| *text == self.text);
            known.map(|(_, system)| Rc::clone(system))
        });
        if let Some(system) = last {
            return Ok(system);
        }
        let system = Rc::new(read(&self.text).map_err(|faults| {
            let lines = faults.into_iter().map(|fault| fault.message);
            lines.collect::<Vec<_>>().join("\n")
        })?);
        LAST.with_borrow_mut(|last| *last = Some((self.text.clone(), Rc::clone(&system))));
        Ok(system)
    }

    /// Returns the motion of which the answer tells the amplitude.
    pub fn motion(&self) -> Of {
        self.of.map_or(Of::Contact, Of::Mass)
    }
}

/// A message at a position of the description.  A message without a position has line 0.
#[derive(Debug)]
pub struct Fault {
    /// The line, counted from 1.
    pub line: usize,
    /// The column, counted in characters from 1.
    pub column: usize,
    /// The message.
    pub message: String,
}

impl Fault {
    fn whole(message: String) -> Vec<Self> {
        vec![Self {
            line: 0,
            column: 0,
            message,
        }]
    }
}

/// Reads a description.
pub fn read(text: &str) -> Result<System, Vec<Fault>> {
    if text.len() > LONGEST {
        return Err(Fault::whole(format!(
            "this page reads descriptions of up to {LONGEST} bytes; this one has {}",
            text.len()
        )));
    }
    let scene = read_scene(text).map_err(|faults| {
        let list = faults.list.into_iter();
        list.map(|fault| Fault {
            line: fault.line,
            column: fault.column,
            message: fault.message,
        })
        .collect::<Vec<_>>()
    })?;
    let count = scene.masses.len();
    if count > MOST_MASSES {
        return Err(Fault::whole(format!(
            "this page answers for up to {MOST_MASSES} masses; the scene has {count}, for which the command `frictiongen` answers"
        )));
    }
    System::try_from(scene).map_err(|error| Fault::whole(error.to_string()))
}

/// Returns a picture of one panel, laid out for a narrow page, and the position of its frame.
pub fn picture(panel: Panel, height: f64) -> Value {
    let panel = Panel {
        height: Some(height),
        ..panel
    };
    let figure = Figure::new("", "", 1, vec![panel]).narrow();
    let (svg, frames) = figure.svg_with_frames();
    json!({ "svg": svg, "frame": frames.first().map(place) })
}

fn place(frame: &PanelFrame) -> Value {
    json!({
        "left": frame.left, "top": frame.top, "width": frame.width, "height": frame.height,
        "x": [frame.x.0, frame.x.1], "y": [frame.y.0, frame.y.1],
    })
}
