use super::*;

fn covering(seed: u64) -> Covering {
    let mut covering = Covering::default();
    case(seed, 30, &mut covering);
    covering
}

#[test]
fn cases_are_named_by_their_seeds_and_pass() {
    for seed in 0..400 {
        let found = covering(seed);
        assert_eq!(found, covering(seed));
        let outcome = check(&found, seed % 8 == 0);
        assert_eq!(outcome, Ok(()), "seed {seed}\n{}", found.as_source());
    }
}

#[test]
fn cases_are_of_every_sort() {
    let sorts: [fn(&Covering) -> bool; 8] = [
        |c| c.domain == Domain::Box,
        |c| c.domain == Domain::Notch,
        |c| !c.inner_points,
        |c| !c.divides_edges,
        |c| !c.divides_triangles,
        |c| !c.optimizes,
        |c| c.factor == 1.0,
        |c| c.options().cover(c.data.iter().copied()).is_err(),
    ];
    for (i, is_of_sort) in sorts.iter().enumerate() {
        let count = (0..500).filter(|&seed| is_of_sort(&covering(seed))).count();
        assert!(count > 30, "only {count} of sort {i}");
    }
}

/// An oracle must be able to say no.
#[test]
fn what_is_wrong_is_told() {
    let lattice = Covering {
        data: data(DataKind::Lattice, 36, 0),
        least: 2,
        ..Covering::default()
    };
    let cover = lattice
        .options()
        .cover(lattice.data.iter().copied())
        .unwrap();
    assert!(judge(&lattice, &cover).is_ok());
    let judge = |change: fn(&mut Covering)| judge(&lattice.with(change), &cover);
    assert!(judge(|c| c.least = 7).is_err(), "they hold fewer");
    assert!(judge(|c| c.data.reverse()).is_err(), "other data");
    assert!(judge(|c| c.domain = Domain::Box).is_err(), "other corners");
    let refuse = |error| refusal::check(&lattice, &error);
    let errors = [
        delone::Error::TooFewData {
            distinct: 36,
            least: 2,
        },
        delone::Error::CollinearData { distinct: 36 },
        delone::Error::BadDomain { why: "" },
        delone::Error::DatumOutside {
            datum: 0,
            at: lattice.data[0],
        },
    ];
    for error in errors {
        assert!(refuse(error).is_err());
    }
}
