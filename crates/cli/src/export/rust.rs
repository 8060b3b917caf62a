//! Writes the Rust file of an exported crate.

use super::face::{
    ExportedFunction, ExportedItems, ExportedStruct, FieldType, Opaque, Passed, type_name,
};
use super::status;

/// Returns the text of `src/lib.rs` of an exported crate. `name` is the scene's type in Rust, and `prefix` begins the
/// names in C. `is_joined` is true for a scene with several contacts or dashpots.
pub fn library(
    face: &ExportedItems,
    head: &str,
    (prefix, name, scalar): (&str, &str, &str),
    is_joined: bool,
) -> String {
    let records: String = face
        .records
        .iter()
        .map(|record| self::record(record, scalar))
        .collect();
    let opaque: String = face.opaque.iter().map(opaque).collect();
    let functions = face.functions.iter();
    let functions: String = functions.map(|of| function(of, prefix, scalar)).collect();
    format!(
        "{head}//\n\
         // The only `unsafe` is in `change` and `read` below, and in the attribute that gives a function its C name.  Pointers\n\
         // are references that may be null: the header says what a caller must pass.\n\
         #![no_std]\n#![allow(missing_docs, dead_code, unused_imports, unused_macros, clippy::all)]\n\n\
         frictiongen::friction_system!(\"{prefix}.friction\");\n\n\
         /// A panic cannot be reached: the emitted code and the library have none.  If one were, the program would end.\n\
         #[panic_handler]\nfn panic(_: &core::panic::PanicInfo<'_>) -> ! {{\n    \
         unsafe extern \"C\" {{\n        safe fn abort() -> !;\n    }}\n    abort()\n}}\n\n\
         mod exported {{\n    use super::{name} as Scene;\n    use core::ffi::{{CStr, c_char}};\n    use core::mem::MaybeUninit;\n    \
         use frictiongen::{{Complex as Number, NoOrbit, NotContinuous, OutOfDomain, Regime}};\n\n\
         {statuses}\n{helpers}\n{records}{opaque}{functions}}}\n",
        statuses = status::conversions(),
        helpers = helpers(face, (prefix, scalar), is_joined),
    )
}

/// Returns the Rust functions that several exported functions call.
fn helpers(face: &ExportedItems, (prefix, scalar): (&str, &str), is_joined: bool) -> String {
    let has = |name: &str| face.records.iter().any(|record| record.name == name);
    let mut text = format!(
        "    fn status(answer: impl FnOnce() -> Result<(), i32>) -> i32 {{\n        \
         match answer() {{\n            Ok(()) => 0,\n            Err(status) => status,\n        }}\n    }}\n\n    \
         #[unsafe(no_mangle)]\n    pub extern \"C\" fn {prefix}_status_text(status: i32) -> *const c_char {{\n        \
         text(status).as_ptr()\n    }}\n\n"
    );
    if has("complex") {
        text.push_str(&format!(
            "    fn complex(number: Number<{scalar}>) -> Complex {{\n        Complex {{ re: number.re, im: number.im }}\n    }}\n\n"
        ));
    }
    if has("segment") || has("stepped") {
        text.push_str(
            "    fn sliding(contact: frictiongen::answer::Contact) -> i32 {\n        use frictiongen::answer::Contact;\n        \
             match contact {\n            Contact::Stuck => 0,\n            Contact::Forward => 1,\n            \
             Contact::Backward => -1,\n        }\n    }\n\n",
        );
    }
    if has("mass_now") {
        let of_mass = if is_joined {
            "joints::MassState"
        } else {
            "stepper::MassNow"
        };
        text.push_str(&format!(
            "    fn mass_now(mass: &frictiongen::kernel::{of_mass}<{scalar}>) -> MassNow {{\n        \
             MassNow {{ displacement: mass.displacement(), velocity: mass.velocity() }}\n    }}\n\n"
        ));
    }
    text
}

fn kind(kind: &FieldType, scalar: &str) -> String {
    match kind {
        FieldType::Real => scalar.to_owned(),
        FieldType::Int => "i32".to_owned(),
        FieldType::Count => "u32".to_owned(),
        FieldType::Long => "u64".to_owned(),
        FieldType::Record(name) => type_name(name),
        FieldType::Bytes(length) => format!("[u8; {length}]"),
    }
}

fn record(record: &ExportedStruct, scalar: &str) -> String {
    let fields = record.fields.iter();
    let fields = fields.map(|field| {
        format!(
            "        pub {}: {},\n",
            field.name,
            kind(&field.kind, scalar)
        )
    });
    format!(
        "    #[repr(C)]\n    pub struct {} {{\n{}    }}\n\n",
        type_name(record.name),
        fields.collect::<String>()
    )
}

fn opaque(of: &Opaque) -> String {
    let name = type_name(of.name);
    let Opaque {
        contents, words, ..
    } = of;
    format!(
        "    /// Memory of the C struct.  `MARK` in front tells that it is initialised.\n    #[repr(C)]\n    \
         pub struct {name}Memory {{\n        mark: u64,\n        contents: MaybeUninit<{contents}>,\n    }}\n\n    \
         const _: () = assert!(\n        size_of::<{name}Memory>() <= 8 * {words} && align_of::<{name}Memory>() <= align_of::<u64>(),\n        \
         \"the struct of the header is too small\"\n    );\n\n    \
         impl {name}Memory {{\n        const MARK: u64 = Scene::SCENE_HASH ^ {words};\n\n        \
         fn new(contents: {contents}) -> Self {{\n            \
         Self {{ mark: Self::MARK, contents: MaybeUninit::new(contents) }}\n        }}\n\n        \
         fn read(&self) -> Result<&{contents}, i32> {{\n            \
         if self.mark != Self::MARK {{\n                return Err(NOT_STARTED);\n            }}\n            \
         // SAFETY: only `new` writes MARK, and it writes the contents with it.  C copies both or neither.\n            \
         Ok(unsafe {{ self.contents.assume_init_ref() }})\n        }}\n\n        \
         fn change(&mut self) -> Result<&mut {contents}, i32> {{\n            \
         if self.mark != Self::MARK {{\n                return Err(NOT_STARTED);\n            }}\n            \
         // SAFETY: as in `read`.\n            \
         Ok(unsafe {{ self.contents.assume_init_mut() }})\n        }}\n    }}\n\n"
    )
}

fn function(of: &ExportedFunction, prefix: &str, scalar: &str) -> String {
    let parameters = of.parameters.iter().map(|(name, passed)| {
        let written = match passed {
            Passed::Value(of) => kind(of, scalar),
            Passed::Input(of) => format!("Option<&{}>", type_name(of)),
            Passed::Output(of) => format!("Option<&mut MaybeUninit<{}>>", kind(of, scalar)),
            Passed::Fresh(of) => format!("Option<&mut MaybeUninit<{}Memory>>", type_name(of)),
            Passed::Changed(of) => format!("Option<&mut {}Memory>", type_name(of)),
            Passed::Read(of) => format!("Option<&{}Memory>", type_name(of)),
        };
        format!("{name}: {written}")
    });
    let parameters: Vec<String> = parameters.collect();
    let pointers = of
        .parameters
        .iter()
        .filter(|(_, passed)| !matches!(passed, Passed::Value(_)));
    let pointers: Vec<&str> = pointers.map(|(name, _)| *name).collect();
    let checks = if pointers.is_empty() {
        String::new()
    } else {
        let some: Vec<String> = pointers
            .iter()
            .map(|name| format!("Some({name})"))
            .collect();
        let (some, all) = (some.join(", "), pointers.join(", "));
        format!(
            "        let ({some},) = ({all},) else {{\n            return NULL_POINTER;\n        }};\n"
        )
    };
    let body: String = of
        .body
        .lines()
        .map(|line| format!("            {line}\n"))
        .collect();
    format!(
        "    #[unsafe(no_mangle)]\n    pub extern \"C\" fn {prefix}_{}({}) -> i32 {{\n{checks}        status(|| {{\n{body}        }})\n    }}\n\n",
        of.name,
        parameters.join(", ")
    )
}
