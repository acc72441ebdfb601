// Tangled from paper/G-benchmarks.md; edit there.
#include "studies/timings.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "studies/comparison.hpp"
#include "studies/sampling.hpp"
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

double spread_of(const std::map<std::string, std::vector<double>>& all) {
  std::vector<double> spreads;
  for (const auto& [name, values] : all) {
    if (values.size() < 2) continue;
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    spreads.push_back((*most - *least) / *least);
  }
  std::sort(spreads.begin(), spreads.end());
  return spreads.empty() ? 0 : spreads[(spreads.size() - 1) * 9 / 10];
}

std::map<std::string, std::vector<double>> repetitions(const nlohmann::json& output) {
  const std::map<std::string, double> seconds{{"ns", 1e-9}, {"us", 1e-6}, {"ms", 1e-3}, {"s", 1}};
  std::map<std::string, std::vector<double>> all;
  for (const auto& run : output.at("benchmarks")) {
    if (run.at("run_type") != "iteration" || run.value("error_occurred", false)) continue;
    const double unit = seconds.at(run.at("time_unit").get<std::string>());
    const std::string name = run.at("run_name");
    all[name.substr(0, name.find("/repeats:"))].push_back(unit * run.at("cpu_time").get<double>());
  }
  return all;
}

void times_by_name(std::ostream& out, const Benchmarks& run) {
  out << "name,seconds\n";
  for (const auto& [name, time] : run.times) out << name << ',' << time << '\n';
}

std::string duration(double seconds) {
  if (seconds < 1e-3) return fixed(1e6 * seconds, seconds < 1e-5 ? 1 : 0) + " µs";
  return fixed(1e3 * seconds, seconds < 1e-2 ? 1 : 0) + " ms";
}

std::string below(double error) { return error < 1e-13 ? "< $10^{-13}$" : scientific(error, 1); }

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

void table_of_shares(std::ostream& out, const Benchmarks& run) {
  const auto of = [&](const std::string& name) { return time_of(run.times, name); };
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
                                      {"last grid: iteration, signs, estimates", rest},
                                      {"**all**", whole}})
    out << '"' << what << "\"," << duration(seconds) << ',' << fixed(100 * seconds / whole, 0)
        << " %\n";
}

void carters_problem(std::ostream& out, const Benchmarks& run) {
  out << "program,cells or unknowns,force,creep,traction,time\n"
         "CONTACT,50,1.25 %,1.6 %,3.1 %,9 ms\n"
         "CONTACT,200,0.31 %,0.42 %,1.6 %,29 ms\n"
         "CONTACT,800,0.078 %,0.10 %,0.78 %,570 ms\n"
         "CONTACT,1600,0.039 %,–,0.53 %,2920 ms\n";
  const CarterErrors x = carter_errors();
  out << "**coupled**," << x.unknowns << ',' << below(x.force) << ',' << below(x.creep) << ','
      << below(x.traction) << ',' << duration(time_of(run.times, "carter")) << '\n';
}

/// The least times of a method to have load, temperature and creep to six and to eight digits.
struct LeastTimes {
  double six = std::numeric_limits<double>::infinity(), eight = six;
};

LeastTimes least_times(const Times& times, const Regime& regime, const std::string& method) {
  const Found exact = reference(regime);
  LeastTimes least;
  for (const Run& run : runs(regime)) {
    if (run.method != method) continue;
    const Found x = run.find();
    const double time = time_of(times, run.name);
    const double error =
        std::max({std::abs((x.load_ratio - 1) / (exact.load_ratio - 1) - 1),
                  std::abs(x.hottest / exact.hottest - 1), std::abs(x.creep / exact.creep - 1)});
    if (error <= 1e-6) least.six = std::min(least.six, time);
    if (error <= 1e-8) least.eight = std::min(least.eight, time);
  }
  return least;
}

void circumstances(nlohmann::ordered_json& v, const Benchmarks& run) {
  v["speed_processor"] = run.processor;
  v["speed_compiler"] = run.compiler;
  v["speed_repetitions"] = std::to_string(run.repetitions);
  v["speed_spread"] = fixed(std::ceil(100 * run.spread), 0);
}

void times_of_solves(nlohmann::ordered_json& v, const Times& times) {
  const auto of = [&](const std::string& name) { return time_of(times, name); };
  const std::string steel = "/Pe:4360/H:0.0175";
  const double to_6 = of("coupled/tol:1e-06" + steel);
  const double scheme = of("gauss_chebyshev/n:200" + steel);
  const double cached = of("gauss_chebyshev_thrifty/n:200" + steel);
  v["speed_time_6"] = duration(to_6);
  v["speed_scheme"] = duration(scheme);
  v["speed_thrifty"] = duration(cached);
  v["speed_ratio_6"] = to_two_digits(scheme / to_6);
  v["speed_ratio_cached_6"] = to_two_digits(cached / to_6);
  v["speed_repeated"] = fixed(100 * (1 - cached / scheme), 0);
  v["speed_time_curve"] = duration(of("temperature_curve/points:400"));
  v["speed_time_curve_coupled"] = duration(of("temperature_curve_coupled/points:400"));
  v["speed_digits"] =
      to_two_digits(of("coupled/tol:1e-10" + steel) / of("coupled/tol:0.01" + steel));
  const double on_60 = of("coupled/tol:1e-08" + steel);
  v["speed_60_by_30"] = fixed(on_60 / to_6, 1);
  v["speed_88_by_60"] = fixed(of("coupled/tol:1e-10" + steel) / on_60, 1);
}

void times_at_equal_error(nlohmann::ordered_json& v, const Times& times) {
  const auto to_2_percent = [&](const char* method) {
    return time_of(times, accurate_enough(regimes[1], method, 0.02));
  };
  const double scheme = to_2_percent("gauss_chebyshev"), coupled = to_2_percent("coupled");
  v["speed_slow_load"] = duration(scheme);
  v["speed_time_load"] = duration(coupled);
  v["speed_time_once"] = duration(to_2_percent("first_order"));
  v["speed_ratio_load"] = to_two_digits(scheme / coupled);
  for (const Regime& regime : regimes) {
    const LeastTimes panels = least_times(times, regime, "graded_panels");
    const LeastTimes best = least_times(times, regime, "coupled");
    v[std::string("speed_panels_6_") + regime.name] = to_two_digits(panels.six / best.six);
    v[std::string("speed_panels_8_") + regime.name] = to_two_digits(panels.eight / best.eight);
  }
}

void times_in_prose(std::ostream& out, const Benchmarks& run) {
  nlohmann::ordered_json v;
  circumstances(v, run);
  times_of_solves(v, run.times);
  times_at_equal_error(v, run.times);
  for (const auto& [digits, tolerance] : {std::pair{"2", 0.01}, {"3", 1e-3}, {"6", 1e-6}}) {
    const std::string scenes = "/tol:" + shortest(tolerance) + "/random:200";
    const double saved =
        time_of(run.times, "coupled" + scenes) / time_of(run.times, "auto" + scenes);
    v[std::string("least_saved_") + digits] = fixed(saved, 1);
  }
  out << v.dump(2) << '\n';
}

using TimedWriter = void (*)(std::ostream&, const Benchmarks&);

const std::vector<std::pair<std::string, TimedWriter>>& timed_writers() {
  static const std::vector<std::pair<std::string, TimedWriter>> table{{"times", times_by_name},
                                                                      {"shares", table_of_shares},
                                                                      {"contact", carters_problem},
                                                                      {"speed", times_in_prose}};
  return table;
}

}  // namespace

std::string judgement(double ratio, double spread, double bar, bool at_least) {
  if (!(spread <= 0.05)) return "not judged";
  return (at_least ? ratio >= bar : ratio <= bar) ? "met" : "missed";
}

Benchmarks read_benchmarks(const std::string& path) try {
  const nlohmann::json output = read_json(path);
  auto all = repetitions(output);
  Benchmarks found;
  found.spread = spread_of(all);
  for (auto& [name, values] : all) {
    found.repetitions = std::max(found.repetitions, static_cast<int>(values.size()));
    found.times[name] = median(values);
  }
  const auto context = output.value("context", nlohmann::json::object());
  found.processor = context.value("processor", "an unknown processor");
  found.compiler = context.value("compiler", "an unknown compiler");
  return found;
} catch (const nlohmann::json::exception&) {
  throw std::invalid_argument(path +
                              " is not the output of thermoroll-bench: it has other contents");
} catch (const std::exception& error) {
  throw std::invalid_argument(path + " is not the output of thermoroll-bench: " + error.what());
}

std::vector<std::string> timed_data_names() {
  std::vector<std::string> names;
  for (const auto& [name, write] : timed_writers()) names.push_back(name);
  return names;
}

void write_timed_data(const std::string& name, const Benchmarks& run, std::ostream& out) {
  for (const auto& [known, write] : timed_writers())
    if (name == known) return write(out, run);
  throw std::invalid_argument("figure-data: unknown name " + name);
}

}  // namespace thermoroll
