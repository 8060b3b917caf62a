//! `trade-picture FOLDER` draws `trade.csv` of the folder as `trade.svg`, and for telephones as `trade-narrow.svg`.
//! `trade-picture --elastic FOLDER` draws `elastic-trade.csv` as `elastic-trade.svg`.

use std::path::Path;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match arguments.as_slice() {
        ["--elastic", folder] => {
            let folder = Path::new(folder);
            let table = std::fs::read_to_string(folder.join("elastic-trade.csv"))?;
            trade_picture::elastic::write(&table, folder)
        }
        [folder] => {
            let folder = Path::new(folder);
            let table = std::fs::read_to_string(folder.join("trade.csv"))?;
            trade_picture::write(&table, folder)
        }
        _ => Err("trade-picture [--elastic] FOLDER".into()),
    }
}
