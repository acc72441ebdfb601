// Tangled from paper/F-data-files.md; edit there.
#include "studies/estimate_study.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <utility>

#include <nlohmann/json.hpp>

#include "studies/data.hpp"
#include "studies/sampling.hpp"
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

/// The ratios of a quantity that are not left out, ascending.
std::vector<double> ratios_of(const std::vector<StudyRow>& rows, Quantity quantity) {
  std::vector<double> x;
  for (const StudyRow& row : rows)
    if (const double ratio = row.ratio[static_cast<std::size_t>(quantity)]; !std::isnan(ratio))
      x.push_back(ratio);
  std::sort(x.begin(), x.end());
  return x;
}

/// What so many per cent of ascending numbers do not exceed; NaN of none.
double percentile(const std::vector<double>& x, std::size_t percent) {
  return x.empty() ? left_out : x[(x.size() - 1) * percent / 100];
}

long too_small(const std::vector<double>& ratios) {
  return std::count_if(ratios.begin(), ratios.end(), [](double x) { return x < 1; });
}

void write_achieved(std::ostream& out, const std::vector<StudyRow>& rows) {
  for (int bin = -18; bin < -4; ++bin) {
    std::vector<double> errors;
    for (const StudyRow& row : rows)
      if (std::floor(2 * std::log10(row.tolerance)) == bin) errors.push_back(row.error);
    std::sort(errors.begin(), errors.end());
    for (const auto& [curve, percent] :
         {std::pair{"median", 50u}, {"99 of 100", 99u}, {"all", 100u}})
      row(out, "achieved", curve, std::pow(10, (bin + 0.5) / 2), percentile(errors, percent));
  }
}

void write_histogram(std::ostream& out, const std::vector<StudyRow>& rows) {
  for (const Reported& q : studied) {
    const std::vector<double> ratios = ratios_of(rows, q.quantity);
    for (int bin = -4; bin < 28; ++bin) {
      const auto in_bin = [&](double x) { return std::floor(4 * std::log10(x)) == bin; };
      const auto count = std::count_if(ratios.begin(), ratios.end(), in_bin);
      row(out, "ratio", q.key, std::pow(10, (bin + 0.5) / 4),
          100 * static_cast<double>(count) / static_cast<double>(ratios.size()));
    }
  }
}

}  // namespace

StudyScene study_scene(int number) {
  Random random{std::mt19937_64(20261122 + static_cast<std::uint64_t>(number))};
  random.bits.discard(8);
  const double f = random.log_uniform(0.03, 1.5), peclet = random.log_uniform(1e-2, 1e6);
  Scene scene{f, peclet, random.log_uniform(1e-6, 10) / f};
  const double share = random.uniform() < 0.5 ? random.uniform() : random.log_uniform(1e-6, 1);
  const double pull = f * (random.uniform() < 0.5 ? share : 1 - share);
  const Quantity all[] = {Quantity::traction, Quantity::creep, Quantity::stick_slip_border};
  const Quantity what = all[static_cast<int>(3 * random.uniform())];
  return {scene, {what, carter_values(carter(f, pull))(what)}, random.log_uniform(1e-9, 1e-2)};
}

std::optional<StudyRow> study_row(int number) try {
  const StudyScene x = study_scene(number);
  const auto to = [&](double tolerance) {
    return solve_coupled(x.scene, {Formulation::corrected, tolerance}, x.given);
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

std::vector<StudyRow> study_rows(int count) {
  std::vector<std::optional<StudyRow>> found(static_cast<std::size_t>(count));
  on_all_processors(found.size(),
                    [&](std::size_t i) { found[i] = study_row(static_cast<int>(i)); });
  std::vector<StudyRow> rows;
  for (const auto& row : found)
    if (row) rows.push_back(*row);
  return rows;
}

void write_study_figure(std::ostream& out, const std::vector<StudyRow>& rows) {
  row(out, "part", "curve", "x", "y");
  write_achieved(out, rows);
  write_histogram(out, rows);
}

void write_study_table(std::ostream& out, const std::vector<StudyRow>& rows) {
  row(out, "result", "compared", "1 of 100 below", "median", "3 of 4 below", "too small");
  for (const Reported& q : studied) {
    const std::vector<double> x = ratios_of(rows, q.quantity);
    row(out, q.key, x.size(), fixed(percentile(x, 1), 1), fixed(percentile(x, 50), 0),
        fixed(percentile(x, 75), 0), too_small(x));
  }
}

void write_study_values(std::ostream& out, const std::vector<StudyRow>& rows) {
  std::vector<double> all;
  for (const Reported& q : studied)
    for (const double x : ratios_of(rows, q.quantity)) all.push_back(x);
  std::sort(all.begin(), all.end());
  double used = 0;  // of the tolerance
  for (const StudyRow& row : rows) used = std::max(used, row.error / row.tolerance);
  nlohmann::ordered_json v;
  v["study_scenes"] = std::to_string(rows.size());
  v["study_compared"] = std::to_string(all.size());
  v["study_median"] = fixed(percentile(all, 50), 0);
  v["study_beyond"] = std::to_string(too_small(all));
  v["study_worst"] = fixed(1 / all.front(), 1);
  v["study_used"] = fixed(100 * used, 0);
  out << v.dump(2) << '\n';
}

void write_study_sample(std::ostream& out, const std::vector<StudyRow>& rows) {
  out << "number,tolerance,error";
  for (const Reported& q : studied) out << ',' << q.key;
  for (const StudyRow& x : rows) {
    if (x.number % 100 != 50) continue;
    out << std::setprecision(2) << '\n' << x.number << ',' << x.tolerance << ',' << x.error;
    for (const Reported& q : studied) {
      const double ratio = x.ratio[static_cast<std::size_t>(q.quantity)];
      out << ',';
      if (!std::isnan(ratio)) out << ratio;
    }
  }
  out << '\n';
}

}  // namespace thermoroll
