// SPDX-License-Identifier: GPL-3.0-or-later
/// A mesh by Netgen with sizes that are told at points.
///
///     netgen_mesh PART.brep SIZES LARGEST OUT.mesh
///
/// SIZES holds a point and the size there, x y z h in mm, as four doubles (binary) after each other. Netgen's
/// own script interface has no way to give them, the library has. Writes a Medit mesh; prints the seconds
/// that meshing took, and those of optimising within them, as JSON. Netgen itself talks on standard output,
/// so that is the last line.
#include <array>
#include <chrono>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#define OCCGEOMETRY
namespace nglib {
#include <nglib.h>
}

namespace {

using namespace nglib;

std::vector<std::array<double, 4>> sizes_in(const char* path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<std::array<double, 4>> sizes;
  for (std::array<double, 4> row; file.read(reinterpret_cast<char*>(row.data()), sizeof row);)
    sizes.push_back(row);
  if (sizes.empty()) throw std::runtime_error(std::string("cannot read ") + path);
  return sizes;
}

void ensure(Ng_Result result, const char* step) {
  if (result != NG_OK)
    throw std::runtime_error(std::string(step) + ": Netgen's error " + std::to_string(result));
}

void mesh_shape(Ng_OCC_Geometry* shape, Ng_Mesh* mesh, const std::vector<std::array<double, 4>>& sizes,
                double largest) {
  Ng_Meshing_Parameters parameters;
  parameters.maxh = largest;
  parameters.uselocalh = 1;
  parameters.elementsperedge = 1;
  parameters.elementspercurve = 1;
  parameters.grading = 0.5;
  parameters.optsurfmeshenable = parameters.optvolmeshenable = 1;
  ensure(Ng_OCC_SetLocalMeshSize(shape, mesh, &parameters), "sizes");
  for (std::array<double, 4> size : sizes) Ng_RestrictMeshSizePoint(mesh, size.data(), size[3]);
  ensure(Ng_OCC_GenerateEdgeMesh(shape, mesh, &parameters), "edges");
  ensure(Ng_OCC_GenerateSurfaceMesh(shape, mesh, &parameters), "faces");
  ensure(Ng_GenerateVolumeMesh(mesh, &parameters), "solid");
}

template <int corners, typename Element>
void write_elements(std::ostream& file, const char* name, int count, Element&& element) {
  file << name << '\n' << count << '\n';
  std::array<int, 10> vertices{};
  for (int i = 1; i <= count; ++i) {
    element(i, vertices.data());
    for (int k = 0; k < corners; ++k) file << vertices[k] << ' ';
    file << "1\n";
  }
}

void write_medit(Ng_Mesh* mesh, const char* path) {
  std::ofstream file(path);
  file.precision(17);
  file << "MeshVersionFormatted 2\nDimension 3\nVertices\n" << Ng_GetNP(mesh) << '\n';
  for (int i = 1; i <= Ng_GetNP(mesh); ++i) {
    std::array<double, 3> p{};
    Ng_GetPoint(mesh, i, p.data());
    file << p[0] << ' ' << p[1] << ' ' << p[2] << " 0\n";
  }
  write_elements<3>(file, "Triangles", Ng_GetNSE(mesh),
                    [&](int i, int* v) { Ng_GetSurfaceElement(mesh, i, v); });
  write_elements<4>(file, "Tetrahedra", Ng_GetNE(mesh), [&](int i, int* v) {
    Ng_GetVolumeElement(mesh, i, v);
    std::swap(v[0], v[1]);  // Netgen's tetrahedra are the other way round
  });
  file << "End\n";
  if (!file.flush()) throw std::runtime_error(std::string("cannot write ") + path);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 5) throw std::invalid_argument("usage: netgen_mesh PART.brep SIZES LARGEST OUT.mesh");
  const auto sizes = sizes_in(argv[2]);
  Ng_Init();
  Ng_OCC_Geometry* shape = Ng_OCC_Load_BREP(argv[1]);
  if (!shape) throw std::runtime_error(std::string("cannot read ") + argv[1]);
  Ng_Mesh* mesh = Ng_NewMesh();
  const auto start = std::chrono::steady_clock::now();
  mesh_shape(shape, mesh, sizes, std::stod(argv[3]));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  write_medit(mesh, argv[4]);
  std::cout << "\n{\"seconds\": " << seconds.count() << "}" << std::endl;
  return 0;
} catch (const std::exception& error) {
  std::cerr << "netgen_mesh: " << error.what() << '\n';
  return 1;
}
