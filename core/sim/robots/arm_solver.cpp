#include "core/sim/robots/arm_solver.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace usar::sim {

namespace {

constexpr int most_steps = 200;
constexpr int other_postures = 24;
constexpr double arm_length_m = 0.5; ///< a turn of 1 rad weighs as much as this way
constexpr double good_enough_m = 1e-5;

/// Van der Corput's sequence: numbers in 0..1 that fill the range evenly.
double spread(int number, int base) {
    double value = 0.0;
    for (double share = 1.0 / base; number > 0; number /= base, share /= base)
        value += share * (number % base);
    return value;
}

constexpr std::array primes{2, 3, 5, 7, 11, 13, 17};

} // namespace

ArmSolver::ArmSolver(const RobotModel& model, const PackageModel& package) : model_(model) {
    for (const std::string& joint : package.joints)
        links_.push_back(static_cast<std::size_t>(model.linkOnJoint(joint).value_or(0)));
    const std::size_t last = links_.back();
    const Vec3 pivot_in_link_m = model.body.links[last].pivot_in_link_m + model.links[last].center_of_mass_in_link_m;
    tip_in_body_m_ = package.tip_in_last_link_m.value_or(pivot_in_link_m) - model.links[last].center_of_mass_in_link_m;
}

/// Frames of bodies have their origins in the centers of mass.
Eigen::Isometry3d ArmSolver::linkInBase(int link, const std::vector<double>& all) const {
    if (link < 0)
        return Eigen::Isometry3d(Eigen::Translation3d(model_.center_of_mass_in_base_m));
    const LinkDescription& part = model_.body.links[static_cast<std::size_t>(link)];
    const double position = all[static_cast<std::size_t>(link)];
    const Eigen::Isometry3d joint_at_0 = linkInBase(part.parent, all) * part.link_in_parent.isometry();
    if (part.kind == JointKind::Prismatic)
        return joint_at_0 * Eigen::Translation3d(position * part.axis_in_link);
    return joint_at_0 * Eigen::Translation3d(part.pivot_in_link_m) * Eigen::AngleAxisd(position, part.axis_in_link) *
           Eigen::Translation3d(-part.pivot_in_link_m);
}

Eigen::Isometry3d ArmSolver::tipInBase(const std::vector<double>& all) const {
    return linkInBase(static_cast<int>(links_.back()), all) * Eigen::Translation3d(tip_in_body_m_);
}

Eigen::VectorXd ArmSolver::errorAt(const TipTarget& target, const std::vector<double>& all) const {
    const Eigen::Isometry3d tip = tipInBase(all);
    Eigen::VectorXd error(target.rotation_in_base ? 6 : 3);
    error.head<3>() = target.position_in_base_m - tip.translation();
    if (target.rotation_in_base) {
        const Eigen::AngleAxisd missing(target.rotation_in_base->toRotationMatrix() * tip.linear().transpose());
        error.tail<3>() = arm_length_m * missing.angle() * missing.axis();
    }
    return error;
}

Eigen::MatrixXd ArmSolver::slopesAt(const TipTarget& target, const std::vector<double>& all) const {
    const Vec3 tip_m = tipInBase(all).translation();
    Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(target.rotation_in_base ? 6 : 3, static_cast<int>(links_.size()));
    for (std::size_t i = 0; i < links_.size(); ++i) {
        const auto column = static_cast<Eigen::Index>(i);
        const LinkDescription& part = model_.body.links[links_[i]];
        const Eigen::Isometry3d link = linkInBase(static_cast<int>(links_[i]), all);
        const Vec3 axis = link.linear() * part.axis_in_link;
        if (part.kind == JointKind::Prismatic) {
            slopes.col(column).head<3>() = axis;
            continue;
        }
        slopes.col(column).head<3>() = axis.cross(tip_m - link * part.pivot_in_link_m);
        if (target.rotation_in_base)
            slopes.col(column).tail<3>() = arm_length_m * axis;
    }
    return slopes;
}

void ArmSolver::limit(std::vector<double>& all) const {
    for (const std::size_t link : links_) {
        const LinkDescription& part = model_.body.links[link];
        if (part.lower <= part.upper)
            all[link] = std::clamp(all[link], part.lower, part.upper);
    }
}

void ArmSolver::descend(const TipTarget& target, std::vector<double>& all) const {
    double damping = 0.05;
    Eigen::VectorXd error = errorAt(target, all);
    for (int step = 0; step < most_steps && error.norm() > good_enough_m && damping < 1e6; ++step) {
        const Eigen::MatrixXd slopes = slopesAt(target, all);
        Eigen::MatrixXd damped = slopes.transpose() * slopes;
        damped.diagonal().array() += damping * damping;
        const Eigen::VectorXd turn = damped.ldlt().solve(slopes.transpose() * error);
        std::vector<double> next = all;
        for (std::size_t i = 0; i < links_.size(); ++i)
            next[links_[i]] += turn[static_cast<Eigen::Index>(i)];
        limit(next);
        const Eigen::VectorXd next_error = errorAt(target, next);
        if (next_error.norm() < error.norm()) {
            all = std::move(next);
            error = next_error;
            damping *= 0.3;
        } else {
            damping *= 3.0;
        }
    }
}

ArmSolution ArmSolver::solutionAt(const TipTarget& target, const std::vector<double>& all) const {
    ArmSolution solution;
    for (const std::size_t link : links_)
        solution.positions.push_back(all[link]);
    const Eigen::VectorXd error = errorAt(target, all);
    solution.off_m = error.head<3>().norm();
    if (target.rotation_in_base)
        solution.off_rad = error.tail<3>().norm() / arm_length_m;
    return solution;
}

ArmSolution ArmSolver::solve(const TipTarget& target, const std::vector<double>& all) const {
    const auto badness = [](const ArmSolution& one) { return one.off_m + arm_length_m * one.off_rad; };
    ArmSolution best;
    for (int posture = 0; posture <= other_postures; ++posture) {
        std::vector<double> tried = all;
        for (std::size_t i = 0; posture > 0 && i < links_.size(); ++i) {
            const LinkDescription& part = model_.body.links[links_[i]];
            const bool limited = part.lower <= part.upper;
            const double low = limited ? part.lower : -pi;
            const double high = limited ? part.upper : pi;
            tried[links_[i]] = low + (high - low) * spread(posture, primes[i % primes.size()]);
        }
        limit(tried);
        descend(target, tried);
        const ArmSolution solution = solutionAt(target, tried);
        if (posture == 0 || badness(solution) < badness(best))
            best = solution;
        if (best.reached())
            break;
    }
    return best;
}

} // namespace usar::sim
