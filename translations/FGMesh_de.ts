<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
  <context>
    <name>FGMesh</name>
    <message>
      <source>0 on the first reference, 1 on the second</source>
      <translation>0 an der ersten Referenz, 1 an der zweiten</translation>
    </message>
    <message>
      <source>1 at the frame's origin; falls by e within 1/alpha</source>
      <translation>1 im Ursprung des Bezugssystems; fällt je 1/alpha auf den e-ten Teil</translation>
    </message>
    <message>
      <source>1 at the low end of the frame's z axis; falls by e within 1/alpha</source>
      <translation>1 am unteren Ende der z-Achse des Bezugssystems; fällt je 1/alpha auf den e-ten Teil</translation>
    </message>
    <message>
      <source>1 on the reference; falls by e within the depth</source>
      <translation>1 an der Referenz; fällt innerhalb der Tiefe auf den e-ten Teil</translation>
    </message>
    <message>
      <source>; a volume fraction must stay between 0 and 1</source>
      <translation>; ein Volumenanteil muss zwischen 0 und 1 bleiben</translation>
    </message>
    <message>
      <source>; not defined in {} % of it</source>
      <translation>; in {} % davon nicht definiert</translation>
    </message>
    <message>
      <source>; only {} MB of memory are free</source>
      <translation>; nur {} MB Speicher sind frei</translation>
    </message>
    <message>
      <source>; that takes about {}</source>
      <translation>; das dauert etwa {}</translation>
    </message>
    <message>
      <source>; this stage about {} more</source>
      <translation>; diese Stufe noch etwa {}</translation>
    </message>
    <message>
      <source>A material of FreeCAD or of the document, or any other name; only an analysis needs a material of that name</source>
      <translation>Ein Material von FreeCAD oder des Dokuments oder ein beliebiger anderer Name; nur eine Analyse braucht ein Material dieses Namens</translation>
    </message>
    <message>
      <source>A parameter has no name: write one beside its value {}, or remove it</source>
      <translation>Ein Parameter hat keinen Namen: Schreiben Sie einen neben seinen Wert {}, oder entfernen Sie ihn</translation>
    </message>
    <message>
      <source>A smooth step from 0 to 1 in the middle, over the width</source>
      <translation>Eine glatte Stufe von 0 nach 1 in der Mitte, über die Breite</translation>
    </message>
    <message>
      <source>Add</source>
      <translation>Hinzufügen</translation>
    </message>
    <message>
      <source>Add ...</source>
      <translation>Hinzufügen ...</translation>
    </message>
    <message>
      <source>Adds an entry at the end</source>
      <translation>Fügt am Ende einen Eintrag hinzu</translation>
    </message>
    <message>
      <source>Allowed error</source>
      <translation>Erlaubter Fehler</translation>
    </message>
    <message>
      <source>Analysis</source>
      <translation>Analyse</translation>
    </message>
    <message>
      <source>Analysis of {}</source>
      <translation>Analyse von {}</translation>
    </message>
    <message>
      <source>Anisotropy</source>
      <translation>Anisotropie</translation>
    </message>
    <message>
      <source>Anisotropy {}</source>
      <translation>Anisotropie {}</translation>
    </message>
    <message>
      <source>As the linear one, to the power n</source>
      <translation>Wie linear, hoch n</translation>
    </message>
    <message>
      <source>Ball, exponential about its centre (case study I)</source>
      <translation>Kugel, exponentiell um die Mitte (Fallstudie I)</translation>
    </message>
    <message>
      <source>Beam, steel below and aluminium above, for analysis</source>
      <translation>Balken, unten Stahl und oben Aluminium, für die Analyse</translation>
    </message>
    <message>
      <source>Bins</source>
      <translation>Klassen</translation>
    </message>
    <message>
      <source>Bins: elements of nearly the same properties share a material. Continuous: properties vary inside the elements, for two constituents</source>
      <translation>Klassen: Elemente mit fast gleichen Eigenschaften teilen sich ein Material. Stetig: die Eigenschaften ändern sich im Inneren der Elemente, bei zwei Bestandteilen</translation>
    </message>
    <message>
      <source>Bins: elements share materials</source>
      <translation>Klassen: je ein Material</translation>
    </message>
    <message>
      <source>Bracket, from one face to another</source>
      <translation>Winkel, von einer Fläche zur anderen</translation>
    </message>
    <message>
      <source>CSV files: a header such as r, z, value, then a row for each sample; the rows fill a grid</source>
      <translation>CSV-Dateien: eine Kopfzeile wie r, z, value, dann eine Zeile je Stützstelle; die Zeilen füllen ein Gitter</translation>
    </message>
    <message>
      <source>Cancel</source>
      <translation>Abbrechen</translation>
    </message>
    <message>
      <source>Click ...</source>
      <translation>Klicken ...</translation>
    </message>
    <message>
      <source>Click on d{} ...</source>
      <translation>d{} anklicken ...</translation>
    </message>
    <message>
      <source>Colours of the composition</source>
      <translation>Farben der Zusammensetzung</translation>
    </message>
    <message>
      <source>Colours the solid in the 3D view</source>
      <translation>Färbt den Festkörper in der 3D-Ansicht</translation>
    </message>
    <message>
      <source>Constituent {}</source>
      <translation>Bestandteil {}</translation>
    </message>
    <message>
      <source>Constituent {} has no material: choose one, or clear the others</source>
      <translation>Bestandteil {} hat kein Material: Wählen Sie eines, oder leeren Sie die anderen</translation>
    </message>
    <message>
      <source>Continuous: inside elements, too</source>
      <translation>Stetig: auch in Elementen</translation>
    </message>
    <message>
      <source>Create graded analysis</source>
      <translation>Gradierte Analyse anlegen</translation>
    </message>
    <message>
      <source>Cut</source>
      <translation>Schnitt</translation>
    </message>
    <message>
      <source>Cuts it open across this axis</source>
      <translation>Schneidet quer zu dieser Achse auf</translation>
    </message>
    <message>
      <source>Cylinder, power law along its axis (case study II)</source>
      <translation>Zylinder, Potenzgesetz längs der Achse (Fallstudie II)</translation>
    </message>
    <message>
      <source>Dihedral angle, degrees</source>
      <translation>Diederwinkel in Grad</translation>
    </message>
    <message>
      <source>Dihedral angles</source>
      <translation>Diederwinkel</translation>
    </message>
    <message>
      <source>Direction of the frame's z axis: x, y, z</source>
      <translation>Richtung der z-Achse des Bezugssystems: x, y, z</translation>
    </message>
    <message>
      <source>Drag in the view</source>
      <translation>In der Ansicht ziehen</translation>
    </message>
    <message>
      <source>Examples</source>
      <translation>Beispiele</translation>
    </message>
    <message>
      <source>Expected: ...</source>
      <translation>Erwartet: ...</translation>
    </message>
    <message>
      <source>Expected: about {} tetrahedra, {} MB</source>
      <translation>Erwartet: etwa {} Tetraeder, {} MB</translation>
    </message>
    <message>
      <source>Exponential about a point</source>
      <translation>Exponentiell um einen Punkt</translation>
    </message>
    <message>
      <source>Exponential along z</source>
      <translation>Exponentiell längs z</translation>
    </message>
    <message>
      <source>FGMesh</source>
      <translation>FGMesh</translation>
    </message>
    <message>
      <source>Fields on the results</source>
      <translation>Felder auf den Ergebnissen</translation>
    </message>
    <message>
      <source>Figures, histograms and the worst tetrahedra of the mesh</source>
      <translation>Zahlen, Histogramme und die schlechtesten Tetraeder des Netzes</translation>
    </message>
    <message>
      <source>Fraction</source>
      <translation>Volumenanteil</translation>
    </message>
    <message>
      <source>Frame of x y z r theta d</source>
      <translation>Bezugssystem für x y z r theta d</translation>
    </message>
    <message>
      <source>From 0 at the frame's origin to 1 at the radius</source>
      <translation>Von 0 im Ursprung des Bezugssystems bis 1 am Radius</translation>
    </message>
    <message>
      <source>From 0 at the low end to 1 at the high end of the frame's x axis</source>
      <translation>Von 0 am unteren bis 1 am oberen Ende der x-Achse des Bezugssystems</translation>
    </message>
    <message>
      <source>From 0 at the low end to 1 at the high end of the frame's y axis</source>
      <translation>Von 0 am unteren bis 1 am oberen Ende der y-Achse des Bezugssystems</translation>
    </message>
    <message>
      <source>From 0 at the low end to 1 at the high end of the frame's z axis</source>
      <translation>Von 0 am unteren bis 1 am oberen Ende der z-Achse des Bezugssystems</translation>
    </message>
    <message>
      <source>From 0 on the frame's z axis to 1 at the radius</source>
      <translation>Von 0 auf der z-Achse des Bezugssystems bis 1 am Radius</translation>
    </message>
    <message>
      <source>From face A to face B</source>
      <translation>Von Fläche A zu Fläche B</translation>
    </message>
    <message>
      <source>Graded material</source>
      <translation>Gradiertes Material</translation>
    </message>
    <message>
      <source>Graded material of {}</source>
      <translation>Gradientenwerkstoff von {}</translation>
    </message>
    <message>
      <source>Groups</source>
      <translation>Gruppen</translation>
    </message>
    <message>
      <source>Help</source>
      <translation>Hilfe</translation>
    </message>
    <message>
      <source>Histogram</source>
      <translation>Histogramm</translation>
    </message>
    <message>
      <source>How far a property may be from that of its bin: there are as many bins as this needs; 0: as Bins says</source>
      <translation>Wie weit eine Eigenschaft von der ihrer Klasse abweichen darf: es gibt so viele Klassen, wie dafür nötig sind; 0: wie unter Klassen angegeben</translation>
    </message>
    <message>
      <source>How many times longer elements may be across the gradient than along it; 1: isotropic</source>
      <translation>Wie viele Male länger Elemente quer zum Gradienten sein dürfen als längs; 1: isotrop</translation>
    </message>
    <message>
      <source>How the property of a mixture follows from those of its constituents: a law of the list, or a formula over the fractions v1 v2 ... and the constituents' values p1 p2 ...; empty: the usual law</source>
      <translation>Wie die Eigenschaft einer Mischung aus denen der Bestandteile folgt: ein Gesetz der Liste oder eine Formel aus den Anteilen v1 v2 ... und den Werten p1 p2 ... der Bestandteile; leer: das übliche Gesetz</translation>
    </message>
    <message>
      <source>In the view</source>
      <translation>In der Ansicht</translation>
    </message>
    <message>
      <source>Is</source>
      <translation>Ergibt</translation>
    </message>
    <message>
      <source>Keep to the paper's own loop, which takes more elements and leaves flat ones; for comparisons</source>
      <translation>Die Schleife des Aufsatzes selbst, die mehr Elemente braucht und flache übrig lässt; für Vergleiche</translation>
    </message>
    <message>
      <source>Largest difference of composition allowed inside one tetrahedron, above 0 and at most 1</source>
      <translation>Größter zulässiger Unterschied der Zusammensetzung innerhalb eines Tetraeders, über 0 und höchstens 1</translation>
    </message>
    <message>
      <source>Largest distance of the mesh's boundary to the true one; 0: the part's diagonal / 2000, or less where the volume would be more than 0.5 % off</source>
      <translation>Größter Abstand der Netzoberfläche von der wahren; 0: Diagonale des Teils / 2000, oder weniger, wo das Volumen um mehr als 0,5 % abwiche</translation>
    </message>
    <message>
      <source>Largest size</source>
      <translation>Max. Elementgröße</translation>
    </message>
    <message>
      <source>Largest size {}</source>
      <translation>Größte Kantenlänge {}</translation>
    </message>
    <message>
      <source>Largest variation</source>
      <translation>Größte Variation</translation>
    </message>
    <message>
      <source>Layer below a face</source>
      <translation>Schicht unter einer Fläche</translation>
    </message>
    <message>
      <source>Linear along x</source>
      <translation>Linear längs x</translation>
    </message>
    <message>
      <source>Linear along y</source>
      <translation>Linear längs y</translation>
    </message>
    <message>
      <source>Linear along z</source>
      <translation>Linear längs z</translation>
    </message>
    <message>
      <source>Make {} a parameter</source>
      <translation>{} zum Parameter machen</translation>
    </message>
    <message>
      <source>Material of {}</source>
      <translation>Material von {}</translation>
    </message>
    <message>
      <source>Material threshold</source>
      <translation>Materialschwelle</translation>
    </message>
    <message>
      <source>Material threshold {}</source>
      <translation>Materialschwelle {}</translation>
    </message>
    <message>
      <source>Materials: {}, properties within {} % of the mixtures</source>
      <translation>Materialien: {}, Eigenschaften bis auf {} % die der Mischungen</translation>
    </message>
    <message>
      <source>Mesh</source>
      <translation>Vernetzen</translation>
    </message>
    <message>
      <source>Mesh again ...</source>
      <translation>Neu vernetzen ...</translation>
    </message>
    <message>
      <source>Mesh graded solid</source>
      <translation>Gradierten Festkörper vernetzen</translation>
    </message>
    <message>
      <source>Mesh of {}</source>
      <translation>Netz von {}</translation>
    </message>
    <message>
      <source>Meshes in the background; one undo takes the mesh back</source>
      <translation>Vernetzt im Hintergrund; ein Rückgängig nimmt das Netz zurück</translation>
    </message>
    <message>
      <source>Mixing laws</source>
      <translation>Mischungsregeln</translation>
    </message>
    <message>
      <source>New analysis</source>
      <translation>Neue Analyse</translation>
    </message>
    <message>
      <source>No edge is longer than this; 0: about the part's diagonal / 8</source>
      <translation>Keine Kante ist länger; 0: etwa Diagonale des Teils / 8</translation>
    </message>
    <message>
      <source>No refinement makes edges shorter than this; 0: the part's diagonal / 2000</source>
      <translation>Keine Verfeinerung macht Kanten kürzer; 0: Diagonale des Teils / 2000</translation>
    </message>
    <message>
      <source>Nothing was changed: {}</source>
      <translation>Nichts wurde geändert: {}</translation>
    </message>
    <message>
      <source>Of {} tetrahedra {} break the threshold, at or between their corners; {} are not proved</source>
      <translation>Von {} Tetraedern überschreiten {} die Schwelle, an oder zwischen ihren Ecken; für {} ist nichts bewiesen</translation>
    </message>
    <message>
      <source>On the solid: {}</source>
      <translation>Im Festkörper: {}</translation>
    </message>
    <message>
      <source>One constituent more, and a formula for the one that was the last</source>
      <translation>Ein Bestandteil mehr, und eine Formel für den bisher letzten</translation>
    </message>
    <message>
      <source>Open</source>
      <translation>Öffnen</translation>
    </message>
    <message>
      <source>Origin</source>
      <translation>Ursprung</translation>
    </message>
    <message>
      <source>Origin and z axis of the frame take three numbers each, as in 0, 0, 1, and the axis not three zeros</source>
      <translation>Ursprung und z-Achse des Bezugssystems brauchen je drei Zahlen, etwa 0, 0, 1, und die Achse nicht drei Nullen</translation>
    </message>
    <message>
      <source>Origin of the frame in the solid's own coordinates: x, y, z, with or without units, as in 0, 0, 1 in</source>
      <translation>Ursprung des Bezugssystems in den eigenen Koordinaten des Körpers: x, y, z, mit oder ohne Einheit, wie in 0, 0, 1 in</translation>
    </message>
    <message>
      <source>Parameter</source>
      <translation>Parameter</translation>
    </message>
    <message>
      <source>Pick</source>
      <translation>Wählen</translation>
    </message>
    <message>
      <source>Pictures (*.png *.svg *.pdf)</source>
      <translation>Bilder (*.png *.svg *.pdf)</translation>
    </message>
    <message>
      <source>Pin in a plate, two solids with a material each</source>
      <translation>Stift in einer Platte, zwei Festkörper mit je einem Material</translation>
    </message>
    <message>
      <source>Pin, hardened, by a table of measured values</source>
      <translation>Stift, gehärtet, nach einer Tabelle gemessener Werte</translation>
    </message>
    <message>
      <source>Plain</source>
      <translation>Schlicht</translation>
    </message>
    <message>
      <source>Poisson's ratio</source>
      <translation>Querkontraktionszahl</translation>
    </message>
    <message>
      <source>Power law along z</source>
      <translation>Potenzgesetz längs z</translation>
    </message>
    <message>
      <source>Preview</source>
      <translation>Vorschau</translation>
    </message>
    <message>
      <source>Processors to use at most, 0 for all; the mesh does not depend on it</source>
      <translation>Höchstens zu nutzende Prozessoren, 0 für alle; das Netz hängt nicht davon ab</translation>
    </message>
    <message>
      <source>Properties</source>
      <translation>Eigenschaften</translation>
    </message>
    <message>
      <source>Properties vary inside the elements</source>
      <translation>Die Eigenschaften ändern sich innerhalb der Elemente</translation>
    </message>
    <message>
      <source>Prove the threshold between corners</source>
      <translation>Schwelle zwischen den Ecken beweisen</translation>
    </message>
    <message>
      <source>Prove the threshold over the whole of each tetrahedron, not at its corners alone, and split those that break it in between</source>
      <translation>Die Schwelle für jedes ganze Tetraeder beweisen, nicht nur an seinen Ecken, und die teilen, die sie dazwischen überschreiten</translation>
    </message>
    <message>
      <source>Proved over the whole of each tetrahedron: the variation is at most {}</source>
      <translation>Für jedes ganze Tetraeder bewiesen: Die Variation ist höchstens {}</translation>
    </message>
    <message>
      <source>Radial</source>
      <translation>Radial</translation>
    </message>
    <message>
      <source>Ready gradings ...</source>
      <translation>Fertige Verläufe ...</translation>
    </message>
    <message>
      <source>References of d1 d2 ...</source>
      <translation>Referenzen für d1 d2 ...</translation>
    </message>
    <message>
      <source>Remove</source>
      <translation>Entfernen</translation>
    </message>
    <message>
      <source>Removes the selected entry, or else the last one</source>
      <translation>Entfernt den ausgewählten Eintrag, sonst den letzten</translation>
    </message>
    <message>
      <source>Report ...</source>
      <translation>Bericht ...</translation>
    </message>
    <message>
      <source>Report of {}</source>
      <translation>Bericht zu {}</translation>
    </message>
    <message>
      <source>Reset</source>
      <translation>Zurücksetzen</translation>
    </message>
    <message>
      <source>Run</source>
      <translation>Lauf</translation>
    </message>
    <message>
      <source>Sampled tables</source>
      <translation>Wertetabellen</translation>
    </message>
    <message>
      <source>Save</source>
      <translation>Speichern</translation>
    </message>
    <message>
      <source>Save picture ...</source>
      <translation>Bild speichern ...</translation>
    </message>
    <message>
      <source>Save table ...</source>
      <translation>Tabelle speichern ...</translation>
    </message>
    <message>
      <source>Section</source>
      <translation>Schnitt</translation>
    </message>
    <message>
      <source>Set graded material</source>
      <translation>Gradientenwerkstoff zuweisen</translation>
    </message>
    <message>
      <source>Sets the field above so that the mesh gets fewer tetrahedra</source>
      <translation>Setzt das Feld oben so, dass das Netz weniger Tetraeder bekommt</translation>
    </message>
    <message>
      <source>Shifts the cut along its axis</source>
      <translation>Verschiebt den Schnitt entlang seiner Achse</translation>
    </message>
    <message>
      <source>Show</source>
      <translation>Zeigen</translation>
    </message>
    <message>
      <source>Show the material</source>
      <translation>Material zeigen</translation>
    </message>
    <message>
      <source>Shows a handle by which the mouse shifts and turns the cut</source>
      <translation>Zeigt einen Griff, mit dem die Maus den Schnitt verschiebt und dreht</translation>
    </message>
    <message>
      <source>Sigmoid layer across z</source>
      <translation>Sigmoide Schicht quer zu z</translation>
    </message>
    <message>
      <source>Smallest angles</source>
      <translation>Kleinste Winkel</translation>
    </message>
    <message>
      <source>Smallest size</source>
      <translation>Min. Elementgröße</translation>
    </message>
    <message>
      <source>Spherical</source>
      <translation>Kugelförmig</translation>
    </message>
    <message>
      <source>Start of the random numbers; the same seed, the same mesh</source>
      <translation>Anfang der Zufallszahlen; gleicher Anfang, gleiches Netz</translation>
    </message>
    <message>
      <source>Stops the run; the mesh stays as it was</source>
      <translation>Bricht den Lauf ab; das Netz bleibt, wie es war</translation>
    </message>
    <message>
      <source>Surface deviation</source>
      <translation>Flächenabweichung</translation>
    </message>
    <message>
      <source>Surface deviation {}</source>
      <translation>Oberflächenabweichung {}</translation>
    </message>
    <message>
      <source>Tables (*.csv *.txt *.dat *.tsv);;All files (*)</source>
      <translation>Tabellen (*.csv *.txt *.dat *.tsv);;Alle Dateien (*)</translation>
    </message>
    <message>
      <source>Tables (*.csv)</source>
      <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
      <source>Tables of t1 t2 ...</source>
      <translation>Tabellen für t1 t2 ...</translation>
    </message>
    <message>
      <source>Takes the last constituent away</source>
      <translation>Nimmt den letzten Bestandteil weg</translation>
    </message>
    <message>
      <source>Ten-node tetrahedra</source>
      <translation>Zehnknotige Tetraeder</translation>
    </message>
    <message>
      <source>Ten-node tetrahedra in place of four-node ones, with nodes on the true faces and edges</source>
      <translation>Zehnknotige statt vierknotiger Tetraeder, mit Knoten auf den wahren Flächen und Kanten</translation>
    </message>
    <message>
      <source>The analysis that the mesh and its materials are put into: a new one, or one that has no mesh yet</source>
      <translation>Die Analyse, in die das Netz und seine Materialien kommen: eine neue oder eine, die noch kein Netz hat</translation>
    </message>
    <message>
      <source>The formula is not defined anywhere on the solid</source>
      <translation>Die Formel ist nirgends im Festkörper definiert</translation>
    </message>
    <message>
      <source>The last of the three stages to run</source>
      <translation>Die letzte der drei Stufen, die läuft</translation>
    </message>
    <message>
      <source>The mesh gets a group of elements for each of these parts of the shape</source>
      <translation>Das Netz bekommt eine Elementgruppe für jeden dieser Teile der Form</translation>
    </message>
    <message>
      <source>The most materials that the elements may share</source>
      <translation>Wie viele Materialien sich die Elemente höchstens teilen</translation>
    </message>
    <message>
      <source>The solid is being triangulated</source>
      <translation>Der Körper wird in Dreiecke zerlegt</translation>
    </message>
    <message>
      <source>The solid's own coordinates</source>
      <translation>Die eigenen Koordinaten des Festkörpers</translation>
    </message>
    <message>
      <source>The threshold is not proved between the corners of tetrahedra</source>
      <translation>Die Schwelle ist zwischen den Ecken der Tetraeder nicht bewiesen</translation>
    </message>
    <message>
      <source>Then click on a face, an edge or a vertex in the 3D view, or on a solid in the tree</source>
      <translation>Klicken Sie dann auf eine Fläche, eine Kante oder einen Eckpunkt in der 3D-Ansicht oder auf einen Festkörper im Baum</translation>
    </message>
    <message>
      <source>Then click on a face, an edge, a vertex, a datum or a coordinate system: the frame stands there, its z axis along the normal or the axis</source>
      <translation>Klicken Sie dann auf eine Fläche, eine Kante, einen Eckpunkt, ein Bezugselement oder ein Koordinatensystem: Dort steht das Bezugssystem, seine z-Achse längs der Normalen oder der Achse</translation>
    </message>
    <message>
      <source>There are no results yet: solve the analysis first</source>
      <translation>Es gibt noch keine Ergebnisse: zuerst die Analyse lösen</translation>
    </message>
    <message>
      <source>There is no material card and no material object called {}: a mesh needs none, an analysis does</source>
      <translation>Es gibt weder eine Materialkarte noch ein Materialobjekt namens {}: ein Netz braucht keines, eine Analyse schon</translation>
    </message>
    <message>
      <source>Two parameters are called {}: rename or remove one</source>
      <translation>Zwei Parameter heißen {}: Benennen Sie einen um, oder entfernen Sie ihn</translation>
    </message>
    <message>
      <source>Value</source>
      <translation>Wert</translation>
    </message>
    <message>
      <source>Values are numbers (0.08), numbers with units (2 cm) or expressions of FreeCAD (Height/2, Spreadsheet.alpha), which then drive the parameter</source>
      <translation>Werte sind Zahlen (0.08), Zahlen mit Einheiten (2 cm) oder Ausdrücke von FreeCAD (Height/2, Spreadsheet.alpha), denen der Parameter dann folgt</translation>
    </message>
    <message>
      <source>Variation of composition</source>
      <translation>Variation der Zusammensetzung</translation>
    </message>
    <message>
      <source>Variation of composition in a tetrahedron</source>
      <translation>Variation im Tetraeder</translation>
    </message>
    <message>
      <source>Volume fraction of constituent {}</source>
      <translation>Volumenanteil von Bestandteil {}</translation>
    </message>
    <message>
      <source>Volume fraction, 0 to 1, over x y z r theta d (mm, radians, in the material's frame), the parameters, d1 d2 ..., the distances to the references, and t1 t2 ..., the values of the tables; the last constituent is what the others leave</source>
      <translation>Volumenanteil, 0 bis 1, aus x y z r theta d (mm, Bogenmaß, im Bezugssystem des Materials), den Parametern, d1 d2 ..., den Abständen zu den Referenzen, und t1 t2 ..., den Werten der Tabellen; der letzte Bestandteil ist, was die anderen übrig lassen</translation>
    </message>
    <message>
      <source>What the colours tell: a volume fraction, or a property of the mixture</source>
      <translation>Was die Farben zeigen: einen Volumenanteil oder eine Eigenschaft der Mischung</translation>
    </message>
    <message>
      <source>What the histogram below counts in the tetrahedra</source>
      <translation>Was das Histogramm unten an den Tetraedern zählt</translation>
    </message>
    <message>
      <source>What the mesh shows in the 3D view: its composition, or its worst tetrahedra</source>
      <translation>Was das Netz in der 3D-Ansicht zeigt: seine Zusammensetzung oder seine schlechtesten Tetraeder</translation>
    </message>
    <message>
      <source>Write a formula, or choose a ready grading above</source>
      <translation>Schreiben Sie eine Formel, oder wählen Sie oben einen fertigen Verlauf</translation>
    </message>
    <message>
      <source>Writes the figures of the stages as a table that spreadsheets read</source>
      <translation>Schreibt die Zahlen der Stufen als Tabelle, die Tabellenkalkulationen lesen</translation>
    </message>
    <message>
      <source>Writes the histogram that is shown as a picture</source>
      <translation>Schreibt das gezeigte Histogramm als Bild</translation>
    </message>
    <message>
      <source>Young's modulus</source>
      <translation>Elastizitätsmodul</translation>
    </message>
    <message>
      <source>above threshold</source>
      <translation>über Schwelle</translation>
    </message>
    <message>
      <source>above {}</source>
      <translation>über {}</translation>
    </message>
    <message>
      <source>angle max</source>
      <translation>Winkel max</translation>
    </message>
    <message>
      <source>angle min</source>
      <translation>Winkel min</translation>
    </message>
    <message>
      <source>as Bins says</source>
      <translation>wie Klassen sagt</translation>
    </message>
    <message>
      <source>automatic</source>
      <translation>automatisch</translation>
    </message>
    <message>
      <source>below {}</source>
      <translation>unter {}</translation>
    </message>
    <message>
      <source>d1 is the distance to the first of them, d2 to the second, and so on</source>
      <translation>d1 ist der Abstand zur ersten, d2 zur zweiten und so weiter</translation>
    </message>
    <message>
      <source>density</source>
      <translation>Dichte</translation>
    </message>
    <message>
      <source>edges</source>
      <translation>Kanten</translation>
    </message>
    <message>
      <source>faces</source>
      <translation>Flächen</translation>
    </message>
    <message>
      <source>facets</source>
      <translation>Facetten</translation>
    </message>
    <message>
      <source>fraction of constituent {}</source>
      <translation>Anteil von Bestandteil {}</translation>
    </message>
    <message>
      <source>fraction of {}</source>
      <translation>Anteil von {}</translation>
    </message>
    <message>
      <source>geometry</source>
      <translation>Geometrie</translation>
    </message>
    <message>
      <source>geometry-oriented refinement</source>
      <translation>Verfeinerung nach der Geometrie</translation>
    </message>
    <message>
      <source>initial</source>
      <translation>Anfang</translation>
    </message>
    <message>
      <source>initial mesh</source>
      <translation>Anfangsnetz</translation>
    </message>
    <message>
      <source>last bar: all above</source>
      <translation>letzter Balken: alle darüber</translation>
    </message>
    <message>
      <source>material</source>
      <translation>Material</translation>
    </message>
    <message>
      <source>material-oriented refinement</source>
      <translation>Verfeinerung nach dem Material</translation>
    </message>
    <message>
      <source>mean {mean:.4f}
max {max:.4f}</source>
      <translation>Mittel {mean:.4f}
max {max:.4f}</translation>
    </message>
    <message>
      <source>measuring references</source>
      <translation>Messen der Referenzen</translation>
    </message>
    <message>
      <source>no value</source>
      <translation>kein Wert</translation>
    </message>
    <message>
      <source>nodes in the middle of edges</source>
      <translation>Knoten in den Kantenmitten</translation>
    </message>
    <message>
      <source>points</source>
      <translation>Punkte</translation>
    </message>
    <message>
      <source>proof between the corners</source>
      <translation>Nachweis zwischen den Ecken</translation>
    </message>
    <message>
      <source>reading the shape</source>
      <translation>Lesen der Form</translation>
    </message>
    <message>
      <source>seconds</source>
      <translation>Sekunden</translation>
    </message>
    <message>
      <source>share of angles</source>
      <translation>Anteil der Winkel</translation>
    </message>
    <message>
      <source>share of tetrahedra</source>
      <translation>Anteil der Tetraeder</translation>
    </message>
    <message>
      <source>solids</source>
      <translation>Festkörper</translation>
    </message>
    <message>
      <source>specific heat</source>
      <translation>Spezifische Wärme</translation>
    </message>
    <message>
      <source>starting</source>
      <translation>Start</translation>
    </message>
    <message>
      <source>t1 is the value of the first of them at a point, t2 of the second, and so on</source>
      <translation>t1 ist der Wert der ersten an einem Punkt, t2 der der zweiten und so weiter</translation>
    </message>
    <message>
      <source>taking the mesh into the document</source>
      <translation>Übernahme des Netzes in das Dokument</translation>
    </message>
    <message>
      <source>tetrahedra</source>
      <translation>Tetraeder</translation>
    </message>
    <message>
      <source>thermal conductivity</source>
      <translation>Wärmeleitfähigkeit</translation>
    </message>
    <message>
      <source>thermal expansion</source>
      <translation>Wärmeausdehnung</translation>
    </message>
    <message>
      <source>threshold</source>
      <translation>Schwelle</translation>
    </message>
    <message>
      <source>usual: {}</source>
      <translation>üblich: {}</translation>
    </message>
    <message>
      <source>variation max</source>
      <translation>Variation max</translation>
    </message>
    <message>
      <source>variation mean</source>
      <translation>Variation Mittel</translation>
    </message>
    <message>
      <source>variation min</source>
      <translation>Variation min</translation>
    </message>
    <message>
      <source>vertices</source>
      <translation>Eckpunkte</translation>
    </message>
    <message>
      <source>volume fraction</source>
      <translation>Volumenanteil</translation>
    </message>
    <message>
      <source>whole</source>
      <translation>ganz</translation>
    </message>
    <message>
      <source>yield strength</source>
      <translation>Streckgrenze</translation>
    </message>
    <message>
      <source>z axis</source>
      <translation>z-Achse</translation>
    </message>
    <message>
      <source>{} has lost its solid: set its Shape to a graded solid</source>
      <translation>{} hat seinen Festkörper verloren: Setzen Sie Shape auf einen gradierten Festkörper</translation>
    </message>
    <message>
      <source>{} has no graded material yet. Give it one now?</source>
      <translation>{} hat noch kein gradiertes Material. Jetzt eines zuweisen?</translation>
    </message>
    <message>
      <source>{} is not meshed yet: mesh it first</source>
      <translation>{} ist noch nicht vernetzt: bitte zuerst vernetzen</translation>
    </message>
    <message>
      <source>{} so far</source>
      <translation>bisher {}</translation>
    </message>
    <message>
      <source>{} tetrahedra, variation up to {}, angles from {} to {} degrees</source>
      <translation>{} Tetraeder, Variation bis {}, Winkel von {} bis {} Grad</translation>
    </message>
    <message>
      <source>{} to {}</source>
      <translation>{} bis {}</translation>
    </message>
    <message>
      <source>{}: about {}</source>
      <translation>{}: etwa {}</translation>
    </message>
    <message>
      <source>{}: {} is no length; write for example 0.5 mm</source>
      <translation>{}: {} ist keine Länge; schreiben Sie zum Beispiel 0,5 mm</translation>
    </message>
    <message>
      <source>{}: {} tetrahedra</source>
      <translation>{}: {} Tetraeder</translation>
    </message>
  </context>
  <context>
    <name>FGMeshPreferences</name>
    <message>
      <source> MB</source>
      <translation> MB</translation>
    </message>
    <message>
      <source>General</source>
      <translation>Allgemein</translation>
    </message>
    <message>
      <source>Largest difference of composition inside one tetrahedron</source>
      <translation>Größter Unterschied der Zusammensetzung innerhalb eines Tetraeders</translation>
    </message>
    <message>
      <source>Material threshold</source>
      <translation>Materialschwelle</translation>
    </message>
    <message>
      <source>Memory limit</source>
      <translation>Speichergrenze</translation>
    </message>
    <message>
      <source>Meshing runs</source>
      <translation>Vernetzungsläufe</translation>
    </message>
    <message>
      <source>New meshes</source>
      <translation>Neue Netze</translation>
    </message>
    <message>
      <source>Preview</source>
      <translation>Vorschau</translation>
    </message>
    <message>
      <source>Shown as soon as the panel of a material opens</source>
      <translation>Zu sehen, sobald der Dialog eines Materials aufgeht</translation>
    </message>
    <message>
      <source>Ten-node tetrahedra</source>
      <translation>Zehnknotige Tetraeder</translation>
    </message>
    <message>
      <source>Time limit</source>
      <translation>Zeitgrenze</translation>
    </message>
    <message>
      <source>nine tenths of what is free</source>
      <translation>neun Zehntel des freien</translation>
    </message>
    <message>
      <source>none</source>
      <translation>keine</translation>
    </message>
  </context>
  <context>
    <name>FGMesh_Analysis</name>
    <message>
      <source>Create graded analysis ...</source>
      <translation>Gradierte Analyse anlegen ...</translation>
    </message>
    <message>
      <source>Makes or completes a FEM analysis of the selected mesh, with graded properties</source>
      <translation>Erstellt oder ergänzt eine FEM-Analyse des ausgewählten Netzes mit gradierten Eigenschaften</translation>
    </message>
  </context>
  <context>
    <name>FGMesh_Examples</name>
    <message>
      <source>Examples ...</source>
      <translation>Beispiele ...</translation>
    </message>
    <message>
      <source>Opens a document with graded solids, ready to be meshed</source>
      <translation>Öffnet ein Dokument mit gradierten Festkörpern, bereit zum Vernetzen</translation>
    </message>
  </context>
  <context>
    <name>FGMesh_Material</name>
    <message>
      <source>Gives the selected solids a material that changes by a formula, or changes theirs</source>
      <translation>Gibt den gewählten Festkörpern ein Material, das sich nach einer Formel ändert, oder ändert das ihre</translation>
    </message>
    <message>
      <source>Graded material ...</source>
      <translation>Gradientenwerkstoff ...</translation>
    </message>
  </context>
  <context>
    <name>FGMesh_Mesh</name>
    <message>
      <source>Makes the mesh of the selected graded solid, or makes the selected mesh again</source>
      <translation>Vernetzt den gewählten gradierten Festkörper oder macht das gewählte Netz neu</translation>
    </message>
    <message>
      <source>Mesh graded solid ...</source>
      <translation>Gradierten Festkörper vernetzen ...</translation>
    </message>
  </context>
  <context>
    <name>FGMesh_Preview</name>
    <message>
      <source>Colours the selected graded solid by its material, whole or cut open</source>
      <translation>Färbt den gewählten gradierten Festkörper nach seinem Material, ganz oder aufgeschnitten</translation>
    </message>
    <message>
      <source>Preview of the material</source>
      <translation>Vorschau des Materials</translation>
    </message>
  </context>
  <context>
    <name>FGMesh_Report</name>
    <message>
      <source>Figures of the selected mesh: stages, histograms, the worst tetrahedra, a cut</source>
      <translation>Zahlen zum gewählten Netz: Stufen, Histogramme, die schlechtesten Tetraeder, ein Schnitt</translation>
    </message>
    <message>
      <source>Report of the mesh</source>
      <translation>Bericht zum Netz</translation>
    </message>
  </context>
  <context>
    <name>Workbench</name>
    <message>
      <source>FGMesh</source>
      <translation>FGMesh</translation>
    </message>
    <message>
      <source>Tetrahedral FEM meshes of functionally graded solids</source>
      <translation>FEM-Tetraedernetze von Festkörpern aus Gradientenwerkstoff</translation>
    </message>
  </context>
</TS>
