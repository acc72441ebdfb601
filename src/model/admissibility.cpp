// Tangled from paper/04-integral-equations.md; edit there.
#include "thermoroll/admissibility.hpp"

#include <algorithm>
#include <cmath>

namespace thermoroll {

using Eigen::ArrayXd;
using Eigen::Index;

namespace {

/// Add an interval for each run of nodes where the condition is negative or NaN, up to where it
/// changes sign between two nodes, or to the end of the contact.
void add(std::vector<Violation>& found, const char* what, const ArrayXd& s,
         const ArrayXd& condition) {
  const auto root = [&](Index i) {  // between nodes i and i + 1
    const double share = condition(i) / (condition(i) - condition(i + 1));
    return s(i) + (std::isfinite(share) ? share : 0) * (s(i + 1) - s(i));
  };
  const Index n = s.size();
  for (Index i = 0, first = 0; i < n; ++i) {
    const bool bad = !(condition(i) >= 0), more = i + 1 < n && !(condition(i + 1) >= 0);
    if (bad && (i == 0 || condition(i - 1) >= 0)) first = i;
    if (bad && !more)
      found.push_back({what, first > 0 ? root(first - 1) : -1, i + 1 < n ? root(i) : 1});
  }
}

bool is_same(const Violation& x, const Violation& y) {
  const double shared = std::min(x.to, y.to) - std::max(x.from, y.from);
  const double covered = std::max(x.to, y.to) - std::min(x.from, y.from);
  return x.what == y.what && shared >= covered / 2;
}

}  // namespace

std::vector<Violation> violations(const Factors& at) {
  const ArrayXd stick = (at.border - at.s).max(0).sqrt();
  ArrayXd limit = 2 * at.friction * (1 - at.s).sqrt() * at.pressure;
  if (at.phi.size() > 0) limit *= at.phi;
  const ArrayXd other_limit = limit - stick * at.slip;
  std::vector<Violation> found;
  add(found, "separation", at.s, at.pressure);
  add(found, "backward slip", at.s, (at.s > at.border).select(at.slip, 1));
  add(found, "traction above friction", at.s, (at.s < at.border).select(at.slip, 1));
  add(found, "traction below -friction", at.s, (at.s < at.border).select(other_limit, 1));
  if (!(at.load_ratio > 0)) found.push_back({"no load", -1, 1});
  return found;
}

std::optional<std::vector<Violation>> agreed_violations(const std::vector<Violation>& a,
                                                        const std::vector<Violation>& b) {
  std::vector<Violation> both;
  for (const Violation& x : b)
    if (std::any_of(a.begin(), a.end(), [&](const auto& y) { return is_same(x, y); }))
      both.push_back(x);
  if (both.empty() && !(a.empty() && b.empty())) return std::nullopt;
  return both;
}

}  // namespace thermoroll
