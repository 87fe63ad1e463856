// SPDX-License-Identifier: GPL-3.0-or-later
// Readers of polygon soups: CGAL's, each behind its check, and our own of OFF.
#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>

#include <sstream>

#include "io/formats/polygon_soup.hpp"

namespace crest::io {
namespace {

template <class Read>
PolygonSoup read_checked(std::string bytes, const char* format, Read&& read) {
  std::istringstream stream(std::move(bytes), std::ios::binary);
  PolygonSoup soup;
  if (!read(stream, soup.points, soup.faces)) {
    if (soup.faces.empty()) fail("faces", "there are none", "export the mesh with its faces");
    fail("file", std::string("cannot be read as ") + format, "export the mesh again");
  }
  return soup;
}

}  // namespace

PolygonSoup read_off(std::string bytes) {
  PolygonSoup soup = parse_off(bytes);
  if (soup.faces.empty()) fail("faces", "there are none", "export the mesh with its faces");
  return soup;
}

PolygonSoup read_obj(std::string bytes) {
  check_obj(bytes);
  return read_checked(std::move(bytes), "OBJ", [](auto& stream, auto& points, auto& faces) {
    return CGAL::IO::read_OBJ(stream, points, faces, CGAL::parameters::verbose(false));
  });
}

PolygonSoup read_ply(std::string bytes) {
  check_ply(bytes);
  return read_checked(std::move(bytes), "PLY", [](auto& stream, auto& points, auto& faces) {
    return CGAL::IO::read_PLY(stream, points, faces, CGAL::parameters::verbose(false));
  });
}

PolygonSoup read_stl(std::string bytes) {
  check_stl(bytes);
  return read_checked(std::move(bytes), "STL", [](auto& stream, auto& points, auto& faces) {
    return CGAL::IO::read_STL(stream, points, faces, CGAL::parameters::verbose(false));
  });
}

}  // namespace crest::io
