// A heated half-space by finite elements: plane strain, biquadratic rectangles, nothing else. It
// shares no formula with the kernels that it is to check.
//
// Units: half-width a = 1, conductivity K = 1, alpha (1 + nu) = 1, shear modulus mu = 1. So fluxes
// are per phi, temperatures per phi a / K, slopes and strains per alpha (1 + nu) phi a / K where
// heat causes them, and per p / mu where pressure p does. The surface is y = 0, and the body lies
// on either side of it; the material flows in the direction of x on both. Displacements ux and uy
// are positive along x and y, wherever the body lies.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

#include <Eigen/Sparse>

namespace fem {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Function = std::function<double(double)>;
using Sparse = Eigen::SparseMatrix<double>;

constexpr double poisson = 0.3;

// Gauss's rule with three points on (-1, 1), exact to degree five.
constexpr std::array<double, 3> gauss = {-0.7745966692414834, 0, 0.7745966692414834};
constexpr std::array<double, 3> weight = {5.0 / 9, 8.0 / 9, 5.0 / 9};

// The quadratic shape functions of a line element with nodes -1, 0, 1, and their derivatives.
inline std::array<double, 3> shape(double r) {
  return {r * (r - 1) / 2, 1 - r * r, r * (r + 1) / 2};
}
inline std::array<double, 3> slope(double r) { return {r - 0.5, -2 * r, r + 0.5}; }

// Node (i, j) is at x[i], y[j], and the surface is j = 0; from there y may grow or fall. The
// element (e, f), both even, has the nodes e..e+2 by f..f+2.
struct Mesh {
  std::vector<double> x, y;
  int columns() const { return static_cast<int>(x.size()); }
  int rows() const { return static_cast<int>(y.size()); }
  int nodes() const { return columns() * rows(); }
  int node(int i, int j) const { return i + columns() * j; }
  double inward() const { return y.back() > 0 ? 1 : -1; }  // the direction of y into the body
};

// Nodes from 0 on: elements of length step as far as even, then each by the factor growth longer
// than the one before, until reach is passed.
inline std::vector<double> graded(double step, double even, double reach, double growth) {
  std::vector<double> x{0};
  while (x.back() < reach) {
    const double start = x.back();
    if (start > even - step / 2) step *= growth;
    x.push_back(start + step / 2);
    x.push_back(start + step);
  }
  return x;
}

// A half-space that ends at the distance reach on both sides and below, with elements of length
// step in |x| < 1.2 and next to the surface.
inline Mesh mesh(double step, double reach, double growth = 7.0 / 6) {
  const std::vector<double> right = graded(step, 1.2, reach, growth);
  std::vector<double> x;
  for (auto node = right.rbegin(); *node > 0; ++node) x.push_back(-*node);
  x.insert(x.end(), right.begin(), right.end());
  return {x, graded(step, 0, reach, growth)};
}

// Each element cut into four equal ones.
inline std::vector<double> halved(const std::vector<double>& x) {
  std::vector<double> finer{x[0]};
  for (std::size_t i = 1; i < x.size(); ++i) {
    finer.push_back((x[i - 1] + x[i]) / 2);
    finer.push_back(x[i]);
  }
  return finer;
}
inline Mesh halved(const Mesh& m) { return {halved(m.x), halved(m.y)}; }

// The mesh on the other side of the surface: y changes its sign, x and so the motion do not.
inline Mesh above(Mesh m) {
  for (double& y : m.y) y = -y;
  return m;
}

// One of an element's nine Gauss points: the shape functions of the element's nodes there, their
// derivatives, and the area that the point stands for.
using Vector9 = Eigen::Matrix<double, 9, 1>;
using Matrix9 = Eigen::Matrix<double, 9, 9>;
struct Point {
  Vector9 N, dx, dy;
  double area;
};

// Calls visit(nodes, points) for each element, with its nine node numbers and nine Gauss points.
template <class Visit>
void for_each_element(const Mesh& m, const Visit& visit) {
  std::array<int, 9> nodes{};
  std::array<Point, 9> points{};
  for (int f = 0; f + 2 < m.rows(); f += 2)
    for (int e = 0; e + 2 < m.columns(); e += 2) {
      const double a = (m.x[e + 2] - m.x[e]) / 2, b = (m.y[f + 2] - m.y[f]) / 2;
      for (int n = 0; n < 9; ++n) nodes[n] = m.node(e + n % 3, f + n / 3);
      for (int g = 0; g < 9; ++g) {
        const double r = gauss[g % 3], s = gauss[g / 3];
        for (int n = 0; n < 9; ++n) {
          points[g].N[n] = shape(r)[n % 3] * shape(s)[n / 3];
          points[g].dx[n] = slope(r)[n % 3] * shape(s)[n / 3] / a;
          points[g].dy[n] = shape(r)[n % 3] * slope(s)[n / 3] / b;
        }
        points[g].area = weight[g % 3] * weight[g / 3] * a * std::abs(b);
      }
      visit(nodes, points);
    }
}

// Linear equations, of which the held unknowns are zero: their rows and columns are left out but
// for a one on the diagonal.
struct Equations {
  std::vector<bool> held;
  std::vector<Eigen::Triplet<double>> entries;

  explicit Equations(int unknowns) : held(unknowns, false) {}

  void add(int row, int column, double value) {
    if (!held[row] && !held[column]) entries.emplace_back(row, column, value);
  }

  // One solution for each column of loads, with one factorisation.
  template <class Solver>
  MatrixXd solved(MatrixXd loads) const {
    auto all = entries;
    for (int i = 0; i < loads.rows(); ++i)
      if (held[i]) {
        all.emplace_back(i, i, 1);
        loads.row(i).setZero();
      }
    Sparse matrix(loads.rows(), loads.rows());
    matrix.setFromTriplets(all.begin(), all.end());
    const Solver solver(matrix);
    if (solver.info() != Eigen::Success) throw std::runtime_error("finite elements: not solved");
    return solver.solve(loads);
  }
};

// The integral of density times each node's shape function over the surface.
inline VectorXd surface_load(const Mesh& m, const Function& density) {
  VectorXd load = VectorXd::Zero(m.nodes());
  for (int e = 0; e + 2 < m.columns(); e += 2) {
    const double a = (m.x[e + 2] - m.x[e]) / 2;
    for (int g = 0; g < 3; ++g)
      for (int n = 0; n < 3; ++n)
        load[m.node(e + n, 0)] +=
            weight[g] * a * shape(gauss[g])[n] * density(m.x[e + 1] + a * gauss[g]);
  }
  return load;
}

// Adds 2 Pe dT/dx = div grad T, times a conductivity, for the nodal temperatures of a body that are
// numbered from first on; T = 0 upstream and below, and dT/dx = 0 where the material leaves.
// Galerkin's method as it stands: the elements are short against 1/Pe where T is rough, and T is
// smooth where they are long.
inline void conduct(Equations& heat, const Mesh& m, double peclet, double conductivity, int first) {
  for (int j = 0; j < m.rows(); ++j) heat.held[first + m.node(0, j)] = true;
  for (int i = 0; i < m.columns(); ++i) heat.held[first + m.node(i, m.rows() - 1)] = true;
  for_each_element(m, [&](const auto& nodes, const auto& points) {
    Matrix9 element = Matrix9::Zero();
    for (const Point& p : points)
      element +=
          p.area * conductivity *
          (p.dx * p.dx.transpose() + p.dy * p.dy.transpose() + 2 * peclet * p.N * p.dx.transpose());
    for (int i = 0; i < 9; ++i)
      for (int j = 0; j < 9; ++j) heat.add(first + nodes[i], first + nodes[j], element(i, j));
  });
}

// Nodal temperatures of a body that takes this flux through its surface.
inline VectorXd temperature(const Mesh& m, double peclet, const Function& flux) {
  Equations heat(m.nodes());
  conduct(heat, m, peclet, 1, 0);
  return heat.solved<Eigen::SparseLU<Sparse>>(surface_load(m, flux));
}

// Displacements are numbered ux = 2 node, uy = 2 node + 1. The stress is
// lambda div(u) I + 2 mu strain - beta T I, in plane strain with lambda = 2 nu / (1 - 2 nu) and, as
// alpha (1 + nu) = 1, beta = (3 lambda + 2 mu) alpha = 2 / (1 - 2 nu).

// The load of nodal temperatures: the integral of beta T div(w) for each shape function w.
inline VectorXd thermal_load(const Mesh& m, const VectorXd& T) {
  const double beta = 2 / (1 - 2 * poisson);
  VectorXd load = VectorXd::Zero(2 * m.nodes());
  for_each_element(m, [&](const auto& nodes, const auto& points) {
    Vector9 warm;
    for (int n = 0; n < 9; ++n) warm[n] = T[nodes[n]];
    for (const Point& p : points)
      for (int n = 0; n < 9; ++n) {
        load[2 * nodes[n]] += p.area * beta * p.N.dot(warm) * p.dx[n];
        load[2 * nodes[n] + 1] += p.area * beta * p.N.dot(warm) * p.dy[n];
      }
  });
  return load;
}

// The load of a pressure, which pushes into the body.
inline VectorXd pressure_load(const Mesh& m, const Function& pressure) {
  const VectorXd pushed = surface_load(m, pressure);
  VectorXd load = VectorXd::Zero(2 * m.nodes());
  for (int i = 0; i < m.nodes(); ++i) load[2 * i + 1] = m.inward() * pushed[i];
  return load;
}

// The displacements of each load (a column), the surface being free otherwise. The far sides are
// smooth rigid walls: ux = 0 left and right, uy = 0 below.
inline MatrixXd displacements(const Mesh& m, const MatrixXd& loads) {
  const double lambda = 2 * poisson / (1 - 2 * poisson);
  Equations balance(2 * m.nodes());
  for (int j = 0; j < m.rows(); ++j)
    balance.held[2 * m.node(0, j)] = balance.held[2 * m.node(m.columns() - 1, j)] = true;
  for (int i = 0; i < m.columns(); ++i) balance.held[2 * m.node(i, m.rows() - 1) + 1] = true;
  for_each_element(m, [&](const auto& nodes, const auto& points) {
    Matrix9 xx = Matrix9::Zero(), xy = xx, yy = xx;  // products of derivatives
    for (const Point& p : points) {
      xx += p.area * p.dx * p.dx.transpose();
      xy += p.area * p.dx * p.dy.transpose();
      yy += p.area * p.dy * p.dy.transpose();
    }
    for (int i = 0; i < 9; ++i)
      for (int j = 0; j < 9; ++j) {
        const int x = 2 * nodes[i], X = 2 * nodes[j];
        balance.add(x, X, (lambda + 2) * xx(i, j) + yy(i, j));
        balance.add(x, X + 1, lambda * xy(i, j) + xy(j, i));
        balance.add(x + 1, X, lambda * xy(j, i) + xy(i, j));
        balance.add(x + 1, X + 1, (lambda + 2) * yy(i, j) + xx(i, j));
      }
  });
  return balance.solved<Eigen::SimplicialLDLT<Sparse>>(loads);
}

// The surface at x; the slope is that of the displacement out of the body, the strain dux/dx.
struct Surface {
  double x, temperature, outward_slope, strain;
};

// The surface in |x| < 1.2 at the points -+1/sqrt(3) of every element, where the derivatives of
// quadratic elements are accurate by one order more than elsewhere.
inline std::vector<Surface> surface(const Mesh& m, const VectorXd& T, const VectorXd& u) {
  std::vector<Surface> points;
  for (int e = 0; e + 2 < m.columns(); e += 2)
    for (const double r : {-std::sqrt(1.0 / 3), std::sqrt(1.0 / 3)}) {
      const double a = (m.x[e + 2] - m.x[e]) / 2;
      Surface s{m.x[e + 1] + a * r, 0, 0, 0};
      for (int n = 0; n < 3; ++n) {
        const int node = m.node(e + n, 0);
        s.temperature += shape(r)[n] * T[node];
        s.strain += slope(r)[n] / a * u[2 * node];
        s.outward_slope -= m.inward() * slope(r)[n] / a * u[2 * node + 1];
      }
      if (std::abs(s.x) < 1.2) points.push_back(s);
    }
  return points;
}

inline double no_pressure(double) { return 0; }

// The surface over each of several nodal temperatures (columns) and under one pressure, with one
// factorisation.
inline std::vector<std::vector<Surface>> surfaces(const Mesh& m, const MatrixXd& T,
                                                  const Function& pressure = no_pressure) {
  MatrixXd loads(2 * m.nodes(), T.cols());
  for (int i = 0; i < T.cols(); ++i)
    loads.col(i) = thermal_load(m, T.col(i)) + pressure_load(m, pressure);
  const MatrixXd u = displacements(m, loads);
  std::vector<std::vector<Surface>> result(loads.cols());
  for (int i = 0; i < T.cols(); ++i) result[i] = surface(m, T.col(i), u.col(i));
  return result;
}

// A value of the surface at x: the cubic through its four nearest points.
inline double interpolated(const std::vector<Surface>& points, double Surface::*value, double x) {
  const auto before = [x](const Surface& p) { return p.x < x; };
  const auto right = std::partition_point(points.begin() + 2, points.end() - 2, before);
  double sum = 0;
  for (auto p = right - 2; p != right + 2; ++p) {
    double product = *p.*value;
    for (auto q = right - 2; q != right + 2; ++q)
      if (q != p) product *= (x - q->x) / (p->x - q->x);
    sum += product;
  }
  return sum;
}

}  // namespace fem
