//! Collects the numbers in the formulas of a file. Each number gets a name. The file defines all numbers in one place.

use super::{Language, NumberFormat};

/// Form of a constant: a single number, or a structure with named numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ConstantForm {
    /// A single number.
    Number,
    /// A zero on the imaginary axis, as a factor of a product.
    Zero,
    /// A pair of zeros off the imaginary axis, as a factor of a product.
    Pair,
    /// A pair of complex roots, as a factor of a complex product.
    RootPair,
}

impl ConstantForm {
    /// Returns the names of the numbers that a constant of this form contains.
    pub fn fields(self) -> &'static [&'static str] {
        match self {
            Self::Number => &[],
            Self::Zero => &["at", "rest"],
            Self::Pair => &["at", "rest", "off", "least"],
            Self::RootPair => &["at", "rest", "off", "rate"],
        }
    }

    /// Returns the name of the type in C or in Rust.
    fn type_name(self, language: Language) -> &'static str {
        match (self, language) {
            (Self::Number, _) => "",
            (Self::Zero, Language::C) => "zero",
            (Self::Pair, Language::C) => "pair",
            (Self::RootPair, Language::C) => "root_pair",
            (Self::Zero, Language::Rust) => "Zero",
            (Self::Pair, Language::Rust) => "Pair",
            (Self::RootPair, Language::Rust) => "RootPair",
        }
    }

    /// Returns an explanation of the numbers, for a comment in the file.
    pub fn about(self) -> &'static str {
        match self {
            Self::Number => "",
            Self::Zero => "Factor `(r - y)(r + y)` of the zeros or poles r = +-y",
            Self::Pair => {
                "Factor `((r - y)(r + y) + x^2)^2 + 4 x^2 y^2` of four zeros or poles s = +-x +- iy, at s = ir"
            }
            Self::RootPair => {
                "Complex factor `(s - x)^2 + y^2` of two zeros or poles s = x +- iy, at s = ir"
            }
        }
    }

    /// Returns the meaning of a field, for a comment in the file.
    fn field_about(field: &str) -> &'static str {
        match field {
            "at" => "y, rounded",
            "rest" => "rounding error of `at`: keeps the digits of r - y near r = y",
            "off" => "x^2",
            "least" => "4 x^2 y^2",
            "rate" => "-2x",
            _ => "",
        }
    }
}

/// A constant of a file: its name, its form and its numbers.
pub(super) struct NamedConstant {
    name: String,
    form: ConstantForm,
    values: Vec<f64>,
    about: String,
}

/// The constants of a file, in the order of their use.
pub(super) struct FileConstants {
    pub numbers: NumberFormat,
    list: Vec<NamedConstant>,
}

impl FileConstants {
    pub fn new(numbers: NumberFormat) -> Self {
        Self {
            numbers,
            list: Vec::new(),
        }
    }

    /// Adds a constant, and returns the expression that names it.
    pub fn add(
        &mut self,
        name: impl Into<String>,
        form: ConstantForm,
        values: &[f64],
        about: impl Into<String>,
    ) -> String {
        let name = name.into();
        let shown = match self.numbers.language {
            Language::C => name.clone(),
            Language::Rust => format!("numbers::{name}"),
        };
        self.list.push(NamedConstant {
            name,
            form,
            values: values.to_vec(),
            about: about.into(),
        });
        shown
    }

    /// Returns true if the file has a constant of this form.
    pub fn uses(&self, form: ConstantForm) -> bool {
        self.list.iter().any(|constant| constant.form == form)
    }

    /// Returns all numbers of the constants, in the order of the constants.
    pub fn values(&self) -> impl Iterator<Item = f64> {
        self.list
            .iter()
            .flat_map(|constant| constant.values.iter().copied())
    }

    /// Returns an expression for each number, in the order of [`values`](Self::values), as one text with several lines.
    pub fn expressions(&self) -> String {
        let prefix = match self.numbers.language {
            Language::C => "",
            Language::Rust => "numbers::",
        };
        let each = self.list.iter().map(|constant| {
            let name = &constant.name;
            let fields = constant.form.fields();
            if fields.is_empty() {
                return format!("        {prefix}{name},\n");
            }
            let fields = fields
                .iter()
                .map(|field| format!("{prefix}{name}.{field}, "));
            format!("        {}\n", fields.collect::<String>().trim_end())
        });
        each.collect()
    }

    /// Writes the type definitions of the forms of constants that the file contains.
    pub fn types(&self) -> String {
        let NumberFormat { real, language, .. } = self.numbers;
        let forms = [
            ConstantForm::Zero,
            ConstantForm::Pair,
            ConstantForm::RootPair,
        ];
        let forms = forms.into_iter().filter(|form| self.uses(*form));
        let forms = forms.map(|form| {
            let (name, about) = (form.type_name(language), form.about());
            let fields = form.fields().iter().map(|field| {
                let about = ConstantForm::field_about(field);
                match language {
                    Language::C => format!("    {real} {field}; /* {about} */\n"),
                    Language::Rust => format!("    /// {about}.\n    {field}: {real},\n"),
                }
            });
            let fields: String = fields.collect();
            match language {
                Language::C => format!("/* {about}. */\nstruct {name} {{\n{fields}}};\n\n"),
                Language::Rust => {
                    format!(
                        "/// {about}.\n#[derive(Clone, Copy)]\nstruct {name} {{\n{fields}}}\n\n"
                    )
                }
            }
        });
        forms.collect()
    }

    /// Writes the constants, one per line.
    pub fn written(&self) -> String {
        let NumberFormat { real, language, .. } = self.numbers;
        let lines = self.list.iter().map(|constant| {
            let NamedConstant {
                name,
                form,
                values,
                about,
            } = constant;
            let values: Vec<String> = values
                .iter()
                .map(|value| self.numbers.write(*value))
                .collect();
            let kind = form.type_name(language);
            let about = match (about.is_empty(), language) {
                (true, _) => String::new(),
                (false, Language::C) => format!(" /* {about} */"),
                (false, Language::Rust) => format!(" // {about}"),
            };
            match (language, form) {
                (Language::C, ConstantForm::Number) => {
                    format!("static const {real} {name} = {};{about}\n", values.join(""))
                }
                (Language::C, _) => format!(
                    "static const struct {kind} {name} = {{{}}};{about}\n",
                    values.join(", ")
                ),
                (Language::Rust, ConstantForm::Number) => {
                    format!(
                        "    pub(super) const {name}: {real} = {};{about}\n",
                        values.join("")
                    )
                }
                (Language::Rust, _) => {
                    let fields = form.fields().iter().zip(&values);
                    let fields: Vec<String> = fields
                        .map(|(field, value)| format!("{field}: {value}"))
                        .collect();
                    format!(
                        "    pub(super) const {name}: {kind} = {kind} {{ {} }};{about}\n",
                        fields.join(", ")
                    )
                }
            }
        });
        lines.collect()
    }
}
