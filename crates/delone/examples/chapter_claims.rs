//! Measures what the chapter claims of optimisation, of Algorithm B and of inner points, on many sets of random data, and
//! prints tables in Markdown. Takes the number of sets; the default is 400.

use delone_testkit::claims::{Comparison, compare, share_that_b_finishes};
use delone_testkit::fuzz::cover::Covering;

/// Numbers of data, and d.
const SIZES: [(usize, usize); 4] = [(150, 3), (150, 6), (300, 6), (300, 10)];

fn main() {
    let sets = std::env::args().nth(1);
    let sets = sets.map_or(400, |n| n.parse().expect("a number of sets"));
    let chapter = Covering::default();
    let a = Covering {
        divides_edges: false,
        divides_triangles: false,
        ..chapter.clone()
    };
    let a_and_b = Covering {
        divides_triangles: false,
        ..chapter.clone()
    };
    let not_optimized = Covering {
        optimizes: false,
        ..chapter.clone()
    };
    let without_b = Covering {
        divides_edges: false,
        ..chapter.clone()
    };
    let no_inner = |way: &Covering| Covering {
        inner_points: false,
        ..way.clone()
    };
    println!("{sets} sets of even random data each.\n");
    println!(
        "| example | ways compared | data | d | smallest angle | first better | second better | triangles | reductions |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    let rows = [
        ("3.51", "optimised / not", &chapter, &not_optimized),
        ("3.52", "A, B, C / A, C", &chapter, &without_b),
        ("3.53", "A: inner points / none", &a, &no_inner(&a)),
        (
            "3.53",
            "A, B: inner points / none",
            &a_and_b,
            &no_inner(&a_and_b),
        ),
        (
            "3.53",
            "A, B, C: inner points / none",
            &chapter,
            &no_inner(&chapter),
        ),
    ];
    for (example, ways, first, second) in rows {
        for (n, least) in SIZES {
            print_row(
                example,
                ways,
                (n, least),
                compare(sets, n, least, [first, second]),
            );
        }
    }
    println!("\n| data | d | B leaves no triangle 3d data or more |\n|---|---|---|");
    for (n, least) in SIZES {
        let share = 100.0 * share_that_b_finishes(sets, n, least);
        println!("| {n} | {least} | {share:.1} % of the sets |");
    }
}

fn print_row(example: &str, ways: &str, (n, least): (usize, usize), found: Comparison) {
    let Comparison {
        min_angle: a,
        better: b,
        triangles: t,
        reductions: r,
        ..
    } = found;
    println!(
        "| {example} | {ways} | {n} | {least} | {:.2}° / {:.2}° | {:.0} % | {:.0} % | {:.1} / {:.1} | {:.2} / {:.2} |",
        a[0],
        a[1],
        100.0 * b[0],
        100.0 * b[1],
        t[0],
        t[1],
        r[0],
        r[1]
    );
}
