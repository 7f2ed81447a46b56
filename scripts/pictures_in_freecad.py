# SPDX-License-Identifier: LGPL-2.1-or-later
"""What scripts/pictures does inside FreeCAD: makes shapes with a hole, fills each through the Python package and
leaves a picture of every fill in $FAIRING_OUTPUT: the base in grey, a colour a patch, its isolines and borders; and some
of the panels at work."""

import math
import os
import sys

import FreeCAD as App
import FreeCADGui as Gui
import Part

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
OUTPUT = os.environ["FAIRING_OUTPUT"]
sys.path.insert(0, os.path.join(ROOT, "tests", "freecad"))

import gui  # noqa: E402

import fairing  # noqa: E402
from fairing.choices import ENERGIES  # noqa: E402

SIZE = 900, 600  # pixels
GREY = (0.84, 0.86, 0.89)
COLORS = ((0.36, 0.62, 0.84), (0.96, 0.72, 0.36), (0.51, 0.76, 0.52), (0.87, 0.49, 0.48), (0.66, 0.57, 0.82),
          (0.42, 0.76, 0.76), (0.93, 0.83, 0.42), (0.75, 0.60, 0.47))
ISOLINES = 7  # of a patch, in either direction


def wavy_sheet() -> Part.Face:
    """A sheet of 120 x 90 mm in waves of a few mm."""
    def height(x, y):
        return 9.0 * math.sin(x / 21.0 + 0.4) * math.cos(y / 26.0) + 0.002 * x * x

    grid = [[App.Vector(x, y, height(x, y)) for y in range(-45, 46, 6)] for x in range(-60, 61, 6)]
    surface = Part.BSplineSurface()
    surface.interpolate(grid)
    return surface.toShape()


def with_hole(wire: Part.Wire) -> tuple:
    """The sheet without what lies under a plane outline; the names of the edges round the hole."""
    prism = Part.Face(wire).extrude(App.Vector(0, 0, 200))
    prism.translate(App.Vector(0, 0, -100))
    shape = wavy_sheet().cut(prism)
    return shape, fairing.holes(shape)[0]


def polygon(*corners) -> Part.Wire:
    points = [App.Vector(x, y, 0) for x, y in corners]
    return Part.makePolygon(points + points[:1])


def l_shape() -> Part.Wire:
    return polygon((-34, -26), (34, -26), (34, 4), (2, 4), (2, 28), (-34, 28))


def pentagon() -> Part.Wire:
    return polygon(*((30 * math.cos(a), 30 * math.sin(a)) for a in (0.3 + k * 0.4 * math.pi for k in range(5))))


def quadrangle() -> Part.Wire:
    return polygon((-40, -28), (38, -32), (42, 26), (-36, 30))


def circle() -> Part.Wire:
    return Part.Wire(Part.makeCircle(28))


def rounded_corner() -> tuple:
    """A box with its three edges at one corner rounded, without the face where the fillets meet."""
    size = 40.0
    box = Part.makeBox(size, size, size)
    corner = App.Vector(size, size, size)
    edges = [edge for edge in box.Edges if any(vertex.Point.isEqual(corner, 1e-6) for vertex in edge.Vertexes)]
    solid = box.makeFillet(12.0, edges)
    middle = min(solid.Faces, key=lambda face: face.CenterOfMass.distanceToPoint(corner))
    shape = Part.makeShell([face for face in solid.Faces if not face.isSame(middle)])
    return shape, fairing.holes(shape)[0]


def rims(shape: Part.Shape, points: list) -> list:
    """The names of the edges nearest to points."""
    return [f"Edge{1 + min(range(len(shape.Edges)), key=lambda k: shape.Edges[k].distToShape(Part.Vertex(p))[0])}"
            for p in points]


def three_pipes() -> tuple:
    """Three pipes of different width whose axes meet; their inner rims."""
    walls, points = [], []
    for axis, radius in (((1, 0.1, 0.1), 15), ((-0.5, 0.85, -0.1), 13), ((-0.5, -0.85, 0.15), 11)):
        axis = App.Vector(*axis).normalize()
        circle = Part.makeCircle(radius, 42 * axis, axis)
        walls.append(circle.extrude(24 * axis))
        points.append(circle.valueAt(math.pi))
    shape = Part.makeCompound(walls)
    return shape, rims(shape, points)


def two_frames() -> tuple:
    """Two rectangular ducts of different size, one above the other and turned a little."""
    def duct(width, depth, z, turn):
        wire = Part.makePolygon([App.Vector(x * width, y * depth, 0) for x, y in
                                 ((1, 1), (-1, 1), (-1, -1), (1, -1), (1, 1))])
        walls = wire.extrude(App.Vector(0, 0, 18))
        walls.rotate(App.Vector(), App.Vector(0, 0, 1), turn)
        walls.translate(App.Vector(0, 0, z))
        return walls

    low, high = duct(26, 18, 0, 0), duct(14, 14, 56, 15)
    shape = Part.makeCompound([low, high])
    sides = [[f"Edge{k}" for k, edge in enumerate(shape.Edges, 1)
              if all(abs(vertex.Point.z - z) < 1e-6 for vertex in edge.Vertexes)] for z in (18, 56)]
    return shape, sides


def isolines(face: Part.Face) -> Part.Shape:
    """Lines of constant u and v of a patch, without its borders; of a trimmed face what lies on it."""
    surface = face.Surface
    u0, u1, v0, v1 = surface.bounds()
    shares = [(k + 1) / (ISOLINES + 1) for k in range(ISOLINES)]
    lines = [surface.uIso(u0 + s * (u1 - u0)).toShape() for s in shares]
    lines += [surface.vIso(v0 + s * (v1 - v0)).toShape() for s in shares]
    if len(face.Edges) != 4:
        lines = [face.common(line) for line in lines]
    return Part.makeCompound(lines)


def show(document, name: str, shape: Part.Shape, color: tuple, width: float):
    obj = document.addObject("Part::Feature", name)
    obj.Shape = shape
    view = obj.ViewObject
    view.Deviation, view.AngularDeflection = 0.02, 4.0
    view.ShapeColor, view.LineWidth, view.PointSize = color, width, 1.0
    view.LineColor = (0.13, 0.15, 0.18)
    return obj


def look(view, turn: float, tilt: float):
    """The camera turned about z and tilted from above, degrees."""
    view.setCameraOrientation(App.Rotation(App.Vector(0, 0, 1), turn).multiply(
        App.Rotation(App.Vector(1, 0, 0), tilt)))


def fill_picture(name: str, base: Part.Shape, edges: list, turn: float, tilt: float, margin=1.1, **options):
    """Fills a hole and shows it."""
    picture(name, base, *fairing.fill(base, edges=edges, **options), turn, tilt, margin)


def blend_picture(name: str, base: Part.Shape, edges: list, turn: float, tilt: float, margin=1.1, **options):
    """Blends from the first edge to the others and shows it."""
    picture(name, base, *fairing.blend(base, edges[:1], edges[1:], **options), turn, tilt, margin)


def picture(name: str, base: Part.Shape, filled: Part.Shape, report: dict, turn: float, tilt: float, margin: float):
    """Shows, saves; the camera is turned about z and tilted from above, degrees; margin is the height of the picture
    over that of the patches."""
    print(f"{name}: {report['layout']}, {len(filled.Faces)} patches, within tolerance: {report['within_tolerance']}")
    document = App.newDocument(name)
    show(document, "Base", base, GREY, 1.5)
    patches = []
    for k, face in enumerate(filled.Faces):
        patches.append(show(document, "Patch", face, COLORS[k % len(COLORS)], 2.5))
        show(document, "Isolines", isolines(face), GREY, 1.0)
    view = Gui.ActiveDocument.ActiveView
    view.setAnimationEnabled(False)
    view.setCameraType("Orthographic")
    look(view, turn, tilt)
    for patch in patches:
        Gui.Selection.addSelection(patch)
    Gui.SendMsgToActiveView("ViewSelection")
    Gui.Selection.clearSelection()
    height = view.getCameraNode().height
    height.setValue(margin * height.getValue())
    gui.pump(0.3)
    view.saveImage(os.path.join(OUTPUT, name + ".png"), *SIZE, "White")
    App.closeDocument(document.Name)


def pipe_with_wave() -> tuple:
    """A wide pipe with a wavy ring drawn on it, and a narrow tilted one above; the wide one's upper rim, the other's
    lower one, and the ring; and the ring a little wider, to be seen."""
    def height(angle):
        return 24.0 + 5.0 * math.sin(3.0 * angle + 0.9)

    wide, narrow = Part.makeCircle(24).extrude(App.Vector(0, 0, 42)), Part.makeCircle(13).extrude(App.Vector(0, 0, 22))
    narrow.Placement = App.Placement(App.Vector(6, 0, 66), App.Rotation(App.Vector(0, 1, 0), 14))
    angles = [2.0 * math.pi * k / 18 for k in range(18)]
    ring, above = Part.BSplineCurve(), Part.BSplineCurve()
    for curve, radius in ((ring, 24.0), (above, 24.3)):
        curve.interpolate([App.Vector(radius * math.cos(a), radius * math.sin(a), height(a)) for a in angles],
                          PeriodicFlag=True)
    shape = Part.makeCompound([wide, narrow, ring.toShape()])
    rim = narrow.Placement.multVec(App.Vector(-13, 0, 0))
    return shape, rims(shape, [App.Vector(-24, 0, 42), rim, App.Vector(-24, 0, height(math.pi))]), above.toShape()


def setback_picture(name: str):
    """A blend from a drawn curve: what is cut off shows through."""
    shape, (low, high, drawn), ring = pipe_with_wave()
    whole, report = fairing.blend(shape, [low], [high], from_curve=[drawn], to_setback=5.0, result="base")
    print(f"{name}: {len(whole.Faces)} faces, within tolerance: {report['within_tolerance']}")
    document = App.newDocument(name)
    for face in whole.Faces:
        is_blend = isinstance(face.Surface, Part.BSplineSurface)
        show(document, "Face", face, COLORS[0] if is_blend else GREY, 1.5)
        if is_blend:
            show(document, "Isolines", isolines(face), GREY, 1.0)
    for face in shape.Faces:  # a little wider, so that it stands clear of what is left
        wider = face.makeOffsetShape(-0.2, 1e-3)
        show(document, "Before", wider, GREY, 1.0).ViewObject.Transparency = 82
    show(document, "Drawn", ring, GREY, 5.0).ViewObject.LineColor = (0.80, 0.22, 0.18)
    view = Gui.ActiveDocument.ActiveView
    view.setAnimationEnabled(False)
    view.setCameraType("Orthographic")
    look(view, turn=20, tilt=70)
    Gui.SendMsgToActiveView("ViewFit")
    height = view.getCameraNode().height
    height.setValue(0.96 * height.getValue())
    gui.pump(0.3)
    view.saveImage(os.path.join(OUTPUT, name + ".png"), *SIZE, "White")
    App.closeDocument(document.Name)


def tilted_pipes(document) -> list:
    """Two pipes as objects of their own, the upper one wider, beside the other's axis and tilted; and their rims."""
    tilted = App.Placement(App.Vector(10, 4, 62), App.Rotation(App.Vector(0, 1, 0), 25))
    rims = []
    for name, radius, placement, height in (("Pipe", 15, App.Placement(), 30), ("Collar", 22, tilted, 0)):
        wall = Part.makeCircle(radius).extrude(App.Vector(0, 0, 30 if height else 20))
        obj = document.addObject("Part::Feature", name)
        obj.Shape, obj.Placement = wall, placement
        obj.ViewObject.ShapeColor, obj.ViewObject.Deviation = (0.62, 0.69, 0.77), 0.02
        rims.append((obj, next(f"Edge{number}" for number, edge in enumerate(wall.Edges, 1)
                               if edge.isClosed() and abs(edge.CenterOfMass.z - height) < 1e-6)))
    document.recompute()
    return rims


def light_background():
    view = App.ParamGet("User parameter:BaseApp/Preferences/View")
    for name, color in (("BackgroundColor2", 0xF4F6F9FF), ("BackgroundColor3", 0xB9C4D2FF)):
        view.SetUnsigned(name, color)


def fill_panel_on_sheet(name: str, outline: Part.Wire, **options):
    """The panel of Fill Hole on a hole in the wavy sheet."""
    document = App.newDocument(name)
    shape, edges = with_hole(outline)
    base = document.addObject("Part::Feature", "Sheet")
    base.Shape = shape
    base.ViewObject.ShapeColor, base.ViewObject.Deviation = (0.62, 0.69, 0.77), 0.02
    document.recompute()
    fill = fairing.make_fill(base, edges[:1], **options)
    look(gui.look_at_all(), turn=-25, tilt=48)
    Gui.SendMsgToActiveView("ViewFit")
    Gui.ActiveDocument.setEdit(fill.Name)
    gui.wait_for_verdict()
    return document


def curvature_zebra():
    """Stripes across a new surface and what it meets."""
    document = fill_panel_on_sheet("zebra", pentagon(), continuity="G2")
    gui.widget("labelsCheck").setChecked(False)
    gui.widget("pictureCombo").setCurrentIndex(6)
    gui.pump(1.0)  # the limits fold away slowly
    gui.picture("curvature_zebra")
    gui.press("Cancel")
    App.closeDocument(document.Name)


def compare_energies():
    """All energies in a table, one of them in the view in colours."""
    document = fill_panel_on_sheet("energies", pentagon())
    gui.widget("labelsCheck").setChecked(False)
    gui.widget("pictureCombo").setCurrentIndex(1)
    gui.widget("compareButton").click()
    gui.pump(0.1)
    gui.settle()
    gui.widget("compareTable").selectRow(4)
    gui.pump(1.0)
    gui.picture("compare_energies")
    gui.press("Cancel")
    App.closeDocument(document.Name)


def energy_pictures():
    """The mean curvature of one hole's fill with each energy, in the same colours: blue to red is -1/72 to 1/72 mm."""
    document = fill_panel_on_sheet("energy", quadrangle())
    height = Gui.ActiveDocument.ActiveView.getCameraNode().height
    height.setValue(0.75 * height.getValue())
    gui.widget("labelsCheck").setChecked(False)
    gui.widget("pictureCombo").setCurrentIndex(1)
    for name, value in (("pictureLow", -1 / 72), ("pictureHigh", 1 / 72)):
        gui.widget(name).setText(str(value))
        gui.widget(name).textEdited.emit(str(value))
    for position, energy in enumerate(ENERGIES):
        if energy == "mean-curvature-gradient-minimum":  # looks the same as with a few steps
            continue
        gui.widget("energyCombo").setCurrentIndex(position)
        gui.wait_for_verdict()
        gui.pump(0.3)
        path = os.path.join(OUTPUT, f"energy_{energy.replace('-', '_')}.png")
        Gui.ActiveDocument.ActiveView.saveImage(path, 600, 400, "Current")
    gui.press("Cancel")
    App.closeDocument(document.Name)


def blend_panel():
    """The panel of Blend Faces with a slider moved: what users see."""
    document = App.newDocument("pipes")
    rims = tilted_pipes(document)
    look(gui.look_at_all(), turn=228, tilt=75)
    Gui.SendMsgToActiveView("ViewFit")
    for obj, edge in rims:
        Gui.Selection.addSelection(document.Name, obj.Name, edge)
    Gui.runCommand("Fairing_BlendFaces")
    gui.wait_for_verdict()
    gui.widget("fromReachSpin").setValue(1.4)
    gui.wait_for_verdict()
    gui.picture("blend_panel")
    gui.press("Cancel")


def edit_panel():
    """The panel of Edit Surface with a handle that leans: what users see."""
    document = App.newDocument("edit")
    base = document.addObject("Part::Feature", "Sheet")
    base.Shape = wavy_sheet()
    base.ViewObject.ShapeColor, base.ViewObject.Deviation = (0.62, 0.69, 0.77), 0.02
    document.recompute()
    middle = base.Shape.Faces[0].valueAt(0.5, 0.5)
    handles = [{"point": tuple(middle + App.Vector(shift, 0, 0)), "normal": (lean, 0, 1), "radius": 22}
               for shift, lean in ((-22, -0.6), (22, 0.6))]
    edit = fairing.make_edit(base, "Face1", guides=handles, lambda_=2000)
    look(gui.look_at_all(), turn=-25, tilt=52)
    Gui.SendMsgToActiveView("ViewFit")
    Gui.ActiveDocument.setEdit(edit.Name)
    gui.settle()
    gui.widget("guideList").setCurrentRow(1)
    gui.picture("edit_panel")
    gui.press("Cancel")


def main():
    gui.start()
    fill_picture("star_fill", *rounded_corner(), turn=118, tilt=50, margin=1.4)
    fill_picture("star_fill_pentagon", *with_hole(pentagon()), turn=-25, tilt=48)
    fill_picture("star_fill_l", *with_hole(l_shape()), turn=-25, tilt=48, layout="star")
    fill_picture("o_grid_fill", *with_hole(circle()), turn=-25, tilt=48)
    blend_picture("junction", *three_pipes(), turn=25, tilt=40, margin=1.25)
    frames, (low, high) = two_frames()
    picture("strip_blend", frames, *fairing.blend(frames, low, high), turn=25, tilt=62, margin=1.3)
    setback_picture("strip_setback")
    light_background()
    blend_panel()
    edit_panel()
    curvature_zebra()
    compare_energies()
    energy_pictures()
    fill_picture("trimmed_fill", *with_hole(l_shape()), turn=-25, tilt=48, layout="trimmed")


main()
