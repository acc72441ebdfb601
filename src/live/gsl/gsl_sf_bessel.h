// Tangled from paper/J-live-page.md; edit there.
#pragma once

#include "live/special_functions.hpp"

inline double gsl_sf_bessel_K0_scaled(double x) { return thermoroll::bessel_k_scaled(0, x); }
inline double gsl_sf_bessel_K1_scaled(double x) { return thermoroll::bessel_k_scaled(1, x); }
inline double gsl_sf_bessel_I0_scaled(double x) { return thermoroll::bessel_i_scaled(0, x); }
inline double gsl_sf_bessel_I1_scaled(double x) { return thermoroll::bessel_i_scaled(1, x); }
inline double gsl_sf_bessel_K0(double x) { return std::exp(-x) * gsl_sf_bessel_K0_scaled(x); }
