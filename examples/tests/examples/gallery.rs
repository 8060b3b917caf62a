//! Tests that the gallery shows every figure, and that its links lead to existing files.

use std::path::Path;

/// Returns the targets of a page's links and pictures. Anchors and other sites are left out.
fn links(page: &str) -> impl Iterator<Item = &str> {
    let rests = page.split("](").skip(1);
    rests
        .filter_map(|rest| rest.split([')', '#']).next())
        .filter(|link| !link.is_empty() && !link.starts_with("http"))
}

#[test]
fn every_figure_is_shown_under_its_title() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let page = std::fs::read_to_string(folder.join("GALLERY.md")).expect("the gallery");
    let mut shown = 0;
    for entry in std::fs::read_dir(folder.join("figures")).expect("figures") {
        let path = entry.expect("an entry").path();
        if path.extension().is_none_or(|extension| extension != "svg") {
            continue;
        }
        let picture = std::fs::read_to_string(&path).expect("a picture");
        let rest = picture.split("<title>").nth(1).expect("a title");
        let title = rest.split("</title>").next().expect("its end");
        let name = path.file_name().and_then(|name| name.to_str());
        let link = format!("![{title}](figures/{})", name.expect("a name"));
        assert!(page.contains(&link), "{link}");
        shown += 1;
    }
    assert!(70 < shown, "{shown}");
    for link in links(&page) {
        assert!(folder.join(link).exists(), "{link}");
    }
}
