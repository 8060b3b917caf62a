//! A run-time system with tables of limits and motions. The macro emits the same tables for a description with the
//! field `accuracy`.

mod stuck;
mod system;

pub use stuck::CompiledStuck;
pub use system::{CompiledAt, CompiledContact, CompiledMotion, CompiledSystem};
