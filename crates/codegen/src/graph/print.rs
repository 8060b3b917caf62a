//! Prints a graph as Rust. A value with a name or with several uses becomes a `let` statement. Every other value is
//! part of the expression that uses it.

use super::literal::literal;
use super::{Binary, Graph, Id, Operand, Operation, Recorded, Unary, ValueName, operands};
use frictiongen_model::scene::Precision;
use proc_macro2::{Ident, Span, TokenStream};
use std::collections::{BTreeMap, BTreeSet};

/// A printed expression and its operator precedence.
#[derive(Clone)]
struct Text {
    tokens: TokenStream,
    binds: Binds,
}

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binds {
    Branch,
    Compare,
    Sum,
    Product,
    Unary,
    Atom,
}

/// Printed statements, and the expressions of the outputs.
pub struct Printed {
    /// The `let` statements that bind shared and named values.
    pub statements: TokenStream,
    /// One expression for each output of the graph.
    pub outputs: Vec<TokenStream>,
}

/// Prints the operations on which `outputs` depend. `taken` lists names that the surrounding code uses.
#[must_use]
pub fn print(graph: &Graph, outputs: &[Operand], precision: Precision, taken: &[&str]) -> Printed {
    let mut printer = Printer::new(precision, taken);
    printer.visit_all(&graph.reachable(outputs), outputs, 1);
    printer.printed(outputs)
}

/// Values that the printed code has bound so far, with their names.
#[derive(Clone)]
pub(super) struct Printer {
    precision: Precision,
    texts: BTreeMap<Id, Text>,
    pairs: BTreeMap<Id, (Option<Id>, Option<Id>)>,
    names: BTreeSet<String>,
    visited: BTreeSet<Id>,
    statements: TokenStream,
}

impl Printer {
    pub(super) fn new(precision: Precision, taken: &[&str]) -> Self {
        Self {
            precision,
            texts: BTreeMap::new(),
            pairs: BTreeMap::new(),
            names: taken.iter().map(|name| (*name).to_owned()).collect(),
            visited: BTreeSet::new(),
            statements: TokenStream::new(),
        }
    }

    /// Binds each value that has a name or more than one use to a `let` variable. Each output counts as `each` uses of
    /// its value.
    pub(super) fn visit_all(&mut self, nodes: &[Recorded], outputs: &[Operand], each: usize) {
        let mut uses: BTreeMap<Id, usize> = BTreeMap::new();
        for (_, node, _) in nodes {
            for operand in operands(node) {
                *uses.entry(operand).or_default() += 1;
            }
        }
        for output in outputs {
            if let Operand::Node(id) = output {
                *uses.entry(*id).or_default() += each;
            }
        }
        for (id, node, _) in nodes {
            if let Operation::Part(pair, second) = node {
                let parts = self.pairs.entry(*pair).or_default();
                if *second {
                    parts.1 = Some(*id)
                } else {
                    parts.0 = Some(*id)
                }
            }
        }
        let names: BTreeMap<Id, ValueName> = nodes
            .iter()
            .filter_map(|(id, _, name)| Some((*id, name.clone()?)))
            .collect();
        for (id, node, name) in nodes {
            if self.visited.insert(*id) {
                let uses = uses.get(id).copied().unwrap_or(0);
                self.visit(*id, node, name.as_ref(), uses, &names);
            }
        }
    }

    /// Returns the `let` statements that the printer has collected since the last call of this function.
    pub(super) fn statements(&mut self) -> TokenStream {
        std::mem::take(&mut self.statements)
    }

    pub(super) fn printed(mut self, outputs: &[Operand]) -> Printed {
        let outputs = outputs.iter().map(|output| self.text(output).tokens);
        Printed {
            outputs: outputs.collect(),
            statements: self.statements(),
        }
    }

    fn visit(
        &mut self,
        id: Id,
        node: &Operation,
        name: Option<&ValueName>,
        uses: usize,
        names: &BTreeMap<Id, ValueName>,
    ) {
        match node {
            Operation::Part(..) => return,
            Operation::SinCosPi(_) | Operation::SinCosPiMinus(..) => {
                let value = self.expression(node).tokens;
                let (first, second) = self.pairs.get(&id).copied().unwrap_or_default();
                let about = [first, second].into_iter().flatten();
                let about = about.filter_map(|part| Some(names.get(&part)?.about));
                let about = about.collect::<Vec<_>>().join(", ");
                let mut bind = |part: Option<Id>, default: &str| match part {
                    None => code!(_),
                    Some(part) => {
                        let name = names.get(&part).map_or(default, |name| name.text.as_str());
                        let ident = self.fresh(name);
                        self.texts.insert(part, atom(code!(#ident)));
                        code!(#ident)
                    }
                };
                let (first, second) = (bind(first, "sine"), bind(second, "cosine"));
                let about = explained(&about);
                self.statements
                    .extend(code!(#about let (#first, #second) = #value;));
                return;
            }
            _ => {}
        }
        let text = self.expression(node);
        let trivial = matches!(
            node,
            Operation::Input(_)
                | Operation::Constant(..)
                | Operation::Less(..)
                | Operation::IsZero(_)
        );
        let text = if !trivial && (name.is_some() || uses > 1) {
            let ident = self.fresh(name.map_or_else(|| fallback(node), |name| &name.text));
            let value = text.tokens;
            let about = explained(name.map_or("", |name| name.about));
            self.statements.extend(code!(#about let #ident = #value;));
            atom(code!(#ident))
        } else {
            text
        };
        self.texts.insert(id, text);
    }

    fn fresh(&mut self, name: &str) -> Ident {
        let mut full = name.to_owned();
        let mut number = 2;
        while !self.names.insert(full.clone()) {
            full = format!("{name}_{number}");
            number += 1;
        }
        Ident::new(&full, Span::mixed_site())
    }

    fn text(&self, operand: &Operand) -> Text {
        match operand {
            Operand::Number(bits) => {
                let value = f64::from_bits(*bits);
                let binds = if value.is_sign_negative() {
                    Binds::Unary
                } else {
                    Binds::Atom
                };
                Text {
                    tokens: named_number(value).unwrap_or_else(|| literal(value, self.precision)),
                    binds,
                }
            }
            Operand::Node(id) => self
                .texts
                .get(id)
                .cloned()
                .unwrap_or_else(|| atom(TokenStream::new())),
        }
    }

    /// Returns the text of an operand. The text is in parentheses if its operator binds less tightly than `least`.
    fn within(&self, operand: &Operand, least: Binds) -> TokenStream {
        let text = self.text(operand);
        let tokens = text.tokens;
        if text.binds >= least {
            tokens
        } else {
            code!((#tokens))
        }
    }

    fn expression(&self, node: &Operation) -> Text {
        let plain = |operand: &Operand| self.text(operand).tokens;
        match node {
            Operation::Input(text) | Operation::Constant(text, _) => {
                atom(mixed(text.parse().unwrap_or_default()))
            }
            Operation::Unary(Unary::Neg, a) => {
                let a = self.within(a, Binds::Unary);
                Text {
                    tokens: code!(-#a),
                    binds: Binds::Unary,
                }
            }
            Operation::Unary(op, a) => {
                let function = Ident::new(unary_name(*op), Span::mixed_site());
                let a = plain(a);
                atom(code!(Scalar::#function(#a)))
            }
            Operation::Binary(op, a, b) => self.binary(*op, a, b),
            Operation::SinCosPi(a) => {
                let a = plain(a);
                atom(code!(Scalar::sin_cos_pi(#a)))
            }
            Operation::SinCosPiMinus(a, b) => {
                let (a, b) = (plain(a), plain(b));
                atom(code!(Scalar::sin_cos_pi_minus(#a, #b)))
            }
            Operation::Part(..) => atom(TokenStream::new()),
            Operation::Less(a, b) => {
                let (a, b) = (self.within(a, Binds::Sum), self.within(b, Binds::Sum));
                Text {
                    tokens: code!(#a < #b),
                    binds: Binds::Compare,
                }
            }
            Operation::IsZero(a) => {
                let a = self.within(a, Binds::Sum);
                Text {
                    tokens: code!(#a == 0.0),
                    binds: Binds::Compare,
                }
            }
            Operation::Select(condition, yes, no) => {
                let condition = self.text(&Operand::Node(*condition)).tokens;
                let (yes, no) = (plain(yes), plain(no));
                Text {
                    tokens: code!(if #condition { #yes } else { #no }),
                    binds: Binds::Branch,
                }
            }
        }
    }

    fn binary(&self, op: Binary, a: &Operand, b: &Operand) -> Text {
        let sum = |tokens| Text {
            tokens,
            binds: Binds::Sum,
        };
        let product = |tokens| Text {
            tokens,
            binds: Binds::Product,
        };
        match op {
            Binary::Add => {
                let (a, b) = (self.within(a, Binds::Sum), self.within(b, Binds::Product));
                sum(code!(#a + #b))
            }
            Binary::Sub => {
                let (a, b) = (self.within(a, Binds::Sum), self.within(b, Binds::Product));
                sum(code!(#a - #b))
            }
            Binary::Mul => {
                let (a, b) = (self.within(a, Binds::Product), self.within(b, Binds::Unary));
                product(code!(#a * #b))
            }
            Binary::Div => {
                let (a, b) = (self.within(a, Binds::Product), self.within(b, Binds::Unary));
                product(code!(#a / #b))
            }
            Binary::Max | Binary::Min | Binary::Copysign | Binary::Atan2 | Binary::Hypot => {
                let function = match op {
                    Binary::Max => code!(max),
                    Binary::Min => code!(min),
                    Binary::Copysign => code!(copysign),
                    Binary::Hypot => code!(hypot),
                    _ => code!(atan2),
                };
                let (a, b) = (self.text(a).tokens, self.text(b).tokens);
                atom(code!(Scalar::#function(#a, #b)))
            }
        }
    }
}

/// Returns an explanation as the doc comment of a `let` statement. The comment is for readers. The compiler ignores
/// it.
fn explained(about: &str) -> TokenStream {
    if about.is_empty() {
        return TokenStream::new();
    }
    let about = format!(" {about}");
    code!(#[doc = #about])
}

/// Returns the name of a constant if the value is π or 2π.
fn named_number(value: f64) -> Option<TokenStream> {
    use std::f64::consts::{PI, TAU};
    let name = [(PI, code!(PI)), (TAU, code!(TAU))];
    let (_, name) = name
        .into_iter()
        .find(|(number, _)| number.to_bits() == value.abs().to_bits())?;
    Some(if value.is_sign_negative() {
        code!(-#name)
    } else {
        name
    })
}

fn atom(tokens: TokenStream) -> Text {
    Text {
        tokens,
        binds: Binds::Atom,
    }
}

fn unary_name(op: Unary) -> &'static str {
    match op {
        Unary::Neg => "neg",
        Unary::Abs => "abs",
        Unary::Sqrt => "sqrt",
        Unary::Exp => "exp",
        Unary::ExpM1 => "exp_m1",
        Unary::OneMinusSincPi => "one_minus_sinc_pi",
        Unary::DetuningOffPole => "detuning_off_pole",
        Unary::CosineOffPole => "cosine_off_pole",
        Unary::ScaledSinhDefect => "scaled_sinh_defect",
    }
}

/// Returns the tokens with mixed-site hygiene: local names in them do not clash with names of the user.
fn mixed(tokens: TokenStream) -> TokenStream {
    tokens
        .into_iter()
        .map(|mut token| {
            token.set_span(Span::mixed_site());
            token
        })
        .collect()
}

/// Returns the name of a bound value whose formula gives it no name.
fn fallback(node: &Operation) -> &'static str {
    match node {
        Operation::Binary(Binary::Add, ..) => "sum",
        Operation::Binary(Binary::Sub, ..) => "difference",
        Operation::Binary(Binary::Mul, ..) => "product",
        Operation::Binary(Binary::Div, ..) => "ratio",
        Operation::Unary(Unary::Abs, _) => "magnitude",
        Operation::Unary(Unary::Sqrt, _) => "root",
        Operation::Select(..) => "choice",
        _ => "value",
    }
}
