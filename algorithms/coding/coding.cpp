// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/coding/coding.hpp"

#include <cmath>

#include "algorithms/coding/attributes.hpp"
#include "algorithms/coding/clearance.hpp"
#include "algorithms/coding/container.hpp"
#include "algorithms/coding/order_code.hpp"
#include "algorithms/coding/positions.hpp"
#include "algorithms/coding/stream_error.hpp"
#include "algorithms/coding/tree_code.hpp"
#include "algorithms/coding/valence_code.hpp"
#include "kernel/geometry/input_error.hpp"
#include "kernel/predicates/within.hpp"

namespace crest::coding {
namespace {

TreeMethod tree_method(Method method) {
  return method == Method::fan      ? TreeMethod::fan
         : method == Method::zigzag ? TreeMethod::zigzag
                                    : TreeMethod::fixed;
}

struct Coded {
  Method method;
  Bytes bytes;
  CodedOrder order;
  bool cleared = false;
};

Coded encode_connectivity(const Surface& surface, Method method) {
  Coded coded{method, {}, {}};
  coded.bytes = method == Method::valence ? encode_valences(surface, coded.order)
                                          : encode_tree(surface, tree_method(method), coded.order);
  return coded;
}

Coded smallest(const Surface& surface) {
  Coded best = encode_connectivity(surface, Method::valence);
  for (const Method method : {Method::fan, Method::fixed})
    if (Coded other = encode_connectivity(surface, method); other.bytes.size() < best.bytes.size())
      best = std::move(other);
  return best;
}

/// More than 1 % of the vertices?
bool has_many_of_valence_3(const Surface& surface) {
  std::size_t found = 0;
  for (Index v = 0; v < surface.counts().vertices; ++v) {
    int valence = 0;
    surface.around(v, [&](Index) { ++valence; });
    found += valence == 3 && surface.twin(surface.table().half_of(v)) != kNone ? 1 : 0;
  }
  return 100 * found > surface.counts().vertices;
}

Coded smallest_of_all(const Surface& surface) {
  Coded best = smallest(surface);
  if (!has_many_of_valence_3(surface)) return best;
  const Clearance clearance(surface);
  if (clearance.empty()) return best;
  Coded base = smallest(Surface(clearance.vertices(), clearance.faces()));
  base.bytes = clearance.finish(base.bytes, base.order);
  base.cleared = true;
  return base.bytes.size() < best.bytes.size() ? base : best;
}

/// The mesh's vertex at each decoded one.
std::vector<Index> vertex_order(const Surface& surface, const CodedOrder& order) {
  std::vector<Index> vertices(surface.counts().vertices, kNone);
  for (std::size_t f = 0; f < order.faces.size(); ++f) {
    Index h = order.corners[f];
    for (const Index v : order.faces[f]) {
      if (vertices[v] == kNone) vertices[v] = surface.from(h);
      h = next_half(h);
    }
  }
  return vertices;
}

void check_points(Index vertices, std::span<const Point> points, const EncodeOptions& options) {
  if (options.places == Places::none) return;
  if (points.size() != vertices)
    throw kernel::InputError("mesh: has not a point a vertex; give all points");
  for (std::size_t v = 0; v < points.size(); ++v)
    for (const double x : points[v])
      if (!std::isfinite(x))
        throw kernel::InputError("vertex " + std::to_string(v) +
                                 ": a coordinate is not a finite number; repair it");
}

/// What the step promises, decided exactly at every vertex.
void require_within(std::span<const Point> points, std::span<const Point> rounded,
                    std::span<const Index> order, double tolerance) {
  for (std::size_t v = 0; v < points.size(); ++v)
    if (!kernel::within(points[v], rounded[v], tolerance))
      throw kernel::InputError("vertex " + std::to_string(order[v]) +
                               ": its rounded place is not within the tolerance; use --exact");
}

Bytes encode_places(const Surface& decoded, std::span<const Point> points,
                    std::span<const Index> order, const EncodeOptions& options,
                    std::vector<Point>& places) {
  if (options.places == Places::exact) {
    places.assign(points.begin(), points.end());
    return encode_exact(decoded, points);
  }
  const double step = step_within(options.tolerance);
  for (std::size_t v = 0; v < points.size(); ++v)
    if (!in_reach(points[v], step))
      throw kernel::InputError(
          "vertex " + std::to_string(order[v]) +
          ": is 2^31 steps from the origin; use a larger tolerance or --exact");
  Bytes bytes = encode_rounded(decoded, points, step);
  places.clear();
  for (const Point& point : points) places.push_back(rounded(point, step));
  require_within(points, places, order, options.tolerance);
  return bytes;
}

/// Of each place of an attribute in one order that of another, from those of vertices, and of
/// half-edges that begin faces.
std::vector<Index> sources(kernel::Site site, std::span<const Index> vertices,
                           std::span<const Index> first_halves) {
  std::vector<Index> source;
  if (site == kernel::Site::vertices) source.assign(vertices.begin(), vertices.end());
  if (site == kernel::Site::faces)
    for (const Index h : first_halves) source.push_back(h / 3);
  if (site == kernel::Site::corners)
    for (Index h : first_halves)
      for (int k = 0; k < 3; ++k, h = next_half(h)) source.push_back(h);
  return source;
}

Bytes encode_all(const Surface& decoded, std::span<const kernel::Attribute> attributes,
                 std::span<const Index> vertices, std::span<const Index> first_halves) {
  std::vector<kernel::Attribute> list;
  for (const kernel::Attribute& a : attributes)
    list.push_back(rearranged(a, sources(a.site, vertices, first_halves)));
  return encode_attributes(decoded, list);
}

/// Puts what was decoded in the input's order.
void apply(const KeptOrder& order, std::vector<Triangle>& faces, std::vector<Point>& points) {
  std::vector<Triangle> ordered(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) ordered[order.faces[f]][k] = order.vertices[faces[f][k]];
  faces = std::move(ordered);
  std::vector<Point> places(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) places[order.vertices[v]] = points[v];
  points = std::move(places);
}

void apply(const KeptOrder& order, std::vector<kernel::Attribute>& attributes) {
  std::vector<Index> vertices(order.vertices.size()), first_halves(order.faces.size());
  for (Index v = 0; v < vertices.size(); ++v) vertices[order.vertices[v]] = v;
  for (Index f = 0; f < first_halves.size(); ++f) first_halves[order.faces[f]] = 3 * f;
  for (kernel::Attribute& a : attributes)
    a = rearranged(a, sources(a.site, vertices, first_halves));
}

StreamInfo info_of(const Container& c, Index faces, std::size_t total) {
  StreamInfo info{
      c.method, c.cleared,           c.places,       c.keeps_order,    c.counts.vertices,
      faces,    c.counts.components, c.counts.loops, c.counts.handles, {}};
  const auto size = [&](Section s) { return c.sections[static_cast<std::size_t>(s)].size(); };
  info.sizes.connectivity = size(Section::connectivity);
  info.sizes.geometry = size(Section::positions);
  info.sizes.attributes = size(Section::attributes) + size(Section::order);
  info.sizes.header = total - info.sizes.total();
  return info;
}

/// Calls `work`, naming the section in its errors.
template <class Work>
auto in_section(Section section, Work&& work) {
  const auto fail = [&](const std::string& problem) {
    throw kernel::InputError(std::string("section ") +
                             kSectionNames[static_cast<std::size_t>(section)] + ": " + problem +
                             "; the file is damaged, get it again");
  };
  try {
    return work();
  } catch (const StreamError& error) {
    fail(error.what());
    throw;
  }
}

}  // namespace

const char* name_of(Method method) {
  constexpr std::array<const char*, 4> names = {"valence", "fan", "zigzag", "static"};
  return names[static_cast<std::size_t>(method)];
}

Encoded encode(Index vertices, std::span<const Triangle> faces, std::span<const Point> points,
               const EncodeOptions& options, std::span<const kernel::Attribute> attributes) {
  check_points(vertices, points, options);
  for (const kernel::Attribute& a : attributes)
    require_sound(a, vertices, static_cast<Index>(faces.size()));
  const Surface surface(vertices, faces);
  const Coded coded =
      options.method ? encode_connectivity(surface, *options.method) : smallest_of_all(surface);
  Encoded result;
  result.vertex_order = vertex_order(surface, coded.order);
  result.splits = coded.order.splits;
  Container c;
  c.method = coded.method;
  c.cleared = coded.cleared;
  c.places = options.places;
  c.keeps_order = options.keep_order;
  c.has_attributes = !attributes.empty();
  c.counts = surface.counts();
  const auto set = [&](Section section, const Bytes& bytes) {
    c.sections[static_cast<std::size_t>(section)] = bytes;
  };
  set(Section::connectivity, coded.bytes);
  Bytes geometry, numbers, order;
  std::vector<Point> places;
  std::optional<Surface> decoded;
  if (options.places != Places::none || c.has_attributes)
    decoded.emplace(vertices, coded.order.faces);
  if (options.places != Places::none) {
    for (const Index v : result.vertex_order) places.push_back(points[v]);
    const std::vector<Point> in_order = std::move(places);
    geometry = encode_places(*decoded, in_order, result.vertex_order, options, places);
    set(Section::positions, geometry);
  }
  if (c.has_attributes) {
    numbers = encode_all(*decoded, attributes, result.vertex_order, coded.order.corners);
    set(Section::attributes, numbers);
  }
  std::vector<Triangle> final_faces = coded.order.faces;
  if (options.keep_order) {
    KeptOrder kept{result.vertex_order, {}};
    for (const Index h : coded.order.corners) kept.faces.push_back(h / 3);
    order = encode_order(kept);
    set(Section::order, order);
    apply(kept, final_faces, places);
    for (Index v = 0; v < vertices; ++v) result.vertex_order[v] = v;
  }
  c.digest = mesh_digest(vertices, final_faces, places);
  result.stream = compose(c);
  result.info = info_of(c, surface.face_count(), result.stream.size());
  return result;
}

Decoded decode(std::span<const std::uint8_t> stream, const DecodeLimits& limits) {
  const Container c = parse(stream);
  const auto bytes = [&](Section s) { return c.sections[static_cast<std::size_t>(s)]; };
  Decoded result;
  std::optional<Surface> surface;
  in_section(Section::connectivity, [&] {
    const auto section = bytes(Section::connectivity);
    const auto decode_part = [&](std::span<const std::uint8_t> part, const Counts& counts) {
      return c.method == Method::valence
                 ? decode_valences(part, counts, limits.faces)
                 : decode_tree(part, tree_method(c.method), counts, limits.faces);
    };
    result.faces = c.cleared ? decode_cleared(section, c.counts, limits.faces, decode_part)
                             : decode_part(section, c.counts);
    try {
      surface.emplace(c.counts.vertices, result.faces);
    } catch (const kernel::InputError& error) {
      throw StreamError(std::string("is of no manifold: ") + error.what());
    }
    if (surface->counts() != c.counts) throw StreamError("has other counts than the header says");
  });
  in_section(Section::positions, [&] {
    if (c.places == Places::exact)
      result.points = decode_exact(bytes(Section::positions), *surface);
    if (c.places == Places::rounded)
      result.points = decode_rounded(bytes(Section::positions), *surface);
  });
  in_section(Section::attributes, [&] {
    if (c.has_attributes)
      result.attributes = decode_attributes(bytes(Section::attributes), *surface, limits.numbers);
  });
  in_section(Section::order, [&] {
    if (!c.keeps_order) return;
    const KeptOrder order =
        decode_order(bytes(Section::order), c.counts.vertices, surface->face_count());
    apply(order, result.faces, result.points);
    apply(order, result.attributes);
  });
  if (mesh_digest(c.counts.vertices, result.faces, result.points) != c.digest)
    throw kernel::InputError(
        "digest: the decoded mesh has another one; the file is damaged, get it again");
  result.info = info_of(c, static_cast<Index>(result.faces.size()), stream.size());
  return result;
}

}  // namespace crest::coding
