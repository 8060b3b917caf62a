//! Drawing tools of the chapters: systems from their descriptions, responses over frequency, motions over a cycle,
//! files of figures.

mod chains;
mod colours;
mod limit;
mod responses;
mod sheet;
mod simulated;
mod stuck;
mod systems;
mod tidy;
mod times;

pub use chains::{RATIO, Row, chain, drawn, map, over_r1, strokes};
pub use colours::{beta_colour, part_colour, variant_colour};
pub use limit::{at_limit, places};
pub use responses::{Responses, only_regimes};
pub use sheet::{csv, save};
pub use simulated::{CYCLES, Polar, from_rest, simulated};
pub use stuck::stuck;
pub use systems::{block, system};
pub use tidy::{one_turn, tidy, without_specks};
pub use times::{Times, cycle, keys};
