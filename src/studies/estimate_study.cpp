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

StudyKind draw_kind(Random& random) {
  const double x = random.uniform();
  if (x < 0.5) return StudyKind::one_body;
  if (x < 0.7) return StudyKind::alike;
  if (x < 0.8) return x < 0.77 ? StudyKind::unlike : StudyKind::bulk_difference;
  return x < 0.96 ? StudyKind::law : StudyKind::law_of_unlike;
}

void draw_second_body(Random& random, StudyKind kind, Scene& scene) {
  const double conductivity = random.log_uniform(0.1, 10);
  scene.roller = {conductivity, scene.heating * random.log_uniform(0.1, 10)};
  if (kind == StudyKind::alike) return;
  scene.roller.peclet = scene.peclet * random.log_uniform(1.0 / 30, 30);
  if (kind == StudyKind::unlike) return;
  if (kind == StudyKind::law_of_unlike && random.uniform() < 0.5) return;
  const double side = random.uniform() < 0.5 ? -1 : 1;
  scene.bulk_difference =
      side * random.log_uniform(0.003, 0.3) * scene.friction / std::sqrt(scene.peclet);
}

void draw_law(Random& random, Scene& scene) {
  const double most = scene.friction / std::sqrt(scene.peclet);
  const double falls = most * random.log_uniform(0.2, 10), end = 0.7 * random.uniform();
  const FrictionTemperature of{falls, end};
  const FrictionLaw laws[] = {linear_friction(of), exponential_friction(of), rational_friction(of),
                              piecewise_linear_friction(of)};
  scene.law = laws[static_cast<int>(4 * random.uniform())];
}

void draw_reference(Random& random, Scene& scene) {
  LawOfFriction law = *scene.law.target<LawOfFriction>();
  law.of.reference = scene.friction / std::sqrt(scene.peclet) * random.log_uniform(1e-3, 1);
  scene.law = law;
}

constexpr int of_one_sign_and_partial_slip = 10000;

void draw_another_kind(Random& random, int number, StudyScene& x) {
  Scene& scene = x.scene;
  scene.law = {};
  scene.bulk_difference = 0;
  if (number / 100 % 4 == 0) {
    x = {scene, x.given, x.tolerance, StudyKind::printed_sign, Formulation::printed};
    scene.roller = {};
    scene.direction = Direction::driving;
  } else if (number / 100 % 4 == 1) {
    x.kind = StudyKind::nearly_alike;
    draw_second_body(random, StudyKind::alike, scene);
    const double apart = random.log_uniform(1e-14, 0.5);
    scene.roller.peclet = scene.peclet * std::exp(random.uniform() < 0.5 ? -apart : apart);
  } else {
    x.kind = StudyKind::full_slip;
    const double beyond = random.log_uniform(1e-3, 10);
    x.given = {Quantity::creep, 2 * scene.friction / pi * (1 + beyond)};
  }
}

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

const std::pair<StudyKind, std::string> kinds[] = {
    {StudyKind::one_body, "one conducting body"},
    {StudyKind::alike, "two bodies of one diffusivity"},
    {StudyKind::unlike, "two of unlike diffusivities"},
    {StudyKind::bulk_difference, "the same with a bulk difference"},
    {StudyKind::law, "a law of friction"},
    {StudyKind::law_of_unlike, "a law of friction between unlike bodies"},
    {StudyKind::printed_sign, "one body with the printed sign"},
    {StudyKind::nearly_alike, "two of nearly one diffusivity"},
    {StudyKind::full_slip, "full slip"}};

std::vector<StudyRow> rows_of(const std::vector<StudyRow>& rows, StudyKind kind) {
  std::vector<StudyRow> found;
  for (const StudyRow& row : rows)
    if (row.kind == kind) found.push_back(row);
  return found;
}

/// The ratios of all quantities, ascending.
std::vector<double> all_ratios_of(const std::vector<StudyRow>& rows) {
  std::vector<double> all;
  for (const Reported& q : studied)
    for (const double x : ratios_of(rows, q.quantity)) all.push_back(x);
  std::sort(all.begin(), all.end());
  return all;
}

/// The largest true error by the tolerance asked for.
double most_used(const std::vector<StudyRow>& rows) {
  double used = 0;
  for (const StudyRow& row : rows) used = std::max(used, row.error / row.tolerance);
  return used;
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
  const double tolerance = random.log_uniform(1e-9, 1e-2);
  const StudyKind kind = draw_kind(random);
  const bool with_law = kind == StudyKind::law || kind == StudyKind::law_of_unlike;
  if (with_law) draw_law(random, scene);
  if (kind != StudyKind::one_body && kind != StudyKind::law) draw_second_body(random, kind, scene);
  if (kind != StudyKind::one_body && random.uniform() < 0.5) scene.direction = Direction::braking;
  if (with_law && random.uniform() < 0.5) draw_reference(random, scene);
  StudyScene x{scene, {what, carter_values(carter(f, pull))(what)}, tolerance, kind};
  if (number >= of_one_sign_and_partial_slip) draw_another_kind(random, number, x);
  return x;
}

CoupledSolution study_solution(const StudyScene& x, double tolerance) {
  return solve_coupled(x.scene, {x.formulation, tolerance}, x.given);
}

CoupledSolution better_solution(const StudyScene& x) try {
  return study_solution(x, 1e-10);
} catch (const std::runtime_error&) {  // not resolved to so much
  if (x.tolerance < 1e-7) throw;
  return study_solution(x, 1e-8);
}

std::optional<StudyRow> study_row(int number) try {
  const StudyScene x = study_scene(number);
  const CoupledSolution found = study_solution(x, x.tolerance), best = better_solution(x);
  const Results off = (found.value - best.value).abs(), scale = scale_in(x.scene, best.value);
  StudyRow row{number, x.kind, x.tolerance, (off / scale).head(compared).maxCoeff(), {}};
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

void write_study_kinds(std::ostream& out, const std::vector<StudyRow>& rows) {
  row(out, "kind", "scenes", "compared", "median", "too small", "true/stated", "true/tolerance");
  for (const auto& [kind, name] : kinds) {
    const std::vector<StudyRow> some = rows_of(rows, kind);
    const std::vector<double> x = all_ratios_of(some);
    row(out, name, some.size(), x.size(), fixed(percentile(x, 50), 0), too_small(x),
        fixed(1 / percentile(x, 0), 2), fixed(most_used(some), 2));
  }
}

void write_study_table(std::ostream& out, const std::vector<StudyRow>& rows) {
  row(out, "result", "compared", "1 of 100 below", "median", "3 of 4 below", "99 of 100 below",
      "too small");
  for (const Reported& q : studied) {
    const std::vector<double> x = ratios_of(rows, q.quantity);
    row(out, q.key, x.size(), fixed(percentile(x, 1), 1), fixed(percentile(x, 50), 0),
        fixed(percentile(x, 75), 0), fixed(percentile(x, 99), 0), too_small(x));
  }
}

void write_study_values(std::ostream& out, const std::vector<StudyRow>& rows) {
  const std::vector<double> all = all_ratios_of(rows);
  nlohmann::ordered_json v;
  v["study_scenes"] = std::to_string(rows.size());
  v["study_compared"] = std::to_string(all.size());
  v["study_median"] = fixed(percentile(all, 50), 0);
  v["study_beyond"] = std::to_string(too_small(all));
  v["study_worst"] = fixed(1 / all.front(), 1);
  v["study_used"] = fixed(100 * most_used(rows), 0);
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
