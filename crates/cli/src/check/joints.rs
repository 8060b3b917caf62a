//! Stops, moving surfaces, dashpots and constant forces of a scene.

use frictiongen::study::scene::{Impact, Node, Scene};
use serde_json::{Map, Value as Json, json};

/// Returns a line for each of them: what it is, its name or its ends, and its numbers.
pub fn lines(scene: &Scene) -> Vec<[String; 3]> {
    let node = |node: Node| scene.node_name(node);
    let line = |what: &str, name: String, numbers: String| [what.to_owned(), name, numbers];
    let contacts = scene.named_contacts().into_iter();
    let belts = contacts.filter(|contact| contact.law.speed != 0.0);
    let belts = belts.map(|contact| {
        let speed = contact.law.speed;
        line("moving surface (m/s)", contact.name, format!("{speed:?}"))
    });
    let stops = scene.joints.stops.iter().map(|stop| {
        let ends = format!("{} - {}", node(stop.sides.from), node(stop.sides.to));
        let law = match stop.law.impact {
            Impact::Spring { stiffness, damping } => {
                format!("stiffness {stiffness:?}, damping {damping:?}")
            }
            Impact::Restitution(restitution) => format!("restitution {restitution:?}"),
        };
        let numbers = format!("{ends}, gap {:?}, {law}", stop.law.gap);
        line("stop (m, N/m, N s/m)", stop.name.clone(), numbers)
    });
    let dampers = scene.joints.dampers.iter().map(|damper| {
        let ends = format!("{} - {}", node(damper.from), node(damper.to));
        line("dashpot (N s/m)", ends, format!("{:?}", damper.coefficient))
    });
    let constant = scene.joints.constant.iter().map(|own| {
        let mass = node(Node::Mass(own.mass)).to_owned();
        line("constant force (N)", mass, format!("{:?}", own.force))
    });
    belts.chain(stops).chain(dampers).chain(constant).collect()
}

/// Returns them as JSON fields. The fields are missing for a scene that has none of them.
pub fn json(scene: &Scene) -> Map<String, Json> {
    let node = |node: Node| scene.node_name(node);
    let contacts = scene.named_contacts().into_iter();
    let belts = contacts.filter(|contact| contact.law.speed != 0.0);
    let belts = belts.map(|own| json!({ "name": own.name, "speed_m_s": own.law.speed }));
    let stops = scene.joints.stops.iter().map(|stop| {
        let (stiffness, damping, restitution) = stop.law.impact.numbers();
        let restitution = stiffness.is_none().then_some(restitution);
        json!({
            "name": stop.name,
            "between": [node(stop.sides.from), node(stop.sides.to)],
            "gap_m": stop.law.gap,
            "stiffness_N_m": stiffness,
            "damping_N_s_m": stiffness.map(|_| damping),
            "restitution": restitution,
        })
    });
    let dampers = scene.joints.dampers.iter().map(|damper| {
        json!({
            "between": [node(damper.from), node(damper.to)],
            "coefficient_N_s_m": damper.coefficient,
        })
    });
    let constant = scene.joints.constant.iter();
    let constant =
        constant.map(|own| json!({ "mass": node(Node::Mass(own.mass)), "force_N": own.force }));
    let fields: [(&str, Vec<Json>); 4] = [
        ("moving_surfaces", belts.collect()),
        ("stops", stops.collect()),
        ("dashpots", dampers.collect()),
        ("constant_forces", constant.collect()),
    ];
    let given = fields.into_iter().filter(|(_, list)| !list.is_empty());
    given
        .map(|(name, list)| (name.to_owned(), Json::Array(list)))
        .collect()
}
