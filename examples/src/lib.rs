//! What the programs share: figures with their data and captions (`draw`, `gallery`), and the numbers that the thesis
//! prints beside what they come out as (`facts`), recordings (`rig`).

pub mod album;
pub mod draw;
pub mod facts;
pub mod gallery;
pub mod rig;
pub mod two_stops;
