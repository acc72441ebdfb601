#include "curves.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace thermoroll_test {

Table data(const std::string& name) {
  return read_table(std::string(THERMOROLL_ROOT) + "/build/data/" + name + ".csv");
}

Curve curve(const Table& table, const std::vector<std::pair<std::string, std::string>>& where,
            const std::string& x, const std::string& y) {
  std::vector<std::pair<double, double>> points;
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    if (std::all_of(where.begin(), where.end(), [&](const auto& condition) {
          return table.text(row, condition.first) == condition.second;
        }))
      points.emplace_back(table.number(row, x), table.number(row, y));
  if (points.size() < 2) throw std::runtime_error("no such curve");
  std::stable_sort(points.begin(), points.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  Curve result;
  for (const auto& [abscissa, ordinate] : points) {
    result.x.push_back(abscissa);
    result.y.push_back(ordinate);
  }
  return result;
}

double at(const Curve& c, double x) {
  if (!(c.x.front() <= x && x <= c.x.back())) throw std::runtime_error("outside of the curve");
  const auto next = std::lower_bound(c.x.begin() + 1, c.x.end() - 1, x) - c.x.begin();
  const auto i = static_cast<std::size_t>(next);
  const double share = (x - c.x[i - 1]) / (c.x[i] - c.x[i - 1]);
  return (1 - share) * c.y[i - 1] + share * c.y[i];
}

double integral(const Curve& c) {
  double sum = 0;
  for (std::size_t i = 1; i < c.x.size(); ++i)
    sum += (c.x[i] - c.x[i - 1]) * (c.y[i] + c.y[i - 1]) / 2;
  return sum;
}

double largest(const Curve& c) { return *std::max_element(c.y.begin(), c.y.end()); }

}  // namespace thermoroll_test
