// SPDX-License-Identifier: GPL-3.0-or-later
// Texts read in parts give what the readers of their formats give, which read one after the other.
#include "io/formats/text_parts.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <optional>

#include "tests/io/bytes.hpp"
#include "tests/io/soups.hpp"
#include "tests/support/random.hpp"

namespace {

using namespace crest::io;
using namespace crest::tests;

/// Vertices and triangles, more than a part of a text holds.
struct Mesh {
  std::vector<std::string> points, faces;

  explicit Mesh(int vertices) {
    Random random(11);
    const auto coordinate = [&] { return std::ldexp(static_cast<double>(random()), -40); };
    for (int v = 0; v < vertices; ++v)
      points.push_back(fmt::format("{} {} {:.3f}", coordinate(), -coordinate(), coordinate()));
    for (int f = 0; f < 2 * vertices; ++f)
      faces.push_back(
          fmt::format("{} {} {}", f % vertices, (7 * f + 1) % vertices, (f / 2 + 2) % vertices));
  }
  std::string off(const std::string& behind = "") const {
    std::string text = fmt::format("OFF\n{} {} 0\n", points.size(), faces.size());
    for (const auto& p : points) text += p + behind + "\n";
    for (const auto& f : faces) text += "3 " + f + behind + "\n";
    return text;
  }
  std::string ply() const {
    std::string text = fmt::format(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\n"
        "property float z\nproperty uchar red\nelement face {}\n"
        "property list uchar int vertex_indices\nproperty int label\nend_header\n",
        points.size(), faces.size());
    for (const auto& p : points) text += p + " 7\n";
    for (const auto& f : faces) text += "3 " + f + " 5\n";
    return text;
  }
};

bool same(const Soup& a, const Soup& b) {
  if (a.points != b.points || a.cells.size() != b.cells.size()) return false;
  for (std::size_t c = 0; c < a.cells.size(); ++c)
    if (a.cells.type(c) != b.cells.type(c) || nodes_of(a, c) != nodes_of(b, c)) return false;
  return a.point_fields.size() == b.point_fields.size() &&
         a.cell_fields.size() == b.cell_fields.size() && a.warnings == b.warnings;
}

/// With a blank line that the readers of parts do not know.
std::string with_blank_line(std::string text, const std::string& before) {
  return text.insert(text.find(before), " \n");
}

std::size_t size_of_header(const std::string& text) {
  return text.find('\n', text.find('\n') + 1) + 1;
}

}  // namespace

TEST_CASE("parts of a text are lines, and all of it", "[io]") {
  const std::string text = "a\nbb\n\nccc\ndd";
  for (const std::size_t size : {1, 2, 3, 5, 100}) {
    std::size_t begin = 2;
    for (const TextPart& part : text_parts(text, 2, size)) {
      CHECK(part.begin == begin);
      CHECK((part.end == text.size() || text[part.end - 1] == '\n'));
      CHECK(part.end - part.begin <= std::max<std::size_t>(size + 3, 4));
      begin = part.end;
    }
    CHECK(begin == text.size());
  }
  CHECK(text_parts("", 0).empty());
  CHECK(text_parts("a\n", 2).empty());
}

TEST_CASE("rows of triangles in parts are those of the reader of the format", "[io]") {
  const Mesh mesh(40000);
  for (const std::size_t threads : {1, 2}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const std::string off = mesh.off();
    Soup soup;
    REQUIRE(read_triangle_rows(off, {size_of_header(off), 40000, 80000, {}, {}, '#'}, soup));
    CHECK(soup.points.size() == 40000);
    CHECK(soup.cells.size() == 80000);
    CHECK(same(soup, soup_of("a.off", with_blank_line(off, mesh.points[3]))));
    CHECK(same(soup, soup_of("a.off", mesh.off(" 1 2 3 # colour"))));
    const std::string ply = mesh.ply();
    CHECK(same(soup_of("a.ply", ply), soup_of("a.ply", with_blank_line(ply, mesh.points[3]))));
  }
}

TEST_CASE("what a row of triangles is not is left to the reader of the format", "[io]") {
  const Mesh mesh(30);
  const std::string off = mesh.off();
  const std::size_t begin = size_of_header(off);
  const auto read = [&](const std::string& text, std::size_t vertices, std::size_t faces,
                        std::optional<std::size_t> behind = std::nullopt) {
    Soup soup;
    const bool good = read_triangle_rows(text, {begin, vertices, faces, behind, behind, '#'}, soup);
    CHECK(soup.cells.size() == (good ? faces : 0));
    return good;
  };
  CHECK(read(off, 30, 60));
  CHECK(read(off.substr(0, off.size() - 1), 30, 60));  // no line feed at its end
  CHECK(read(off, 30, 60, 0));
  CHECK(read(off + "more\n", 30, 60));
  CHECK_FALSE(read(off, 30, 61));  // a line is missing
  CHECK_FALSE(read(off, 29, 60));
  CHECK_FALSE(read(mesh.off(" 1"), 30, 60, 0));  // words behind
  CHECK_FALSE(read(off, 30, 60, 1));
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = off;
    text.replace(text.find(from, begin), from.size(), to);
    return text;
  };
  for (const std::string bad : {"nan 1 2", "1 2", "1 2 x", "inf 0 0", "# 1 2 3", "", "1,5 2 3"})
    CHECK_FALSE(read(changed(mesh.points[4], bad), 30, 60));
  for (const std::string bad : {"4 0 1 2 3", "3 0 1", "3 0 1 30", "3 0 1 -1", "3 0 1 2.5", "2 0 1"})
    CHECK_FALSE(read(changed("3 " + mesh.faces[9], bad), 30, 60));
  std::string returns = off;  // as many lines, but not as many line feeds
  returns[returns.find('\n', begin)] = '\r';
  CHECK_FALSE(read(returns, 30, 60));
}

TEST_CASE("triangles of OBJ in parts are those of its reader", "[io]") {
  Random random(13);
  std::string text = "# made here\nmtllib a.mtl\n";
  for (int v = 0; v < 30000; ++v)
    text += fmt::format("v {} {} {}\nvn 0 0 1\n", v, random() % 1000, -1.5 * v);
  for (int f = 0; f < 60000; ++f)
    text += fmt::format("f {}//1 {}/2/3 {}\n", f % 30000 + 1, 7 * f % 30000 + 1, f / 2 + 1);
  for (const std::size_t threads : {1, 2}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    Soup soup;
    REQUIRE(read_obj_triangles(text, soup));
    Soup with_line = soup_of("a.obj", text + "l 1 2\n");  // which only the reader knows
    REQUIRE(with_line.cells.size() == 60001);
    with_line.cells = soup.cells;
    CHECK(same(soup, with_line));
    CHECK(same(soup, soup_of("a.obj", text)));
    CHECK(nodes_of(soup_of("a.obj", text + "l 1 2\n"), 59999) == nodes_of(soup, 59999));
  }
  const std::string good = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  Soup soup;
  CHECK(read_obj_triangles(good + "f 1 2 3\n", soup));
  CHECK(read_obj_triangles("f 1 2 3\r\n" + good, soup));
  for (const std::string bad : {"f 1 2\n", "f 1 2 3 1\n", "f 1 2 4\n", "f 1 2 -1\n", "f 1 2 0\n",
                                "f 1 2 x\n", "p 1\n", "v 1 2\n", "v 1 2 nan\n", "f 1 2 3.5\n"}) {
    INFO(bad);
    Soup none;
    CHECK_FALSE(read_obj_triangles(good + bad, none));
    CHECK(none.points.empty());
  }
}

TEST_CASE("triangles of OBJ in parts begin behind a byte order mark", "[io]") {
  for (const std::string first : {"v 9 9 9\n", "f 1 3 2\n"}) {
    const std::string text = "\xef\xbb\xbf" + first + "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    Soup soup;
    REQUIRE(read_obj_triangles(text, soup));
    CHECK(soup.points.size() == (first[0] == 'v' ? 4 : 3));
    CHECK(soup.cells.size() == (first[0] == 'f' ? 2 : 1));
  }
}

TEST_CASE("rows that the bytes are too few for are not made room for", "[io]") {
  const std::size_t lines = 100000;
  const std::string text = "0 0 0\n" + std::string(lines, '\n');
  Soup soup;
  TriangleRows rows;
  rows.vertices = lines;
  CHECK_FALSE(read_triangle_rows(text, rows, soup));
  const std::string least = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2";
  rows.vertices = 3;
  rows.faces = 1;
  CHECK(read_triangle_rows(least, rows, soup));
}

namespace {

/// A small text of vertices and triangles as other programs write them, and worse: some rows may be
/// none. `vertex`, `face`: what starts a line.
std::string odd_text(Random& random, int vertices, int faces, const std::string& vertex,
                     const std::string& face, int first) {
  const auto pick = [&](std::initializer_list<const char*> list) {
    return std::string(list.begin()[random() % list.size()]);
  };
  const std::uint64_t rare = std::array{5, 40, 1000}[random() % 3];
  const auto rarely = [&] { return random() % rare == 0; };
  const auto number = [&] {
    return rarely() ? pick({"1.#QNAN", "1e400", "1,5", "x", "1.5D+00"})
                    : pick({"0", "1", "-2.5", "+3", "1e-3", ".5", "7.", "123456789012345678", "-0",
                            "0.1000000000000000055511151231257827021181583404541015625"});
  };
  const auto blank = [&] {
    return rarely() ? pick({"\t", "\v", "\f", " \t "}) : pick({" ", "  "});
  };
  const auto line_end = [&] {
    return rarely() ? pick({"\r", "# 1 2\n", " # n\r\n", "\n\n", "\n\r"})
                    : pick({"\n", "\r\n", " \n"});
  };
  const auto more = [&] { return rarely() ? blank() + number() : ""; };
  std::string text;
  for (int v = 0; v < vertices; ++v)
    text += vertex + number() + blank() + number() + blank() + number() + more() + line_end();
  for (int f = 0; f < faces; ++f) {
    text += face;
    for (int k = 0; k < 3; ++k) {
      const int most = rarely() ? vertices + 1 : vertices;
      text += blank() + std::to_string(first + static_cast<int>(random() % std::uint64_t(most)));
      if (first == 1) text += pick({"", "", "/1", "//2", "/", "/x/3"});
    }
    text += more() + line_end();
  }
  if (rarely()) text += pick({"\n", "\n\n\n", "1 2 3\n", "3 0 0 0\n0 1 2\n"});
  if (rarely()) text.pop_back();
  if (rarely()) text[random() % text.size()] = pick({" ", "\n", "\r", "#", "3", "-"})[0];
  return text;
}

/// The reader of the format, one line after the other; nothing where it refuses.
std::optional<Soup> read_in_order(const std::string& name, const std::string& text) {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  try {
    return soup_of(name, text);
  } catch (const crest::kernel::InputError&) {
    return std::nullopt;
  }
}

}  // namespace

TEST_CASE("parts smaller than a line, wherever cuts are, give what the readers give", "[io]") {
  Random random(17);
  std::size_t read = 0, left = 0;
  const auto check = [&](const std::string& name, const std::string& text, const auto& read_parts) {
    const auto expected = read_in_order(name, text);
    for (const std::size_t size : {1, 2, 5, 13, 40, 1000}) {
      Soup soup;
      const bool done = read_parts(size, soup);
      ++(done ? read : left);
      INFO(name << ", parts of " << size << ":\n" << text);
      if (done) REQUIRE((expected && same(soup, *expected)));
    }
  };
  // As many line feeds as rows, but a row more.
  const std::string returned = "OFF\n3 1 0\n0 0 0\r1 1 1\n2 2 2\n3 0 1 2\n3 0 0 0\n";
  check("a.off", returned, [&](std::size_t size, Soup& soup) {
    return read_triangle_rows(returned, {size_of_header(returned), 3, 1, {}, {}, '#'}, soup, size);
  });
  for (std::uint64_t i = 0; i < scaled(400); ++i) {
    const int vertices = 1 + static_cast<int>(random() % 6),
              faces = 1 + static_cast<int>(random() % 6);
    const std::string obj = odd_text(random, vertices, faces, "v ", "f", 1);
    check("a.obj", obj,
          [&](std::size_t size, Soup& soup) { return read_obj_triangles(obj, soup, size); });
    const std::string head = fmt::format("OFF\n{} {} 0\n", vertices, faces);
    const std::string off = head + odd_text(random, vertices, faces, "", "3", 0);
    const auto v = static_cast<std::size_t>(vertices), f = static_cast<std::size_t>(faces);
    check("a.off", off, [&](std::size_t size, Soup& soup) {
      return read_triangle_rows(off, {head.size(), v, f, {}, {}, '#'}, soup, size);
    });
    const std::string ply_head = fmt::format(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty "
        "float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
        vertices, faces);
    const std::string ply = ply_head + odd_text(random, vertices, faces, "", "3", 0);
    check("a.ply", ply, [&](std::size_t size, Soup& soup) {
      return read_triangle_rows(ply, {ply_head.size(), v, f, 0, 0}, soup, size);
    });
  }
  CHECK(read > 500);
  CHECK(left > 500);
}
