#include "core/mapping/strip_hold.h"

#include <Eigen/Eigenvalues>

namespace usar::mapping {

namespace {

Eigen::Matrix2d meanOf(const std::vector<Eigen::Matrix4d>& covariances) {
    Eigen::Matrix2d sum_m2 = Eigen::Matrix2d::Zero();
    for (const Eigen::Matrix4d& covariance : covariances)
        sum_m2 += covariance.topLeftCorner<2, 2>();
    return sum_m2 / double(covariances.size());
}

} // namespace

Eigen::Vector2d holdOf(const std::vector<Eigen::Matrix4d>& with, const std::vector<Eigen::Matrix4d>& without) {
    if (with.empty() || without.empty())
        return Eigen::Vector2d::Zero();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(meanOf(with));
    return Eigen::Vector2d::Ones() - axes.eigenvalues() / meanOf(without)(0, 0);
}

} // namespace usar::mapping
