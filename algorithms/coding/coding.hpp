// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The public calls: triangle meshes to streams and back (format: docs/cmc-format.md; theory:
// README.md beside this file).
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "kernel/geometry/attribute.hpp"
#include "kernel/geometry/index.hpp"

namespace crest::coding {

using Index = kernel::Index;
using Triangle = kernel::Triangle;
using Point = std::array<double, 3>;
using Bytes = std::vector<std::uint8_t>;

enum class Method : std::uint8_t { valence, fan, zigzag, fixed };

/// "valence", "fan", "zigzag", "static".
const char* name_of(Method method);

enum class Places : std::uint8_t {
  none,    ///< connectivity alone
  exact,   ///< bit for bit
  rounded  ///< within a tolerance
};

struct EncodeOptions {
  std::optional<Method> method = {};  ///< empty: the smallest of valence, fan and static, tried
                                      ///< without vertices of valence 3, too, where they are many
  Places places = Places::exact;
  double tolerance = 0;     ///< of rounded places: how far a vertex may move
  bool keep_order = false;  ///< decoding gives vertices and faces in their order
};

/// Bytes of a stream by what they are for; a kept order counts as attributes.
struct StreamSizes {
  std::size_t connectivity = 0, geometry = 0, attributes = 0, header = 0;
  std::size_t total() const { return connectivity + geometry + attributes + header; }
};

/// What a stream says of its mesh.
struct StreamInfo {
  Method method = Method::valence;
  bool cleared = false;  ///< of vertices of valence 3, which are put back
  Places places = Places::none;
  bool keeps_order = false;
  Index vertices = 0, faces = 0, components = 0, loops = 0, handles = 0;
  StreamSizes sizes;
};

struct Encoded {
  Bytes stream;
  StreamInfo info;
  Index splits =
      0;  ///< of the method: triangles that join two parts of a boundary or two boundaries
  std::vector<Index> vertex_order;  ///< of each decoded vertex: which of the input it is
};

/// Shapes: V points, or none with Places::none; F faces with indices below `vertices`.
/// Guarantees: decode() gives the mesh back: faces under vertex_order up to the choice of their
///   first corners, points bit for bit or within the tolerance, attributes bit for bit; the same
///   bytes on every machine.
/// Throws: kernel::InputError naming the element if the faces are no oriented manifold, a point is
///   not finite or too far for the tolerance, an attribute has not the numbers that it says.
/// Cost: O(V + F), but for splits, each of which costs its distance along a boundary.
Encoded encode(Index vertices, std::span<const Triangle> faces, std::span<const Point> points,
               const EncodeOptions& options = {},
               std::span<const kernel::Attribute> attributes = {});

struct Decoded {
  std::vector<Point> points;  ///< V, or none
  std::vector<Triangle> faces;
  std::vector<kernel::Attribute> attributes;
  StreamInfo info;
};

/// What decode() makes at most.
struct DecodeLimits {
  Index faces = Index{1} << 28;
  std::size_t numbers = std::size_t{1} << 27;  ///< of all attributes: places times components
};

/// Trusts nothing: what it gives is an oriented manifold with the counts, checksums and digest that
/// the stream states.
/// Throws: kernel::InputError, one line "section SECTION, byte N: PROBLEM; REMEDY".
/// Cost: as encode(); memory in proportion to what is decoded, which the limits bound.
Decoded decode(std::span<const std::uint8_t> stream, const DecodeLimits& limits = {});

}  // namespace crest::coding
