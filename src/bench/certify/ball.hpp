// Tangled from paper/M-certified.md; edit there.
#pragma once

#include <functional>
#include <vector>

#include <acb.h>

namespace thermoroll::certify {

/// Bits of the midpoints, and of the accuracy asked of integrals.
inline slong bits = 96, goal_bits = 70;

/// A complex number with radii; real if its imaginary part is exactly zero.
class Ball {
 public:
  Ball(double real = 0) {
    acb_init(x_);
    acb_set_d(x_, real);
  }
  Ball(const Ball& other) {
    acb_init(x_);
    acb_set(x_, other.x_);
  }
  ~Ball() { acb_clear(x_); }
  Ball& operator=(const Ball& other) {
    acb_set(x_, other.x_);
    return *this;
  }
  acb_ptr of() { return x_; }
  acb_srcptr of() const { return x_; }

 private:
  acb_t x_;
};

Ball operator+(const Ball& x, const Ball& y);
Ball operator-(const Ball& x, const Ball& y);
Ball operator*(const Ball& x, const Ball& y);
Ball operator/(const Ball& x, const Ball& y);
inline Ball operator-(const Ball& x) { return Ball(0) - x; }

Ball root(const Ball& x, bool analytic = false);
Ball exponential(const Ball& x);
Ball sine_of(const Ball& x);
Ball pi_ball();
Ball scaled_i(int order, const Ball& x);  // exp(-x) I
Ball scaled_k(int order, const Ball& x);  // exp(x) K
bool positive(const Ball& x);             // certainly, in the real part
bool wide(const Ball& x);                 // with fewer than 30 accurate bits
double upper(const Ball& x);              // of the real part
double lower(const Ball& x);
Ball magnitude(const Ball& x);
Ball undefined();
Ball between(double low, double high);
Ball widened(const Ball& x, const Ball& error);

/// An integrand; undefined where it is not analytic, if that is asked.
using Integrand = std::function<Ball(const Ball& x, bool analytic)>;

/// Its integral from point to point.
Ball integral(const Integrand& f, const std::vector<double>& points);

/// f on a ball, from f at the midpoint and the slope at the least real part.
template <class Function, class Slope>
Ball around_midpoint(const Ball& z, const Function& f, const Slope& slope) {
  Ball middle, least, radius;
  acb_get_mid(middle.of(), z.of());
  const Ball value = f(middle);
  if (acb_is_exact(z.of())) return value;
  arb_get_lbound_arf(arb_midref(acb_realref(least.of())), acb_realref(z.of()), bits);
  acb_get_rad_ubound_arf(arb_midref(acb_realref(radius.of())), z.of(), bits);
  return widened(value, radius * slope(least));
}

}  // namespace thermoroll::certify
