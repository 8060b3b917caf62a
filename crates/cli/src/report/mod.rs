//! `frictiongen report`: writes the results for a scene description as one HTML page. The page needs no network.

pub mod asked;
mod best;
mod cost;
mod features;
mod found;
mod live;
mod map;
mod modes;
pub mod page;
mod plot;
mod response;
pub mod scene;
mod summary;
pub mod words;

use crate::args::ReportArguments;
use crate::failure::Failure;
use crate::file;
use crate::interrupt;
use crate::joined;
use crate::play;
use asked::ReportRequest;
use frictiongen::System;
use frictiongen_codegen::{SizeLimits, parse_text};
use page::ReportPage;
use std::io::Write;

/// Runs `frictiongen report`.
pub fn run(arguments: &ReportArguments, out: &mut dyn Write) -> Result<(), Failure> {
    if let Some(path) = arguments.output.as_deref() {
        file::check_page(path, "a report")?;
        // The command checks the file before it computes. The user then gets an error about the file without waiting.
        file::check(path, arguments.file.path())?;
    }
    let name = arguments.file.name();
    let text = arguments.file.text()?;
    let description = parse_text(&text, &SizeLimits::RUN_TIME).map_err(|diagnostics| {
        let lines = diagnostics.list.into_iter();
        Failure::Lines(lines.map(|line| format!("{name}:{line}")).collect())
    })?;
    let documentation = description.documentation();
    if description.scene.has_joined_states() {
        joined::refused(&[(arguments.live, "--live")])?;
        let about = (name.as_str(), documentation.as_str());
        return joined::write_page(arguments, description.scene, about, out);
    }
    let playground = match arguments.live {
        true => Some(play::page(arguments.page.as_deref())?),
        false => None,
    };
    let system = System::try_from(description.scene).map_err(Failure::new)?;
    let mut asked = ReportRequest::of(arguments, system)?;
    interrupt::watch();
    let best = best::search(&asked);
    let best_beta = best::worst(&best).map(|(_, optimum)| optimum.beta);
    let levels = asked.levels(best_beta);
    let responses = response::Responses::of(&asked, &levels, best_beta)?;
    let features = features::FeatureSection::of(&asked, &levels, best_beta);
    let live = playground.map(|page| live::start(&page, &text, &asked, best_beta));
    let page = ReportPage {
        file: &name,
        documentation: &documentation,
        modes: modes::ModeSection::of(&asked),
        responses,
        regimes: map::Regimes::of(&asked, &levels, best::limits(&best))?,
        features,
        cost: cost::CostSection::of(&text, &asked),
        best,
        live,
        asked,
    };
    let html = page.html();
    let paths = (arguments.output.as_deref(), arguments.file.path());
    file::write_page(paths, &html, out)?;
    match page.regimes.is_cut {
        true => Err(Failure::new(
            "stopped: the page is written, but its map of the regimes ends early",
        )),
        false => Ok(()),
    }
}
