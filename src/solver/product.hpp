// Tangled from paper/E-fast-kernels.md; edit there.
#pragma once

#include <Eigen/Core>

namespace thermoroll {

/// factor a b, four rows at a time.
Eigen::MatrixXd product(double factor, const Eigen::Ref<const Eigen::MatrixXd>& a,
                        const Eigen::Ref<const Eigen::MatrixXd>& b);

/// c += sign a b, four rows at a time.
void add_product(double sign, const Eigen::Ref<const Eigen::MatrixXd>& a,
                 const Eigen::Ref<const Eigen::MatrixXd>& b, Eigen::Ref<Eigen::MatrixXd> c);

}  // namespace thermoroll
