//! VTK, legacy and in XML: what stands among the data, and data that are packed.

use super::{fixture, mesh_of};
use delone_io::{ReadOptions, Source, read_mesh};

/// A triangle by hand.
pub const VTK: &str = "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 double\n\
0 0 0\n1 0 0\n0 1 0\nCELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n";

#[test]
fn tensors_of_vtk_have_all_their_components() {
    let rows = |row: &str| [row; 3].join("\n");
    let tensors = rows("1 2 3 4 5 6 7 8 9");
    let symmetric = rows("1 2 3 4 5 6");
    let data = format!(
        "POINT_DATA 3\nTENSORS t double\n{tensors}\nTENSORS6 s double\n{symmetric}\nNORMALS n double\n{}\n\
         FIELD f 1\nid%20of 1 3 int\n7 8 9\n",
        rows("0 0 1")
    );
    let mesh = mesh_of("a.vtk", &format!("{VTK}{data}")).expect("a mesh");
    let names: Vec<_> = mesh
        .vertices
        .attributes
        .iter()
        .map(|a| &a.name[..])
        .collect();
    assert_eq!(names.len(), 9 + 6 + 3 + 1);
    assert_eq!((names[8], names[9], names[18]), ("t_8", "s_0", "id of"));
    assert_eq!(mesh.vertices.attributes[8].values, [9.0; 3]);
    assert_eq!(mesh.vertices.attributes[18].values, [7.0, 8.0, 9.0]);
    let whole = VTK.replace(
        "DATASET",
        "FIELD FieldData 1\ntime 1 1 double\n0.5\nDATASET",
    );
    let notes = mesh_of("a.vtk", &whole).expect("a mesh").vertices.notes;
    assert_eq!(notes, ["data of the whole file are not kept: \"time\""]);
}

#[test]
fn what_cells_say_about_lines_is_noted_if_it_is_something() {
    let both = VTK.replace(
        "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n",
        "CELLS 2 7\n2 0 1\n3 0 1 2\nCELL_TYPES 2\n3\n5\nCELL_DATA 2\nSCALARS heat double\n",
    );
    for (value, is_noted) in [("0", false), ("-1", false), ("nan", false), ("0.5", true)] {
        let mesh = mesh_of("a.vtk", &format!("{both}{value}\n7\n")).expect("a mesh");
        let note = "what \"heat\" says about lines is not kept";
        assert_eq!(
            mesh.vertices.notes.iter().any(|n| n == note),
            is_noted,
            "{value}"
        );
        assert_eq!(mesh.triangle_attributes[0].values, [7.0]);
        assert_eq!(mesh.constraints.expect("a line").markers, None);
    }
}

#[test]
fn strings_among_bytes_of_vtk_are_passed_over() {
    let mut file =
        b"# vtk DataFile Version 3.0\ntitle\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 float\n"
            .to_vec();
    let points = [0f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    file.extend(points.iter().flat_map(|v| v.to_be_bytes()));
    file.extend(b"\nPOINT_DATA 3\nFIELD FieldData 2\nnames 1 3 string\n");
    // The first two bits tell how many bytes the length takes.
    file.extend(b"\xc2ab");
    file.extend([&[0x80, 70][..], &[b'x'; 70]].concat());
    file.extend(b"\x40\0\0\x01c");
    file.extend(b"\nid 1 3 int\n");
    file.extend([7i32, -8, 70_000].iter().flat_map(|v| v.to_be_bytes()));
    let (name, bytes) = ("a.vtk".to_owned(), file);
    let mesh = read_mesh(
        &Source::Memory { name, bytes },
        &ReadOptions::default(),
        &(),
    );
    let vertices = mesh.expect("points").vertices;
    assert_eq!(vertices.attributes[0].values, [7.0, -8.0, 70_000.0]);
    assert_eq!(vertices.notes, ["strings are not kept: \"names\""]);
}

#[test]
fn bombs_are_not_unpacked() {
    // A declared size far beyond what so few bytes may be unpacked to.
    let path = fixture("vtk-raw-zlib-32be.vtu");
    let bytes = std::fs::read(&path).expect("file");
    let element = bytes
        .windows(13)
        .position(|w| w == b"<AppendedData")
        .expect("appended data");
    let underscore = bytes[element..]
        .iter()
        .position(|&b| b == b'_')
        .expect("data");
    let start = element + underscore + 1;
    let mut huge = bytes.clone();
    huge[start + 4..start + 8].copy_from_slice(&[0x7f; 4]);
    huge[start..start + 4].copy_from_slice(&[0, 0, 0, 2]);
    let source = Source::Memory {
        name: "a.vtu".to_owned(),
        bytes: huge,
    };
    let error = read_mesh(&source, &ReadOptions::default(), &())
        .expect_err("too much")
        .to_string();
    assert!(
        error.contains("too many for a file of this size; write without compression"),
        "{error}"
    );
}

#[test]
fn arrays_that_share_their_bytes_are_few() {
    let array = |name| {
        format!("<DataArray type=\"UInt8\" Name=\"{name}\" format=\"appended\" offset=\"0\"/>")
    };
    let read = |arrays: usize| {
        let arrays: String = (0..arrays).map(array).collect();
        let head = format!(
            "<VTKFile type=\"UnstructuredGrid\" header_type=\"UInt64\"><Piece NumberOfPoints=\"9999\"><PointData>\
             {arrays}</PointData></Piece><AppendedData encoding=\"raw\">_"
        );
        let count = 9999u64.to_le_bytes();
        let bytes = [
            head.as_bytes(),
            &count,
            &[7; 9999],
            b"</AppendedData></VTKFile>",
        ];
        let (name, bytes) = ("a.vtu".to_owned(), bytes.concat());
        read_mesh(
            &Source::Memory { name, bytes },
            &ReadOptions::default(),
            &(),
        )
        .expect_err("no points")
        .to_string()
    };
    assert!(
        read(2).contains("the piece declares 9999 points"),
        "{}",
        read(2)
    );
    let error = read(3);
    assert!(
        error.contains("array \"2\": shares its bytes with too many others"),
        "{error}"
    );
}
