//! An answer that depends on the mass, in straight lines for each.

use proc_macro2::{Literal, TokenStream};

/// The lines of some masses that have the same.
pub(super) struct Arm {
    pub masses: Vec<usize>,
    pub statements: TokenStream,
    pub value: TokenStream,
}

/// Statements, and the value; a function returns `None` from there for any other mass.
pub(super) fn chosen(arms: &[Arm]) -> (TokenStream, TokenStream) {
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
