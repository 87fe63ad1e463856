// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 10, compression: two piecewise linear vector fields on one domain have the same skeleton
// (SPEC.md).
#include "certify/compression/bijection.hpp"
#include "certify/compression/decode.hpp"
#include "certify/container/byte_writer.hpp"
#include "certify/container/checker.hpp"
#include "certify/container/prove.hpp"
#include "certify/container/reject.hpp"
#include "certify/container/sha256.hpp"
#include "certify/skeleton/encode.hpp"

namespace crest::certify {
namespace {

using namespace compression;

const char* in_words(SkeletonNotion notion) {
  return notion == SkeletonNotion::strong     ? "strong"
         : notion == SkeletonNotion::original ? "original"
                                              : "relaxed";
}

/// The lines of one field's proof, said to be its.
void add_lines(const Verdict& from, const char* whose, Verdict& to) {
  for (const std::string& line : from.lines) prove(to, "{}, {}", whose, line);
}

/// Of a field's data section, as claim 9 has it.
Digest digest_of(const SkeletonCertificate& c) {
  ByteWriter out;
  write_skeleton_data(out, c);
  return sha256({std::span<const std::uint8_t>(out.result())});
}

void compare(const CompressionCertificate& c, Match& match, SignLadder& sign, Verdict& verdict) {
  const Proof &in = match.in, &out = match.out;
  match_boundary(match);
  const auto map = [](const std::vector<std::uint32_t>& stated, std::size_t before,
                      std::size_t after, const char* what) {
    require(before == after, "{}: {} in the input, {} in the output", what, before, after);
    return Map(stated, before, what);
  };
  const Maps maps{
      map(c.zeros, c.input.zeros.size(), c.output.zeros.size(), "zeros"),
      map(c.orbits, c.input.orbits.size(), c.output.orbits.size(), "orbits"),
      map(c.separatrices, c.input.separatrices.size(), c.output.separatrices.size(), "lines")};
  check_zeros(match, maps.zeros, c.notion, sign);
  prove(verdict, "both: {} zeros and {} switch points correspond", maps.zeros.to.size(),
        match.switch_point.size());
  const std::vector<Orbit> orbits_in = find_orbits(in, sign), orbits_out = find_orbits(out, sign);
  check_orbits(orbits_in, orbits_out, match, maps);
  prove(verdict, "both: {} closed orbits go around the same zeros and loops, in the same order",
        orbits_in.size());
  const ArrivalTable lines_in = find_arrivals(in, orbits_in, sign),
                     lines_out = find_arrivals(out, orbits_out, sign);
  const std::size_t open = check_separatrices(match, lines_in, lines_out, maps);
  prove(verdict,
        "both: {} separatrices and lines through vertices have the same starts and ends, up to {} "
        "undecided ones",
        maps.separatrices.to.size(), open);
  check_arrivals(match, lines_in, lines_out, maps);
  prove(
      verdict,
      "both: in the same order at the {} places where they arrive; at {} sinks, sources, sides of "
      "orbits and loops of one region there is no line",
      lines_in.orders.size(), lines_in.silent);
  if (c.notion == SkeletonNotion::strong)
    prove(verdict, "both: separatrices and orbits meet the same {} triangles",
          check_strong(match, lines_in, lines_out, maps));
}

void verify_compression(std::span<const std::uint8_t> data, std::span<const std::uint8_t> claims,
                        const VerifyOptions& options, Verdict& verdict) {
  const CompressionCertificate c = decode_compression(data, claims);
  if (options.input) throw TieUnavailable("a compression is tied to files by their fields");
  verdict.fields = {digest_of(c.input), digest_of(c.output)};
  SignLadder sign(options.arithmetic);
  Proof in(c.input), out(c.output);
  Verdict before, after;
  prove_surface(in, sign, before);
  prove_surface(out, sign, after);
  Match match = match_surfaces(c.vertices, in, out, sign);
  prove_skeleton(in, sign, options.arithmetic, before);
  prove_skeleton(out, sign, options.arithmetic, after);
  add_lines(before, "input", verdict);
  add_lines(after, "output", verdict);
  prove(verdict,
        "both: one domain, {} of {} triangles and {} of {} vertices left, their vectors unchanged; "
        "equivalence: {}",
        c.output.triangles.size(), c.input.triangles.size(), c.vertices.size(),
        c.input.positions.size(), in_words(c.notion));
  compare(c, match, sign, verdict);
  verdict.signs = sign.counts();
}

}  // namespace

extern const ClaimChecker compression_claim;
const ClaimChecker compression_claim = {kCompression, kCompressionVersion, "compression",
                                        verify_compression};

}  // namespace crest::certify
