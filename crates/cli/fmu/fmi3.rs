//! The C functions of FMI 3.0.  `instance` has what they do.
//!
//! All `unsafe` code of the crate is in this file: the standard passes arrays and states as pointers.  An instance is a
//! reference that may be null.

use crate::instance::{Instance, Refusal, State, Status};
use crate::scene;
use std::ffi::{CStr, CString, c_char, c_void};
use std::slice;

type LogMessage = Option<extern "C" fn(*mut c_void, i32, *const c_char, *const c_char)>;

/// Returns the function that passes messages to the importer.
fn logger(environment: *mut c_void, callback: LogMessage) -> impl Fn(Status, &str) {
    move |status, text| {
        if let Some(callback) = callback {
            let text = CString::new(text).unwrap_or_default();
            let category = if status == Status::Discard {
                c"logStatusDiscard"
            } else {
                c"logStatusError"
            };
            callback(environment, status as i32, category.as_ptr(), text.as_ptr());
        }
    }
}

/// Calls a function of an instance.  A refusal becomes a message and a status.
pub(crate) fn answer(
    instance: Option<&mut Instance>,
    call: impl FnOnce(&mut Instance) -> Result<(), Refusal>,
) -> i32 {
    let Some(instance) = instance else {
        return Status::Error as i32;
    };
    match call(instance) {
        Ok(()) => Status::Ok as i32,
        Err(refusal) => {
            instance.log(&refusal);
            refusal.status as i32
        }
    }
}

/// Returns an array of the importer.
///
/// # Safety
/// The standard demands that `start` points to `count` values, or that `count` is 0.
unsafe fn array<'a, T>(start: *const T, count: usize) -> Result<&'a [T], Refusal> {
    match (start.is_null(), count) {
        (_, 0) => Ok(&[]),
        (true, _) => Err(Refusal::null()),
        // SAFETY: the caller passes an array of the importer.
        (false, _) => Ok(unsafe { slice::from_raw_parts(start, count) }),
    }
}

/// Returns an array of the importer for results.
///
/// # Safety
/// The standard demands that `start` points to `count` values, or that `count` is 0.
unsafe fn results<'a, T>(start: *mut T, count: usize) -> Result<&'a mut [T], Refusal> {
    match (start.is_null(), count) {
        (_, 0) => Ok(&mut []),
        (true, _) => Err(Refusal::null()),
        // SAFETY: the caller passes an array of the importer.
        (false, _) => Ok(unsafe { slice::from_raw_parts_mut(start, count) }),
    }
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetVersion() -> *const c_char {
    c"3.0".as_ptr()
}

/// # Safety
/// The pointers are those that the standard demands.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateCoSimulation(
    _name: *const c_char,
    token: *const c_char,
    _resources: *const c_char,
    _visible: bool,
    _logging: bool,
    event_mode: bool,
    early_return: bool,
    _intermediate: *const u32,
    intermediate_count: usize,
    environment: *mut c_void,
    log_message: LogMessage,
    _intermediate_update: *const c_void,
) -> *mut Instance {
    let log = logger(environment, log_message);
    let token = if token.is_null() {
        c""
    } else {
        // SAFETY: the standard demands a text that ends with zero.
        unsafe { CStr::from_ptr(token) }
    };
    let refused = if token.to_bytes() != scene::TOKEN.as_bytes() {
        format!(
            "the instantiation token is {}, but this binary has {}: modelDescription.xml belongs to another FMU",
            token.to_string_lossy(),
            scene::TOKEN
        )
    } else if event_mode {
        "the FMU has no event mode; instantiate it without eventModeUsed".to_owned()
    } else if intermediate_count > 0 {
        "the FMU has no intermediate update; instantiate it without intermediate variables"
            .to_owned()
    } else {
        return Box::into_raw(Box::new(Instance::new(log, early_return)));
    };
    log(Status::Error, &refused);
    std::ptr::null_mut()
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi3InstantiateModelExchange(
    _name: *const c_char,
    _token: *const c_char,
    _resources: *const c_char,
    _visible: bool,
    _logging: bool,
    environment: *mut c_void,
    log_message: LogMessage,
) -> *mut Instance {
    logger(environment, log_message)(Status::Error, ONLY_CO_SIMULATION);
    std::ptr::null_mut()
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi3InstantiateScheduledExecution(
    _name: *const c_char,
    _token: *const c_char,
    _resources: *const c_char,
    _visible: bool,
    _logging: bool,
    environment: *mut c_void,
    log_message: LogMessage,
    _clock_update: *const c_void,
    _lock: *const c_void,
    _unlock: *const c_void,
) -> *mut Instance {
    logger(environment, log_message)(Status::Error, ONLY_CO_SIMULATION);
    std::ptr::null_mut()
}

const ONLY_CO_SIMULATION: &str = "the FMU is for co-simulation only";

/// # Safety
/// The instance is null, or one that was instantiated and is not free yet.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3FreeInstance(instance: *mut Instance) {
    if !instance.is_null() {
        // SAFETY: `fmi3InstantiateCoSimulation` made this box.
        drop(unsafe { Box::from_raw(instance) });
    }
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi3SetDebugLogging(
    instance: Option<&mut Instance>,
    _on: bool,
    _count: usize,
    _categories: *const *const c_char,
) -> i32 {
    // The FMU has messages of errors only, which it always sends.
    answer(instance, |_| Ok(()))
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi3EnterInitializationMode(
    instance: Option<&mut Instance>,
    _tolerance_defined: bool,
    _tolerance: f64,
    start: f64,
    stop_defined: bool,
    stop: f64,
) -> i32 {
    let stop = if stop_defined { stop } else { f64::INFINITY };
    answer(instance, |instance| instance.state.enter(start, stop))
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi3ExitInitializationMode(instance: Option<&mut Instance>) -> i32 {
    answer(instance, |instance| instance.state.begin())
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi3Terminate(instance: Option<&mut Instance>) -> i32 {
    answer(instance, |instance| instance.state.terminate())
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi3Reset(instance: Option<&mut Instance>) -> i32 {
    answer(instance, |instance| {
        instance.state = State::new();
        Ok(())
    })
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi3DoStep(
    instance: Option<&mut Instance>,
    now: f64,
    length: f64,
    _no_set_state_before: bool,
    event: Option<&mut bool>,
    terminate: Option<&mut bool>,
    mut early_return: Option<&mut bool>,
    last: Option<&mut f64>,
) -> i32 {
    let flags = [event, terminate, early_return.as_deref_mut()];
    for flag in flags.into_iter().flatten() {
        *flag = false;
    }
    answer(instance, |instance| {
        let stepped = instance.advance(now, length);
        if let Some(last) = last {
            *last = instance.state.time();
        }
        let is_early = stepped?;
        if let Some(flag) = early_return {
            *flag = is_early;
        }
        Ok(())
    })
}

/// Defines the functions that return and set the variables of a type.
macro_rules! variables {
    ($($get:ident, $set:ident: $kind:ty, $read:ident, $write:ident;)*) => {$(
        /// # Safety
        /// The arrays are those that the standard demands.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $get(
            instance: Option<&mut Instance>,
            references: *const u32,
            count: usize,
            values: *mut $kind,
            value_count: usize,
        ) -> i32 {
            answer(instance, |instance| {
                // SAFETY: the importer passes arrays of these lengths.
                let (references, values) = unsafe { (array(references, count)?, results(values, value_count)?) };
                instance.state.$read(references, values)
            })
        }

        /// # Safety
        /// The arrays are those that the standard demands.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $set(
            instance: Option<&mut Instance>,
            references: *const u32,
            count: usize,
            values: *const $kind,
            value_count: usize,
        ) -> i32 {
            answer(instance, |instance| {
                // SAFETY: the importer passes arrays of these lengths.
                let (references, values) = unsafe { (array(references, count)?, array(values, value_count)?) };
                instance.state.$write(references, values)
            })
        }
    )*};
}

variables! {
    fmi3GetFloat64, fmi3SetFloat64: f64, reals, set_reals;
    fmi3GetBoolean, fmi3SetBoolean: bool, flags, refuse_to_set;
    fmi3GetInt32, fmi3SetInt32: i32, directions, refuse_to_set;
    fmi3GetUInt64, fmi3SetUInt64: u64, counts, refuse_to_set;
    fmi3GetFloat32, fmi3SetFloat32: f32, none, refuse_to_set;
    fmi3GetInt8, fmi3SetInt8: i8, none, refuse_to_set;
    fmi3GetUInt8, fmi3SetUInt8: u8, none, refuse_to_set;
    fmi3GetInt16, fmi3SetInt16: i16, none, refuse_to_set;
    fmi3GetUInt16, fmi3SetUInt16: u16, none, refuse_to_set;
    fmi3GetUInt32, fmi3SetUInt32: u32, none, refuse_to_set;
    fmi3GetInt64, fmi3SetInt64: i64, none, refuse_to_set;
    fmi3GetString, fmi3SetString: *const c_char, none, refuse_to_set;
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetFMUState(
    instance: Option<&mut Instance>,
    state: Option<&mut *mut State>,
) -> i32 {
    answer(instance, |instance| keep(state, instance.state.clone()))
}

/// Stores a state at the pointer of the importer.
fn keep(place: Option<&mut *mut State>, state: State) -> Result<(), Refusal> {
    let place = place.ok_or_else(Refusal::null)?;
    if place.is_null() {
        *place = Box::into_raw(Box::new(state));
    } else {
        // SAFETY: a state that is not null was made by this function.
        unsafe { **place = state };
    }
    Ok(())
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi3SetFMUState(instance: Option<&mut Instance>, state: Option<&State>) -> i32 {
    answer(instance, |instance| {
        instance.state = state.ok_or_else(Refusal::null)?.clone();
        Ok(())
    })
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi3FreeFMUState(
    instance: Option<&mut Instance>,
    state: Option<&mut *mut State>,
) -> i32 {
    answer(instance, |_| {
        if let Some(place) = state.filter(|place| !place.is_null()) {
            // SAFETY: `keep` made this box.
            drop(unsafe { Box::from_raw(*place) });
            *place = std::ptr::null_mut();
        }
        Ok(())
    })
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi3SerializedFMUStateSize(
    instance: Option<&mut Instance>,
    state: Option<&State>,
    size: Option<&mut usize>,
) -> i32 {
    answer(instance, |_| {
        *size.ok_or_else(Refusal::null)? = state.ok_or_else(Refusal::null)?.bytes().len();
        Ok(())
    })
}

/// # Safety
/// The array has `size` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SerializeFMUState(
    instance: Option<&mut Instance>,
    state: Option<&State>,
    bytes: *mut u8,
    size: usize,
) -> i32 {
    answer(instance, |_| {
        let found = state.ok_or_else(Refusal::null)?.bytes();
        // SAFETY: the importer passes an array of this length.
        let place = unsafe { results(bytes, size)? };
        let place = place.get_mut(..found.len()).ok_or_else(|| {
            Refusal::error(format!(
                "the state has {} bytes, but the array has {size}",
                found.len()
            ))
        })?;
        place.copy_from_slice(&found);
        Ok(())
    })
}

/// # Safety
/// The array has `size` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3DeserializeFMUState(
    instance: Option<&mut Instance>,
    bytes: *const u8,
    size: usize,
    state: Option<&mut *mut State>,
) -> i32 {
    answer(instance, |_| {
        // SAFETY: the importer passes an array of this length.
        let found = State::of(unsafe { array(bytes, size)? })?;
        keep(state, found)
    })
}
