// Least squares for the errors of a path at its knots.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <Eigen/SparseCore>

#include "core/mapping/strip_overlaps.h"

namespace usar::mapping {

struct StripFactor;

/// A grid, and the width of the distribution of the differences in height on it: coarse first, then finer.
struct StripLevel {
    double cell_size_m;
    double width_m;
};

/// The unknowns are the errors of x, y, z and yaw at each knot. What is known before any overlap:
/// - The error is zero at the beginning of a sortie, and at its end what the setting of the INS has shown.
/// - In between it is a random walk with a standard deviation of `walk_share` of each step.
/// - The error of the yaw is some hundredths of a rad, and changes mostly when the robot turns.
/// An overlap says that early height minus late height is the difference of the two errors in z, minus the slope times
/// the difference of the two errors in x and y, to which a yaw adds its product with the arm from the scanner. A plain
/// value.
class StripSolver {
public:
    static constexpr double walk_share = 0.05; ///< robots-and-worlds.md 4.4

    StripSolver(const std::vector<Sortie>& sorties, std::span<const KeptScan* const> scans, const KnotTimes& knots);

    /// The most likely errors, given overlaps on a grid of cells of `cell_size_m` that were found at `at`.
    /// Differences have a Cauchy distribution of the width `width_m`, wider on slopes.
    /// Without overlaps, the errors of a sortie whose end is known are on the straight line, over the walk, from zero
    /// to the end's.
    KnotErrors solve(std::span<const Overlap> overlaps, const KnotErrors& at, double cell_size_m, double width_m);
    /// Covariance of x, y, z and yaw at each knot of the last solution, in m² and rad².
    std::vector<Eigen::Matrix4d> covariances() const;

private:
    using Sparse = Eigen::SparseMatrix<double>;

    void addPrior(const std::vector<Sortie>& sorties, std::span<const KeptScan* const> scans, const KnotTimes& knots);
    /// Holds an error at a knot near a value.
    void hold(std::size_t knot, int axis, double sigma, double value);
    /// Holds the change of an error from a knot to the next one near zero.
    void bind(std::size_t knot, int axis, double variance);
    Eigen::VectorXd solved(const Eigen::VectorXd& guess);
    /// `told_m`: the difference of the two errors, along the height, that each overlap tells.
    void assemble(std::span<const Overlap> overlaps, std::span<const double> weights, std::span<const double> told_m);

    std::size_t knots_;
    std::vector<Eigen::Triplet<double>> prior_; ///< the lower half
    Eigen::VectorXd prior_side_;
    Sparse normal_; ///< the lower half
    Eigen::VectorXd side_;
    std::shared_ptr<const StripFactor> factor_; ///< of an earlier `normal_`, good enough as a preconditioner
};

} // namespace usar::mapping
