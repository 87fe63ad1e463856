// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/coding/verify.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "kernel/predicates/within.hpp"

namespace crest::coding {
namespace {

Triangle turned(const Triangle& f) {
  const auto least = static_cast<std::size_t>(std::min_element(f.begin(), f.end()) - f.begin());
  return {f[least], f[(least + 1) % 3], f[(least + 2) % 3]};
}

void compare_faces(const Encoded& encoded, const Decoded& decoded, std::span<const Triangle> faces) {
  std::vector<bool> seen(decoded.info.vertices, false);
  for (const Index v : encoded.vertex_order) {
    if (v >= seen.size() || seen[v]) throw std::logic_error("the stream's order of vertices is no permutation");
    seen[v] = true;
  }
  std::vector<Triangle> mine, theirs;
  for (const Triangle& f : faces) mine.push_back(turned(f));
  for (const Triangle& f : decoded.faces)
    theirs.push_back(turned({encoded.vertex_order[f[0]], encoded.vertex_order[f[1]], encoded.vertex_order[f[2]]}));
  if (!decoded.info.keeps_order) {
    std::sort(mine.begin(), mine.end());
    std::sort(theirs.begin(), theirs.end());
  }
  if (mine != theirs) throw std::logic_error("the stream decodes to other faces");
}

}  // namespace

double verify(const Encoded& encoded, std::span<const Triangle> faces, std::span<const Point> points,
              const EncodeOptions& options) {
  const Decoded decoded = decode(encoded.stream, static_cast<Index>(faces.size()));
  compare_faces(encoded, decoded, faces);
  double largest = 0;
  for (std::size_t v = 0; v < decoded.points.size(); ++v) {
    const Point &p = points[encoded.vertex_order[v]], &q = decoded.points[v];
    if (options.places == Places::exact) {
      if (std::memcmp(&p, &q, sizeof p) != 0) throw std::logic_error("the stream decodes to other points");
      continue;
    }
    if (!kernel::within(p, q, options.tolerance))
      throw std::logic_error("the stream decodes to points beyond the tolerance");
    largest = std::max(largest, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
  }
  return largest;
}

}  // namespace crest::coding
