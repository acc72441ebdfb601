// Tangled from paper/E-fast-kernels.md; edit there.
#include "solver/linear_system.hpp"

namespace thermoroll {

using Eigen::MatrixXd;
using Eigen::PartialPivLU;
using Eigen::VectorXd;

MatrixXd solve(const MatrixXd& a, const MatrixXd& b) { return factors_of(a).solve(b); }

PartialPivLU<MatrixXd> factors_of(const MatrixXd& a) { return PartialPivLU<MatrixXd>(a); }

VectorXd solve(const PartialPivLU<MatrixXd>& a, const VectorXd& b) { return a.solve(b); }

}  // namespace thermoroll
