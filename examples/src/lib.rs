//! Shared code of the programs: figures with their data and captions (`draw`, `album`), the numbers that the thesis
//! prints compared with computed ones (`facts`), and synthetic recordings (`rig`).

pub mod album;
pub mod draw;
pub mod facts;
pub mod rig;
pub mod several;
pub mod two_stops;
