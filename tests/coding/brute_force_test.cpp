// SPDX-License-Identifier: GPL-3.0-or-later
// All codes of up to seven nodes, all rooted triangulations of the disk and the sphere of up to
// nine vertices: theorem 4.2 of paper 001 is necessary, not sufficient.
#include <catch2/catch.hpp>
#include <map>
#include <optional>

#include "algorithms/coding/coding.hpp"
#include "algorithms/coding/reverse_mesh.hpp"
#include "algorithms/coding/stream_error.hpp"
#include "algorithms/coding/surface.hpp"
#include "algorithms/coding/thesis_codes.hpp"
#include "algorithms/coding/verify.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/support/failures.hpp"

namespace crest::tests {
namespace {

using coding::Method;
using coding::NodeType;
using coding::Places;
using coding::TreeNode;
using Code = std::vector<TreeNode>;  ///< in postorder
using kernel::Index;
using kernel::Triangle;

/// All codes of n nodes that obey conditions (i) and (ii), by n.
std::vector<std::vector<Code>> all_codes(std::size_t most) {
  std::vector<std::vector<Code>> codes(most + 1);
  const auto add = [&](std::size_t n, Code code, NodeType type, Index strips) {
    // (i): t + 1 <= 2 n; (ii): left odd, right one or even.
    for (Index l = 1; strips + l + 1 <= 2 * n; ++l) {
      if (type == NodeType::leaf && l > 1) break;
      if (type == NodeType::left && l % 2 == 0) continue;
      if (type == NodeType::right && l > 1 && l % 2 == 1) continue;
      Code longer = code;
      longer.push_back({type, l});
      codes[n].push_back(longer);
    }
  };
  const auto length = [](const Code& code) {
    Index t = 0;
    for (const TreeNode& node : code) t += node.length;
    return t;
  };
  add(1, {}, NodeType::leaf, 0);
  for (std::size_t n = 2; n <= most; ++n) {
    for (const Code& child : codes[n - 1])
      for (const NodeType type : {NodeType::left, NodeType::right})
        add(n, child, type, length(child));
    for (std::size_t k = 1; k + 1 < n; ++k)
      for (const Code& left : codes[k])
        for (const Code& right : codes[n - 1 - k]) {
          Code both = left;
          both.insert(both.end(), right.begin(), right.end());
          add(n, both, NodeType::both, length(left) + length(right));
        }
  }
  return codes;
}

struct Simple {
  Index vertices;
  std::vector<Triangle> faces;
};

/// The faces of a code, of the closed one if `closed`; nothing if two vertices have two edges.
std::optional<Simple> simple_mesh(const Code& code, bool closed) {
  coding::ReverseMesh mesh(coding::kNone);
  for (const TreeNode& node : code) coding::add_node(mesh, node);
  if (closed) mesh.fill(0);
  Simple result{};
  result.faces = mesh.take_faces(result.vertices);
  try {
    kernel::CornerTable(result.vertices, result.faces);
  } catch (const kernel::InputError&) {
    return std::nullopt;
  }
  return result;
}

TEST_CASE(
    "brute force: conditions (i) and (ii) are not sufficient, simple codes are Tutte's numbers") {
  const auto codes = all_codes(7);
  std::vector<std::size_t> obeying, simple;
  std::size_t longest = 0;
  for (std::size_t n = 2; n <= 7; ++n) {
    obeying.push_back(0);
    simple.push_back(0);
    for (const Code& code : codes[n]) {
      Index t = 0;
      for (const TreeNode& node : code) t += node.length;
      if (t + 1 != 2 * n) continue;  // three boundary edges
      ++obeying.back();
      simple.back() += simple_mesh(code, true) ? 1 : 0;
    }
  }
  CHECK(obeying == std::vector<std::size_t>{1, 4, 20, 116, 740, 5044});
  CHECK(simple == std::vector<std::size_t>{1, 3, 13, 68, 399, 2530});
  for (std::size_t n = 2; n <= 7; ++n) {
    longest = 0;
    for (const Code& code : codes[n])
      if (simple_mesh(code, false))
        for (const TreeNode& node : code) longest = std::max<std::size_t>(longest, node.length);
    CHECK(longest == n);  // v - 2, not v / 2
  }
  CHECK_FALSE(simple_mesh({{NodeType::leaf, 1}, {NodeType::right, 1}, {NodeType::left, 3}}, true));
}

TEST_CASE("brute force: all disks and spheres of up to nine vertices round trip") {
  const auto codes = all_codes(7);
  std::size_t meshes = 0;
  Failures failures;
  for (std::size_t n = 1; n <= 7; ++n)
    for (const Code& code : codes[n]) {
      Index t = 0;
      for (const TreeNode& node : code) t += node.length;
      for (const bool closed : {false, true}) {
        if (closed && (t + 1 != 2 * n || n < 2)) continue;
        const auto mesh = simple_mesh(code, closed);
        if (!mesh) continue;
        ++meshes;
        failures.expect(mesh->vertices == n + 2, "vertices", n, mesh->vertices);
        for (std::size_t m = 0; m < 4; ++m) {
          // Of the many largest ones each has its turn with one method.
          if (n == 7 && multiplier() == 1 && m != meshes % 4) continue;
          const coding::EncodeOptions options{.method = static_cast<Method>(m),
                                              .places = Places::none};
          bool same = true;
          try {
            const auto encoded = coding::encode(mesh->vertices, mesh->faces, {}, options);
            coding::verify(encoded, mesh->faces, {}, options);
          } catch (const std::exception&) {
            same = false;
          }
          failures.expect(same, "round trip", n, t);
        }
      }
    }
  CHECK(failures.report() == "");
  CHECK(meshes == 22993);
}

}  // namespace
}  // namespace crest::tests
