// Tangled from paper/M-certified.md; edit there.
#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "bench/certify/certify.hpp"
#include "studies/paper_scene.hpp"
#include "support/number_text.hpp"
#include "thermoroll/carter.hpp"
#include "thermoroll/temperature.hpp"

namespace thermoroll::certify {
namespace {

/// One side of a point s: the integrand of @eq:certified-temperature without x k.
struct Side {
  Side(const ColdContact& c, const Ball& s, bool upstream, bool slope)
      : contact(c), point(s), sign(upstream ? 1 : -1), derivative(slope) {
    length = upstream ? 1 - s : s - c.c0;
    other = upstream ? s - c.c0 : 1 - s;
  }
  Ball operator()(const Ball& x, bool analytic) const {
    const Ball phi = x * x * (3 - 2 * x), far = other + length * phi;
    const Ball gap = (1 - x) * (1 - x), near = length * gap * (1 + 2 * x);
    const Ball r = root(length * (1 + 2 * x) * far, analytic);
    const Ball stick = 1 + point + sign * length * phi;
    const Ball bend = derivative ? gap * r + stick * sign * (near - far) / (2 * r) : Ball(0);
    return 6 * length * contact.unit * (derivative ? bend : stick * gap * r);
  }
  const ColdContact& contact;
  Ball point, length, other;
  double sign;
  bool derivative;
};

Ball integral_of(const Side& side, double peclet, double from) {
  const auto integrand = [&](const Ball& x, bool analytic) {
    const Ball zeta = peclet * side.length * x * x * (3 - 2 * x);
    const Ball decay = side.sign > 0 ? exponential(-2 * zeta) : Ball(1);
    return x * temperature_kernel(zeta) * decay * side(x, analytic);
  };
  std::vector<double> points{from};
  while (points.back() < 0x1p-3) points.push_back(8 * points.back());
  points.push_back(1);
  const Ball most = root(pi_ball() / (2 * peclet * side.length)) * side(between(0, from), false);
  return widened(integral(integrand, points), from * most);
}

Ball temperature_at(const ColdContact& c, double peclet, const Ball& s, bool slope, double from) {
  const Side before(c, s, true, slope), behind(c, s, false, slope);
  return (integral_of(before, peclet, from) + integral_of(behind, peclet, from)) / pi_ball();
}

/// The contact, the temperature that is known to occur and the least length of a tile.
struct Tiles {
  Ball at(const Ball& s, bool slope) const {
    return temperature_at(contact, peclet, s, slope, 0x1p-40);
  }
  const ColdContact& contact;
  double peclet, known, least;
};

Ball end_temperature(const Tiles& of, double low, double high) {
  const ColdContact& c = of.contact;
  const bool upstream = high < 1;  // the longer side
  const Ball width = upstream ? high - c.c0 : Ball(1) - low;
  const Side longer(c, between(low, high), upstream, false);
  const double from = upper(2 * root(width / (2 * c.l)));
  if (from > 0.25) return undefined();
  const Ball shorter = 12 * c.unit * width * root(3 * pi_ball() * c.l / of.peclet);
  return (integral_of(longer, of.peclet, from) + shorter) / pi_ball();
}

/// An upper bound of T* if its maximum is in the tile; else at least what is known.
double bound_on(const Tiles& of, double low, double high) {
  const double middle = (low + high) / 2;
  if (high == 1 || !positive(low - of.contact.c0)) {
    if (upper(end_temperature(of, low, high)) <= of.known) return of.known;
  } else {
    const Ball slope = of.at(between(low, high), true);
    if (positive(slope) || positive(-slope)) return of.known;
    if (high - low < of.least)
      return upper(widened(of.at(middle, false), (high - low) / 2 * slope));
  }
  return std::max(bound_on(of, low, middle), bound_on(of, middle, high));
}

double largest(const ColdContact& c, double peclet, double known) {
  const slong usual_bits = std::exchange(bits, 64), usual_goal = std::exchange(goal_bits, 36);
  const double most = bound_on({c, peclet, known, 4e-4}, lower(c.c0), 1);
  bits = usual_bits;
  goal_bits = usual_goal;
  return most;
}

}  // namespace

void certified_temperatures(const Rows& rows) {
  std::puts("$Q^*$,$\\mathrm{Pe}$,$s$,$T^*$,radius,library,revision,date");
  const double cases[][2] = {{0.5, 4360}, {0.5, 100}, {0.59, 1000}, {0.2, 15000}};
  for (const auto& [traction, peclet] : cases) {
    const ColdContact c(paper::friction, traction);
    const HeatFlux flux = carter_flux(carter(paper::friction, traction));
    const double s = hottest_point(flux, peclet).at, leading = (flux.from + s) / 2;
    const std::string contact = shortest(traction) + "," + shortest(peclet) + ",";
    for (const double place : {leading, s})
      rows(contact + shortest(place), temperature_at(c, peclet, place, false, 0x1p-60));
    const double known = lower(temperature_at(c, peclet, s, false, 0x1p-60));
    rows(contact + "maximum", between(known, largest(c, peclet, known)));
  }
}

}  // namespace thermoroll::certify
