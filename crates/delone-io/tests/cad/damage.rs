//! Files that are cut or damaged: an answer in any case.

use crate::{data, read};
use delone_io::ReadOptions;
use proptest::prelude::*;

/// The files that damage begins with.
fn seeds() -> Vec<(&'static str, Vec<u8>)> {
    let names = [
        "plate-r12.dxf",
        "plate-binary.dxf",
        "curves.dxf",
        "shapes.svg",
        "lednicer.dat",
        "elements.dat",
    ];
    names
        .map(|name| (name, std::fs::read(data(name)).unwrap()))
        .to_vec()
}

#[test]
fn cut_files_are_answered() {
    for (name, bytes) in seeds() {
        for cut in (0..bytes.len()).step_by(1 + bytes.len() / 300) {
            let _ = read(name, &bytes[..cut], &ReadOptions::default());
            if name.ends_with(".dxf") && cut + 10 < bytes.len() {
                let outcome = read(name, &bytes[..cut], &ReadOptions::default());
                assert!(outcome.is_err(), "{name} cut at {cut}");
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn damaged_files_are_answered(
        seed in 0usize..6,
        damage in proptest::collection::vec((any::<u32>(), any::<u8>()), 1..8),
    ) {
        let (name, mut bytes) = seeds().swap_remove(seed);
        for (at, byte) in damage {
            let at = at as usize % bytes.len();
            bytes[at] = byte;
        }
        if let Ok(domain) = read(name, &bytes, &ReadOptions::default()) {
            let n = domain.vertices.points.len();
            prop_assert!(domain.segments.iter().flatten().all(|v| v.index() < n));
            prop_assert!(domain.vertices.points.iter().all(|p| p.x.is_finite() && p.y.is_finite()));
        }
    }
}
