<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
 <context>
  <name>FairingFillPanel</name>
  <message>
   <source>Fill Hole</source>
   <translation>Loch füllen</translation>
  </message>
  <message>
   <source>Boundary</source>
   <translation>Rand</translation>
  </message>
  <message>
   <source>Pick an edge of the hole in the 3D view, or the face to be replaced.</source>
   <translation>In der 3D-Ansicht eine Kante des Lochs anklicken oder die Fläche, die ersetzt werden soll.</translation>
  </message>
  <message>
   <source>The edges round the hole, in order. Continuity: G1 meets the neighbouring face tangentially, G0 only touches the edge. Gap and angle are the largest ones measured along the edge.</source>
   <translation>Die Kanten um das Loch der Reihe nach. G1 schließt tangential an die Nachbarfläche an, G0 berührt nur die Kante. Abstand und Winkel sind die größten, die entlang der Kante gemessen wurden.</translation>
  </message>
  <message>
   <source>Edge</source>
   <translation>Kante</translation>
  </message>
  <message>
   <source>Edge of the base; the sign tells whether it is met within the tolerances</source>
   <translation>Kante des Grundkörpers; das Zeichen sagt, ob sie innerhalb der Toleranzen getroffen wird</translation>
  </message>
  <message>
   <source>Face</source>
   <translation>Fläche</translation>
  </message>
  <message>
   <source>The neighbouring face</source>
   <translation>Die Nachbarfläche</translation>
  </message>
  <message>
   <source>Meets</source>
   <translation>Anschluss</translation>
  </message>
  <message>
   <source>How the surface meets the neighbouring face</source>
   <translation>Wie die Fläche an die Nachbarfläche anschließt</translation>
  </message>
  <message>
   <source>Gap</source>
   <translation>Abstand</translation>
  </message>
  <message>
   <source>Largest distance of the edge from the surface</source>
   <translation>Größter Abstand der Kante von der Fläche</translation>
  </message>
  <message>
   <source>Angle</source>
   <translation>Winkel</translation>
  </message>
  <message>
   <source>Largest angle between the surface and the neighbouring face, in degrees</source>
   <translation>Größter Winkel zwischen der Fläche und der Nachbarfläche, in Grad</translation>
  </message>
  <message>
   <source>All G1</source>
   <translation>Alle G1</translation>
  </message>
  <message>
   <source>Meet every neighbouring face tangentially</source>
   <translation>An jede Nachbarfläche tangential anschließen</translation>
  </message>
  <message>
   <source>All G0</source>
   <translation>Alle G0</translation>
  </message>
  <message>
   <source>Only touch every edge</source>
   <translation>Jede Kante nur berühren</translation>
  </message>
  <message>
   <source>Pick anew</source>
   <translation>Neu wählen</translation>
  </message>
  <message>
   <source>Forget the edges and pick another hole</source>
   <translation>Die Kanten vergessen und ein anderes Loch wählen</translation>
  </message>
  <message>
   <source>Whether the surface meets its neighbours within the tolerances, as measured</source>
   <translation>Ob die Fläche innerhalb der Toleranzen an ihre Nachbarn anschließt, wie gemessen</translation>
  </message>
  <message>
   <source>Preview</source>
   <translation>Vorschau</translation>
  </message>
  <message>
   <source>Compute and show the surface whenever something changes</source>
   <translation>Die Fläche nach jeder Änderung berechnen und zeigen</translation>
  </message>
  <message>
   <source>Labels</source>
   <translation>Schilder</translation>
  </message>
  <message>
   <source>Show at each edge in the 3D view how the surface meets it</source>
   <translation>In der 3D-Ansicht an jeder Kante zeigen, wie die Fläche sie trifft</translation>
  </message>
  <message>
   <source>The surface is being computed</source>
   <translation>Die Fläche wird berechnet</translation>
  </message>
  <message>
   <source>Stop</source>
   <translation>Halt</translation>
  </message>
  <message>
   <source>Stop computing</source>
   <translation>Die Berechnung anhalten</translation>
  </message>
  <message>
   <source>Shape</source>
   <translation>Form</translation>
  </message>
  <message>
   <source>Energy</source>
   <translation>Energie</translation>
  </message>
  <message>
   <source>What the surface minimises inside the hole. Default: Thin plate</source>
   <translation>Was die Fläche im Loch möglichst klein macht. Vorgabe: Dünne Platte</translation>
  </message>
  <message>
   <source>Thin plate</source>
   <translation>Dünne Platte</translation>
  </message>
  <message>
   <source>Membrane</source>
   <translation>Membran</translation>
  </message>
  <message>
   <source>Guide</source>
   <translation>Führung</translation>
  </message>
  <message>
   <source>Pick guiding faces</source>
   <translation>Führende Flächen wählen</translation>
  </message>
  <message>
   <source>Pick faces in the 3D view whose normals and points guide the surface</source>
   <translation>In der 3D-Ansicht Flächen anklicken, deren Normalen und Punkte die Fläche führen</translation>
  </message>
  <message>
   <source>No guide</source>
   <translation>Keine Führung</translation>
  </message>
  <message>
   <source>Normals λ</source>
   <translation>Normalen λ</translation>
  </message>
  <message>
   <source>How strongly the surface follows the normals of the guiding faces; 0 (left): not at all. Default: 0</source>
   <translation>Wie stark die Fläche den Normalen der führenden Flächen folgt; 0 (links): gar nicht. Vorgabe: 0</translation>
  </message>
  <message>
   <source>Points γ</source>
   <translation>Punkte γ</translation>
  </message>
  <message>
   <source>How strongly the surface follows the points of the guiding faces; 0 (left): not at all. Default: 0</source>
   <translation>Wie stark die Fläche den Punkten der führenden Flächen folgt; 0 (links): gar nicht. Vorgabe: 0</translation>
  </message>
  <message>
   <source>Result and limits</source>
   <translation>Ergebnis und Grenzen</translation>
  </message>
  <message>
   <source>Result</source>
   <translation>Ergebnis</translation>
  </message>
  <message>
   <source>What the new object holds. Default: the new faces alone</source>
   <translation>Was das neue Objekt enthält. Vorgabe: die neuen Flächen allein</translation>
  </message>
  <message>
   <source>New faces</source>
   <translation>Neue Flächen</translation>
  </message>
  <message>
   <source>New faces, sewn together</source>
   <translation>Neue Flächen, vernäht</translation>
  </message>
  <message>
   <source>Base with the hole closed</source>
   <translation>Grundkörper mit geschlossenem Loch</translation>
  </message>
  <message>
   <source>Gap ≤</source>
   <translation>Abstand ≤</translation>
  </message>
  <message>
   <source>Largest distance of an edge from the surface, a length</source>
   <translation>Größter Abstand einer Kante von der Fläche, eine Länge</translation>
  </message>
  <message>
   <source>Auto</source>
   <translation>Auto</translation>
  </message>
  <message>
   <source>A millionth of the hole's diagonal</source>
   <translation>Ein Millionstel der Lochdiagonale</translation>
  </message>
  <message>
   <source>Angle ≤</source>
   <translation>Winkel ≤</translation>
  </message>
  <message>
   <source>Largest angle to the neighbouring faces along the edges. Default: 0.02°</source>
   <translation>Größter Winkel zu den Nachbarflächen entlang der Kanten. Vorgabe: 0,02°</translation>
  </message>
  <message>
   <source>Degree</source>
   <translation>Grad</translation>
  </message>
  <message>
   <source>Degree of the surface, 3 to 9; never below that of the edges. Default: chosen from the edges</source>
   <translation>Grad der Fläche, 3 bis 9; nie unter dem der Kanten. Vorgabe: aus den Kanten bestimmt</translation>
  </message>
  <message>
   <source>Largest number of control points. Default: 10000</source>
   <translation>Größte Zahl von Kontrollpunkten. Vorgabe: 10000</translation>
  </message>
  <message>
   <source> points</source>
   <translation> Punkte</translation>
  </message>
 </context>
 <context>
  <name>FairingPreferences</name>
  <message>
   <source>General</source>
   <translation>Allgemein</translation>
  </message>
  <message>
   <source>New fills</source>
   <translation>Neue Füllungen</translation>
  </message>
  <message>
   <source>Meets its neighbours</source>
   <translation>Anschluss an die Nachbarn</translation>
  </message>
  <message>
   <source>How a new surface meets the neighbouring faces</source>
   <translation>Wie eine neue Fläche an die Nachbarflächen anschließt</translation>
  </message>
  <message>
   <source>G0 - touching</source>
   <translation>G0 - berührend</translation>
  </message>
  <message>
   <source>G1 - tangentially</source>
   <translation>G1 - tangential</translation>
  </message>
  <message>
   <source>Energy</source>
   <translation>Energie</translation>
  </message>
  <message>
   <source>What a new surface minimises inside the hole</source>
   <translation>Was eine neue Fläche im Loch möglichst klein macht</translation>
  </message>
  <message>
   <source>Thin plate - bends as little as possible</source>
   <translation>Dünne Platte - biegt sich so wenig wie möglich</translation>
  </message>
  <message>
   <source>Membrane - stretches as little as possible</source>
   <translation>Membran - dehnt sich so wenig wie möglich</translation>
  </message>
  <message>
   <source>Result</source>
   <translation>Ergebnis</translation>
  </message>
  <message>
   <source>What a new object holds</source>
   <translation>Was ein neues Objekt enthält</translation>
  </message>
  <message>
   <source>New faces</source>
   <translation>Neue Flächen</translation>
  </message>
  <message>
   <source>New faces, sewn together</source>
   <translation>Neue Flächen, vernäht</translation>
  </message>
  <message>
   <source>Base with the hole closed</source>
   <translation>Grundkörper mit geschlossenem Loch</translation>
  </message>
  <message>
   <source>Largest angle</source>
   <translation>Größter Winkel</translation>
  </message>
  <message>
   <source>Largest angle to the neighbouring faces that counts as tangential, in degrees</source>
   <translation>Größter Winkel zu den Nachbarflächen, der als tangential gilt, in Grad</translation>
  </message>
  <message>
   <source>Control points, at most</source>
   <translation>Kontrollpunkte, höchstens</translation>
  </message>
  <message>
   <source>Largest number of control points of a new surface</source>
   <translation>Größte Zahl von Kontrollpunkten einer neuen Fläche</translation>
  </message>
  <message>
   <source>Display</source>
   <translation>Anzeige</translation>
  </message>
  <message>
   <source>Compute and show the surface while the panel is open</source>
   <translation>Die Fläche berechnen und zeigen, solange das Fenster offen ist</translation>
  </message>
  <message>
   <source>The panel's Preview is ticked when it opens</source>
   <translation>„Vorschau“ ist angehakt, wenn sich das Fenster öffnet</translation>
  </message>
  <message>
   <source>Label the edges in the 3D view</source>
   <translation>Die Kanten in der 3D-Ansicht beschildern</translation>
  </message>
  <message>
   <source>The panel's Labels is ticked when it opens</source>
   <translation>„Schilder“ ist angehakt, wenn sich das Fenster öffnet</translation>
  </message>
  <message>
   <source>Colour of new faces</source>
   <translation>Farbe neuer Flächen</translation>
  </message>
  <message>
   <source>Colour a new surface is shown in</source>
   <translation>Farbe, in der eine neue Fläche gezeigt wird</translation>
  </message>
 </context>
 <context>
  <name>Workbench</name>
  <message>
   <source>Fill holes with surfaces that meet their neighbours smoothly</source>
   <translation>Löcher mit Flächen füllen, die glatt an ihre Nachbarn anschließen</translation>
  </message>
 </context>
 <context>
  <name>Fairing</name>
  <message>
   <source>This is the surface being made: pick an edge of the hole beside it.</source>
   <translation>Das ist die Fläche, die gerade entsteht: eine Kante des Lochs daneben anklicken.</translation>
  </message>
  <message>
   <source>Pick an edge of the hole, or the face to be replaced.</source>
   <translation>Eine Kante des Lochs anklicken oder die Fläche, die ersetzt werden soll.</translation>
  </message>
  <message>
   <source>G1: tangential to the face. G0: only touches the edge.</source>
   <translation>G1: tangential zur Fläche. G0: berührt nur die Kante.</translation>
  </message>
  <message>
   <source>Gap {0}, allowed {1}</source>
   <translation>Abstand {0}, erlaubt {1}</translation>
  </message>
  <message>
   <source>Angle {0}, allowed {1}</source>
   <translation>Winkel {0}, erlaubt {1}</translation>
  </message>
  <message>
   <source>Angle next to the corners {0}, allowed {1}</source>
   <translation>Winkel bei den Ecken {0}, erlaubt {1}</translation>
  </message>
  <message>
   <source>Curvature differs by {0:.0%}</source>
   <translation>Krümmung unterscheidet sich um {0:.0%}</translation>
  </message>
  <message>
   <source>The surface folds back at this edge.</source>
   <translation>Die Fläche schlägt an dieser Kante um.</translation>
  </message>
  <message>
   <source>Stopped. Change something, or press OK, to compute again.</source>
   <translation>Angehalten. Etwas ändern oder OK drücken, um neu zu rechnen.</translation>
  </message>
  <message>
   <source>The preview is off.</source>
   <translation>Die Vorschau ist aus.</translation>
  </message>
  <message>
   <source>Computing ...</source>
   <translation>Rechnet ...</translation>
  </message>
  <message>
   <source>Bends as little as possible.</source>
   <translation>Biegt sich so wenig wie möglich.</translation>
  </message>
  <message>
   <source>Stretches as little as possible.</source>
   <translation>Dehnt sich so wenig wie möglich.</translation>
  </message>
  <message>
   <source>Pick faces in the 3D view</source>
   <translation>Flächen in der 3D-Ansicht wählen</translation>
  </message>
  <message>
   <source>Pick guiding faces</source>
   <translation>Führende Flächen wählen</translation>
  </message>
  <message>
   <source>Fairing cannot work</source>
   <translation>Fairing kann nicht arbeiten</translation>
  </message>
 </context>
 <context>
  <name>Fairing_FillHole</name>
  <message>
   <source>Fill Hole</source>
   <translation>Loch füllen</translation>
  </message>
  <message>
   <source>Fill a hole with a surface that meets its neighbours smoothly: pick one edge of the hole, or the face to be replaced</source>
   <translation>Ein Loch mit einer Fläche füllen, die glatt an ihre Nachbarn anschließt: eine Kante des Lochs anklicken oder die Fläche, die ersetzt werden soll</translation>
  </message>
 </context>
 <context>
  <name>Fairing_Reconnect</name>
  <message>
   <source>Reconnect Fills</source>
   <translation>Füllungen wiederbeleben</translation>
  </message>
  <message>
   <source>Make fills compute again that were saved by a FreeCAD without Fairing</source>
   <translation>Füllungen wieder rechnen lassen, die ein FreeCAD ohne Fairing gespeichert hat</translation>
  </message>
 </context>
</TS>
