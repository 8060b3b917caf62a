//! Emits a function body with one match arm for each mass. Each arm is straight-line code.

use super::emission::mentions;
use proc_macro2::{Literal, TokenStream};

/// One match arm of an emitted function: the masses for which it is executed, its statements, and the expression of
/// its value.
pub(super) struct Arm {
    pub masses: Vec<usize>,
    pub statements: TokenStream,
    pub value: TokenStream,
}

/// Returns the body of an emitted function that chooses an arm by the index `mass`: its statements, and the expression
/// of its value. `all` is the number of masses of the chain. For a mass without an arm, the emitted function returns
/// `None`.
pub(super) fn chosen(arms: &[Arm], all: usize) -> (TokenStream, TokenStream) {
    let literals = |masses: &[usize]| -> Vec<Literal> {
        let masses = masses.iter().copied();
        masses.map(Literal::usize_unsuffixed).collect()
    };
    if let [only] = arms {
        let Arm {
            masses,
            statements,
            value,
        } = only;
        // A single arm for all masses needs no check of the index. Its look-up of the mode shape returns `None` for a
        // mass that does not exist. If the shapes fold away, the code has no look-up and needs the check.
        if masses.len() == all && mentions(statements, "mass") {
            return (statements.clone(), value.clone());
        }
        let masses = literals(masses);
        let other = code!(#(mass != #masses)&&*);
        return (code!(if #other { return None; } #statements), value.clone());
    }
    let arms = arms.iter().map(|arm| {
        let Arm {
            masses,
            statements,
            value,
        } = arm;
        let masses = literals(masses);
        code! {
            #(#masses)|* => {
                #statements
                #value
            }
        }
    });
    let value = code! {
        match mass {
            #(#arms)*
            _ => return None,
        }
    };
    (TokenStream::new(), value)
}
