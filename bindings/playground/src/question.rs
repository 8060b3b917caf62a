//! The questions that the page asks, and the pictures of their answers.

use frictiongen::{Of, System};
use frictiongen_plot::{Figure, Panel, PanelFrame};
use frictiongen_syntax::read_scene;
use serde::Deserialize;
use serde_json::{Value, json};
use std::cell::RefCell;
use std::rc::Rc;

/// Largest number of masses of a scene in the page. With more masses an answer takes longer than a second.
pub const MOST_MASSES: usize = 12;
/// Largest length of a description in bytes.
pub const LONGEST: usize = 20_000;

/// A question of the page.  Each kind of question uses some of the fields.
#[derive(Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Question {
    /// The kind of the question, such as `scene`.
    pub ask: String,
    /// The description of the scene.
    pub text: String,
    /// The frequency ratio r at which the page wants a steady state.
    pub r: f64,
    /// The frequency ratios r of a curve or a map.
    pub rs: Vec<f64>,
    /// The friction ratio β of a steady state or a curve.
    pub beta: f64,
    /// The friction ratios β of a map.
    pub betas: Vec<f64>,
    /// The lowest frequency ratio of the range that the answer covers.
    pub from: f64,
    /// The highest frequency ratio of the range that the answer covers.
    pub to: f64,
    /// The highest friction ratio of a map. With `None` the answer chooses it.
    pub top: Option<f64>,
    /// Index of the mass whose motion the answer describes. `None` stands for the motion of the contact.
    pub of: Option<usize>,
    /// The starts of the curves: `rest`, `up` for a sweep to higher frequencies, `down` to lower ones.
    pub starts: Vec<String>,
    /// Largest amount of work for the answer, in units of about 10 µs.
    pub work: usize,
    /// Points of a curve that were computed before, each with frequency ratio, amplitude, and index of the regime.
    pub points: Vec<(f64, Option<f64>, Option<usize>)>,
    /// Cells of a map that were computed before, as indices of regimes, row after row.
    pub cells: Vec<Option<usize>>,
    /// True to omit the pictures of an answer.
    pub bare: bool,
}

thread_local! {
    /// The scene of the last question, because most questions are about the same scene as the question before.
    static LAST: RefCell<Option<(String, Rc<System>)>> = const { RefCell::new(None) };
}

impl Question {
    /// Returns the system that the description of the question gives.
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

    /// Returns the motion whose amplitude the answer gives: that of a mass, or that of the contact.
    pub fn motion(&self) -> Of {
        self.of.map_or(Of::Contact, Of::Mass)
    }
}

/// A message about a description, with its position in the text. A message without a position has line 0.
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

/// Parses a description. Returns its system, or the messages about its faults.
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

/// Returns the picture of one panel for a narrow page, and the position of the panel's frame.
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
