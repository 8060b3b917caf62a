//! Records the formulas as graphs. Each emitted function becomes a graph with named outputs.

use super::emission::rounded;
use crate::graph::count::OperationCount;
use crate::graph::print::{Printed, print};
use crate::graph::{Expr, Graph, Operand};
use frictiongen_kernel::Scalar;
use frictiongen_kernel::contact::quadrature::Quadratures;
use frictiongen_kernel::contact::sums::{Chain, ContactAt, ModeAt};
use frictiongen_kernel::number::complex::Complex;
use frictiongen_kernel::oscillator::mode::{Mode, ModeResponse};
use frictiongen_kernel::response::coefficients::Friction;
use frictiongen_model::modal::Modal;
use frictiongen_model::reduced::Reduced;
use frictiongen_model::scene::{Precision, Scene};

/// Records the operations of one function in a graph.
pub(super) struct Tracer<'g> {
    pub graph: &'g Graph,
    pub reduced: Reduced<Expr<'g>>,
}

impl<'g> Tracer<'g> {
    pub fn new(graph: &'g Graph, modal: &Modal, precision: Precision) -> Self {
        Self {
            graph,
            reduced: modal.reduced(|value| Expr::Number(rounded(value, precision))),
        }
    }

    /// Creates a tracer that gives names to the constants: fields of `constants_1`, `constants_2`, … for the modes, and
    /// fields of `CHAIN` for the chain. The emitted code then contains each number once. Numbers that fold (0, 1 and
    /// −1) get no name.
    pub fn over_constants(graph: &'g Graph, modal: &Modal, precision: Precision) -> Self {
        let mut tracer = Self::new(graph, modal, precision);
        let modes = &mut tracer.reduced.modes;
        let same = modes
            .iter()
            .all(|mode| mode.residue.operand() == mode.contact_squared.operand());
        for (number, mode) in (1..).zip(modes) {
            let named = |value: &mut Expr<'g>, field: &str| {
                *value = constant(graph, &format!("constants_{number}.{field}"), *value);
            };
            named(&mut mode.resonance, "resonance");
            named(&mut mode.zeta, "zeta");
            named(&mut mode.q, "q");
            named(&mut mode.q_defect, "q_defect");
            named(&mut mode.load, "load");
            named(&mut mode.contact, "contact");
            named(&mut mode.contact_squared, "contact_squared");
            named(&mut mode.static_residue, "static_residue");
            // If the residue of every mode equals its inverse mass, V and H are the same sum. V is the response to the
            // load, and H the response to a force in the contact.
            if same {
                mode.residue = mode.contact_squared;
            } else {
                named(&mut mode.residue, "residue");
            }
        }
        let chain = &mut tracer.reduced.chain;
        chain.stiction = constant(graph, "Self::CHAIN.stiction", chain.stiction);
        chain.inverse_mass = constant(graph, "Self::CHAIN.inverse_mass", chain.inverse_mass);
        chain.on_moving_base = chain
            .on_moving_base
            .map(|at_rest| constant(graph, "Self::AT_REST", at_rest));
        tracer
    }

    /// Returns the components of a mass in the mode shapes, as inputs `shape_1`, `shape_2`, …. Components that fold (0,
    /// 1 and −1) stay numbers. Masses for which the same components fold then have the same formulas.
    pub fn shape(&self, mass: usize) -> Vec<Expr<'g>> {
        let components = self.reduced.shape(mass).iter().zip(1..);
        let named = components.map(|(component, number)| match *component {
            Expr::Number(value) if value != 0.0 && value.abs() != 1.0 => {
                self.graph.input(format!("shape_{number}"))
            }
            folds => folds,
        });
        named.collect()
    }

    /// Returns the modes, and their loads in quadrature with the motion of the base. Without damping relative to a
    /// moving base, the list of these loads is empty.
    pub fn loaded(&self) -> (&[Mode<Expr<'g>>], &[[Expr<'g>; 2]]) {
        (&self.reduced.modes, &self.reduced.quadratures)
    }

    pub fn count(&self) -> usize {
        self.reduced.modes.len()
    }

    fn damped(&self) -> bool {
        self.reduced.chain.damped
    }

    fn complex(&self, text: &str) -> Complex<Expr<'g>> {
        let im = if self.damped() {
            self.graph.input(format!("{text}.im"))
        } else {
            Expr::Number(0.0)
        };
        Complex::new(self.graph.input(format!("{text}.re")), im)
    }

    fn if_damped(&self, text: String) -> Expr<'g> {
        if self.damped() {
            self.graph.input(text)
        } else {
            Expr::Number(0.0)
        }
    }

    pub fn contact(&self, name: &str) -> ContactAt<Expr<'g>> {
        ContactAt {
            scale: self.graph.input(format!("{name}.scale")),
            v: self.complex(&format!("{name}.v")),
            u: self.graph.input(format!("{name}.u")),
            g: self.if_damped(format!("{name}.g")),
            reversal: self.if_damped(format!("{name}.reversal")),
            h: self.complex(&format!("{name}.h")),
        }
    }

    pub fn mode_at(&self, name: &str) -> ModeAt<Expr<'g>> {
        ModeAt {
            x: self.graph.input(format!("{name}.x")),
            response: self.complex(&format!("{name}.response")),
            u: self.graph.input(format!("{name}.u")),
            g: self.if_damped(format!("{name}.g")),
        }
    }

    /// Returns the response functions of a mode as inputs of the graph. The emitted code has multiplied these functions
    /// by a factor that removes their pole.
    pub fn response(&self, name: &str) -> ModeResponse<Expr<'g>> {
        let of = |field: &str| self.graph.input(format!("{name}.{field}"));
        ModeResponse {
            x: of("x"),
            denominator: self.complex(&format!("{name}.denominator")),
            size: of("size"),
            u: of("u"),
            g: self.if_damped(format!("{name}.g")),
            reversal: self.if_damped(format!("{name}.reversal")),
        }
    }

    pub fn modes_at(&self) -> Vec<ModeAt<Expr<'g>>> {
        (1..=self.count())
            .map(|mode| self.mode_at(&format!("mode_{mode}")))
            .collect()
    }

    pub fn friction(&self) -> Friction<Expr<'g>> {
        let of = |field: &str| self.graph.input(format!("friction.{field}"));
        Friction {
            beta: of("beta"),
            root: of("root"),
            amplitude: of("amplitude"),
            phase: of("phase"),
            unscale: of("unscale"),
        }
    }

    /// Records the whole evaluation of a scene at one frequency ratio, without loops. The closure `g` replaces the
    /// recorded g of each mode, the displacement of the mode at a reversal.
    pub fn frequency(
        &self,
        inverse_r: Expr<'g>,
        g: impl Fn(Expr<'g>) -> Expr<'g>,
    ) -> (ContactAt<Expr<'g>>, Vec<ModeAt<Expr<'g>>>) {
        let Reduced {
            modes,
            quadratures,
            chain,
            ..
        } = &self.reduced;
        let responses = modes.iter().enumerate().map(|(index, mode)| {
            let response = mode.response(inverse_r, index);
            ModeResponse {
                g: g(response.g),
                ..response
            }
        });
        let responses: Vec<ModeResponse<Expr<'g>>> = responses.collect();
        let sizes = responses.iter().map(|response| response.size);
        let scale =
            Chain::scale(modes.iter().zip(sizes)).named("scale", "E, the smallest `size`", None);
        let mut at = Vec::with_capacity(modes.len());
        let contact = chain.contact_loaded(
            (modes, quadratures.as_slice()),
            responses.into_iter(),
            scale,
            inverse_r,
            true,
            |mode| at.push(mode),
        );
        (contact, at)
    }

    /// Records the sums V, H, U, G and H_c over the modes. The responses of the modes are inputs of the graph:
    /// `mode_1`, `at_1` and so on.
    pub fn joined(&self) -> ContactAt<Expr<'g>> {
        let Reduced {
            modes,
            quadratures,
            chain,
            ..
        } = &self.reduced;
        let mut sum = ContactAt::zero(self.graph.input("scale"));
        for (index, mode) in modes.iter().enumerate() {
            let number = index + 1;
            let response = self.response(&format!("mode_{number}"));
            let at = self.mode_at(&format!("at_{number}"));
            let mode = (mode, quadratures.as_slice().of(index));
            let term = chain.term(sum.scale, mode, &response, &at, false, true);
            sum = chain.with_term(&sum, &term, true);
        }
        chain.completed(&sum, self.graph.input("inverse_r"))
    }

    /// Prints `outputs` for a function body. `taken` lists the names that the body already uses.
    pub fn print(
        &self,
        outputs: &[Operand],
        precision: Precision,
        taken: &[&str],
    ) -> (Printed, OperationCount) {
        (
            print(self.graph, outputs, precision, taken),
            OperationCount::of(self.graph, outputs),
        )
    }
}

/// Returns a number as a constant with the name `text`. If the value already has a name, returns it unchanged.
fn constant<'g>(graph: &'g Graph, text: &str, value: Expr<'g>) -> Expr<'g> {
    match value {
        Expr::Number(value) => graph.constant(text, value),
        named @ Expr::Node(..) => named,
    }
}

/// Returns the sums over the modes as inputs of the graph, for the body of a loop that adds one mode to the sums.
pub(super) fn symbolic_sum(graph: &Graph, damped: bool) -> ContactAt<Expr<'_>> {
    let of = |field: &str| graph.input(format!("sum.{field}"));
    let if_damped = |field: &str| {
        if damped {
            of(field)
        } else {
            Expr::constant(0.0)
        }
    };
    ContactAt {
        scale: of("scale"),
        v: Complex::new(of("v.re"), if_damped("v.im")),
        u: of("u"),
        g: if_damped("g"),
        reversal: if_damped("reversal"),
        h: Complex::new(of("h.re"), if_damped("h.im")),
    }
}

/// Returns the scale E and the sums V, U, G, H_c and H of the contact as operands, in the order of the emitted code.
pub(super) fn contact_outputs(contact: &ContactAt<Expr<'_>>) -> Vec<Operand> {
    let ContactAt {
        scale,
        v,
        u,
        g,
        reversal,
        h,
    } = contact;
    [scale, &v.re, &v.im, u, g, reversal, &h.re, &h.im]
        .map(|value| value.operand())
        .to_vec()
}

/// Returns the numbers of a mode at one frequency ratio as operands, in the order of the emitted code.
pub(super) fn mode_outputs(at: &ModeAt<Expr<'_>>) -> Vec<Operand> {
    [at.x, at.response.re, at.response.im, at.u, at.g]
        .map(Expr::operand)
        .to_vec()
}

/// Evaluates the recorded functions of a scene in numbers. Tests compare these numbers with the compiled code and with
/// the run-time system.
pub fn traces<S: frictiongen_kernel::Float>(
    scene: &Scene,
    inverse_r: S,
    beta: S,
) -> Option<Vec<(String, S)>> {
    let modal = Modal::of(scene);
    let graph = Graph::new(scene.masses.len()).in_precision(scene.precision);
    let tracer = Tracer::new(&graph, &modal, scene.precision);
    let inverse = graph.input("inverse_r");
    let (contact, at) = tracer.frequency(inverse, |g| g);
    let chain = &tracer.reduced.chain;
    let friction = chain.friction(&contact, inverse, graph.input("beta"));
    let limit = chain.continuous_limit(&contact, chain.break_away(&contact));
    let mut named: Vec<(String, Operand)> = [
        ("continuous_limit_without_search", limit),
        ("sliding_limit", chain.sliding_limit(&contact)),
        ("amplitude", friction.amplitude),
        ("phase", friction.phase),
    ]
    .map(|(name, value)| (name.to_owned(), value.operand()))
    .to_vec();
    for (index, mass) in scene.masses.iter().enumerate() {
        let shape = tracer.reduced.shape(index);
        let loaded = tracer.loaded();
        let fundamental =
            chain.fundamental_loaded(shape, loaded, &at, &contact, &friction, inverse);
        for (field, value) in [("cosine", fundamental.cosine), ("sine", fundamental.sine)] {
            named.push((format!("{}.{field}", mass.name), value.operand()));
        }
        if tracer.reduced.rubbing == Some(index) {
            continue;
        }
        let stuck = chain.stuck_loaded(shape, loaded, &at, &contact, inverse);
        named.push((format!("{}.stuck.re", mass.name), stuck.re.operand()));
        named.push((format!("{}.stuck.im", mass.name), stuck.im.operand()));
    }
    let outputs: Vec<Operand> = named.iter().map(|(_, operand)| *operand).collect();
    let values = crate::graph::interpret::interpret(&graph, &outputs, |text| match text {
        "inverse_r" => Some(inverse_r),
        "beta" => Some(beta),
        _ => None,
    })?;
    Some(
        named
            .into_iter()
            .map(|(name, _)| name)
            .zip(values)
            .collect(),
    )
}
