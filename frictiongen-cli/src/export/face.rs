//! The exported functions and structs. The header and the Rust file are written from this list, so they declare the
//! same functions.

/// Type of a number or a struct.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FieldType {
    /// The scene's scalar.
    Real,
    /// A signed number of 32 bits, for flags and enumerations.
    Int,
    /// An unsigned number of 32 bits.
    Count,
    /// An unsigned number of 64 bits.
    Long,
    /// A struct with this name.
    Record(&'static str),
    /// An array of bytes.
    Bytes(usize),
}

/// A field of a struct.
#[derive(Clone, Debug)]
pub struct StructField {
    /// Name in C and in Rust.
    pub name: String,
    /// Type.
    pub kind: FieldType,
    /// Meaning and unit, for a comment.
    pub about: String,
}

impl StructField {
    /// Returns a field.
    pub fn new(name: impl Into<String>, kind: FieldType, about: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            kind,
            about: about.into(),
        }
    }
}

/// A struct of numbers.
#[derive(Clone, Debug)]
pub struct ExportedStruct {
    /// Name in snake case, without the prefix.
    pub name: &'static str,
    /// Meaning, for a comment.
    pub about: String,
    /// The fields.
    pub fields: Vec<StructField>,
}

/// The way in which a parameter is passed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Passed {
    /// By value.
    Value(FieldType),
    /// By a pointer to a constant struct.
    Input(&'static str),
    /// By a pointer to memory for the result.
    Output(FieldType),
    /// By a pointer to memory for an opaque struct, which the function initialises.
    Fresh(&'static str),
    /// By a pointer to an opaque struct that the function changes.
    Changed(&'static str),
    /// By a pointer to an opaque struct that the function only reads.
    Read(&'static str),
}

/// A function.
#[derive(Clone, Debug)]
pub struct ExportedFunction {
    /// Name without the prefix.
    pub name: &'static str,
    /// Meaning, for a comment.
    pub about: String,
    /// Names and types of the parameters.
    pub parameters: Vec<(&'static str, Passed)>,
    /// Body in Rust: statements that return `Result<(), i32>` and write results last.
    pub body: String,
}

impl ExportedFunction {
    /// Returns a function.
    pub fn new(
        name: &'static str,
        about: impl Into<String>,
        parameters: Vec<(&'static str, Passed)>,
        body: impl Into<String>,
    ) -> Self {
        Self {
            name,
            about: about.into(),
            parameters,
            body: body.into(),
        }
    }
}

/// An opaque struct, which C allocates.
#[derive(Clone, Debug)]
pub struct Opaque {
    /// Name in snake case, without the prefix.
    pub name: &'static str,
    /// Meaning, for a comment.
    pub about: &'static str,
    /// Rust type of the contents.
    pub contents: String,
    /// Size in words of 64 bits, including the word for the mark of an initialised struct.
    pub words: usize,
}

/// All exported items of a scene.
#[derive(Clone, Debug, Default)]
pub struct ExportedItems {
    /// The structs, each before the structs that contain it.
    pub records: Vec<ExportedStruct>,
    /// The opaque structs.
    pub opaque: Vec<Opaque>,
    /// The functions.
    pub functions: Vec<ExportedFunction>,
}

/// Returns the name of a struct in Rust.
pub fn type_name(name: &str) -> String {
    let words = name.split('_');
    let words = words.map(|word| {
        let mut letters = word.chars();
        let first = letters.next().into_iter().flat_map(char::to_uppercase);
        first.chain(letters).collect::<String>()
    });
    words.collect()
}
