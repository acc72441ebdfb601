// Tangled from paper/08-results.md; edit there.
#pragma once

#include <string>
#include <vector>

namespace thermoroll {

enum class Judgement { holds, restricted, near, not_reproduced, fails, extended, untestable };
struct Verdict {
  Judgement outcome;
  std::string words;
};

/// Where this report has the evidence of a claim.
struct Evidence {
  std::string section;             ///< the label of the section
  std::string chunk;               ///< the title of the chunk that computes the values
  std::vector<std::string> tests;  ///< the names of the tests
  std::string figure = {};         ///< the label of the figure that shows it, or empty
};

/// A statement of the paper beside our values; the first six fields are text for a table.
struct Claim {
  std::string claim;      ///< the statement of the paper
  std::string source;     ///< its page, figure or equation there
  std::string paper;      ///< its value
  std::string published;  ///< the published scheme's value, run again
  std::string converged;  ///< the converged value, with the sign as printed
  std::string corrected;  ///< the same with the corrected sign
  Verdict verdict;
  Evidence evidence;
};

/// Every claim of the paper's text in the table; runs the published scheme some forty times.
std::vector<Claim> claims();

/// The number of claims with an outcome.
int count_of(const std::vector<Claim>& all, Judgement outcome);

/// The verdict on a number, given as the paper prints it, beside ours > 0: "holds" within half a
/// per cent, "holds, rounded" if ours rounds to it, up to five per cent "paper 4.0 % low", else
/// "not reproduced: 6.7 % high".
Verdict verdict_on(const std::string& paper, double ours);

/// "holds" or "does not hold"; what holds may have a restriction: "holds, by construction".
Verdict verdict(bool holds, const std::string& restriction = "");

/// The claim that an iteration on `unknown` took so many steps at most; `found` has ours.
Claim claim_on_steps(const std::string& unknown, int most, int found, bool converged);

/// Steps and errors of the published scheme over the paper's sixteen scenes with 50 and with 200
/// nodes, run to 0.1 %.
struct Record {
  int inner = 0;            ///< the largest number of inner steps
  int outer = 0;            ///< the largest number of outer steps
  bool converged = true;    ///< whether every run converged
  double coarse_error = 0;  ///< the largest error of T*max with n = 50, in per cent
  double fine_error = 0;    ///< the same with n = 200
};
Record scheme_record();

/// T*max in rolling over T*max in pure sliding with the same heat, at Pe = 1000 and f = 0.6, for
/// 0 < Q* < 0.6.
double rolling_to_sliding(double q);

/// 1 - kappa to first order in H at high speed, @eq:first-order, in the paper's scene with
/// 0 < Q* < 0.6.
double first_order_load_change(double q);

/// gamma0 to first order in H at high speed, @eq:first-order, in the paper's scene with
/// 0 < Q* < 0.6.
double first_order_gamma0(double q);

/// Speed V = 2 k Pe / a of the wheel on the rail, m/s, at a Péclet number > 0.
double speed_at(double pe);

/// The temperature in degrees C of T* = 1 for the wheel on the rail, at a speed in m/s and at a
/// Péclet number, > 0.
double celsius_per_unit(double speed);
double celsius_per_unit_at(double pe);

}  // namespace thermoroll
