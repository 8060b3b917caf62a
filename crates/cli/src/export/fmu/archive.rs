//! Writes a zip archive without compression.

/// A file of a zip archive.
struct Entry {
    name: String,
    checksum: u32,
    size: u32,
    offset: u32,
}

/// A zip archive in memory, without compression.
#[derive(Default)]
pub struct Archive {
    bytes: Vec<u8>,
    entries: Vec<Entry>,
}

/// Signatures that begin the three kinds of headers in a zip archive: local, central and end.
const LOCAL: u32 = 0x0403_4b50;
const CENTRAL: u32 = 0x0201_4b50;
const END: u32 = 0x0605_4b50;
/// Version 1.0 of the zip format suffices to read the archive.
const VERSION: u16 = 10;
/// Flag of the zip format: the names of the files are in UTF-8.
const FLAGS: u16 = 1 << 11;
/// Time and date of all files in the archive: midnight on 1 January 1980, the first date of the zip format. The fixed
/// date gives the same bytes for the same scene.
const TIME: u16 = 0;
const DATE: u16 = (1 << 5) | 1;

impl Archive {
    /// Adds a file to the zip archive.
    pub fn add(&mut self, name: &str, contents: &[u8]) {
        let entry = Entry {
            name: name.to_owned(),
            checksum: checksum(contents),
            size: bounded(contents.len()),
            offset: bounded(self.bytes.len()),
        };
        self.double(LOCAL);
        self.common(&entry);
        self.bytes.extend(name.as_bytes());
        self.bytes.extend(contents);
        self.entries.push(entry);
    }

    /// Writes the end of the zip archive, and returns the bytes of the archive.
    pub fn finish(mut self) -> Vec<u8> {
        let start = self.bytes.len();
        let entries = std::mem::take(&mut self.entries);
        for entry in &entries {
            self.double(CENTRAL);
            self.word(VERSION);
            self.common(entry);
            // The archive has no comment, only the first volume, and no attributes, so the fields for these are 0.
            for _ in 0..3 {
                self.word(0);
            }
            self.double(0);
            self.double(entry.offset);
            self.bytes.extend(entry.name.as_bytes());
        }
        let size = self.bytes.len() - start;
        let count = u16::try_from(entries.len()).unwrap_or(u16::MAX);
        self.double(END);
        self.word(0);
        self.word(0);
        self.word(count);
        self.word(count);
        self.double(bounded(size));
        self.double(bounded(start));
        self.word(0);
        self.bytes
    }

    /// Writes the fields that the local header and the central header of a file have in common.
    fn common(&mut self, entry: &Entry) {
        // The third number is the compression method, 0 for no compression.
        for word in [VERSION, FLAGS, 0, TIME, DATE] {
            self.word(word);
        }
        for double in [entry.checksum, entry.size, entry.size] {
            self.double(double);
        }
        self.word(u16::try_from(entry.name.len()).unwrap_or(u16::MAX));
        self.word(0);
    }

    fn word(&mut self, word: u16) {
        self.bytes.extend(word.to_le_bytes());
    }

    fn double(&mut self, double: u32) {
        self.bytes.extend(double.to_le_bytes());
    }
}

/// Converts the size of a file to 32 bits. A binary has some megabytes, and the zip format permits four gigabytes.
fn bounded(size: usize) -> u32 {
    u32::try_from(size).unwrap_or(u32::MAX)
}

/// Returns the CRC-32 of some bytes, as the zip format defines it.
pub(super) fn checksum(bytes: &[u8]) -> u32 {
    let step = |sum: u32, _: u32| (sum >> 1) ^ (0xedb8_8320 & (sum & 1).wrapping_neg());
    let byte = |sum: u32, byte: &u8| (0..8).fold(sum ^ u32::from(*byte), step);
    !bytes.iter().fold(u32::MAX, byte)
}
