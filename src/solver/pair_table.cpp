// Tangled from paper/23-unlike-bodies.md, paper/E-fast-kernels.md; edit there.
#include "solver/pair_table.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <cstdint>

#include "solver/gauss_legendre.hpp"
#include "solver/linear_system.hpp"
#include "support/simd.hpp"

namespace thermoroll {

namespace {

using complex = std::complex<double>;

constexpr int cell_nodes = 12;  // of the polynomials of a cell

Eigen::ArrayXd cell_places() {
  return (pi * (Eigen::ArrayXd::LinSpaced(cell_nodes, 0, cell_nodes - 1) + 0.5) / cell_nodes).cos();
}

Eigen::MatrixXd powers(const Eigen::ArrayXd& x) {
  Eigen::MatrixXd all(x.size(), x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) all.col(i) = x.pow(static_cast<double>(i));
  return all;
}

complex upper_root(double x) {
  return x > 0 ? complex(std::sqrt(x), 0) : complex(0, -std::sqrt(-x));
}

/// delta of @eq:partition from its roots A and B.
template <class Number>
Number crossing(const Scene& scene, const Number& a, const Number& b) {
  const double k = scene.roller.conductivity_ratio;
  return 2 * k * (scene.peclet - peclet_2(scene)) / ((a + b) * (a + k * b));
}

/// For the exponential exp(-u z): of the slope, the strain and the temperature.
struct Density {
  double slope, strain, temperature;
};

Density upstream(const Scene& scene, double u) {
  const complex a = upper_root(2 * scene.peclet - u), b = upper_root(2 * peclet_2(scene) - u);
  const complex delta = crossing(scene, a, b), i(0, 1);
  const complex a1 = std::sqrt(u) / a, a2 = std::sqrt(u) / b;
  const double h1 = scene.heating, h2 = scene.roller.heating;
  return {imag(delta * (h1 * (1.0 + i * a1) - h2 * (1.0 + i * a2))) / pi,
          imag(delta * (h1 * a1 + h2 * a2)) - real(delta) * (h1 + h2),
          imag(delta / (std::sqrt(u) * a))};
}

Density downstream(const Scene& scene, double u) {
  const double a = std::sqrt(2 * scene.peclet + u), b = std::sqrt(2 * peclet_2(scene) + u);
  const double delta = crossing(scene, a, b), root = std::sqrt(u);
  const auto strain = [&](double peclet, double of) { return 2 * peclet / (of * (of + root)); };
  const double h1 = scene.heating, h2 = scene.roller.heating;
  return {0, delta * (h1 * strain(scene.peclet, a) + h2 * strain(peclet_2(scene), b)),
          delta / (root * a)};
}

/// Add panels from a point where a density is like a root or its inverse to another; the first
/// has this length.
void add_panels(Exponentials& sum, double from, double to, double first) {
  const GaussLegendre& rule = gauss_legendre(12);
  const double sign = to > from ? 1 : -1, length = std::abs(to - from);
  double start = 0, end = std::min(first, length);
  while (start < length) {
    for (Eigen::Index i = 0; i < rule.x.size(); ++i) {
      const double x = (1 + rule.x(i)) / 2, width = end - start;
      const double place = start > 0 ? start + width * x : end * x * x;
      sum.u.push_back(from + sign * place);
      sum.w.push_back(rule.w(i) / 2 * width * (start > 0 ? 1 : 2 * x));
    }
    start = end;
    end = 3 * end < 0.75 * length ? 3 * end : length;
  }
}

Exponentials ascending(const Exponentials& all) {
  std::vector<std::pair<double, double>> sorted;
  for (std::size_t i = 0; i < all.u.size(); ++i) sorted.emplace_back(all.u[i], all.w[i]);
  std::sort(sorted.begin(), sorted.end());
  Exponentials sum;
  for (const auto& [u, w] : sorted) {
    sum.u.push_back(u);
    sum.w.push_back(w);
  }
  return sum;
}

/// From the lower and the higher 2 Pe and the conductivity of the faster body over the slower's.
Exponentials upstream_exponentials(double low, double high, double ratio) {
  const double apart = high - low, middle = (low + high) / 2, square = ratio * ratio;
  const double at_low = std::max(std::min({low, apart, square * apart}) / 2, 1e-9 * low);
  const double at_high = std::max(std::min({low, apart, apart / square}) / 2, 1e-9 * low);
  Exponentials sum;
  add_panels(sum, 0, low / 2, low * 0x1p-20);
  add_panels(sum, low, low / 2, at_low);
  add_panels(sum, low, middle, at_low);
  add_panels(sum, high, middle, at_high);
  add_panels(sum, high, high * 0x1p28, at_high);
  return ascending(sum);
}

Exponentials downstream_exponentials(double low, double high) {
  Exponentials sum;
  add_panels(sum, 0, high * 0x1p28, low * 0x1p-20);
  return sum;
}

template <class Function>
Densities densities(const Exponentials& of, const Function& density) {
  Densities all(3, static_cast<Eigen::Index>(of.u.size()));
  for (std::size_t i = 0; i < of.u.size(); ++i) {
    const Density at = density(of.u[i]);
    all.col(static_cast<Eigen::Index>(i)) << at.slope, at.strain, at.temperature;
    all.col(static_cast<Eigen::Index>(i)) *= of.w[i];
  }
  return all;
}

Eigen::Vector3d sum(const Exponentials& of, const Densities& density, double z) {
  const Eigen::Map<const Eigen::ArrayXd> u(of.u.data(), density.cols());
  return density * (-z * u).exp().matrix();
}

}  // namespace

Remainders all_exponentials(const PairTable& table, double z) {
  const Eigen::Vector3d up = sum(table.up, table.up_density, z);
  const Eigen::Vector3d down = sum(table.down, table.down_density, z);
  Remainders r;
  r << up(0), up(1), down(1), down(2), up(2);
  return r;
}

/// The number of a cell and the place -1 <= x <= 1 in it.
struct Cell {
  int number;
  double x;
};

Cell cell_of(double z) {
  const auto bits = std::bit_cast<std::uint64_t>(z);  // the exponent, the half, the place in it
  const int of_half = 2 * 1022;                       // those of 1/2, whose cell is 0
  const std::uint64_t inside = bits & ((std::uint64_t{1} << 51) - 1);
  return {static_cast<int>(bits >> 51) - of_half, static_cast<double>(inside) * 0x1p-50 - 1};
}

double place_in(const Cell& cell) {
  const int half = cell.number & 1;
  return std::ldexp((half + (cell.x + 1) / 2) / 4 + 0.5, (cell.number - half) / 2);
}

/// The coefficients of a cell and the place in it; none beyond the table.
struct InCell {
  const Remainders* c;
  double x;
};

[[gnu::always_inline]] inline InCell look_up(const PairTable& table, double z) {
  const Cell cell = cell_of(z);
  const int at = cell.number - table.first, size = static_cast<int>(table.coefficients.size());
  if (size == 0 || at >= size / cell_nodes) return {nullptr, 0};
  const auto before = static_cast<std::size_t>(std::max(at, 0)) * cell_nodes;
  return {&table.coefficients[before], at < 0 ? -1 : cell.x};  // next to zero they are constant
}

THERMOROLL_CLONES void remainders(const PairTable& table, std::size_t n, const double* z,
                                  Kernels* all) {
  for (std::size_t i = 0; i < n; ++i) {
    const InCell at = look_up(table, z[i]);
    Pack4 sum = {}, next;
    for (int k = at.c ? cell_nodes : 0; k-- > 0;) {
      load(at.c[k].data(), next);
      sum = sum * at.x + next;
    }
    if (!at.c && !table.coefficients.empty()) load(all_exponentials(table, z[i]).data(), sum);
    all[i] = {sum[0], sum[1], sum[2], sum[3]};
  }
}

THERMOROLL_CLONES void temperatures_upstream(const PairTable& table, std::size_t n, const double* z,
                                             double* all) {
  for (std::size_t i = 0; i < n; ++i) {
    const InCell at = look_up(table, z[i]);
    all[i] = 0;
    for (int k = at.c ? cell_nodes : 0; k-- > 0;) all[i] = all[i] * at.x + at.c[k](4);
    if (!at.c && !table.coefficients.empty()) all[i] = all_exponentials(table, z[i])(4);
  }
}

/// The exponentials of eight octaves: exp(-u z) for each place of an octave (rows) and each of
/// `count` u from `first` on (columns), and the Taylor coefficients of the sum of those before.
struct OctaveSums {
  Eigen::Index first = 0, count = 0;
  Eigen::Array<double, 2 * cell_nodes, Eigen::Dynamic> powers{};
  Eigen::Matrix<double, 3, 9> taylor{};
};

THERMOROLL_CLONES void exponentials_of(const double* z, const double* u, OctaveSums& x) {
  for (Eigen::Index i = 0; i < x.count; ++i)
    for (int place = 0; place < 2 * cell_nodes; place += 4) {
      Pack4 at, power;
      load(z + place, at);
      at = at * -u[i];
      exp_of(at > -50 ? at : Pack4{} - 50, power);
      store(power, &x.powers(place, i));
    }
}

void next_octave(OctaveSums& x, const Exponentials& of, const Densities& density,
                 const Eigen::ArrayXd& z, int octave) {
  const auto below = [&](double u) -> Eigen::Index {
    return std::lower_bound(of.u.begin(), of.u.end(), u) - of.u.begin();
  };
  const bool anew = octave % 8 == 0;
  if (anew) x.first = below(0x1p-11 / z.maxCoeff());
  x.count = below(50 / z.minCoeff()) - x.first;
  if (!anew) return;
  const Eigen::Map<const Eigen::ArrayXd> u(of.u.data(), density.cols());
  x.powers.resize(Eigen::NoChange, x.count);
  exponentials_of(z.data(), of.u.data() + x.first, x);
  Eigen::ArrayXd power = Eigen::ArrayXd::Ones(x.first);  // (-u)^k / k!
  for (int k = 0; k < x.taylor.cols(); ++k) {
    x.taylor.col(k) = density.leftCols(x.first) * power.matrix();
    power *= -u.head(x.first) / (k + 1);
  }
}

THERMOROLL_CLONES void sum_and_square(const double* density, OctaveSums& x, double* sums) {
  constexpr int places = 2 * cell_nodes;
  for (int place = 0; place < places; place += 12) {
    Pack4 sum[9] = {}, p;
    double* power = x.powers.data() + place;
    const Eigen::Index count = x.count;
    for (Eigen::Index i = 0; i < count; ++i, power += places) {
      const double slope = density[3 * i], strain = density[3 * i + 1], heat = density[3 * i + 2];
      for (Eigen::Index k = 0; k < 3; ++k) {
        load(power + 4 * k, p);
        sum[k] += slope * p;
        sum[3 + k] += strain * p;
        sum[6 + k] += heat * p;
        store(p * p, power + 4 * k);
      }
    }
    for (Eigen::Index k = 0; k < 9; ++k) store(sum[k], sums + k / 3 * places + place + 4 * (k % 3));
  }
}

Densities sums_of(OctaveSums& x, const Densities& density, const Eigen::ArrayXd& z) {
  Eigen::Array<double, 2 * cell_nodes, 3> sums, rest;
  rest.setZero();
  for (Eigen::Index k = x.taylor.cols(); k-- > 0;)
    for (Eigen::Index j = 0; j < 3; ++j) rest.col(j) = rest.col(j) * z + x.taylor(j, k);
  sum_and_square(density.data() + 3 * x.first, x, sums.data());
  return (sums + rest).matrix().transpose();
}

void add_octave(PairTable& table, const Densities& up, const Densities& down) {
  static const Eigen::MatrixXd to_powers =
      solve(powers(cell_places()), Eigen::MatrixXd::Identity(cell_nodes, cell_nodes));
  for (const int half : {0, cell_nodes}) {
    Eigen::Matrix<double, cell_nodes, 5> values;
    const auto above = up.middleCols<cell_nodes>(half).transpose();
    const auto below = down.middleCols<cell_nodes>(half).transpose();
    values << above.leftCols<2>(), below.rightCols<2>(), above.rightCols<1>();
    const Eigen::Matrix<double, cell_nodes, 5> c = to_powers * values;
    for (int i = 0; i < cell_nodes; ++i) table.coefficients.push_back(c.row(i).transpose());
  }
}

PairTable::PairTable(const Scene& pair, bool crossing)
    : peclet(pair.peclet),
      other_peclet(peclet_2(pair)),
      slope_1(peclet * pair.heating),
      slope_2(pair.roller.conductivity_ratio * peclet * distortion_2(pair)) {
  if (!crossing) return;
  const double low = 2 * std::min(peclet, other_peclet), high = 2 * std::max(peclet, other_peclet);
  const double k = pair.roller.conductivity_ratio;
  up = upstream_exponentials(low, high, peclet < other_peclet ? k : 1 / k);
  down = downstream_exponentials(low, high);
  up_density = densities(up, [&](double u) { return upstream(pair, u); });
  down_density = densities(down, [&](double u) { return downstream(pair, u); });
  first = cell_of(0x1p-20 / high).number & ~1;
  Eigen::ArrayXd z(2 * cell_nodes);
  for (int i = 0; i < cell_nodes; ++i) {
    z(i) = place_in({first, cell_places()(i)});
    z(cell_nodes + i) = place_in({first + 1, cell_places()(i)});
  }
  OctaveSums of_up, of_down;
  for (int octave = 0; z(0) < 4; ++octave) {
    next_octave(of_up, up, up_density, z, octave);
    next_octave(of_down, down, down_density, z, octave);
    add_octave(*this, sums_of(of_up, up_density, z), sums_of(of_down, down_density, z));
    z *= 2;
  }
}

}  // namespace thermoroll
