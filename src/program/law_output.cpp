// Tangled from paper/22-creep-curve.md, paper/C-output.md; edit there.
#include "program/law_output.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <nlohmann/json.hpp>

#include "program/format.hpp"
#include "support/number_text.hpp"

namespace thermoroll {
namespace {

/// The creep at z, which is negative on the braking half.
double creep_at(const CreepLaw& law, double z) {
  const double size = std::abs(z), unit = (z < 0 ? law.braking : law.driving).unit_creep;
  return law.no_slip_creep + std::copysign(size <= 1 ? unit * size * size : unit / (2 - size), z);
}

double z_of(const CreepLaw& law, double creep) {
  const LawSide side = side_of(law, creep);
  const double share = side.size / side.half.unit_creep;
  return side.sign * (share <= 1 ? std::sqrt(share) : 2 - 1 / share);
}

struct WayAlong {
  std::vector<double> creep, way;
};

WayAlong length_along(const CreepLaw& law, const CurveRange& range, double friction) {
  const double width = range.to - range.from, first = z_of(law, range.from);
  const int many = 20 * range.points;
  const double apart = (z_of(law, range.to) - first) / many;
  WayAlong x{{range.from}, {0}};
  LawValue last = evaluate(law, range.from).value_or(LawValue{});
  const auto angle = [&](const LawValue& at) { return std::atan(at.slope * width / friction); };
  for (int i = 1; i <= many; ++i) {
    const double creep = i == many ? range.to : creep_at(law, first + i * apart);
    const LawValue now = evaluate(law, creep).value_or(last);
    x.way.push_back(x.way.back() + (creep - x.creep.back()) / width +
                    std::abs(now.traction - last.traction) / friction +
                    std::abs(angle(now) - angle(last)));
    x.creep.push_back(creep);
    last = now;
  }
  return x;
}

void move_to_zero(std::vector<double>& points) {
  for (std::size_t k = 1; k + 1 < points.size(); ++k) {
    const double apart = std::min(points[k] - points[k - 1], points[k + 1] - points[k]);
    if (std::abs(points[k]) < 1e-4 * apart) points[k] = 0;
  }
}

std::string unsigned_zero(double x) { return shortest(x == 0 ? 0 : x); }

LawValue finite_value(const CreepLaw& law, double creep) {
  const std::optional<LawValue> x = evaluate(law, creep);
  if (!x || !std::isfinite(x->traction + x->temperature + x->border))
    throw NotResolved("law: no finite value at the creep " + shortest(creep), {});
  return *x;
}

std::string curve_header(const std::optional<LawUnits>& units) {
  const bool bulk = units && units->bulk_temperature;
  std::string text = "creep,traction,stick_slip_border,full_slip,max_temperature";
  if (units) text += ",creep_ratio,creep_speed_m_per_s,tangential_load,max_temperature_celsius";
  if (bulk) text += ",contact_temperature_celsius";
  text += ",error_estimate.traction,error_estimate.stick_slip_border";
  text += ",error_estimate.max_temperature";
  if (units) text += ",error_estimate.tangential_load,error_estimate.max_temperature_celsius";
  return text + '\n';
}

struct LawTable {
  const char* name;
  std::vector<double> numbers{};
};

/// The last creep and the rounding of a creep in other units and over that without slip.
double past_rounding(double last, double rest) { return last + 4e-16 * (last + std::abs(rest)); }

/// For both sides of each law unit_creep, last_creep and the first piece, with the number of pieces
/// at the end; then the ends of all pieces and their coefficients, law_terms for each.
std::vector<LawTable> tables_of(const CreepLawBySpeed& by_speed) {
  LawTable unit{"unit_creep"}, last{"last_creep"}, first{"first_piece", {0}}, from{"from_z"},
      to{"to_z"}, q{"traction_terms"}, t{"temperature_terms"};
  for (const CreepLaw& law : by_speed.laws)
    for (const LawHalf* half : {&law.driving, &law.braking}) {
      for (const LawPiece& piece : half->pieces) {
        from.numbers.push_back(piece.from);
        to.numbers.push_back(piece.to);
        q.numbers.insert(q.numbers.end(), piece.traction.begin(), piece.traction.end());
        t.numbers.insert(t.numbers.end(), piece.temperature.begin(), piece.temperature.end());
      }
      unit.numbers.push_back(half->unit_creep);
      last.numbers.push_back(past_rounding(half->last_creep, law.no_slip_creep));
      first.numbers.push_back(static_cast<double>(from.numbers.size()));
    }
  return {unit, last, first, from, to, q, t};
}

std::vector<std::pair<const char*, double>> constants_of(const LawUnits& unit) {
  return {{"creep_unit", unit.creep},
          {"traction_unit", unit.traction},
          {"temperature_unit", unit.temperature}};
}

std::vector<LawTable> states_of(const CreepLawBySpeed& by_speed) {
  LawTable creep{"no_slip_creep"}, traction{"no_slip_traction"}, coldest{"coldest"};
  for (const CreepLaw& law : by_speed.laws) {
    creep.numbers.push_back(law.no_slip_creep);
    traction.numbers.push_back(law.no_slip_traction);
    coldest.numbers.push_back(law.coldest);
  }
  return {creep, traction, coldest};
}

bool counts_pieces(const LawTable& table) { return table.name == std::string("first_piece"); }

std::string listed(const LawTable& table, const std::string& infinite) {
  std::string text;
  for (const double x : table.numbers)
    text += (text.empty() ? "" : ", ") + (std::isfinite(x) ? shortest(x) : infinite);
  return text;
}

bool has_speeds(const CreepLawBySpeed& law) { return law.laws.size() > 1; }

std::vector<LawTable> all_tables_of(const CreepLawBySpeed& law) {
  std::vector<LawTable> all = states_of(law);
  if (has_speeds(law)) {
    LawTable scale{"share_creep"};  // for both sides of each of the five laws of a piece
    for (std::size_t first = 0; first + 1 < law.laws.size(); first += 4)
      for (std::size_t i = 0; i < 5; ++i)
        for (const bool brakes : {false, true})
          scale.numbers.push_back(scale_of(law, first, i, brakes));
    all.push_back({"speeds", law.speeds});
    all.push_back(scale);
  }
  for (const LawTable& table : tables_of(law)) all.push_back(table);
  return all;
}

nlohmann::ordered_json scene_of_law(const Scene& x, Formulation formulation) {
  nlohmann::ordered_json o{{"friction", x.friction}, {"peclet", x.peclet}, {"heating", x.heating}};
  o["formulation"] = name_of(formulation_names, formulation);
  o["roller"] = name_of(roller_names, kind_of(x));
  if (x.roller.conductivity_ratio > 0) {
    o["conductivity_ratio"] = x.roller.conductivity_ratio;
    o["heating_2"] = x.roller.heating;
    o["peclet_2"] = peclet_2(x);
    o["bulk_difference"] = x.bulk_difference;
  }
  if (const auto* law = x.law.target<LawOfFriction>()) {
    o["friction_law"] = name_of(law_names, std::optional(law->kind));
    o["friction_temperature"] = law->of.scale;
    o["friction_floor"] = law->of.floor;
    o["friction_reference_temperature"] = law->of.reference;
  }
  return o;
}

std::string told_data(const CreepLawBySpeed& law, const nlohmann::ordered_json& scene,
                      const std::vector<SiDatum>& si, const std::string& mark) {
  std::string text = mark + "Rolling contact by thermoroll, dimensionless:\n";
  for (const auto& [key, value] : scene.items())
    text.append(mark).append("  " + key + " = " + value.dump() + '\n');
  if (!si.empty()) text += mark + "In SI units:\n";
  for (const auto& [name, value, unit] : si) {
    const bool all_speeds = has_speeds(law) && name == std::string("speed");
    text.append(mark).append("  ").append(name).append(" = ").append(shortest(value));
    if (all_speeds) text += " to " + shortest(law.speeds.back());
    text.append(*unit == 0 ? "" : " ").append(unit).append("\n");
  }
  return text;
}

std::string told(const CreepLawBySpeed& law, const nlohmann::ordered_json& scene,
                 const std::optional<LawUnits>& units, const std::vector<SiDatum>& si,
                 const std::string& mark) {
  const LawUnits unit = units.value_or(LawUnits{});
  std::string text = told_data(law, scene, si, mark);
  const bool by_speed = has_speeds(law);
  text += mark + (units ? "Creep as a fraction of the speed, traction in N/m, temperature: the "
                          "largest rise over the half-space's bulk in degree C.\n"
                        : "Creep xi*, traction Q*, temperature: the largest T*.\n");
  text += mark + "Slope: of the traction by the creep, without an error of its own.\n";
  if (by_speed)
    text += mark + "The dimensionless data are those of the lowest speed.\n" + mark +
            "At speeds outside of this range the status is 1.\n";
  if (units) text += mark + "Both surfaces have one speed in the model: creeps up to 0.1.\n";
  const double q = 1.05 * law.traction_error, t = 1.05 * law.temperature_error;  // rounded upwards
  text += mark + "Errors: of the traction " + rounded(q * unit.traction, 2) +
          ", of the temperature " + rounded(t * unit.temperature, 2) + ";\n" + mark +
          "in full slip the latter grows like the creep from where all slips on.\n";
  for (const bool brakes : {false, true}) {
    const LawEnd end = earliest_end(law, brakes);
    text += mark + (brakes ? "Braking" : "Driving");
    text += end.reason.empty() ? " has no end.\n"
                               : " ends at the creep " + shortest(end.creep * unit.creep) +
                                     (by_speed ? " at the earliest: " : ": ") + end.reason + ".\n";
  }
  return text + mark + "Beyond an end the status is 1 and all else is 0.\n";
}

constexpr const char* c_series = R"(
static double series(const double *c, double x, double *slope) {
  double b = 0, before = 0, d = 0, d_before = 0;
  for (int j = terms - 1; j > 0; --j) {
    const double next = 2 * x * b - before + c[j], d_next = 2 * x * d - d_before + 2 * b;
    before = b;
    b = next;
    d_before = d;
    d = d_next;
  }
  *slope = b + x * d - d_before;
  return x * b - before + c[0];
}
)";

constexpr const char* c_function = R"(
static int law_at(int law, double creep, double *traction, double *slope, double *temperature) {
  const double more = creep / creep_unit - no_slip_creep[law];
  const int brakes = more < 0, side = 2 * law + brakes;
  const double sign = brakes ? -1 : 1, size = sign * more, unit = unit_creep[side];
  *traction = *slope = *temperature = 0;
  if (!(size <= last_creep[side] && isfinite(size))) return 1;
  const double z = size <= unit ? sqrt(size / unit) : 2 - unit / size;
  int k = first_piece[side];
  while (k + 1 < first_piece[side + 1] && z > to_z[k]) ++k;
  const double per_z = 2 / (to_z[k] - from_z[k]);
  const double x = fmin(1, fmax(-1, per_z * (z - from_z[k]) - 1));
  double by_x, unused;
  const double q = series(traction_terms + terms * k, x, &by_x);
  const double t = fmax(coldest[law], series(temperature_terms + terms * k, x, &unused));
  const int sticks = from_z[k] < 1;
  *traction = traction_unit * (sticks ? no_slip_traction[law] + sign * size * q : sign * q);
  *slope = traction_unit / creep_unit *
           (!sticks         ? unit / size / size * per_z * by_x
            : z < from_z[k] ? q
                            : q + z * per_z * by_x / 2);
  *temperature = temperature_unit * t * (sticks ? 1 : size / unit);
  return 0;
}
)";

constexpr const char* c_alone = R"(
int creep_law(double creep, double *traction, double *slope, double *temperature) {
  return law_at(0, creep, traction, slope, temperature);
}
)";

constexpr const char* c_by_speed = R"(
int creep_law(double creep, double speed, double *traction, double *slope, double *temperature) {
  double weight[5], rest = 0, unit[2] = {0, 0}, sum[3] = {0, 0, 0}, q, dq, t;
  int first = 0;
  *traction = *slope = *temperature = 0;
  if (!(speeds[0] <= speed && speed <= speeds[laws - 1] && isfinite(creep))) return 1;
  while (first + 5 < laws && speed > speeds[first + 4]) first += 4;
  const double y = 4 * log(speed / speeds[first]) / log(speeds[first + 4] / speeds[first]);
  for (int i = 0; i < 5; ++i) {
    weight[i] = 1;
    for (int j = 0; j < 5; ++j)
      if (j != i) weight[i] *= (y - j) / (i - j);
    rest += weight[i] * no_slip_creep[first + i];
    for (int side = 0; side < 2; ++side)
      unit[side] += weight[i] * share_creep[first / 4 * 10 + 2 * i + side];
  }
  const double more = creep / creep_unit - rest;
  const int brakes = more < 0;
  const double share = fabs(more) / unit[brakes];
  for (int i = 0; i < 5; ++i) {
    const int law = first + i;
    const double own = share_creep[first / 4 * 10 + 2 * i + brakes];
    const double stretch = share > 1 ? sqrt(speed / speeds[law]) : 1;
    const double size = own * (share + (stretch - 1) * (share - 1));
    const double there = no_slip_creep[law] + (brakes ? -size : size);
    if (law_at(law, creep_unit * there, &q, &dq, &t)) return 1;
    sum[0] += weight[i] * q;
    sum[1] += weight[i] * stretch * own / unit[brakes] * dq;
    sum[2] += weight[i] * speeds[law] / speeds[0] * t;
  }
  *traction = sum[0];
  *slope = sum[1];
  *temperature = sum[2];
  return 0;
}
)";

std::string in_c(const CreepLawBySpeed& law, const LawUnits& unit, const std::string& comment) {
  std::string text = comment + "#include <math.h>\n\n";
  const std::string laws = has_speeds(law) ? ", laws = " + std::to_string(law.laws.size()) : "";
  text += "enum { terms = " + std::to_string(law_terms) + laws + " };\n";
  for (const auto& [name, number] : constants_of(unit))
    text += std::string("static const double ") + name + " = " + shortest(number) + ";\n";
  for (const LawTable& table : all_tables_of(law))
    text += std::string("static const ") + (counts_pieces(table) ? "int " : "double ") +
            table.name + "[] = {" + listed(table, "HUGE_VAL") + "};\n";
  return text + c_series + c_function + (has_speeds(law) ? c_by_speed : c_alone);
}

constexpr const char* python_function = R"(

def series(c, x):
    b = before = d = d_before = 0.0
    for term in reversed(c[1:]):
        b, before, d, d_before = 2 * x * b - before + term, b, 2 * x * d - d_before + 2 * b, d
    return x * b - before + c[0], b + x * d - d_before


def law_at(law, creep):
    more = creep / creep_unit - no_slip_creep[law]
    side, sign = (2 * law + 1, -1) if more < 0 else (2 * law, 1)
    size, unit = sign * more, unit_creep[side]
    if not size <= last_creep[side] or math.isinf(size):
        return 0.0, 0.0, 0.0, 1
    z = math.sqrt(size / unit) if size <= unit else 2 - unit / size
    k = first_piece[side]
    while k + 1 < first_piece[side + 1] and z > to_z[k]:
        k += 1
    per_z = 2 / (to_z[k] - from_z[k])
    x = min(1, max(-1, per_z * (z - from_z[k]) - 1))
    q, by_x = series(traction_terms[terms * k:terms * (k + 1)], x)
    t = max(coldest[law], series(temperature_terms[terms * k:terms * (k + 1)], x)[0])
    if from_z[k] < 1:
        traction, slope = no_slip_traction[law] + sign * size * q, q
        if z > from_z[k]:
            slope += z * per_z * by_x / 2
    else:
        traction, slope, t = sign * q, unit / size / size * per_z * by_x, t * size / unit
    return traction_unit * traction, traction_unit / creep_unit * slope, temperature_unit * t, 0
)";

constexpr const char* python_alone = R"(

def creep_law(creep):
    """Traction, its slope, temperature and status at a creep."""
    return law_at(0, creep)
)";

constexpr const char* python_by_speed = R"(

def creep_law(creep, speed):
    """Traction, its slope, temperature and status at a creep and a speed."""
    if not (speeds[0] <= speed <= speeds[-1] and math.isfinite(creep)):
        return 0.0, 0.0, 0.0, 1
    first = 0
    while first + 5 < len(speeds) and speed > speeds[first + 4]:
        first += 4
    y = 4 * math.log(speed / speeds[first]) / math.log(speeds[first + 4] / speeds[first])
    weights = [math.prod((y - j) / (i - j) for j in range(5) if j != i) for i in range(5)]
    mean = lambda table: sum(w * x for w, x in zip(weights, table))
    more = creep / creep_unit - mean(no_slip_creep[first:])
    side, sign = (1, -1) if more < 0 else (0, 1)
    own = share_creep[first // 4 * 10 + side:][:10:2]
    unit = mean(own)
    share = abs(more) / unit
    traction = slope = temperature = 0.0
    for law, weight in enumerate(weights, first):
        stretch = math.sqrt(speed / speeds[law]) if share > 1 else 1
        size = own[law - first] * (share + (stretch - 1) * (share - 1))
        q, dq, t, status = law_at(law, creep_unit * (no_slip_creep[law] + sign * size))
        if status:
            return 0.0, 0.0, 0.0, 1
        traction, slope = traction + weight * q, slope + weight * stretch * own[law - first] / unit * dq
        temperature += weight * speeds[law] / speeds[0] * t
    return traction, slope, temperature, 0
)";

std::string in_python(const CreepLawBySpeed& law, const LawUnits& unit,
                      const std::string& comment) {
  std::string text = comment + "import math\n\nterms = " + std::to_string(law_terms) + "\n";
  for (const auto& [name, number] : constants_of(unit))
    text += std::string(name) + " = " + shortest(number) + "\n";
  for (const LawTable& table : all_tables_of(law))
    text += table.name + (" = [" + listed(table, "math.inf")) + "]\n";
  return text + python_function + (has_speeds(law) ? python_by_speed : python_alone);
}

constexpr const char* modelica_piece = R"(    if distance > last_creep[side] then
      traction := 0; slope := 0; temperature := 0; status := 1;
      return;
    end if;
    z := if distance <= unit_creep[side] then sqrt(distance / unit_creep[side]) else 2 - unit_creep[side] / distance;
    k := first_piece[side] + 1;
    while k < first_piece[side + 1] and z > to_z[k] loop k := k + 1; end while;
    per_z := 2 / (to_z[k] - from_z[k]);
    x := min(1, max(-1, per_z * (z - from_z[k]) - 1));
    b := {0, 0}; before := {0, 0}; d := {0, 0}; d_before := {0, 0};
    for j in terms:-1:2 loop
      next := 2 * x * b - before + {traction_terms[terms * (k - 1) + j], temperature_terms[terms * (k - 1) + j]};
      before := b;
      b := next;
      next := 2 * x * d - d_before + 2 * before;
      d_before := d;
      d := next;
    end for;)";

constexpr const char* modelica_sum = R"(
    q := x * b[1] - before[1] + traction_terms[terms * (k - 1) + 1];
    t := max(coldest[law], x * b[2] - before[2] + temperature_terms[terms * (k - 1) + 1]);
    by_x := b[1] + x * d[1] - d_before[1];
    if from_z[k] < 1 then
      traction := traction + weight * traction_unit * (no_slip_traction[law] + way * distance * q);
      slope := slope + weight * steeper * traction_unit / creep_unit * (if z < from_z[k] then q else q + z * per_z * by_x / 2);
      temperature := temperature + weight * warmer * temperature_unit * t;
    else
      traction := traction + weight * traction_unit * way * q;
      slope := slope + weight * steeper * traction_unit / creep_unit * unit_creep[side] / distance / distance * per_z * by_x;
      temperature := temperature + weight * warmer * temperature_unit * t * distance / unit_creep[side];
    end if;
  end for;
)";

constexpr const char* modelica_variables = R"(  Integer first, shares, side, k;
  Real y, weight, weights[5], rest, unit[2], more, way, share, own, stretch, steeper, warmer, distance;
  Real z, per_z, x, b[2], before[2], d[2], d_before[2], next[2], q, by_x, t;
algorithm
  traction := 0; slope := 0; temperature := 0; status := 0;
)";

constexpr const char* modelica_alone = R"(  weight := 1; steeper := 1; warmer := 1;
  more := creep / creep_unit - no_slip_creep[1];
  way := if more < 0 then -1 else 1;
  for law in 1:1 loop
    side := if more < 0 then 2 else 1;
    distance := way * more;
)";

constexpr const char* modelica_by_speed = R"(  if speed < speeds[1] or speed > speeds[laws] then
    status := 1;
    return;
  end if;
  first := 1;
  while first + 4 < laws and speed > speeds[first + 4] loop first := first + 4; end while;
  y := 4 * log(speed / speeds[first]) / log(speeds[first + 4] / speeds[first]);
  weights := {1, 1, 1, 1, 1}; rest := 0; unit := {0, 0}; shares := div(first, 4) * 10;
  for i in 1:5 loop
    for j in 1:5 loop
      weights[i] := if j == i then weights[i] else weights[i] * (y - (j - 1)) / (i - j);
    end for;
    rest := rest + weights[i] * no_slip_creep[first + i - 1];
    unit := unit + weights[i] * {share_creep[shares + 2 * i - 1], share_creep[shares + 2 * i]};
  end for;
  more := creep / creep_unit - rest;
  way := if more < 0 then -1 else 1;
  share := if more < 0 then -more / unit[2] else more / unit[1];
  for law in first:first + 4 loop
    weight := weights[law - first + 1];
    side := if more < 0 then 2 * law else 2 * law - 1;
    own := share_creep[shares + 2 * (law - first) + (if more < 0 then 2 else 1)];
    stretch := if share > 1 then sqrt(speed / speeds[law]) else 1;
    steeper := stretch * own / (if more < 0 then unit[2] else unit[1]);
    warmer := speeds[law] / speeds[1];
    distance := own * (share + (stretch - 1) * (share - 1));
)";

std::string in_modelica(const CreepLawBySpeed& law, const LawUnits& unit,
                        const std::string& comment) {
  const bool by_speed = has_speeds(law);
  std::string text = comment + "function creep_law\n  input Real creep;\n";
  if (by_speed) text += "  input Real speed;\n";
  text += "  output Real traction, slope, temperature;\n  output Integer status;\nprotected\n";
  text += "  constant Integer terms = " + std::to_string(law_terms) + ";\n";
  if (by_speed) text += "  constant Integer laws = " + std::to_string(law.laws.size()) + ";\n";
  for (const auto& [name, number] : constants_of(unit))
    text += std::string("  constant Real ") + name + " = " + shortest(number) + ";\n";
  for (const LawTable& table : all_tables_of(law))
    text += std::string("  constant ") + (counts_pieces(table) ? "Integer " : "Real ") +
            table.name + "[:] = {" + listed(table, "1e300") + "};\n";
  text += modelica_variables + std::string(by_speed ? modelica_by_speed : modelica_alone);
  return text + modelica_piece + modelica_sum + "end creep_law;\n";
}

std::string in_json(const CreepLawBySpeed& law, const LawUnits& unit, nlohmann::ordered_json o) {
  for (const auto& [name, number] : constants_of(unit)) o[name] = number;
  for (const LawTable& table : all_tables_of(law)) {
    o[table.name] = table.numbers;
    if (counts_pieces(table))
      o[table.name] = std::vector<int>(table.numbers.begin(), table.numbers.end());
    if (table.numbers.size() == 1) o[table.name] = table.numbers.front();
  }
  for (const CreepLaw& one : law.laws)
    for (const LawHalf* half : {&one.driving, &one.braking})
      o["end_reason"].push_back(half->reason);
  o["error_estimate"] = {{"traction", law.traction_error * unit.traction},
                         {"temperature", law.temperature_error * unit.temperature}};
  return o.dump(1) + '\n';
}

}  // namespace

std::vector<double> curve_points(const CreepLaw& law, const CurveRange& range, double friction) {
  const auto [creep, way] = length_along(law, range, friction);
  std::vector<double> points;
  std::size_t next = 1;
  for (int k = 0; k + 1 < range.points; ++k) {
    const double wanted = way.back() * k / (range.points - 1);
    while (next + 1 < way.size() && way[next] <= wanted) ++next;
    const double share = (wanted - way[next - 1]) / (way[next] - way[next - 1]);
    points.push_back(creep[next - 1] + share * (creep[next] - creep[next - 1]));
  }
  points.push_back(range.to);
  move_to_zero(points);
  return points;
}

std::string creep_curve_csv(const CreepLaw& law, const std::vector<double>& creeps,
                            const std::optional<LawUnits>& units) {
  std::string text = curve_header(units);
  const bool bulk = units && units->bulk_temperature;
  for (const double creep : creeps) {
    const LawValue x = finite_value(law, creep);
    const LawSide side = side_of(law, creep);
    const bool full = x.border == -1;
    std::vector<double> more;
    if (units) {
      const double ratio = creep * units->creep, rise = x.temperature * units->temperature;
      more = {ratio, ratio * units->speed, x.traction * units->traction, rise};
      if (bulk) more.push_back(*units->bulk_temperature + rise);
    }
    const double grown = std::max(1.0, side.size / side.half.unit_creep);
    const double error = law.temperature_error * grown;
    more.insert(more.end(), {law.traction_error, border_error_at(law, creep), error});
    if (units) more.push_back(law.traction_error * units->traction);
    if (units) more.push_back(error * units->temperature);
    text += unsigned_zero(creep) + ',' + unsigned_zero(x.traction) + ',' + shortest(x.border) +
            ',' + (full ? "true" : "false") + ',' + unsigned_zero(x.temperature);
    for (const double number : more) text += ',' + unsigned_zero(number);
    text += '\n';
  }
  return text;
}

std::string law_text(const CreepLawBySpeed& law, const Scene& of, Formulation formulation,
                     const std::optional<PhysicalScene>& si, Language language) {
  nlohmann::ordered_json scene = scene_of_law(of, formulation);
  std::optional<LawUnits> units;
  if (si) units = law_units(*si, of.friction);
  const LawUnits unit = units.value_or(LawUnits{});
  const bool conducting = kind_of(of) == RollerKind::conducting;
  const std::vector<SiDatum> data = si ? data_in_si(*si, conducting) : std::vector<SiDatum>{};
  const auto comment = [&](const char* mark) { return told(law, scene, units, data, mark); };
  if (language == Language::c) return in_c(law, unit, comment("// "));
  if (language == Language::python) return in_python(law, unit, comment("# "));
  if (language == Language::modelica) return in_modelica(law, unit, comment("// "));
  if (units && !has_speeds(law)) scene["speed"] = units->speed;
  if (unit.bulk_temperature) scene["bulk_temperature"] = *unit.bulk_temperature;
  for (const SiDatum& x : data) scene["data_in_si"][x.name] = x.value;
  return in_json(law, unit, scene);
}

}  // namespace thermoroll
