<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
 <context>
  <name>FairingFillAllPanel</name>
  <message>
   <source>Fill All Holes</source>
   <translation>Alle Löcher füllen</translation>
  </message>
  <message>
   <source>Holes</source>
   <translation>Löcher</translation>
  </message>
  <message>
   <source>Pick an edge or a face of the object whose holes are to be filled.</source>
   <translation>Eine Kante oder Fläche des Objekts anklicken, dessen Löcher gefüllt werden sollen.</translation>
  </message>
  <message>
   <source>The holes of the object. Those with a tick are filled. A click on a row shows its hole in the 3D view.</source>
   <translation>Die Löcher des Objekts. Die mit Haken werden gefüllt. Ein Klick auf eine Zeile zeigt ihr Loch in der 3D-Ansicht.</translation>
  </message>
  <message>
   <source>Hole</source>
   <translation>Loch</translation>
  </message>
  <message>
   <source>Number of the hole; the tick says whether it is filled, the sign how well</source>
   <translation>Nummer des Lochs; der Haken sagt, ob es gefüllt wird, das Zeichen, wie gut</translation>
  </message>
  <message>
   <source>Sides</source>
   <translation>Seiten</translation>
  </message>
  <message>
   <source>Number of edges round the hole</source>
   <translation>Zahl der Kanten um das Loch</translation>
  </message>
  <message>
   <source>Layout</source>
   <translation>Aufteilung</translation>
  </message>
  <message>
   <source>How patches span the hole</source>
   <translation>Wie Flächenstücke das Loch überspannen</translation>
  </message>
  <message>
   <source>Gap</source>
   <translation>Abstand</translation>
  </message>
  <message>
   <source>Largest distance of an edge from the surface</source>
   <translation>Größter Abstand einer Kante von der Fläche</translation>
  </message>
  <message>
   <source>Angle</source>
   <translation>Winkel</translation>
  </message>
  <message>
   <source>Largest angle between the surface and a neighbouring face</source>
   <translation>Größter Winkel zwischen der Fläche und einer Nachbarfläche</translation>
  </message>
  <message>
   <source>Verdict</source>
   <translation>Urteil</translation>
  </message>
  <message>
   <source>Whether the hole is filled within the tolerances</source>
   <translation>Ob das Loch innerhalb der Toleranzen gefüllt ist</translation>
  </message>
  <message>
   <source>All</source>
   <translation>Alle</translation>
  </message>
  <message>
   <source>Fill every hole</source>
   <translation>Jedes Loch füllen</translation>
  </message>
  <message>
   <source>None</source>
   <translation>Keins</translation>
  </message>
  <message>
   <source>Fill no hole</source>
   <translation>Kein Loch füllen</translation>
  </message>
  <message>
   <source>Meet</source>
   <translation>Anschluss</translation>
  </message>
  <message>
   <source>How the surfaces meet the faces beside the holes: G2 in curvature, G1 tangentially, G0 only touching. Default: G1</source>
   <translation>Wie die Flächen an die Flächen neben den Löchern anschließen: G2 in der Krümmung, G1 tangential, G0 nur berührend. Vorgabe: G1</translation>
  </message>
  <message>
   <source>G0</source>
   <translation>G0</translation>
  </message>
  <message>
   <source>G1</source>
   <translation>G1</translation>
  </message>
  <message>
   <source>G2</source>
   <translation>G2</translation>
  </message>
  <message>
   <source>Outer borders</source>
   <translation>Außenränder</translation>
  </message>
  <message>
   <source>Fill the rims of open sheets, too. Default: off</source>
   <translation>Auch die Ränder offener Flächen füllen. Vorgabe: aus</translation>
  </message>
  <message>
   <source>How many holes are filled within the tolerances, as measured; of a selected row, how well its hole is</source>
   <translation>Wie viele Löcher innerhalb der Toleranzen gefüllt sind, wie gemessen; von einer gewählten Zeile, wie gut ihr Loch</translation>
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
   <source>Show the number of each hole in the 3D view</source>
   <translation>Die Nummer jedes Lochs in der 3D-Ansicht zeigen</translation>
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
 </context>
 <context>
  <name>FairingBlendPanel</name>
  <message>
   <source>Blend Faces</source>
   <translation>Flächen überblenden</translation>
  </message>
  <message>
   <source>Sides</source>
   <translation>Seiten</translation>
  </message>
  <message>
   <source>Pick an edge the surface starts from in the 3D view, then the edge it ends at, or several closed ones for a junction.</source>
   <translation>In der 3D-Ansicht eine Kante anklicken, an der die Fläche beginnt, dann die, an der sie endet, oder für einen Knoten mehrere geschlossene.</translation>
  </message>
  <message>
   <source>Starts from</source>
   <translation>Beginnt an</translation>
  </message>
  <message>
   <source>Edges picked now belong to the side the surface starts from</source>
   <translation>Kanten, die jetzt gewählt werden, gehören zu der Seite, an der die Fläche beginnt</translation>
  </message>
  <message>
   <source>The edges of this side: the picked ones, and slanted those that continue them smoothly, found by themselves. Meets: G2 meets the neighbouring face in curvature, G1 tangentially, G0 only touches the edge. The numbers are the largest ones measured along the edge.</source>
   <translation>Die Kanten dieser Seite: die gewählten und schräg gedruckt die, die sie glatt fortsetzen und von selbst gefunden wurden. G2 schließt in der Krümmung an die Nachbarfläche an, G1 tangential, G0 berührt nur die Kante. Die Zahlen sind die größten, die entlang der Kante gemessen wurden.</translation>
  </message>
  <message>
   <source>Edge</source>
   <translation>Kante</translation>
  </message>
  <message>
   <source>The edge; the sign tells whether it is met within the tolerances</source>
   <translation>Die Kante; das Zeichen sagt, ob sie innerhalb der Toleranzen getroffen wird</translation>
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
   <source>Curv.</source>
   <translation>Krümm.</translation>
  </message>
  <message>
   <source>Largest relative difference between the curvatures of the surface and of the neighbouring face across the edge</source>
   <translation>Größter relativer Unterschied zwischen den Krümmungen der Fläche und der Nachbarfläche quer zur Kante</translation>
  </message>
  <message>
   <source>Ends at</source>
   <translation>Endet an</translation>
  </message>
  <message>
   <source>Edges picked now belong to the side the surface ends at</source>
   <translation>Kanten, die jetzt gewählt werden, gehören zu der Seite, an der die Fläche endet</translation>
  </message>
  <message>
   <source>All G2</source>
   <translation>Alle G2</translation>
  </message>
  <message>
   <source>Meet every neighbouring face in curvature</source>
   <translation>An jede Nachbarfläche in der Krümmung anschließen</translation>
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
   <source>Forget the edges of both sides</source>
   <translation>Die Kanten beider Seiten vergessen</translation>
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
   <source>Reach</source>
   <translation>Weite</translation>
  </message>
  <message>
   <source>How far the surface goes on along the faces of this side before it turns away: 1 as the fairest surface does, 2 twice as far. Drag the blue arrow in the 3D view instead. Default: 1</source>
   <translation>Wie weit die Fläche den Flächen dieser Seite folgt, ehe sie sich abwendet: 1 wie die schönste Fläche, 2 doppelt so weit. Statt dessen lässt sich der blaue Pfeil in der 3D-Ansicht ziehen. Vorgabe: 1</translation>
  </message>
  <message>
   <source>Reach 1: as far as the fairest surface goes.</source>
   <translation>Weite 1: so weit wie die schönste Fläche.</translation>
  </message>
  <message>
   <source>Remove</source>
   <translation>Entfernen</translation>
  </message>
  <message>
   <source>Take the edge chosen in the tables away from its side; edges found by themselves go with the picked ones</source>
   <translation>Die in den Tabellen gewählte Kante von ihrer Seite nehmen; von selbst gefundene gehen mit den gewählten</translation>
  </message>
  <message>
   <source>More</source>
   <translation>Mehr</translation>
  </message>
  <message>
   <source>Reach that changes along a side, direction, setback, and what belongs together</source>
   <translation>Weite, die sich entlang einer Seite ändert, Richtung, Abstand, und was zusammengehört</translation>
  </message>
  <message>
   <source>Reach at end</source>
   <translation>Weite am Ende</translation>
  </message>
  <message>
   <source>Lets the reach change along an open side: this is the reach at its end, the one above that at its start. Default: off</source>
   <translation>Lässt die Weite sich entlang einer offenen Seite ändern: dies ist die Weite an ihrem Ende, die obere die am Anfang. Vorgabe: aus</translation>
  </message>
  <message>
   <source>Leaves</source>
   <translation>Abgang</translation>
  </message>
  <message>
   <source>Direction in which the surface leaves the edges: freely in the tangent plane, square to the edge, or along the curves of the face. Default: freely</source>
   <translation>Richtung, in der die Fläche die Kanten verlässt: frei in der Tangentialebene, senkrecht zur Kante oder entlang der Kurven der Fläche. Vorgabe: frei</translation>
  </message>
  <message>
   <source>Direction</source>
   <translation>Richtung</translation>
  </message>
  <message>
   <source>Leave this side the other way, back over its face. Default: off</source>
   <translation>Diese Seite in der anderen Richtung verlassen, zurück über ihre Fläche. Vorgabe: aus</translation>
  </message>
  <message>
   <source>Setback</source>
   <translation>Abstand</translation>
  </message>
  <message>
   <source>How far from the edges, inside the faces, the surface starts; in a sewn result the faces are trimmed back to there. Default: 0 mm</source>
   <translation>Wie weit von den Kanten, innerhalb der Flächen, die Fläche beginnt; im vernähten Ergebnis sind die Flächen bis dorthin beschnitten. Vorgabe: 0 mm</translation>
  </message>
  <message>
   <source>Match</source>
   <translation>Zuordnung</translation>
  </message>
  <message>
   <source>Which points of the sides belong together: equal shares of their lengths, or corner to corner. Automatic: corners where both sides have as many</source>
   <translation>Welche Punkte der Seiten zusammengehören: gleiche Anteile der Längen, oder Ecke zu Ecke. Automatisch: Ecken, wo beide Seiten gleich viele haben</translation>
  </message>
  <message>
   <source>Turn</source>
   <translation>Drehung</translation>
  </message>
  <message>
   <source>Turns closed sides against each other, from where the surface is least twisted, by a share of the length. Default: 0</source>
   <translation>Dreht geschlossene Seiten gegeneinander, von dort, wo die Fläche am wenigsten verdreht ist, um einen Anteil der Länge. Vorgabe: 0</translation>
  </message>
  <message>
   <source>Freely</source>
   <translation>Frei</translation>
  </message>
  <message>
   <source>Square to edge</source>
   <translation>Senkrecht zur Kante</translation>
  </message>
  <message>
   <source>Along curves</source>
   <translation>Entlang der Kurven</translation>
  </message>
  <message>
   <source>Other way</source>
   <translation>Umgekehrt</translation>
  </message>
  <message>
   <source>Automatic</source>
   <translation>Automatisch</translation>
  </message>
  <message>
   <source>By length</source>
   <translation>Nach Länge</translation>
  </message>
  <message>
   <source>Corner to corner</source>
   <translation>Ecke zu Ecke</translation>
  </message>
  <message>
   <source>A curve drawn on the faces of this side, or a little off them, that the surface starts at in place of a distance: pick its edges, or a sketch in the tree; in a sewn result the faces are trimmed back to it</source>
   <translation>Eine Kurve auf den Flächen dieser Seite oder etwas daneben, an der die Fläche beginnt statt in einem Abstand: ihre Kanten anklicken, oder eine Skizze im Baum; in einem vernähten Ergebnis werden die Flächen bis dorthin beschnitten</translation>
  </message>
  <message>
   <source>A curve drawn on the faces of this side, or a little off them, that the surface ends at in place of a distance: pick its edges, or a sketch in the tree; in a sewn result the faces are trimmed back to it</source>
   <translation>Eine Kurve auf den Flächen dieser Seite oder etwas daneben, an der die Fläche endet statt in einem Abstand: ihre Kanten anklicken, oder eine Skizze im Baum; in einem vernähten Ergebnis werden die Flächen bis dorthin beschnitten</translation>
  </message>
  <message>
   <source>Take the curve away</source>
   <translation>Die Kurve wegnehmen</translation>
  </message>
  <message>
   <source>Pair two vertices</source>
   <translation>Zwei Punkte zuordnen</translation>
  </message>
  <message>
   <source>Vertices of both sides that belong together: pick one of either side in the 3D view</source>
   <translation>Punkte beider Seiten, die zusammengehören: je einen in der 3D-Ansicht anklicken</translation>
  </message>
  <message>
   <source>Take the chosen pair away, or all</source>
   <translation>Das gewählte Paar wegnehmen, oder alle</translation>
  </message>
  <message>
   <source>The sides come to a vertex</source>
   <translation>Die Seiten laufen auf eine Ecke zu</translation>
  </message>
  <message>
   <source>Each chain is a side of its own, with gaps between it and the next ones: all are joined round the vertex they would meet in</source>
   <translation>Jede Kantenfolge ist eine eigene Seite, mit Lücken zu den nächsten: alle werden rund um die Ecke verbunden, in der sie zusammenliefen</translation>
  </message>
  <message>
   <source>Cuts: automatic</source>
   <translation>Schnitte: automatisch</translation>
  </message>
  <message>
   <source>Where the junction is cut from rim to rim. Pick edges drawn between the rims in the 3D view: the cuts leave the rims at their ends</source>
   <translation>Wo die Verzweigung von Rand zu Rand geschnitten wird. Kanten anklicken, die zwischen den Rändern gezeichnet sind: die Schnitte beginnen an ihren Enden</translation>
  </message>
  <message>
   <source>Find the cuts automatically</source>
   <translation>Die Schnitte automatisch finden</translation>
  </message>
  <message>
   <source>Let the ends follow edges or faces</source>
   <translation>Enden an Kanten oder Flächen führen</translation>
  </message>
  <message>
   <source>Edges or faces, of any objects, that lead from the end of one side to the end of the other; on other faces the end slides. Pick them in the 3D view</source>
   <translation>Kanten oder Flächen beliebiger Objekte, die vom Ende der einen Seite zum Ende der anderen führen; auf anderen Flächen gleitet das Ende. In der 3D-Ansicht anklicken</translation>
  </message>
  <message>
   <source>Let the ends leave the chosen edge or face, or all</source>
   <translation>Die Enden von der gewählten Kante oder Fläche lösen, oder von allen</translation>
  </message>
  <message>
   <source>What the ends of the blend follow, with the gap as measured</source>
   <translation>Dem die Enden der Verbindung folgen, mit dem gemessenen Abstand</translation>
  </message>
 </context>
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
   <source>The edges round the hole, in order. Meets: G2 meets the neighbouring face in curvature, G1 tangentially, G0 only touches the edge. The numbers are the largest ones measured along the edge.</source>
   <translation>Die Kanten um das Loch der Reihe nach. G2 schließt in der Krümmung an die Nachbarfläche an, G1 tangential, G0 berührt nur die Kante. Die Zahlen sind die größten, die entlang der Kante gemessen wurden.</translation>
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
   <source>Curv.</source>
   <translation>Krümm.</translation>
  </message>
  <message>
   <source>Largest relative difference between the curvatures of the surface and of the neighbouring face across the edge</source>
   <translation>Größter relativer Unterschied zwischen den Krümmungen der Fläche und der Nachbarfläche quer zur Kante</translation>
  </message>
  <message>
   <source>All G2</source>
   <translation>Alle G2</translation>
  </message>
  <message>
   <source>Meet every neighbouring face in curvature</source>
   <translation>An jede Nachbarfläche in der Krümmung anschließen</translation>
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
   <source>Pass through points or edges</source>
   <translation>Durch Punkte oder Kanten führen</translation>
  </message>
  <message>
   <source>Pick vertices, edges, sketches or datum points in the 3D view or the tree that the surface is to pass through</source>
   <translation>In der 3D-Ansicht oder im Baum Punkte, Kanten, Skizzen oder Bezugspunkte wählen, durch die die Fläche gehen soll</translation>
  </message>
  <message>
   <source>✕</source>
   <translation>✕</translation>
  </message>
  <message>
   <source>Leave out what is selected in the list, or everything</source>
   <translation>Weglassen, was in der Liste gewählt ist, oder alles</translation>
  </message>
  <message>
   <source>What the surface passes through, with its distance from it as measured</source>
   <translation>Wodurch die Fläche geht, mit dem gemessenen Abstand von ihr</translation>
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
 </context>
 <context>
  <name>FairingChoices</name>
  <message>
   <source>Choices</source>
   <translation>Einstellungen</translation>
  </message>
  <message>
   <source>Shape</source>
   <translation>Form</translation>
  </message>
  <message>
   <source>Layout</source>
   <translation>Aufteilung</translation>
  </message>
  <message>
   <source>How patches span the hole. Automatic takes what suits it: one patch for four sides, a star for other corners, a ring for round holes. Default: Automatic</source>
   <translation>Wie Flächenstücke das Loch überspannen. Automatisch nimmt, was passt: ein Stück bei vier Seiten, einen Stern bei anderen Ecken, einen Ring bei runden Löchern. Vorgabe: Automatisch</translation>
  </message>
  <message>
   <source>Automatic</source>
   <translation>Automatisch</translation>
  </message>
  <message>
   <source>Quad</source>
   <translation>Viereck</translation>
  </message>
  <message>
   <source>Star</source>
   <translation>Stern</translation>
  </message>
  <message>
   <source>O-grid</source>
   <translation>Ring</translation>
  </message>
  <message>
   <source>Trimmed</source>
   <translation>Getrimmt</translation>
  </message>
  <message>
   <source>Energy</source>
   <translation>Energie</translation>
  </message>
  <message>
   <source>What the surface minimises inside the hole</source>
   <translation>Was die Fläche im Inneren des Lochs kleinstmöglich macht</translation>
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
   <source>Least change of curvature</source>
   <translation>Geringste Krümmungsänderung</translation>
  </message>
  <message>
   <source>Least change of curvature, to the end</source>
   <translation>Kleinste Krümmungsänderung, genau</translation>
  </message>
  <message>
   <source>Minimum variation</source>
   <translation>Kleinste Variation</translation>
  </message>
  <message>
   <source>Total curvature</source>
   <translation>Gesamtkrümmung</translation>
  </message>
  <message>
   <source>Triharmonic</source>
   <translation>Triharmonisch</translation>
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
   <source>Largest number of control points. Default: 2500</source>
   <translation>Größte Zahl von Kontrollpunkten. Vorgabe: 2500</translation>
  </message>
  <message>
   <source>≤ </source>
   <translation>≤ </translation>
  </message>
  <message>
   <source> points</source>
   <translation> Punkte</translation>
  </message>
  <message>
   <source>Between patches</source>
   <translation>Zwischen Stücken</translation>
  </message>
  <message>
   <source>How the patches of one surface meet each other. Tangent is quick, but reflections may bend sharply at the seams. Curvature lets them run on smoothly, for surfaces that will be seen, and takes several times to a hundred times as long and more control points. A surface of one patch is the same either way. Default: Tangent (G1)</source>
   <translation>Wie die Stücke einer Fläche aneinander stoßen. Tangential geht schnell, doch können Spiegelungen an den Nähten knicken. Mit gleicher Krümmung laufen sie glatt durch, für Flächen, die man sehen wird; das dauert einige Male bis hundertmal so lang und braucht mehr Kontrollpunkte. Bei einem einzigen Stück ändert sich nichts. Vorgabe: Tangential (G1)</translation>
  </message>
  <message>
   <source>Tangent (G1)</source>
   <translation>Tangential (G1)</translation>
  </message>
  <message>
   <source>Curvature (G2)</source>
   <translation>Krümmung (G2)</translation>
  </message>
  <message>
   <source>Compare…</source>
   <translation>Vergleichen…</translation>
  </message>
  <message>
   <source>Make the surface with every energy, and show values and shapes side by side</source>
   <translation>Die Fläche mit jeder Energie machen, Werte und Formen nebeneinander zeigen</translation>
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
   <source>G2 - in curvature</source>
   <translation>G2 - in der Krümmung</translation>
  </message>
  <message>
   <source>Layout</source>
   <translation>Aufteilung</translation>
  </message>
  <message>
   <source>How patches span a hole</source>
   <translation>Wie Flächenstücke ein Loch überspannen</translation>
  </message>
  <message>
   <source>Automatic</source>
   <translation>Automatisch</translation>
  </message>
  <message>
   <source>Quad</source>
   <translation>Viereck</translation>
  </message>
  <message>
   <source>Star</source>
   <translation>Stern</translation>
  </message>
  <message>
   <source>O-grid</source>
   <translation>Ring</translation>
  </message>
  <message>
   <source>Trimmed</source>
   <translation>Getrimmt</translation>
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
   <source>Least change of curvature - the fairest</source>
   <translation>Geringste Krümmungsänderung - am schönsten</translation>
  </message>
  <message>
   <source>Least change of curvature, to the end - the same, taken to its minimum</source>
   <translation>Kleinste Krümmungsänderung, genau - dieselbe, bis zum Minimum geführt</translation>
  </message>
  <message>
   <source>Minimum variation - brings back spheres, cylinders, cones and tori</source>
   <translation>Kleinste Variation - bringt Kugeln, Zylinder, Kegel und Tori zurück</translation>
  </message>
  <message>
   <source>Total curvature - bends as little as possible, whatever the parameters</source>
   <translation>Gesamtkrümmung - biegt sich so wenig wie möglich, unabhängig von den Parametern</translation>
  </message>
  <message>
   <source>Triharmonic - bends as evenly as possible; quick</source>
   <translation>Triharmonisch - biegt sich so gleichmäßig wie möglich; schnell</translation>
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
   <source> °</source>
   <translation> °</translation>
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
   <source>Fill holes and join edges with surfaces that meet their neighbours smoothly</source>
   <translation>Löcher füllen und Kanten verbinden, mit Flächen, die glatt an ihre Nachbarn anschließen</translation>
  </message>
 </context>
 <context>
  <name>Fairing</name>
  <message>
   <source>Another task panel is open: close it first.</source>
   <translation>Ein anderes Aufgabenfenster ist offen: zuerst schließen.</translation>
  </message>
  <message>
   <source>This is the surface being made: pick an edge of the hole beside it.</source>
   <translation>Das ist die Fläche, die gerade entsteht: eine Kante des Lochs daneben anklicken.</translation>
  </message>
  <message>
   <source>Pick a point, an edge, a sketch or a datum point.</source>
   <translation>Einen Punkt, eine Kante, eine Skizze oder einen Bezugspunkt wählen.</translation>
  </message>
  <message>
   <source>Pick an edge of the hole, or the face to be replaced.</source>
   <translation>Eine Kante des Lochs anklicken oder die Fläche, die ersetzt werden soll.</translation>
  </message>
  <message>
   <source>Pick an edge: a blend starts from edges and ends at edges.</source>
   <translation>Eine Kante wählen: Eine Überblendung beginnt an Kanten und endet an Kanten.</translation>
  </message>
  <message>
   <source>Fairing cannot work</source>
   <translation>Fairing kann nicht arbeiten</translation>
  </message>
  <message>
   <source>G2: with the curvature of the face. G1: tangential to it. G0: only touches the edge.</source>
   <translation>G2: mit der Krümmung der Nachbarfläche. G1: tangential zu ihr. G0: berührt nur die Kante.</translation>
  </message>
  <message>
   <source>Curvature differs by {0}, allowed {1}</source>
   <translation>Krümmung weicht um {0} ab, erlaubt {1}</translation>
  </message>
  <message>
   <source>The surface folds back at this edge.</source>
   <translation>Die Fläche schlägt an dieser Kante um.</translation>
  </message>
  <message>
   <source>Curvature differs by {0}</source>
   <translation>Krümmung weicht um {0} ab</translation>
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
   <source>Pick a point, an edge or a sketch</source>
   <translation>Punkt, Kante oder Skizze anklicken</translation>
  </message>
  <message>
   <source>Pass through points or edges</source>
   <translation>Durch Punkte oder Kanten führen</translation>
  </message>
  <message>
   <source>Taking the best so far ...</source>
   <translation>Das Beste bis jetzt wird genommen ...</translation>
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
   <source>not filled</source>
   <translation>nicht gefüllt</translation>
  </message>
  <message>
   <source>good</source>
   <translation>gut</translation>
  </message>
  <message>
   <source>out of tolerance</source>
   <translation>außerhalb</translation>
  </message>
  <message>
   <source>Automatic</source>
   <translation>Automatisch</translation>
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
   <source>Changes its curvature as little as possible: fair and quick.</source>
   <translation>Ändert ihre Krümmung so wenig wie möglich: schön und schnell.</translation>
  </message>
  <message>
   <source>The same, taken to its minimum: slower.</source>
   <translation>Dasselbe, bis zum Minimum geführt: langsamer.</translation>
  </message>
  <message>
   <source>Brings back spheres, cylinders, cones and tori. Slower.</source>
   <translation>Bringt Kugeln, Zylinder, Kegel und Tori zurück. Langsamer.</translation>
  </message>
  <message>
   <source>Bends as little as possible, whatever the parameters. Slower.</source>
   <translation>Biegt sich so wenig wie möglich, unabhängig von den Parametern. Langsamer.</translation>
  </message>
  <message>
   <source>Bends as evenly as possible; quick.</source>
   <translation>Biegt sich so gleichmäßig wie möglich; schnell.</translation>
  </message>
  <message>
   <source>Found by itself: it continues a picked edge smoothly</source>
   <translation>Von selbst gefunden: setzt eine gewählte Kante glatt fort</translation>
  </message>
  <message>
   <source>Pick a vertex of a side</source>
   <translation>Einen Punkt einer Seite anklicken</translation>
  </message>
  <message>
   <source>Pick the vertex it belongs to</source>
   <translation>Den zugehörigen Punkt anklicken</translation>
  </message>
  <message>
   <source>Pick an edge of the curve, or a sketch.</source>
   <translation>Eine Kante der Kurve anklicken, oder eine Skizze.</translation>
  </message>
  <message>
   <source>Pick an edge</source>
   <translation>Kante anklicken</translation>
  </message>
  <message>
   <source>To a curve</source>
   <translation>Bis zu einer Kurve</translation>
  </message>
  <message>
   <source>{} edges</source>
   <translation>{} Kanten</translation>
  </message>
  <message>
   <source>Pair two vertices</source>
   <translation>Zwei Punkte zuordnen</translation>
  </message>
  <message>
   <source>Pick a vertex where edges of the other side meet.</source>
   <translation>Einen Punkt anklicken, an dem Kanten der anderen Seite enden.</translation>
  </message>
  <message>
   <source>Pick a vertex where edges of a side of the blend meet.</source>
   <translation>Einen Punkt anklicken, an dem Kanten einer Seite der Überblendung enden.</translation>
  </message>
  <message>
   <source>Pick edges or faces, then click here</source>
   <translation>Kanten oder Flächen anklicken, dann hier</translation>
  </message>
  <message>
   <source>Pick edges, then click here</source>
   <translation>Kanten anklicken, dann hier</translation>
  </message>
  <message>
   <source>Cuts shown: {}</source>
   <translation>Gezeigte Schnitte: {}</translation>
  </message>
  <message>
   <source>Cuts: automatic</source>
   <translation>Schnitte: automatisch</translation>
  </message>
  <message>
   <source>Let the ends follow edges or faces</source>
   <translation>Enden an Kanten oder Flächen führen</translation>
  </message>
  <message>
   <source>Pick an edge that leads from rim to rim.</source>
   <translation>Eine Kante anklicken, die von Rand zu Rand führt.</translation>
  </message>
  <message>
   <source>Pick the face to be shaped anew.</source>
   <translation>Die Fläche anklicken, die neu geformt werden soll.</translation>
  </message>
  <message>
   <source>Click on the surface where it is to have a normal.</source>
   <translation>Auf die Fläche klicken, wo sie eine Normale haben soll.</translation>
  </message>
  <message>
   <source>Pick an edge, or a sketch, for the surface to follow.</source>
   <translation>Eine Kante oder eine Skizze anklicken, der die Fläche folgen soll.</translation>
  </message>
  <message>
   <source>Pick a face, a mesh or an object that the surface is to be like.</source>
   <translation>Eine Fläche, ein Netz oder ein Objekt anklicken, dem die Fläche gleichen soll.</translation>
  </message>
  <message>
   <source>Pick a face, an edge or a datum with the direction.</source>
   <translation>Eine Fläche, eine Kante oder ein Bezugsobjekt mit der Richtung anklicken.</translation>
  </message>
  <message>
   <source>energy {0}</source>
   <translation>Energie {0}</translation>
  </message>
  <message>
   <source>Follows within {0} rms, {1} at most</source>
   <translation>Folgt auf {0} im Mittel (RMS), höchstens {1}</translation>
  </message>
  <message>
   <source>{0} from the reference</source>
   <translation>{0} vom Vorbild</translation>
  </message>
  <message>
   <source>it covers {0}</source>
   <translation>es deckt {0}</translation>
  </message>
  <message>
   <source>Pick it</source>
   <translation>Anklicken</translation>
  </message>
  <message>
   <source>From …</source>
   <translation>Von …</translation>
  </message>
  <message>
   <source>{0}  Normal ({1})</source>
   <translation>{0}  Normale ({1})</translation>
  </message>
  <message>
   <source>{0}  Along {1}</source>
   <translation>{0}  Entlang {1}</translation>
  </message>
  <message>
   <source>{0}  Normal from {1}</source>
   <translation>{0}  Normale von {1}</translation>
  </message>
  <message>
   <source>Pick an edge, a face, a mesh or a datum.</source>
   <translation>Eine Kante, eine Fläche, ein Netz oder ein Bezugsobjekt anklicken.</translation>
  </message>
  <message>
   <source>{0} from the face as it was</source>
   <translation>{0} von der Fläche, wie sie war</translation>
  </message>
  <message>
   <source>Point at the picture to read its values.</source>
   <translation>Auf das Bild zeigen, um seine Werte zu lesen.</translation>
  </message>
  <message>
   <source>What is selected has no faces with a surface.</source>
   <translation>Was ausgewählt ist, hat keine Flächen.</translation>
  </message>
 </context>
 <context>
  <name>Fairing_BlendFaces</name>
  <message>
   <source>Blend Faces</source>
   <translation>Flächen überblenden</translation>
  </message>
  <message>
   <source>Join two edges with a surface that leaves the faces beside them smoothly: select the edge it starts from, then the edge it ends at</source>
   <translation>Zwei Kanten mit einer Fläche verbinden, die glatt an die Flächen daneben anschließt: die Kante wählen, an der sie beginnt, dann die, an der sie endet</translation>
  </message>
  <message>
   <source>The edges cannot be joined</source>
   <translation>Die Kanten lassen sich nicht verbinden</translation>
  </message>
 </context>
 <context>
  <name>Fairing_FillAllHoles</name>
  <message>
   <source>Fill All Holes</source>
   <translation>Alle Löcher füllen</translation>
  </message>
  <message>
   <source>Fill every hole of the selected object with a surface that meets its neighbours smoothly</source>
   <translation>Jedes Loch des gewählten Objekts mit einer Fläche füllen, die glatt an ihre Nachbarn anschließt</translation>
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
 <context>
  <name>FairingEditPanel</name>
  <message>
   <source>Edit Surface</source>
   <translation>Fläche umformen</translation>
  </message>
  <message>
   <source>Face</source>
   <translation>Fläche</translation>
  </message>
  <message>
   <source>Pick the face to be shaped anew.</source>
   <translation>Die Fläche anklicken, die neu geformt werden soll.</translation>
  </message>
  <message>
   <source>The face that is shaped anew; pick another one in the 3D view</source>
   <translation>Die Fläche, die neu geformt wird; eine andere in der 3D-Ansicht anklicken</translation>
  </message>
  <message>
   <source>Border</source>
   <translation>Rand</translation>
  </message>
  <message>
   <source>What stays along the border. The more stays, the less is free inside. Automatic: tangents, and the place alone for the membrane</source>
   <translation>Was am Rand bleibt. Je mehr bleibt, desto weniger ist innen frei. Automatisch: die Tangenten, bei der Membran nur der Ort</translation>
  </message>
  <message>
   <source>Automatic</source>
   <translation>Automatisch</translation>
  </message>
  <message>
   <source>G0: stays in place</source>
   <translation>G0: bleibt am Ort</translation>
  </message>
  <message>
   <source>G1: keeps its tangents</source>
   <translation>G1: behält seine Tangenten</translation>
  </message>
  <message>
   <source>G2: keeps its curvature</source>
   <translation>G2: behält seine Krümmung</translation>
  </message>
  <message>
   <source>Energy</source>
   <translation>Energie</translation>
  </message>
  <message>
   <source>What the surface minimises inside its border: a thin plate bends, a membrane stretches as little as possible. Default: Thin plate</source>
   <translation>Was die Fläche innerhalb des Randes klein hält: Eine dünne Platte biegt, eine Membran dehnt sich so wenig wie möglich. Vorgabe: Dünne Platte</translation>
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
   <source>Spans</source>
   <translation>Felder</translation>
  </message>
  <message>
   <source>Splits the face into as many spans along each direction: more spans, more detail. Default: those of the face</source>
   <translation>Teilt die Fläche in so viele Felder je Richtung: mehr Felder, mehr Einzelheiten. Vorgabe: die der Fläche</translation>
  </message>
  <message>
   <source>Auto</source>
   <translation>Auto</translation>
  </message>
  <message>
   <source>Degree</source>
   <translation>Grad</translation>
  </message>
  <message>
   <source>Raises the degree of the face, 3 to 9. Default: that of the face</source>
   <translation>Erhöht den Grad der Fläche, 3 bis 9. Vorgabe: der der Fläche</translation>
  </message>
  <message>
   <source>Result</source>
   <translation>Ergebnis</translation>
  </message>
  <message>
   <source>What the new object holds. Default: the base with the new face, or the face alone where the base has no other</source>
   <translation>Was das neue Objekt enthält. Vorgabe: die Basis mit der neuen Fläche, oder die Fläche allein, wo die Basis keine andere hat</translation>
  </message>
  <message>
   <source>New face</source>
   <translation>Neue Fläche</translation>
  </message>
  <message>
   <source>New face as a shell</source>
   <translation>Neue Fläche als Hülle</translation>
  </message>
  <message>
   <source>Base with the new face in it</source>
   <translation>Basis mit der neuen Fläche darin</translation>
  </message>
  <message>
   <source>Preview</source>
   <translation>Vorschau</translation>
  </message>
  <message>
   <source>Show the surface while choosing</source>
   <translation>Die Fläche beim Auswählen zeigen</translation>
  </message>
  <message>
   <source>Stop</source>
   <translation>Anhalten</translation>
  </message>
  <message>
   <source>Stop computing</source>
   <translation>Die Berechnung anhalten</translation>
  </message>
 </context>
 <context>
  <name>FairingGuidance</name>
  <message>
   <source>Guidance</source>
   <translation>Führung</translation>
  </message>
  <message>
   <source>Normal</source>
   <translation>Normale</translation>
  </message>
  <message>
   <source>Click on the surface: it gets a normal there, as an arrow to drag</source>
   <translation>Auf die Fläche klicken: Sie bekommt dort eine Normale, als Pfeil zum Ziehen</translation>
  </message>
  <message>
   <source>Curve</source>
   <translation>Kurve</translation>
  </message>
  <message>
   <source>Pick edges or sketches in the 3D view: the surface takes a normal along them, that of the faces beside them until another is chosen</source>
   <translation>Kanten oder Skizzen in der 3D-Ansicht anklicken: Die Fläche nimmt entlang von ihnen eine Normale an, die der Flächen daneben, bis eine andere gewählt wird</translation>
  </message>
  <message>
   <source>Reference</source>
   <translation>Vorbild</translation>
  </message>
  <message>
   <source>Pick faces, meshes or whole objects in the 3D view whose normals and points guide the surface</source>
   <translation>Flächen, Netze oder ganze Objekte in der 3D-Ansicht anklicken, deren Normalen und Punkte die Fläche führen</translation>
  </message>
  <message>
   <source>Take the selected guide away</source>
   <translation>Die gewählte Führung wegnehmen</translation>
  </message>
  <message>
   <source>What guides the surface. A selected guide shows its values below</source>
   <translation>Was die Fläche führt. Die gewählte Zeile zeigt ihre Werte darunter</translation>
  </message>
  <message>
   <source>Direction</source>
   <translation>Richtung</translation>
  </message>
  <message>
   <source>Direction of the normal; its length does not matter</source>
   <translation>Richtung der Normalen; ihre Länge ist gleichgültig</translation>
  </message>
  <message>
   <source>From …</source>
   <translation>Von …</translation>
  </message>
  <message>
   <source>Pick a face, an edge or a datum that tells the direction; of a curve, the faces whose normals it takes</source>
   <translation>Eine Fläche, eine Kante oder ein Bezugsobjekt anklicken, das die Richtung angibt; bei einer Kurve die Flächen, deren Normalen sie annimmt</translation>
  </message>
  <message>
   <source>Weight</source>
   <translation>Gewicht</translation>
  </message>
  <message>
   <source>How much this guide counts among the others. Default: 1</source>
   <translation>Wie viel diese Führung neben den anderen zählt. Vorgabe: 1</translation>
  </message>
  <message>
   <source>Radius</source>
   <translation>Radius</translation>
  </message>
  <message>
   <source>Distance over which this guide fades to nothing, a length. Default: a quarter of the surface</source>
   <translation>Abstand, über den diese Führung ganz ausklingt, eine Länge. Vorgabe: ein Viertel der Fläche</translation>
  </message>
  <message>
   <source>Normals λ</source>
   <translation>Normalen λ</translation>
  </message>
  <message>
   <source>How strongly the surface follows the guiding normals; 0 (left): not at all. Begin with 10 to 100. Default: 0</source>
   <translation>Wie stark die Fläche den führenden Normalen folgt; 0 (links): gar nicht. Mit 10 bis 100 beginnen. Vorgabe: 0</translation>
  </message>
  <message>
   <source>Points γ</source>
   <translation>Punkte γ</translation>
  </message>
  <message>
   <source>How strongly the surface is pulled to the points of the reference; 0 (left): not at all. Default: 0</source>
   <translation>Wie stark die Fläche zu den Punkten des Vorbilds gezogen wird; 0 (links): gar nicht. Vorgabe: 0</translation>
  </message>
  <message>
   <source>Field</source>
   <translation>Feld</translation>
  </message>
  <message>
   <source>Show the guiding normals as arrows, the stronger the redder. Default: off</source>
   <translation>Die führenden Normalen als Pfeile zeigen, je stärker, desto röter. Vorgabe: aus</translation>
  </message>
  <message>
   <source>Control net</source>
   <translation>Kontrollnetz</translation>
  </message>
  <message>
   <source>Show the control points of the surface and the net between them. Default: off</source>
   <translation>Die Kontrollpunkte der Fläche und das Netz dazwischen zeigen. Vorgabe: aus</translation>
  </message>
 </context>
 <context>
  <name>Fairing_EditSurface</name>
  <message>
   <source>Edit Surface</source>
   <translation>Fläche umformen</translation>
  </message>
  <message>
   <source>Shape a face anew by normals, curves and other surfaces, its border kept: pick the face</source>
   <translation>Eine Fläche nach Normalen, Kurven und anderen Flächen neu formen, ihr Rand bleibt: die Fläche anklicken</translation>
  </message>
 </context>
 <context>
  <name>FairingPicture</name>
  <message>
   <source>Picture</source>
   <translation>Bild</translation>
  </message>
  <message>
   <source>Curvature</source>
   <translation>Krümmung</translation>
  </message>
  <message>
   <source>No picture</source>
   <translation>Kein Bild</translation>
  </message>
  <message>
   <source>Mean curvature H</source>
   <translation>Mittlere Krümmung H</translation>
  </message>
  <message>
   <source>Gaussian curvature K</source>
   <translation>Gaußsche Krümmung K</translation>
  </message>
  <message>
   <source>Greater principal curvature κ₁</source>
   <translation>Größere Hauptkrümmung κ₁</translation>
  </message>
  <message>
   <source>Smaller principal curvature κ₂</source>
   <translation>Kleinere Hauptkrümmung κ₂</translation>
  </message>
  <message>
   <source>Change of mean curvature |∇H|</source>
   <translation>Änderung der mittleren Krümmung |∇H|</translation>
  </message>
  <message>
   <source>Zebra</source>
   <translation>Zebra</translation>
  </message>
  <message>
   <source>Auto</source>
   <translation>Auto</translation>
  </message>
  <message>
   <source>The unit of both numbers</source>
   <translation>Die Einheit beider Zahlen</translation>
  </message>
  <message>
   <source>Stripes</source>
   <translation>Streifen</translation>
  </message>
  <message>
   <source>Show the curvature of the surface and of its neighbours in colours, or the stripes that light lines leave on a mirror. Curvatures are positive where a face bends towards its normal. Default: No picture</source>
   <translation>Die Krümmung der Fläche und ihrer Nachbarn in Farben zeigen, oder die Streifen, die Lichtlinien auf einem Spiegel hinterlassen. Krümmungen sind positiv, wo eine Fläche sich zu ihrer Normalen hin biegt. Voreinstellung: Kein Bild</translation>
  </message>
  <message>
   <source>Let the colours span what nearly all of the surface has. Default: on</source>
   <translation>Die Farben umfassen, was fast die ganze Fläche hat. Voreinstellung: an</translation>
  </message>
  <message>
   <source>Number of dark and light stripes round the part. Default: 24</source>
   <translation>Zahl der dunklen und hellen Streifen rund um das Teil. Voreinstellung: 24</translation>
  </message>
  <message>
   <source>What the colours stand for</source>
   <translation>Wofür die Farben stehen</translation>
  </message>
  <message>
   <source>What the colour at the left stands for. A number typed in takes the place of the automatic one</source>
   <translation>Wofür die Farbe links steht. Eine eingetippte Zahl tritt an die Stelle der automatischen</translation>
  </message>
  <message>
   <source>What the colour at the right stands for. A number typed in takes the place of the automatic one</source>
   <translation>Wofür die Farbe rechts steht. Eine eingetippte Zahl tritt an die Stelle der automatischen</translation>
  </message>
  <message>
   <source>The values of the surface itself where the mouse rests; text to copy</source>
   <translation>Die Werte der Fläche selbst, wo die Maus ruht; Text zum Kopieren</translation>
  </message>
  <message>
   <source>What is shown. Select other faces or objects to see theirs</source>
   <translation>Was gezeigt wird. Andere Flächen oder Objekte auswählen, um deren Krümmung zu sehen</translation>
  </message>
 </context>
 <context>
  <name>FairingCompare</name>
  <message>
   <source>Compare Energies</source>
   <translation>Energien vergleichen</translation>
  </message>
  <message>
   <source>The same surface with every energy. A click on a row shows it in the 3D view; the least value of a column is bold</source>
   <translation>Dieselbe Fläche mit jeder Energie. Ein Klick auf eine Zeile zeigt sie in der 3D-Ansicht; der kleinste Wert einer Spalte ist fett</translation>
  </message>
  <message>
   <source>Energy</source>
   <translation>Energie</translation>
  </message>
  <message>
   <source>Gap</source>
   <translation>Spalt</translation>
  </message>
  <message>
   <source>Angle</source>
   <translation>Winkel</translation>
  </message>
  <message>
   <source>Curv.</source>
   <translation>Krümm.</translation>
  </message>
  <message>
   <source>Thin plate</source>
   <translation>Dünne Platte</translation>
  </message>
  <message>
   <source>κ₁² + κ₂²</source>
   <translation>κ₁² + κ₂²</translation>
  </message>
  <message>
   <source>|∇H|²</source>
   <translation>|∇H|²</translation>
  </message>
  <message>
   <source>MVS</source>
   <translation>MVS</translation>
  </message>
  <message>
   <source>s</source>
   <translation>s</translation>
  </message>
  <message>
   <source>What the surface minimises. The sign tells whether it meets its neighbours within the tolerances</source>
   <translation>Was die Fläche minimiert. Das Zeichen sagt, ob sie ihre Nachbarn innerhalb der Toleranzen trifft</translation>
  </message>
  <message>
   <source>Largest distance of an edge from the surface</source>
   <translation>Größter Abstand einer Kante von der Fläche</translation>
  </message>
  <message>
   <source>Largest angle to the neighbouring faces</source>
   <translation>Größter Winkel zu den Nachbarflächen</translation>
  </message>
  <message>
   <source>Largest relative difference of the curvatures across edges that are to be met in G2</source>
   <translation>Größter relativer Unterschied der Krümmungen quer zu Kanten, die mit G2 getroffen werden sollen</translation>
  </message>
  <message>
   <source>Integral over the parameters of |R_uu|² + 2 |R_uv|² + |R_vv|², mm²</source>
   <translation>Integral über die Parameter von |R_uu|² + 2 |R_uv|² + |R_vv|², mm²</translation>
  </message>
  <message>
   <source>Total curvature: integral of κ₁² + κ₂² over the surface</source>
   <translation>Gesamtkrümmung: Integral von κ₁² + κ₂² über die Fläche</translation>
  </message>
  <message>
   <source>Integral of the squared change of mean curvature over the surface, 1/mm²</source>
   <translation>Integral der quadrierten Änderung der mittleren Krümmung über die Fläche, 1/mm²</translation>
  </message>
  <message>
   <source>Minimum variation: integral of the squared changes of the principal curvatures along their own lines, 1/mm²</source>
   <translation>Minimale Variation: Integral der quadrierten Änderungen der Hauptkrümmungen entlang ihrer eigenen Linien, 1/mm²</translation>
  </message>
  <message>
   <source>Seconds it took</source>
   <translation>Sekunden, die es dauerte</translation>
  </message>
  <message>
   <source>The surfaces are being computed</source>
   <translation>Die Flächen werden berechnet</translation>
  </message>
  <message>
   <source>Stop</source>
   <translation>Anhalten</translation>
  </message>
  <message>
   <source>Stop computing; what is there stays</source>
   <translation>Die Berechnung anhalten; was da ist, bleibt</translation>
  </message>
  <message>
   <source>Use</source>
   <translation>Nehmen</translation>
  </message>
  <message>
   <source>Take the energy of the selected row</source>
   <translation>Die Energie der ausgewählten Zeile nehmen</translation>
  </message>
  <message>
   <source>Close</source>
   <translation>Schließen</translation>
  </message>
  <message>
   <source>Keep the energy as it is</source>
   <translation>Die Energie lassen, wie sie ist</translation>
  </message>
 </context>
 <context>
  <name>Fairing_CurvaturePicture</name>
  <message>
   <source>Curvature Picture</source>
   <translation>Krümmungsbild</translation>
  </message>
  <message>
   <source>Show the curvature of faces in colours, or the stripes that light lines leave on them, and read its values: select faces or objects, or nothing for all that is visible</source>
   <translation>Die Krümmung von Flächen in Farben zeigen, oder die Streifen, die Lichtlinien auf ihnen hinterlassen, und ihre Werte ablesen: Flächen oder Objekte auswählen, oder nichts für alles Sichtbare</translation>
  </message>
 </context>
</TS>
