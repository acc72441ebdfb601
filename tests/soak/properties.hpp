// What must hold of the coupled solver in any scene, and random scenes to try it in.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "thermoroll/coupled.hpp"

namespace soak {

/// A scene and the accuracy to solve it with.
struct Sample {
  thermoroll::Scene scene;
  thermoroll::Prescribed given;
  thermoroll::Formulation formulation;
  double tolerance;
};

/// One line that says which, with all digits, as options of `thermoroll solve`.
std::string text(const Sample& x);

/// The scene of this number in the sequence of a seed, the same on every machine. Three of four are
/// such as a user may ask for: log-uniform in f 0.03...1.5, f H 1e-7...50 and Pe 1e-2...1e6 or
/// 1e-3...1e8, Q*/f log-uniform down to 1e-9 from either end or uniform in between, at the
/// tolerance 1e-6 or between 1e-8 and 1e-2; the fourth is from the corners: Pe 1e-3...1e8, H 0 or
/// 1e-6...1e3, f 1e-3...2, and Q*/f down to 1e-12 from either end. In a third of all, the creep or
/// the border of Carter's solution is given in place of the traction; half of the creeps are near
/// the one of full slip in this scene, log-uniform in their distance from it. A third of the
/// cylinders each insulates, is the same body or conducts otherwise, and half of them brake. Of
/// sixteen scenes one has a law of friction, one bodies of different diffusivities and one
/// different bulk temperatures; some laws and half of the last are between bodies of different
/// diffusivities, some laws have different bulk temperatures, and a quarter of their tractions the
/// falling branch.
Sample sample(std::uint64_t seed, std::uint64_t number);

/// How far something may be from what it should be, and the scene in which it was so far.
struct Worst {
  double share = 0;  ///< of what is allowed
  std::uint64_t number = 0;
};

/// How many results were compared with a finer solution, in how many scenes the error was beyond
/// its estimate, and by how many times at most.
struct Compared {
  long scenes = 0, beyond = 0;
  double worst = 0;
};

/// What became of many scenes.
struct Totals {
  std::map<std::string, long> outcomes;         ///< solved, or the refusal without its numbers
  std::map<std::string, long> beside;           ///< what could not be looked at besides, and why
  std::map<std::string, Worst> worst;           ///< by property
  std::map<int, Compared> compared;             ///< by the decade that the tolerance is in
  std::map<std::string, std::string> failures;  ///< a property and one scene in which it fails
  void add(const Totals& other);
};

/// The totals and the scene that is being looked at.
class Record {
 public:
  Record(std::uint64_t number, const Sample& x, Totals& totals);
  /// A property that holds or not.
  void require(const char* property, bool holds) const;
  /// A property that holds if the deviation is at most what is allowed; a NaN is not.
  void within(const char* property, double deviation, double allowed) const;
  /// What became of the scene.
  void outcome(const std::string& what) const;
  /// A true error, in units of its estimate, of a solution to that tolerance; a larger one is told.
  void compared(double tolerance, double excess) const;
  /// What could not be looked at, and why.
  void beside(const std::string& what, const std::string& why) const;

 private:
  std::uint64_t number_;
  std::string scene_;
  Totals& totals_;
};

/// How much of what must hold is looked at.
enum class Depth {
  results,   ///< of one solve
  again,     ///< also solved once more, for a little less traction, and much finer
  profiles,  ///< also what the tractions carry
  energy     ///< also the energy balance, by adaptive quadrature
};

/// Solve a scene, look at what must hold, and add to the totals. Throws nothing.
void examine(std::uint64_t number, const Sample& x, Depth depth, Totals& totals);

}  // namespace soak
