// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 15: wrong claims are rejected. The claim is a function of the data, so every other one is
// wrong.
#include <catch2/catch.hpp>
#include <functional>
#include <map>

#include "certify/container/container.hpp"
#include "certify/lineart/encode.hpp"
#include "certify/verify.hpp"
#include "tests/certify_lineart/reference_drawing.hpp"
#include "tests/certify_lineart/scenes.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

/// Scenes with events and a hatch.
const std::vector<LineArtCertificate>& originals() {
  static const auto all = [] {
    std::vector<LineArtCertificate> list;
    for (std::uint64_t seed = 1; list.size() < 3; ++seed) {
      Random random(seed);
      LineArtCertificate soup = random_soup(random, seed % 2 == 0, 16);
      if (soup.parallel) soup.view.scale = {1.0 / 256, 1.0 / 4096};
      const auto drawing = reference_drawing(soup);
      if (!drawing) continue;
      std::size_t events = 0;
      for (const LineEdge& edge : drawing->edges) events += edge.breaks.size();
      if (events < 4) continue;
      for (int k = 0; k < 40; ++k) {
        const auto hatch =
            hatch_on(*drawing, static_cast<std::uint32_t>(random() % drawing->faces.size()),
                     random() % 3, 0.25);
        const auto truth = reference_hatch(*drawing, hatch);
        if (!truth || truth->crosses || truth->faces.empty()) continue;
        list.push_back(*drawing);
        list.back().hatches = {hatch};
        list.back().hatch_faces = truth->faces;
        break;
      }
    }
    for (const auto& c : list) REQUIRE(verify(encode(c)).accepted);
    return list;
  }();
  return all;
}

using Edit = std::function<bool(LineArtCertificate&, Random&)>;

LineEdge& some_edge(LineArtCertificate& c, Random& random) {
  return c.edges[random() % c.edges.size()];
}

using Edits = std::map<std::string, Edit>;

Edits first_edits() {
  return {{"front",
           [](auto& c, auto& r) {
             LineEdge& e = some_edge(c, r);
             e.pieces[r() % e.pieces.size()].front += r() % 2 == 0 ? 1 : -1;
             return true;
           }},
          {"hiding",
           [](auto& c, auto& r) {
             LineEdge& e = some_edge(c, r);
             e.pieces[r() % e.pieces.size()].hiding += r() % 2 == 0 ? 1 : -1;
             return true;
           }},
          {"hidden made visible",
           [](auto& c, auto& r) {
             LineEdge& e = some_edge(c, r);
             LinePiece& piece = e.pieces[r() % e.pieces.size()];
             const bool hidden = piece.front > 0;
             piece = {0, 0};
             return hidden;
           }},
          {"edge dropped",
           [](auto& c, auto& r) {
             c.edges.erase(c.edges.begin() + static_cast<std::ptrdiff_t>(r() % c.edges.size()));
             return true;
           }},
          {"edge twice",
           [](auto& c, auto& r) {
             const auto at = static_cast<std::ptrdiff_t>(r() % c.edges.size());
             const LineEdge copy = c.edges[static_cast<std::size_t>(at)];
             c.edges.insert(c.edges.begin() + at, copy);
             return true;
           }},
          {"other edge", [](auto& c, auto& r) {
             some_edge(c, r).high += 1;
             return true;
           }}};
}

Edits more_edits() {
  return {{"event dropped, pieces merged",
           [](auto& c, auto& r) {
             LineEdge& e = some_edge(c, r);
             if (e.breaks.empty()) return false;
             const auto at = static_cast<std::ptrdiff_t>(r() % e.breaks.size());
             e.breaks.erase(e.breaks.begin() + at);
             e.pieces.erase(e.pieces.begin() + at + static_cast<std::ptrdiff_t>(r() % 2));
             return true;
           }},
          {"events exchanged",
           [](auto& c, auto& r) {
             LineEdge& e = some_edge(c, r);
             if (e.breaks.size() < 2) return false;
             std::swap(e.breaks[0], e.breaks[1]);
             return true;
           }},
          {"events made one place",
           [](auto& c, auto& r) {
             LineEdge& e = some_edge(c, r);
             if (e.breaks.size() < 2) return false;
             e.breaks[0].push_back(e.breaks[1][0]);
             e.breaks.erase(e.breaks.begin() + 1);
             e.pieces.erase(e.pieces.begin() + 1);
             return true;
           }},
          {"other partner",
           [](auto& c, auto& r) {
             LineEdge& e = some_edge(c, r);
             if (e.breaks.empty()) return false;
             e.breaks[r() % e.breaks.size()][0].first += 1;
             return true;
           }},
          {"event of the other kind",
           [](auto& c, auto& r) {
             LineEdge& e = some_edge(c, r);
             if (e.breaks.empty()) return false;
             LineEvent& event = e.breaks[0][0];
             event.kind =
                 event.kind == LineEvent::kCrossing ? LineEvent::kPiercing : LineEvent::kCrossing;
             return true;
           }},
          {"turned round", [](auto& c, auto& r) {
             LineEdge& e = some_edge(c, r);
             if (e.breaks.empty()) return false;
             std::reverse(e.breaks.begin(), e.breaks.end());
             std::reverse(e.pieces.begin(), e.pieces.end());
             return e.breaks.size() > 1 || e.pieces[0] != e.pieces[1];
           }}};
}

Edits last_edits() {
  return {{"crease dropped",
           [](auto& c, auto&) {
             c.creases.clear();
             // Its edge may be occluding.
             const auto drawing = reference_drawing(c);
             return !drawing || drawing->edges.size() != c.edges.size();
           }},
          {"hatch on another face",
           [](auto& c, auto& r) {
             c.hatch_faces[0] = static_cast<std::uint32_t>(
                 (c.hatch_faces[0] + 1 + r() % (c.faces.size() - 1)) % c.faces.size());
             return true;
           }},
          {"hatch repeats a point",
           [](auto& c, auto&) {
             c.hatches[0].push_back(c.hatches[0].back());
             return true;
           }},
          {"hatch of a point", [](auto& c, auto&) {
             c.hatches[0].resize(1);
             return true;
           }}};
}

/// Each changes what is stated, or says that it could not.
const Edits& edits() {
  static const Edits all = [] {
    Edits list = first_edits();
    list.merge(more_edits());
    list.merge(last_edits());
    return list;
  }();
  return all;
}

TEST_CASE("line art: every changed claim is rejected") {
  std::map<std::string, std::size_t> tried;
  for (const auto& original : originals())
    for (const auto& [name, edit] : edits())
      for (std::uint64_t seed = 1; seed <= scaled(3); ++seed) {
        Random random(seed);
        LineArtCertificate mutant = original;
        if (!edit(mutant, random)) continue;
        INFO(name << ", seed " << seed);
        CHECK_FALSE(verify(encode(mutant)).accepted);
        ++tried[name];
      }
  for (const auto& [name, edit] : edits()) {
    INFO(name);
    CHECK(tried[name] > 0);
  }
}

TEST_CASE("line art: every changed byte of the claim is rejected") {
  for (const auto& original : originals()) {
    const Bytes bytes = encode(original);
    const Container parts = open_container(bytes);
    const std::size_t from = kHeaderSize + parts.data.size(), to = from + parts.claims.size();
    for (std::size_t at = from; at < to; at += 2) {
      Bytes mutant = bytes;
      mutant[at] = static_cast<std::uint8_t>(mutant[at] ^ (at % 2 == 0 ? 1 : 128));
      rebind(mutant);
      INFO("byte " << at - from);
      CHECK_FALSE(verify(mutant).accepted);
    }
  }
}

TEST_CASE("line art: other data keep a claim only where it is true of them") {
  std::size_t accepted = 0, rejected = 0;
  for (const auto& original : originals())
    for (std::uint64_t seed = 1; seed <= scaled(40); ++seed) {
      Random random(seed);
      LineArtCertificate mutant = original;
      mutant.hatches.clear();
      mutant.hatch_faces.clear();
      auto& number = mutant.points[random() % mutant.points.size()][random() % 3];
      number += static_cast<double>(random() % 9) - 4 + 0.5;
      const auto drawing = reference_drawing(mutant);
      if (!drawing) continue;
      bool same = drawing->edges.size() == mutant.edges.size();
      for (std::size_t e = 0; same && e < mutant.edges.size(); ++e) {
        const LineEdge &s = mutant.edges[e], &t = drawing->edges[e];
        same = s.low == t.low && s.high == t.high && s.breaks == t.breaks && s.pieces == t.pieces;
      }
      const Verdict verdict = verify(encode(mutant));
      INFO("seed " << seed << ": " << verdict.reason);
      CHECK(verdict.accepted == same);
      ++(same ? accepted : rejected);
    }
  CHECK(accepted > 10);
  CHECK(rejected > 10);
}

TEST_CASE("line art: data that are no scene are rejected") {
  const auto refused = [](const Edit& edit) {
    LineArtCertificate c = originals()[1];
    Random random(1);
    edit(c, random);
    return !verify(encode(c)).accepted;
  };
  const LineArtCertificate& plain = originals()[1];
  REQUIRE(verify(encode(plain)).accepted);
  CHECK(refused([](auto& c, auto&) { return c.points[1] = c.points[0], true; }));
  CHECK(refused([](auto& c, auto&) { return c.faces[0][1] = c.faces[0][0], true; }));
  CHECK(refused([](auto& c, auto&) { return c.faces[0][1] = 1000, true; }));
  CHECK(refused([](auto& c, auto&) { return c.points.push_back({99, 99, 99}), true; }));
  CHECK(refused([](auto& c, auto&) { return c.view.scale[0] = 0, true; }));
  CHECK(refused([](auto& c, auto&) { return c.view.scale[1] = -1, true; }));
  CHECK(refused([](auto& c, auto&) { return c.view.axes = {}, true; }));
  CHECK(refused([](auto& c, auto&) { return std::swap(c.creases[0][0], c.creases[0][1]), true; }));
  for (const double bad : {HUGE_VAL, -HUGE_VAL, std::nan("")}) {
    CHECK(refused([&](auto& c, auto&) { return c.points[0][0] = bad, true; }));
    CHECK(refused([&](auto& c, auto&) { return c.eye[2] = bad, true; }));
    CHECK(refused([&](auto& c, auto&) { return c.view.origin[1] = bad, true; }));
    CHECK(refused([&](auto& c, auto&) { return c.hatches[0][0][0] = bad, true; }));
  }
  // Every truncation.
  const Bytes bytes = encode(plain);
  for (std::size_t size = 0; size < bytes.size(); size += 17)
    CHECK_FALSE(verify(std::span(bytes).first(size)).accepted);
}

}  // namespace
