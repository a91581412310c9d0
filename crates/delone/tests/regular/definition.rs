//! The definition, word by word, with the perturbed predicates: O(n⁴), no mesh, no walk.

use crate::sites::everywhere;
use crate::{Site, built, hidden, triangles, turned};
use delone::predicates::{
    Orientation, Weighted, in_power_circle_perturbed, in_power_segment_perturbed, orient2d,
};

fn weighted((p, w): Site) -> Weighted {
    Weighted::new(p, w)
}

/// The sites that count: of each place the heaviest, of equally heavy ones the first.
fn strongest(sites: &[Site]) -> Vec<usize> {
    let beats = |i: usize, j: usize| {
        let [(p, w), (q, v)] = [sites[i], sites[j]];
        p == q && (w > v || (w == v && i < j))
    };
    let n = sites.len();
    (0..n).filter(|&j| !(0..n).any(|i| beats(i, j))).collect()
}

/// All triples of the sites that count whose power circle is empty of the others.
fn naive_triangles(sites: &[Site]) -> Vec<[usize; 3]> {
    let strongest = strongest(sites);
    let site = |i: usize| weighted(sites[i]);
    let mut found = Vec::new();
    for &i in &strongest {
        for &j in strongest.iter().filter(|&&j| j > i) {
            for &k in strongest.iter().filter(|&&k| k > i && k != j) {
                let [a, b, c] = [site(i), site(j), site(k)];
                let is_empty = || {
                    let mut others = strongest.iter().filter(|l| ![i, j, k].contains(l));
                    !others.any(|&l| in_power_circle_perturbed(a, b, c, site(l)))
                };
                if orient2d(a.point, b.point, c.point) == Orientation::Left && is_empty() {
                    found.push(turned([i, j, k]));
                }
            }
        }
    }
    found.sort_unstable();
    found
}

/// The vertices of sites that count, if all lie on one line: no two of the others hide them.
fn naive_row(sites: &[Site]) -> Vec<usize> {
    let strongest = strongest(sites);
    let is_hidden_by = |i: usize, j: usize, v: usize| {
        let [a, b, p] = [i, j, v].map(|i| weighted(sites[i]));
        let (before, after) = (a.point.lex_cmp(&p.point), p.point.lex_cmp(&b.point));
        before.is_lt() && after.is_lt() && !in_power_segment_perturbed(a, b, p)
    };
    let is_vertex = |&v: &usize| {
        let mut pairs = strongest
            .iter()
            .flat_map(|&i| strongest.iter().map(move |&j| (i, j)));
        !pairs.any(|(i, j)| is_hidden_by(i, j, v))
    };
    strongest.iter().copied().filter(is_vertex).collect()
}

fn check(sites: &[Site], name: &str) {
    let t = built(sites);
    let expected = naive_triangles(sites);
    assert_eq!(triangles(&t), expected, "{name}: {sites:?}");
    let visible: Vec<usize> = if expected.is_empty() {
        naive_row(sites)
    } else {
        expected.as_flattened().to_vec()
    };
    let rest: Vec<usize> = (0..sites.len()).filter(|i| !visible.contains(i)).collect();
    assert_eq!(hidden(&t), rest, "{name}: {sites:?}");
    assert_eq!(t.triangulation().num_vertices(), sites.len() - rest.len());
}

#[test]
fn few_sites_of_every_kind() {
    everywhere(0..9, 60, check);
}

#[test]
fn more_sites_of_every_kind() {
    everywhere(10..26, 4, check);
}

/// All ways to put weights 0, 1 and 2 on a lattice of 3 × 2, and a few more with holes in it.
#[test]
fn all_small_weights_on_a_small_lattice() {
    let places = [(0, 0), (1, 0), (2, 0), (0, 1), (1, 1), (2, 1)];
    for code in 0..3_usize.pow(6) {
        let weight = |i: usize| (code / 3_usize.pow(i as u32) % 3) as f64;
        let sites: Vec<Site> = (0..6)
            .map(|i| {
                (
                    (f64::from(places[i].0), f64::from(places[i].1)).into(),
                    weight(i),
                )
            })
            .collect();
        check(&sites, "lattice");
        check(&sites[1..], "lattice without a corner");
        check(&sites[..4], "row and a point");
    }
}
