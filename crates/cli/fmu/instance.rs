//! An instance of the FMU: its variables and its state.  `steps` has its steps.

use crate::scene::{self, CONTACTS, INPUTS, Kind, MASSES, OUTPUTS, SETTABLE, STICTION, Stepper};

/// Status of FMI 3.0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    Ok = 0,
    /// The call changed nothing.
    Discard = 2,
    /// The importer broke a rule of the standard.  The call changed nothing.
    Error = 3,
}

/// A call that failed, with the message for the importer.
#[derive(Debug)]
pub struct Refusal {
    pub status: Status,
    pub text: String,
}

impl Refusal {
    pub fn error(text: String) -> Self {
        Self {
            status: Status::Error,
            text,
        }
    }

    pub fn null() -> Self {
        Self::error("a pointer is null".to_owned())
    }

    pub fn missing(function: &str) -> Self {
        Self::error(format!(
            "the FMU does not provide {function}, as modelDescription.xml says"
        ))
    }

    pub fn discard(text: String) -> Self {
        Self {
            status: Status::Discard,
            text,
        }
    }
}

/// An instance: its state, and where its messages go.
pub struct Instance {
    log: Box<dyn Fn(Status, &str)>,
    /// True if fmi3DoStep may return before the end of the communication step.
    early_return: bool,
    pub state: State,
}

impl Instance {
    pub fn new(log: impl Fn(Status, &str) + 'static, early_return: bool) -> Self {
        Self {
            log: Box::new(log),
            early_return,
            state: State::new(),
        }
    }

    /// Advances by whole steps.  Returns true if the FMU has returned before the end of the communication step.
    pub fn advance(&mut self, now: f64, length: f64) -> Result<bool, Refusal> {
        self.state.advance(now, length, self.early_return)
    }

    pub fn log(&self, refusal: &Refusal) {
        (self.log)(refusal.status, &refusal.text);
    }
}

/// Modes of the standard.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    Instantiated = 0,
    Initialization = 1,
    Step = 2,
    Terminated = 3,
}

/// Everything that changes during a simulation.
#[derive(Clone)]
pub struct State {
    pub phase: Phase,
    /// Times of start and stop, s.
    pub start: f64,
    pub stop: f64,
    /// Inputs, stictions, and initial displacements and velocities.
    pub values: [f64; SETTABLE],
    /// Inputs at the end of the last step.
    pub last: [f64; INPUTS],
    /// Events of the last call of fmi3DoStep.
    pub events: u64,
    /// Instant of the last event since the start, s.  Before the first event it is the start time.
    pub event_time: f64,
    /// The stepper, once the initialization has ended.
    pub stepper: Option<Stepper>,
}

/// First value references of outputs: reals, then a flag and a direction of each contact, two counts and an instant.
const FIRST_OUTPUT: usize = 1 + SETTABLE;
const STICKS: usize = FIRST_OUTPUT + OUTPUTS.len();
const DIRECTION: usize = STICKS + CONTACTS;
const EVENTS: usize = DIRECTION + CONTACTS;
const EXCEEDED: usize = EVENTS + 1;
const EVENT_TIME: usize = EVENTS + 2;

impl State {
    pub fn new() -> Self {
        Self {
            phase: Phase::Instantiated,
            start: 0.0,
            stop: f64::INFINITY,
            values: scene::VARIABLES.map(|variable| variable.start),
            last: [0.0; INPUTS],
            events: 0,
            event_time: 0.0,
            stepper: None,
        }
    }

    pub fn demand(&self, phase: Phase, call: &str) -> Result<(), Refusal> {
        if self.phase == phase {
            return Ok(());
        }
        Err(Refusal::error(format!(
            "{call} is not allowed in the mode {:?}; call it in the mode {phase:?}",
            self.phase
        )))
    }

    pub fn enter(&mut self, start: f64, stop: f64) -> Result<(), Refusal> {
        self.demand(Phase::Instantiated, "fmi3EnterInitializationMode")?;
        if !start.is_finite() || stop.is_nan() {
            return Err(Refusal::error(format!(
                "the start time is {start} s and the stop time {stop} s; give numbers"
            )));
        }
        (self.start, self.stop, self.phase) = (start, stop, Phase::Initialization);
        self.event_time = start;
        Ok(())
    }

    pub fn begin(&mut self) -> Result<(), Refusal> {
        self.demand(Phase::Initialization, "fmi3ExitInitializationMode")?;
        self.stepper = Some(self.started()?);
        self.last = self.inputs();
        self.phase = Phase::Step;
        Ok(())
    }

    pub fn terminate(&mut self) -> Result<(), Refusal> {
        self.demand(Phase::Step, "fmi3Terminate")?;
        self.phase = Phase::Terminated;
        Ok(())
    }

    pub fn inputs(&self) -> [f64; INPUTS] {
        std::array::from_fn(|index| self.values[index])
    }

    /// Returns a stepper at the start, with the present values of all variables.
    fn started(&self) -> Result<Stepper, Refusal> {
        let initial = &self.values[STICTION + CONTACTS..];
        let refused = |error| {
            Refusal::discard(format!(
                "{error}; the variables are {}",
                self.told(0..SETTABLE)
            ))
        };
        let mut stepper = scene::start(
            std::array::from_fn::<_, MASSES, _>(|mass| initial[2 * mass]),
            std::array::from_fn::<_, MASSES, _>(|mass| initial[2 * mass + 1]),
        )
        .map_err(refused)?;
        for contact in 0..CONTACTS {
            scene::set_stiction(&mut stepper, contact, self.values[STICTION + contact])
                .map_err(refused)?;
        }
        stepper
            .begin(scene::input(&self.inputs()))
            .map_err(refused)?;
        Ok(stepper)
    }

    /// Returns names and values of variables for a message.
    pub fn told(&self, range: std::ops::Range<usize>) -> String {
        let variables = scene::VARIABLES[range.clone()]
            .iter()
            .zip(&self.values[range]);
        let texts = variables
            .map(|(variable, value)| format!("{} = {value:?} {}", variable.name, variable.unit));
        texts
            .map(|text| text.trim_end().to_owned())
            .collect::<Vec<_>>()
            .join(", ")
    }

    /// Calls a function with the stepper.  Before the first step this is a stepper at the start.
    fn with<R>(&self, call: impl FnOnce(&Stepper) -> R) -> Result<R, Refusal> {
        match &self.stepper {
            Some(stepper) => Ok(call(stepper)),
            None => Ok(call(&self.started()?)),
        }
    }

    pub fn reals(&self, references: &[u32], values: &mut [f64]) -> Result<(), Refusal> {
        let numbers = self.with(scene::outputs)?;
        read(references, values, |reference| match reference {
            0 => Some(self.time()),
            EVENT_TIME => Some(self.event_time),
            _ if reference < FIRST_OUTPUT => self.values.get(reference - 1).copied(),
            _ => numbers.get(reference - FIRST_OUTPUT).copied(),
        })
    }

    pub fn flags(&self, references: &[u32], values: &mut [bool]) -> Result<(), Refusal> {
        let directions = self.with(scene::directions)?;
        read(references, values, |reference| {
            let direction = directions.get(reference.wrapping_sub(STICKS));
            direction.map(|direction| *direction == 0)
        })
    }

    pub fn directions(&self, references: &[u32], values: &mut [i32]) -> Result<(), Refusal> {
        let directions = self.with(scene::directions)?;
        read(references, values, |reference| {
            directions.get(reference.wrapping_sub(DIRECTION)).copied()
        })
    }

    pub fn counts(&self, references: &[u32], values: &mut [u64]) -> Result<(), Refusal> {
        let exceeded = self.with(|stepper| stepper.exceeded())?;
        read(references, values, |reference| match reference {
            EVENTS => Some(self.events),
            EXCEEDED => Some(exceeded),
            _ => None,
        })
    }

    /// Serves a type without variables.
    pub fn none<T: Copy>(&self, references: &[u32], values: &mut [T]) -> Result<(), Refusal> {
        read(references, values, |_| None)
    }

    /// Sets variables, or none of them after a refusal.
    pub fn set_reals(&mut self, references: &[u32], values: &[f64]) -> Result<(), Refusal> {
        same_length(references, values)?;
        let mut next = self.values;
        for (reference, value) in references.iter().zip(values) {
            let index = (*reference as usize).wrapping_sub(1);
            let (Some(variable), Some(place)) = (scene::VARIABLES.get(index), next.get_mut(index))
            else {
                return Err(Refusal::error(format!(
                    "the variable with the value reference {reference} cannot be set"
                )));
            };
            let allowed = match self.phase {
                Phase::Instantiated | Phase::Initialization => true,
                Phase::Step => variable.kind != Kind::Initial,
                Phase::Terminated => false,
            };
            if !allowed {
                return Err(Refusal::error(format!(
                    "{} cannot be set in the mode {:?}",
                    variable.name, self.phase
                )));
            }
            let finite = value.is_finite() && scene::real(*value).is_finite();
            if !(finite && variable.least <= *value) {
                let least = if variable.least.is_finite() {
                    format!(" of at least {}", variable.least)
                } else {
                    String::new()
                };
                return Err(Refusal::discard(format!(
                    "{} is {value:?}; give a finite number{least}",
                    variable.name
                )));
            }
            *place = *value;
        }
        let changed = |place: &usize| next[*place] != self.values[*place];
        let changed: Vec<usize> = (STICTION..STICTION + CONTACTS).filter(changed).collect();
        if let Some(stepper) = self.stepper.as_mut() {
            for place in changed {
                let stiction = next[place];
                let refused = |error| {
                    Refusal::discard(format!(
                        "{error}; {} is {stiction:?}",
                        scene::VARIABLES[place].name
                    ))
                };
                scene::set_stiction(stepper, place - STICTION, stiction).map_err(refused)?;
            }
        }
        self.values = next;
        Ok(())
    }

    /// Serves a type without variables that can be set.
    pub fn refuse_to_set<T>(&mut self, references: &[u32], values: &[T]) -> Result<(), Refusal> {
        same_length(references, values)?;
        match references.first() {
            None => Ok(()),
            Some(reference) => Err(Refusal::error(format!(
                "the variable with the value reference {reference} cannot be set"
            ))),
        }
    }
}

fn same_length<T>(references: &[u32], values: &[T]) -> Result<(), Refusal> {
    if references.len() == values.len() {
        return Ok(());
    }
    Err(Refusal::error(format!(
        "the call has {} value references, but {} values; every variable is one number",
        references.len(),
        values.len()
    )))
}

/// Reads variables, or none of them after a refusal.
fn read<T: Copy>(
    references: &[u32],
    values: &mut [T],
    of: impl Fn(usize) -> Option<T>,
) -> Result<(), Refusal> {
    same_length(references, values)?;
    let unknown = |reference: &u32| {
        Refusal::error(format!(
            "the value reference {reference} is not that of a variable of this type"
        ))
    };
    let found = references
        .iter()
        .map(|reference| of(*reference as usize).ok_or_else(|| unknown(reference)));
    let found = found.collect::<Result<Vec<T>, Refusal>>()?;
    values.copy_from_slice(&found);
    Ok(())
}
