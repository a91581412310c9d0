//! What the help says about the switches.

/// Each switch, and what becomes of it.
pub const SWITCHES: &str = "\
Input:
  -p      read FILE.poly: segments, holes, regions; keep what the segments enclose
  -r      refine the mesh in FILE.node and FILE.ele: its vertices stay, its border is kept, and with
          -p the segments in FILE.poly; its triangles are made anew, with the attributes of the old
  -c      keep all of the convex hull, and write its edges to the .poly file (with -r: the border)
  -O      ignore the holes of the .poly file
  .node, .poly, .ele or .area may end the name of FILE; .poly means -p, .ele -r, .area -ra
Refinement:
  -q      no angle below 20 degrees; -q30.5: below 30.5; less than 60
  -a0.1   no triangle larger than 0.1; -a without number: what the regions of the .poly file allow, or
          with -r the .area file; both may be given
  -D      every triangle Delaunay, segments or not
  -Y      no new vertices on the border; -YY: on no segment
  -S100   at most 100 new vertices, those at crossings not counted; -S: none
Output, as FILE.1.* (FILE.2.* of FILE.1.*):
  -e -n   also write .edge, .neigh
  -g      also write .off, for Geomview; not with -o2
  -v      also write the Voronoi diagram, .v.node and .v.edge: vertex and edge numbers are those of
          .ele and .edge; a true one if the triangles are Delaunay (-D, or no segments)
  -A      a number for each triangle: the attribute of its region
  -o2     six nodes a triangle: the midpoints of its edges too
  -j      leave out vertices that no triangle has
  -B      write no markers
  -P -N -E  write no .poly, .node, .ele
  -I      write FILE.* instead, but no .poly, and .node only if the points came from the .poly file
  -Q      say nothing but errors (Delone's own -q would stand before `triangle`)
Accepted, but nothing to choose here:
  -i -F -l -s -C -X  the algorithm is always the same and always exact (`delone check` proves a mesh);
          segments are never split to be inserted
  -L      means -D, as in older versions
  -V      the summary is always the same
  -z      numbers begin as in the input, as in Triangle
Refused:
  -u      no test of one's own: `delone mesh --sizing` takes a formula or a file of sizes
  -w      no weights: `delone voronoi FILE --weights COLUMN` makes power cells

Examples:
  delone triangle -pq30a0.1D file.poly     file.1.node, file.1.ele, file.1.poly
  delone triangle -rpaq file.1             file.1.area says how large triangles may be; file.2.*
  delone triangle -pqen -o2 -Q file        bundled or not";
