// Tangled from paper/J-live-page.md; edit there.
#pragma once

#include <cstddef>

#include "program/live/special_functions.hpp"

inline int gsl_set_error_handler_off() { return 0; }  // there is none

inline double gsl_sf_bessel_K0_scaled(double x) { return thermoroll::bessel_k_scaled(0, x); }
inline double gsl_sf_bessel_K1_scaled(double x) { return thermoroll::bessel_k_scaled(1, x); }
inline double gsl_sf_bessel_I0_scaled(double x) { return thermoroll::bessel_i_scaled(0, x); }
inline double gsl_sf_bessel_I1_scaled(double x) { return thermoroll::bessel_i_scaled(1, x); }
inline double gsl_sf_bessel_K0(double x) { return std::exp(-x) * gsl_sf_bessel_K0_scaled(x); }

struct gsl_integration_glfixed_table {
  int n;
};

inline gsl_integration_glfixed_table* gsl_integration_glfixed_table_alloc(std::size_t n) {
  return new gsl_integration_glfixed_table{static_cast<int>(n)};
}

inline int gsl_integration_glfixed_point(double, double, std::size_t i, double* x, double* w,
                                         const gsl_integration_glfixed_table* table) {
  *x = thermoroll::legendre_zero(table->n, static_cast<int>(i));
  *w = 0;
  return 0;
}

inline void gsl_integration_glfixed_table_free(gsl_integration_glfixed_table* table) {
  delete table;
}
