// Tangled from paper/F-data-files.md; edit there.
#include "studies/estimate_study.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <limits>
#include <random>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <utility>

#include <nlohmann/json.hpp>

#include "studies/data.hpp"
#include "support/number_text.hpp"
#include "thermoroll/carter.hpp"

namespace thermoroll {
namespace {

constexpr double left_out = std::numeric_limits<double>::quiet_NaN();

std::vector<Reported> quantities_of_the_study() {
  std::vector<Reported> all;
  for (const Reported& q : reported)
    if (static_cast<int>(q.quantity) < compared) all.push_back(q);
  return all;
}

const std::vector<Reported> studied = quantities_of_the_study();

using Rows = std::vector<std::vector<double>>;  // number, tolerance, error, ratios

Rows read_study(const std::string& path) {
  std::ifstream file(path);
  Rows rows;
  std::string line;
  for (std::getline(file, line); std::getline(file, line);) {
    std::vector<double> row;
    std::istringstream cells(line + ',');
    for (std::string cell; std::getline(cells, cell, ',');)
      row.push_back(cell.empty() ? left_out : std::stod(cell));
    if (row.size() != 3 + studied.size())
      throw std::runtime_error(path + " is not a study: it has a row of " +
                               std::to_string(row.size()) + " cells");
    rows.push_back(row);
  }
  if (rows.empty()) throw std::runtime_error(path + " is not a study: it has no rows");
  return rows;
}

/// The numbers of a column that are there, ascending.
std::vector<double> column_of(const Rows& rows, std::size_t column) {
  std::vector<double> x;
  for (const auto& row : rows)
    if (!std::isnan(row[column])) x.push_back(row[column]);
  std::sort(x.begin(), x.end());
  return x;
}

/// What so many per cent of ascending numbers do not exceed; NaN of none.
double percentile(const std::vector<double>& x, std::size_t percent) {
  return x.empty() ? left_out : x[(x.size() - 1) * percent / 100];
}

void write_achieved(std::ostream& out, const Rows& rows) {
  for (int bin = -18; bin < -4; ++bin) {
    Rows here;
    for (const auto& row : rows)
      if (std::floor(2 * std::log10(row[1])) == bin) here.push_back(row);
    const std::vector<double> errors = column_of(here, 2);
    for (const auto& [curve, percent] : {std::pair{"median", 50}, {"99 of 100", 99}, {"all", 100}})
      row(out, "achieved", curve, std::pow(10, (bin + 0.5) / 2),
          percentile(errors, static_cast<std::size_t>(percent)));
  }
}

void write_histogram(std::ostream& out, const Rows& rows) {
  for (std::size_t k = 0; k < studied.size(); ++k) {
    const std::vector<double> ratios = column_of(rows, 3 + k);
    for (int bin = -4; bin < 28; ++bin) {
      const auto in_bin = [&](double x) { return std::floor(4 * std::log10(x)) == bin; };
      const auto count = std::count_if(ratios.begin(), ratios.end(), in_bin);
      row(out, "ratio", studied[k].key, std::pow(10, (bin + 0.5) / 4),
          100 * static_cast<double>(count) / static_cast<double>(ratios.size()));
    }
  }
}

void estimates(std::ostream& out, const Rows& rows) {
  row(out, "part", "curve", "x", "y");
  write_achieved(out, rows);
  write_histogram(out, rows);
}

long too_small(const std::vector<double>& ratios) {
  return std::count_if(ratios.begin(), ratios.end(), [](double x) { return x < 1; });
}

void by_quantity(std::ostream& out, const Rows& rows) {
  row(out, "result", "compared", "median", "99 of 100 below", "too small");
  for (std::size_t k = 0; k < studied.size(); ++k) {
    const std::vector<double> x = column_of(rows, 3 + k);
    row(out, studied[k].key, x.size(), fixed(percentile(x, 50), 0), fixed(percentile(x, 99), 0),
        too_small(x));
  }
}

void study_in_prose(std::ostream& out, const Rows& rows) {
  std::vector<double> all;
  for (std::size_t k = 0; k < studied.size(); ++k)
    for (const double x : column_of(rows, 3 + k)) all.push_back(x);
  std::sort(all.begin(), all.end());
  nlohmann::ordered_json v;
  v["study_scenes"] = std::to_string(rows.size());
  v["study_compared"] = std::to_string(all.size());
  v["study_median"] = fixed(percentile(all, 50), 0);
  v["study_beyond"] = std::to_string(too_small(all));
  v["study_worst"] = fixed(1 / all.front(), 1);
  out << v.dump(2) << '\n';
}

}  // namespace

StudyScene study_scene(int number) {
  std::mt19937_64 random(20261122 + static_cast<std::uint64_t>(number));
  random.discard(8);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const auto log_uniform = [&](double low, double high) {
    return low * std::pow(high / low, uniform());
  };
  const double f = log_uniform(0.03, 1.5), peclet = log_uniform(1e-2, 1e6);
  Scene scene{f, peclet, log_uniform(1e-6, 10) / f};
  const double share = uniform() < 0.5 ? uniform() : log_uniform(1e-6, 1);
  const double pull = f * (uniform() < 0.5 ? share : 1 - share);
  const Quantity all[] = {Quantity::traction, Quantity::creep, Quantity::stick_slip_border};
  const Quantity what = all[static_cast<int>(3 * uniform())];
  return {scene, {what, carter_values(carter(f, pull))(what)}, log_uniform(1e-9, 1e-2)};
}

std::optional<StudyRow> study_row(int number) try {
  const StudyScene x = study_scene(number);
  const auto to = [&](double tolerance) {
    return solve_coupled(x.scene, Formulation::corrected, tolerance, x.given);
  };
  const CoupledSolution found = to(x.tolerance), best = to(1e-10);
  const Results off = (found.value - best.value).abs(), scale = scale_of(best.value);
  StudyRow row{number, x.tolerance, (off / scale).head(compared).maxCoeff(), {}};
  for (int i = 0; i < compared; ++i) {
    const double known = std::max(off[i], best.error[i]);
    row.ratio[static_cast<std::size_t>(i)] =
        found.error[i] > 10 * best.error[i] ? found.error[i] / known : left_out;
  }
  return row;
} catch (const std::exception&) {  // refused, or a creep at which contact is lost
  return std::nullopt;
}

std::string line_of(const StudyRow& x) {
  std::ostringstream line;
  line << std::setprecision(2) << x.number << ',' << x.tolerance << ',' << x.error;
  for (const Reported& q : studied) {
    const double ratio = x.ratio[static_cast<std::size_t>(q.quantity)];
    line << ',';
    if (!std::isnan(ratio)) line << ratio;
  }
  return line.str();
}

void write_study(int count, std::ostream& out) {
  std::vector<std::string> lines(static_cast<std::size_t>(count));
  std::atomic<int> next{0};
  const auto work = [&] {
    for (int number = next++; number < count; number = next++)
      if (const auto x = study_row(number))
        lines[static_cast<std::size_t>(number)] = line_of(*x) + '\n';
  };
  std::vector<std::thread> others(std::max(1u, std::thread::hardware_concurrency()));
  for (std::thread& other : others) other = std::thread(work);
  for (std::thread& other : others) other.join();
  out << "number,tolerance,error";
  for (const Reported& q : studied) out << ',' << q.key;
  out << '\n';
  for (const std::string& line : lines) out << line;
}

using StudyWriter = void (*)(std::ostream&, const Rows&);

constexpr std::pair<const char*, StudyWriter> study_writers[] = {
    {"estimates", estimates}, {"study", by_quantity}, {"study-values", study_in_prose}};

std::vector<std::string> study_data_names() {
  std::vector<std::string> names;
  for (const auto& [name, write] : study_writers) names.emplace_back(name);
  return names;
}

void write_study_data(const std::string& name, const std::string& path, std::ostream& out) {
  for (const auto& [known, write] : study_writers)
    if (name == known) return write(out, read_study(path));
  throw std::invalid_argument("figure-data: unknown name " + name);
}

}  // namespace thermoroll
