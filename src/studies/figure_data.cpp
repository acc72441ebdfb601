// Tangled from paper/F-data-files.md; edit there.
#include "studies/figure_data.hpp"

#include <iomanip>
#include <map>
#include <stdexcept>
#include <utility>

#include "studies/data.hpp"

namespace thermoroll {

using Writer = std::function<void(std::ostream&)>;

/// What has been registered; there before the first object that registers.
std::map<std::string, Writer>& writers() {
  static std::map<std::string, Writer> by_name;
  return by_name;
}

void write_figure_data(const std::string& name, std::ostream& out) {
  const auto found = writers().find(name);
  if (found == writers().end()) throw std::invalid_argument("figure-data: unknown name " + name);
  out << std::setprecision(10);
  found->second(out);
}

FigureData::FigureData(const std::string& name, Writer write) {
  if (!writers().emplace(name, std::move(write)).second)
    throw std::logic_error("two data have the name " + name);
}

std::vector<std::string> figure_data_names() {
  std::vector<std::string> names;
  for (const auto& [name, write] : writers()) names.push_back(name);
  return names;
}

std::vector<double> grid(double low, double high, int n) {
  std::vector<double> points;
  for (int i = 0; i <= n; ++i) points.push_back(((n - i) * low + i * high) / n);
  return points;
}

}  // namespace thermoroll
