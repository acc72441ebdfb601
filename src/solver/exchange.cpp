// Tangled from paper/24-exchanged-heat.md; edit there.
#include "solver/exchange.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "solver/contact_grid.hpp"
#include "solver/graded_rule.hpp"
#include "solver/linear_system.hpp"
#include "solver/product.hpp"
#include "support/number_text.hpp"
#include "support/simd.hpp"

namespace thermoroll {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

namespace {

/// The data of both bodies in @eq:exchange and @eq:exchange-terms.
struct ExchangingPair {
  double peclet, peclet_2, ratio, share;    // ratio = K1 / K2, share = omega
  double slope, slope_2, strain, strain_2;  // factors of N1 and of N2
};

ExchangingPair exchanging_pair(const Scene& scene, Formulation formulation) {
  const double unit = scene.friction * scene.peclet;
  const double d1 = unit * scene.heating, d2 = unit * distortion_2(scene);
  const double outward = -slope_sign(formulation), along = sign_of(scene.direction) / pi;
  const double ratio = 1 / scene.roller.conductivity_ratio, share = heat_share(scene);
  return {scene.peclet, peclet_2(scene), ratio,      share,
          outward * d1, -outward * d2,   along * d1, along * d2};
}

/// The map of a zone: its length, the fineness of the stick zone's exponential (zero on the slip
/// zone, which has the cubic), whether it has both edges, and the slip zone's variable.
struct ZoneMap {
  double length, fine;
  bool two_edges;
  SlipVariable variable{};
  bool slips() const { return fine == 0; }
  double growth() const { return std::log1p(1 / fine); }
};

ZoneMap slip_map(const ZoneLengths& at) { return {at.slip, 0, at.stick == 0, at.variable}; }

ZoneMap stick_map(const ZoneLengths& at) {
  return {at.stick, std::min(1.0, std::sqrt(at.slip / at.stick)), false};
}

THERMOROLL_CLONES GradedArray exponentials_less_one(const GradedArray& exponent) {
  GradedArray grown(exponent.size());
  Index i = 0;
  for (Pack4 x, y; i + 4 <= grown.size(); i += 4) {
    load(&exponent[i], x);
    exp_less_one(x, y);
    store(y, &grown[i]);
  }
  for (; i < grown.size(); ++i) grown[i] = std::expm1(exponent[i]);
  return grown;
}

/// u, v = 1 - u and du/dx.
struct ZonePoints {
  GradedArray u, v, du;
};

ZonePoints clustered_points(const SlipVariable& variable, const GradedArray& left,
                            const GradedArray& right) {
  ZonePoints all{left, left, left};
  for (Index i = 0; i < left.size(); ++i) {
    const SlipPoint at(left[i], right[i], variable);
    all.u[i] = at.u;
    all.v[i] = at.v;
    all.du[i] = at.du;
  }
  return all;
}

ZonePoints zone_points(const ZoneMap& zone, const GradedArray& left, const GradedArray& right) {
  if (zone.variable.clustered()) return clustered_points(zone.variable, left, right);
  if (zone.slips()) {
    ZonePoints at{{}, {}, (3 + 12 * left * right) / 22};
    slip_cubic(left, at.u);
    slip_cubic(right, at.v);
    return at;
  }
  const double half = zone.growth() / 2;
  const GradedArray u = zone.fine * exponentials_less_one(half * left);
  return {u, -(1 + zone.fine) * exponentials_less_one(-half * right), half * (u + zone.fine)};
}

/// dt / sqrt(1 - t), or with both edges dt / sqrt(t (1 - t)), over du.
GradedArray edge_measure(const ZoneMap& zone, const ZonePoints& at) {
  if (zone.two_edges) return 6 / ((1 + 2 * at.u) * (1 + 2 * at.v)).sqrt();
  return 6 * at.u / (1 + 2 * at.u).sqrt();
}

/// The distances 1 + x and 1 - x of a target inside, or 0 and 2 (2 and 0) where it lies before the
/// border (beyond the edge) at a gap.
struct Target {
  double left, right, gap;
};

/// Whether the rule that goes upstream from a target serves the mirrored target as well.
bool mirrors(const ZoneMap& zone, const Target& from) {
  return zone.slips() && !zone.variable.clustered() && from.left > 0 && from.right > 0;
}

/// Positions x, distances from the target, weights of a(x) and of h; whether it goes upstream; and
/// the weights of a(-x) if the mirror image is used.
struct ZoneRule {
  GradedArray x, apart, exchanged, heat;
  bool upstream;
  GradedArray mirrored{};
};

/// The steps in psi for steps in x from a point.
GradedArray across_clusters(const SlipPoint& from, GradedArray step) {
  for (std::size_t i = 2; i-- > 0;)
    if (from.clusters[i].rate > 0)
      for (double& one : step) step_across(from.clusters[i], from.before[i], one);
  return step;
}

/// The rule from a target towards the edge (side = 1) or the border (-1).
ZoneRule zone_rule(const ZoneMap& zone, double peclet, const Target& from, int side,
                   const GaussLegendre& rule) {
  const GradedArray left = GradedArray::Constant(1, from.left);
  const GradedArray right = GradedArray::Constant(1, from.right);
  const ZonePoints at = zone_points(zone, left, right);
  const double u = at.u[0], v = at.v[0], du = at.du[0], speed = peclet * zone.length;
  const double at_end = std::sqrt((1 / speed + from.gap / zone.length) / 3) / du;
  const double delta = 6 * std::min(at_end, 1 / (speed * 6 * u * v * du));
  const double k = std::log1p((side > 0 ? from.right : from.left) / delta);
  const GradedArray step = delta * exponentials_less_one(k * rule.cube);
  const GradedArray dx = k * rule.dcube * (step + delta);
  const double middle = (from.left - from.right) / 2;
  ZoneRule graded{middle + side * step, {}, {}, {}, (side > 0) == zone.slips()};
  const ZonePoints to = zone_points(zone, from.left + side * step, from.right - side * step);
  const SlipPoint own(from.left, from.right, zone.variable);
  const GradedArray ahead = across_clusters(own, side * step), psi = own.psi + ahead;
  GradedArray far = side * ahead * (15 - 4 * (own.psi * (own.psi + psi) + psi.square())) / 22;
  if (!zone.slips())
    far = side * (u + zone.fine) * exponentials_less_one(side * zone.growth() / 2 * step);
  const auto near_border = to.u + u < 1;
  const GradedArray sum = near_border.select(to.u + u, to.v + v);
  const GradedArray product = near_border.select(to.u * u, to.v * v);
  graded.apart = from.gap + zone.length * far * (3 * sum - 2 * (sum.square() - product));
  const GradedArray omega = ((1 + 2 * to.u) * (1 + 2 * to.v)).sqrt();
  const GradedArray along = zone.length * to.du * dx;
  const double heated = zone.slips() ? 6 * zone.length : 0;
  graded.exchanged = edge_measure(zone, to) * along;
  if (mirrors(zone, from) && zone.two_edges) graded.mirrored = graded.exchanged;
  if (mirrors(zone, from) && !zone.two_edges)
    graded.mirrored = edge_measure(zone, {to.v, to.u, to.du}) * along;
  graded.heat = heated * along * (to.u * to.v).square() * omega;
  return graded;
}

/// A row for each target. The first four have a column for each coefficient of E, slip zone first:
/// pi times the left side of @eq:exchange and T*, slope and strain; the last one, for each term of
/// h, is pi times the right side.
struct ExchangeRows {
  ExchangeRows(Index targets, Index coefficients, Index terms)
      : jump(MatrixXd::Zero(targets, coefficients)),
        temperature(jump),
        slope(jump),
        strain(jump),
        heat(MatrixXd::Zero(targets, terms)) {}
  MatrixXd jump, temperature, slope, strain, heat;
};

KernelWeights exchange_weights(const ExchangingPair& pair, const ZoneRule& graded, bool heats) {
  const GradedKernels first = at_distances(pair.peclet, pair.peclet * graded.apart);
  const bool alike = pair.peclet == pair.peclet_2, mirrored = graded.mirrored.size() > 0;
  const GradedKernels second =
      alike ? first : at_distances(pair.peclet_2, pair.peclet_2 * graded.apart);
  GradedArray ahead_1 = GradedArray::Ones(graded.apart.size()), ahead_2 = ahead_1;
  if (graded.upstream) {
    ahead_1 = exponentials(-2 * pair.peclet * graded.apart);
    ahead_2 = exponentials(-2 * pair.peclet_2 * graded.apart);
  }
  KernelWeights weights(graded.x.size(), mirrored ? (heats ? 9 : 7) : 5);
  for (Index i = 0; i < graded.x.size(); ++i) {
    const Kernels &k1 = first[i], &k2 = second[i];
    const double flux = graded.exchanged[i], heat = graded.heat[i] * pair.share;
    const double m1 = k1.m_down * ahead_1[i], m2 = k2.m_down * ahead_2[i];
    const double slope = graded.upstream ? pair.slope * k1.n1 + pair.slope_2 * k2.n1 : 0;
    const double up = pair.strain * k1.n2_up + pair.strain_2 * k2.n2_up;
    const double down = pair.strain * k1.n2_down + pair.strain_2 * k2.n2_down;
    weights.row(i).head<4>() << flux * (m1 + pair.ratio * m2), flux * m1, flux * slope,
        flux * (graded.upstream ? up : down);
    if (heats) weights.row(i).tail<1>() << heat * (m2 - m1);
    if (!mirrored) continue;
    const double image = graded.mirrored[i];
    weights.row(i).segment<3>(4) << image * (k1.m_down + pair.ratio * k2.m_down), image * k1.m_down,
        image * down;
    if (heats) weights(i, 7) = heat * (k2.m_down - k1.m_down);
  }
  return weights;
}

/// The columns of E begin at this one. In a mirror image there is no slope, and odd polynomials
/// have the other sign.
void add_sums(const Sums& sums, bool image, Index row, Index column, ExchangeRows& rows) {
  const Index n = sums.cols(), terms = rows.heat.cols();
  const auto add = [&](Index sum, MatrixXd& to, Index from, Index size) {
    for (Index l = 0; l < size; ++l)
      to(row, from + l) += image && l % 2 == 1 ? -sums(sum, l) : sums(sum, l);
  };
  add(image ? 4 : 0, rows.jump, column, n);
  add(image ? 5 : 1, rows.temperature, column, n);
  if (!image) add(2, rows.slope, column, n);
  add(image ? 6 : 3, rows.strain, column, n);
  if (column == 0) add(image ? 7 : sums.rows() - 1, rows.heat, 0, terms);
}

/// Add the rules of a zone, whose coefficients begin at this column, to the row of a target.
void add_zone(const ExchangingPair& pair, const ZoneMap& zone, const Target& target, Index row,
              Index column, const GaussLegendre& rule, Sums& sums, ExchangeRows& rows) {
  const double fastest = std::max(pair.peclet, pair.peclet_2);
  const bool mirrored = mirrors(zone, target), heats = !mirrored || rows.heat.cols() > 0;
  for (const int side : {1, -1}) {
    if ((side > 0 ? target.right : target.left) == 0 || (mirrored && side < 0)) continue;
    const ZoneRule graded = zone_rule(zone, fastest, target, side, rule);
    legendre_sums(graded.x, exchange_weights(pair, graded, heats), sums);
    add_sums(sums, false, row, column, rows);
    if (mirrored) add_sums(sums, true, sums.cols() - 1 - row, column, rows);
  }
}

ExchangeRows exchange_rows(const ExchangingPair& pair, const Nodes& z, const GaussLegendre& stick,
                           Index terms, const GaussLegendre& rule) {
  const Index n = z.y.size(), m = z.d.size();
  const ZoneMap slips = slip_map(z.zones), sticks = stick_map(z.zones);
  ExchangeRows rows(n + m, n + m, terms);
  Sums of_slip(node_weights, n), of_stick(node_weights, m);
  for (Index i = 0; i < n; ++i) {
    add_zone(pair, slips, {1 + z.y(i), 1 - z.y(i), 0}, i, 0, rule, of_slip, rows);
    if (m == 0) continue;
    add_zone(pair, sticks, {0, 2, z.zones.slip * z.t(i)}, i, n, rule, of_stick, rows);
  }
  for (Index j = 0; j < m; ++j) {
    const double x = stick.x(j);
    add_zone(pair, slips, {0, 2, z.d(j)}, n + j, 0, rule, of_slip, rows);
    add_zone(pair, sticks, {1 + x, 1 - x, 0}, n + j, n, rule, of_stick, rows);
  }
  return rows;
}

MatrixXd slopes_at_nodes(const Nodes& z, const GaussLegendre& rule, const MatrixXd& values) {
  VectorXd dy_ds(z.y.size());
  for (Index i = 0; i < dy_ds.size(); ++i) {
    const SlipPoint at(1 + z.y(i), 1 - z.y(i), z.zones.variable);
    dy_ds(i) = 1 / (z.zones.slip * 6 * at.u * at.v * at.du);
  }
  const MatrixXd series = product(1, to_legendre(rule), values);
  return dy_ds.asDiagonal() * product(1, by_derivatives(rule.p), series);
}

RowVectorXd flux_integral(const ZoneMap& zone, const GaussLegendre& rule) {
  const ZonePoints at = zone_points(zone, 1 + rule.x, 1 - rule.x);
  const VectorXd weights = zone.length * edge_measure(zone, at) * at.du * rule.w;
  return weights.transpose() * rule.p;
}

RowVectorXd flux_integrals(const Nodes& z, const GridRules& rules) {
  const Index n = z.y.size(), m = z.d.size();
  RowVectorXd both(n + m);
  both.head(n) = flux_integral(slip_map(z.zones), rules.slip);
  if (m > 0) both.tail(m) = flux_integral(stick_map(z.zones), rules.stick);
  return both;
}

BulkExchange solve_bulk(const Scene& scene, int n) {
  Scene driven = scene;
  driven.direction = Direction::driving;
  const GridRules rules(n, {2, 0});
  const Nodes z = place_nodes({2, 0}, rules.slip, rules.stick);
  const Exchange x = exchange(driven, Formulation::corrected, z, rules, 0);
  const VectorXd f = x.thermal.f.col(0), strain = x.thermal.g.col(0) - scene.friction * f;
  const MatrixXd to = to_legendre(rules.slip);
  BulkExchange bulk{x.series.col(0), to * f, to * strain, to * x.temperature.col(0), {}};
  const ExchangingPair pair = exchanging_pair(driven, Formulation::corrected);
  const double j = pair.slope + pair.slope_2;
  bulk.root_1 = -2 * j * x.edge(0);
  bulk.root_2 = 2 * j * std::sqrt(2) * x.series.col(0).sum();
  const ArrayXd roots = bulk.root_1 * (1 + z.s).sqrt() + bulk.root_2 * (1 - z.s).sqrt();
  const VectorXd rest = f - roots.matrix();
  const ThermalTerms smooth{rest, slopes_at_nodes(z, rules.slip, rest), 0 * rest};
  const TractionOperators by = traction_operators(z, smooth, scene.friction);
  bulk.pressure = to * (by.p.col(0).array() - 2 * by.kappa(0) / pi).matrix();
  bulk.kappa = z.over_root.cwiseProduct(z.s.matrix()).dot(f);
  bulk.gamma0 = z.over_root.dot(f) / pi;
  bulk.heat = x.heat(0);
  bulk.edge = x.edge(0);
  bulk.rest.creep = z.over_root.dot(strain) / pi;
  bulk.rest.traction = z.over_root.cwiseProduct(z.s.matrix()).dot(strain);
  const double least = 0.4 * std::pow(n, -5);
  const double part = tail(bulk.flux) + tail(bulk.strain) / 200 + least;
  bulk.rest.traction_error = part * std::abs(bulk.rest.traction);
  bulk.rest.creep_error = part * std::abs(bulk.rest.creep);
  bulk.temperature_error = tail(bulk.temperature) / 4 + least;
  return bulk;
}

/// With so many unknowns.
std::shared_ptr<const BulkExchange> bulk_on(const Scene& scene, int n) {
  static thread_local Scene last{};
  static thread_local std::map<int, std::shared_ptr<const BulkExchange>> found;
  if (scene.friction != last.friction || !same_bodies(scene, last)) found.clear();
  (last = scene).law = nullptr;
  auto& kept = found[n];
  if (!kept) kept = std::make_shared<const BulkExchange>(solve_bulk(scene, n));
  return kept;
}

/// At the distances 1 + s and 1 - s from its edges.
double on_whole_contact(double left, double right) {
  const double near = distance_of_share(std::min({left, right, 1.0}) / 2);
  return left < right ? near - 1 : 1 - near;
}

struct EdgeDistances {
  ArrayXd left, right;
};

EdgeDistances edge_distances(const Nodes& z) {
  const Index n = z.y.size(), m = z.d.size();
  EdgeDistances at{ArrayXd(n + m), ArrayXd(n + m)};
  at.left << z.zones.stick + z.zones.slip * z.t, z.zones.stick - z.d;
  at.right.tail(m) = z.zones.slip + z.d;
  for (Index i = 0; i < n; ++i)  // 1 - t with its digits
    at.right(i) = z.zones.slip * SlipPoint(1 - z.y(i), 1 + z.y(i), mirrored(z.zones.variable)).t();
  return at;
}

/// L of @eq:edge-pressure, with 2 - x^2.
ArrayXd edge_pressure(const ArrayXd& x, const ArrayXd& rest) {
  return ((std::sqrt(2) + x).square() / rest).log() / x;
}

/// The target at this distance from the border, negative before it.
Target seen_from(const ZoneMap& zone, double from_border) {
  const double t = from_border / zone.length;
  if (t <= 0) return {0, 2, -from_border};
  if (t >= 1) return {2, 0, from_border - zone.length};
  const SlipVariable& by = zone.variable;
  const double share = std::min(t, 1 - t);
  const double near = distance_of_share(share, t < 0.5 ? by : mirrored(by));
  if (zone.slips()) return t < 0.5 ? Target{near, 2 - near, 0} : Target{2 - near, near, 0};
  double u = 0;
  slip_cubic(near, u);
  const double scale = 2 / zone.growth();
  const double left = scale * std::log1p(u / zone.fine);
  const double right = -scale * std::log1p(-u / (1 + zone.fine));
  return t < 0.5 ? Target{left, 2 - left, 0} : Target{2 - right, right, 0};
}

double flux_on(const ZoneMap& zone, double from_border, double from_edge, const VectorXd& series) {
  const Target at = seen_from(zone, from_border);
  const double rest = from_edge / zone.length;
  const double root = zone.two_edges ? from_border / zone.length * rest : rest;
  const ArrayXd x = ArrayXd::Constant(1, (at.left - at.right) / 2);
  return legendre(x, series.size()).row(0).dot(series) / std::sqrt(root);
}

double temperature_by(const ZoneMap& zone, double peclet, const Target& target,
                      const VectorXd& series_of_zone, const GaussLegendre& rule) {
  double sum = 0;
  for (const int side : {1, -1}) {
    if ((side > 0 ? target.right : target.left) == 0) continue;
    const ZoneRule graded = zone_rule(zone, peclet, target, side, rule);
    const GradedArray flux = graded.exchanged * series(1, graded.x, series_of_zone);
    const GradedKernels kernels = at_distances(peclet, peclet * graded.apart);
    for (Index i = 0; i < flux.size(); ++i) {
      const double before = graded.upstream ? std::exp(-2 * peclet * graded.apart[i]) : 1;
      sum += kernels[i].m_down * before * flux[i];
    }
  }
  return sum / pi;
}

}  // namespace

Exchange exchange(const Scene& scene, Formulation formulation, const Nodes& z,
                  const GridRules& rules, Index terms) {
  const ExchangingPair pair = exchanging_pair(scene, formulation);
  const Index n = z.y.size(), m = z.d.size();
  const double fastest = std::max(pair.peclet, pair.peclet_2) * std::max(z.zones.slip, 1.0);
  const double more = 8 + 5 * decades_beyond(fastest) + more_graded(z.zones.variable);
  const double nodes = std::min(static_cast<double>(std::max(n, m)) + more, most_unknowns + 24.0);
  const ExchangeRows rows =
      exchange_rows(pair, z, rules.stick, terms, rounded_up(4, static_cast<int>(nodes)));
  MatrixXd right(n + m, terms + 1);
  right << rows.heat, VectorXd::Constant(n + m, pi);
  Exchange x;
  x.series = solve(rows.jump, right);
  x.temperature = product(1 / pi, rows.temperature, x.series);
  x.thermal.f = product(1, rows.slope, x.series);
  x.thermal.g = scene.friction * x.thermal.f + product(1, rows.strain, x.series);
  x.thermal.df = slopes_at_nodes(z, rules.slip, x.thermal.f.topRows(n));
  x.heat = flux_integrals(z, rules) * x.series;
  const Index last = m > 0 ? m : n;
  const MatrixXd at_edge = legendre(ArrayXd::Constant(1, m > 0 ? 1 : -1), last);
  x.edge = std::sqrt(m > 0 ? z.zones.stick : 2) * at_edge * x.series.bottomRows(last);
  return x;
}

void add_exchange(const Exchange& x, ThermalTerms& to) {
  const Index terms = to.f.cols();
  to.f += x.thermal.f.leftCols(terms);
  to.df += x.thermal.df.leftCols(terms);
  to.g += x.thermal.g.leftCols(terms);
}

int edge_unknowns(const Scene& scene) {
  const double speed = std::max(scene.peclet, peclet_2(scene));
  return static_cast<int>(std::clamp(std::ceil(2 * std::pow(speed, 0.25)), 30.0, 120.0));
}

std::shared_ptr<const BulkExchange> bulk_exchange(const Scene& scene, Index unknowns) {
  if (scene.bulk_difference == 0) return nullptr;
  const int n = std::max(static_cast<int>(unknowns), edge_unknowns(scene) + 20);
  return bulk_on(scene, std::min(n, most_unknowns));
}

BulkTerms bulk_terms(const BulkExchange& x, const Scene& scene, Formulation formulation,
                     const Nodes& z) {
  const EdgeDistances at = edge_distances(z);
  const ArrayXd y = at.left.binaryExpr(at.right, &on_whole_contact);
  const ArrayXd to_1 = at.left.sqrt(), to_2 = at.right.sqrt();
  const MatrixXd p = scene.bulk_difference * legendre(y, x.slope.size());
  const double outward = slope_sign(formulation) / slope_sign(Formulation::corrected);
  const double unit = outward * scene.bulk_difference;
  BulkTerms to{outward * (p * x.slope), {}, outward * (p * x.pressure), p * x.temperature};
  to.g = scene.friction * to.f + sign_of(scene.direction) * (p * x.strain);
  to.pressure.array() -= unit / pi * (x.root_1 * edge_pressure(to_2, at.left));
  to.pressure.array() += unit / pi * (x.root_2 * edge_pressure(to_1, at.right));
  to.kappa = unit * x.kappa;
  to.gamma0 = unit * x.gamma0;
  return to;
}

NoSlip no_slip(const Scene& scene, double tolerance) {
  NoSlip now;
  if (scene.bulk_difference == 0) return now;
  check(scene);
  const double size = std::abs(scene.bulk_difference);
  for (const int more : {20, 60, 140}) {
    const NoSlip& rest = bulk_on(scene, edge_unknowns(scene) + more)->rest;
    now = {scene.bulk_difference * rest.traction, scene.bulk_difference * rest.creep,
           size * rest.traction_error, size * rest.creep_error};
    if (std::max(now.traction_error, now.creep_error) <= tolerance * std::abs(now.creep)) break;
  }
  return now;
}

std::string without_friction(const Scene& scene) {
  const double met = scene.bulk_difference * (1 - effusivity_share(scene));
  if (!scene.law || scene.law(met).value > 0) return "";
  return "; friction is zero at T* = " + shortest(met) + ", at which the bodies meet";
}

NoSlip no_slip_near(const Scene& scene, const Prescribed& given) {
  if (given.quantity == Quantity::stick_slip_border) return {};
  const NoSlip rest = no_slip(scene, 1e-2);
  const double least = given.quantity == Quantity::traction ? rest.traction : rest.creep;
  return std::abs(given.value - least) < 0.1 * std::abs(least) ? no_slip(scene) : rest;
}

Prescribed beyond_no_slip(const Scene& scene, Prescribed given) {
  const double sign = sign_of(scene.direction), f = scene.friction;
  const NoSlip rest = no_slip_near(scene, {given.quantity, sign * given.value});
  if (given.quantity == Quantity::creep) given.value -= sign * rest.creep;
  if (given.quantity == Quantity::traction && rest.traction != 0)
    given.value = f * (given.value - sign * rest.traction) / (f - sign * rest.traction);
  return given;
}

bool exchanges(const Scene& scene, const ZoneLengths& at) {
  return is_unlike(scene) && 2 * std::min(scene.peclet, peclet_2(scene)) * at.stick < 30;
}

ExchangedFlux exchanged_flux(const Exchange& x, const Nodes& z, const VectorXd& h) {
  const VectorXd series = x.series.leftCols(h.size()) * h;
  return {z.zones, series.head(z.y.size()), series.tail(z.d.size())};
}

ArrayXd flux_at(const ExchangedFlux& x, const ArrayXd& s) {
  const double c0 = x.at.c0();
  ArrayXd flux = ArrayXd::Zero(s.size());
  for (Index i = 0; i < s.size(); ++i) {
    if (!(-1 < s(i) && s(i) < 1)) continue;
    const bool slips = s(i) > c0;
    flux(i) = slips ? flux_on(slip_map(x.at), s(i) - c0, 1 - s(i), x.slip)
                    : flux_on(stick_map(x.at), c0 - s(i), 1 + s(i), x.stick);
  }
  return flux;
}

std::vector<HeatFlux> heat_fluxes(const ExchangedFlux& x) {
  const double c0 = x.at.c0();
  std::vector<HeatFlux> zones{{c0, 1, [x](double left, double right) {
                                 return flux_on(slip_map(x.at), left, right, x.slip);
                               }}};
  if (x.stick.size() > 0)
    zones.push_back({-1, c0, [x](double left, double right) {
                       return flux_on(stick_map(x.at), right, left, x.stick);
                     }});
  return zones;
}

ArrayXd temperature_of(const ExchangedFlux& x, double peclet, const ArrayXd& s,
                       const GaussLegendre& rule) {
  const double c0 = x.at.c0();
  ArrayXd temperature(s.size());
  for (Index i = 0; i < s.size(); ++i) {
    const ZoneMap slips = slip_map(x.at), sticks = stick_map(x.at);
    temperature(i) = temperature_by(slips, peclet, seen_from(slips, s(i) - c0), x.slip, rule);
    if (x.stick.size() > 0)
      temperature(i) += temperature_by(sticks, peclet, seen_from(sticks, c0 - s(i)), x.stick, rule);
  }
  return temperature;
}

ArrayXd temperature_of(const ExchangedFlux& x, double peclet, const ArrayXd& s) {
  const auto terms = static_cast<int>(std::max(x.slip.size(), x.stick.size()));
  const int nodes = terms + 16 + more_graded(x.at.variable);
  return temperature_of(x, peclet, s, rounded_up(8, std::clamp(nodes, 96, most_unknowns + 24)));
}

}  // namespace thermoroll
