// Tangled from paper/F-data-files.md; edit there.
#include <utility>

#include "studies/claims.hpp"
#include "studies/data.hpp"

namespace thermoroll {
namespace {

const std::pair<std::string, std::string> symbols[] = {
    {"T*max", "$T^*_{\\max}$"},
    {"|q| < f p", "$|q|<fp$"},
    {"p* ", "$p^*$ "},
    {"q* ", "$q^*$ "},
    {"1 − κ", "$1-\\kappa$"},
    {"γ0", "$\\gamma_0$"},
    {"Pe", "$\\mathrm{Pe}$"},
    {" n ", " $n$ "},
    {" H ", " $H$ "},
    {"Q*", "$Q^*$"},
    {"T*", "$T^*$"},
    {"v*", "$v^*$"},
    {"c0", "$c_0$"},
    {"% of f", "% of $f$"},
};

std::string in_tex(std::string text) {
  for (const auto& [plain, tex] : symbols)
    for (std::size_t at = 0; (at = text.find(plain, at)) != text.npos; at += tex.size())
      text.replace(at, plain.size(), tex);
  return text;
}

std::string links_to(const Evidence& x) {
  std::string links = '@' + x.section + ", " + (x.figure.empty() ? "–" : '@' + x.figure);
  links += " [code](<#chunk:" + x.chunk + ">)";
  for (const std::string& test : x.tests) links += " [test](#test:" + test + ')';
  return links;
}

void claims_table(std::ostream& out) {
  row(out, "the paper says", "where", "paper", "published scheme", "converged", "corrected sign",
      "verdict", "evidence");
  const auto cell = [](const std::string& text) { return '"' + in_tex(text) + '"'; };
  for (const Claim& c : claims())
    row(out, cell(c.claim), cell(c.source), cell(c.paper), cell(c.published), cell(c.converged),
        cell(c.corrected), cell(c.verdict.words), '"' + links_to(c.evidence) + '"');
}

const FigureData claims_data{"claims", claims_table};

}  // namespace
}  // namespace thermoroll
