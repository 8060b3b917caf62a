//! Scenes with several contacts: coupled clutches, a frame with a damper in each storey, a robot joint, and a bolted
//! joint as an Iwan element.

pub mod clutches;
pub mod frame;
pub mod iwan;
pub mod record;
pub mod robot;
