# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of curvature in the real window: of any faces by the command, of a surface and its neighbours in the
panels."""

import FreeCAD as App
import FreeCADGui as Gui
import Part
from pivy import coin

import gui
from seen import lines_run
import support

RADIUS, SIZE = 12.0, 60.0


def nodes(kind):
    """The nodes of a kind that are drawn in the view now."""
    search = coin.SoSearchAction()
    search.setType(kind.getClassTypeId())
    search.setInterest(coin.SoSearchAction.ALL)
    search.setSearchingAll(False)  # what a switch hides is not there
    search.apply(Gui.ActiveDocument.ActiveView.getSceneGraph())
    paths = search.getPaths()
    return [paths[k].getTail() for k in range(paths.getLength())]


def view_children():
    return Gui.ActiveDocument.ActiveView.getSceneGraph().getNumChildren()


def pictures():
    return len(nodes(coin.SoTexture2))


def places():
    """Where the vertices of the first mesh look their colour up, along the scale."""
    field = nodes(coin.SoTextureCoordinate2)[0].point
    return [field[k][0] for k in range(field.getNum())]


def choose(word):
    from fairing.pictures import PICTURES

    gui.widget("pictureCombo").setCurrentIndex(PICTURES.index(word))
    gui.settle()


def point_at(view, point):
    """Rests the real mouse on a point of the model; what the panel says of the place under it."""
    gui.hover(view, point)
    gui.pump(0.3)
    return gui.widget("placeLabel").text()


gui.start()
panels = gui.keep_panels()
document = App.newDocument("Drilled")
block = Part.makeBox(SIZE, SIZE, 30).cut(Part.makeCylinder(RADIUS, 40, App.Vector(30, 30, -5)))
pipe = Part.makeCylinder(RADIUS, SIZE, App.Vector(90, 30, 0))
gui.part(document, "Block", block)
pipe = gui.part(document, "Pipe", pipe)
document.recompute()
view = gui.look_at_all()

# The command on one face of a cylinder: |H| = 1 / (2 r) wherever the mouse points.
assert gui.action_is_enabled("Fairing_CurvaturePicture")
gui.select(document, (pipe, "Edge1"))
assert not gui.action_is_enabled("Fairing_CurvaturePicture"), "an edge has no curvature to show"
wall = support.face_where(pipe, lambda face: isinstance(face.Surface, Part.Cylinder))
gui.select(document, (pipe, wall))
Gui.runCommand("Fairing_CurvaturePicture")
gui.settle()
assert pictures() == 1 and gui.widget("pictureCombo").currentText() == "Mean curvature H"
assert gui.widget("facesLabel").text() == f"Pipe: {wall}"
seen = App.Vector(90, 30, 35) + RADIUS * App.Vector(1, -1, 0).normalize()
text = point_at(view, seen)
assert f"H\u00a0{-0.5 / RADIUS:.4g}" in text and f"\u03ba\u2082\u00a0{-1.0 / RADIUS:.4g}" in text, text
assert "K\u00a00" in text or "K\u00a0-0" in text, text
low, high = (float(gui.widget(name).text()) for name in ("pictureLow", "pictureHigh"))
assert abs(high - 0.5 / RADIUS) < 1e-4 and low == -high, (low, high)
assert max(places()) < 0.01, "H is the lower end of its range everywhere"
red, green, blue = gui.color_at(view, seen)
assert blue > 1.3 * red, (red, green, blue)
gui.picture("41_curvature_of_a_face")

# Another range by hand, then the picture's own again.
gui.widget("pictureLow").setText("-1")
gui.widget("pictureLow").textEdited.emit("-1")
gui.settle()
assert not gui.widget("pictureAutoCheck").isChecked()
expected = (-0.5 / RADIUS + 1.0) / (high + 1.0)
assert abs(places()[0] - expected) < 0.01, places()[0]
gui.widget("pictureAutoCheck").setChecked(True)
gui.settle()
assert max(places()) < 0.01 and float(gui.widget("pictureLow").text()) == low

# Selected while the panel is open: the whole block, inside and outside. Its hole bends the other way.
gui.select(document, ("Block", ""))
gui.settle()
gui.wait_for(lambda: gui.widget("facesLabel").text() == "Block", "the block's picture")
choose("k1")
assert float(gui.widget("pictureHigh").text()) == float(f"{1.0 / RADIUS:.4g}")
gui.picture("42_curvature_of_a_block")
choose("zebra")
assert pictures() == 1 and max(places()) - min(places()) > 10.0, "stripes go round"
before = places()
view.viewFront()
gui.pump(0.3)
assert max(abs(a - b) for a, b in zip(before, places())) > 1.0, "stripes follow the camera"
view.viewIsometric()
gui.pump(0.3)
assert max(abs(a - b) for a, b in zip(before, places())) < 1e-3
assert gui.widget("stripesSpin").isVisible() and not gui.widget("scaleLabel").isVisible()
gui.picture("43_zebra_of_a_block")
view.setCameraType("Perspective")
point_at(view, App.Vector(0, 0, 30))
near = places()
assert max(abs(a - b) for a, b in zip(before, near)) > 0.05, "seen from near by a plane has stripes, too"
view.viewFront()
gui.pump(0.3)
assert max(abs(a - b) for a, b in zip(near, places())) > 1.0, "stripes follow the other camera"
view.setCameraType("Orthographic")
view.viewIsometric()
gui.press("Close")
assert not gui.panel_is_open() and pictures() == 0
App.closeDocument(document.Name)

# Fill Hole: the picture takes the preview's place, on the patch and on what it meets.
document, base, edges = support.example()
view = gui.look_at_all()
gui.select(document, (base, edges[0]))
Gui.runCommand("Fairing_FillHole")
gui.wait_for_verdict("Meets all 4 edges")
assert pictures() == 0
choose("mean")
centre = App.Vector(*[sum(base.Shape.getElement(edge).CenterOfMass[k] for edge in edges) / 4 for k in range(3)])
assert pictures() == 1 and len(nodes(coin.SoTextureCoordinate2)) == 2
gui.picture("44_fill_mean_curvature")
text = point_at(view, centre)
first = text.splitlines()[0]
assert first.startswith("(") and first.endswith("mm"), text
choose("zebra")
assert len(nodes(coin.SoTextureCoordinate2)) == 2
gui.picture("45_fill_zebra")
stripes = {gui.color_at(view, centre + App.Vector(x, 0, 0))[0] > 110 for x in range(-15, 16)}
assert stripes == {True, False}, "dark and light stripes"
gui.widget("stripesSpin").setValue(60)
gui.settle()
gui.picture("46_fill_more_stripes")
gui.widget("allG2Button").click()
gui.wait_for_verdict("Meets all 4 edges")
assert len(nodes(coin.SoTextureCoordinate2)) == 2
choose("none")
assert pictures() == 0 and gui.widget("pictureCombo").isVisible() and not gui.widget("pictureRows").isVisible()
choose("mean-gradient")
assert float(gui.widget("pictureLow").text()) == 0.0
gui.picture("47_fill_gradient")
gui.ok()
assert pictures() == 0 and document.Fill.isValid()
App.closeDocument(document.Name)

# In a container that is moved the picture lies where the surface does, and so do the places it tells.
document, base, edges = support.example("Moved")
container = document.addObject("App::Part", "Part")
container.addObject(base)
container.Placement = App.Placement(App.Vector(40, -25, 10), App.Rotation(App.Vector(0, 1, 1), 30))
document.recompute()
view = gui.look_at_all()
gui.select(document, (base, edges[0]))
Gui.runCommand("Fairing_FillHole")
gui.wait_for_verdict("Meets all 4 edges")
gui.widget("labelsCheck").setChecked(False)
choose("gauss")
inside = panels[-1]._drawn
middle = App.Vector(*inside.mesh(2)[0][4].tolist())  # of a grid of 3 x 3 points
text = point_at(view, container.Placement.multVec(middle))
told = App.Vector(*map(float, text.splitlines()[0][1:].split(")")[0].split(",")))
assert told.distanceToPoint(container.Placement.multVec(middle)) < 2.0, (text, middle)
picture = inside.curvature_picture(2)
expected = picture.values()[4, 1]
assert abs(float(text.split("K\u00a0")[1].split(",")[0]) - expected) < 0.1 * abs(expected), (text, expected)
choose("zebra")
gui.picture("49_moved_zebra")
gui.press("Cancel")
App.closeDocument(document.Name)

# Blend Faces and Edit Surface have the same switch.
document = App.newDocument("Others")
low = gui.part(document, "Low", Part.makeCircle(10).extrude(App.Vector(0, 0, 20)))
high = gui.part(document, "High", Part.makeCircle(10, App.Vector(0, 0, 45)).extrude(App.Vector(0, 0, 20)))
box = gui.part(document, "Box", Part.makeBox(30, 30, 30, App.Vector(30, 0, 0)))
document.recompute()
view = gui.look_at_all()
gui.select(document, (low, gui.edge_at(low.Shape, (0, 0, 20))), (high, gui.edge_at(high.Shape, (0, 0, 45))))
Gui.runCommand("Fairing_BlendFaces")
gui.wait_for_verdict()
choose("mean")
assert len(nodes(coin.SoTextureCoordinate2)) == 2, "the strip, and both pipes beside it"
text = point_at(view, App.Vector(0, 0, 32.5) + 10 * App.Vector(1, -1, 0).normalize())
curvature = float(text.split("H\u00a0")[1].split(",")[0])
assert abs(abs(curvature) - 0.05) < 1e-3, f"the cylinder goes on: {text}"
gui.widget("fromReachSpin").setValue(1.5)  # live
gui.settle()
assert pictures() == 1
gui.picture("48_blend_mean_curvature")
gui.press("Cancel")
assert pictures() == 0
top = support.face_where(box, lambda face: face.CenterOfMass.z == 30.0)
gui.select(document, (box, top))
Gui.runCommand("Fairing_EditSurface")
gui.settle()
choose("zebra")
assert pictures() == 0, "a plane has nothing to move, so there is no new face"
gui.widget("spansSpin").setValue(6)
gui.widget("degreeSpin").setValue(3)
gui.wait_for_verdict("25 of 81")
assert len(nodes(coin.SoTextureCoordinate2)) == 2 and gui.widget("stripesSpin").isVisible()
gui.press("Cancel")
App.closeDocument(document.Name)

# From a script: any picture at once. A macro recorder sees the same line.
document = App.newDocument("Script")
ball = gui.part(document, "Ball", Part.makeSphere(10))
document.recompute()
gui.look_at_all()
import fairing  # noqa: E402

assert fairing.show_curvature([ball], "zebra")
gui.settle()
assert gui.widget("pictureCombo").currentText() == "Zebra" and pictures() == 1
gui.press("Close")
gui.select(document, (ball, "Face1"))
lines = lines_run(lambda: Gui.runCommand("Fairing_CurvaturePicture"))
gui.settle()
assert lines == ["fairing.show_curvature([(FreeCAD.ActiveDocument.getObject('Ball'), ['Face1'])])"], lines
assert gui.widget("facesLabel").text() == "Ball: Face1"
gui.press("Close")
support.refused(lambda: fairing.show_curvature([ball], "warmth"))
assert not gui.panel_is_open() and pictures() == 0

# While another panel is open there is none: a sentence says so, and nothing of it stays.
gui.select(document, (ball, "Face1"))
Gui.runCommand("Fairing_FillHole")
gui.settle()
children = view_children()
refused = gui.answer_message(lambda: fairing.show_curvature([ball]))
assert refused == (False, "Another task panel is open: close it first."), refused
gui.settle()
assert pictures() == 0 and view_children() == children
gui.press("Cancel")

# Closed by somebody else it takes its picture and its ears along.
before = view_children()
assert fairing.show_curvature([ball])
gui.settle()
assert pictures() == 1 and view_children() > before
Gui.Control.closeDialog()
gui.pump(0.1)
assert pictures() == 0 and view_children() == before
gui.select(document, (ball, "Face1"))
gui.settle()
assert pictures() == 0 and not gui.panel_is_open()
App.closeDocument(document.Name)

# With nothing selected all that is to be seen: of a body the body alone, not its tip, too.
document = App.newDocument("Body")
body = document.addObject("PartDesign::Body", "Body")
pad = body.newObject("PartDesign::AdditiveBox", "Pad")
gui.part(document, "Ball", Part.makeSphere(4, App.Vector(30, 0, 0)))
gui.part(document, "Hidden", Part.makeSphere(4, App.Vector(60, 0, 0))).ViewObject.Visibility = False
document.recompute()
gui.look_at_all()
assert body.Tip == pad and pad.ViewObject.Visibility
Gui.Selection.clearSelection()
Gui.runCommand("Fairing_CurvaturePicture")
gui.settle()
assert gui.widget("facesLabel").text() == "Body, Ball", gui.widget("facesLabel").text()
assert len(nodes(coin.SoTextureCoordinate2)) == 2
gui.press("Close")
App.closeDocument(document.Name)

# A document closed under the panel takes the picture with it.
document, base, edges = support.example("Closing")
gui.look_at_all()
Gui.runCommand("Fairing_CurvaturePicture")
gui.settle()
App.closeDocument(document.Name)
gui.wait_for(lambda: not gui.panel_is_open(), "the panel to close")
print("passed")
