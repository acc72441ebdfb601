// Tangled from paper/07-temperature.md; edit there.
#include "thermoroll/quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>
#include <stdexcept>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_min.h>

#include "support/number_text.hpp"

namespace thermoroll {
namespace {

constexpr std::size_t intervals = 1000;  // at most, per integral
constexpr double target = 1e-11;         // relative error asked of GSL
constexpr double promised = 1e-9;        // relative error above which the result is refused
constexpr double noise = 1e-14;          // of the integrand: GSL's Bessel functions, cancellation
constexpr double tiny = 1e-290;          // below it, relative accuracy ends with the number range

using Function = std::function<double(double)>;

struct Free {
  void operator()(gsl_integration_workspace* w) const { gsl_integration_workspace_free(w); }
  void operator()(gsl_min_fminimizer* m) const { gsl_min_fminimizer_free(m); }
};
using Workspace = std::unique_ptr<gsl_integration_workspace, Free>;
using Minimizer = std::unique_ptr<gsl_min_fminimizer, Free>;

gsl_function wrapped(const Function& f) {
  const auto call = [](double x, void* g) { return (*static_cast<const Function*>(g))(x); };
  return {call, const_cast<Function*>(&f)};
}

// From here on GSL reports errors by its return codes.
[[maybe_unused]] const auto abort_no_more = gsl_set_error_handler_off();

}  // namespace

Estimate integrate(const Function& f, const std::vector<double>& points, double scale) {
  const Workspace space(gsl_integration_workspace_alloc(intervals));
  if (space == nullptr) throw std::bad_alloc();
  gsl_function function = wrapped(f);
  Estimate sum{0, 0};
  for (std::size_t i = 1; i < points.size(); ++i) {
    Estimate panel{};
    const int status =
        gsl_integration_qags(&function, points[i - 1], points[i], target * scale, target, intervals,
                             space.get(), &panel.value, &panel.error);
    if (status == GSL_EDIVERGE) panel.error += std::abs(panel.value);
    sum.value += panel.value;
    sum.error += panel.error + noise * std::abs(panel.value);
  }
  if (!(sum.error <= promised * std::max(std::abs(sum.value), scale) + tiny)) {
    throw std::runtime_error("integral from " + shortest(points.front()) + " to " +
                             shortest(points.back()) + " not resolved: " + shortest(sum.value) +
                             " with estimated error " + with_exponent(sum.error, 2));
  }
  return sum;
}

double minimum(const Function& f, double low, double middle, double high) {
  const Minimizer search(gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent));
  if (search == nullptr) throw std::bad_alloc();
  gsl_function function = wrapped(f);
  if (gsl_min_fminimizer_set(search.get(), &function, middle, low, high) != GSL_SUCCESS)
    throw std::runtime_error("no minimum between " + shortest(low) + " and " + shortest(high));
  for (int i = 0; i < 100 && high - low > 1e-9; ++i) {
    if (gsl_min_fminimizer_iterate(search.get()) != GSL_SUCCESS) break;  // none is better
    low = gsl_min_fminimizer_x_lower(search.get());
    high = gsl_min_fminimizer_x_upper(search.get());
  }
  return gsl_min_fminimizer_x_minimum(search.get());
}

}  // namespace thermoroll
