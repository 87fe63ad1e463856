// SPDX-License-Identifier: GPL-3.0-or-later
// crest skeleton, crest compress.
#include "algorithms/vector_fields/vector_fields.hpp"

#include <algorithm>
#include <stdexcept>

#include "algorithms/vector_fields/certificate.hpp"
#include "algorithms/vector_fields/importance.hpp"
#include "bindings/python/systems.hpp"
#include "certify/verify.hpp"
#include "io/vector_fields/skeleton_writer.hpp"

namespace crest::python {
namespace {

using namespace vector_fields;

PlanarField field_of(const Arguments& a) {
  PlanarField field{a.rows<2>("V"), a.rows<2>("vectors"), {}};
  field.triangles = a.cells<3>("F", field.points.size());
  return field;
}

/// What the checker, which shares no code with the extraction, refuses is a bug on either side.
std::string certify_checked(std::vector<std::uint8_t> bytes, Output& out) {
  if (const certify::Verdict verdict = certify::verify(bytes); !verdict.accepted)
    throw std::runtime_error("the certificate's checker refuses it: " + verdict.reason);
  return out.certify(std::move(bytes));
}

std::int64_t undecided_in(const Skeleton& skeleton) {
  return std::count_if(skeleton.separatrices.begin(), skeleton.separatrices.end(),
                       [](const Separatrix& s) { return s.end == EndKind::undecided; });
}

void fill(const PlanarField& field, const Skeleton& skeleton, const std::string& digest,
          Output& out) {
  out.geometries["geometry"] = io::geometry_of(io::skeleton_poly_data({&field, &skeleton, digest}));
  out.values["undecided"] = undecided_in(skeleton);
  std::vector<Index> origins;
  for (const Separatrix& s : skeleton.separatrices) origins.push_back(s.origin);
  out.values["origin"] = array_of(origins);
  out.values["index_sum"] = std::int64_t{skeleton.index_sum};
  out.values["euler_characteristic"] = std::int64_t{skeleton.euler_characteristic};
  out.values["data_digest"] = digest;
}

Laplacian laplacian_of(const Arguments& a) {
  return a.text("laplacian") == "cotan" ? Laplacian::cotan : Laplacian::uniform;
}

/// What weighs `least` or more, in the order of the skeleton.
void add_weights(const Importance& importance, double least, Output& out) {
  std::vector<double> zeros, separatrices;
  for (const ZeroWeight& zero : importance.zeros)
    if (zero.weight >= least) zeros.push_back(zero.weight);
  for (const double weight : importance.separatrices)
    if (weight >= least) separatrices.push_back(weight);
  out.values["critical_weight"] = array_of(std::move(zeros));
  out.values["separatrix_weight"] = array_of(std::move(separatrices));
}

}  // namespace

Output run_skeleton(const Arguments& a, const Progress& progress) {
  const PlanarField field = field_of(a);
  certify::SkeletonCertificate record;
  const Skeleton skeleton =
      progress.step("skeleton", [&] { return extract_skeleton(field, record); });
  Output out;
  std::string digest;
  if (a.flag("certificate"))
    digest = progress.step("composing the certificate",
                           [&] { return certify_checked(certify::encode(record), out); });
  const auto least = a.maybe_number("simplify");
  if (!least) {
    fill(field, skeleton, digest, out);
    return out;
  }
  progress.step("weighing critical points", [&] {
    const Importance importance = weigh(field, smoothed(field, laplacian_of(a)), skeleton);
    fill(field, important_part(skeleton, importance, *least), digest, out);
    add_weights(importance, *least, out);
    out.values["undecided"] = undecided_in(skeleton);  // of those that are not shown, too
  });
  return out;
}

Output run_compress(const Arguments& a, const Progress& progress) {
  const PlanarField field = field_of(a);
  CompressionOptions options;
  const std::string& equivalence = a.text("equivalence");
  options.equivalence = equivalence == "strong"    ? Equivalence::strong
                        : equivalence == "relaxed" ? Equivalence::relaxed
                                                   : Equivalence::original;
  if (a.text("test") == "thesis") options.test = CollapseTest::thesis;
  const std::string& priority = a.text("priority");
  options.priority = priority == "length"  ? CollapsePriority::length
                     : priority == "error" ? CollapsePriority::error
                                           : CollapsePriority::product;
  options.flips = a.flag("flips");
  options.simplify = a.maybe_number("simplify");
  options.laplacian = laplacian_of(a);
  certify::CompressionCertificate record;
  const Compression result =
      progress.step("collapsing edges", [&] { return compress(field, options, record); });
  Output out;
  std::string digest;
  // Of both skeletons; where these differ, of the output's alone.
  if (result.same_skeleton && a.flag("certificate"))
    digest = progress.step("composing the certificate", [&] {
      return certify_checked(
          result.importance ? certify::encode(record.output) : certify::encode(record), out);
    });
  fill(result.field, result.after, digest, out);
  out.values["same_skeleton"] = result.same_skeleton;
  out.values["difference"] = result.difference;
  out.values["V"] = array_of(result.field.points);
  out.values["F"] = array_of(result.field.triangles);
  out.values["vectors"] = array_of(result.field.vectors);
  out.values["vertex_of"] = array_of(result.vertex_of);
  return out;
}

}  // namespace crest::python
