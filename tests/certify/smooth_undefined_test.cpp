// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 4, condition (A): expressions with a part that is not defined, or not analytic, where the
// claim speaks of it. Every part in every context is refused by the producer, which names its
// column, and the checker rejects it in a certificate that was true without it.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <functional>

#include "algorithms/smooth_ridges/smooth_ridges.hpp"
#include "algorithms/smooth_ridges/undefined.hpp"
#include "certify/container/container.hpp"
#include "certify/container/reject.hpp"
#include "certify/ridges_smooth/sheet.hpp"
#include "certify/verify.hpp"
#include "tests/certify/second_opinion.hpp"
#include "tests/certify/smooth_producer.hpp"
#include "tests/support/environment.hpp"

using namespace crest::certify;
using namespace crest::tests;
using crest::smooth_ridges::find_undefined;
using Producer = crest::smooth_ridges::Surface;

namespace {

/// @ stands before each part that may be named as not defined.
using Parts = std::vector<std::string>;

const Parts kConstants = {"@log(-1)",
                          "@log(0)",
                          "@sqrt(-2)",
                          "@1/0",
                          "@0/0",
                          "@0^-1",
                          "@(1-1)^-2",
                          "exp(@1/0)",
                          "sin(@1/0)",
                          "@1/sin(0)",
                          "@log(cos(pi))",
                          "exp(@exp(exp(9)))",
                          "sqrt(@log(-e))",
                          "@1/(pi-pi)",
                          "@log(log(0.5))",
                          "@sqrt(1-pi)^3",
                          "exp(0.5*@log(-2))",
                          "@log(1-1)^0",
                          "@sqrt(log(0.9))",
                          "(2+@1/(1-1)^3)^2"};

/// In the domain [0.4, 0.5]^2: nowhere, in a half, on the border, at a point, 1e-300 wide.
const Parts kHeightField = {"@log(u-1)",
                            "@log(-1-u^2)",
                            "@sqrt(-u)",
                            "@1/(u-u)",
                            "@log(v-v)",
                            "@log(log(u))",
                            "@log(u-0.45)",
                            "@sqrt(v-0.47)",
                            "@log(u-v)",
                            "@sqrt(u*v-0.2)",
                            "@1/(u-0.45)",
                            "@(u-0.45)^-1",
                            "@(u-v)^-2",
                            "@sqrt(u-0.45)^3",
                            "exp(0.5*@log(v-0.44))",
                            "@log(@1/(u-0.45))",
                            "@1/log(2.2*u)",
                            "(@sqrt(u-0.42)-1)^2",
                            "@log(sin(40*u))",
                            "@log(u-0.4)",
                            "@sqrt(u-0.4)",
                            "@1/(u-0.4)",
                            "@sqrt(0.5-v)",
                            "@log(0.5-u)",
                            "@(v-0.5)^-3",
                            "@1/((u-0.43)^2+(v-0.46)^2)",
                            "@log((u-0.43)^2+(v-0.46)^2)",
                            "@sqrt((u-0.43)^2+(v-0.46)^2)",
                            "@((u-0.4)^2+(v-0.4)^2)^-1",
                            "@sqrt((u-0.45)^2-1e-300)",
                            "@log((u-0.45)^2-1e-300)",
                            "@1/((u-0.45)^2-1e-300)"};

const Parts kPeriodic = {"@log(cos(u)-2)",          "@1/(1-cos(u))", "@sqrt(cos(u)-1)",
                         "@log(1-cos(u))",          "@1/sin(u)",     "@log(sin(3*u)^2)",
                         "@sqrt(cos(u)^2-1-1e-300)"};

/// {x}, {y}, {z}: a corner of the first face. It begins with the place's border.
const Parts kImplicit = {"@log(x-4)",
                         "@sqrt(-1-x^2)",
                         "@1/(x-x)",
                         "@log(-y^2)",
                         "@log(x-({x}))",
                         "@sqrt(y-({y}))",
                         "@1/(z-({z}))",
                         "@(x-({x}))^-1",
                         "@(y-({y}))^-2",
                         "@log(({z})-z)",
                         "@sqrt(({x})-x)^3",
                         "exp(0.5*@log(y-({y})))",
                         "@1/(x+y+z-({x})-({y})-({z}))",
                         "@1/((x-({x}))^2+(y-({y}))^2+(z-({z}))^2)",
                         "@log((x-({x}))^2+(y-({y}))^2+(z-({z}))^2)",
                         "@sqrt((x-({x}))^2-1e-300)",
                         "@log((z-({z}))^2-1e-300)",
                         "@1/((y-({y}))^2-1e-300)"};
/// Defined everywhere, not analytic at a point of S: harmless where the context moves S away.
const Parts kRough = {"@sqrt((x-({x}))^2+(y-({y}))^2+(z-({z}))^2)", "@sqrt((x-({x}))^2)",
                      "@sqrt((y-({y}))^4+(x-({x}))^2)^3"};
/// On the border of the box, where F is not zero.
const Parts kBorder = {"@log(x+3)", "@1/(x+3)",      "@log(y+3)",
                       "@(z+3)^-2", "@sqrt(x+2.99)", "@1/((x+3)^2+(y+3)^2+(z+3)^2)"};

const std::vector<std::string> kNested = {
    "#", "cos(#)", "exp(sin(#))", "1/(3+sin(#))", "log(2+cos(#))", "sqrt(1.5+sin(#))"};
const std::vector<std::string> kContexts = {
    "0*#",   "#*0",       "#-#",          "sin(#)",     "0*cos(#)", "#^0",      "0*#^0",
    "0*#^2", "exp(-#^2)", "0/(2+cos(#))", "log(2+0*#)", "(0*#)^0",  "1e-300*#", "(2-2)*(#-#)*#"};

const std::vector<std::string> kZeroContexts = {"0*#",      "#*0",   "#-#",
                                                "0*cos(#)", "0*#^2", "0/(2+cos(#))"};

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

/// A text with the marks taken out.
struct Marked {
  std::string text;
  std::vector<std::size_t> columns;

  explicit Marked(const std::string& marked) {
    for (const char c : marked)
      if (c == '@')
        columns.push_back(text.size() + 1);
      else
        text.push_back(c);
  }
};

struct Kind {
  std::string name;
  RidgesSmoothCertificate certificate;  ///< true
  Parts parts;
  std::vector<std::size_t> places;  ///< numbers of texts that the parts are put into
  const std::vector<std::string>& contexts = kContexts;
};

Verdict verdict_on(const RidgesSmoothCertificate& c, Arithmetic arithmetic) {
  return verify(encode(c), {arithmetic, std::nullopt});
}

/// What the producer says against the surface; empty: nothing.
std::string refusal(const SmoothSurfaceData& s) {
  try {
    const Producer surface =
        s.kind == 0 ? Producer::implicit(s.texts[0], s.box)
                    : Producer::parametric({s.texts[0], s.texts[1], s.texts[2]},
                                           {s.texts[3], s.texts[4], s.texts[5], s.texts[6]},
                                           {(s.periodic & 1) != 0, (s.periodic & 2) != 0});
    const auto undefined = find_undefined(surface);
    return undefined ? undefined->text : "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

RidgesSmoothCertificate small_height_field() {
  const auto s = parametric("u", "v", "0.3*u^2 + 0.1*v^2 + 0.1*u^3 + 0.02*v^4 + 0.07*u^2*v",
                            {"0.4", "0.5", "0.4", "0.5"});
  return smooth_grid(s, 2, 2, 0.1, 0, 3);
}
RidgesSmoothCertificate ellipsoid() {
  const auto result = crest::smooth_ridges::smooth_ridges(
      Producer::implicit("x^2 + y^2/2.25 + z^2/4 - 1", {-3, 3, -3, 3, -3, 3}), {});
  return result.certificate;
}

/// Of the whole certificate, or the completeness of kind 0 alone.
bool rejects(const RidgesSmoothCertificate& c, Arithmetic arithmetic, bool completeness_alone,
             SecondOpinions& second) {
  if (!completeness_alone) {
    const Verdict verdict = verdict_on(c, arithmetic);
    const bool also =
        arithmetic == Arithmetic::doubles &&
        second.compare(encode(c), verdict, c.surface.texts[c.surface.texts.size() / 3]);
    return !verdict.accepted && !also;
  }
  try {
    const auto surface = smooth::parse_surface(c.surface);
    const auto mesh = smooth::check_mesh(c);
    smooth::check_completeness({surface, c, mesh, arithmetic});
    return false;
  } catch (const Reject&) {
    return true;
  }
}

/// Runs through all combinations, or every `stride`-th.
class Combinations {
 public:
  Combinations()
      : stride_(multiplier() >= kAll ? 1 : static_cast<std::size_t>(kAll / multiplier())) {}

  void run(const Kind& kind, bool completeness_alone = false) {
    for (const std::string& part : kind.parts)
      for (const std::string& nested : kNested)
        for (const std::string& context : kind.contexts)
          for (const std::size_t place : kind.places)
            for (const Arithmetic arithmetic : {Arithmetic::doubles, Arithmetic::mpfr}) {
              if (number_++ % stride_ != 0) continue;
              ++tried_;
              const std::string wrapped = replaced(nested, "#", "(" + part + ")");
              try_one(kind, replaced(context, "#", "(" + wrapped + ")"), place, arithmetic,
                      completeness_alone);
            }
  }
  std::size_t all() const { return number_; }
  std::size_t tried() const { return tried_; }
  std::size_t failures() const { return failures_; }

 private:
  static constexpr double kAll = 101;

  void try_one(const Kind& kind, const std::string& added, std::size_t place, Arithmetic arithmetic,
               bool completeness_alone) {
    RidgesSmoothCertificate forged = kind.certificate;
    const Marked marked(forged.surface.texts[place] + " + " + added);
    forged.surface.texts[place] = marked.text;
    INFO(kind.name << ", text " << place << ", "
                   << (arithmetic == Arithmetic::mpfr ? "mpfr" : "doubles") << ": " << marked.text);
    bool good = rejects(forged, arithmetic, completeness_alone, second_);
    CHECK(good);
    const std::string text = refusal(forged.surface);
    INFO("producer: " << text);
    bool named = false;
    for (const std::size_t column : marked.columns)
      named = named || text.rfind(fmt::format("column {}: ", column), 0) == 0;
    CHECK(named);
    failures_ += good && named ? 0 : 1;
  }

  SecondOpinions second_{4};
  std::size_t stride_, number_ = 0, tried_ = 0, failures_ = 0;
};

Parts joined(Parts a, const Parts& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace

TEST_CASE("smooth ridges: undefined parts in every context are refused and rejected") {
  Combinations all;
  const auto field = small_height_field();
  for (const Arithmetic a : {Arithmetic::doubles, Arithmetic::mpfr}) {
    const Verdict verdict = verdict_on(field, a);
    INFO(verdict.reason);
    REQUIRE(verdict.accepted);
  }
  all.run({"height field", field, joined(kConstants, kHeightField), {2}});
  all.run({"height field, x", field, kHeightField, {0}});
  all.run({"bounds", field, kConstants, {3, 4, 5, 6}});
  all.run({"tube", smooth_claims()[3].certificate, joined(kConstants, kPeriodic), {2}});

  const auto surface = ellipsoid();
  REQUIRE(verdict_on(surface, Arithmetic::doubles).accepted);
  const auto& corner = surface.vertices[surface.faces[0][0]];
  const auto at_corner = [&](Parts parts) {
    for (std::string& part : parts)
      for (std::size_t k = 0; k < 3; ++k)
        part = replaced(part, std::string("{") + "xyz"[k] + "}", fmt::format("{}", corner[k]));
    return parts;
  };
  all.run({"ellipsoid", surface, at_corner(joined(kConstants, kImplicit)), {0}});
  all.run({"ellipsoid, rough", surface, at_corner(kRough), {0}, kZeroContexts});
  all.run({"border of the box", surface, kBorder, {0}}, true);

  WARN(fmt::format("{} of {} combinations, {} wrong", all.tried(), all.all(), all.failures()));
  CHECK(all.all() >= 10000);
}

TEST_CASE("smooth ridges: what is undefined elsewhere does no harm") {
  SecondOpinions second(1);
  const auto field = small_height_field();
  for (const char* added : {"0*log(u)", "0*sqrt(v-0.39)", "1e-6/(u-0.6)", "0*log(log(u+1))",
                            "0*sqrt((u-0.3)^2+(v-0.3)^2)", "u^0 - 1", "0*(u-0.3)^-3"}) {
    RidgesSmoothCertificate c = field;
    c.surface.texts[2] += std::string(" + ") + added;
    INFO(c.surface.texts[2]);
    CHECK(refusal(c.surface).empty());
    for (const Arithmetic a : {Arithmetic::doubles, Arithmetic::mpfr})
      CHECK(verdict_on(c, a).accepted);
    CHECK(second.compare(encode(c), verdict_on(c, Arithmetic::doubles), added));
  }
  RidgesSmoothCertificate c = field;
  c.surface.texts[4] = "0.5 + 0*log(7)*(3)^0";
  CHECK(refusal(c.surface).empty());
  CHECK(verdict_on(c, Arithmetic::doubles).accepted);

  const auto surface = ellipsoid();
  for (const char* added : {"0*log(x+5)", "0*sqrt(x^2+y^2+z^2)", "0*sqrt(x+3)", "0/(x-3.1)"}) {
    c = surface;
    c.surface.texts[0] += std::string(" + ") + added;
    const Verdict verdict = verdict_on(c, Arithmetic::doubles);
    INFO(c.surface.texts[0] << ": " << verdict.reason);
    CHECK(verdict.accepted);
    if (added == std::string("0*log(x+5)")) CHECK(second.compare(encode(c), verdict, added));
    CHECK(refusal(c.surface).empty());
  }
}

TEST_CASE("smooth ridges: the producer says where a part is defined, and how much of it") {
  using Extent = crest::smooth_ridges::Undefined::Extent;
  const auto on_field = [](const std::string& z) {
    return find_undefined(
        Producer::parametric({"u", "v", z}, {"0.11", "0.3", "0.1", "0.3"}, {false, false}));
  };
  CHECK_FALSE(on_field("u^2 + sqrt(u) + 1/v + log(u + v)"));
  const auto half = on_field("u^2 + log(u - 0.2)");
  REQUIRE(half);
  CHECK(half->extent == Extent::here);
  CHECK(half->column == 7);
  CHECK(half->where[0] < 0.2);
  const auto pole = on_field("1/(v - 0.2)");
  REQUIRE(pole);
  CHECK(pole->extent == Extent::perhaps);
  CHECK(pole->where[1] == Approx(0.2));
  CHECK_THROWS_WITH(on_field("u*v + log(u-1)"),
                    "column 7: log(u-1) is defined nowhere in the domain (in z = u*v + log(u-1))");
  CHECK_THROWS_WITH(Producer::implicit("x^2+y^2+z^2-1+log(-1-x^2)", {-2, 2, -2, 2, -2, 2}),
                    Catch::StartsWith("column 15: log(-1-x^2) is defined nowhere in the box"));
  CHECK_THROWS_WITH(
      Producer::parametric({"u", "v", "u*v"}, {"0", "1+0*log(-1)", "0", "1"}, {false, false}),
      "column 5: log(-1) is not defined (in u1 = 1+0*log(-1))");
}
