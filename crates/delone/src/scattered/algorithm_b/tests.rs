use super::super::cover::Cover;
use super::super::data::Data;
use super::*;

/// A field of these triangles.
fn with_field<R>(
    data: &[(f64, f64)],
    points: &[(f64, f64)],
    triangles: &[[usize; 3]],
    act: impl FnOnce(&mut Field<()>) -> R,
) -> R {
    let data = Data::new(data.iter().copied()).unwrap();
    let mut nobody = ();
    let mut field = Field::new(&data, 1, &(), &mut nobody);
    let triangles: Vec<_> = triangles.iter().map(|t| t.map(VertexId::new)).collect();
    let points = points.iter().map(|&p| p.into()).collect();
    field.lay_out(points, &triangles).unwrap();
    act(&mut field)
}

fn edge(field: &Field<()>, a: usize, b: usize) -> HalfEdgeId {
    let [a, b] = [a, b].map(VertexId::new);
    let mut edges = field.draft.mesh.half_edges();
    edges
        .find(|&h| field.draft.mesh.origin(h) == a && field.draft.mesh.dest(h) == b)
        .unwrap()
}

const SQUARE: [(f64, f64); 4] = [(0.0, 0.0), (8.0, 0.0), (8.0, 8.0), (0.0, 8.0)];
const HALVES: [[usize; 3]; 2] = [[0, 1, 2], [0, 2, 3]];

#[test]
fn lines_are_those_of_the_pseudocode() {
    let beginnings = [
        (line::BEGIN, "T := all"),
        (line::NEXT, "while there is"),
        (line::EDGE, "for each edge"),
        (line::FAIL, "if there is none: j"),
        (line::DIVIDE, "else: put a vertex"),
        (line::OLD_EDGE, "if t lies inside"),
        (line::OPTIMIZE, "swap edges opposite"),
        (line::TRY, "if all triangles hold d"),
    ];
    for (line, beginning) in beginnings {
        let text = CODE_B[usize::from(line) - 1].trim_start();
        assert!(text.starts_with(beginning), "{line}: {text}");
    }
}

#[test]
fn an_edge_full_of_data_is_divided_though_nothing_else_is_there() {
    let data: Vec<_> = (0..12).map(|i| (f64::from(i) * 0.7, 0.0)).collect();
    let options = Cover::new(6);
    with_field(&data, &SQUARE[..3], &HALVES[..1], |field| {
        let [outer, other] = [edge(field, 0, 1), edge(field, 1, 2)];
        assert!(!divide_at(field, other, &options).unwrap());
        assert!(divide_at(field, outer, &options).unwrap());
        let held: Vec<_> = field
            .draft
            .mesh
            .triangles()
            .map(|t| field.stock.count(t))
            .collect();
        assert_eq!(held, [6, 6]);
        assert!(!divide_at(field, edge(field, 0, 3), &options).unwrap());
    });
}

#[test]
fn an_inner_edge_is_divided_only_if_all_four_get_enough() {
    let on = |n: i32| (0..n).map(move |i| (0.3 + 0.4 * f64::from(i), 0.3 + 0.4 * f64::from(i)));
    for (n, is_divided) in [(15, false), (16, true)] {
        let data: Vec<_> = on(n).collect();
        with_field(&data, &SQUARE, &HALVES, |field| {
            let h = edge(field, 0, 2);
            assert_eq!(divide_at(field, h, &Cover::new(4)).unwrap(), is_divided);
            let triangles = field.draft.mesh.triangles();
            let counts: Vec<_> = triangles.map(|t| field.stock.count(t)).collect();
            assert_eq!(counts.iter().sum::<usize>(), n as usize);
            assert!(!is_divided || counts == [4; 4]);
        });
    }
}

#[test]
fn the_outline_stays_locked() {
    let data: Vec<_> = (0..400)
        .map(|i| (0.2 + f64::from(i % 20) * 0.4, 0.2 + f64::from(i / 20) * 0.4))
        .collect();
    with_field(&data, &SQUARE, &HALVES, |field| {
        run(field, &Cover::new(10)).unwrap();
        field.draft.mesh.validate().unwrap();
        assert!(field.draft.points.len() > 10);
        for h in field.draft.mesh.half_edges() {
            let is_ghostly =
                field.draft.mesh.origin(h).is_infinite() || field.draft.mesh.dest(h).is_infinite();
            let [t, u] = [h, field.draft.mesh.twin(h)].map(HalfEdgeId::triangle);
            let is_outer = field.draft.mesh.is_ghost(t) != field.draft.mesh.is_ghost(u);
            assert_eq!(field.draft.marks.is_constrained(h), is_outer && !is_ghostly);
        }
    });
}

#[test]
fn the_longest_edge_comes_first() {
    let points = [(0.0, 0.0), (3.0, 0.0), (0.0, 4.0)];
    with_field(&[(1.0, 1.0)], &points, &[[0, 1, 2]], |field| {
        let t = field.draft.mesh.triangles().next().unwrap();
        let lengths = longest_first(field, t).map(|h| {
            let [a, b, _] = field.edge(h);
            (b.x - a.x).hypot(b.y - a.y)
        });
        assert_eq!(lengths, [5.0, 4.0, 3.0]);
    });
}
