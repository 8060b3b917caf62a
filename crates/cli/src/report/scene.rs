//! Section of the report about the scene: a drawing and the values.

use super::asked::ReportRequest;
use super::words::digits;
use crate::measure::Measure;
use frictiongen::study::scene::{Damping, DampingFrom, Excitation, Node, Scene};
use frictiongen::study::units::Load;
use frictiongen_plot::{Excitation as Drawn, Label, Sketch, desk};
use maud::{Markup, PreEscaped, html};
use serde_json::{Value as Json, json};

/// Returns the name of a node in the scene description.
fn node(scene: &Scene, node: Node) -> &str {
    scene.node_name(node)
}

/// Returns a sketch of the chain with its values and the amplitude of the load, or `None` for a long chain.
pub fn drawing(scene: &Scene, measure: &Measure) -> Option<String> {
    let plain = desk::sketch(scene, true);
    let values = scene.masses.iter();
    let values = values.map(|mass| Label::verbatim(&format!("{} kg", digits(mass.value))));
    let mut sketch = Sketch {
        values: values.collect(),
        ..plain
    };
    for (drawn, spring) in sketch.springs.iter_mut().zip(&scene.springs) {
        drawn.label = Label::verbatim(&format!("{} N/m", digits(spring.stiffness)));
    }
    for (drawn, damper) in sketch.dashpots.iter_mut().zip(&scene.joints.dampers) {
        drawn.label = Label::verbatim(&format!("{} N·s/m", digits(damper.coefficient)));
    }
    let contacts = scene.named_contacts().into_iter();
    let speeds = contacts.map(|contact| match contact.law.speed {
        0.0 => String::new(),
        speed => format!(", {} m/s", digits(speed)),
    });
    let stops = scene.joints.stops.iter();
    let gaps = stops.map(|stop| format!(", gap {} m", digits(stop.law.gap)));
    for (drawn, more) in sketch.sliders.iter_mut().zip(speeds.chain(gaps)) {
        drawn.label = Label::verbatim(&(drawn.label.plain() + &more));
    }
    for (drawn, own) in sketch.constant.iter_mut().zip(&scene.joints.constant) {
        drawn.label = Label::verbatim(&format!("{} N", digits(own.force.abs())));
    }
    let size = measure.load().map(|load| match load {
        Load::Base(motion) => (format!("*Y* = {} mm", digits(1e3 * motion)), "*Y* cos *ωt*"),
        load => (
            format!("*P* = {} N", digits(load.amplitude())),
            "*P* cos *ωt*",
        ),
    });
    if let (Some((size, _)), Drawn::Base { label } | Drawn::Force { label, .. }) =
        (size, &mut sketch.excitation)
    {
        *label = size.into();
    }
    sketch.svg()
}

/// Describes the damping of the scene in words.
fn damping(scene: &Scene) -> String {
    let acts_on = match (scene.damping_acts_on(), scene.damping_from) {
        (None, _) => "",
        (Some(_), DampingFrom::Rest) => ", on absolute velocities",
        (Some(_), DampingFrom::Base) => ", relative to the base",
    };
    let ratios = match &scene.damping {
        Damping::None => "none but friction".to_owned(),
        Damping::Uniform(zeta) => format!("damping ratio {} in every mode", digits(*zeta)),
        Damping::Modal(zeta) => {
            let all: Vec<String> = zeta.iter().map(|zeta| digits(*zeta)).collect();
            format!("damping ratios of the modes {}", all.join(", "))
        }
        Damping::Rayleigh { mass, stiffness } => format!(
            "Rayleigh: {} of the mass and {} of the stiffness matrix",
            digits(*mass),
            digits(*stiffness)
        ),
    };
    ratios + acts_on
}

/// Describes the load of the report in words.
fn load(asked: &ReportRequest) -> String {
    let scene = asked.system.scene();
    let place = match scene.excitation {
        Excitation::Base => "motion of the base".to_owned(),
        Excitation::Force(index) => {
            let name = scene
                .masses
                .get(index)
                .map_or("", |mass| mass.name.as_str());
            format!("force on {name}")
        }
    };
    match asked.words.measure.load() {
        None => place,
        Some(Load::Base(motion)) => format!("{place}, amplitude Y = {} mm", digits(1e3 * motion)),
        Some(load) => format!("{place}, amplitude P = {} N", digits(load.amplitude())),
    }
}

/// Returns the section about the scene as HTML.
pub fn html(asked: &ReportRequest) -> Markup {
    let scene = asked.system.scene();
    let contact = (
        node(scene, scene.contact.from),
        node(scene, scene.contact.to),
    );
    html! {
        section #scene {
            h2 { "The chain" }
            @match drawing(scene, &asked.words.measure) {
                // The crate frictiongen-plot has made this SVG text, and has escaped every word of the user in it.
                Some(svg) => div.scroll.paper.sketch tabindex="0" role="region" aria-label="Drawing of the chain" { (PreEscaped(svg)) },
                None => p { "A chain of " (scene.masses.len()) " masses is not drawn; its values are in the tables." },
            }
            dl.facts {
                div { dt { (scene.contact_name) } dd { (contact.0) " – " (contact.1) } }
                @if let Some(stiffness) = scene.stiffness {
                    div { dt { "stiffness of the contact, in series with its slider" } dd { (digits(stiffness)) " N/m" } }
                }
                div { dt { "load" } dd { (load(asked)) } }
                div { dt { "damping" } dd { (damping(scene)) } }
                div { dt { "stiction, static over kinetic friction" } dd { "μ = " (digits(scene.stiction)) } }
            }
            details {
                summary { "Values: masses and springs" }
                div.pair {
                    (masses_and_springs(scene))
                }
            }
            p.note {
                "The page reads the numbers of the description as kg, N/m, N and m. "
                "r = ω√(m₁/k₁) and β = "
                @if scene.excitation == Excitation::Base { "F/(k₁Y)" } @else { "F/P" }
                " refer to the first mass and the first spring."
            }
        }
    }
}

/// Returns the tables of the masses and of the springs.
pub fn masses_and_springs(scene: &Scene) -> Markup {
    html! {
        table {
            caption { "Masses" }
            thead { tr { th scope="col" { "name" } th scope="col" { "kg" } } }
            tbody { @for mass in &scene.masses { tr { th scope="row" { (mass.name) } td { (digits(mass.value)) } } } }
        }
        table {
            caption { "Springs" }
            thead { tr { th scope="col" { "between" } th scope="col" { "N/m" } } }
            tbody { @for spring in &scene.springs { tr {
                th scope="row" { (node(scene, spring.from)) " – " (node(scene, spring.to)) }
                td { (digits(spring.stiffness)) }
            } } }
        }
    }
}

/// Returns the scene as JSON data.
pub fn data(asked: &ReportRequest) -> Json {
    let scene = asked.system.scene();
    let masses = scene.masses.iter();
    let springs = scene.springs.iter();
    json!({
        "masses": masses.map(|mass| json!({ "name": mass.name, "kg": mass.value })).collect::<Vec<_>>(),
        "springs": springs.map(|spring| json!({
            "between": [node(scene, spring.from), node(scene, spring.to)],
            "N_per_m": spring.stiffness,
        })).collect::<Vec<_>>(),
        "contact": [node(scene, scene.contact.from), node(scene, scene.contact.to)],
        "contact_N_per_m": scene.stiffness,
        "load": load(asked),
        "load_m_or_N": asked.words.measure.load().map(|load| load.amplitude()),
        "damping": damping(scene),
        "stiction": scene.stiction,
    })
}
