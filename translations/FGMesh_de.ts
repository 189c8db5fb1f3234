<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
  <context>
    <name>FGMesh</name>
    <message>
      <source>0 on the first reference, 1 on the second</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>1 at the frame's origin; falls by e within 1/alpha</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>1 at the low end of the frame's z axis; falls by e within 1/alpha</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>1 on the reference; falls by e within the depth</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>; a volume fraction must stay between 0 and 1</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>; not defined in {} % of it</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>; only {} MB of memory are free</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A smooth step from 0 to 1 in the middle, over the width</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Anisotropy</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>As the linear one, to the power n</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Ball, exponential about its centre (case study I)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Bracket, from one face to another</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cancel</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Click ...</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Click on d{} ...</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Coated insert, two solids with a material each</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Constituent 1</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Constituent 2</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cut</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cuts the solid open across this axis</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cylinder, power law along its axis (case study II)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Dihedral angles</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Direction of the frame's z axis: x, y, z</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Drag in the view</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Edges much longer than this are split; 0: the part's diagonal / 8</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Examples</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Expected: ...</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Expected: about {} tetrahedra, {} MB</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Exponential about a point</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Exponential along z</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>FGMesh</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Fraction</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Frame of x y z r theta d</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>From 0 at the frame's origin to 1 at the radius</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>From 0 at the low end to 1 at the high end of the frame's x axis</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>From 0 at the low end to 1 at the high end of the frame's y axis</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>From 0 at the low end to 1 at the high end of the frame's z axis</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>From 0 on the frame's z axis to 1 at the radius</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>From face A to face B</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Graded material of {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Groups</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>In the view</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Is</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Largest difference of composition allowed inside one tetrahedron, above 0 and at most 1</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Largest distance of the mesh's boundary to the true one; 0: the part's diagonal / 2000, or less where the volume would be more than 0.5 % off</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Largest size</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Largest stretch of an element across the gradient; 1: isotropic (more is not available yet)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Largest variation</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Layer below a face</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Linear along x</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Linear along y</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Linear along z</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Make {} a parameter</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Material of {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Material threshold</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Mesh</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Mesh again ...</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Mesh graded solid</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Mesh of {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No refinement makes edges shorter than this; 0: the part's diagonal / 2000</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nothing was changed: {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>On the solid: {} to {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Origin</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Origin of the frame in the solid's own coordinates, mm: x, y, z</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Parameter</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pick</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pictures (*.png *.svg *.pdf)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Plain</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Power law along z</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Preview</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Processors to use; without effect yet, one is used</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Radial</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Ready gradings ...</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>References of d1 d2 ...</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Remove</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Report ...</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Report of {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reset</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Run</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save picture ...</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save table ...</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Section</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Set graded material</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Show</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Show the material</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sigmoid layer across z</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Smallest angles</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Smallest size</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Spherical</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Start of the random numbers; the same seed, the same mesh</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Surface deviation</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Tables (*.csv)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Ten-node tetrahedra</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Ten-node tetrahedra in place of four-node ones, with nodes on the true faces and edges</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The formula is not defined anywhere on the solid</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The frame takes three numbers each, as in 0, 0, 1; it was left as it was</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The last of the three stages to run</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The solid's own coordinates</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Then click on a face, an edge or a vertex in the 3D view, or on a solid in the tree</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Then click on a face, an edge, a vertex, a datum or a coordinate system: the frame stands there, its z axis along the normal or the axis</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Value</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Values are numbers (0.08), numbers with units (2 cm) or expressions of FreeCAD (Height/2, Spreadsheet.alpha), which then drive the parameter</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Variation of composition</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Volume fraction of constituent 1</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Volume fraction of the first constituent, 0 to 1, over x y z r theta d (mm, radians, in the material's frame), the parameters, and d1 d2 ..., the distances to the references</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Write a formula, or choose a ready grading above</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>automatic</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>d1 is the distance to the first of them, d2 to the second, and so on</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>edges</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>faces</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>geometry-oriented refinement</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>initial mesh</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>material-oriented refinement</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>measuring references</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>reading the shape</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>solids</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>starting</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>vertices</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>whole</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>z axis</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{} tetrahedra, variation up to {}, angles from {} to {} degrees</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>FGMeshPreferences</name>
    <message>
      <source> MB</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>General</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Largest difference of composition inside one tetrahedron</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Material threshold</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Memory limit</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Meshing runs</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>New meshes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Preview</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Shown as soon as the panel of a material opens</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Ten-node tetrahedra</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Time limit</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>nine tenths of what is free</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>none</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>FGMesh_Examples</name>
    <message>
      <source>Examples ...</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Opens a document with graded solids, ready to be meshed</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>FGMesh_Material</name>
    <message>
      <source>Gives the selected solids a material that changes by a formula, or changes theirs</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Graded material ...</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>FGMesh_Mesh</name>
    <message>
      <source>Makes the mesh of the selected graded solid, or makes the selected mesh again</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Mesh graded solid ...</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>FGMesh_Preview</name>
    <message>
      <source>Colours the selected graded solid by its material, whole or cut open</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Preview of the material</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>FGMesh_Report</name>
    <message>
      <source>Figures of the selected mesh: stages, histograms, the worst tetrahedra, a cut</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Report of the mesh</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>Workbench</name>
    <message>
      <source>FGMesh</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Tetrahedral FEM meshes of functionally graded solids</source>
      <translation type="unfinished" />
    </message>
  </context>
</TS>
