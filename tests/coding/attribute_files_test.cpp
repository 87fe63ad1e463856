// SPDX-License-Identifier: GPL-3.0-or-later
// What PLY, VTP and OBJ give at vertices, faces and corners, from a file through a stream to a
// file.
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <limits>

#include "algorithms/coding/verify.hpp"
#include "io/read/surface_reader.hpp"
#include "io/write/mesh_writer.hpp"
#include "tests/support/random.hpp"
#include "tests/support/temporary_folder.hpp"

namespace crest::tests {
namespace {

using kernel::Attribute;
using kernel::NumberType;
using kernel::Site;

io::SurfaceFile written_and_read(const TemporaryFolder& folder, const std::string& name,
                                 const std::string& text) {
  std::ofstream(folder / name) << text;
  return io::read_surface(folder / name, true);
}

/// Through a stream that keeps the order.
coding::Decoded coded(const io::SurfaceFile& file) {
  const coding::EncodeOptions options{.keep_order = true};
  const auto encoded = coding::encode(static_cast<kernel::Index>(file.points.size()), file.faces,
                                      file.points, options, file.attributes);
  coding::verify(encoded, file.faces, file.points, options, file.attributes);
  return coding::decode(encoded.stream);
}

/// The same after a file of this format.
io::SurfaceFile again(const TemporaryFolder& folder, const std::string& name,
                      const io::SurfaceFile& file, std::size_t left_out = 0) {
  const coding::Decoded mesh = coded(file);
  CHECK(io::write_mesh(folder / name, mesh.points, mesh.faces, mesh.attributes).size() == left_out);
  return io::read_surface(folder / name, true);
}

/// By name: nothing if there is none.
Attribute named(const io::SurfaceFile& file, const std::string& name) {
  for (const Attribute& a : file.attributes)
    if (a.name == name) return a;
  FAIL("no attribute " << name);
  return {};
}

/// Do corners, faces begin where they may, have the same numbers?
bool same_corners(const io::SurfaceFile& x, const io::SurfaceFile& y, const std::string& name) {
  const Attribute a = named(x, name), b = named(y, name);
  if (a.site != b.site || a.words.size() != b.words.size() || x.faces.size() != y.faces.size())
    return false;
  if (a.site == Site::vertices) return a == b;
  const std::size_t places = a.places();
  for (std::size_t p = 0; p < places; ++p) {
    std::size_t q = p / 3 * 3;
    while (y.faces[q / 3][q % 3] != x.faces[p / 3][p % 3]) ++q;
    if (a.has(p) != b.has(q)) return false;
    for (std::size_t first = 0; first < a.words.size(); first += places)
      if (a.words[first + p] != b.words[first + q]) return false;
  }
  return true;
}

const char* const kPly =
    "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\n"
    "property uchar green\nproperty uchar blue\nproperty double quality\nproperty short label\n"
    "property uint64 key\nproperty float half\nelement face 3\n"
    "property list uchar int vertex_indices\nproperty uchar red\nproperty int patch\n"
    "property list uchar float texcoord\nend_header\n"
    "0 0 0 0 0 1 255 0 7 0.1 -32768 18446744073709551615 0.5\n"
    "1 0 0 0 0.6 0.8 254 1 7 nan -1 1 0.25\n"
    "0 1 0 0.1 0.2 0.3 253 2 7 inf 0 2 -0\n"
    "1 1 0 -0 0 -1 252 3 7 -inf 32767 3 1\n"
    "9 9 9 0 0 1 0 0 0 0 0 0 0\n"
    "3 0 1 2 10 -5 0\n3 2 1 3 20 2147483647 2 0.5 0.5\n";

TEST_CASE("attribute files: PLY's properties, normals, colours, keys of 64 bits, of faces") {
  const TemporaryFolder folder;
  // A vertex that no face uses is left out with its numbers.
  std::string text = kPly;
  text.replace(text.find("element face 3"), 14, "element face 2");
  const io::SurfaceFile file = written_and_read(folder, "a.ply", text);
  CHECK(file.points.size() == 4);
  CHECK(named(file, "Normals").components == 3);
  CHECK(named(file, "Normals").type == NumberType::f64);  // 0.6 is no float
  CHECK(named(file, "half").type == NumberType::f32);
  CHECK(named(file, "blue").type == NumberType::u8);
  CHECK(named(file, "label").words[0] == static_cast<std::uint64_t>(-32768));
  CHECK(named(file, "key").words[0] == ~std::uint64_t{0});
  CHECK(named(file, "half").words[2] == std::uint64_t{1} << 63);
  CHECK(std::isinf(std::bit_cast<double>(named(file, "quality").words[2])));
  CHECK(file.attributes.size() == 10);
  CHECK(file.warnings.size() == 2);  // the vertex and the list
  CHECK(coded(file).attributes == file.attributes);
  for (const char* name : {"b.ply", "b.vtp"}) {
    INFO(name);
    const io::SurfaceFile after = again(folder, name, file);
    for (const Attribute& a : file.attributes)
      if (a.site == Site::vertices && a.name != "red" && a.name != "quality")
        CHECK(named(after, a.name) == a);
    CHECK(after.attributes.size() == file.attributes.size());
    for (std::size_t i = 0; i < after.attributes.size(); ++i)  // "red" of faces, too
      CHECK(after.attributes[i].words.size() == file.attributes[i].words.size());
    const auto quality = named(after, "quality").words;
    CHECK(std::isnan(std::bit_cast<double>(quality[1])));
    CHECK(std::bit_cast<double>(quality[3]) == -std::numeric_limits<double>::infinity());
  }
}

TEST_CASE(
    "attribute files: VTP's arrays of every type, of several components, at points and cells") {
  const TemporaryFolder folder;
  io::SurfaceFile file = written_and_read(
      folder, "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  Random random(kSeed);
  for (const Site site : {Site::vertices, Site::faces})
    for (std::uint8_t type = 0; type < 10; ++type) {
      Attribute a{"array " + std::to_string(type), site, static_cast<NumberType>(type),
                  1 + type % 4u};
      for (std::size_t i = 0; i < 4 * a.components; ++i) {
        const std::uint64_t bits = random();
        a.words.push_back(a.type == NumberType::f32
                              ? std::bit_cast<std::uint64_t>(
                                    double(std::bit_cast<float>(static_cast<std::uint32_t>(bits))))
                          : type < 6 ? bits & 63
                                     : bits);
      }
      file.attributes.push_back(std::move(a));
    }
  file.attributes.push_back({"Normals", Site::vertices, NumberType::f32, 3,
                             std::vector<std::uint64_t>(12, std::bit_cast<std::uint64_t>(0.5))});
  const io::SurfaceFile after = again(folder, "b.vtp", file);
  REQUIRE(after.attributes.size() == file.attributes.size());
  for (const Attribute& a : file.attributes)
    CHECK(std::find(after.attributes.begin(), after.attributes.end(), a) != after.attributes.end());
  CHECK(again(folder, "c.off", file, file.attributes.size()).attributes.empty());
}

TEST_CASE("attribute files: OBJ's textures and normals at corners, colours, corners without") {
  const TemporaryFolder folder;
  const io::SurfaceFile file = written_and_read(
      folder, "a.obj",
      "v 0 0 0 1 0 0.5\nv 1 0 0 1 0 0.25\nv 1 1 0 0 0 0\nv 0 1 0 0.1 0 0\nv 2 2 2 1 1 1\n"
      "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.5\nvn 0 0 1\nvn 0 0.6 0.8\n"
      "f 1/1/1 2/2/1 3/3/1 4/4/1\nf 1//2 4//-1 5//2\nf 3/5/1 5/1/1 4/2/1\n");
  CHECK(named(file, "TCoords").site == Site::corners);
  CHECK(named(file, "TCoords").components == 2);
  const std::vector<bool> missing = named(file, "TCoords").missing;
  CHECK(std::count(missing.begin(), missing.end(), true) == 3);
  CHECK(named(file, "Normals").site == Site::corners);
  CHECK(named(file, "Normals").missing.empty());
  CHECK(named(file, "RGB").site == Site::vertices);
  const io::SurfaceFile after = again(folder, "b.obj", file);
  for (const char* name : {"TCoords", "Normals", "RGB"}) {
    INFO(name);
    CHECK(same_corners(file, after, name));
  }
  const io::SurfaceFile smooth =
      written_and_read(folder, "c.obj",
                       "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                       "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n");
  CHECK(named(smooth, "TCoords").site == Site::vertices);
  CHECK(again(folder, "d.vtp", smooth).attributes == smooth.attributes);
  again(folder, "e.ply", file, 2);  // colours alone
}

TEST_CASE("attribute files: OBJ's weights before colours, indices that name nothing") {
  const TemporaryFolder folder;
  const auto colours = [&](const std::string& end) {
    return written_and_read(folder, "a.obj",
                            "v 0 0 0" + end + "\nv 1 0 0" + end + "\nv 0 1 0" + end + "\nf 1 2 3\n")
        .attributes.size();
  };
  CHECK(colours(" 0.1 0.2 0.3") == 1);
  CHECK(colours(" 0.1 0.2 0.3 # three") == 1);
  CHECK(colours(" 1 0.1 0.2 0.3") == 0);
  CHECK(colours(" 1") == 0);
  const auto warnings = [&](const std::string& corner) {
    return written_and_read(folder, "a.obj",
                            "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0\nvt 1\nf 1/1 2/2 " + corner + "\n")
        .warnings;
  };
  for (const char* good : {"3", "3/", "3//", "3/1", "3/-2", "3/2/"}) {
    INFO(good);
    CHECK(warnings(good).empty());
  }
  for (const char* bad : {"3/3", "3/99", "3/-3", "3/x", "3/1x", "3/0", "3/+", "3/1.5"}) {
    INFO(bad);
    REQUIRE(warnings(bad).size() == 1);
    CHECK(warnings(bad)[0].find("left out TCoords at 1 corners") == 0);
  }
  CHECK(warnings("3/1/7")[0].find("left out Normals at 1 corners") == 0);
}

TEST_CASE("attribute files: corners of a polygon that meets a vertex twice keep their numbers") {
  // A square around a square hole, cut along its diagonal from vertex 0 to vertex 4.
  const TemporaryFolder folder;
  std::string text = "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 1 1 0\nv 2 1 0\nv 2 2 0\nv 1 2 0\n";
  for (int i = 1; i <= 10; ++i) text += "vt " + std::to_string(i) + "\n";
  text += "f 1/1 2/2 3/3 4/4 1/5 5/6 8/7 7/8 6/9 5/10\n";
  const io::SurfaceFile file = written_and_read(folder, "a.obj", text);
  const Attribute a = named(file, "TCoords");
  REQUIRE(a.site == Site::corners);
  CHECK(a.missing.empty());
  CHECK(file.warnings == std::vector<std::string>{"split 1 polygon into triangles"});
  REQUIRE(file.faces.size() == 8);
  const double below[] = {1, 2, 3, 4, 10, 9, 8, 7}, above[] = {5, 2, 3, 4, 6, 9, 8, 7};
  for (std::size_t f = 0; f < file.faces.size(); ++f) {
    double side = 0;  // of the diagonal on which the triangle is
    for (const auto v : file.faces[f]) side += file.points[v][1] - file.points[v][0];
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(std::bit_cast<double>(a.words[3 * f + k]) ==
            (side < 0 ? below : above)[file.faces[f][k]]);
  }
  CHECK(same_corners(file, again(folder, "b.obj", file), "TCoords"));
}

TEST_CASE("attribute files: names of a VTP that PLY cannot have") {
  const TemporaryFolder folder;
  io::SurfaceFile file = written_and_read(folder, "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  for (const char* name : {"x", "x", "my\nfield", "", "vertex_indices"})
    for (const Site site : {Site::vertices, Site::faces})
      file.attributes.push_back({name, site, NumberType::i32, 1, {}});
  for (std::size_t i = 0; i < file.attributes.size(); ++i)
    file.attributes[i].words.assign(file.attributes[i].site == Site::faces ? 1 : 3, i);
  const io::SurfaceFile after = again(folder, "b.ply", file);
  REQUIRE(after.attributes.size() == file.attributes.size());
  CHECK(after.points == file.points);
  CHECK(after.faces == file.faces);
}

TEST_CASE("attribute files: names that XML cannot have as they are") {
  const TemporaryFolder folder;
  io::SurfaceFile file = written_and_read(folder, "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const std::vector<std::pair<std::string, std::string>> names = {
      {"a<b&c>\"d'", "a<b&c>\"d'"},
      {"&lt;", "&lt;"},
      {"e\x1b[1m\n", "e_[1m_"},
      {std::string("f\0g", 3), "f_g"},
      {"h\xe9", "h_"},
      {"h\xc3\xa9", "h\xc3\xa9"},
      {"i\xed\xa0\x80\xef\xbf\xbf\xc0\x80\xe0\x80\x80", "i___________"},
      {"", "_"},
      {"_", "__"}};
  for (const auto& [name, after] : names)
    for (const Site site : {Site::vertices, Site::faces})
      file.attributes.push_back({name, site, NumberType::i32, 1, {}});
  for (std::size_t i = 0; i < file.attributes.size(); ++i)
    file.attributes[i].words.assign(file.attributes[i].site == Site::faces ? 1 : 3, i);
  const io::SurfaceFile after = again(folder, "b.vtp", file);
  REQUIRE(after.attributes.size() == file.attributes.size());
  for (std::size_t i = 0; i < file.attributes.size(); ++i) {
    const auto same = [&](const Attribute& a) {
      return a.name == names[i / 2].second && a.site == file.attributes[i].site &&
             a.words == file.attributes[i].words;
    };
    INFO(names[i / 2].second);
    CHECK(std::any_of(after.attributes.begin(), after.attributes.end(), same));
  }
}

}  // namespace
}  // namespace crest::tests
