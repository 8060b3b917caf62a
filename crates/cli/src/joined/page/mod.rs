//! `frictiongen report` for a scene with several contacts: one HTML page that needs no network and has no script.

mod contents;
mod figures;
mod html;

pub use html::write;
