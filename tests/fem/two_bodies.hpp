// Two bodies that touch in |x| < 1 and are insulated outside, each with its own mesh; the second
// lies at y < 0. Their temperatures are tied by a Lagrange multiplier, which is the flux into the
// first body. Units of half_space.hpp, and conductivities are in units of the first body's.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "half_space.hpp"

namespace fem {

struct Body {
  Mesh mesh;
  double peclet, conductivity;
};

// The surface's shape functions at x, of the columns first..first+2 of the mesh.
struct Trace {
  int first;
  std::array<double, 3> N;
};
inline Trace trace(const Mesh& m, double x) {
  int e = 0;
  while (m.x[e + 2] < x) e += 2;
  return {e, shape((x - m.x[e + 1]) / (m.x[e + 2] - m.x[e + 1]))};
}

// The ends of the contact and where elements of either mesh meet in it, in order: between two of
// them the shape functions of both surfaces are polynomials.
inline std::vector<double> joints(const Mesh& m1, const Mesh& m2) {
  std::vector<double> x{-1, 1};
  for (const Mesh* m : {&m1, &m2})
    for (int e = 0; e < m->columns(); e += 2)
      if (std::abs(m->x[e]) < 1) x.push_back(m->x[e]);
  std::sort(x.begin(), x.end());
  return x;
}

// Calls visit(t1, t2, length) for three points of each stretch between two joints, with the traces
// of both surfaces and the length that the point stands for.
template <class Visit>
void for_each_contact_point(const Mesh& m1, const Mesh& m2, const Visit& visit) {
  const std::vector<double> x = joints(m1, m2);
  for (std::size_t k = 1; k < x.size(); ++k)
    for (int g = 0; g < 3; ++g) {
      const double a = (x[k] - x[k - 1]) / 2, here = x[k - 1] + a * (1 + gauss[g]);
      visit(trace(m1, here), trace(m2, here), weight[g] * a);
    }
}

struct Tied {
  VectorXd T1, T2;  // nodal temperatures
  double heat1;     // the integral of the flux into the first body
};

// Temperatures of both bodies with a source of heat in the contact. The flux into the first is a
// sum of the shape functions of its surface, in the contact; the second takes what the first leaves
// of the source. The integral of T1 - T2 over the contact, times each of these functions, is zero.
inline Tied tied(const Body& body1, const Body& body2, const Function& source) {
  const Mesh &m1 = body1.mesh, &m2 = body2.mesh;
  const int second = m1.nodes(), flux = second + m2.nodes(), end = flux + m1.columns();
  Equations heat(end);
  conduct(heat, m1, body1.peclet, body1.conductivity, 0);
  conduct(heat, m2, body2.peclet, body2.conductivity, second);
  for (int i = 0; i < m1.columns(); ++i) heat.held[flux + i] = std::abs(m1.x[i]) > 1;

  VectorXd integral = VectorXd::Zero(m1.columns());  // of the flux's functions
  const auto tie = [&](int node, int function, double value) {
    heat.add(node, flux + function, -value);
    heat.add(flux + function, node, value);
  };
  for_each_contact_point(m1, m2, [&](const Trace& t1, const Trace& t2, double length) {
    for (int i = 0; i < 3; ++i) {
      const int function = t1.first + i;
      integral[function] += length * t1.N[i];
      for (int n = 0; n < 3; ++n) {
        tie(m1.node(t1.first + n, 0), function, length * t1.N[i] * t1.N[n]);
        tie(second + m2.node(t2.first + n, 0), function, -length * t1.N[i] * t2.N[n]);
      }
    }
  });

  VectorXd load = VectorXd::Zero(end);
  load.segment(second, m2.nodes()) = surface_load(m2, source);
  const VectorXd found = heat.solved<Eigen::SparseLU<Sparse>>(load);
  return {found.head(second), found.segment(second, m2.nodes()),
          integral.dot(found.tail(m1.columns()))};
}

// The two surfaces against each other, at the points of the first: the difference of the
// temperatures, the sum of the outward slopes, which both count in the gap, and the difference of
// the strains, which counts in the slip.
inline std::vector<Surface> against(const std::vector<Surface>& first,
                                    const std::vector<Surface>& second) {
  std::vector<Surface> points = first;
  for (Surface& p : points) {
    p.temperature -= interpolated(second, &Surface::temperature, p.x);
    p.outward_slope += interpolated(second, &Surface::outward_slope, p.x);
    p.strain -= interpolated(second, &Surface::strain, p.x);
  }
  return points;
}

}  // namespace fem
