// Tangled from paper/M-certified.md; edit there.
#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

#include "bench/certify/certify.hpp"
#include "studies/paper_scene.hpp"
#include "support/number_text.hpp"

namespace thermoroll::certify {
namespace {

/// The integrals of exp(-k (t - r)) g / w, with the weight r + b0 if moment; the first per pi.
Ball exponential_on_stick(const ColdContact& c, const Ball& k, bool moment) {
  const Ball at = k * c.l, on_stick = mean_of_exponentials(moment ? 1 : 0, k * c.b);
  const Ball inner = (2 * c.b + c.l) * weighted_mean(1, at) - c.l * weighted_mean(2, at);
  return (moment ? pi_ball() * c.b : Ball(1)) * on_stick * pi_ball() * c.unit * c.l * c.l * inner;
}

/// The integrals over r and t of N1* g / w (slope) or N2* g / w.
Ball kernel_on_stick(const ColdContact& c, double peclet, bool slope, bool moment) {
  const auto low = [&](const Ball& x, bool) {
    const Ball phi = pi_ball() * x / 2, sine = sine_of(phi);
    const Ball weight = slope ? 4 * sine * sine / pi_ball() : -2 * sine_of(2 * phi);
    const Ball k = 2 * peclet * sine * sine;
    return pi_ball() / 2 * weight * exponential_on_stick(c, k, moment);
  };
  Ball sum = integral(low, {0, 0x1p-16, 0x1p-12, 0x1p-9, 0x1p-6, 0x1p-3, 1});
  if (slope) return sum;
  const auto high = [&](const Ball& y, bool) {
    const Ball grown = (exponential(y) + exponential(-y)) / 2;
    return 2 * (1 + exponential(-2 * y)) *
           exponential_on_stick(c, 2 * peclet * grown * grown, moment);
  };
  const Ball tail = 8 * pi_ball() * pi_ball() * c.unit * c.l * exponential(Ball(-32)) / peclet;
  return sum + widened(integral(high, {0, 1, 2, 4, 8, 16}), tail);
}

Ball overlap_integrand(const ColdContact& c, const Ball& z, int n, bool far, const Ball& x,
                       bool analytic) {
  const Ball sine = sine_of(pi_ball() * x / 2), cosine = sine_of(pi_ball() * (1 - x) / 2);
  const Ball p = 2 * sine * sine, q = 2 * cosine * cosine;  // 1 - cos and 1 + cos
  const Ball half = far ? 1 - z / 2 : c.l, t = (far ? z - 1 : c.c0) + half * p;
  const Ball before = root(z + half * q, analytic);
  const Ball gap = root((far ? z - 2 * c.b : 2 * c.b - z) + half * p, analytic);
  const Ball rest = far ? half * q * gap / before : half * half * p * q / (before * gap);
  return pi_ball() * c.unit * (1 + t) * (n ? t - z : Ball(1)) * rest;
}

Ball overlap(const ColdContact& c, const Ball& z, int n, bool far) {
  if (!wide(z))
    return integral([&](const Ball& x, bool a) { return overlap_integrand(c, z, n, far, x, a); },
                    {0, 0.25, 0.75, 1});
  Ball sum = 0;
  for (double low = 0, high = 0x1p-40; low < 0.5; low = high, high = 1.5 * high) {
    const Ball tile = between(low, std::min(high, 0.5));
    const double width = std::min(high, 0.5) - low;
    sum = sum + width * overlap_integrand(c, z, n, far, tile, true);
    sum = sum + width * overlap_integrand(c, z, n, far, 1 - tile, true);
  }
  return sum;
}

/// The integral of Pe N1* W_n.
Ball slope_on_contact(const ColdContact& c, double peclet, int n) {
  const double zero = 0x1p-60, kink = upper(2 * c.b);
  std::vector<double> near{zero}, far{2};
  for (double z = zero; z < kink / 2; z *= 8) near.push_back(std::min(8 * z, kink / 2));
  for (double gap = kink / 16; gap > 0x1p-45; gap /= 8) near.push_back(kink - gap);
  for (double gap = 1 - kink / 2; gap > 0x1p-45; gap /= 8) far.insert(far.begin(), kink + gap);
  const auto part = [&](bool beyond) {
    return [&, beyond](const Ball& z, bool) {
      if (!positive(z)) return undefined();
      return peclet * slope_kernel(peclet * z) * overlap(c, z, n, beyond);
    };
  };
  const Ball most = 8 * c.l * c.unit * peclet, gap = Ball(far.front()) - near.back();
  const Ball lost = most * (zero + slope_kernel(peclet * Ball(near.back())) * gap);
  return widened(integral(part(false), near) + integral(part(true), far), lost);
}

/// The changes of kappa, gamma0, Q* and xi* per H at Carter's border.
std::array<Ball, 4> changes(const ColdContact& c, double peclet, double sign) {
  const auto heat = [&](bool moment) {
    const Ball strain = kernel_on_stick(c, peclet, false, moment) / pi_ball();
    return c.f * peclet * (strain - sign * c.f * kernel_on_stick(c, peclet, true, moment));
  };
  const Ball load = -sign * c.f * slope_on_contact(c, peclet, 1);
  const Ball gamma0 = -sign * c.f * slope_on_contact(c, peclet, 0) / pi_ball();
  const Ball constant = heat(false) + 2 * c.f * c.l * load / pi_ball();
  return {load, gamma0, heat(true) - c.f * c.b * c.b * load, constant - c.f * gamma0};
}

}  // namespace

void certified_first_order(const Rows& rows) {
  std::puts("$Q^*$,$\\mathrm{Pe}$,result,change per $H$,radius,library,revision,date");
  bits = 192;
  goal_bits = 50;
  const double cases[][2] = {{0.5, 4360}, {0.5, 100}, {0.3, 10000}, {0.5, 1}};
  const char* const names[] = {"$\\kappa$", "$\\gamma_0$", "$Q^*$", "$\\xi^*$"};
  for (const auto& [traction, peclet] : cases) {
    const std::array<Ball, 4> all = changes(ColdContact(paper::friction, traction), peclet, -1);
    for (std::size_t i = 0; i < 4; ++i)
      rows(shortest(traction) + "," + shortest(peclet) + "," + names[i], all[i]);
  }
}

}  // namespace thermoroll::certify
