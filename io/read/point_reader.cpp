// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read/point_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/formats/files.hpp"
#include "io/formats/readers.hpp"
#include "io/formats/text_scan.hpp"

namespace crest::io {
namespace {

constexpr const char* kNoNormals =
    "give each point a normal x y z nx ny nz, whose sign does not matter (CloudCompare and MeshLab "
    "estimate them)";

/// Six numbers a line.
class Columns {
 public:
  explicit Columns(std::string_view text) : scan_(text, '#') {}

  PointFile read() {
    while (scan_.more()) {
      read_line();
      scan_.next_line();
    }
    return std::move(file_);
  }

 private:
  std::string name() const { return numbered("point", file_.points.size(), scan_.line()); }
  void read_line() {
    double x[6] = {};
    std::size_t count = 0;
    while (scan_.in_line()) {
      double number = 0;
      if (!scan_.take(number)) {
        const bool comma = scan_.peek().find(',') != std::string_view::npos;
        fail(name(), io::quoted(scan_.peek()) + " is not a number",
             comma ? "separate numbers by blanks" : "correct it");
      }
      if (count < 6) x[count] = number;
      ++count;
    }
    if (count != 6)
      fail(name(), count == 3 ? "has no normal" : fmt::format("has {} numbers, not 6", count),
           kNoNormals);
    file_.points.push_back({x[0], x[1], x[2]});
    file_.normals.push_back({x[3], x[4], x[5]});
  }
  TextScan scan_;
  PointFile file_;
};

PointFile from_soup(Soup soup) {
  PointFile file;
  if (soup.points.empty()) fail("points", "there are none", "export them again");
  const auto field = std::find_if(
      soup.point_fields.begin(), soup.point_fields.end(),
      [](const Field& f) { return (f.normals || f.name == "Normals") && f.components == 3; });
  if (field == soup.point_fields.end() || field->size() != 3 * soup.points.size())
    fail("points", "have no normals", kNoNormals);
  if (!field->missing.empty()) {
    const auto v = std::find(field->missing.begin(), field->missing.end(), true);
    if (v != field->missing.end())
      fail(soup.point_name(static_cast<std::size_t>(v - field->missing.begin())), "has no normal",
           kNoNormals);
  }
  file.warnings = std::move(soup.warnings);
  file.points = std::move(soup.points);
  file.normals.resize(file.points.size());
  std::visit(
      [&](const auto& numbers) {
        for (std::size_t i = 0; i < numbers.size(); ++i)
          file.normals[i / 3][i % 3] = static_cast<double>(numbers[i]);
      },
      field->numbers);
  return file;
}

void check(PointFile& file) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < file.points.size(); ++i) {
    for (std::size_t k = 0; k < 6; ++k) {
      const double x = k < 3 ? file.points[i][k] : file.normals[i][k - 3];
      if (!std::isfinite(x))
        fail(fmt::format("point {}", i), k < 3 ? "is not finite" : "its normal is not finite",
             "repair it");
    }
    if (file.normals[i] == kernel::Vec3{0, 0, 0}) continue;
    file.points[kept] = file.points[i];
    file.normals[kept++] = file.normals[i];
  }
  const std::size_t zero = file.points.size() - kept;
  if (file.points.empty()) fail("points", "there are none", "export them again");
  if (kept == 0) fail("points", "all normals are zero", kNoNormals);
  if (zero > 0)
    file.warnings.push_back(fmt::format("left out {} points whose normal is zero", zero));
  file.points.resize(kept);
  file.normals.resize(kept);
}

PointFile from_bytes(const std::string& name, std::string_view bytes) {
  const std::string extension = lower_extension(name);
  if (extension == ".pcd") fail("file", "PCD is not read", "convert it to PLY or XYZ with normals");
  PointFile file = is_point_name(name)
                       ? Columns(check_text(bytes)).read()
                       : from_soup(read_soup(name, bytes, {.normals = true, .points = true}));
  check(file);
  return file;
}

}  // namespace

bool is_point_name(const std::string& path) {
  const std::string extension = lower_extension(path);
  return extension == ".xyz" || extension == ".pwn" || extension == ".txt";
}

PointFile read_points(const std::string& path) {
  PointFile file;
  read_named(path, [&] { file = from_bytes(path, load(path)); });
  return file;
}

PointFile read_points_bytes(const std::string& name, std::string_view bytes) {
  PointFile file;
  read_named(name, [&] { file = from_bytes(name, bytes); });
  return file;
}

}  // namespace crest::io
