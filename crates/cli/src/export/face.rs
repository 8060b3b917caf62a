//! The functions and structs that an exported crate offers to C. The command writes the header and the Rust file from
//! this list. The header and the Rust file therefore declare the same functions.

/// Type of a field or a parameter in the C interface.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FieldType {
    /// A number in the scene's number type.
    Real,
    /// A signed number of 32 bits, for flags and enumerations.
    Int,
    /// An unsigned number of 32 bits, for counts.
    Count,
    /// An unsigned number of 64 bits.
    Long,
    /// A struct with this name.
    Record(&'static str),
    /// An array of bytes.
    Bytes(usize),
}

/// A field of a struct in the C interface.
#[derive(Clone, Debug)]
pub struct StructField {
    /// Name of the field in C and in Rust.
    pub name: String,
    /// Type of the field in the C interface.
    pub kind: FieldType,
    /// Meaning and unit of the field, for a comment in the header.
    pub about: String,
}

impl StructField {
    /// Creates a field from its name, its type, and a text with its meaning and unit.
    pub fn new(name: impl Into<String>, kind: FieldType, about: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            kind,
            about: about.into(),
        }
    }
}

/// A struct of numbers in the C interface.
#[derive(Clone, Debug)]
pub struct ExportedStruct {
    /// Name of the struct in snake case, without the prefix of the export.
    pub name: &'static str,
    /// Meaning of the struct, for a comment in the header.
    pub about: String,
    /// Fields of the exported struct, in their order.
    pub fields: Vec<StructField>,
}

/// The way in which C passes a parameter to an exported function: by value or by pointer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Passed {
    /// The function takes the parameter by value.
    Value(FieldType),
    /// The function takes a pointer to a constant struct.
    Input(&'static str),
    /// The function takes a pointer to memory for its result.
    Output(FieldType),
    /// The function takes a pointer to memory for an opaque struct, and initialises this struct.
    Fresh(&'static str),
    /// The function takes a pointer to an opaque struct, and changes the struct.
    Changed(&'static str),
    /// The function takes a pointer to an opaque struct, and only reads the struct.
    Read(&'static str),
}

/// A function of the C interface.
#[derive(Clone, Debug)]
pub struct ExportedFunction {
    /// Name of the function, without the prefix of the export.
    pub name: &'static str,
    /// Meaning of the function, for a comment in the header.
    pub about: String,
    /// Names and types of the function's parameters.
    pub parameters: Vec<(&'static str, Passed)>,
    /// Body of the function in Rust. Its statements return `Result<(), i32>`, and write the results last.
    pub body: String,
}

impl ExportedFunction {
    /// Creates a function of the C interface.
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

/// An opaque struct of the C interface. The C program allocates its memory, and does not know its fields.
#[derive(Clone, Debug)]
pub struct Opaque {
    /// Name of the struct in snake case, without the prefix of the export.
    pub name: &'static str,
    /// Meaning of the struct, for a comment in the header.
    pub about: &'static str,
    /// Rust type of the struct's contents.
    pub contents: String,
    /// Size of the struct in words of 64 bits. It includes the word that marks an initialised struct.
    pub words: usize,
}

/// All structs and functions that an exported crate offers to C.
#[derive(Clone, Debug, Default)]
pub struct ExportedItems {
    /// The structs of numbers. A struct that is a field of another struct comes before the other struct.
    pub records: Vec<ExportedStruct>,
    /// Opaque structs of the C interface.
    pub opaque: Vec<Opaque>,
    /// Functions of the C interface.
    pub functions: Vec<ExportedFunction>,
}

/// Returns the Rust name of a struct, in camel case, from its name in snake case.
pub fn type_name(name: &str) -> String {
    let words = name.split('_');
    let words = words.map(|word| {
        let mut letters = word.chars();
        let first = letters.next().into_iter().flat_map(char::to_uppercase);
        first.chain(letters).collect::<String>()
    });
    words.collect()
}
