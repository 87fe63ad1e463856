// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/off_binary.hpp"

#include <fmt/format.h>

#include "io/formats/binary.hpp"
#include "io/formats/files.hpp"
#include "io/formats/remedy.hpp"
#include "io/formats/text_scan.hpp"

namespace crest::io {
namespace {

class BinaryOff {
 public:
  BinaryOff(std::string_view bytes, OffVertex vertex, bool normals)
      : bytes_(bytes), vertex_(vertex), with_normals_(normals && vertex.normals) {}

  Soup read() {
    const std::size_t vertices = take_count(), faces = take_count();
    take<std::int32_t>();  // edges
    const std::size_t size = 4 * (3 + (vertex_.normals ? 3 : 0) + vertex_.numbers_behind);
    // The shortest face has two numbers.
    if (vertices > bytes_.size() / size || faces > (bytes_.size() - vertices * size) / 8) {
      fail(where(),
           fmt::format("announces {} vertices and {} faces, more than the file holds", vertices,
                       faces),
           kTruncated);
    }
    soup_.points.resize(vertices);
    for (kernel::Vec3& point : soup_.points) read_vertex(point);
    soup_.cells.reserve(faces, 3 * faces);
    in_faces_ = true;
    while (soup_.cells.size() < faces) read_face();
    if (with_normals_)
      soup_.point_fields.emplace_back(Field{
          .name = "Normals", .components = 3, .numbers = std::move(of_normals_), .normals = true});
    return std::move(soup_);
  }

 private:
  std::string where() const {
    return in_faces_ ? fmt::format("face {}", soup_.cells.size()) : "header";
  }
  void require(std::size_t numbers) const {
    if (numbers > bytes_.size() / 4) fail(where(), "the file ends before or in it", kTruncated);
  }

  template <class T>
  T take() {
    static_assert(sizeof(T) == 4);
    require(1);
    const T number = load_number<T>(bytes_.data(), true);
    bytes_.remove_prefix(sizeof(T));
    return number;
  }

  /// Of what follows.
  std::size_t take_count() {
    const auto count = take<std::int32_t>();
    if (count < 0) fail(where(), fmt::format("has a bad count {}", count), "export the mesh again");
    return static_cast<std::size_t>(count);
  }

  void read_vertex(kernel::Vec3& point) {
    for (double& x : point) x = take<float>();
    for (int k = 0; k < 3 && vertex_.normals; ++k) {
      const double x = take<float>();
      if (with_normals_) of_normals_.push_back(x);
    }
    bytes_.remove_prefix(4 * vertex_.numbers_behind);
  }

  void read_face() {
    const std::size_t corners = take_count();
    if (corners == 0) fail(where(), "has 0 corners", "remove it");
    require(corners);
    face_.clear();
    for (std::size_t k = 0; k < corners; ++k) {
      face_.push_back(take<std::int32_t>());
      if (face_.back() < 0 || face_.back() >= static_cast<Cells::Node>(soup_.points.size()))
        fail_vertex(where(), face_.back(), soup_.points.size());
    }
    const std::size_t colours = take_count();
    require(colours);
    bytes_.remove_prefix(4 * colours);
    soup_.cells.add(face_type(corners), face_);
  }

  std::string_view bytes_;  ///< that are left
  OffVertex vertex_;
  bool with_normals_, in_faces_ = false;
  Soup soup_;
  std::vector<double> of_normals_;
  std::vector<Cells::Node> face_;
};

}  // namespace

Soup read_binary_off(std::string_view bytes, OffVertex vertex, bool normals) {
  return BinaryOff(bytes, vertex, normals).read();
}

}  // namespace crest::io
