// Tangled from paper/E-fast-kernels.md; edit there.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

namespace thermoroll {

/// x of a x = b, by elimination with row exchanges.
Eigen::MatrixXd solve(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// The factors of a, and x of a x = b from them.
Eigen::PartialPivLU<Eigen::MatrixXd> factors_of(const Eigen::MatrixXd& a);
Eigen::VectorXd solve(const Eigen::PartialPivLU<Eigen::MatrixXd>& a, const Eigen::VectorXd& b);

}  // namespace thermoroll
