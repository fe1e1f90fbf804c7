#include "core/mapping/strip_solver.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <Eigen/SparseCholesky>

#include "core/mapping/sparse_inverse.h"

namespace usar::mapping {

struct StripFactor {
    explicit StripFactor(const Eigen::SparseMatrix<double>& lower) : cholesky(lower) {}
    bool good() const { return cholesky.info() == Eigen::Success && cholesky.vectorD().minCoeff() > 0.0; }
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> cholesky;
};

namespace {

/// Rounding of the wire when the INS is set, and of the estimates.
constexpr double set_sigma_m = 0.02;
constexpr double least_step_m = 0.003;
constexpr double begin_sigma_rad = 0.02;
/// The robot corrects its yaw by its course, so the error does not grow without limit.
constexpr double yaw_sigma_rad = 0.1;
/// The INS's noise of a turn, as in the robot's own filter of its course: (1.1 degrees)^2 per right angle.
constexpr double turn_variance_rad = 2.4e-4;
constexpr double least_turn_rad = 0.004;
constexpr std::size_t unknowns = 4; ///< of a knot
constexpr int yaw_axis = 3;
/// Neighboring cells see the same things and err alike, so each counts less than one of its own.
constexpr double share_of_cell = 0.3;
/// How much wider the distribution is on a slope: part of the difference in height across a cell.
constexpr double share_of_slope = 0.3;
constexpr int rounds = 1;
/// Conjugate gradients: more steps than this cost more than a new factor, and fewer digits are lost than the heights
/// have.
constexpr int most_steps = 25;
constexpr double tolerance = 1e-6;

/// The four knots of an overlap, and what its equation has for the errors at each.
struct Equation {
    std::array<std::size_t, 4> knots{};
    std::array<KnotError, 4> factors;

    explicit Equation(const Overlap& overlap) {
        for (std::size_t look = 0; look < 2; ++look) {
            const double moment = look == 0 ? overlap.early : overlap.late;
            const Eigen::Vector2d arm_m = (look == 0 ? overlap.early_arm_m : overlap.late_arm_m).cast<double>();
            const Eigen::Vector2d slope = overlap.slope.cast<double>();
            KnotError factor(-slope.x(), -slope.y(), 1.0, slope.x() * arm_m.y() - slope.y() * arm_m.x());
            if (look == 1)
                factor = -factor;
            const auto knot = static_cast<std::size_t>(moment);
            const double part = moment - double(knot);
            knots[2 * look] = knot;
            knots[2 * look + 1] = knot + 1;
            factors[2 * look] = (1.0 - part) * factor;
            factors[2 * look + 1] = part * factor;
        }
    }
    /// What the errors say about the difference of the heights.
    double expected_m(const KnotErrors& errors) const {
        double sum_m = 0.0;
        for (std::size_t i = 0; i < 4; ++i)
            sum_m += factors[i].dot(errors[knots[i]]);
        return sum_m;
    }
};

Eigen::VectorXd flat(const KnotErrors& errors) {
    Eigen::VectorXd values(static_cast<Eigen::Index>(unknowns * errors.size()));
    for (std::size_t knot = 0; knot < errors.size(); ++knot)
        values.segment<unknowns>(static_cast<Eigen::Index>(unknowns * knot)) = errors[knot];
    return values;
}

/// Sorts by a number below `limit` that each overlap has, and leaves the order of those with the same one.
template <class Of>
std::vector<Overlap> sortedBy(const Of& of, std::span<const Overlap> overlaps, std::size_t limit) {
    std::vector<std::size_t> begins(limit + 1, 0);
    for (const Overlap& overlap : overlaps)
        ++begins[of(overlap) + 1];
    std::partial_sum(begins.begin(), begins.end(), begins.begin());
    std::vector<Overlap> sorted(overlaps.size());
    for (const Overlap& overlap : overlaps)
        sorted[begins[of(overlap)]++] = overlap;
    return sorted;
}

/// Overlaps of the same two intervals between knots follow one another.
std::vector<Overlap> grouped(std::span<const Overlap> overlaps, std::size_t knots) {
    const auto early = [](const Overlap& overlap) { return static_cast<std::size_t>(overlap.early); };
    const auto late = [](const Overlap& overlap) { return static_cast<std::size_t>(overlap.late); };
    return sortedBy(early, sortedBy(late, overlaps, knots), knots);
}

/// A sum that grows with each scan of a sortie, at the knots: interpolated over the moments. `of` is the sum at a scan,
/// `at_end` that at the end of the sortie.
template <class Of>
std::vector<double> sumsAt(const std::vector<Sortie>& sorties, std::span<const KeptScan* const> scans,
                           const KnotTimes& knots, const Of& of, const std::vector<double>& at_end) {
    std::vector<double> sums(knots.count(), 0.0);
    std::size_t next = 0;
    for (std::size_t sortie = 0; sortie < sorties.size(); ++sortie) {
        double moment = double(knots.first(sortie)), sum = 0.0;
        std::size_t knot = knots.first(sortie);
        const auto reach = [&](double to_moment, double to) {
            for (; knot < knots.first(sortie + 1) && double(knot) <= to_moment; ++knot)
                sums[knot] =
                    to_moment > moment ? sum + (to - sum) * (double(knot) - moment) / (to_moment - moment) : to;
            moment = to_moment;
            sum = to;
        };
        for (; next < scans.size() && scans[next]->sortie == sortie; ++next)
            reach(knots.moment(sortie, scans[next]->time), of(next));
        reach(knots.moment(sortie, sorties[sortie].end), at_end[sortie]);
        for (; knot < knots.first(sortie + 1); ++knot)
            sums[knot] = sum;
    }
    return sums;
}

/// The direction to the left of the scanner, whose yaw alone means nothing because it looks down.
double leftOf_rad(const KeptScan& scan) {
    return bearingOf(Vec3(scan.scanner_in_map.rotation() * Vec3::UnitY()).head<2>());
}

} // namespace

StripSolver::StripSolver(const std::vector<Sortie>& sorties, std::span<const KeptScan* const> scans,
                         const KnotTimes& knots)
    : knots_(knots.count())
    , prior_side_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(unknowns * knots_))) {
    addPrior(sorties, scans, knots);
}

void StripSolver::addPrior(const std::vector<Sortie>& sorties, std::span<const KeptScan* const> scans,
                           const KnotTimes& knots) {
    std::vector<double> walks_m2, turns_rad(sorties.size(), 0.0), turned_rad(scans.size(), 0.0);
    for (const Sortie& sortie : sorties)
        walks_m2.push_back(sortie.walk_m2);
    for (std::size_t i = 0; i < scans.size(); ++i) {
        if (i > 0 && scans[i - 1]->sortie == scans[i]->sortie)
            turned_rad[i] =
                turned_rad[i - 1] + std::abs(normalizedAngle(leftOf_rad(*scans[i]) - leftOf_rad(*scans[i - 1])));
        turns_rad[scans[i]->sortie] = turned_rad[i];
    }
    const auto walk_m2 = sumsAt(
        sorties, scans, knots, [&](std::size_t i) { return scans[i]->walk_m2; }, walks_m2);
    const auto turn_rad = sumsAt(
        sorties, scans, knots, [&](std::size_t i) { return turned_rad[i]; }, turns_rad);
    for (std::size_t sortie = 0; sortie < sorties.size(); ++sortie) {
        const std::size_t first = knots.first(sortie), last = knots.first(sortie + 1) - 1;
        const auto& closing_m = sorties[sortie].closing_error_m;
        for (int axis = 0; axis < 3; ++axis) {
            hold(first, axis, set_sigma_m, 0.0);
            if (closing_m)
                hold(last, axis, set_sigma_m, (*closing_m)[axis]);
            for (std::size_t knot = first; knot < last; ++knot)
                bind(knot, axis,
                     walk_share * walk_share * (walk_m2[knot + 1] - walk_m2[knot]) + least_step_m * least_step_m);
        }
        hold(first, yaw_axis, begin_sigma_rad, 0.0);
        for (std::size_t knot = first; knot <= last; ++knot)
            hold(knot, yaw_axis, yaw_sigma_rad, 0.0);
        for (std::size_t knot = first; knot < last; ++knot)
            bind(knot, yaw_axis,
                 turn_variance_rad * (turn_rad[knot + 1] - turn_rad[knot]) + least_turn_rad * least_turn_rad);
    }
}

void StripSolver::hold(std::size_t knot, int axis, double sigma, double value) {
    const double weight = 1.0 / (sigma * sigma);
    const int at = static_cast<int>(unknowns * knot) + axis;
    prior_.emplace_back(at, at, weight);
    prior_side_[at] += weight * value;
}

void StripSolver::bind(std::size_t knot, int axis, double variance) {
    const int at = static_cast<int>(unknowns * knot) + axis, next = at + static_cast<int>(unknowns);
    prior_.emplace_back(at, at, 1.0 / variance);
    prior_.emplace_back(next, next, 1.0 / variance);
    prior_.emplace_back(next, at, -1.0 / variance);
}

void StripSolver::assemble(std::span<const Overlap> overlaps, std::span<const double> weights,
                           std::span<const double> told_m) {
    constexpr int n = static_cast<int>(unknowns);
    std::vector<Eigen::Triplet<double>> entries = prior_;
    side_ = prior_side_;
    Eigen::Matrix<double, 4 * n, 4 * n> block = Eigen::Matrix<double, 4 * n, 4 * n>::Zero();
    Eigen::Matrix<double, 4 * n, 1> row;
    for (std::size_t i = 0; i < overlaps.size(); ++i) {
        const Equation equation(overlaps[i]);
        const double side = weights[i] * told_m[i];
        for (int k = 0; k < 4; ++k) {
            const auto knot = static_cast<std::size_t>(k);
            row.segment<n>(n * k) = equation.factors[knot];
            side_.segment<n>(n * static_cast<Eigen::Index>(equation.knots[knot])) += side * equation.factors[knot];
        }
        block.selfadjointView<Eigen::Lower>().rankUpdate(row, weights[i]);
        if (i + 1 < overlaps.size() && intervalsOf(overlaps[i + 1]) == intervalsOf(overlaps[i]))
            continue;
        // The later knots are higher, so the lower half of the block is in the lower half of the matrix.
        const auto at_row = [&](int r) {
            return n * static_cast<int>(equation.knots[static_cast<std::size_t>(r / n)]) + r % n;
        };
        for (int r = 0; r < 4 * n; ++r)
            for (int c = 0; c <= r; ++c)
                entries.emplace_back(at_row(r), at_row(c), block(r, c));
        block.setZero();
    }
    for (int knot = 0; knot < static_cast<int>(knots_); ++knot) // So that no block on the diagonal has gaps.
        for (int r = 1; r < n; ++r)
            for (int c = 0; c < r; ++c)
                entries.emplace_back(n * knot + r, n * knot + c, 0.0);
    const auto size = static_cast<Eigen::Index>(unknowns * knots_);
    normal_.resize(size, size);
    normal_.setFromTriplets(entries.begin(), entries.end());
}

KnotErrors StripSolver::solve(std::span<const Overlap> overlaps, const KnotErrors& at, double cell_size_m,
                              double width_m) {
    const std::vector<Overlap> sorted = grouped(overlaps, knots_);
    std::vector<double> weights(sorted.size()), told_m(sorted.size());
    for (std::size_t i = 0; i < sorted.size(); ++i)
        told_m[i] = double(sorted[i].difference_m) + Equation(sorted[i]).expected_m(at);
    KnotErrors errors = at;
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < sorted.size(); ++i) {
            const double left_m = told_m[i] - Equation(sorted[i]).expected_m(errors);
            const double sigma_m = std::hypot(width_m, share_of_slope * double(sorted[i].slope.norm()) * cell_size_m);
            const double ratio = left_m / sigma_m;
            weights[i] =
                share_of_cell * std::min(1.0, cell_size_m * cell_size_m) / (sigma_m * sigma_m * (1.0 + ratio * ratio));
        }
        assemble(sorted, weights, told_m);
        const Eigen::VectorXd solution = solved(flat(errors));
        if (solution.size() == 0)
            return at;
        for (std::size_t knot = 0; knot < knots_; ++knot)
            errors[knot] = solution.segment<unknowns>(static_cast<Eigen::Index>(unknowns * knot));
    }
    return errors;
}

/// Conjugate gradients (Hestenes and Stiefel, 1952), preconditioned with a factor of an earlier, similar matrix,
/// because a factor takes much longer than some steps. Empty if the matrix is not positive definite.
Eigen::VectorXd StripSolver::solved(const Eigen::VectorXd& guess) {
    if (factor_) {
        Eigen::VectorXd solution = guess;
        Eigen::VectorXd left = side_ - normal_.selfadjointView<Eigen::Lower>() * solution;
        Eigen::VectorXd step = factor_->cholesky.solve(left);
        double product = left.dot(step);
        const double goal = tolerance * tolerance * side_.squaredNorm();
        for (int i = 0; i < most_steps; ++i) {
            if (left.squaredNorm() <= goal)
                return solution;
            const Eigen::VectorXd image = normal_.selfadjointView<Eigen::Lower>() * step;
            const double length = product / step.dot(image);
            solution += length * step;
            left -= length * image;
            const Eigen::VectorXd next = factor_->cholesky.solve(left);
            const double next_product = left.dot(next);
            step = next + next_product / product * step;
            product = next_product;
        }
    }
    factor_ = std::make_shared<const StripFactor>(normal_);
    if (factor_->good())
        return factor_->cholesky.solve(side_);
    factor_.reset();
    return {};
}

std::vector<Eigen::Matrix4d> StripSolver::covariances() const {
    return diagonalBlocksOfInverse(normal_);
}

} // namespace usar::mapping
