#include "compare/documents/texts/regime_text.hpp"

#include <fmt/format.h>

#include <cstddef>

namespace validate {
namespace {

const char* in_words(Regime regime) {
  switch (regime) {
    case Regime::bending:
      return "bending dominates";
    case Regime::membrane:
      return "a membrane";
    case Regime::softening:
      return "softening dominates";
    case Regime::hardening:
      return "hardening dominates";
    case Regime::cancellation:
      return "bending and the law's curvature cancel each other";
    case Regime::artefact:
      return "artefact zone";
  }
  return "";
}

}  // namespace

std::string regime_text(const Comparison& c) {
  std::string text;
  for (std::size_t i = 0; i < c.depth_A.size(); ++i) {
    const bool last = i + 1 == c.depth_A.size() || c.regime[i + 1] != c.regime[i];
    if (last) text += fmt::format("{}{} up to {:.3g} Å", text.empty() ? "" : ", ", in_words(c.regime[i]), c.depth_A[i]);
  }
  return text;
}

}  // namespace validate
