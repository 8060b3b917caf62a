//! `trade-picture FOLDER` draws `trade.csv` of the folder as `trade.svg`, and for telephones as `trade-narrow.svg`.

use std::path::Path;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let [folder] = &std::env::args().skip(1).collect::<Vec<_>>()[..] else {
        return Err("trade-picture FOLDER".into());
    };
    let folder = Path::new(folder);
    let table = std::fs::read_to_string(folder.join("trade.csv"))?;
    trade_picture::write(&table, folder)?;
    Ok(())
}
