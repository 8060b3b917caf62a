//! `trade-picture DATA FOLDER` draws `trade.csv` of the folder DATA as `trade.svg`, and for telephones as
//! `trade-narrow.svg`.

use std::path::Path;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [data, folder] = arguments.as_slice() else {
        return Err("trade-picture DATA FOLDER".into());
    };
    let table = std::fs::read_to_string(Path::new(data).join("trade.csv"))?;
    trade_picture::write(&table, Path::new(folder))
}
