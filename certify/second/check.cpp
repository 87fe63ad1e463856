// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/second/check.hpp"

#include "certify/second/crossings.hpp"
#include "certify/second/graph.hpp"
#include "certify/second/patches.hpp"

namespace crest::recheck {
namespace {

std::string in_words(const Certificate& c) {
  const auto n = [](std::uint64_t x) { return std::to_string(x); };
  std::string s = "For the data " + c.digest + ": the surface ";
  s += c.implicit ? "{F = 0} in its box is smooth and closed, with "
                  : "is immersed, its domain has ";
  s += "Euler characteristic " + std::to_string(c.euler) + ", " + n(c.components) +
       " components, " + n(c.boundary_loops) + " boundary loops.\nUmbilics: " + n(c.umbilics[0]) +
       " of index 1/2, " + n(c.umbilics[1]) + " of index -1/2; " + n(c.umbilics[2]) +
       " with one blue branch, " + n(c.umbilics[3]) + " with three.\n";
  for (std::size_t j = 0; j < 2; ++j)
    s += (j == 0 ? "Blue: " : "Red: ") + n(c.curves[j][0]) + " loops, " + n(c.curves[j][1]) +
         " paths, " + n(c.turning[j]) + " turning points.\n";
  return s + "Purple points: " + n(c.purple) + ".\n";
}

void prove(const Certificate& c) {
  const Surface surface(c);  // 1
  const Complex complex(c);  // 2
  const Problem problem = {c, surface, complex};
  if (c.implicit && !complex.closed()) throw Rejected("the triangulation has a boundary");
  if (!c.implicit) check_parametric_chart(problem);
  const LooseCorners loose(problem);
  std::vector<FaceOutcome> outcomes(c.faces.size());  // 3 and 4, a face at a time
  in_parallel(c.faces.size(), [&](Index f) {
    try {
      outcomes[f] = check_face(problem, loose, f);
    } catch (const Open& open) {
      throw Rejected("face " + std::to_string(f) + ": not shown: " + open.what);
    } catch (const Undefined&) {
      throw Rejected("face " + std::to_string(f) + ": a part is not certainly defined");
    }
  });
  const auto crossed = crossed_edges(problem, loose, outcomes);
  if (c.implicit) {
    check_sheets(problem, outcomes);
    check_completeness(problem, outcomes);
  }
  check_patches(problem);         // 5
  check_graph(problem, crossed);  // 6
}

}  // namespace

std::string recheck(const Bytes& file) {
  const Certificate c = decode(file);
  try {
    prove(c);
  } catch (const Open& open) {
    throw Rejected(std::string("not shown: ") + open.what);
  } catch (const Undefined&) {
    throw Rejected("a part of an expression is not certainly defined");
  }
  return in_words(c);
}

}  // namespace crest::recheck
