// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write/mesh_texts.hpp"

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <set>

#include "io/formats/binary.hpp"
#include "io/formats/files.hpp"
#include "io/write/formats.hpp"
#include "io/write/poly_data.hpp"
#include "io/write/text.hpp"

namespace crest::io {
namespace {

using kernel::Attribute;
using kernel::Index;
using kernel::Site;

/// Shortest decimals that read back as the same double, whatever the type.
std::string number_text(const Attribute& a, std::size_t word) {
  if (is_real(a.type)) return fmt::format("{}", std::bit_cast<double>(a.words[word]));
  return a.type == NumberType::u64 ? fmt::format("{}", a.words[word])
                                   : fmt::format("{}", static_cast<std::int64_t>(a.words[word]));
}

/// Header, then a line a point and a line a face with the given starts and ends; indices from
/// `base`.
struct Lines {
  std::string header;
  const char *vertex, *face;
  Index base;
};

template <class VertexEnd, class Corner, class FaceEnd>
std::string text_of(const MeshPoints& points, const MeshFaces& faces, const Lines& lines,
                    VertexEnd&& vertex_end, Corner&& corner, FaceEnd&& face_end) {
  Text text;
  text.add("{}", lines.header);
  for (std::size_t v = 0; v < points.size(); ++v) {
    const kernel::Vec3& p = points[v];
    text.add("{}{} {} {}{}\n", lines.vertex, p[0], p[1], p[2], vertex_end(v));
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto end = [&](std::size_t k) {
      return fmt::format("{}{}", faces[f][k] + lines.base, corner(3 * f + k));
    };
    text.add("{}{} {} {}{}\n", lines.face, end(0), end(1), end(2), face_end(f));
  }
  return text.text();
}

constexpr auto kNothing = [](std::size_t) { return ""; };

/// What a text format, or VTK, has a place for; the others' names are kept.
template <class Has>
std::vector<const Attribute*> kept(Attributes attributes, LeftOut& left_out, Has&& has) {
  std::vector<const Attribute*> list;
  for (const Attribute& a : attributes)
    if (has(a))
      list.push_back(&a);
    else
      left_out.push_back(a.name);
  return list;
}

bool is_whole(const Attribute& a) {
  return a.site != Site::corners && a.missing.empty();
}

/// A name that `taken` has not.
std::string new_name(std::string name, std::set<std::string>& taken) {
  while (!taken.insert(name).second) name += "_";
  return name;
}

/// One property of PLY.
struct Property {
  const Attribute* attribute;
  std::size_t component;
  std::string name;
};

std::string ply_name(std::string name) {
  for (char& c : name)
    if (static_cast<unsigned char>(c) <= ' ' || c == 127) c = '_';
  return name.empty() ? "_" : name;
}

std::vector<Property> properties_of(const std::vector<const Attribute*>& list, Site site,
                                    std::set<std::string> taken) {
  std::vector<Property> properties;
  for (const Attribute* a : list) {
    if (a->site != site) continue;
    const bool normals = site == Site::vertices && a->name == "Normals" && a->components == 3;
    for (std::size_t c = 0; c < a->components; ++c) {
      const std::string name = normals              ? std::array{"nx", "ny", "nz"}[c]
                               : a->components == 1 ? ply_name(a->name)
                                                    : fmt::format("{}_{}", ply_name(a->name), c);
      properties.push_back({a, c, new_name(name, taken)});
    }
  }
  return properties;
}

std::string declared(const std::vector<Property>& properties) {
  constexpr std::array types = {"char", "uchar", "short",  "ushort", "int",
                                "uint", "int64", "uint64", "float",  "double"};
  std::string lines;
  for (const Property& p : properties)
    lines +=
        fmt::format("property {} {}\n", types[static_cast<std::size_t>(p.attribute->type)], p.name);
  return lines;
}

std::string row(const std::vector<Property>& properties, std::size_t place) {
  std::string text;
  for (const Property& p : properties)
    text +=
        fmt::format(" {}", number_text(*p.attribute, p.component * p.attribute->places() + place));
  return text;
}

/// Numbers that corners of OBJ name, from 1.
class Pool {
 public:
  Pool() = default;
  Pool(const Attribute& a, const MeshFaces& faces, const char* keyword) {
    std::map<std::vector<std::uint64_t>, std::size_t> numbers;
    for (std::size_t corner = 0; corner < 3 * faces.size(); ++corner) {
      const std::size_t place = a.site == Site::corners ? corner : faces[corner / 3][corner % 3];
      if (!a.has(place)) {
        number_.push_back(0);
        continue;
      }
      std::vector<std::uint64_t> tuple;
      for (std::size_t c = 0; c < a.components; ++c)
        tuple.push_back(a.words[c * a.places() + place]);
      const auto [at, fresh] = numbers.emplace(std::move(tuple), numbers.size() + 1);
      number_.push_back(at->second);
      if (!fresh) continue;
      lines_ += keyword;
      for (std::size_t c = 0; c < a.components; ++c)
        lines_ += fmt::format(" {}", number_text(a, c * a.places() + place));
      lines_ += "\n";
    }
  }
  const std::string& lines() const { return lines_; }
  /// Empty: none.
  std::string at(std::size_t corner) const {
    if (number_.empty() || number_[corner] == 0) return "";
    return std::to_string(number_[corner]);
  }

 private:
  std::string lines_;
  std::vector<std::size_t> number_;  ///< of corners
};

/// As VTK's writer puts it between quotes, unescaped.
std::string vtp_name(const std::string& name) {
  std::string text;
  for (const char c : one_line(name, '_'))
    text += c == '&'   ? "&amp;"
            : c == '<' ? "&lt;"
            : c == '>' ? "&gt;"
            : c == '"' ? "&quot;"
                       : std::string(1, c);
  return text.empty() ? "_" : text;
}

vtkSmartPointer<vtkDataArray> array_of(const Attribute& a) {
  constexpr std::array types = {VTK_TYPE_INT8,    VTK_TYPE_UINT8,  VTK_TYPE_INT16, VTK_TYPE_UINT16,
                                VTK_TYPE_INT32,   VTK_TYPE_UINT32, VTK_TYPE_INT64, VTK_TYPE_UINT64,
                                VTK_TYPE_FLOAT32, VTK_TYPE_FLOAT64};
  auto array = vtkSmartPointer<vtkDataArray>::Take(
      vtkDataArray::CreateDataArray(types[static_cast<std::size_t>(a.type)]));
  array->SetNumberOfComponents(static_cast<int>(a.components));
  array->SetNumberOfTuples(static_cast<vtkIdType>(a.places()));
  with_type(a.type, [&](auto sample) {
    using T = decltype(sample);
    T* to = static_cast<T*>(array->GetVoidPointer(0));
    for (std::size_t p = 0; p < a.places(); ++p)
      for (std::size_t c = 0; c < a.components; ++c) {
        const std::uint64_t word = a.words[c * a.places() + p];
        *to++ = std::is_floating_point_v<T> ? static_cast<T>(std::bit_cast<double>(word))
                                            : static_cast<T>(word);
      }
  });
  return array;
}

}  // namespace

std::string off_text(const MeshPoints& points, const MeshFaces& faces, Attributes attributes,
                     LeftOut& left_out) {
  kept(attributes, left_out, [](const Attribute&) { return false; });
  const std::string header = fmt::format("OFF\n{} {} 0\n", points.size(), faces.size());
  return text_of(points, faces, {header, "", "3 ", 0}, kNothing, kNothing, kNothing);
}

std::string obj_text(const MeshPoints& points, const MeshFaces& faces, Attributes attributes,
                     LeftOut& left_out) {
  Pool normals, textures;
  const Attribute* colours = nullptr;
  std::set<std::string> seen;
  kept(attributes, left_out, [&](const Attribute& a) {
    if (!is_real(a.type) || a.site == Site::faces || a.components > 3) return false;
    const bool three = a.components == 3, first = seen.insert(a.name).second;
    if (first && a.name == "Normals" && three) return normals = Pool(a, faces, "vn"), true;
    if (first && a.name == "TCoords") return textures = Pool(a, faces, "vt"), true;
    if (first && a.name == "RGB" && three && is_whole(a)) return colours = &a, true;
    return false;
  });
  const auto colour = [&](std::size_t v) {
    std::string text;
    for (std::size_t c = 0; colours && c < 3; ++c)
      text += fmt::format(" {}", number_text(*colours, c * points.size() + v));
    return text;
  };
  const auto corner = [&](std::size_t h) {
    const std::string texture = textures.at(h), normal = normals.at(h);
    if (normal != "") return fmt::format("/{}/{}", texture, normal);
    return texture != "" ? fmt::format("/{}", texture) : "";
  };
  const std::string header = textures.lines() + normals.lines();
  return text_of(points, faces, {header, "v ", "f ", 1}, colour, corner, kNothing);
}

std::string ply_text(const MeshPoints& points, const MeshFaces& faces, Attributes attributes,
                     LeftOut& left_out) {
  const auto list = kept(attributes, left_out, is_whole);
  const auto of_points = properties_of(list, Site::vertices, {"x", "y", "z"}),
             of_faces = properties_of(list, Site::faces, {"vertex_indices", "vertex_index"});
  const std::string header = fmt::format(
      "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\n"
      "property double z\n{}element face {}\nproperty list uchar int vertex_indices\n{}"
      "end_header\n",
      points.size(), declared(of_points), faces.size(), declared(of_faces));
  return text_of(
      points, faces, {header, "", "3 ", 0}, [&](std::size_t v) { return row(of_points, v); },
      kNothing, [&](std::size_t f) { return row(of_faces, f); });
}

void write_vtp_mesh(const std::string& path, const MeshPoints& points, const MeshFaces& faces,
                    Attributes attributes, LeftOut& left_out) {
  PolyData cells;
  cells.add_points(points);
  for (const kernel::Triangle& f : faces) cells.add_triangle(f[0], f[1], f[2]);
  const auto data = cells.data();
  std::set<std::string> given, of_points, of_cells;
  for (const Attribute* a : kept(attributes, left_out, is_whole)) {
    const bool cell = a->site == Site::faces;
    const std::string name = new_name(vtp_name(a->name), cell ? of_cells : of_points);
    const auto array = array_of(*a);
    array->SetName(name.c_str());
    given.insert(name);
    vtkDataSetAttributes* to = data->GetPointData();
    if (cell) to = data->GetCellData();
    to->AddArray(array);
    if (a->name == "Normals" && a->components == 3) to->SetActiveNormals("Normals");
    if (a->name == "TCoords" && a->components <= 3) to->SetActiveTCoords("TCoords");
  }
  write_vtp(path, *data, given);
}

}  // namespace crest::io
