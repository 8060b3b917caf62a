//! Tests that the number of operations in a doc comment is that of the emitted text.

#![allow(
    clippy::expect_used,
    clippy::indexing_slicing,
    clippy::panic,
    reason = "a test may fail"
)]

use frictiongen_codegen::{SizeLimits, emit, parse_text};
use std::collections::BTreeSet;
use syn::visit::Visit;
use syn::{Attribute, BinOp, Block, Expr, ImplItemFn, Lit, Local, Meta, Pat, UnOp};

/// Returns the number of operations that a doc comment states. Functions that call others state the sum.
fn stated(attributes: &[Attribute]) -> Option<usize> {
    attributes.iter().find_map(|attribute| {
        let Meta::NameValue(pair) = &attribute.meta else {
            return None;
        };
        let Expr::Lit(literal) = &pair.value else {
            return None;
        };
        let Lit::Str(text) = &literal.lit else {
            return None;
        };
        let text = text.value();
        let number = text.strip_prefix(" Operations: ")?;
        if number == "none." {
            return Some(0);
        }
        number.split(':').next()?.parse().ok()
    })
}

/// Counts the operations of a body on its worst path.
#[derive(Default)]
struct Counted {
    operations: usize,
    /// Names of values that depend on constants of the scene alone.
    constant: BTreeSet<String>,
}

impl Counted {
    /// Returns true if the compiler computes an expression, because it has only constants of the scene.
    fn is_constant(&self, expr: &Expr) -> bool {
        match expr {
            Expr::Lit(_) => true,
            Expr::Paren(inner) => self.is_constant(&inner.expr),
            Expr::Unary(unary) => self.is_constant(&unary.expr),
            Expr::Binary(binary) => {
                self.is_constant(&binary.left) && self.is_constant(&binary.right)
            }
            Expr::Field(field) => self.is_constant(&field.base),
            Expr::Call(call) => {
                is_operation(&call.func) && call.args.iter().all(|one| self.is_constant(one))
            }
            Expr::Path(path) => {
                let name = path.path.segments.last().expect("a name").ident.to_string();
                let is_scene = path.path.segments.len() > 1;
                is_scene
                    || name == "PI"
                    || name == "TAU"
                    || name.starts_with("constants_")
                    || self.constant.contains(&name)
            }
            _ => false,
        }
    }

    /// Counts one arm of a choice of the mass.
    fn of(&self, visit: impl FnOnce(&mut Self)) -> usize {
        let mut arm = Self {
            operations: 0,
            constant: self.constant.clone(),
        };
        visit(&mut arm);
        arm.operations
    }
}

/// Returns true for a call of the scalar trait.
fn is_operation(function: &Expr) -> bool {
    matches!(function, Expr::Path(path) if path.path.segments[0].ident == "Scalar")
}

impl<'ast> Visit<'ast> for Counted {
    fn visit_local(&mut self, local: &'ast Local) {
        let value = &local.init.as_ref().expect("a value").expr;
        if let Pat::Ident(name) = &local.pat
            && self.is_constant(value)
        {
            self.constant.insert(name.ident.to_string());
            return;
        }
        self.visit_expr(value);
    }

    fn visit_expr(&mut self, expr: &'ast Expr) {
        if self.is_constant(expr) {
            return;
        }
        match expr {
            Expr::Binary(binary) => match binary.op {
                BinOp::Add(_)
                | BinOp::Sub(_)
                | BinOp::Mul(_)
                | BinOp::Div(_)
                | BinOp::Lt(_)
                | BinOp::Eq(_) => {
                    self.operations += 1;
                }
                // `if mass != 0` selects what the motion is asked of.
                _ => return,
            },
            Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => self.operations += 1,
            Expr::Call(call) if is_operation(&call.func) => self.operations += 1,
            Expr::If(choice) => {
                let by_flag = matches!(&*choice.cond, Expr::Path(_));
                let by_mass = matches!(&*choice.cond, Expr::Binary(binary)
                    if matches!(binary.op, BinOp::Ne(_) | BinOp::And(_)));
                self.operations += usize::from(!by_flag && !by_mass);
            }
            Expr::Match(choice) => {
                let arms = choice.arms.iter();
                let arms = arms.map(|arm| self.of(|inside| inside.visit_expr(&arm.body)));
                self.operations += arms.max().unwrap_or(0);
                return;
            }
            _ => {}
        }
        syn::visit::visit_expr(self, expr);
    }
}

/// Collects the functions that state a number and call no function of the scene.
#[derive(Default)]
struct Functions {
    found: Vec<(String, usize, usize)>,
}

impl<'ast> Visit<'ast> for Functions {
    fn visit_impl_item_fn(&mut self, function: &'ast ImplItemFn) {
        let name = function.sig.ident.to_string();
        let Some(stated) = stated(&function.attrs) else {
            return;
        };
        // The text of a damped mass's motion repeats the modulus in two conditions, which the number counts once.
        if calls_others(&function.block) || name == "mass_motion" {
            return;
        }
        let mut counted = Counted::default();
        counted.visit_block(&function.block);
        self.found.push((name, stated, counted.operations));
    }
}

/// Returns true if a body calls a function of the scene, or a sum or a loop of the kernel.
fn calls_others(block: &Block) -> bool {
    struct Calls(bool);
    impl<'ast> Visit<'ast> for Calls {
        fn visit_expr(&mut self, expr: &'ast Expr) {
            self.0 |= matches!(expr, Expr::ForLoop(_));
            if let Expr::Call(call) = expr
                && let Expr::Path(path) = &*call.func
            {
                self.0 |= path.path.segments[0].ident == "Self";
            }
            if let Expr::MethodCall(call) = expr {
                self.0 |= call.method == "at_scale" || call.method == "begun_by";
            }
            syn::visit::visit_expr(self, expr);
        }
    }
    let mut calls = Calls(false);
    calls.visit_block(block);
    calls.0
}

#[test]
fn counts_are_those_of_the_text() {
    let one = "masses: { a: 2 }, springs: { base - a: 50 }";
    let two = "masses: { a: 3.27, b: 3.25 }, springs: { base - a: 1190, a - b: 1323 }";
    let mut compared = 0;
    for (chain, contacts) in [
        (one, &["a - wall", "a - base"][..]),
        (two, &["b - wall", "a - b", "a - base"]),
    ] {
        for contact in contacts {
            for excitation in ["base", "a"] {
                for damping in ["none", "modal(0.02)", "modal(0.7)", "modal(1.5)"] {
                    for stiction in ["1", "1.2"] {
                        let text = format!(
                            "struct S {{ {chain}, contact: {contact}, excitation: {excitation},
                             damping: {damping}, stiction: {stiction}, provide: [limits, motion, stuck] }}"
                        );
                        let description = parse_text(&text, &SizeLimits::CHECK).expect("a scene");
                        let file = syn::parse2(emit(&description)).expect("Rust");
                        let mut functions = Functions::default();
                        functions.visit_file(&file);
                        for (name, stated, counted) in &functions.found {
                            assert_eq!(stated, counted, "{name} of {text}");
                        }
                        compared += functions.found.len();
                    }
                }
            }
        }
    }
    assert!(compared > 300, "{compared}");
}
