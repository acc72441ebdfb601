#include "properties.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <functional>
#include <random>
#include <sstream>
#include <stdexcept>
#include <typeinfo>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "program/names.hpp"
#include "solver/contact_grid.hpp"
#include "solver/grid_solution.hpp"
#include "solver/least_model.hpp"
#include "support/number_text.hpp"
#include "thermoroll/carter.hpp"
#include "thermoroll/kernels.hpp"
#include "thermoroll/quadrature.hpp"
#include "thermoroll/solution.hpp"
#include "ways.hpp"

using namespace thermoroll;
using enum thermoroll::Quantity;
using Eigen::ArrayXd;
using Eigen::Index;

namespace soak {
namespace {

/// Numbers from a generator whose sequence the language fixes, unlike its distributions.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t number) {
    std::seed_seq both{seed >> 32, seed & 0xffffffff, number >> 32, number & 0xffffffff};
    generator_.seed(both);
  }
  double uniform(double from, double to) {
    return from + (to - from) * static_cast<double>(generator_() >> 11) * 0x1p-53;
  }
  double log_uniform(double from, double to) {
    return std::exp(uniform(std::log(from), std::log(to)));
  }
  bool one_of(int n) { return generator_() % static_cast<std::uint64_t>(n) == 0; }

 private:
  std::mt19937_64 generator_;
};

/// The words of a message without its numbers, which would make every refusal one of a kind.
std::string words_of(std::string message) {
  std::string words;
  for (std::size_t i = 0; i < message.size(); ++i) {
    const std::size_t digit = message[i] == '-' ? i + 1 : i;
    const bool starts = i == 0 || message[i - 1] == ' ';
    if (starts && digit < message.size() &&
        std::isdigit(static_cast<unsigned char>(message[digit]))) {
      words += '#';
      i = std::min(message.find_first_of(" ,:", i), message.size()) - 1;
    } else {
      words += message[i];
    }
  }
  return words;
}

/// Whether friction and bulk temperature are constant and both bodies have one diffusivity, if both
/// conduct.
bool is_plain(const Scene& scene) {
  return !scene.law && scene.bulk_difference == 0 && !is_unlike(scene);
}

CoupledSolution solve(const Sample& x, double given) {
  return solve_coupled(x.scene, {x.formulation, x.tolerance},
                       {x.given.quantity, given, x.given.branch});
}

/// What is said of a solution must be numbers, keep the tolerance and fit together.
void examine_results(const Record& record, const Sample& x, const CoupledSolution& found) {
  const Results &v = found.value, &e = found.error;
  record.require("all results are finite", v.allFinite() && e.allFinite());
  record.require("errors are positive", (e >= 0).all());
  for (const Quantity q : {stick_slip_border, traction, load_ratio, gamma0})
    record.within("errors keep the tolerance", e(q), x.tolerance);
  const bool contact = found.violations.empty();
  const Results scale = scale_in(x.scene, v);
  for (const Quantity q : {creep_constant, creep, heat_integral, max_temperature})
    if (contact)  // without one they may be zero
      record.within("errors keep the tolerance", e(q), x.tolerance * scale(q) * (1 + 1e-12));
  const Quantity given = x.given.quantity;
  record.within("what is given comes out", v(given) - x.given.value, std::max(e(given), 1e-15));
  const bool slips = v(stick_slip_border) == -1;
  const bool may_slip = given == creep || (given == traction && x.scene.law);
  record.require("the border is in the contact, or a creep or a hot traction leaves no stick",
                 std::abs(v(stick_slip_border)) < 1 || (slips && may_slip));
  record.require("full slip pulls with the friction",
                 !slips || x.scene.law || v(traction) == x.scene.friction);
  const bool warms = v(max_temperature) > 0 || x.scene.bulk_difference != 0;  // of the warmer bulk
  record.require("heat, temperature and load ratio are positive",
                 !contact || (v(heat_integral) > 0 && warms && v(load_ratio) > 0));
  // C = xi* + f gamma0; each is a sum of about a hundred terms of its own size or that of f kappa.
  const double f = x.scene.friction;
  record.within("the creep belongs to its constant", v(creep_constant) - v(creep) - f * v(gamma0),
                1e-12 * f * (1 + std::abs(v(load_ratio)) + std::abs(v(gamma0))));
  record.within("the eccentricity belongs to gamma0",
                v(eccentricity) - pi * v(gamma0) / (2 * v(load_ratio)),
                1e-15 * std::abs(v(eccentricity)) + 1e-300);
  // An observation and no theorem: of the samples tried, none lost contact below these heatings.
  // Those beyond are asked whether "a finer solution is as much of a contact".
  const double strength = x.scene.friction * heating_of_both(x.scene);
  if (is_plain(x.scene) && strength <= (strain_share(x.scene) == 1 ? 10 : 0.5))
    record.require("a solution is a contact", contact);
  record.require("the work is bounded",
                 found.unknowns <= most_unknowns && found.newton_steps <= 100);
}

/// Without heat the solution is Carter's, but for a few roundings.
void examine_without_heat(const Record& record, const Sample& x, const CoupledSolution& found) {
  if (heating_of_both(x.scene) > 0 || !is_plain(x.scene)) return;
  const Results closed = carter_values(carter_given(x.scene.friction, x.given));
  const Results scale = scale_of(closed);
  for (int i = 0; i + 1 < compared; ++i)
    record.within("without heat it is the closed form", found.value[i] - closed[i],
                  found.error[i] + 1e-15 * scale[i]);
}

/// A lesser model is off by no more than it says. The coupled solution's own error counts tenfold,
/// which its estimate may be exceeded by.
void examine_least_model(const Record& record, const Sample& x, const CoupledSolution& found) {
  const Choice least = least_model(x.scene, {x.formulation, x.tolerance}, x.given);
  if (least.model == Model::coupled) return record.beside("the least model", "is the coupled one");
  const Results off = (least.solution.value - found.value).abs();
  const Results allowed = least.solution.error + 10 * found.error + 1e-15 * scale_of(found.value);
  for (int i = 0; i < compared; ++i)
    record.within("a lesser model is as good as it says", off[i], allowed[i]);
}

/// As a user gives it: a border has no sign.
Prescribed signed_given(const Sample& x) {
  const bool has_sign = x.given.quantity != stick_slip_border;
  return {x.given.quantity, has_sign ? sign_of(x.scene.direction) * x.given.value : x.given.value,
          x.given.branch};
}

Solution solve_to(const Sample& x, double tolerance) {
  Approach approach;
  approach.method = Method::coupled;
  approach.formulation = x.formulation;
  approach.tolerance = tolerance;
  return thermoroll::solve(x.scene, signed_given(x), approach);
}

/// The scene in SI units of a steel of its own, with a creep as a fraction of the speed and a
/// traction as a load.
GivenScene in_si(const Sample& x) {
  const double width = 5e-3, load = 1e7, poisson = 0.3, diffusivity = 1.4e-5, conductivity = 50;
  const Scene& scene = x.scene;
  const auto expansion = [&](double heating, double k, double conducts) {
    return heating * width * conducts / (2 * (1 + poisson) * k * load);
  };
  PhysicalScene si{load,        2 * diffusivity * scene.peclet / width,
                   width,       8.1e10,
                   poisson,     expansion(scene.heating, diffusivity, conductivity),
                   diffusivity, conductivity};
  if (const Roller& roller = scene.roller; roller.conductivity_ratio > 0) {
    si.conductivity_2 = roller.conductivity_ratio * conductivity;
    si.diffusivity_2 = roller.peclet > 0 ? diffusivity * scene.peclet / roller.peclet : diffusivity;
    si.expansion_2 = expansion(roller.heating, si.diffusivity_2, si.conductivity_2);
  }
  si.direction = scene.direction;
  const Units unit = units_of(si, scene.friction);
  if (scene.bulk_difference != 0) si.bulk_temperature = 20;
  if (scene.bulk_difference != 0)
    si.bulk_temperature_2 = 20 + scene.bulk_difference * unit.temperature;
  if (const auto* law = scene.law.target<LawOfFriction>()) {
    si.law = *law;
    si.law->of.scale *= unit.temperature;
    si.law->of.reference *= unit.temperature;
  }
  Prescribed given = signed_given(x);
  const bool creeps = given.quantity == creep;
  if (creeps) given.value *= unit.slip / si.speed;
  return {{scene.friction, 0, 0},
          given,
          {x.formulation, x.tolerance, Method::coupled},
          si,
          {},
          creeps ? CreepUnit::ratio : CreepUnit::scaled};
}

/// In SI units the groups differ by some roundings. Results and errors are those of the scene.
void examine_in_si(const Record& record, const Sample& x, const CoupledSolution& found) try {
  const SolvedScene y = solve_scene(in_si(x));
  if (!y.solution.converged || !y.solution.violations.empty()) return;
  const Results error = 10 * (found.error + *y.solution.error) + 1e-12 * scale_of(found.value);
  const double sign = sign_of(x.scene.direction);
  for (int i = 0; i < compared; ++i) {
    const auto quantity = static_cast<Quantity>(i);
    const bool turns = quantity == traction || quantity == creep || quantity == creep_constant;
    const double value = y.solution.value[i];
    record.within("a scene in SI units is the same",
                  (turns ? std::abs(value) - std::abs(found.value[i]) : value - found.value[i]),
                  error[i]);
    if (turns && quantity != creep_constant)
      record.require("a scene in SI units has its sign", value * sign * found.value[i] >= 0);
  }
  const PhysicalResults& si = y.physical->value;
  record.require("results in SI units are finite",
                 std::isfinite(si.radius + si.max_pressure + si.max_traction + si.max_heat_flux +
                               si.dissipation + y.physical->error->max_pressure));
} catch (const std::exception& error) {
  record.beside("the scene in SI units", words_of(error.what()));
}

/// A solution to 1e-10 where it can be had, else a hundred times as accurate as is asked for, or
/// 1e-8.
Solution finer(const Sample& x) {
  try {
    return solve_to(x, 1e-10);
  } catch (const std::runtime_error&) {
    return solve_to(x, std::min(1e-8, x.tolerance / 100));
  }
}

/// A result and a finer one, each with its error.
struct Pair {
  double value, error, exact, exact_error;
};

/// The results, peaks, crossing heat and largest traction of both solutions, but for what is given.
std::vector<Pair> pairs(const Sample& x, const Solution& found, const Solution& exact) {
  const auto &a = std::get<CoupledSolution>(found.found),
             &b = std::get<CoupledSolution>(exact.found);
  std::vector<Pair> all;
  for (int i = 0; i <= compared; ++i)
    if (i != static_cast<int>(x.given.quantity))
      all.push_back({a.value[i], a.error[i], b.value[i], b.error[i]});
  const FoundPeaks p = peaks(found), q = peaks(exact);
  for (double Peaks::*of : {&Peaks::pressure, &Peaks::traction, &Peaks::heat_flux})
    all.push_back({p.value.*of, (*p.error).*of, q.value.*of, (*q.error).*of});
  if (a.crossing && b.crossing) {
    const CrossingHeat &c = *a.crossing, &d = *b.crossing;
    all.push_back({c.heat, c.heat_error, d.heat, d.heat_error});
    all.push_back({c.edge, c.edge_error, d.edge, d.edge_error});
  }
  if (a.limit && b.limit) {
    all.push_back(
        {a.limit->traction, a.limit->traction_error, b.limit->traction, b.limit->traction_error});
    all.push_back({a.limit->creep, a.limit->creep_error, b.limit->creep, b.limit->creep_error});
  }
  return all;
}

/// The true error, against a finer solution, is within ten times its estimate, and, of a result,
/// within the tolerance. Whether it is within the estimate itself is counted. Quantities that the
/// finer solution does not know to a tenth of the estimate are left out.
void examine_error(const Record& record, const Sample& x, const CoupledSolution& coupled) {
  Solution exact;
  try {
    exact = finer(x);
  } catch (const std::runtime_error& error) {
    return record.beside("no finer solution", words_of(error.what()));
  }
  double excess = 0;
  for (const Pair& of : pairs(x, solve_to(x, x.tolerance), exact)) {
    record.require("values and errors are numbers", !std::isnan(of.value) && !std::isnan(of.error));
    if (of.exact_error <= 0.1 * of.error)
      excess = std::max(excess, std::abs(of.value - of.exact) / of.error);
  }
  record.within("no error is ten times its estimate", excess, 10);
  record.require(
      "a finer solution has a largest traction, too",
      coupled.limit.has_value() == std::get<CoupledSolution>(exact.found).limit.has_value());
  record.compared(x.tolerance, excess);
  const auto& best = std::get<CoupledSolution>(exact.found);
  const Results off = (coupled.value - best.value).abs();
  const Results scale = scale_in(x.scene, best.value);
  for (int i = 0; i < compared && coupled.violations.empty(); ++i)
    record.within("the tolerance is kept", off[i], x.tolerance * scale[i] + best.error[i]);
  // Heat that bends the profile more than the load does can leave no contact; what is said of that
  // is of the scene and not of a grid.
  record.require("a finer solution is as much of a contact",
                 coupled.violations.empty() == best.violations.empty());
}

/// A creep near that of the largest traction, or in full slip, has no more of it.
void examine_limit(const Record& record, const Sample& x, const CoupledSolution& found) {
  if (!found.limit || x.scene.bulk_difference != 0) return;
  const TractionLimit& limit = *found.limit;
  for (const double share : {0.5, 0.9, 0.99, 0.999, 0.9997, 1.0, 1.0003, 1.01, 1.1, 3.0}) {
    CoupledSolution there;
    try {
      there = solve_coupled(x.scene, {x.formulation, x.tolerance}, {creep, share * limit.creep});
    } catch (const std::exception& error) {
      record.beside("no solution about the largest traction", words_of(error.what()));
      continue;
    }
    record.within("no creep has more than the largest traction",
                  std::max(there.value(traction) - limit.traction, 0.0),  // or NaN
                  limit.traction_error + there.error(traction));
  }
}

bool same_bits(const Results& a, const Results& b) {
  return std::memcmp(a.data(), b.data(), sizeof(double) * Results::SizeAtCompileTime) == 0;
}

/// Once more gives the same bits; less traction or creep leaves more stick, but for a falling
/// branch and where the state without slip is not zero.
void examine_again(const Record& record, const Sample& x, const CoupledSolution& found) {
  const CoupledSolution again = solve(x, x.given.value);
  record.require("once more gives the same bits", same_bits(found.value, again.value) &&
                                                      same_bits(found.error, again.error) &&
                                                      found.h == again.h);
  if (x.given.quantity == stick_slip_border || !found.violations.empty()) return;
  if (x.given.branch == Branch::falling || x.scene.bulk_difference != 0) return;
  const double most = x.given.quantity == traction ? x.scene.friction : 2 * x.scene.friction / pi;
  const double given = x.given.value, less = given - 0.05 * std::min(given, std::abs(most - given));
  try {
    const CoupledSolution other = solve(x, less);
    if (!other.violations.empty()) return;
    record.require("less traction or creep, more stick", other.value(stick_slip_border) +
                                                                 other.error(stick_slip_border) +
                                                                 found.error(stick_slip_border) >=
                                                             found.value(stick_slip_border));
  } catch (const std::runtime_error& error) {
    record.beside("a neighbour", words_of(error.what()));
  }
}

/// Points of one zone, whose distances from its two ends keep their digits.
struct Places {
  ArrayXd ds, from_border, from_end;  // weights; distances from c0 and from -1 or 1
};

/// q^2 (3 - 2q), its derivative by q, and what is left of 1, for q and 1 - q.
Places cubic(const ArrayXd& q, const ArrayXd& rest) {
  return {6 * q * rest, q.square() * (1 + 2 * rest), rest.square() * (1 + 2 * q)};
}

Places scaled(const Places& x, double length, const ArrayXd& weights) {
  return {length * x.ds * weights, length * x.from_border, length * x.from_end};
}

/// The places of @eq:angles for the nodes y of a rule.
Places slip_places(double length, const SlipVariable& by, const GaussLegendre& rule) {
  const auto rise = [](const ArrayXd& eta) { return eta * (3 + (12 - 4 * eta) * eta) / 22; };
  ArrayXd left = 1 + rule.x, right = 1 - rule.x, weights = rule.w;
  for (std::size_t i = 2; i-- > 0;) {  // psi = place + width sinh(rate (x - middle))
    const Cluster& c = by.clusters[i];
    if (c.rate == 0) continue;
    const double k = c.rate / 2;
    const double at_left = c.rate * (1 + c.middle), at_right = c.rate * (1 - c.middle);
    const ArrayXd x = c.rate * ((left - right) / 2 - c.middle);
    weights *= c.width * c.rate * x.cosh();
    left = 2 * c.width * (k * left).sinh() * ((x - at_left) / 2).cosh();
    right = 2 * c.width * (k * right).sinh() * ((x + at_right) / 2).cosh();
  }
  if (const double beta = by.beta; beta > 0) {  // psi = tanh(beta x) / tanh(beta)
    const ArrayXd grown = (beta * left).sinh(), rest = (beta * right).sinh(), sum = grown + rest;
    left = 2 * grown / sum;
    right = 2 * rest / sum;
    weights *= beta / (std::tanh(beta) * (beta * rule.x).cosh().square());
  }
  const ArrayXd du = (3 + 12 * left * right) / 22 * weights;
  return scaled(cubic(rise(left), rise(right)), length, du);
}

/// The same on the stick zone, q = eps (e^(k rho) - 1) with rho = (1 + x) / 2.
Places stick_places(double length, double near, const GaussLegendre& rule) {
  const double eps = std::min(1.0, std::sqrt(near / length)), k = std::log1p(1 / eps);
  const ArrayXd grown = eps * (k / 2 * (1 + rule.x)).exp();
  const ArrayXd rest =
      -(1 + eps) * (k / 2 * (rule.x - 1)).unaryExpr([](double x) { return std::expm1(x); });
  return scaled(cubic(grown - eps, rest), length, k / 2 * grown * rule.w);
}

/// The matrix that takes values at the nodes of a rule to those of their polynomial at points.
Eigen::MatrixXd interpolation(const GaussLegendre& from, const ArrayXd& to) {
  return legendre(to, from.x.size()) * to_legendre(from);
}

/// A zone at the nodes of a profile and at many more points; the values of a smooth function at
/// the former, from the border on, give those at the latter.
struct Zone {
  Places nodes, fine;
  Eigen::MatrixXd values;
};

Zone zone(Index n, const std::function<Places(const GaussLegendre&)>& places) {
  const GaussLegendre &nodes = gauss_legendre(static_cast<int>(n)),
                      &fine = gauss_legendre(static_cast<int>(200 + 2 * n));
  return {places(nodes), places(fine), interpolation(nodes, fine.x)};
}

/// The tractions of a profile on many points, from the smooth factors of their roots.
struct Tractions {
  Zone stick, slip;
  ArrayXd pressure, pull, flux;  // on the stick zone, then on the slip zone; flux on the latter
};
Tractions tractions_of(const Sample& x, const CoupledSolution& found, const Profile& y) {
  const double slip = found.value(slip_length), c0 = found.value(stick_slip_border),
               f = x.scene.friction;
  const Index n = found.unknowns, m = y.s.size() - n;
  const double near = std::min(slip, smooth_tractions(found, found.unknowns).layer);
  Tractions z{zone(m, [&](const GaussLegendre& r) { return stick_places(1 + c0, near, r); }),
              zone(n, [&](const GaussLegendre& r) { return slip_places(slip, found.variable, r); }),
              {},
              {},
              {}};
  const auto root = [](const Places& at) { return (at.from_end * (2 - at.from_end)).sqrt(); };
  const auto between = [](const Places& at) { return (at.from_end * at.from_border).sqrt(); };
  const auto on_fine = [](const Zone& of, const ArrayXd& factor) {
    return (of.values * factor.matrix()).array();
  };
  const ArrayXd p = y.pressure.head(m).reverse(), q = y.traction.head(m).reverse();
  const ArrayXd p_stick = on_fine(z.stick, p / root(z.stick.nodes)) * root(z.stick.fine);
  const ArrayXd p_slip =
      on_fine(z.slip, y.pressure.tail(n) / root(z.slip.nodes)) * root(z.slip.fine);
  const ArrayXd short_of = on_fine(z.stick, (f * p - q) / between(z.stick.nodes));
  z.pressure.resize(p_stick.size() + p_slip.size());
  z.pressure << p_stick, p_slip;
  z.pull = f * z.pressure;
  z.pull.head(p_stick.size()) -= short_of * between(z.stick.fine);
  z.flux = on_fine(z.slip, y.heat_flux.tail(n) / between(z.slip.nodes)) * between(z.slip.fine);
  return z;
}

double integral(const Tractions& z, const ArrayXd& values) {
  const ArrayXd &stick = z.stick.fine.ds, &slip = z.slip.fine.ds;
  return (stick * values.head(stick.size())).sum() + (slip * values.tail(slip.size())).sum();
}

/// The tractions have their signs and carry the loads.
void examine_profile(const Record& record, const CoupledSolution& found, const Profile& y,
                     const Tractions& z) {
  record.require("profiles are finite", y.pressure.allFinite() && y.traction.allFinite() &&
                                            y.slip.allFinite() && y.heat_flux.allFinite() &&
                                            y.temperature.allFinite());
  if (found.violations.empty())
    record.require("pressure and slip are positive",
                   (y.pressure > 0).all() && (y.slip.tail(found.unknowns) > 0).all());
  // The profile has the border that is reported and the h of the last grid, whose border was
  // another by what the last change was of. Of a change, at least a fiftieth is counted as error,
  // and a twentieth on a grid of more than 200 unknowns, so this is at most so many errors. The
  // pressure carries the load for any h. What depends on h moves with it less than a result of
  // order one with the border: Carter's heat over (1 - c0)^2 by half of it.
  const double errors = found.unknowns > 200 ? 20 : 50;
  const Results &v = found.value, &e = found.error;
  // A load that is off by its error pulls by f times that more, while the result has the load of
  // one; by how much with a law is not known.
  const double load = integral(z, z.pressure) - 1;
  const double more = found.scene.law ? 0 : found.scene.friction * load;
  record.within("the pressure carries the load", load, e(load_ratio));
  record.within("the traction carries the pull", integral(z, z.pull) - more - v(traction),
                errors * e(traction));
  record.within("the flux carries the heat", (z.slip.fine.ds * z.flux).sum() - v(heat_integral),
                errors * e(heat_integral));
  record.within("no point is hotter than the hottest",
                std::max(y.temperature.maxCoeff() - v(max_temperature), 0.0),  // or NaN
                errors * e(max_temperature));
}

/// The strain by heat at s, without its factor tau f Pe H / pi: the integral of N2 with the flux.
double strain(const HeatFlux& flux, double peclet, double s) {
  const double length = flux.to - flux.from, from = flux.from - s, to = flux.to - s;
  std::vector<double> points{from, to};
  if (from < 0 && to > 0) points.push_back(0);
  for (const double width : {1 / peclet, std::abs(from), to})
    for (double u = std::max(width, 1e-9 * length); u < 2; u *= 16)
      for (const double at : {-u, u})
        if (from < at && at < to) points.push_back(at);
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const auto integrand = [&](double u) {
    return u == 0 ? 0 : kernel::N2(peclet * u) * flux.density(u - from, to - u);
  };
  return integrate(integrand, points).value;
}

/// f int g = xi Q - (tau f Pe H / pi) int q int N2 g with the share of strain tau and the heating
/// of both bodies, as in Coupled.EnergyBalances, where the adaptive quadrature finds int N2 g.
void examine_energy(const Record& record, const Sample& x, const CoupledSolution& found,
                    const Profile& y, const Tractions& z) {
  const double f = x.scene.friction, peclet = x.scene.peclet;
  const double heating = strain_share(x.scene) * heating_of_both(x.scene);
  const HeatFlux flux = coupled_flux(found);
  const Index n = found.unknowns, m = y.s.size() - n;
  Eigen::VectorXd strains(m + n);
  try {
    for (Index i = 0; i < m + n; ++i) strains(i) = strain(flux, peclet, y.s(i));
  } catch (const std::runtime_error& error) {
    return record.beside("the energy", words_of(error.what()));
  }
  ArrayXd everywhere(z.pull.size());
  everywhere << z.stick.values * strains.head(m).reverse(), z.slip.values * strains.tail(n);
  const Results &v = found.value, &e = found.error;
  const double q = v(traction);
  const double lost = f * peclet * heating / pi * integral(z, z.pull * everywhere);
  const double allowed =
      f * e(heat_integral) + q * e(creep) + std::abs(lost) * e(heat_integral) / v(heat_integral);
  record.within("the energy balances", f * v(heat_integral) - v(creep) * q + lost, 5 * allowed);
}

}  // namespace

/// The options of a cylinder that conducts.
static std::string text_of_pair(const Scene& scene) {
  const Roller& roller = scene.roller;
  std::string text;
  if (roller.conductivity_ratio > 0)
    text += " --roller conducting --conductivity-ratio " + shortest(roller.conductivity_ratio) +
            " --heating-2 " + shortest(roller.heating);
  if (roller.peclet > 0) text += " --peclet-2 " + shortest(roller.peclet);
  if (scene.bulk_difference != 0) text += " --bulk-difference " + shortest(scene.bulk_difference);
  return text;
}

static std::string text_of_law(const Scene& scene) {
  const auto* law = scene.law.target<LawOfFriction>();
  if (law == nullptr) return "";
  return " --friction-law " + name_of(law_names, std::optional(law->kind)) +
         " --friction-temperature " + shortest(law->of.scale) + " --friction-floor " +
         shortest(law->of.floor) + " --friction-reference-temperature " +
         shortest(law->of.reference);
}

std::string text(const Sample& x) {
  const bool by_creep = x.given.quantity == creep,
             by_border = x.given.quantity == stick_slip_border;
  return "--friction " + shortest(x.scene.friction) +
         (by_creep    ? " --creep "
          : by_border ? " --stick-slip-border "
                      : " --traction ") +
         shortest(signed_given(x).value) + " --peclet " + shortest(x.scene.peclet) + " --heating " +
         shortest(x.scene.heating) + " --tolerance " + shortest(x.tolerance) +
         (x.formulation == Formulation::printed ? " --formulation printed" : "") +
         (by_border && x.scene.direction == Direction::braking ? " --direction braking" : "") +
         (x.given.branch == Branch::falling ? " --branch falling" : "") + text_of_pair(x.scene) +
         text_of_law(x.scene);
}

/// Near both ends of (0, 1) log-uniform down to the least, in between uniform.
static double spread_share(Random& random, double least) {
  const double share =
      random.one_of(3) ? random.log_uniform(least, 0.01) : random.uniform(0.005, 0.5);
  return random.one_of(2) ? share : 1 - share;
}

/// The traction, or the creep or border that Carter's solution has with it.
static Prescribed spread_given(Random& random, double friction, double share) {
  const double root = std::sqrt(1 - share), slip_half_width = share / (1 + root);
  if (!random.one_of(3)) return {traction, share * friction};
  if (random.one_of(2)) return {creep, 2 * friction / pi * slip_half_width};
  return {stick_slip_border, share < 0.5 ? 1 - 2 * slip_half_width : 2 * root - 1};
}

/// An insulator, the same body, or another with a heating from a tenth to ten times as large.
static Roller spread_roller(Random& random, double heating) {
  if (random.one_of(3)) return {};
  if (random.one_of(2)) return {1, heating};
  return {random.log_uniform(0.01, 100), heating * random.log_uniform(0.1, 10)};
}

/// Laws of each kind in turn; a quarter of the linear ones rise, and half have a reference
/// temperature above that of the bulk.
static LawOfFriction spread_law(Random& random, LawKind kind, double warm) {
  const bool rises = kind == LawKind::linear && random.one_of(4);
  const double scale = (rises ? -1 : 1) * warm * random.log_uniform(0.02, 20);
  const double most = kind == LawKind::piecewise_linear ? 1.5 : 0.9;
  const double floor = rises ? 0 : random.uniform(0, most);
  return {kind, {scale, floor, random.one_of(2) ? 0 : warm * random.log_uniform(1e-3, 1)}};
}

/// As far from the state without slip as from zero without a bulk difference.
static Prescribed beyond_rest(const Scene& scene, Prescribed given) {
  NoSlip rest = no_slip(scene, 1e-2);
  if (given.value < 0.1 * std::abs(given.quantity == traction ? rest.traction : rest.creep))
    rest = no_slip(scene);
  const double sign = sign_of(scene.direction), pull = sign * rest.traction;
  if (std::abs(pull) > 0.5 * scene.friction) return {stick_slip_border, 0};
  if (given.quantity == creep) given.value += sign * rest.creep;
  if (given.quantity == traction) given.value = pull + given.value * (1 - pull / scene.friction);
  return given;
}

/// Less than the creep of full slip in this scene, as Carter's is with a short stick zone; in one
/// of four as much more. As given if there is none.
static double next_to_slip(Random& random, const Sample& x) {
  const double share = random.log_uniform(1e-7, 0.3), sign = random.one_of(4) ? 1 : -1;
  const GridSolution all = next_to_full_slip(x.scene, x.formulation, 40);
  const double near = all.value(creep) * (1 + sign * share);
  const bool pulls = all.newton_steps > 0 && beyond_no_slip(x.scene, {creep, near}).value > 0;
  return pulls ? near : x.given.value;
}

/// Of sixteen scenes one has a law of friction, one two bodies of different diffusivities, and one
/// bodies of different bulk temperatures, and half of the first and last have more than one of
/// these. Their scale is about that of the hottest point.
static void extend(Random& random, std::uint64_t number, Sample& x) {
  Scene& scene = x.scene;
  const double warm = scene.friction / std::sqrt(1 + scene.peclet);
  const std::uint64_t kind = number / 2 % 16, turn = number / 32;  // of even numbers, too
  const bool law = kind == 5, both = (kind == 13 && turn % 2 == 1) || (law && turn % 8 == 4);
  const bool unlike = kind == 9 || both || (law && turn % 8 == 5);
  const bool bulk = kind == 13 || both || (law && turn % 8 == 6);
  if (law) scene.law = spread_law(random, static_cast<LawKind>(turn / 8 % 4), warm);
  if (law && x.given.quantity == traction && random.one_of(4)) x.given.branch = Branch::falling;
  if ((unlike || bulk) && scene.roller.conductivity_ratio == 0)
    scene.roller = {random.log_uniform(0.1, 10), scene.heating};
  const double apart = random.one_of(3) ? 1e5 : 10;
  if (unlike) scene.roller.peclet = scene.peclet * random.log_uniform(1 / apart, apart);
  if (!bulk) return;
  scene.bulk_difference = (random.one_of(2) ? 1 : -1) * warm * random.log_uniform(1e-3, 1);
  x.given = beyond_rest(scene, x.given);
}

Sample sample(std::uint64_t seed, std::uint64_t number) {
  Random random(seed, number);
  const bool corner = number % 4 == 3, wide = random.one_of(5);
  const double f = corner ? random.log_uniform(1e-3, 2) : random.log_uniform(0.03, 1.5);
  const double peclet =
      corner || wide ? random.log_uniform(1e-3, 1e8) : random.log_uniform(1e-2, 1e6);
  double heating = corner ? random.log_uniform(1e-6, 1e3) : random.log_uniform(1e-7, 50) / f;
  if (corner && random.one_of(8)) heating = 0;
  const Prescribed given = spread_given(random, f, spread_share(random, corner ? 1e-12 : 1e-9));
  const auto formulation = random.one_of(2) ? Formulation::printed : Formulation::corrected;
  const double tolerance = random.one_of(2) ? 1e-6 : random.log_uniform(1e-8, 1e-2);
  const Roller roller = spread_roller(random, heating);
  const auto direction = random.one_of(2) ? Direction::braking : Direction::driving;
  Sample x{{f, peclet, heating, roller, direction}, given, formulation, tolerance};
  extend(random, number, x);
  if (x.given.quantity == creep && random.one_of(2)) x.given.value = next_to_slip(random, x);
  return x;
}

Record::Record(std::uint64_t number, const Sample& x, Totals& totals)
    : number_(number), scene_(text(x)), totals_(totals) {}

void Record::require(const char* property, bool holds) const { within(property, holds ? 0 : 2, 1); }

void Record::within(const char* property, double deviation, double allowed) const {
  const double share = std::abs(deviation) / allowed;
  if (Worst& worst = totals_.worst[property]; !(share <= worst.share)) worst = {share, number_};
  if (!(share <= 1)) totals_.failures[property] = std::to_string(number_) + ": " + scene_;
}

void Record::outcome(const std::string& what) const { ++totals_.outcomes[what]; }

void Record::compared(double tolerance, double excess) const {
  Compared& all = totals_.compared[static_cast<int>(std::floor(std::log10(tolerance)))];
  ++all.scenes;
  all.worst = std::max(all.worst, excess);
  if (excess <= 1) return;
  ++all.beyond;
  std::fprintf(stderr, "%.3g times its estimate in scene %llu: %s\n", excess,
               static_cast<unsigned long long>(number_), scene_.c_str());
}

void Record::beside(const std::string& what, const std::string& why) const {
  ++totals_.beside[what + ": " + why];
}

void Totals::add(const Totals& other) {
  for (const auto& [what, count] : other.outcomes) outcomes[what] += count;
  for (const auto& [what, count] : other.beside) beside[what] += count;
  for (const auto& [property, w] : other.worst)
    if (Worst& mine = worst[property]; !(w.share <= mine.share)) mine = w;
  for (const auto& [decade, c] : other.compared) {
    Compared& mine = compared[decade];
    mine = {mine.scenes + c.scenes, mine.beyond + c.beyond, std::max(mine.worst, c.worst)};
  }
  failures.insert(other.failures.begin(), other.failures.end());
}

/// A fifth by C, a tenth as rows of a sweep, and one of fifty as a law.
static void examine_other_ways(const Record& record, std::uint64_t number, const Sample& x) {
  const GivenScene plain{
      x.scene, signed_given(x), {x.formulation, x.tolerance, Method::coupled}, {}, {}};
  if (number % 10 == 4) examine_in_c(record, plain);
  if (number % 10 == 8) examine_in_c(record, in_si(x));
  if (number % 10 == 6) examine_row(record, text(x), number, plain);
  if (number % 50 == 18) examine_law(record, in_si(x));
}

void examine(std::uint64_t number, const Sample& x, Depth depth, Totals& totals) {
  const Record record(number, x, totals);
  try {
    const CoupledSolution found = solve(x, x.given.value);
    const bool slips = found.value(stick_slip_border) == -1;
    if (slips && !found.violations.empty()) return record.outcome("no contact, in full slip");
    record.outcome(slips ? "solved, in full slip" : "solved");
    examine_results(record, x, found);
    if (slips) return;  // what follows is about both zones
    examine_without_heat(record, x, found);
    examine_least_model(record, x, found);
    if (depth >= Depth::again) {
      examine_again(record, x, found);
      examine_limit(record, x, found);
      if (number % 10 == 2) examine_in_si(record, x, found);
      examine_other_ways(record, number, x);
      if (x.scene.friction * heating_of_both(x.scene) <= 50) examine_error(record, x, found);
    }
    if (depth < Depth::profiles || !is_plain(x.scene)) return;
    const Profile y = profile(found);
    const Tractions z = tractions_of(x, found, y);
    examine_profile(record, found, y, z);
    if (depth >= Depth::energy) examine_energy(record, x, found, y, z);
  } catch (const std::exception& error) {
    const std::string what = error.what();
    record.outcome(words_of(what));
    record.require("refusals are of the documented type and one line",
                   (typeid(error) == typeid(std::runtime_error) ||
                    typeid(error) == typeid(thermoroll::NotResolved) ||
                    typeid(error) == typeid(thermoroll::BeyondLimit) ||
                    typeid(error) == typeid(std::invalid_argument)) &&
                       !what.empty() && what.find('\n') == std::string::npos);
  }
}

}  // namespace soak
