//! A run-time system with tables. They correspond to the tables that the macro emits for the field `accuracy` of a
//! description.

mod stuck;
mod system;

pub use stuck::CompiledStuck;
pub use system::{CompiledAt, CompiledContact, CompiledMotion, CompiledSystem};
