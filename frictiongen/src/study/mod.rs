//! Design studies at run time.

mod system;

pub use system::{
    MAX_MASSES, StudyError, System, SystemAt, SystemMotion, SystemSteady, SystemStuck, UnknownMass,
};
