// SPDX-License-Identifier: GPL-3.0-or-later
// crest encode, crest decode.
#include "algorithms/coding/coding.hpp"

#include "algorithms/coding/certificate.hpp"
#include "algorithms/coding/verify.hpp"
#include "bindings/python/systems.hpp"
#include "certify/coding/encode.hpp"

namespace crest::python {
namespace {

using coding::Method;
using coding::Places;

coding::EncodeOptions options_of(const Arguments& a) {
  coding::EncodeOptions options;
  for (const Method method : {Method::valence, Method::fan, Method::zigzag, Method::fixed})
    if (a.text("method") == coding::name_of(method)) options.method = method;
  options.keep_order = a.flag("keep_order");
  if (a.has("tolerance")) {
    options.tolerance = a.number("tolerance");
    options.places = Places::rounded;
  }
  if (a.flag("connectivity_only")) options.places = Places::none;
  return options;
}

void fill(const coding::StreamInfo& info, Output& out) {
  out.values["method"] = std::string(coding::name_of(info.method));
  out.values["components"] = std::int64_t{info.components};
  out.values["handles"] = std::int64_t{info.handles};
  out.values["boundary_loops"] = std::int64_t{info.loops};
}

}  // namespace

Output run_encode(const Arguments& a, const Progress& progress) {
  const auto points = a.rows<3>("V");
  const auto faces = a.cells<3>("F", points.size());
  const coding::EncodeOptions options = options_of(a);
  const auto count = static_cast<kernel::Index>(points.size());
  const coding::Encoded encoded =
      progress.step("encoding", [&] { return coding::encode(count, faces, points, options); });
  const double largest = progress.step(
      "decoding again", [&] { return coding::verify(encoded, faces, points, options); });
  Output out;
  fill(encoded.info, out);
  if (a.flag("certificate"))
    out.values["data_digest"] = progress.step("composing the certificate", [&] {
      return out.certify(
          certify::encode(coding::make_certificate(encoded, faces, points, options, 0)));
    });
  out.values["vertex_order"] = array_of(encoded.vertex_order);
  out.values["largest_error"] = largest;
  out.values["connectivity_bytes"] = static_cast<std::int64_t>(encoded.info.sizes.connectivity);
  out.values["geometry_bytes"] = static_cast<std::int64_t>(encoded.info.sizes.geometry);
  out.values["stream"] = array_of(encoded.stream);
  return out;
}

Output run_decode(const Arguments& a, const Progress& progress) {
  const auto& stream = std::get<std::vector<std::uint8_t>>(a.array("stream").data);
  const coding::Decoded decoded = progress.step("decoding", [&] {
    return coding::decode(stream, {.faces = static_cast<kernel::Index>(a.integer("max_faces")),
                                   .numbers = static_cast<std::size_t>(a.integer("max_numbers"))});
  });
  Output out;
  fill(decoded.info, out);
  if (decoded.info.places != Places::none) out.values["V"] = array_of(decoded.points);
  out.values["F"] = array_of(decoded.faces);
  out.values["vertices"] = std::int64_t{decoded.info.vertices};
  return out;
}

}  // namespace crest::python
