//! `trade-picture DATA FOLDER` draws `trade.csv` of the folder DATA as `trade.svg`, and for telephones as
//! `trade-narrow.svg`, and `elastic.csv` as `elastic-trade.svg`. A table that is not in DATA is left out.

use std::path::Path;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [data, folder] = arguments.as_slice() else {
        return Err("trade-picture DATA FOLDER".into());
    };
    let (data, folder) = (Path::new(data), Path::new(folder));
    if let Ok(table) = std::fs::read_to_string(data.join("trade.csv")) {
        trade_picture::write(&table, folder)?;
    }
    if let Ok(table) = std::fs::read_to_string(data.join("elastic.csv")) {
        trade_picture::elastic::write(&table, folder)?;
    }
    Ok(())
}
