// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read/face_soup_reader.hpp"

#include <utility>

#include "io/clean/drop.hpp"
#include "io/clean/triangulate.hpp"
#include "io/formats/files.hpp"
#include "io/formats/readers.hpp"

namespace crest::io {

FaceSoup read_face_soup(const std::string& path) {
  FaceSoup file;
  read_named(path, [&] {
    const Soup soup = read_soup(path, {});
    Surface surface = triangulate(soup, false, file.cleanup);
    file.cleanup.repeated_corners += drop_repeated_corners(surface);
    file.warnings = soup.warnings;
    file.points = std::move(surface.points);
    file.faces = std::move(surface.faces);
  });
  return file;
}

}  // namespace crest::io
