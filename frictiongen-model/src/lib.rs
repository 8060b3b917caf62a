//! Scenes of mass-spring chains with one Coulomb contact: their description, their validation, and
//! their modal analysis in double-double.

pub mod interval;
pub mod jacobi;
pub mod modal;
pub mod reduced;
mod roots;
pub mod scene;
pub mod sensitivity;
mod special;
pub mod stepping;
pub mod table;
pub mod transient;
pub mod validate;
