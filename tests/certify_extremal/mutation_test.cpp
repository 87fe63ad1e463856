// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 8: wrong claims are rejected. Every mutant is bound again; an accepted one must state what
// is true of its own data.
#include <cstring>
#include <functional>
#include <iostream>
#include <map>

#include "certify/container/container.hpp"
#include "certify/extremal/decode.hpp"
#include "tests/certify_extremal/extremal_samples.hpp"
#include "tests/support/random.hpp"

using namespace crest::certify;
using namespace crest::tests;
namespace code = crest::certify::extremal_code;

namespace {

std::vector<ExtremalCertificate> make_originals() {
  std::vector<ExtremalCertificate> all;
  const auto add = [&](const ExtremalData& data, const ReferenceOptions& options = {}) {
    all.push_back(as_read(reference_extremal(data, options)));
    require_accepted(all.back());
  };
  add(with_level(sampled({20, 20, 1}, sphere(0.65, 0.4)), 0.4));
  add(with_level(sampled({20, 20, 1}, fading), 0.5));
  add(sampled({16, 16, 1}, half_plane));
  add(with_level(sampled({16, 16, 1}, half_plane), 0.4), {true});
  add(with_level(sampled({9, 9, 9}, sphere(0.6, 0.4)), 0.3));
  add(with_level(sampled({8, 8, 6}, moebius), 0.2));
  auto second = with_level(sampled({8, 7, 6}, sphere(0.6, 0.5)), 0.3);
  second.hessian = true;
  second.tensor_weights = {{{1}, {1}, {1}}};
  second.min_strength = 0.01;
  add(second);
  // Cells of any shape; whole numbers, the level among them.
  add(with_level(sampled({8, 7, 6}, sphere(0.6, 0.5), 1, {1, 0.25, 3}), 0.3));
  std::vector<float> whole;
  Random random(kSeed);
  for (int i = 0; i < 132; ++i) whole.push_back(static_cast<float>(random() % 4));
  add(with_level(make_data({12, 11, 1}, whole, {0x1p20, 0x1p21, 1}, 0.7), 1));
  // Four corners of a square: junctions, ambiguous squares.
  add(sampled({10, 10, 1}, [](double x, double y, double) {
    return std::sin(7 * x + 2 * y) + 0.7 * std::cos(5 * y - 3 * x);
  }));
  return all;
}
const std::vector<ExtremalCertificate>& originals() {
  static const auto all = make_originals();
  return all;
}

/// What a certificate says of its mesh, apart from what weaker codes allow to leave out.
auto statement(const ExtremalCertificate& c) {
  return std::tuple(c.odd_faces, c.valences, c.components);
}
bool same_field(const ExtremalData& a, const ExtremalData& b) {
  return a.samples == b.samples && a.nodes == b.nodes && a.type == b.type &&
         a.spacing == b.spacing && a.weights == b.weights && a.tensor_weights == b.tensor_weights &&
         a.valley == b.valley && a.hessian == b.hessian && a.has_min_value == b.has_min_value &&
         a.min_value == b.min_value && a.min_strength == b.min_strength;
}
/// Codes that are not the original's, at samples; of other data some of them.
bool codes_hold(const ExtremalCertificate& original, const ExtremalCertificate& mutant) {
  const ReferenceFields fields(mutant.data);
  const bool other = !same_field(original.data, mutant.data);
  std::size_t at = 0, proven = 0;
  for (const CellRun& run : mutant.cells)
    for (std::uint32_t i = 0; i < run.length; ++i, ++at) {
      const auto stated = mutant.codes[at];
      const ExtremalDirection w =
          stated == code::kOpen ? ExtremalDirection{} : mutant.directions[proven++];
      const bool same = original.codes.size() == mutant.codes.size() &&
                        original.codes[at] == stated && proven <= original.directions.size() &&
                        (stated == code::kOpen || original.directions[proven - 1] == w);
      if ((!same || (other && at % 61 == 0)) && !code_holds(fields, run.first + i, stated, w))
        return false;
    }
  return true;
}

/// The states of edges must be those that the reference finds, and the counts those of its mesh
/// with the stated pairings and places.
bool is_true(const ExtremalCertificate& c) {
  auto anew = reference_of(c);
  return anew.odd_faces == c.odd_faces && anew.valences == c.valences &&
         anew.components == c.components;
}

/// With as many directions as its codes and trees ask for: others cannot be written.
ExtremalCertificate fitted(ExtremalCertificate c) {
  const auto count = [](const auto& list, const auto& counts) {
    return static_cast<std::size_t>(std::count_if(list.begin(), list.end(), counts));
  };
  const ExtremalDirection more{code::kScale, 0, 0};
  c.directions.resize(count(c.codes, [](auto x) { return x != code::kOpen; }), more);
  c.gradients.resize(count(c.codes, [](auto x) { return x >= code::kRegular; }), more);
  c.leaves.resize(count(c.trees, [](auto x) { return x == code::kLeaf; }), more);
  return c;
}

struct Tally {
  std::uint64_t mutants = 0, accepted = 0, compared = 0;
  std::map<std::string, std::array<std::uint64_t, 2>> by_kind;

  void judge(const std::string& kind, const ExtremalCertificate& original,
             const ExtremalCertificate& edited) {
    const ExtremalCertificate mutant = fitted(edited);
    ++mutants;
    ++by_kind[kind][0];
    if (!verify(encode(mutant)).accepted) return;
    ++accepted;
    ++by_kind[kind][1];
    CHECK(codes_hold(original, mutant));
    if (same_field(original.data, mutant.data) && statement(original) == statement(mutant)) return;
    ++compared;
    CAPTURE(kind);
    CHECK(is_true(mutant));
  }
  void say(const char* what) const {
    std::cout << what << ": " << mutants << " mutants, " << accepted << " accepted, " << compared
              << " made anew\n";
    for (const auto& [kind, counts] : by_kind)
      std::cout << "  " << kind << ": " << counts[1] << " of " << counts[0] << '\n';
  }
};

template <class List>
bool edit_any(List& list, Random& random,
              const std::function<void(typename List::value_type&)>& f) {
  if (list.empty()) return false;
  f(list[random() % list.size()]);
  return true;
}
template <class List>
bool drop_any(List& list, Random& random) {
  if (list.empty()) return false;
  list.erase(list.begin() + static_cast<long>(random() % list.size()));
  return true;
}
template <class List>
bool double_any(List& list, Random& random) {
  if (list.empty()) return false;
  const auto at = random() % list.size();
  list.insert(list.begin() + static_cast<long>(at), typename List::value_type(list[at]));
  return true;
}

using Edit = std::function<bool(ExtremalCertificate&, Random&)>;

template <class Row>
void turn(Row& row, unsigned dimension, Random& random) {
  const auto k = random() % dimension;
  const int step[] = {1, -1, 100, -100, 3000, -3000, 32767};
  row[k] = static_cast<typename Row::value_type>(row[k] + step[random() % 7]);
  if (Row{} == row) row[0] = 1;
}

std::map<std::string, Edit> record_edits() {
  std::map<std::string, Edit> edits;
  edits["code"] = [](auto& c, Random& r) {
    return edit_any(c.codes, r,
                    [&](auto& x) { x = static_cast<std::uint8_t>((x + 1 + r() % 4) % 5); });
  };
  edits["code, alike in lists"] = [](auto& c, Random& r) {
    return edit_any(c.codes, r, [&](auto& x) {
      if (x == code::kRegular || x == code::kRegularExtremal)
        x = x == code::kRegular ? code::kRegularExtremal : code::kRegular;
      else if (x != code::kOpen)
        x = x == code::kCone ? code::kEmpty : code::kCone;
    });
  };
  edits["w"] = [](auto& c, Random& r) {
    return edit_any(c.directions, r, [&](auto& w) { turn(w, c.data.dimension, r); });
  };
  edits["a"] = [](auto& c, Random& r) {
    return edit_any(c.gradients, r, [&](auto& a) { turn(a, c.data.dimension, r); });
  };
  edits["w reversed"] = [](auto& c, Random& r) {
    return edit_any(c.directions, r, [&](auto& w) {
      for (auto& x : w) x = static_cast<std::int16_t>(-x);
    });
  };
  edits["run"] = [](auto& c, Random& r) {
    return edit_any(c.cells, r, [&](auto& run) {
      (r() % 2 == 0 ? run.first : run.length) += r() % 2 == 0 ? 1 : ~0U;
    });
  };
  edits["edge"] = [](auto& c, Random& r) {
    return edit_any(c.edges, r, [&](auto& edge) { edge += r() % 2 == 0 ? 1 : ~0U; });
  };
  edits["edge dropped"] = [](auto& c, Random& r) { return drop_any(c.edges, r); };
  edits["tree"] = [](auto& c, Random& r) {
    return edit_any(c.trees, r, [](auto& x) { x = 1 - x; });
  };
  edits["leaf"] = [](auto& c, Random& r) {
    return edit_any(c.leaves, r, [&](auto& w) { turn(w, c.data.dimension, r); });
  };
  edits["type"] = [](auto& c, Random& r) {
    return edit_any(c.types, r,
                    [&](auto& x) { x = static_cast<std::uint8_t>((x + 1 + r() % 2) % 3); });
  };
  edits["type dropped"] = [](auto& c, Random& r) { return drop_any(c.types, r); };
  edits["pairing"] = [](auto& c, Random& r) {
    return edit_any(c.pairings, r, [](auto& x) { x = 1 - x; });
  };
  return edits;
}
std::map<std::string, Edit> count_edits() {
  std::map<std::string, Edit> edits;
  edits["vertex"] = [](auto& c, Random& r) {
    return edit_any(c.vertices, r,
                    [&](auto& v) { v[r() % c.data.dimension] = static_cast<std::uint16_t>(r()); });
  };
  edits["vertex doubled"] = [](auto& c, Random& r) { return double_any(c.vertices, r); };
  edits["vertex dropped"] = [](auto& c, Random& r) { return drop_any(c.vertices, r); };
  edits["fan point"] = [](auto& c, Random& r) {
    return edit_any(c.fan_points, r, [&](auto& x) { x = static_cast<std::uint16_t>(r()); });
  };
  edits["odd faces"] = [](auto& c, Random& r) {
    c.odd_faces += r() % 2 == 0 ? 1 : ~0U;
    return true;
  };
  edits["valence"] = [](auto& c, Random& r) {
    const auto i = r() % 7;
    (i < 5    ? c.valences.one[i]
     : i == 5 ? c.valences.two
              : c.valences.three) += r() % 2 == 0 ? 1 : ~0U;
    return true;
  };
  edits["component"] = [](auto& c, Random& r) {
    return edit_any(c.components, r, [&](auto& x) {
      switch (r() % 7) {
        case 0:
          x.polygons += r() % 2 == 0 ? 1 : ~0U;
          break;
        case 1:
          x.euler_characteristic += r() % 2 == 0 ? 1 : -1;
          break;
        case 2:
          x.loops += r() % 2 == 0 ? 1 : ~0U;
          break;
        case 3:
          x.orientable = !x.orientable;
          break;
        case 4:
          x.isotopic = !x.isotopic;
          break;
        case 5:
          x.extremal = !x.extremal;
          break;
        default:
          x.cut = !x.cut;
      }
    });
  };
  edits["component doubled"] = [](auto& c, Random& r) { return double_any(c.components, r); };
  edits["component dropped"] = [](auto& c, Random& r) { return drop_any(c.components, r); };
  edits["components swapped"] = [](auto& c, Random& r) {
    if (c.components.size() < 2) return false;
    std::swap(c.components[r() % c.components.size()], c.components[0]);
    return true;
  };
  return edits;
}
std::map<std::string, Edit> data_edits() {
  std::map<std::string, Edit> edits;
  edits["sample"] = [](auto& c, Random& r) {
    const auto at = r() % (c.data.samples.size() / 4) * 4;
    float x;
    std::memcpy(&x, c.data.samples.data() + at, 4);
    const float factors[] = {0.0F, 0.5F, 0.99F, 1.000001F, 1.5F, -1.0F};
    x *= factors[r() % 6];
    if (x == 0) x = 0;
    std::memcpy(c.data.samples.data() + at, &x, 4);
    return true;
  };
  edits["least value"] = [](auto& c, Random& r) {
    if (!c.data.has_min_value) return false;
    c.data.min_value *= 1 + static_cast<double>(static_cast<int>(r() % 9) - 4) / 20;
    return true;
  };
  edits["no least value"] = [](auto& c, Random&) {
    c.data.has_min_value = !c.data.has_min_value;
    if (!c.data.has_min_value) c.data.min_value = 0;
    return true;
  };
  edits["strength"] = [](auto& c, Random& r) {
    c.data.min_strength += static_cast<double>(r() % 10) / 1000;
    return true;
  };
  edits["spacing"] = [](auto& c, Random& r) {
    c.data.spacing[r() % c.data.dimension] *= r() % 2 == 0 ? 1.01 : 1.5;
    return true;
  };
  edits["weight"] = [](auto& c, Random& r) {
    auto& list = (r() % 2 == 0 ? c.data.weights : c.data.tensor_weights)[r() % c.data.dimension];
    return edit_any(list, r, [&](auto& w) { w *= 1 + (r() % 2 == 0 ? 1e-6 : 0.1); });
  };
  edits["kind"] = [](auto& c, Random& r) {
    (r() % 2 == 0 ? c.data.valley : c.data.hessian) ^= true;
    return true;
  };
  edits["sigma"] = [](auto& c, Random& r) {
    (r() % 2 == 0 ? c.data.sigma : c.data.tensor_sigma) *= r() % 2 == 0 ? 1.01 : 0.99;
    return true;
  };
  edits["nodes"] = [](auto& c, Random&) {
    std::swap(c.data.nodes[0], c.data.nodes[1]);
    return true;
  };
  return edits;
}

void run(const char* what, const std::map<std::string, Edit>& edits, std::uint64_t times) {
  Random random(kSeed);
  Tally tally;
  for (const auto& original : originals())
    for (const auto& [kind, edit] : edits)
      for (std::uint64_t i = 0; i < scaled(times); ++i) {
        ExtremalCertificate mutant = original;
        if (edit(mutant, random)) tally.judge(kind, original, mutant);
      }
  CHECK(tally.mutants > 0);
  tally.say(what);
}

}  // namespace

TEST_CASE("extremal: edited bytes, bound again, are rejected unless true") {
  Random random(kSeed);
  Tally tally;
  for (const auto& original : originals()) {
    const Bytes bytes = encode(original);
    const auto data = open_container(bytes).data.size();
    for (std::uint64_t i = 0; i < scaled(40); ++i) {
      Bytes mutant = bytes;
      // One in eight in the data, which are most of the bytes.
      const auto at = i % 8 == 1
                          ? kHeaderSize + random() % data
                          : data + kHeaderSize + random() % (mutant.size() - kHeaderSize - data);
      if (i % 8 == 0)
        mutant.resize(at);
      else if (i % 8 < 3)
        mutant[at] = static_cast<std::uint8_t>(random());
      else
        mutant[at] ^= static_cast<std::uint8_t>(1U << random() % 8);
      if (mutant == bytes) continue;
      CHECK_FALSE(verify(mutant).accepted);
      if (mutant.size() != bytes.size()) continue;
      rebind(mutant);
      ++tally.mutants;
      if (!verify(mutant).accepted) continue;
      ++tally.accepted;
      const Container container = open_container(mutant);
      const auto read = decode_extremal(container.data, container.claims);
      CHECK(codes_hold(original, read));
      if (same_field(read.data, original.data) && statement(read) == statement(original)) continue;
      ++tally.compared;
      CHECK(is_true(read));
    }
  }
  tally.say("bytes");
}

TEST_CASE("extremal: edited records are rejected unless true") {
  run("records", record_edits(), 6);
}
TEST_CASE("extremal: edited counts are rejected unless true") {
  run("counts", count_edits(), 4);
}
TEST_CASE("extremal: edited data are rejected unless the claim is true of them") {
  run("data", data_edits(), 2);
}
