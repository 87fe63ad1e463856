// SPDX-License-Identifier: GPL-3.0-or-later
// The programs `crest-verify` and `crest-verify-<claim>`: check a certificate with nothing of
// algorithms/ or io/ linked in. Which claims one knows is what it is linked with.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "certify/container/container.hpp"
#include "certify/container/sha256.hpp"
#include "certify/verify.hpp"
#include "cli/input_mesh.hpp"
#include "kernel/arithmetic/self_test.hpp"

namespace {

using namespace crest::certify;

enum Exit { kAccepted = 0, kRejected = 1, kUsage = 2, kUnreadable = 3, kInternal = 70 };

struct Arguments {
  std::string certificate;
  VerifyOptions options;
  std::string input, output, stream, weld, tensor, order, vectors, diagonal, slice;
  bool cell_to_point = false, all = false;
  bool split = false, outward = false, quiet = false;
  std::vector<std::string> reseal, rebind;
};

/// As it was called.
std::string program = "crest-verify";

int complain(Exit code, const std::string& text) {
  std::fprintf(stderr, "%s: %s\n", program.c_str(), text.c_str());
  return code;
}

int recompute(const std::vector<std::string>& files, void (*seal)(Bytes&)) {
  try {
    Bytes bytes = read_file(files[0]);
    seal(bytes);
    write_file(files[1], bytes);
  } catch (const std::invalid_argument& problem) {
    return complain(kUnreadable, files[0] + ": " + problem.what());
  } catch (const std::runtime_error& problem) {
    return complain(kUnreadable, problem.what());
  }
  return kAccepted;
}

/// The mesh of --input, cleaned as for the command that wrote the certificate.
InputMesh read_input(const Arguments& arguments) {
  std::vector<std::string> words;
  if (!arguments.weld.empty()) words.insert(words.end(), {"--weld", arguments.weld});
  if (arguments.split) words.emplace_back("--split");
  if (arguments.outward) words.emplace_back("--outward");
  if (arguments.quiet) words.emplace_back("--quiet");
  return crest::cli::input_mesh(arguments.input, words);
}

/// Whether a certificate's claim is one of these.
bool is_about(std::span<const std::uint8_t> bytes, std::initializer_list<std::string_view> names) {
  try {
    const auto number = open_container(bytes).claim;
    return std::ranges::any_of(known_claims(), [&](const ClaimChecker* claim) {
      return claim->number == number && std::ranges::count(names, claim->name) > 0;
    });
  } catch (const Malformed&) {
    return false;
  }
}

Digest read_tensors(const Arguments& arguments) {
  std::vector<std::string> words;
  if (!arguments.tensor.empty()) words.insert(words.end(), {"--tensor", arguments.tensor});
  if (!arguments.order.empty()) words.insert(words.end(), {"--order", arguments.order});
  return crest::cli::input_tensors(arguments.input, words);
}

Digest read_vectors(const std::string& file, const Arguments& arguments) {
  std::vector<std::string> words;
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {option, value});
  };
  add("--vectors", arguments.vectors);
  add("--diagonal", arguments.diagonal);
  add("--slice", arguments.slice);
  if (arguments.cell_to_point) words.emplace_back("--cell-to-point");
  if (arguments.all) words.emplace_back("--all");
  return crest::cli::input_vectors(file, words);
}

/// A file's field, and what it is compared with.
struct FieldTie {
  std::string name, file, what;
  Digest digest;
};

/// What the files hold, for claims whose data sections hold fields alone.
std::vector<FieldTie> read_fields(std::span<const std::uint8_t> bytes, const Arguments& arguments) {
  std::vector<FieldTie> ties;
  if (is_about(bytes, {"modes", "modes-curves"}))
    ties.push_back(
        {"input", arguments.input, "positions, tetrahedra and tensors", read_tensors(arguments)});
  else if (is_about(bytes, {"skeleton", "compression"}))
    ties.push_back({"input", arguments.input, "positions, triangles and vectors",
                    read_vectors(arguments.input, arguments)});
  if (!arguments.output.empty()) {
    Arguments plain;
    ties.push_back({"output", arguments.output, "positions, triangles and vectors",
                    read_vectors(arguments.output, plain)});
  }
  return ties;
}

/// Equal digests say that a field is the file's.
void compare_fields(const std::vector<FieldTie>& ties, Verdict& verdict) {
  for (std::size_t i = 0; i < ties.size() && verdict.accepted; ++i) {
    const FieldTie& tie = ties[i];
    const Digest stated = i < verdict.fields.size() ? verdict.fields[i] : verdict.data.value();
    if (stated == tie.digest) {
      verdict.lines.push_back(tie.name + ": " + tie.file + " holds the same " + tie.what);
      continue;
    }
    verdict.accepted = false;
    verdict.reason = tie.file + ": other " + tie.what + ", their digest is " + hex(tie.digest);
  }
}

int check(Arguments& arguments) {
  Buffer<std::uint8_t> bytes;
  std::vector<FieldTie> ties;
  try {
    bytes = read_buffer(arguments.certificate);
    if (!arguments.output.empty() && !is_about(bytes, {"compression"}))
      return complain(kUsage, "--output is for certificates of compression");
    if (!arguments.input.empty()) {
      ties = read_fields(bytes, arguments);
      if (ties.empty()) arguments.options.input = read_input(arguments);
    }
    if (!arguments.stream.empty()) {
      if (!is_about(bytes, {"coding"}))
        return complain(kUsage, "--stream is for certificates of coding");
      const Buffer<std::uint8_t> stream = read_buffer(arguments.stream);
      ties.push_back({"stream", arguments.stream, "bytes", sha256({std::span(stream)})});
    }
  } catch (const crest::cli::InputUnreadable& problem) {
    // Without words: `crest` has said it.
    return *problem.what() == 0 ? kUnreadable : complain(kUnreadable, problem.what());
  } catch (const std::runtime_error& problem) {
    return complain(kUnreadable, problem.what());
  }
  Verdict verdict = verify(bytes, arguments.options);
  compare_fields(ties, verdict);
  if (!arguments.quiet) {
    for (const auto& line : verdict.lines) std::printf("%s\n", line.c_str());
    if (verdict.data) std::printf("data digest: %s\n", hex(*verdict.data).c_str());
  }
  if (verdict.accepted) {
    std::printf("ACCEPTED\n");
    return kAccepted;
  }
  std::printf("REJECTED: %s\n", verdict.reason.c_str());
  return kRejected;
}

void describe(CLI::App& app, Arguments& arguments) {
  static const std::map<std::string, Arithmetic> kArithmetic = {{"double", Arithmetic::doubles},
                                                                {"mpfr", Arithmetic::mpfr}};
  auto* const certificate =
      app.add_option("CERT", arguments.certificate, "the certificate to check");
  auto* const arithmetic =
      app.add_option("--arithmetic", arguments.options.arithmetic,
                     "double (with proven bounds, default) or mpfr (directed rounding;\n"
                     "about a thousand times slower for ridges of smooth surfaces)")
          ->transform(CLI::CheckedTransformer(kArithmetic).description("{double,mpfr}"))
          ->default_str("double");
  auto* const input = app.add_option("--input", arguments.input,
                                     "also require the data to be what `crest` makes of this file");
  app.add_option("--weld", arguments.weld, "as for the command that wrote the certificate")
      ->type_name("T")
      ->needs(input);
  app.add_flag("--split", arguments.split, "the same")->needs(input);
  app.add_flag("--outward", arguments.outward, "the same")->needs(input);
  app.add_option("--tensor", arguments.tensor, "the same")->type_name("NAME")->needs(input);
  app.add_option("--order", arguments.order, "the same")->type_name("WORDS")->needs(input);
  app.add_option("--output", arguments.output,
                 "for compression: the compressed file, compared in the same way")
      ->type_name("FILE")
      ->needs(input);
  app.add_option("--stream", arguments.stream,
                 "for coding: the .cmc file, whose bytes must be those proved")
      ->type_name("FILE");
  app.add_option("--vectors", arguments.vectors, "as for the command that wrote the certificate")
      ->type_name("NAME")
      ->needs(input);
  app.add_option("--diagonal", arguments.diagonal, "the same")->type_name("WORD")->needs(input);
  app.add_option("--slice", arguments.slice, "the same")->type_name("K")->needs(input);
  app.add_flag("--cell-to-point", arguments.cell_to_point, "the same")->needs(input);
  app.add_flag("--all", arguments.all, "the same")->needs(input);
  auto* const quiet = app.add_flag("--quiet", arguments.quiet, "print the verdict alone");
  auto* const reseal =
      app.add_option("--reseal", arguments.reseal, "IN OUT: copy with the seal recomputed")
          ->expected(2)
          ->type_name("IN OUT");
  auto* const rebind = app.add_option("--rebind", arguments.rebind,
                                      "IN OUT: copy with the data digest and the seal recomputed")
                           ->expected(2)
                           ->type_name("IN OUT");
  for (auto* const other : {certificate, arithmetic, input, quiet}) {
    reseal->excludes(other);
    rebind->excludes(other);
  }
  reseal->excludes(rebind);
  std::string claims;
  for (const ClaimChecker* claim : known_claims())
    claims += (claims.empty() ? "" : ", ") + std::string(claim->name);
  app.footer("Claims: " + claims +
             ".\n"
             "Exit codes: 0 accepted, 1 rejected, 2 usage, 3 unreadable file, 70 internal error.\n"
             "\nExamples:\n  " +
             program + " bunny.crest --input bunny.obj\n  " + program +
             " bunny.crest --arithmetic mpfr --quiet");
}

int run(int argc, char** argv) {
  CLI::App app("Check a certificate of crest: is its claim true of the data it carries?", program);
  Arguments arguments;
  describe(app, arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& problem) {
    return app.exit(problem) == 0 ? kAccepted : kUsage;
  }
  if (!arguments.reseal.empty()) return recompute(arguments.reseal, reseal);
  if (!arguments.rebind.empty()) return recompute(arguments.rebind, rebind);
  if (arguments.certificate.empty())
    return complain(kUsage, "a certificate is needed; see " + program + " --help");
  crest::kernel::require_sound_floating_point();
  try {
    return check(arguments);
  } catch (const TieUnavailable& problem) {
    return complain(kUsage, problem.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc > 0) program = std::filesystem::path(argv[0]).filename().string();
    return run(argc, argv);
  } catch (const std::exception& problem) {
    return complain(kInternal, problem.what());
  }
}
