// SPDX-License-Identifier: GPL-3.0-or-later
// Tables 4.1 to 4.3 of paper 001 on those of its meshes that are public, in bits a vertex; of the
// columns of table 4.1 the range over start triangles.
#include <fmt/format.h>

#include <iostream>

#include "algorithms/coding/mixer.hpp"
#include "algorithms/coding/surface.hpp"
#include "algorithms/coding/thesis_codes.hpp"
#include "experiments/001-coding/coding_input.hpp"
#include "experiments/program.hpp"

namespace crest {
namespace {

using namespace coding;
using Nodes = std::vector<TreeNode>;

/// Bits by arithmetic coding, the last 0 to 20 bits as contexts.
double arithmetic(const Bits& bits) {
  Lines lines(18);
  RangeEncoder range;
  std::vector<Weights<6>> weights(1);
  std::uint64_t history = 1;
  for (const bool bit : bits) {
    Context<6> context;
    for (std::size_t i = 0; i < 6; ++i)
      context[i] = &lines.of((history & ((std::uint64_t{1} << (4 * i)) - 1)) << 3 | i);
    code_mixed(range, context, 0, weights[0], bit);
    history = history << 1 | (bit ? 1 : 0);
  }
  return 8.0 * static_cast<double>(range.finish().size());
}

double huffman(const std::vector<Index>& numbers) {
  return static_cast<double>(Huffman(numbers).code(numbers).size());
}

/// 4 l + two bits of tree.
std::vector<Index> interwoven(const Nodes& nodes) {
  std::vector<Index> numbers;
  for (const TreeNode& node : nodes) {
    const bool left = node.type == NodeType::left || node.type == NodeType::both;
    const bool right = node.type == NodeType::right || node.type == NodeType::both;
    numbers.push_back(4 * node.length + (left ? 2 : 0) + (right ? 1 : 0));
  }
  return numbers;
}

/// Two bits of tree a node, then nothing for the only legal length, one bit for one of two, else a
/// Huffman code of its place.
double tree_first_huffman(const Nodes& nodes, const std::vector<Index>& places) {
  const auto sizes = legal_set_sizes(nodes);
  double bits = static_cast<double>(letters(nodes).size());
  std::vector<Index> others;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (sizes[i] == 2) bits += 1;
    if (sizes[i] > 2) others.push_back(places[i]);
  }
  return bits + huffman(others);
}

/// The same with unary places, none for the only legal length.
Bits tree_first(const Nodes& nodes, const std::vector<Index>& places) {
  const auto sizes = legal_set_sizes(nodes);
  Bits bits;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Bits letter = letters({nodes[i]}), place = sizes[i] > 1 ? unary({places[i] + 1}) : Bits{};
    bits.insert(bits.end(), letter.begin(), letter.end());
    bits.insert(bits.end(), place.begin(), place.end());
  }
  return bits;
}

Nodes tree_from(const kernel::CornerTable& table, const std::vector<Triangle>& faces, Index gate) {
  const std::vector<Index> gates = {gate};
  return in_preorder(kernel::grow_strips(table, faces, kernel::StripExits::zigzag, gates));
}

void tables(const std::filesystem::path& path, Index starts) {
  const auto mesh = experiments::read_coding_input(path.string());
  const kernel::CornerTable table(mesh.vertices(), mesh.faces);
  const double v = mesh.vertices();
  double least_hc = 1e9, most_hc = 0, least_fixed = 1e9, most_fixed = 0;
  const auto sides = static_cast<Index>(3 * mesh.faces.size());
  Index first = kNone;
  for (Index i = 0; i < starts; ++i) {
    Index gate = static_cast<Index>(std::uint64_t{sides} * i / starts);
    // Of meshes with boundary a boundary half-edge.
    for (Index h = 0; h < sides; ++h)
      if (table.opposite((gate + h) % sides) == kNone) {
        gate = (gate + h) % sides;
        break;
      }
    if (first == kNone) first = gate;
    const Nodes nodes = tree_from(table, mesh.faces, gate);
    const double hc = huffman(interwoven(nodes)) / v,
                 fixed = static_cast<double>(lengths_first(nodes).size()) / v;
    least_hc = std::min(least_hc, hc);
    most_hc = std::max(most_hc, hc);
    least_fixed = std::min(least_fixed, fixed);
    most_fixed = std::max(most_fixed, fixed);
  }
  const Nodes pre = tree_from(table, mesh.faces, first), post = to_postorder(pre);
  const auto s = [&](Traversal t) { return arithmetic(unary(lengths(pre, t))) / v; };
  const auto places = places_in_legal_sets(post);
  const double post_h = tree_first_huffman(post, places) / v;
  fmt::print(
      "| {} | {:.2f} to {:.2f} | {:.2f} to {:.2f} | {:.2f} | {:.2f}, {:.2f}, {:.2f} | {:.2f}, "
      "{:.2f}, {:.2f}, {:.2f}, {:.2f} | {:.2f} | {:.2f} |\n",
      path.filename().string(), least_hc, most_hc, least_fixed, most_fixed,
      arithmetic(lengths_first(pre)) / v, arithmetic(zaks(pre)) / v, arithmetic(letters(pre)) / v,
      arithmetic(letters(post)) / v, huffman(lengths(pre, Traversal::pre)) / v, s(Traversal::pre),
      s(Traversal::post), s(Traversal::in), s(Traversal::level), post_h,
      arithmetic(tree_first(post, places)) / v);
}

int run(const std::vector<std::string>& meshes, Index starts) {
  fmt::print(
      "| mesh | 4.1 HC | FIXED | F&AC | 4.2 t pre 1, pre 2, post 2 | s pre,H, pre, post, in, level "
      "| 4.3 post,H | "
      "post |\n|---|---|---|---|---|---|---|---|\n");
  for (const std::string& mesh : meshes)
    if (std::filesystem::exists(mesh))
      tables(mesh, starts);
    else
      std::cerr << mesh << ": not there, left out\n";
  return 0;
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  const std::string shared = "../shared/data/";
  std::vector<std::string> meshes = {
      shared + "meshes/fandisk.off", shared + "thesis-meshes/mannequin_428.off",
      shared + "thesis-meshes/mannequin_11703.off", shared + "thesis-meshes/venus.off"};
  unsigned starts = 20;
  crest::experiments::Program program("Tables 4.1 to 4.3");
  program.option("--meshes", meshes, "spheres or disks");
  program.option("--starts", starts, "start triangles tried", {1, 1000});
  return program.run(argc, argv, [&] { return crest::run(meshes, starts); });
}
