//! What happens to what, format by format, in sentences.

use delone_io::Format;

/// Says what becomes of the parts of points, domains and meshes in a format.
pub(super) fn of(format: Format) -> &'static str {
    match format {
        Format::Node => {
            "Points numbered from 0 or 1, with attributes, whose names are lost, and markers. A mesh written to it is \
             the whole family: .node, .ele, .edge, .neigh, and .poly if something is constrained."
        }
        Format::Ele => {
            "Triangles over the points of the .node of the same stem; a .poly beside it without points of its own adds \
             constrained edges, holes and regions. The region of a triangle is its attribute."
        }
        Format::Edge => {
            "Every edge with its marker: 1 on the border unless it has one of its own. Written with its family."
        }
        Format::Neigh => "For each triangle the three next to it. Written with its family.",
        Format::Poly => {
            "Points, segments with markers, holes and regions with attribute and largest area: all of a domain but \
             which segments make a polygon. What is outside, and in holes, is carved away."
        }
        Format::Npy => {
            "Points are an array (n, 2 or more) of floats, further columns attributes without names, markers the last; \
             a mesh is an array (m, 3) of integers with the points beside it in .points.npy and the constrained edges, \
             ends and marker, in .segments.npy."
        }
        Format::Table => {
            "Columns x and y by name or place; every further column of numbers is an attribute, columns of text are \
             left out and named; markers are written as a column `marker`. .xyz, .txt and their like have blanks \
             between columns, .tsv tabs, .csv commas; read is any."
        }
        Format::Parquet => {
            "Columns of numbers are attributes; GeoParquet brings points, lines and polygons. A mesh is a table of \
             triangles, with its points beside it in .points.parquet and its constrained edges in .segments.parquet."
        }
        Format::GeoJson => {
            "Polygons with holes, lines and points with z; the property `marker` is that of segments. A mesh is written \
             as polygons with region and attributes, and its constrained edges as lines. Holes and regions that are \
             named by points are refused."
        }
        Format::Wkt => {
            "Points, lines and polygons with holes, one geometry a line or a collection; read only."
        }
        Format::Shp => {
            "Points, lines or polygons with holes; numbers of the table beside it are attributes; read only."
        }
        Format::Las => {
            "Points with z, intensity, class and return; --class and --return take some of them. LAZ is the same, \
             compressed; read only."
        }
        Format::Vtu => {
            "Points with attributes and markers, triangles, also of six nodes, with attributes and `region` (−1 where \
             there is none), constrained edges as lines with `marker`. A mesh of z 0, z itself is an attribute."
        }
        Format::Vtk => {
            "The legacy form of .vtu, with the same contents, in bytes or, with --ascii, as text; unstructured grids \
             and polygonal data are read."
        }
        Format::Msh => {
            "Physical curves are markers of constrained edges, physical surfaces the regions of triangles; data of \
             nodes and elements are attributes. Of an element in several groups the first counts, and that is said. \
             Written is version 4.1, read are 4.1 and 2.2, text and binary."
        }
        Format::Msh2 => "As .msh, written in version 2.2 for programs that read no other.",
        Format::Jigsaw => {
            "Points, edges with tags, which are markers, and triangles of the plane; read only."
        }
        Format::Airfoil => {
            "The outline of an airfoil, in the order of Selig or of Lednicer, as one ring; read only. A .dat is taken \
             for one if a line of text comes before its two columns."
        }
        Format::Medit => {
            "Markers of points and constrained edges are references; so are regions of triangles, counted from 1, for 0 is \
             none. Read, references of triangles are the attribute `ref`. Other attributes, z among them, have no place."
        }
        Format::Obj => {
            "Names of groups, objects and materials are numbered as they appear: they are the regions of triangles and \
             the markers of lines; `region_2` and `marker_7`, as written, keep their numbers. Colours behind \
             coordinates are attributes, texture coordinates and normals are passed over. Faces have three corners, \
             but a single polygon is taken as an outline."
        }
        Format::Off => {
            "Triangles over points with z; normals, colours and texture coordinates of points are attributes when \
             read, colours of faces are passed over. Nothing else has a place."
        }
        Format::Ply => {
            "Every number of a vertex or a face is an attribute, colours too; integers named `marker` are markers, \
             of vertices and of edges. Text and bytes of either order are read; written are bytes, or text with \
             --ascii. Lists other than corners are passed over."
        }
        Format::Stl => {
            "Triangles with z, or 0, in floats of 32 bits, in bytes or as text with --ascii; written only."
        }
        Format::Dxf => {
            "Layers are markers of segments in order of appearance (`SEGMENTS_7`, as written, keeps its number); curves become lines as --flatness says, --layer \
             takes some of them. A mesh is written as faces and lines, on a layer for each region and marker."
        }
        Format::Tikz => {
            "A picture for LaTeX: segments and triangles, rounded to what is seen; written only."
        }
        Format::Svg => {
            "Read are paths and shapes, closed ones as rings, curves as --flatness says; written is a picture, coloured \
             by angles, whose data cannot be had back."
        }
        Format::Png => "A picture of pixels; written only.",
        Format::Gif => "A moving picture of a run of an algorithm; written only.",
        Format::Html => "A page about a mesh with figures and pictures; written only.",
        _ => "Nothing is known about it.",
    }
}
