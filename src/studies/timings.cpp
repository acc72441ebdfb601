// Tangled from paper/G-benchmarks.md; edit there.
#include "studies/timings.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "studies/comparison.hpp"
#include "support/number_text.hpp"

namespace thermoroll {
namespace {

nlohmann::json read_json(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("it cannot be read");
  nlohmann::json found = nlohmann::json::parse(file, nullptr, false);
  if (found.is_discarded()) throw std::runtime_error("it is not JSON");
  return found;
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void times_by_name(std::ostream& out, const Times& times) {
  out << "name,seconds\n";
  for (const auto& [name, time] : times) out << name << ',' << time << '\n';
}

std::string duration(double seconds) {
  if (seconds < 1e-3) return fixed(1e6 * seconds, seconds < 1e-5 ? 1 : 0) + " µs";
  return fixed(1e3 * seconds, seconds < 1e-2 ? 1 : 0) + " ms";
}

std::string below(double error) { return error < 1e-13 ? "< $10^{-13}$" : scientific(error, 1); }

struct Bar {
  std::string key, claim;
  double wanted, slow, fast;  // the ratio wanted, and the two times
  double measured() const { return slow / fast; }
};

double time_of(const Times& times, const std::string& name) {
  const auto found = times.find(name);
  if (found == times.end()) throw std::runtime_error("no time of " + name);
  return found->second;
}

/// The name of the first run of a method that has kappa - 1 within a relative error.
std::string accurate_enough(const Regime& regime, const std::string& method, double error) {
  const double exact = reference(regime).load_ratio - 1;
  for (const Run& run : runs(regime))
    if (run.method == method && std::abs((run.find().load_ratio - 1) / exact - 1) <= error)
      return run.name;
  throw std::runtime_error(method + " never has the load to " + shortest(error));
}

std::vector<Bar> bars(const Times& times) {
  const auto of = [&](const std::string& name) { return time_of(times, name); };
  const std::string steel = "/Pe:4360/H:0.0175";
  const double scheme = of("gauss_chebyshev/n:200" + steel);
  const double scheme_to_2 = of(accurate_enough(regimes[1], "gauss_chebyshev", 0.02));
  const double coupled_to_2 = of(accurate_enough(regimes[1], "coupled", 0.02));
  const double once_to_2 = of(accurate_enough(regimes[1], "first_order", 0.02));
  return {{"6", "coupled to $10^{-6}$, steel", 200, scheme, of("coupled/tol:1e-06" + steel)},
          {"8", "coupled to $10^{-8}$, steel", 50, scheme, of("coupled/tol:1e-08" + steel)},
          {"load", "coupled, $\\kappa-1$ to 2 %, slow", 2000, scheme_to_2, coupled_to_2},
          {"once", "one correction, $\\kappa-1$ to 2 %, slow", 2000, scheme_to_2, once_to_2},
          {"curve", "temperature at 400 points, closed form", 50, scheme,
           of("temperature_curve/points:400")},
          {"curve_coupled", "temperature at 400 points, coupled", 50, scheme,
           of("temperature_curve_coupled/points:400")}};
}

void table_of_bars(std::ostream& out, const Times& times) {
  out << "what is faster,published scheme,time,ratio,wanted,met\n";
  for (const Bar& bar : bars(times))
    out << '"' << bar.claim << "\"," << duration(bar.slow) << ',' << duration(bar.fast) << ','
        << fixed(bar.measured(), 0) << ',' << fixed(bar.wanted, 0) << ','
        << (bar.measured() >= bar.wanted ? "yes" : "no") << '\n';
}

void table_of_shares(std::ostream& out, const Times& times) {
  const auto of = [&](const std::string& name) { return time_of(times, name); };
  const double whole = of("coupled/tol:1e-08/Pe:4360/H:0.0175");
  const double coarse = of("coupled/tol:1e-06/Pe:4360/H:0.0175");
  const double rays = of("part/rays"), sides = of("part/sides");
  const double inverses = of("part/inverses"), peak = of("part/hottest");
  const double rest = whole - coarse - sides - inverses - peak;
  out << "what,time,share\n";
  for (const auto& [what, seconds] : {std::pair{"coarser grids, with 10 and 30 unknowns", coarse},
                                      {"last grid: nodes of the rays and kernels", rays},
                                      {"last grid: sums with Legendre polynomials", sides - rays},
                                      {"last grid: inverses of the transforms", inverses},
                                      {"last grid: hottest point", peak},
                                      {"last grid: Newton's method, signs, estimates", rest},
                                      {"**all**", whole}})
    out << '"' << what << "\"," << duration(seconds) << ',' << fixed(100 * seconds / whole, 0)
        << " %\n";
}

void carters_problem(std::ostream& out, const Times& times) {
  out << "program,cells or unknowns,force,creep,traction,time\n"
         "CONTACT,50,1.25 %,1.6 %,3.1 %,9 ms\n"
         "CONTACT,200,0.31 %,0.42 %,1.6 %,29 ms\n"
         "CONTACT,800,0.078 %,0.10 %,0.78 %,570 ms\n"
         "CONTACT,1600,0.039 %,–,0.53 %,2920 ms\n";
  const CarterErrors x = carter_errors();
  out << "**coupled**," << x.unknowns << ',' << below(x.force) << ',' << below(x.creep) << ','
      << below(x.traction) << ',' << duration(time_of(times, "carter")) << '\n';
}

void times_in_prose(std::ostream& out, const Times& times) {
  nlohmann::ordered_json v;
  for (const Bar& bar : bars(times)) {
    v["speed_ratio_" + bar.key] = fixed(bar.measured(), 0);
    v["speed_time_" + bar.key] = duration(bar.fast);
    v["speed_slow_" + bar.key] = duration(bar.slow);
  }
  const auto of = [&](const std::string& name) {
    return time_of(times, name + "/Pe:4360/H:0.0175");
  };
  const double scheme = of("gauss_chebyshev/n:200"), thrifty = of("gauss_chebyshev_thrifty/n:200");
  for (const auto& [digits, tolerance] : {std::pair{"2", 0.01}, {"3", 1e-3}, {"6", 1e-6}}) {
    const std::string run = "/tol:" + shortest(tolerance) + "/random:200";
    const double saved = time_of(times, "coupled" + run) / time_of(times, "auto" + run);
    v[std::string("least_saved_") + digits] = fixed(saved, 1);
  }
  v["speed_digits"] = fixed(of("coupled/tol:1e-10") / of("coupled/tol:0.01"), 0);
  v["speed_scheme"] = duration(scheme);
  v["speed_thrifty"] = duration(thrifty);
  v["speed_repeated"] = fixed(100 * (1 - thrifty / scheme), 0);
  out << v.dump(2) << '\n';
}

using TimedWriter = void (*)(std::ostream&, const Times&);

const std::vector<std::pair<std::string, TimedWriter>>& timed_writers() {
  static const std::vector<std::pair<std::string, TimedWriter>> table{{"times", times_by_name},
                                                                      {"bars", table_of_bars},
                                                                      {"shares", table_of_shares},
                                                                      {"contact", carters_problem},
                                                                      {"speed", times_in_prose}};
  return table;
}

}  // namespace

Times read_times(const std::string& path) try {
  const std::map<std::string, double> seconds{{"ns", 1e-9}, {"us", 1e-6}, {"ms", 1e-3}, {"s", 1}};
  std::map<std::string, std::vector<double>> all;
  const nlohmann::json output = read_json(path);
  for (const auto& run : output.at("benchmarks")) {
    if (run.at("run_type") != "iteration" || run.value("error_occurred", false)) continue;
    const double unit = seconds.at(run.at("time_unit").get<std::string>());
    all[run.at("run_name")].push_back(unit * run.at("cpu_time").get<double>());
  }
  Times times;
  for (auto& [name, values] : all) times[name] = median(values);
  return times;
} catch (const nlohmann::json::exception&) {
  throw std::runtime_error(path + " is not the output of thermoroll-bench: it has other contents");
} catch (const std::exception& error) {
  throw std::runtime_error(path + " is not the output of thermoroll-bench: " + error.what());
}

std::vector<std::string> timed_data_names() {
  std::vector<std::string> names;
  for (const auto& [name, write] : timed_writers()) names.push_back(name);
  return names;
}

void write_timed_data(const std::string& name, const Times& times, std::ostream& out) {
  for (const auto& [known, write] : timed_writers())
    if (name == known) return write(out, times);
  throw std::invalid_argument("figure-data: unknown name " + name);
}

}  // namespace thermoroll
