// SPDX-License-Identifier: GPL-3.0-or-later
// The readers of surfaces by extension; those of CGAL, each behind its check.
#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <map>
#include <sstream>
#include <stdexcept>

#include "io/formats/files.hpp"
#include "io/formats/readers.hpp"

namespace crest::io {
namespace {

/// The corners of a face as CGAL's readers fill them. No list longer than 3 is ever allocated,
/// whatever length a file announces.
class Corners {
 public:
  using value_type = Cells::Node;
  void resize(std::size_t n) {
    if (n > 3) throw std::length_error("face with more than 3 vertices");
    size_ = n;
  }
  std::size_t size() const { return size_; }
  Cells::Node& operator[](std::size_t k) { return at_[k]; }
  const Cells::Node& operator[](std::size_t k) const { return at_[k]; }
  std::span<const Cells::Node> nodes() const { return {at_.data(), size_}; }

 private:
  std::array<Cells::Node, 3> at_{};
  std::size_t size_ = 0;
};

template <class Read>
Soup read_checked(std::string bytes, const char* format, Read&& read) {
  std::istringstream stream(std::move(bytes), std::ios::binary);
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  std::vector<Corners> faces;
  if (!read(stream, points, faces)) {
    if (faces.empty()) fail("faces", "there are none", "export the mesh with its faces");
    fail("file", std::string("cannot be read as ") + format, "export the mesh again");
  }
  Soup soup;
  soup.points.reserve(points.size());
  for (const auto& p : points) soup.points.push_back({p.x(), p.y(), p.z()});
  soup.cells.reserve(faces.size(), 3 * faces.size());
  for (const Corners& face : faces)
    soup.cells.add(face.size() == 3 ? CellType::triangle : CellType::polygon, face.nodes());
  return soup;
}

}  // namespace

Soup read_off(std::string bytes, const FieldRequest&) {
  Soup soup = parse_off(bytes);
  if (soup.cells.empty()) fail("faces", "there are none", "export the mesh with its faces");
  return soup;
}

Soup read_obj(std::string bytes, const FieldRequest&) {
  check_obj(bytes);
  return read_checked(std::move(bytes), "OBJ", [](auto& stream, auto& points, auto& faces) {
    return CGAL::IO::read_OBJ(stream, points, faces, CGAL::parameters::verbose(false));
  });
}

Soup read_ply(std::string bytes, const FieldRequest& request) {
  check_ply(bytes);
  std::vector<Field> normals;
  if (request.wanted) normals = ply_normals(bytes);
  Soup soup = read_checked(std::move(bytes), "PLY", [](auto& stream, auto& points, auto& faces) {
    return CGAL::IO::read_PLY(stream, points, faces, CGAL::parameters::verbose(false));
  });
  soup.point_fields = std::move(normals);
  return soup;
}

Soup read_stl(std::string bytes, const FieldRequest&) {
  check_stl(bytes);
  return read_checked(std::move(bytes), "STL", [](auto& stream, auto& points, auto& faces) {
    return CGAL::IO::read_STL(stream, points, faces, CGAL::parameters::verbose(false));
  });
}

SoupReader soup_reader(const std::string& extension) {
  static const std::map<std::string, SoupReader> readers = {
      {".off", read_off}, {".obj", read_obj}, {".ply", read_ply}, {".stl", read_stl},
      {".vtp", read_vtp}, {".vtu", read_vtu}, {".msh", read_msh}};
  const auto reader = readers.find(extension);
  if (reader == readers.end()) {
    fail("file",
         extension.empty() ? "has no extension" : "has the unknown extension '" + extension + "'",
         "use .off, .obj, .ply, .stl, .vtp, .vtu, .vtk or .msh");
  }
  return reader->second;
}

}  // namespace crest::io
