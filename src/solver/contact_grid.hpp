// Tangled from paper/10-coupled-solver.md; edit there.
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "thermoroll/admissibility.hpp"
#include "thermoroll/kernels.hpp"
#include "thermoroll/scene.hpp"

/// The integral operators of the coupled problem on a grid, for the solvers.
namespace thermoroll {

constexpr int most_unknowns = 480;

/// Gauss-Legendre nodes x and weights w on (-1, 1), and the values p of P_0 ... P_{n-1} at them;
/// for rays, rho = (1 + x) / 2 and its cube.
struct Rule {
  Eigen::ArrayXd x, w, rho, cube;
  Eigen::MatrixXd p;
};

/// The rule of n nodes; made once per thread.
const Rule& gauss_legendre(int n);

/// P_0 ... P_{n-1} at x, a column each.
Eigen::MatrixXd legendre(const Eigen::ArrayXd& x, Eigen::Index n);

/// From values at the nodes to Legendre coefficients.
Eigen::MatrixXd to_legendre(const Rule& rule);

/// The lengths of both zones, 1 - c0 and 1 + c0, which add up to 2.
struct Border {
  double slip, stick;
  double c0() const { return (stick - slip) / 2; }
};

/// The rule of n nodes or a few more, to be taken so many at a time.
inline const Rule& taken_by(int group, int n) {
  return gauss_legendre((n + group - 1) / group * group);
}

/// By how many decades the speed lambda of a slip zone exceeds 1e4.
inline double decades_beyond(double lambda) { return std::max(0.0, std::log10(lambda) - 4); }

/// By how many decades the slip zone is shorter than a hundredth of the stick zone; at most 20, as
/// the quotient of a length next to zero is infinite.
inline double decades_shorter(const Border& at) {
  return std::clamp(std::log10(at.stick / at.slip) - 2, 0.0, 20.0);
}

/// Nodes of the stick zone on a grid of n unknowns: two more for every such decade. The fine grids
/// are those of strong heating, which needs G as fine as h.
inline int stick_nodes(int n, const Border& at) {
  return n > 64 ? n : std::max(8, 3 * n / 4) + static_cast<int>(2 * decades_shorter(at));
}

/// Nodes of a ray for temperatures: the more the faster the slip zone, lambda, is.
inline int temperature_nodes(int n, double lambda) {
  return std::min(most_unknowns, n + static_cast<int>(5 * decades_beyond(lambda))) + 24;
}

/// The rules of a grid of n unknowns: nodes of both zones, of rays, which strong heating needs as
/// fine as h, and of rays for temperatures.
struct Rules {
  explicit Rules(int n, const Border& at = {1, 1}, double peclet = 1)
      : slip(gauss_legendre(n)),
        stick(gauss_legendre(stick_nodes(n, at))),
        ray(taken_by(4, n > 64 ? n : 16 + (n + 2) / 3)),
        fine(taken_by(8, temperature_nodes(n, at.slip * peclet))) {}
  const Rule &slip, &stick, &ray, &fine;
};

/// u at the distance eta from y = -1, or v at that distance from y = 1; in [0, 1].
template <class Distance>
auto rise(const Distance& eta) {
  return eta * (3 + (12 - 4 * eta) * eta) / 22;
}

/// A point of the slip zone at the distances 1 + y and 1 - y from its ends, @eq:angles.
struct Place {
  Place(double left, double right)
      : y((left - right) / 2), u(rise(left)), v(rise(right)), du((3 + 12 * left * right) / 22) {}
  double y, u, v, du;  // du: the derivative of u by y
  double t() const { return u * u * (1 + 2 * v); }
  double omega() const { return std::sqrt((1 + 2 * u) * (1 + 2 * v)); }
};

/// t(b) - t(a) for b.y - a.y = step, without subtracting what is nearly equal.
inline double apart(const Place& a, const Place& b, double step) {
  const double du = step * (15 - 4 * (a.y * a.y + a.y * b.y + b.y * b.y)) / 22;
  const bool left = a.u + b.u < 1;
  const double x = left ? a.u : a.v, z = left ? b.u : b.v;
  return du * (3 * (x + z) - 2 * (x * x + x * z + z * z));
}

/// The distance 1 + y at which t is the given share, in [0, 1/2].
double distance_of_share(double t);

/// The nodes of both zones.
struct Zones {
  Border border;
  Eigen::ArrayXd y, t, s;     // slip zone
  Eigen::ArrayXd d, r;        // stick zone: distances from the border and positions
  Eigen::ArrayXd over_w;      // weights of dr / w at the stick nodes
  Eigen::VectorXd over_root;  // weights of dt / sqrt(1 - t^2) at all nodes, the slip nodes first
  Eigen::VectorXd heat;       // weights of g dt, on h at the slip nodes, per slip^2
};

/// The ten Legendre coefficients of Carter's h.
Eigen::VectorXd carter_h(const Border& at, double friction);

/// The nodes of both zones for a border.
Zones zones(const Border& border, const Rule& slip, const Rule& stick);

/// F, dF/ds and G of @eq:thermal-sides at the slip nodes, then (but for dF/ds) the stick nodes, as
/// matrices on the Legendre coefficients of h.
struct ThermalSides {
  Eigen::MatrixXd f, df, g;
};

/// These matrices on a grid, for an h of so many terms, by rays of a multiple of four nodes.
ThermalSides thermal_sides(const Scene& scene, Formulation formulation, const Zones& z,
                           Eigen::Index terms, const Rule& rule);

/// At the slip nodes p-hat = 2/pi + p h and v-hat = 2f/pi + v h; kappa = 1 + kappa h and
/// gamma0 = gamma0 h.
struct Inverses {
  Eigen::MatrixXd p, v;
  Eigen::RowVectorXd kappa, gamma0;
};

/// These matrices on a grid.
Inverses invert(const Zones& z, const ThermalSides& sides, double friction);

/// What @eq:pressure-conditions and @eq:stick-conditions give for h: kappa, gamma0, C and Q*.
struct Loads {
  double kappa, gamma0, constant, traction;
};
Loads loads(const Zones& z, const ThermalSides& sides, const Inverses& x, double friction,
            const Eigen::VectorXd& h);

/// What the tractions are made of, on both zones (@sec:admissibility), for an h.
Factors factors(const Rules& rules, const Zones& z, const ThermalSides& sides, const Inverses& x,
                double friction, const Eigen::VectorXd& h);

/// T* and dT*/ds.
struct Warmth {
  double value, slope;
};

/// T* and dT*/ds at the distances 1 + y = left and 1 - y = right from the ends of the slip zone,
/// or, with left = 0, across a gap (in lengths of the slip zone); a rule of a multiple of eight
/// nodes.
Warmth warmth(double slip, double peclet, const Eigen::VectorXd& h, double left, double right,
              double gap, const Rule& rule);

/// T* on the surface at every s of a list, for a flux with Legendre coefficients h; a rule of a
/// multiple of eight nodes.
Eigen::ArrayXd surface_temperature(const Border& border, double peclet, const Eigen::VectorXd& h,
                                   const Eigen::ArrayXd& s, const Rule& rule);

/// The hottest point of the slip zone and T* there.
struct Summit {
  double y = 0.43, value = 0, bend = -3;  // bend: the second derivative of ln T by y
};

/// Find it from near by, to about 1e-8 in y; a rule of a multiple of eight nodes.
Summit climb(double slip, double peclet, const Eigen::VectorXd& h, const Summit& near,
             const Rule& rule);

}  // namespace thermoroll
