//! Features of a scene with several contacts, with dashpots, or with masses that no path of springs connects to a
//! support: antiresonances, and the friction from which no contact slides.

use super::functions::Target;
use super::isolate::MotionFunction;
use super::places::samples;
use super::{FeatureError, check_range};
use crate::study::golden::smallest;
use crate::study::joined::{Joined, JoinedError};
use crate::study::large;
use frictiongen_model::joined::at_rest;
use frictiongen_model::modal::Modal;
use frictiongen_model::scene::{ContactSides, Damping, Excitation, Joints, Node, Scene, Spring};

/// Number of steps into which the search for the largest friction divides its range.
const STEPS: usize = 512;
/// Number of golden sections by which the search for the largest friction refines a sample.
const SECTIONS: usize = 60;

/// The friction from which no contact slides, at one frequency.
#[derive(Clone, Debug, PartialEq)]
pub struct StuckLimit {
    /// Frequency ratio r.
    pub r: f64,
    /// Limit of sliding β*_lim: the smallest common friction ratio at which no contact slides. It is infinite on an
    /// undamped resonance of the chain with all contacts stuck.
    pub limit: f64,
    /// Name of the contact that slides first below the limit.
    pub first: String,
}

impl Joined<'_> {
    /// Returns true if the chain has dashpots, or modal or Rayleigh damping.
    #[must_use]
    pub fn is_damped(&self) -> bool {
        let chain = self.chain();
        !chain.dashpots.is_empty() || chain.damping.iter().flatten().any(|entry| *entry != 0.0)
    }

    /// Returns all frequency ratios in the range at which the displacement of a mass vanishes, in ascending order. If
    /// `is_stuck` is true, all contacts stick, and otherwise no contact acts. The list is empty for a mass that the
    /// load does not move.
    ///
    /// # Errors
    /// [`FeatureError::Damped`] for a damped chain, because its motion has a minimum but does not vanish.
    /// [`FeatureError::Range`], [`FeatureError::Crowded`].
    pub fn antiresonances(
        &self,
        mass: usize,
        range: [f64; 2],
        is_stuck: bool,
    ) -> Result<Vec<f64>, FeatureError> {
        check_range(range)?;
        if self.is_damped() {
            return Err(FeatureError::Damped);
        }
        let stuck = if is_stuck { u32::MAX } else { 0 };
        let nodes = self.chain().nodes(stuck);
        let Some(Node::Mass(body)) = nodes.get(mass).copied() else {
            return Ok(Vec::new());
        };
        let Some(scene) = self.linear_scene(&nodes, stuck) else {
            return Ok(Vec::new());
        };
        let modal = at_rest(&scene, large::modal(&scene));
        // The first mass and the first spring of the two scenes may differ, and with them the meaning of r.
        let unit = self.reference() / modal.reference.to_f64();
        let range = range.map(|r| r * unit);
        let zeros = zeros(&modal, body, range)?;
        Ok(zeros.into_iter().map(|r| r / unit).collect())
    }

    /// Returns the scene without friction, in which stuck rigid contacts have joined masses. `nodes` has the node of
    /// each mass. Bit i of `stuck` belongs to contact i. Returns `None` if the load acts on no mass, or if the scene has no spring.
    fn linear_scene(&self, nodes: &[Node], stuck: u32) -> Option<Scene> {
        let scene = self.scene();
        let node = |old: Node| match old {
            Node::Mass(mass) => nodes.get(mass).copied().unwrap_or(old),
            support => support,
        };
        let excitation = match scene.excitation {
            Excitation::Base => Excitation::Base,
            Excitation::Force(mass) => match node(Node::Mass(mass)) {
                Node::Mass(body) => Excitation::Force(body),
                Node::Wall | Node::Base => return None,
            },
        };
        let mut masses = Vec::new();
        for (mass, own) in scene.masses.iter().enumerate() {
            match node(Node::Mass(mass)) {
                Node::Mass(body) if body == masses.len() => masses.push(own.clone()),
                Node::Mass(body) => {
                    masses.get_mut(body)?.value += own.value;
                }
                Node::Wall | Node::Base => {}
            }
        }
        let springs = self.chain().springs_of(stuck);
        let springs = springs.map(|(from, to, stiffness)| Spring {
            from: node(from),
            to: node(to),
            stiffness,
        });
        let moves = |spring: &Spring| {
            let is_mass = |node| matches!(node, Node::Mass(_));
            spring.from != spring.to && (is_mass(spring.from) || is_mass(spring.to))
        };
        let springs: Vec<Spring> = springs.filter(moves).collect();
        (!springs.is_empty()).then(|| Scene {
            masses,
            springs,
            excitation,
            damping: Damping::None,
            contact: ContactSides {
                from: Node::Mass(0),
                to: Node::Wall,
            },
            stiffness: None,
            joints: Joints::default(),
            ..scene.clone()
        })
    }

    /// Returns the friction ratio from which no contact slides at the frequency ratio r.
    ///
    /// # Errors
    /// Same errors as [`at_any`](Self::at_any). [`JoinedError::NotLinear`] for a scene with stops, moving surfaces or
    /// constant forces.
    pub fn stuck_limit(&self, r: f64) -> Result<StuckLimit, JoinedError> {
        let beside = |distance: f64| self.sampled_limit(r * (1.0 + distance));
        let (near, nearer) = (beside(1e-6)?, beside(1e-7)?);
        // On an undamped resonance, rounding makes the limit finite. Beside it, the limit grows as the inverse of the
        // distance.
        if 5.0 * near.limit < nearer.limit {
            return Ok(StuckLimit {
                r,
                limit: f64::INFINITY,
                ..nearer
            });
        }
        self.sampled_limit(r)
    }

    fn sampled_limit(&self, r: f64) -> Result<StuckLimit, JoinedError> {
        let stuck = self.at_any(r)?.stuck()?;
        Ok(StuckLimit {
            r,
            limit: stuck.limit(),
            first: stuck.first().to_owned(),
        })
    }

    /// Returns the largest friction ratio from which no contact slides in a range of frequency ratios. `marks` has the
    /// resonances of the chain with all contacts stuck. The search samples the range, and refines the largest sample.
    ///
    /// # Errors
    /// Same errors as [`stuck_limit`](Self::stuck_limit).
    pub fn largest_stuck_limit(
        &self,
        range: [f64; 2],
        marks: &[f64],
    ) -> Result<Option<StuckLimit>, JoinedError> {
        let [from, to] = range;
        for r in marks.iter().filter(|r| from <= **r && **r <= to) {
            let found = self.stuck_limit(*r)?;
            if found.limit.is_infinite() {
                return Ok(Some(found));
            }
        }
        let places = samples(range, STEPS, marks);
        let limit = |r: f64| match self.sampled_limit(r) {
            Err(JoinedError::Resonance) => Ok(f64::INFINITY),
            found => found.map(|found| found.limit),
        };
        let limits: Vec<f64> = places.iter().map(|r| limit(*r)).collect::<Result<_, _>>()?;
        let Some((top, _)) = (0..).zip(&limits).max_by(|a, b| a.1.total_cmp(b.1)) else {
            return Ok(None);
        };
        let at = |index: usize| places.get(index).copied();
        let own = at(top).unwrap_or(from);
        let low = top.checked_sub(1).and_then(at).unwrap_or(own);
        let high = at(top + 1).unwrap_or(own);
        let (refined, value) = smallest((low, high), (SECTIONS, 0.0), |r| limit(r).map(|x| -x))?;
        let best = limits.get(top).copied().unwrap_or(f64::NAN);
        let r = if best < -value { refined } else { own };
        self.sampled_limit(r).map(Some)
    }
}

/// Returns the zeros of the motion of a mass without friction, as frequency ratios of the modal analysis.
fn zeros(modal: &Modal, mass: usize, range: [f64; 2]) -> Result<Vec<f64>, FeatureError> {
    let function = MotionFunction::new(modal, Some(mass), Target::Free);
    let zeros = function.zeros(range)?;
    Ok(zeros.into_iter().map(|zero| zero.r()).collect())
}
