//! A scene in double-double, and its derivatives with respect to each number of its description.

use frictiongen::study::{System, sensitivity::Quantity};
use frictiongen_kernel::Float;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::dual::Dual;
use frictiongen_model::modal::Modal;
use frictiongen_model::scene::{Damping, Scene};
use generated_tests::data::Data;
use std::cell::OnceCell;

/// A scene in double-double, with its derivatives with respect to all inputs.
pub struct Exact {
    pub data: Data<Dd>,
    modal: Modal,
    scene: Scene,
    along: OnceCell<Vec<Along>>,
}

/// A scene with its derivatives with respect to one number of its description.
struct Along {
    modal: Modal<Dual<Dd>>,
    /// Value of the number. Multiplication by it turns the derivative into one per relative change of the number.
    value: Dd,
}

/// A scene with displaced numbers. Its data carry derivatives with respect to one number of the description.
pub struct Moving {
    pub data: Data<Dual<Dd>>,
    /// Value of the number of the description. Multiplication by it turns the derivative into one per relative
    /// change.
    pub value: Dd,
}

fn data<S: Float>(modal: &Modal<S>) -> Data<S> {
    Data {
        reduced: modal.reduced(|value| value),
    }
}

impl Exact {
    pub fn of(system: &System<Dd>) -> Self {
        let modal = system.modal().clone();
        Self {
            data: data(&modal),
            scene: system.scene().clone(),
            modal,
            along: OnceCell::new(),
        }
    }

    /// Returns the scene with number j displaced by `by[j]` rounding units. The modal data change by the term of
    /// first order. The term of second order is below a rounding unit of double-double.
    pub fn displaced(&self, by: &[f64], epsilon: f64) -> (Data<Dd>, Modal) {
        let mut modal = self.modal.clone();
        for (along, by) in self.along().iter().zip(by) {
            if *by != 0.0 {
                let factor = along.value * Dd::from(epsilon) * Dd::from(*by);
                each(&mut modal, &along.modal, |value, along| {
                    *value = *value + along.slope * factor;
                });
            }
        }
        (data(&modal), modal)
    }

    /// Returns a scene without derivatives with respect to the numbers of its description. The scene may be
    /// displaced. Its results have derivatives with respect to r, β and τ.
    pub fn fixed(modal: &Modal) -> Data<Dual<Dd>> {
        data(&modal.fixed())
    }

    /// Returns a scene once for each number of the description, each time with the derivatives with respect to that
    /// number. The scene may be displaced.
    pub fn moving<'a>(&'a self, modal: &'a Modal) -> impl Iterator<Item = Moving> + 'a {
        self.along().iter().map(|along| {
            let mut there = along.modal.clone();
            each(&mut there, modal, |along, value| along.value = *value);
            Moving {
                data: data(&there),
                value: along.value,
            }
        })
    }

    pub fn modal(&self) -> &Modal {
        &self.modal
    }

    fn along(&self) -> &[Along] {
        self.along.get_or_init(|| self.all_along())
    }

    fn all_along(&self) -> Vec<Along> {
        let Scene {
            masses,
            springs,
            damping,
            stiction,
            ..
        } = &self.scene;
        let masses = masses.iter().map(|mass| mass.value).enumerate();
        let springs = springs.iter().map(|spring| spring.stiffness).enumerate();
        let mut all: Vec<(Quantity, f64)> = masses.map(|(i, m)| (Quantity::Mass(i), m)).collect();
        all.extend(springs.map(|(i, k)| (Quantity::Stiffness(i), k)));
        all.push((Quantity::Stiction, *stiction));
        let mut uniform = None;
        match damping {
            Damping::None => {}
            Damping::Uniform(zeta) => uniform = Some(*zeta).filter(|zeta| *zeta != 0.0),
            Damping::Modal(list) => {
                let ratios = list.iter().enumerate();
                all.extend(ratios.map(|(i, zeta)| (Quantity::DampingRatio(i), *zeta)));
            }
            Damping::Rayleigh { mass, stiffness } => all.extend([
                (Quantity::MassDamping, *mass),
                (Quantity::StiffnessDamping, *stiffness),
            ]),
        }
        let along = |(quantity, value): (Quantity, f64)| {
            let modal = self.modal.along(&self.scene, quantity)?;
            let value = Dd::from(value);
            // Equal modes change smoothly only in another basis of modes. The test does not displace such a number.
            let mut turned = false;
            let mut own = self.modal.clone();
            each(&mut own, &modal, |own, along| {
                turned |= (*own - along.value).abs().to_f64() > 1e-20 * own.abs().to_f64();
            });
            (!value.is_zero() && !turned).then_some(Along { modal, value })
        };
        let one_for_all = uniform.map(|zeta| {
            let mut modal = self.modal.fixed();
            for ratio in &mut modal.damping_ratios {
                ratio.slope = Dd::from(1.0);
            }
            Along {
                modal,
                value: Dd::from(zeta),
            }
        });
        all.into_iter()
            .filter_map(along)
            .chain(one_for_all)
            .collect()
    }
}

/// Visits every number of the modal data, together with the corresponding number of another set of modal data.
fn each<A, B>(modal: &mut Modal<A>, other: &Modal<B>, mut visit: impl FnMut(&mut A, &B)) {
    let single = [
        (&mut modal.inverse_mass, &other.inverse_mass),
        (&mut modal.inertial_load, &other.inertial_load),
        (&mut modal.inertial_drag, &other.inertial_drag),
        (&mut modal.static_motion, &other.static_motion),
        (&mut modal.static_receptance, &other.static_receptance),
        (&mut modal.reference, &other.reference),
        (&mut modal.stiction, &other.stiction),
    ];
    let lists = [
        (&mut modal.resonances, &other.resonances),
        (&mut modal.damping_ratios, &other.damping_ratios),
        (&mut modal.loads, &other.loads),
        (&mut modal.contacts, &other.contacts),
        (&mut modal.participations, &other.participations),
        (&mut modal.walls, &other.walls),
    ];
    let shapes = modal.shapes.iter_mut().zip(&other.shapes);
    let lists = lists.into_iter().chain(shapes);
    let listed = lists.flat_map(|(own, other)| own.iter_mut().zip(other));
    for (own, other) in single.into_iter().chain(listed) {
        visit(own, other);
    }
}
