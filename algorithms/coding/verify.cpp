// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/coding/verify.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "kernel/geometry/corner_table.hpp"
#include "kernel/predicates/within.hpp"

namespace crest::coding {
namespace {

using kernel::next_half;

/// A face from its least corner on, and the half-edge that starts there.
struct Turned {
  Triangle face;
  Index half;
  Turned(const Triangle& f, Index number) : face(f) {
    const auto least = std::min_element(face.begin(), face.end());
    half = 3 * number + static_cast<Index>(least - face.begin());
    std::rotate(face.begin(), least, face.end());
  }
};

/// The mesh's and the stream's faces, one beside the other.
struct Pairing {
  std::vector<Turned> mine, theirs;
};

Pairing paired_faces(const Encoded& encoded, const Decoded& decoded,
                     std::span<const Triangle> faces) {
  std::vector<bool> seen(decoded.info.vertices, false);
  for (const Index v : encoded.vertex_order) {
    if (v >= seen.size() || seen[v])
      throw std::logic_error("the stream's order of vertices is no permutation");
    seen[v] = true;
  }
  Pairing pairs;
  for (Index f = 0; f < faces.size(); ++f) pairs.mine.emplace_back(faces[f], f);
  for (Index f = 0; f < decoded.faces.size(); ++f) {
    Triangle face = decoded.faces[f];
    for (Index& v : face) v = encoded.vertex_order[v];
    pairs.theirs.emplace_back(face, f);
  }
  if (!decoded.info.keeps_order)
    for (std::vector<Turned>* list : {&pairs.mine, &pairs.theirs})
      std::sort(list->begin(), list->end(),
                [](const Turned& a, const Turned& b) { return a.face < b.face; });
  if (!std::equal(pairs.mine.begin(), pairs.mine.end(), pairs.theirs.begin(), pairs.theirs.end(),
                  [](const Turned& a, const Turned& b) { return a.face == b.face; }))
    throw std::logic_error("the stream decodes to other faces");
  return pairs;
}

/// Calls `same` with all places of the mesh and those in the stream.
template <class Same>
bool all_places(kernel::Site site, const Pairing& pairs, std::span<const Index> vertex_order,
                Same&& same) {
  if (site == kernel::Site::vertices) {
    for (Index v = 0; v < vertex_order.size(); ++v)
      if (!same(vertex_order[v], v)) return false;
    return true;
  }
  for (std::size_t f = 0; f < pairs.mine.size(); ++f) {
    Index mine = pairs.mine[f].half, theirs = pairs.theirs[f].half;
    if (site == kernel::Site::faces && !same(mine / 3, theirs / 3)) return false;
    if (site == kernel::Site::corners)
      for (int k = 0; k < 3; ++k, mine = next_half(mine), theirs = next_half(theirs))
        if (!same(mine, theirs)) return false;
  }
  return true;
}

void compare_attributes(const Encoded& encoded, const Decoded& decoded, const Pairing& pairs,
                        std::span<const kernel::Attribute> attributes) {
  const auto refuse = [] { throw std::logic_error("the stream decodes to other attributes"); };
  if (decoded.attributes.size() != attributes.size()) refuse();
  for (std::size_t i = 0; i < attributes.size(); ++i) {
    const kernel::Attribute &a = attributes[i], &b = decoded.attributes[i];
    if (a.name != b.name || a.site != b.site || a.type != b.type || a.components != b.components ||
        a.words.size() != b.words.size())
      refuse();
    const std::size_t places = a.places();
    const auto same = [&](Index p, Index q) {
      for (std::size_t first = 0; first < a.words.size(); first += places)
        if (a.words[first + p] != b.words[first + q]) return false;
      return a.has(p) == b.has(q);
    };
    if (!all_places(a.site, pairs, encoded.vertex_order, same)) refuse();
  }
}

}  // namespace

double verify(const Encoded& encoded, std::span<const Triangle> faces,
              std::span<const Point> points, const EncodeOptions& options,
              std::span<const kernel::Attribute> attributes) {
  const Decoded decoded =
      decode(encoded.stream, {.faces = static_cast<Index>(faces.size()),
                              .numbers = std::numeric_limits<std::size_t>::max()});
  compare_attributes(encoded, decoded, paired_faces(encoded, decoded, faces), attributes);
  double largest = 0;
  for (std::size_t v = 0; v < decoded.points.size(); ++v) {
    const Point &p = points[encoded.vertex_order[v]], &q = decoded.points[v];
    if (options.places == Places::exact) {
      if (std::memcmp(&p, &q, sizeof p) != 0)
        throw std::logic_error("the stream decodes to other points");
      continue;
    }
    if (!kernel::within(p, q, options.tolerance))
      throw std::logic_error("the stream decodes to points beyond the tolerance");
    largest = std::max(largest, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
  }
  return largest;
}

}  // namespace crest::coding
