// Tangled from paper/M-certified.md; edit there.
#include "bench/certify/ball.hpp"

#include <cmath>
#include <utility>

#include <acb_calc.h>
#include <acb_hypgeom.h>

namespace thermoroll::certify {
namespace {

using Operation = void (*)(acb_t, const acb_t, const acb_t, slong);

Ball done(Operation operation, const Ball& x, const Ball& y) {
  Ball z;
  operation(z.of(), x.of(), y.of(), bits);
  return z;
}

}  // namespace

Ball operator+(const Ball& x, const Ball& y) { return done(acb_add, x, y); }
Ball operator-(const Ball& x, const Ball& y) { return done(acb_sub, x, y); }
Ball operator*(const Ball& x, const Ball& y) { return done(acb_mul, x, y); }
Ball operator/(const Ball& x, const Ball& y) { return done(acb_div, x, y); }

Ball root(const Ball& x, bool analytic) {
  Ball z;
  acb_sqrt_analytic(z.of(), x.of(), analytic, bits);
  return z;
}

Ball exponential(const Ball& x) {
  Ball z;
  acb_exp(z.of(), x.of(), bits);
  return z;
}

Ball sine_of(const Ball& x) {
  Ball z;
  acb_sin(z.of(), x.of(), bits);
  return z;
}

Ball pi_ball() {
  Ball z;
  acb_const_pi(z.of(), bits);
  return z;
}

Ball scaled_i(int order, const Ball& x) {
  return exponential(-x) * done(acb_hypgeom_bessel_i, order, x);
}

Ball scaled_k(int order, const Ball& x) {
  const double size = upper(magnitude(x)), enough = 0.55 * static_cast<double>(bits);
  const double lost = size < enough ? 4 * size : 0;
  const slong usual = std::exchange(bits, bits + static_cast<slong>(lost));
  const Ball k = exponential(x) * done(acb_hypgeom_bessel_k, order, x);
  bits = usual;
  return k;
}

bool positive(const Ball& x) { return arb_is_positive(acb_realref(x.of())); }

double upper(const Ball& x) {
  arf_t bound;
  arf_init(bound);
  arb_get_ubound_arf(bound, acb_realref(x.of()), bits);
  const double up = acb_is_finite(x.of()) ? arf_get_d(bound, ARF_RND_CEIL) : HUGE_VAL;
  arf_clear(bound);
  return up;
}

double lower(const Ball& x) { return -upper(-x); }

Ball magnitude(const Ball& x) {
  Ball z;
  acb_abs(acb_realref(z.of()), x.of(), bits);
  return z;
}

Ball undefined() {
  Ball z;
  acb_indeterminate(z.of());
  return z;
}

Ball between(double low, double high) {
  Ball z;
  arb_t end;
  arb_init(end);
  arb_set_d(acb_realref(z.of()), low);
  arb_set_d(end, high);
  arb_union(acb_realref(z.of()), acb_realref(z.of()), end, bits);
  arb_clear(end);
  return z;
}

Ball widened(const Ball& x, const Ball& error) {
  Ball z = x;
  const Ball radius = magnitude(error);
  arb_add_error(acb_realref(z.of()), acb_realref(radius.of()));
  if (!acb_is_real(x.of())) arb_add_error(acb_imagref(z.of()), acb_realref(radius.of()));
  return z;
}

bool wide(const Ball& x) { return acb_rel_accuracy_bits(x.of()) < 30; }

Ball integral(const Integrand& f, const std::vector<double>& points) {
  const auto call = [](acb_ptr value, const acb_t x, void* of, slong order, slong) {
    Ball at;
    acb_set(at.of(), x);
    acb_set(value, (*static_cast<const Integrand*>(of))(at, order > 0).of());
    return 0;
  };
  mag_t goal;
  mag_init(goal);
  mag_set_ui_2exp_si(goal, 1, -goal_bits);
  Ball sum = 0, part;
  for (std::size_t i = 1; i < points.size(); ++i) {
    acb_calc_integrate(part.of(), call, const_cast<Integrand*>(&f), Ball(points[i - 1]).of(),
                       Ball(points[i]).of(), goal_bits, goal, nullptr, bits);
    sum = sum + part;
  }
  mag_clear(goal);
  return sum;
}

}  // namespace thermoroll::certify
