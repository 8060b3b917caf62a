//! Tests that the links of the gallery lead to existing files.

use std::path::Path;

/// Returns the targets of a page's links and pictures. Anchors and other sites are left out.
fn links(page: &str) -> impl Iterator<Item = &str> {
    let ends = [("](", ')'), ("src=\"", '"'), ("srcset=\"", '"')];
    ends.into_iter()
        .flat_map(|(start, end)| {
            let rests = page.split(start).skip(1);
            rests.filter_map(move |rest| rest.split(end).next())
        })
        .filter_map(|link| link.split('#').next())
        .filter(|link| !link.is_empty() && !link.starts_with("http"))
}

#[test]
fn every_link_has_its_file() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let figures = folder.join("figures");
    let mut pages = vec![folder.join("GALLERY.md")];
    for entry in std::fs::read_dir(&figures).expect("figures") {
        let path = entry.expect("an entry").path();
        if path.extension().is_some_and(|extension| extension == "md") {
            pages.push(path);
        }
    }
    assert!(4 < pages.len());
    for page in pages {
        let text = std::fs::read_to_string(&page).expect("a page");
        let beside = page.parent().expect("a folder");
        let mut count = 0;
        for link in links(&text) {
            assert!(beside.join(link).exists(), "{}: {link}", page.display());
            count += 1;
        }
        assert!(5 < count, "{}", page.display());
    }
}
