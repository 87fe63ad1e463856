// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/certify/smooth_mutants.hpp"

#include <cmath>
#include <functional>

namespace crest::tests {
namespace {

using namespace certify;
using Claim = RidgesSmoothCertificate;

template <class Item>
Item& any(std::vector<Item>& list, Random& random) {
  return list[random() % list.size()];
}

template <class Integer>
void step(Integer& number, Random& random) {
  number = static_cast<Integer>(random() % 4 == 0 ? static_cast<Integer>(random())
                                                  : number + (random() % 2 ? 1 : -1));
}

void nudge(double& x, Random& random) {
  switch (random() % 5) {
    case 0:
      x = -x;
      break;
    case 1:
      x *= 1 + std::ldexp(uniform(random), -static_cast<int>(random() % 50));
      break;
    case 2:
      x = uniform(random);
      break;
    case 3:
      x = std::ldexp(x, static_cast<int>(random() % 40) - 20);
      break;
    default:
      x = 0;
  }
}

void mutate_number(Claim& c, Random& random) {
  switch (random() % 9) {
    case 0:
      return step(c.euler_characteristic, random);
    case 1:
      return step(c.boundary_loops, random);
    case 2: {
      step(c.components, random);
      if (c.surface.kind == 0) c.one_sheet.resize(c.components % 5);
      c.components = c.surface.kind == 0 ? c.components % 5 : c.components;
      return;
    }
    case 3:
    case 4:
      return step(c.umbilics[random() % 4], random);
    case 5:
    case 6:
      return step(c.counts[random() % 4], random);
    case 7:
      return step(c.turning_points[random() % 2], random);
    default:
      return step(c.purple_points, random);
  }
}

void mutate_mesh(Claim& c, Random& random) {
  const std::size_t f = random() % c.faces.size();
  const auto erase = [](auto& list, std::size_t i) {
    if (i < list.size()) list.erase(list.begin() + static_cast<std::ptrdiff_t>(i));
  };
  switch (random() % 9) {
    case 0:
      erase(c.faces, f);
      erase(c.lifts, f);
      return erase(c.face_records, f);
    case 1:
      c.faces.push_back(c.faces[f]);
      if (!c.lifts.empty()) c.lifts.push_back(c.lifts[f]);
      return c.face_records.push_back(c.face_records[f]);
    case 2:
      return std::swap(c.faces[f][0], c.faces[f][1]);
    case 3:
      return step(c.faces[f][random() % 3], random);
    case 4:
      return std::swap(c.faces[f], any(c.faces, random));
    case 5:
      return std::swap(any(c.vertices, random), any(c.vertices, random));
    case 6:
      if (!c.lifts.empty()) c.lifts[f] = static_cast<std::uint8_t>(c.lifts[f] ^ 1U << random() % 8);
      return;
    case 7:
      return c.vertices.push_back(any(c.vertices, random));
    default:
      return nudge(any(c.vertices, random)[random() % (c.surface.kind == 0 ? 6 : 2)], random);
  }
}

void mutate_record(Claim& c, Random& random) {
  SmoothFaceRecord& r = any(c.face_records, random);
  switch (random() % 8) {
    case 0:
      r.in_patch = !r.in_patch;
      return;
    case 1:
      r.frame[random() % 4] = static_cast<std::int8_t>(random());
      return;
    case 2:
      r.type[random() % 2] = static_cast<std::uint8_t>(random() % 4);
      return;
    case 3:
      r.purple = !r.purple;
      return;
    case 4:
      r.w = static_cast<std::uint8_t>(random() % 130);
      return;
    case 5:
      r.verdict[random() % 2] = SmoothFaceRecord::kNoZero;
      return;
    case 6:
      r.verdict[random() % 2] = static_cast<std::uint8_t>(random() % 129);
      return;
    default:
      std::swap(r, any(c.face_records, random));
  }
}

void mutate_patch(Claim& c, Random& random) {
  if (c.patches.empty()) return;
  SmoothPatchRecord& p = any(c.patches, random);
  switch (random() % 12) {
    case 0:
      p.axis = static_cast<std::uint8_t>(random() % 3);
      return;
    case 1:
      return step(p.twice_index, random);
    case 2:
      p.twice_index = static_cast<std::int8_t>(-p.twice_index);
      return;
    case 3:
      p.branches[random() % 2] = static_cast<std::uint8_t>(random() % 5);
      return;
    case 4:
      return nudge(p.centre[random() % 2], random);
    case 5:
      return nudge(p.rho, random);
    case 6:
      return nudge(p.radius, random);
    case 7:
      return nudge(p.height[random() % 2], random);
    case 8:
      p.faces.erase(p.faces.begin() + static_cast<std::ptrdiff_t>(random() % p.faces.size()));
      return;
    case 9:
      return step(any(p.faces, random), random);
    case 10: {
      // The record and its marks go together.
      for (const auto f : p.faces) c.face_records[f] = any(c.face_records, random);
      const SmoothPatchRecord copy = p;
      std::erase_if(c.patches, [&](const auto& q) { return q.faces == copy.faces; });
      return;
    }
    default:
      std::swap(p, any(c.patches, random));
  }
}

void mutate_sheets(Claim& c, Random& random) {
  if (c.surface.kind != 0) return mutate_record(c, random);
  switch (random() % 6) {
    case 0:
      return step(any(c.one_sheet, random).face, random);
    case 1:
      return nudge(any(c.graph_boxes, random).box[random() % 6], random);
    case 2:
      any(c.graph_boxes, random).axis = static_cast<std::uint8_t>(random() % 3);
      return;
    case 3:
      return step(any(c.graph_boxes, random).vertex, random);
    case 4:
      any(c.tree, random) = static_cast<std::uint8_t>(random() % 8);
      return;
    default:
      if (c.tree.size() > 1)
        c.tree.erase(c.tree.begin() + static_cast<std::ptrdiff_t>(random() % c.tree.size()));
  }
}

/// A byte changed, dropped, doubled or taken from another.
void mutate_bytes_of(Bytes& witness, const Bytes& other, Random& random) {
  if (witness.empty()) return witness.push_back(static_cast<std::uint8_t>(random()));
  const std::size_t at = random() % witness.size();
  switch (random() % 6) {
    case 0:
      witness[at] = static_cast<std::uint8_t>(random());
      return;
    case 1:
      witness[at] = static_cast<std::uint8_t>(witness[at] ^ 1U << random() % 8);
      return;
    case 2:
      return step(witness[at], random);
    case 3:
      witness.erase(witness.begin() + static_cast<std::ptrdiff_t>(at));
      return;
    case 4:
      witness.push_back(witness[at]);
      return;
    default:
      witness = other;
  }
}

void mutate_witness(Claim& c, Random& random) {
  const bool implicit = c.surface.kind == 0;
  switch (random() % (implicit ? 10 : 6)) {
    case 0:
    case 1:
    case 2:
      return mutate_bytes_of(any(c.face_records, random).witness,
                             any(c.face_records, random).witness, random);
    case 3:
      if (implicit) return step(c.reach, random);
      c.loose_corners = static_cast<std::uint8_t>(c.loose_corners ^ 1U << random() % 8);
      return;
    case 4:
    case 5: {
      if (c.patches.empty()) return;
      SmoothPatchRecord& p = any(c.patches, random);
      if (random() % 2) return mutate_bytes_of(p.witness, any(c.patches, random).witness, random);
      if (random() % 2) return nudge(p.krawczyk[random() % 4], random);
      if (implicit && random() % 3 == 0) return step(p.reach, random);
      if (implicit && random() % 2) return nudge(p.graph[random() % 6], random);
      p.order = p.order == 3 ? 5 : 3;
      return;
    }
    case 6:
      return mutate_bytes_of(any(c.graph_boxes, random).witness, any(c.graph_boxes, random).witness,
                             random);
    default: {
      OneSheetRecord& sheet = any(c.one_sheet, random);
      if (random() % 3 == 0) return nudge(sheet.matrix[random() % 4], random);
      if (random() % 2 || sheet.near.empty()) return mutate_bytes_of(sheet.witness, {}, random);
      if (random() % 3 == 0) return step(any(sheet.near, random).face, random);
      if (random() % 2)
        return mutate_bytes_of(any(sheet.near, random).witness, any(sheet.near, random).witness,
                               random);
      sheet.near.erase(sheet.near.begin() +
                       static_cast<std::ptrdiff_t>(random() % sheet.near.size()));
    }
  }
}

/// Another surface, or another box or domain.
void mutate_data(Claim& c, Random& random) {
  if (c.surface.kind == 0 && random() % 2) return nudge(c.surface.box[random() % 6], random);
  if (c.surface.kind == 1 && random() % 4 == 0) {
    c.surface.periodic = static_cast<std::uint8_t>(random() % 4);
    if (c.surface.periodic != 0) c.lifts.resize(c.faces.size());
    return;
  }
  std::string& text = any(c.surface.texts, random);
  text[random() % text.size()] = static_cast<char>("0123456789+-*/^.uvxyz() "[random() % 24]);
}

}  // namespace

std::string mutate_smooth_claim(Claim& c, Random& random) {
  using Mutation = void (*)(Claim&, Random&);
  const std::pair<const char*, Mutation> all[] = {
      {"number", mutate_number},   {"mesh", mutate_mesh},      {"record", mutate_record},
      {"patch", mutate_patch},     {"sheets", mutate_sheets},  {"data", mutate_data},
      {"witness", mutate_witness}, {"witness", mutate_witness}};
  const auto& [name, mutate] = all[random() % 8];
  mutate(c, random);
  return name;
}

bool same_results(const Claim& a, const Claim& b) {
  return a.euler_characteristic == b.euler_characteristic && a.boundary_loops == b.boundary_loops &&
         a.components == b.components && a.umbilics == b.umbilics && a.counts == b.counts &&
         a.turning_points == b.turning_points && a.purple_points == b.purple_points;
}

}  // namespace crest::tests
