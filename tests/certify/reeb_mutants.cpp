// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/certify/reeb_mutants.hpp"

#include <algorithm>
#include <functional>

#include "tests/support/edits.hpp"

namespace crest::tests {
namespace {

using namespace certify;
using u32 = std::uint32_t;

template <class Row>
std::size_t place(const std::vector<Row>& rows, Random& random) {
  return rows.empty() ? 0 : random() % rows.size();
}

void sort_arcs(ReebCertificate& c) {
  std::sort(c.arcs.begin(), c.arcs.end(), [](const ArcRecord& a, const ArcRecord& b) {
    return a.lower != b.lower ? a.lower < b.lower : a.upper < b.upper;
  });
}

void exchange_ends(ReebCertificate& c, Random& random) {
  if (c.arcs.empty()) return;
  ArcRecord &a = c.arcs[place(c.arcs, random)], &b = c.arcs[place(c.arcs, random)];
  if (random() % 2)
    std::swap(a.upper, b.upper);
  else
    std::swap(a.lower, b.lower);
}

void move_end(ReebCertificate& c, Random& random) {
  if (c.arcs.empty()) return;
  ArcRecord& a = c.arcs[place(c.arcs, random)];
  (random() % 2 ? a.upper : a.lower) = static_cast<u32>(place(c.critical_nodes, random));
}

void swap_in_order(ReebCertificate& c, Random& random) {
  const std::size_t i = place(c.order, random);
  const std::size_t j = random() % 2 ? (i + 1) % c.order.size() : place(c.order, random);
  std::swap(c.order[i], c.order[j]);
}

}  // namespace

std::string mutate_reeb_claim(ReebCertificate& c, Random& random) {
  using Edit = std::pair<const char*, std::function<void()>>;
  u32* const counts[] = {&c.boundary_loops, &c.components, &c.tiles,
                         &c.minima,         &c.saddles,    &c.maxima};
  const Edit edits[] = {
      {"euler", [&] { edit_number(c.euler_characteristic, random); }},
      {"count", [&] { edit_number(*counts[random() % 6], random); }},
      {"ties", [&] { edit_number(random() % 2 ? c.tied_arcs : c.contracted_nodes, random); }},
      {"ties swapped", [&] { std::swap(c.tied_arcs, c.contracted_nodes); }},
      {"kinds of nodes",
       [&] {
         const u32 moved = c.line_critical > 0 ? 1 : 0;
         c.line_critical -= moved, c.face_critical += moved;
       }},
      {"order", [&] { swap_in_order(c, random); }},
      {"order doubled", [&] { c.order[place(c.order, random)] = c.order[place(c.order, random)]; }},
      {"order number", [&] { edit_number(c.order[place(c.order, random)], random); }},
      {"critical list", [&] { edit_list(c.critical_nodes, random); }},
      {"critical node",
       [&] { edit_number(c.critical_nodes[place(c.critical_nodes, random)], random); }},
      {"arc list", [&] { edit_list(c.arcs, random); }},
      {"arc list sorted",
       [&] {
         edit_list(c.arcs, random);
         sort_arcs(c);
       }},
      {"ends exchanged",
       [&] {
         exchange_ends(c, random);
         if (random() % 4) sort_arcs(c);
       }},
      {"arc moved",
       [&] {
         move_end(c, random);
         if (random() % 4) sort_arcs(c);
       }},
      {"arc turned",
       [&] {
         if (!c.arcs.empty()) {
           ArcRecord& a = c.arcs[place(c.arcs, random)];
           std::swap(a.lower, a.upper);
         }
       }},
      {"arc number",
       [&] {
         if (!c.arcs.empty()) edit_number(c.arcs[place(c.arcs, random)].upper, random);
       }},
      {"cut list", [&] { edit_list(c.cuts, random); }},
      {"cut arc",
       [&] {
         if (!c.cuts.empty()) edit_number(c.cuts[place(c.cuts, random)].arc, random);
       }},
      {"cut moved",
       [&] {
         if (!c.cuts.empty())
           c.cuts[place(c.cuts, random)].node = static_cast<u32>(place(c.order, random));
       }},
      {"cut to another arc",
       [&] {
         if (!c.cuts.empty())
           c.cuts[place(c.cuts, random)].arc = static_cast<u32>(place(c.arcs, random));
       }},
  };
  const Edit& edit = edits[random() % std::size(edits)];
  edit.second();
  return edit.first;
}

std::string mutate_reeb_data(ReebCertificate& c, Random& random) {
  auto& values = !c.edge_values.empty() && random() % 2 ? c.edge_values : c.values;
  double& x = values[place(values, random)];
  auto& face = c.faces[place(c.faces, random)];
  switch (random() % 9) {
    case 0:
      x = uniform(random);
      return "value";
    case 1:
      x = static_cast<double>(random() % 5) - 2;
      return "small value";
    case 2:
      std::swap(x, values[place(values, random)]);
      return "values swapped";
    case 3:
      x = x == 0 ? 1 : -x;
      return "sign";
    case 4:
      x *= 1 + 0x1p-40;
      return "a little";
    case 5:
      std::swap(face[random() % 3], face[random() % 3]);
      return "corners";
    case 6:
      face[random() % 3] = static_cast<u32>(place(c.values, random));
      return "corner";
    case 7:
      std::swap(face, c.faces[place(c.faces, random)]);
      return "faces swapped";
    default:
      c.positions[place(c.positions, random)][random() % 3] = uniform(random);
      return "position";
  }
}

void rewire(ReebCertificate& c, const std::vector<std::array<u32, 2>>& contours, Random& random) {
  for (std::size_t i = 1 + random() % 2; i > 0; --i) switch (random() % 5) {
      case 0:
        move_end(c, random);
        break;
      case 1:
        edit_list(c.arcs, random);
        break;
      default:
        exchange_ends(c, random);
    }
  for (ArcRecord& a : c.arcs)
    if (a.lower > a.upper) std::swap(a.lower, a.upper);
  sort_arcs(c);
  // A spanning forest in random order; what closes a loop is cut, and some more.
  std::vector<u32> parent(c.critical_nodes.size()), shuffled(c.arcs.size());
  for (u32 i = 0; i < parent.size(); ++i) parent[i] = i;
  for (u32 a = 0; a < shuffled.size(); ++a) shuffled[a] = a;
  std::shuffle(shuffled.begin(), shuffled.end(), random);
  const auto find = [&](u32 v) {
    while (parent[v] != v) v = parent[v];
    return v;
  };
  std::vector<u32> chosen;
  for (const u32 a : shuffled) {
    const u32 low = find(c.arcs[a].lower), high = find(c.arcs[a].upper);
    if (low == high || random() % 8 == 0) chosen.push_back(a);
    parent[low] = high;
  }
  std::sort(chosen.begin(), chosen.end());
  auto left = contours;
  std::shuffle(left.begin(), left.end(), random);
  c.cuts.clear();
  for (const u32 a : chosen) {
    const auto at = std::find_if(left.begin(), left.end(),
                                 [&](const auto& x) { return x[0] == c.arcs[a].lower; });
    if (at == left.end()) continue;
    c.cuts.push_back({a, (*at)[1]});
    left.erase(at);
  }
}

}  // namespace crest::tests
