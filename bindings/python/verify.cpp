// SPDX-License-Identifier: GPL-3.0-or-later
// crest-verify.
#include "certify/verify.hpp"

#include "bindings/python/systems.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::python {
namespace {

/// The data digest, or that of each of its fields, as a claim about it alone has it.
std::vector<std::string> digests_of(const certify::Verdict& verdict) {
  std::vector<std::string> digests;
  for (const certify::Digest& field : verdict.fields) digests.push_back(certify::hex(field));
  return digests;
}

}  // namespace

Output run_verify(const Arguments& a, const Progress& progress) {
  const auto& certificate = std::get<std::vector<std::uint8_t>>(a.array("certificate").data);
  certify::VerifyOptions options;
  if (a.text("arithmetic") == "mpfr") options.arithmetic = certify::Arithmetic::mpfr;
  if (a.has("V")) {
    certify::InputMesh mesh{"mesh", a.rows<3>("V"), {}};
    for (auto& position : mesh.positions)
      for (double& x : position) x += 0.0;  // certificates hold no -0
    mesh.faces = a.cells<3>("F", mesh.positions.size());
    options.input = std::move(mesh);
  }
  try {
    const certify::Verdict verdict =
        progress.step("checking", [&] { return certify::verify(certificate, options); });
    Output out;
    out.values["accepted"] = verdict.accepted;
    out.values["undecided"] = verdict.undecided;
    out.values["claims"] = verdict.lines;
    out.values["reason"] = verdict.reason;
    out.values["data_digest"] = verdict.data ? certify::hex(*verdict.data) : std::string();
    out.values["fields"] = digests_of(verdict);
    return out;
  } catch (const certify::TieUnavailable& error) {
    throw kernel::InputError(std::string("mesh: ") + error.what());
  }
}

}  // namespace crest::python
