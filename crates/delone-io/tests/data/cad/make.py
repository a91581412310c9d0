"""Makes the drawings of this folder with ezdxf 1.4 (MIT); run in the folder."""
import ezdxf
from ezdxf.math import closed_uniform_bspline


def draw(doc):
    msp = doc.modelspace()
    for name in ["plate", "holes", "lines"]:
        doc.layers.add(name)
    msp.add_lwpolyline([(0, 0, 0, 0, 0), (10, 0, 0, 0, 0.5), (10, 6, 0, 0, 0), (0, 6, 0, 0, 0)],
                       close=True, dxfattribs={"layer": "plate"}) if doc.dxfversion > "AC1009" else \
        msp.add_polyline2d([(0, 0, 0), (10, 0, 0.5), (10, 6, 0), (0, 6, 0)], format="xyb", close=True,
                           dxfattribs={"layer": "plate"})
    msp.add_circle((3, 3), 1.25, dxfattribs={"layer": "holes"})
    block = doc.blocks.new("SLOT", base_point=(1, 0))
    block.add_arc((0, 0), 0.5, 90, 270)
    block.add_line((0, -0.5), (2, -0.5))
    block.add_arc((2, 0), 0.5, 270, 90)
    block.add_line((2, 0.5), (0, 0.5))
    msp.add_blockref("SLOT", (7, 3), dxfattribs={"layer": "holes", "rotation": 30, "xscale": 0.5, "yscale": 0.75})
    msp.add_text("a plate")
    msp.add_point((12, 7, 1.5), dxfattribs={"layer": "lines"})


def save(doc, name, **options):
    doc.saveas(name, **options)


r12 = ezdxf.new("R12")
draw(r12)
save(r12, "plate-r12.dxf")
r2010 = ezdxf.new("R2010")
draw(r2010)
save(r2010, "plate-binary.dxf", fmt="bin")

curves = ezdxf.new("R2000")
msp = curves.modelspace()
msp.add_ellipse((1, 2), (3, 1), 0.4)
msp.add_ellipse((8, 2), (2, 0), 0.5, 0.3, 4.0)
msp.add_spline_control_frame([(0, 6), (2, 9), (5, 5), (8, 9), (10, 6)], degree=3)
msp.add_rational_spline([(12, 0), (14, 0), (14, 3), (16, 3), (16, 0)], [1, 2, 0.5, 3, 1], degree=3)
closed = msp.add_spline()
closed.apply_construction_tool(closed_uniform_bspline([(12, 5), (15, 5), (15, 8), (12, 8)], order=4))
closed.closed = True
msp.add_circle((20, 4), 2, dxfattribs={"extrusion": (0, 0, -1)})
msp.add_arc((20, 4), 1, 10, 100, dxfattribs={"extrusion": (0, 0, -1)})
msp.add_circle((20, 10, 5), 2, dxfattribs={"extrusion": (0.3, 0.2, 0.9)})
msp.add_3dface([(22, 0, 1), (24, 0, 2), (24, 2, 3)])
msp.add_solid([(22, 4), (24, 4), (22, 6), (24, 6)])
save(curves, "curves.dxf")
