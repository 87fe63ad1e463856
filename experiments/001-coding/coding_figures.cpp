// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 4.1 to 4.8 of the thesis as drawings of what the strip tree does: strips in tints, their
// trees, decoding step by step.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "algorithms/coding/surface.hpp"
#include "algorithms/coding/thesis_codes.hpp"
#include "experiments/program.hpp"
#include "io/write/atomic_file.hpp"

namespace crest {
namespace {

using coding::Index;
using coding::kNone;
using coding::Triangle;
using kernel::StripTree;
using Place = std::array<double, 2>;

struct Plane {
  std::vector<Triangle> faces;
  std::vector<Place> places;
};

/// The vertices of the longest boundary loop on a circle, the others in the middle of their
/// neighbours (Tutte); the gate's side below.
Plane laid_out(std::vector<Triangle> faces, Index vertices, Index gate) {
  Plane plane{std::move(faces), std::vector<Place>(vertices, Place{0, 0})};
  const coding::Surface surface(vertices, plane.faces);
  std::vector<bool> fixed(vertices, false);
  std::vector<Index> rim;
  Index h = gate;
  do {
    rim.push_back(surface.from(h));
    h = surface.next_on_boundary(h);
  } while (h != gate);
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const double turn =
        2 * std::numbers::pi * (static_cast<double>(i) - 0.5) / static_cast<double>(rim.size());
    plane.places[rim[i]] = {std::sin(turn), std::cos(turn)};
    fixed[rim[i]] = true;
  }
  for (int round = 0; round < 3000; ++round)
    for (Index v = 0; v < vertices; ++v) {
      if (fixed[v]) continue;
      Place sum{};
      double n = 0;
      surface.around(v, [&](Index g) {
        for (std::size_t k = 0; k < 2; ++k) sum[k] += plane.places[surface.to(g)][k];
        ++n;
      });
      plane.places[v] = {sum[0] / n, sum[1] / n};
    }
  return plane;
}

/// A drawing in rows of panels.
class Svg {
 public:
  /// The next panel, below a caption.
  void panel(const std::string& caption) {
    left_ = 20 + kSize * (count_ % 6);
    top_ = 20 + kSize * (count_ / 6);
    ++count_;
    text({0, 1.25}, caption);
  }
  void face(const Plane& plane, Index f, const std::string& fill) {
    std::string points;
    for (const Index v : plane.faces[f]) {
      const Place p = on_page(plane.places[v]);
      points += fmt::format("{:.1f},{:.1f} ", p[0], p[1]);
    }
    body_ +=
        fmt::format("<polygon points=\"{}\" fill=\"{}\" stroke=\"#333\" stroke-width=\"0.8\"/>\n",
                    points, fill);
  }
  void line(Place a, Place b, const char* colour, double width) {
    a = on_page(a), b = on_page(b);
    body_ += fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" "
        "stroke-width=\"{}\"/>\n",
        a[0], a[1], b[0], b[1], colour, width);
  }
  void dot(Place p, const std::string& fill) {
    p = on_page(p);
    body_ +=
        fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"7\" fill=\"{}\" stroke=\"#333\"/>\n",
                    p[0], p[1], fill);
  }
  void text(Place p, const std::string& words) {
    p = on_page(p);
    body_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", p[0],
                         p[1] + 4, words);
  }
  void write(const std::filesystem::path& path) const {
    const std::size_t columns = std::min<std::size_t>(count_, 6), rows = (count_ + 5) / 6;
    io::write_atomically(
        path, fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" "
                          "font-family=\"Helvetica, Arial, sans-serif\" font-size=\"12\">\n"
                          "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n{}</svg>\n",
                          40 + kSize * columns, 40 + kSize * rows, body_));
  }

 private:
  static constexpr std::size_t kSize = 220;
  Place on_page(Place p) const {
    const double middle = kSize / 2.0, scale = 0.38 * kSize;
    return {static_cast<double>(left_) + middle + scale * p[0],
            static_cast<double>(top_) + middle + scale * p[1]};
  }
  std::string body_;
  std::size_t count_ = 0, left_ = 0, top_ = 0;
};

std::string tint(std::size_t i) {
  return fmt::format("hsl({}, 55%, {}%)", 137 * i % 360, 62 + 12 * (i % 3));
}

/// A mesh cut into strips.
struct Cut {
  Plane plane;
  StripTree tree;
  std::vector<Index> strip;  ///< of each face: a node, or kNone
};

Cut cut(std::vector<Triangle> faces, Index vertices, Index gate) {
  Cut c{laid_out(std::move(faces), vertices, gate), {}, {}};
  const kernel::CornerTable table(vertices, c.plane.faces);
  const std::array<Index, 1> gates = {gate};
  c.tree = kernel::grow_strips(table, c.plane.faces, kernel::StripExits::zigzag, gates);
  c.strip.assign(c.plane.faces.size(), kNone);
  for (Index n = 0; n < c.tree.nodes.size(); ++n)
    for (Index i = 0; i < c.tree.nodes[n].length; ++i)
      c.strip[c.tree.entered[c.tree.nodes[n].begin + i] / 3] = n;
  return c;
}

/// That of a code such as "1E1L1E2S", in postorder; the gate is the last face's first side.
Cut cut_of(const std::string& code) {
  coding::ReverseMesh mesh(kNone);
  Index length = 0;
  for (const char letter : code) {
    if (letter >= '0' && letter <= '9') {
      length = 10 * length + static_cast<Index>(letter - '0');
      continue;
    }
    coding::add_node(mesh,
                     {static_cast<coding::NodeType>(std::string("ELRS").find(letter)), length});
    length = 0;
  }
  Index vertices = 0;
  std::vector<Triangle> faces = mesh.take_faces(vertices);
  const auto gate = 3 * static_cast<Index>(faces.size() - 1);
  return cut(std::move(faces), vertices, gate);
}

/// Strips for which `shown` holds in tints, the others white.
template <class Shown>
void draw(Svg& svg, const Cut& c, Shown&& shown) {
  for (Index f = 0; f < c.plane.faces.size(); ++f)
    svg.face(c.plane, f, c.strip[f] != kNone && shown(c.strip[f]) ? tint(c.strip[f]) : "white");
}

Place middle(const Plane& plane, Index face) {
  Place p{};
  for (const Index v : plane.faces[face])
    for (std::size_t k = 0; k < 2; ++k) p[k] += plane.places[v][k] / 3;
  return p;
}

/// Each strip's last triangle joined to its children's first.
void draw_links(Svg& svg, const Cut& c) {
  const auto face = [&](const StripTree::Node& n, Index i) {
    return c.tree.entered[n.begin + i] / 3;
  };
  for (const StripTree::Node& n : c.tree.nodes) {
    for (Index i = 1; i < n.length; ++i)
      svg.line(middle(c.plane, face(n, i - 1)), middle(c.plane, face(n, i)), "#777", 1.5);
    for (const Index child : {n.left, n.right})
      if (child != kNone)
        svg.line(middle(c.plane, face(n, n.length - 1)),
                 middle(c.plane, face(c.tree.nodes[child], 0)), "black", 2.5);
  }
}

/// The tree with lengths; the width of a subtree is what it has of leaves.
double draw_tree(Svg& svg, const Cut& c, Index node, double left, double width, double top) {
  const StripTree::Node& n = c.tree.nodes[node];
  const Place here = {left + width / 2, top};
  const auto child = [&](Index which, double from, double room) {
    if (which == kNone) return;
    svg.line(here, {from + room / 2, top + 0.4}, "black", 1);
    draw_tree(svg, c, which, from, room, top + 0.4);
  };
  child(n.left, left, width / 2);
  child(n.right, left + width / 2, width / 2);
  svg.dot(here, tint(node));
  svg.text(here, std::to_string(n.length));
  return width;
}

/// A disk of hexagons' corners, `radius` steps wide; a hole in the middle if asked for.
Plane hexagon(int radius, bool hole) {
  std::vector<std::vector<Index>> number(
      static_cast<std::size_t>(2 * radius + 1),
      std::vector<Index>(static_cast<std::size_t>(2 * radius + 1), kNone));
  Plane plane;
  const auto at = [&](int i, int j) -> Index {
    if (std::abs(i) > radius || std::abs(j) > radius || std::abs(i + j) > radius) return kNone;
    if (hole && i == 0 && j == 0) return kNone;
    Index& n = number[static_cast<std::size_t>(i + radius)][static_cast<std::size_t>(j + radius)];
    if (n == kNone) {
      n = static_cast<Index>(plane.places.size());
      plane.places.push_back({(i + 0.5 * j) / radius, -0.866 * j / radius});
    }
    return n;
  };
  for (int i = -radius; i <= radius; ++i)
    for (int j = -radius; j <= radius; ++j)
      for (const auto& f : {Triangle{at(i, j), at(i + 1, j), at(i, j + 1)},
                            Triangle{at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}})
        if (f[0] != kNone && f[1] != kNone && f[2] != kNone) plane.faces.push_back(f);
  return plane;
}

Cut cut_hexagon(int radius, bool hole) {
  const Plane plane = hexagon(radius, hole);
  const coding::Surface surface(static_cast<Index>(plane.places.size()), plane.faces);
  Index gate = surface.loops()[0];
  for (const Index loop : surface.loops())  // that outside
    if (std::hypot(plane.places[surface.from(loop)][0], plane.places[surface.from(loop)][1]) > 0.7)
      gate = loop;
  Cut c = cut(plane.faces, static_cast<Index>(plane.places.size()), gate);
  c.plane.places = plane.places;
  return c;
}

void figures_of_one_code(const std::filesystem::path& folder) {
  const auto all = [](Index) { return true; };
  Svg third, fourth, seventh;
  const Cut c = cut_of("1E1L1E2S");
  third.panel("strips");
  draw(third, c, all);
  third.panel("2,1,1,0,0,0,1,0,0");
  draw_tree(third, c, 0, -1, 2, -0.8);
  third.write(folder / "figure-4.3.svg");
  for (Index step = 0; step < c.tree.nodes.size(); ++step) {
    fourth.panel(fmt::format("preorder {}: length {}", step + 1, c.tree.nodes[step].length));
    draw(fourth, c, [&](Index node) { return node <= step; });
  }
  fourth.write(folder / "figure-4.4.svg");
  const std::vector<Index> order = kernel::postorder(c.tree);
  const std::array words = {"1E", "1L", "1E", "2S"};
  for (std::size_t step = 0; step < order.size(); ++step) {
    seventh.panel(fmt::format("postorder {}: {}", step + 1, words[step]));
    draw(seventh, c, [&](Index node) {
      return std::find(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(step) + 1,
                       node) != order.begin() + static_cast<std::ptrdiff_t>(step) + 1;
    });
  }
  seventh.write(folder / "figure-4.7.svg");
}

void rows_of_codes(const std::filesystem::path& path, const std::vector<std::string>& codes) {
  Svg svg;
  for (const std::string& code : codes) {
    const Cut c = cut_of(code);
    svg.panel(code);
    draw(svg, c, [](Index) { return true; });
    draw_links(svg, c);
  }
  svg.write(path);
}

int run(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const auto all = [](Index) { return true; };
  Svg first, second, fifth;
  const Cut disk = cut_hexagon(4, false);
  first.panel("the first strip divides");
  draw(first, disk, [](Index node) { return node == 0; });
  first.panel("all strips and their tree");
  draw(first, disk, all);
  draw_links(first, disk);
  first.write(folder / "figure-4.1.svg");

  Plane strip;
  for (Index v = 0; v < 14; ++v) strip.places.push_back({-1 + v / 6.5, v % 2 == 0 ? 0.25 : -0.25});
  second.panel("a zig-zag strip of length 12");
  for (Index k = 0; k < 12; ++k) {
    strip.faces.push_back({k, k + 1, k + 2});
    second.face(strip, k, tint(0));
  }
  for (Index v = 0; v < 14; ++v)
    second.text({strip.places[v][0], 1.6 * strip.places[v][1]}, std::to_string(v));
  second.write(folder / "figure-4.2.svg");

  figures_of_one_code(folder);
  const Cut annulus = cut_hexagon(3, true);
  fifth.panel("a hole: splits are black");
  draw(fifth, annulus, all);
  draw_links(fifth, annulus);
  for (const StripTree::Node& n : annulus.tree.nodes)
    if (n.split != kNone)
      fifth.line(middle(annulus.plane, annulus.tree.entered[n.begin + n.length - 1] / 3),
                 middle(annulus.plane, n.split / 3), "black", 6);
  const Cut loop = cut_of("1E1L1L1L5L");
  fifth.panel("the strip met itself: 1E1L1L1L5L");
  draw(fifth, loop, all);
  draw_links(fifth, loop);
  fifth.write(folder / "figure-4.5.svg");
  rows_of_codes(folder / "figure-4.6.svg", {"1E", "1E1L", "1E2R", "1E1L3L"});
  rows_of_codes(folder / "figure-4.8.svg", {"1E", "1E1L", "1E1R", "1E2R", "1E1E1S", "1E1E2S"});
  return 0;
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  std::filesystem::path folder = "pictures";
  crest::experiments::Program program("Figures 4.1 to 4.8");
  program.option("--pictures", folder, "folder for the drawings");
  return program.run(argc, argv, [&] { return crest::run(folder); });
}
