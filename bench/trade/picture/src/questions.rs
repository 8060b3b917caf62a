//! The panels of the picture: which methods and quantities each panel shows, and its notes.

use frictiongen_plot::Anchor;

/// A panel of the picture.
pub struct Question {
    /// Title above the panel.
    pub title: &'static str,
    /// Height of the panel's frame, in pixels.
    pub height: f64,
    /// Returns true if the panel shows the method, the quantity and the number of masses in the arguments.
    pub shows: fn(&str, &str, usize) -> bool,
    /// Notes in the panel.
    pub notes: &'static [Beside],
}

/// A note beside a mark of a panel.
pub struct Beside {
    /// Method, quantity and number of masses of the mark.
    pub of: (&'static str, &'static str, usize),
    /// Text of the note.
    pub text: &'static str,
    /// Factors by which time and error of the mark are multiplied to give the position of the note.
    pub off: (f64, f64),
    /// Part of the note's text that is at the position of the note: its start, middle or end.
    pub anchor: Anchor,
    /// True if the note is about this method alone and has its colour.
    pub coloured: bool,
}

impl Beside {
    const fn new(
        of: (&'static str, &'static str, usize),
        text: &'static str,
        off: (f64, f64),
        anchor: Anchor,
    ) -> Self {
        Self {
            of,
            text,
            off,
            anchor,
            coloured: true,
        }
    }

    /// Returns this note without the colour of a method, because it is about all methods near the mark.
    const fn about_all(mut self) -> Self {
        self.coloured = false;
        self
    }

    /// Creates a note that is centred above or below the mark.
    const fn centred(
        of: (&'static str, &'static str, usize),
        text: &'static str,
        off: f64,
    ) -> Self {
        Self::new(of, text, (1.0, off), Anchor::Middle)
    }
}

const LIMITS: &str = "limits, exact S";
const WITHOUT: &str = "limits without search";
const PER_MODE: &str = "limits per mode";
const AMPLITUDE: &str = "amplitude, exact";
const MONOHARMONIC: &str = "amplitude, monoharmonic";
const FUNDAMENTAL: &str = "fundamental";
const CONTACT: &str = "amplitude of the contact";
const STOPS: &str = "steady state with stops";
const OURS: &str = "emitted f64";
const HAND: &str = "C by hand";
const TEXTBOOK: &str = "eigenproblem at each r";
const STEPPER: &str = "C event stepper";

fn is_balance(by: &str) -> bool {
    by.starts_with("harmonic balance")
}

/// All panels of the picture. Two panels of a row have the same time axis.
pub const ALL: [Question; 6] = [
    Question {
        title: "**(a)** both limits, exact and from tables",
        height: 300.0,
        shows: |_, answer, _| answer == LIMITS,
        notes: &[
            Beside::centred((HAND, LIMITS, 1), "1", 8.0),
            Beside::centred((HAND, LIMITS, 2), "2", 8.0),
            Beside::centred((HAND, LIMITS, 5), "5", 8.0),
            Beside::centred((HAND, LIMITS, 10), "10", 8.0),
        ],
    },
    Question {
        title: "**(b)** both limits, approximate",
        height: 300.0,
        // With one mass the limit per mode is exact. This panel shows approximations only, so it leaves that limit
        // out.
        shows: |by, answer, masses| {
            answer == WITHOUT || (answer == PER_MODE && by == OURS && masses > 1)
        },
        notes: &[
            Beside::centred((OURS, WITHOUT, 5), "without search", 1.25).about_all(),
            Beside::new((OURS, PER_MODE, 5), "per mode", (1.0, 0.75), Anchor::Middle),
            Beside::centred((TEXTBOOK, WITHOUT, 1), "1", 0.8),
            Beside::centred((TEXTBOOK, WITHOUT, 10), "10", 0.8),
        ],
    },
    Question {
        title: "**(c)** amplitude of a mass, exact",
        height: 260.0,
        shows: |by, answer, _| answer == AMPLITUDE && by != STEPPER && !is_balance(by),
        notes: &[
            Beside::centred((HAND, AMPLITUDE, 1), "1", 8.0),
            Beside::centred((HAND, AMPLITUDE, 10), "10", 8.0),
        ],
    },
    Question {
        title: "**(d)** amplitude of a mass, approximate",
        height: 260.0,
        shows: |by, answer, _| {
            (answer == AMPLITUDE && is_balance(by))
                || ((answer == MONOHARMONIC || answer == FUNDAMENTAL) && by == OURS)
        },
        notes: &[
            Beside::new(
                (OURS, MONOHARMONIC, 5),
                "monoharmonic",
                (1.0, 1.22),
                Anchor::Middle,
            ),
            Beside::new(
                (OURS, FUNDAMENTAL, 2),
                "fundamental",
                (1.0, 0.8),
                Anchor::Middle,
            ),
            Beside::centred(("harmonic balance 1", AMPLITUDE, 5), "*n* = 1", 1.2),
            Beside::centred(("harmonic balance 3", AMPLITUDE, 1), "*n* = 3", 0.8),
            Beside::centred(("harmonic balance 9", AMPLITUDE, 10), "*n* = 9", 0.8),
            Beside::centred(("harmonic balance 25", AMPLITUDE, 10), "*n* = 25", 0.8),
        ],
    },
    Question {
        title: "**(e)** amplitude in the contact, no stops",
        height: 230.0,
        // The event stepper computes only the amplitude of the contact.
        shows: |by, answer, _| answer == CONTACT || (answer == AMPLITUDE && by == STEPPER),
        notes: &[
            Beside::centred((STEPPER, AMPLITUDE, 1), "1", 8.0),
            Beside::new((STEPPER, AMPLITUDE, 10), "10", (0.4, 1.0), Anchor::End),
        ],
    },
    Question {
        title: "**(f)** amplitude in the contact, with stops",
        height: 230.0,
        shows: |_, answer, _| answer == STOPS,
        notes: &[
            Beside::centred((STEPPER, STOPS, 1), "1", 8.0),
            Beside::new((STEPPER, STOPS, 5), "5", (0.4, 1.0), Anchor::End),
        ],
    },
];
