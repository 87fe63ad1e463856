// SPDX-License-Identifier: GPL-3.0-or-later
// How fast each format is read: a torus of a million faces from a file to a soup and to a mesh,
// processor time of one thread, medians.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "experiments/processor_time.hpp"
#include "experiments/program.hpp"
#include "io/formats/files.hpp"
#include "io/formats/readers.hpp"
#include "io/read/mesh_reader.hpp"
#include "io/write/mesh_writer.hpp"
#include "kernel/geometry/triangle_mesh.hpp"

namespace crest {
namespace {

using experiments::processor_seconds;
using kernel::Triangle;
using kernel::Vec3;

struct Mesh {
  std::vector<Vec3> points;
  std::vector<Triangle> faces;
};

/// A torus of n x n quadrangles, each cut in two.
Mesh torus(unsigned n) {
  Mesh mesh;
  for (unsigned i = 0; i < n; ++i) {
    for (unsigned j = 0; j < n; ++j) {
      const double u = 2 * M_PI * i / n, v = 2 * M_PI * j / n, r = 1 + 0.4 * std::cos(v);
      mesh.points.push_back({r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v)});
      const unsigned a = i * n + j, b = i * n + (j + 1) % n, c = (i + 1) % n * n + j,
                     d = (i + 1) % n * n + (j + 1) % n;
      mesh.faces.push_back({a, c, d});
      mesh.faces.push_back({a, d, b});
    }
  }
  return mesh;
}

template <class T>
void put(std::string& bytes, T x, bool big_endian = false) {
  char at[sizeof x];
  std::memcpy(at, &x, sizeof x);
  if (big_endian) std::reverse(at, at + sizeof x);
  bytes.append(at, sizeof x);
}

std::string points_text(const Mesh& mesh, const char* before, const char* after) {
  std::string text;
  for (const Vec3& p : mesh.points)
    fmt::format_to(std::back_inserter(text), "{}{} {} {}{}", before, p[0], p[1], p[2], after);
  return text;
}
std::string faces_text(const Mesh& mesh, const char* before, unsigned first) {
  std::string text;
  for (const Triangle& f : mesh.faces)
    fmt::format_to(std::back_inserter(text), "{} {} {} {}\n", before, f[0] + first, f[1] + first,
                   f[2] + first);
  return text;
}

std::string off(const Mesh& mesh) {
  return fmt::format("OFF\n{} {} 0\n", mesh.points.size(), mesh.faces.size()) +
         points_text(mesh, "", "\n") + faces_text(mesh, "3", 0);
}
std::string obj(const Mesh& mesh) {
  return points_text(mesh, "v ", "\n") + faces_text(mesh, "f", 1);
}

std::string ply_header(const Mesh& mesh, const char* format, const char* type) {
  return fmt::format(
      "ply\nformat {0} 1.0\nelement vertex {1}\nproperty {2} x\nproperty {2} y\nproperty {2} z\n"
      "element face {3}\nproperty list uchar int vertex_indices\nend_header\n",
      format, mesh.points.size(), type, mesh.faces.size());
}
std::string ply_text(const Mesh& mesh) {
  return ply_header(mesh, "ascii", "double") + points_text(mesh, "", "\n") +
         faces_text(mesh, "3", 0);
}
template <class Coordinate>
std::string ply_binary(const Mesh& mesh, const char* type) {
  std::string bytes = ply_header(mesh, "binary_little_endian", type);
  for (const Vec3& p : mesh.points)
    for (const double x : p) put(bytes, static_cast<Coordinate>(x));
  for (const Triangle& f : mesh.faces) {
    put(bytes, std::uint8_t{3});
    for (const auto v : f) put(bytes, v);
  }
  return bytes;
}

std::string stl_text(const Mesh& mesh) {
  std::string text = "solid torus\n";
  for (const Triangle& f : mesh.faces) {
    text += "facet normal 0.577350269 0.577350269 0.577350269\n  outer loop\n";
    for (const auto v : f) {
      const Vec3& p = mesh.points[v];
      fmt::format_to(std::back_inserter(text), "    vertex {} {} {}\n", static_cast<float>(p[0]),
                     static_cast<float>(p[1]), static_cast<float>(p[2]));
    }
    text += "  endloop\nendfacet\n";
  }
  return text + "endsolid torus\n";
}
std::string stl_binary(const Mesh& mesh) {
  std::string bytes(80, ' ');
  put(bytes, static_cast<std::uint32_t>(mesh.faces.size()));
  for (const Triangle& f : mesh.faces) {
    bytes.append(12, '\0');
    for (const auto v : f)
      for (const double x : mesh.points[v]) put(bytes, static_cast<float>(x));
    bytes.append(2, '\0');
  }
  return bytes;
}

std::string vtk_text(const Mesh& mesh) {
  return fmt::format(
             "# vtk DataFile Version 4.2\ntorus\nASCII\nDATASET POLYDATA\nPOINTS {} double\n",
             mesh.points.size()) +
         points_text(mesh, "", "\n") +
         fmt::format("POLYGONS {} {}\n", mesh.faces.size(), 4 * mesh.faces.size()) +
         faces_text(mesh, "3", 0);
}
std::string vtk_binary(const Mesh& mesh) {
  std::string bytes =
      fmt::format("# vtk DataFile Version 5.1\ntorus\nBINARY\nDATASET POLYDATA\nPOINTS {} double\n",
                  mesh.points.size());
  for (const Vec3& p : mesh.points)
    for (const double x : p) put(bytes, x, true);
  bytes += fmt::format("\nPOLYGONS {} {}\nOFFSETS vtktypeint64\n", mesh.faces.size() + 1,
                       3 * mesh.faces.size());
  for (std::size_t f = 0; f <= mesh.faces.size(); ++f) put(bytes, std::int64_t(3 * f), true);
  bytes += "\nCONNECTIVITY vtktypeint64\n";
  for (const Triangle& f : mesh.faces)
    for (const auto v : f) put(bytes, std::int64_t{v}, true);
  return bytes + "\n";
}

std::string msh_text(const Mesh& mesh) {
  std::string text =
      fmt::format("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{}\n", mesh.points.size());
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const Vec3& p = mesh.points[v];
    fmt::format_to(std::back_inserter(text), "{} {} {} {}\n", v + 1, p[0], p[1], p[2]);
  }
  text += fmt::format("$EndNodes\n$Elements\n{}\n", mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Triangle& t = mesh.faces[f];
    fmt::format_to(std::back_inserter(text), "{} 2 2 1 1 {} {} {}\n", f + 1, t[0] + 1, t[1] + 1,
                   t[2] + 1);
  }
  return text + "$EndElements\n";
}

void measure(const char* what, const std::string& path, std::size_t faces, int runs) {
  std::vector<double> whole, reading, mesh;
  for (int run = 0; run < runs; ++run) {
    const double start = processor_seconds();
    const io::FileBytes bytes = io::load(path);
    const double loaded = processor_seconds();
    const io::Soup soup = io::soup_reader(io::lower_extension(path))(bytes, {});
    const double end = processor_seconds();
    if (soup.cells.size() != faces) throw std::runtime_error("faces are missing");
    whole.push_back(end - start);
    reading.push_back(end - loaded);
  }
  for (int run = 0; run < runs; ++run) {
    const double start = processor_seconds();
    if (io::read_mesh(path).mesh.face_count() != faces)
      throw std::runtime_error("faces are missing");
    mesh.push_back(processor_seconds() - start);
  }
  for (auto* times : {&whole, &reading, &mesh})
    std::nth_element(times->begin(), times->begin() + runs / 2, times->end());
  const auto middle = static_cast<std::size_t>(runs / 2);
  const double megabytes = 1e-6 * static_cast<double>(std::filesystem::file_size(path));
  fmt::print("| {} | {:.0f} | {:.3f} | {:.3f} | {:.0f} | {:.3f} |\n", what, megabytes,
             whole[middle], reading[middle], megabytes / reading[middle], mesh[middle]);
  std::fflush(stdout);
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  using namespace crest;
  unsigned side = 707;
  int runs = 5;
  std::string folder = std::filesystem::temp_directory_path().string();
  experiments::Program program("Times of the readers of each format");
  program.option("--side", side, "quadrangles a side of the torus");
  program.option("--runs", runs, "of which the median is given");
  program.option("--folder", folder, "for the files");
  return program.run(argc, argv, [&] {
    const Mesh mesh = torus(side);
    fmt::print("\n{} vertices, {} faces\n\n", mesh.points.size(), mesh.faces.size());
    fmt::print(
        "| format | MB | file to soup, s | bytes to soup, s | MB/s | file to mesh, s |\n"
        "|---|---|---|---|---|---|\n");
    const std::string path = folder + "/reading_speed.";
    const auto one = [&](const char* what, const char* extension, const std::string& bytes) {
      if (!bytes.empty()) std::ofstream(path + extension, std::ios::binary) << bytes;
      measure(what, path + extension, mesh.faces.size(), runs);
      std::filesystem::remove(path + extension);
    };
    one("OFF", "off", off(mesh));
    one("OBJ", "obj", obj(mesh));
    one("PLY, text", "ply", ply_text(mesh));
    one("STL, text, 9 digits", "stl", stl_text(mesh));
    one("VTK 4.2, text", "vtk", vtk_text(mesh));
    one("Gmsh 2.2, text", "msh", msh_text(mesh));
    one("PLY, binary, double", "ply", ply_binary<double>(mesh, "double"));
    one("PLY, binary, float", "ply", ply_binary<float>(mesh, "float"));
    one("STL, binary", "stl", stl_binary(mesh));
    one("VTK 5.1, binary", "vtk", vtk_binary(mesh));
    io::write_mesh(path + "vtp", mesh.points, mesh.faces);
    one("VTP, inline, zlib", "vtp", "");
    return 0;
  });
}
