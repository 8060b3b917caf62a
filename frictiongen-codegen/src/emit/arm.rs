//! Emits a function body that depends on the mass, with straight-line code for each mass.

use proc_macro2::{Literal, TokenStream};

/// Code of one match arm, shared by all masses in `masses`.
pub(super) struct Arm {
    pub masses: Vec<usize>,
    pub statements: TokenStream,
    pub value: TokenStream,
}

/// Returns the statements and the value expression. The emitted function returns `None` for any
/// mass without an arm.
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
