// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/strips/strips.hpp"

#include <algorithm>

namespace crest::strips {
namespace {

/// A face's side is left to the right if it follows the one of entry.
bool turns_right(const Step& step) {
  return step.exit == kernel::next_half(step.entry);
}

/// A strip's second face has to turn left, and then the turns alternate: what deviates is a swap.
std::size_t swaps_of(const Path& path) {
  std::size_t swaps = 0;
  bool natural = false;
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const bool right = turns_right(path[i]);
    if (right != natural) ++swaps;
    natural = !right;
  }
  return swaps;
}

class Writer {
 public:
  explicit Writer(std::span<const Triangle> faces) : faces_(faces) {}

  void write(const Path& path) {
    const Step& first = path.front();
    const Index exit = first.exit == kernel::kNone ? 3 * first.face : first.exit;
    for (const Index h : {kernel::previous_half(exit), exit, kernel::next_half(exit)})
      send(start_of(h));
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Step& step = path[i];
      const Index apex = start_of(kernel::previous_half(step.entry));
      const Index older = strips_.vertices[strips_.vertices.size() - 2];
      if (step.exit != kernel::kNone && leaves_by(step.exit, older)) {
        send(older);
        ++strips_.swaps;
      }
      send(apex);
    }
    strips_.begin.push_back(strips_.vertices.size());
  }
  Strips take() { return std::move(strips_); }

 private:
  Index start_of(Index h) const { return faces_[h / 3][h % 3]; }
  bool leaves_by(Index h, Index v) const {
    return start_of(h) == v || start_of(kernel::next_half(h)) == v;
  }
  void send(Index v) { strips_.vertices.push_back(v); }

  std::span<const Triangle> faces_;
  Strips strips_;
};

/// The pieces of a path that need no swap, from either of their ends. A piece of two equal turns
/// ends before the second of their faces.
void cut_at_swaps(const Path& path, std::vector<Path>& pieces) {
  std::size_t from = 0;
  while (from < path.size()) {
    std::size_t to = std::min(from + 2, path.size());
    while (to < path.size() &&
           (to < from + 3 || turns_right(path[to - 1]) != turns_right(path[to - 2])))
      ++to;
    const auto piece = [&] {
      Path p(path.begin() + static_cast<std::ptrdiff_t>(from),
             path.begin() + static_cast<std::ptrdiff_t>(to));
      p.front().entry = p.back().exit = kernel::kNone;
      return swaps_of(p) == 0 ? p : reversed(p);
    };
    // With an even number of turns both ends may be the wrong ones.
    Path p = piece();
    if (swaps_of(p) > 0) {
      --to;
      p = piece();
    }
    pieces.push_back(std::move(p));
    from = to;
  }
}

Strips write_paths(std::span<const Triangle> faces, const std::vector<Path>& paths, bool swaps) {
  Writer writer(faces);
  std::vector<Path> pieces;
  for (const Path& path : paths) {
    if (!swaps) {
      cut_at_swaps(path, pieces);
      continue;
    }
    Path other = reversed(path);
    pieces.push_back(swaps_of(other) < swaps_of(path) ? std::move(other) : path);
  }
  for (const Path& piece : pieces) writer.write(piece);
  return writer.take();
}

}  // namespace

Strips strips_of(const CornerTable& mesh, std::span<const Triangle> faces, Links start,
                 const StripOptions& options) {
  Strips plain = write_paths(faces, paths_of(mesh, start), options.swaps);
  if (options.effort == 0) return plain;
  anneal(mesh, start, options.effort, options.swaps ? 1 : 2);
  Strips annealed = write_paths(faces, paths_of(mesh, std::move(start)), options.swaps);
  return plain.vertices.size() <= annealed.vertices.size() ? plain : annealed;
}

double saved_per_cent(const Strips& strips, std::size_t faces) {
  return 100 * (1 - static_cast<double>(strips.vertices.size()) / (3 * static_cast<double>(faces)));
}

Triangle least_first(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

std::vector<Triangle> triangles_of(const Strips& strips, std::size_t s) {
  const std::span<const Index> v = strips.strip(s);
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i + 2 < v.size(); ++i) {
    if (v[i] == v[i + 1] || v[i + 1] == v[i + 2] || v[i] == v[i + 2]) continue;
    triangles.push_back(least_first(i % 2 == 0 ? Triangle{v[i], v[i + 1], v[i + 2]}
                                               : Triangle{v[i + 1], v[i], v[i + 2]}));
  }
  return triangles;
}

bool covers(const Strips& strips, std::span<const Triangle> faces) {
  std::vector<Triangle> sent, wanted;
  for (std::size_t s = 0; s < strips.count(); ++s)
    for (const Triangle& t : triangles_of(strips, s)) sent.push_back(t);
  for (const Triangle& t : faces) wanted.push_back(least_first(t));
  std::sort(sent.begin(), sent.end());
  std::sort(wanted.begin(), wanted.end());
  return sent == wanted;
}

}  // namespace crest::strips
