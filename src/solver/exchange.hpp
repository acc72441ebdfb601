// Tangled from paper/24-exchanged-heat.md; edit there.
#pragma once

#include <memory>
#include <string>

#include <Eigen/Core>

#include "solver/nodes.hpp"
#include "solver/thermal_terms.hpp"
#include "thermoroll/coupled.hpp"
#include "thermoroll/kernels.hpp"
#include "thermoroll/scene.hpp"

namespace thermoroll {

/// The crossing flux, on n slip nodes and m stick nodes. All matrices have a column for each term
/// of h, and a last one for the bulk difference.
struct Exchange {
  Eigen::MatrixXd series;       // coefficients of @eq:exchange-series, n and then m
  ThermalTerms thermal;         // its part of the terms, beside the uniform share
  Eigen::MatrixXd temperature;  // its part of T* at the n, then the m nodes
  Eigen::RowVectorXd heat;      // the integral of E over the contact
  Eigen::RowVectorXd edge;      // C of E = C / sqrt(1 + s) + ... at the leading edge
};

/// Whether @eq:exchange is solved in such a contact.
bool exchanges(const Scene& scene, const ZoneLengths& at);

/// Solve @eq:exchange for two bodies that conduct, on the nodes of a grid and by its rules, for an
/// h of so many terms, at most as many as there are slip nodes; with none only the column of the
/// bulk difference is left.
Exchange exchange(const Scene& scene, Formulation formulation, const Nodes& z,
                  const GridRules& rules, Eigen::Index terms);

/// no_slip() to a hundredth, or to all digits where a traction or creep, with its sign, is near;
/// nothing for a given border.
NoSlip no_slip_near(const Scene& scene, const Prescribed& given);

/// That friction is zero at T_c of @eq:edge-temperature, for a message; empty if it is not.
std::string without_friction(const Scene& scene);

/// The prescribed value less that without slip in the scene's direction; a traction of f stays f.
Prescribed beyond_no_slip(const Scene& scene, Prescribed given);

/// Add it to the terms of a grid in which both bodies have the uniform share of heat.
void add_exchange(const Exchange& x, ThermalTerms& to);

/// For a bulk difference of one, by the corrected equations and driving. The coefficients of
/// @eq:exchange-series, and those of Legendre's polynomials in the y of a slip zone that is the
/// whole contact: of F, the strain, T*, and p-hat less 2 kappa / pi without the roots at its edges.
/// Estimated errors of rest and T*.
struct BulkExchange {
  Eigen::VectorXd flux, slope, strain, temperature, pressure;
  double root_1 = 0, root_2 = 0;  // of sqrt(1 + s) and sqrt(1 - s) in F
  double kappa = 0, gamma0 = 0;
  double heat = 0, edge = 0;  // the integral of E, and C
  NoSlip rest{};              // @eq:no-slip
  double temperature_error = 0;
};

/// The unknowns of a grid that begins to resolve the layers at the edges; 30 to 120.
int edge_unknowns(const Scene& scene);

/// For grids of so many unknowns; none without a bulk difference.
std::shared_ptr<const BulkExchange> bulk_exchange(const Scene& scene, Eigen::Index unknowns);

/// The effect of the scene's bulk difference at the nodes of a grid.
BulkTerms bulk_terms(const BulkExchange& x, const Scene& scene, Formulation formulation,
                     const Nodes& z);

/// E of @eq:exchange-series: the coefficients on both zones.
struct ExchangedFlux {
  ZoneLengths at;
  Eigen::VectorXd slip, stick;
};

/// For the coefficients of h.
ExchangedFlux exchanged_flux(const Exchange& x, const Nodes& z, const Eigen::VectorXd& h);

/// E at every s; zero outside of the contact.
Eigen::ArrayXd flux_at(const ExchangedFlux& x, const Eigen::ArrayXd& s);

/// E on the slip zone and, if there is one, on the stick zone.
std::vector<HeatFlux> heat_fluxes(const ExchangedFlux& x);

/// The integral of M(Pe (t - s)) E / pi at every s of the surface; a rule of a multiple of eight
/// nodes.
Eigen::ArrayXd temperature_of(const ExchangedFlux& x, double peclet, const Eigen::ArrayXd& s,
                              const GaussLegendre& rule);

/// The same by a rule that resolves the flux.
Eigen::ArrayXd temperature_of(const ExchangedFlux& x, double peclet, const Eigen::ArrayXd& s);

}  // namespace thermoroll
