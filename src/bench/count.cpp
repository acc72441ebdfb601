// Tangled from paper/G-benchmarks.md; edit there.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/kernel_table.hpp"
#include "studies/comparison.hpp"
#include "support/number_text.hpp"
#include "thermoroll/kernels.hpp"

namespace thermoroll {

void uncounted_kernels(std::size_t n, const double* distance, Kernels* k);
Kernels uncounted_kernels(double distance);
SlopeAndStrain uncounted_slope_and_strain(double zeta);
double uncounted_temperature(double zeta);

namespace uncounted {
double N1(double zeta);
double N2(double zeta);
double M(double zeta, double eta);
double N(double zeta, double friction, Formulation formulation);
}  // namespace uncounted

std::size_t evaluations = 0;  // so far

template <class Found>
Found counted(const Found& found) {
  ++evaluations;
  return found;
}

void fast_kernels(std::size_t n, const double* distance, Kernels* k) {
  evaluations += n;
  uncounted_kernels(n, distance, k);
}

Kernels fast_kernels(double distance) { return counted(uncounted_kernels(distance)); }

SlopeAndStrain fast_slope_and_strain(double zeta) {
  return counted(uncounted_slope_and_strain(zeta));
}

double fast_temperature(double zeta) { return counted(uncounted_temperature(zeta)); }

namespace kernel {

double N1(double zeta) { return counted(uncounted::N1(zeta)); }

double N2(double zeta) { return counted(uncounted::N2(zeta)); }

double M(double zeta, double eta) { return counted(uncounted::M(zeta, eta)); }

double N(double zeta, double friction, Formulation formulation) {
  return counted(uncounted::N(zeta, friction, formulation));
}

}  // namespace kernel

namespace {

struct Counted {
  Run run;
  double digits;
  std::size_t evaluations;
};

std::vector<Counted> count_runs(const Regime& regime) {
  const Found exact = reference(regime);
  std::vector<Counted> all;
  for (const Run& run : runs(regime))
    if (run.method == "first_order") run.find();  // makes the table of the fast limit
  for (const Run& run : runs(regime)) {
    evaluations = 0;
    const Found found = run.find();
    if (const double digits = right_digits(found, exact); !std::isnan(digits))
      all.push_back({run, digits, evaluations});
  }
  return all;
}

double fewest(const std::vector<Counted>& all, const std::string& method, double digits) {
  double least = std::numeric_limits<double>::infinity();
  for (const Counted& x : all)
    if (x.run.method == method && x.digits >= digits)
      least = std::min(least, static_cast<double>(x.evaluations));
  return least;
}

void values(std::ostream& out, const std::vector<Counted>& all) {
  nlohmann::ordered_json v;
  const auto of = [&](const char* method, double setting) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Counted& x) {
      return x.run.method == method && x.run.setting == setting;
    });
    return static_cast<double>(found->evaluations);
  };
  v["evaluations_coupled_6"] = to_two_digits(of("coupled", 1e-6));
  v["evaluations_cached_ratio"] = to_two_digits(of("thrifty", 200) / of("coupled", 1e-6));
  const auto panels = [&](double digits) {
    return to_two_digits(fewest(all, "graded_panels", digits) / fewest(all, "coupled", digits));
  };
  v["evaluations_panels_6"] = panels(6);
  v["evaluations_panels_8"] = panels(8);
  out << v.dump(2) << '\n';
}

}  // namespace
}  // namespace thermoroll

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::string folder = argv[1];
  std::ofstream figure(folder + "/evaluations.csv"), prose(folder + "/evaluations.json");
  const auto all = thermoroll::count_runs(thermoroll::regimes[0]);
  figure.precision(10);
  figure << "method,setting,name,digits,evaluations\n";
  for (const auto& [run, digits, evaluations] : all)
    figure << run.method << ',' << run.setting << ',' << run.name << ',' << digits << ','
           << evaluations << '\n';
  thermoroll::values(prose, all);
  return figure.flush() && prose.flush() ? 0 : 1;
}
