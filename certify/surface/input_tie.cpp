// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/surface/input_tie.hpp"

#include <algorithm>
#include <bit>

#include "certify/container/reject.hpp"
#include "certify/surface/union_find.hpp"

namespace crest::certify {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

enum class Match { other, same, opposite };

/// How `turned` runs around the corners of `stated`.
Match match(Triangle turned, const Triangle& stated) {
  for (int i = 0; i < 3; ++i) {
    if (turned == stated) return Match::same;
    if (Triangle{turned[0], turned[2], turned[1]} == stated) return Match::opposite;
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
  }
  return Match::other;
}

/// The least vertex of every vertex's component.
std::vector<std::uint32_t> components(std::size_t vertices, Faces faces) {
  UnionFind classes(vertices);
  for (const auto& f : faces)
    for (const std::size_t i : {1, 2}) classes.join(f[0], f[i]);
  std::vector<std::uint32_t> least(vertices);
  for (std::size_t v = 0; v < vertices; ++v) least[v] = classes.find(static_cast<std::uint32_t>(v));
  return least;
}

/// The faces are matched one by one: what that says of each component, in words.
std::string orientations(std::size_t vertices, Faces faces, const std::vector<Match>& matches) {
  struct Count {
    std::size_t faces = 0, opposite = 0;
  };
  const auto component = components(vertices, faces);
  std::vector<Count> counts(vertices);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    Count& count = counts[component[faces[f][0]]];
    ++count.faces;
    count.opposite += matches[f] == Match::opposite;
  }
  std::size_t all = 0, turned = 0, mixed = 0, flipped = 0;
  for (const auto& [size, opposite] : counts) {
    all += size > 0;
    turned += size > 0 && opposite == size;
    if (opposite == 0 || opposite == size) continue;
    ++mixed;
    flipped += opposite;
  }
  if (turned == 0 && mixed == 0) return "oriented as in the file";
  std::string words = "re-oriented";
  if (turned > 0) words += fmt::format(" {} of {} components", turned, all);
  if (mixed > 0)
    words += fmt::format("{} {} faces of {} components that the file does not orient alike",
                         turned > 0 ? " and" : "", flipped, mixed);
  return words;
}

}  // namespace

std::string check_input(const InputMesh& input, std::span<const std::array<double, 3>> positions,
                        Faces faces) {
  const std::string& name = input.name;
  require(input.positions.size() == positions.size(), "{}: {} vertices, {} in the certificate",
          name, input.positions.size(), positions.size());
  require(input.faces.size() == faces.size(), "{}: {} faces, {} in the certificate", name,
          input.faces.size(), faces.size());
  for (std::size_t v = 0; v < positions.size(); ++v)
    for (std::size_t i = 0; i < 3; ++i)
      require(std::bit_cast<std::uint64_t>(input.positions[v][i]) ==
                  std::bit_cast<std::uint64_t>(positions[v][i]),
              "{}: vertex {} is elsewhere", name, v);
  std::vector<Match> matches;
  matches.reserve(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto& [a, b, c] = faces[f];
    matches.push_back(match(input.faces[f], {a, b, c}));
    require(matches.back() != Match::other, "{}: face {} has other corners", name, f);
  }
  return orientations(positions.size(), faces, matches);
}

}  // namespace crest::certify
