#include "core/mapping/strip_adjustment.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "core/base/numbers.h"

namespace usar::mapping {

namespace {

/// A grid and the width of the distribution of the differences in height on it.
struct Level {
    double cell_size_m;
    double width_m;
};
constexpr std::array<Level, 5> levels{{{2.0, 0.5}, {1.0, 0.4}, {1.0, 0.25}, {0.5, 0.15}, {0.5, 0.1}}};
constexpr double finest_m = 0.5;
constexpr std::size_t fewest_overlaps = 200;
constexpr double most_counted_m = 1.0;
/// The correction must explain differences of so much (root mean square). A path without any drift has smaller ones,
/// because of the noise of the ranges and because two looks at a cell hit different places in it.
constexpr double least_gain_m = 0.08;
/// The overlaps must explain this share of the variance of the path along a horizontal direction.
constexpr double least_hold = 0.3;

Eigen::Matrix2d meanOf(const std::vector<Eigen::Matrix4d>& covariances) {
    Eigen::Matrix2d sum_m2 = Eigen::Matrix2d::Zero();
    for (const Eigen::Matrix4d& covariance : covariances)
        sum_m2 += covariance.topLeftCorner<2, 2>();
    return sum_m2 / double(covariances.size());
}

/// The shares of the variance that the overlaps explain, along the horizontal direction in which it is most, and
/// across; zero if a covariance could not be computed.
Eigen::Vector2d holdOf(const std::vector<Eigen::Matrix4d>& with_m2, const std::vector<Eigen::Matrix4d>& without_m2) {
    if (with_m2.empty() || without_m2.empty())
        return Eigen::Vector2d::Zero();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(meanOf(with_m2));
    return Eigen::Vector2d::Ones() - axes.eigenvalues() / meanOf(without_m2)(0, 0);
}

} // namespace

StripAdjustment::StripAdjustment(const ScanStore& store)
    : store_(&store)
    , sorties_(store.sorties())
    , scan_count_(store.scans().size())
    , knots_(sorties_) {}

bool StripAdjustment::step() {
    const std::size_t now = next_++;
    if (now == 0)
        begin();
    else if (now == 1)
        look();
    else if (now - 2 < levels.size())
        refine();
    else if (now - 2 == levels.size())
        judge();
    return next_ <= levels.size() + 2;
}

void StripAdjustment::decline(const std::string& reason) {
    result_.verdict = AdjustmentVerdict::Declined;
    result_.reason = reason;
    result_.residual_after_m = result_.residual_before_m;
    next_ = levels.size() + 3;
}

void StripAdjustment::begin() {
    if (store_->overfull())
        return decline("The flight was too long for all its scans to be kept.");
    if (scan_count_ == 0)
        return decline("There are no scans.");
    std::vector<const KeptScan*> scans;
    for (std::size_t i = 0; i < scan_count_; ++i)
        if (const KeptScan& scan = store_->scans()[i];
            Vec3(scan.scanner_in_map.position_m).allFinite() && scan.scanner_in_map.rotation().coeffs().allFinite())
            scans.push_back(&scan);
    hits_ = StripHits(scans, knots_);
    solver_.emplace(sorties_, scans, knots_);
}

void StripAdjustment::look() {
    const std::vector<Overlap> overlaps = hits_.overlaps(finest_m, KnotErrors(knots_.count(), KnotError::Zero()));
    result_.overlaps = overlaps.size();
    result_.residual_before_m = residual_m(overlaps);
    errors_ = bridged_ = solver_->solve({}, KnotErrors(knots_.count(), KnotError::Zero()), finest_m, finest_m);
    bridged_covariances_ = solver_->covariances();
    residual_bridged_m_ = residual_m(hits_.overlaps(finest_m, errors_));
    if (overlaps.size() < fewest_overlaps)
        bridgeOrDecline("Hardly any ground was seen twice, half a minute apart.");
}

void StripAdjustment::refine() {
    const Level& level = levels[next_ - 3];
    const std::vector<Overlap> overlaps = hits_.overlaps(level.cell_size_m, errors_);
    errors_ = solver_->solve(overlaps, errors_, level.cell_size_m, level.width_m);
}

void StripAdjustment::judge() {
    const std::vector<Eigen::Matrix4d> covariances = solver_->covariances();
    const Eigen::Vector2d held = holdOf(covariances, bridged_covariances_);
    if (held.x() < least_hold)
        return bridgeOrDecline("The ground is too flat to tell where a strip lies.");
    const auto residual = residual_m(hits_.overlaps(finest_m, errors_));
    const double before_m = *result_.residual_before_m;
    if (!residual || before_m * before_m - *residual * *residual < least_gain_m * least_gain_m ||
        (residual_bridged_m_ && *residual > *residual_bridged_m_))
        return bridgeOrDecline("The heights where strips overlap do not agree much better with a corrected path.");
    accept(AdjustmentVerdict::Adjusted, errors_, residual, covariances);
    result_.reason = "The heights where strips overlap differ by " + fixed(*residual, 2) + " m instead of " +
                     fixed(*result_.residual_before_m, 2) + " m.";
    if (held.y() < least_hold)
        result_.reason += " The ground holds one horizontal direction only.";
}

void StripAdjustment::bridgeOrDecline(const std::string& reason) {
    bool known = false; // An end of a flight without scans would correct nothing.
    for (std::size_t i = 0; i < std::min(scan_count_, store_->scans().size()); ++i)
        known = known || sorties_[store_->scans()[i].sortie].closing_error_m.has_value();
    decline(reason);
    const auto& before_m = result_.residual_before_m; // Strips may overlap only where the path is bridged.
    if (!known || (residual_bridged_m_ && before_m && *residual_bridged_m_ > *before_m))
        return;
    accept(AdjustmentVerdict::Bridged, bridged_, residual_bridged_m_, bridged_covariances_);
    result_.reason = reason + " The path was corrected only by what the settings of the INS have shown.";
}

void StripAdjustment::accept(AdjustmentVerdict verdict, const KnotErrors& errors, std::optional<double> residual_m,
                             const std::vector<Eigen::Matrix4d>& covariances) {
    result_.verdict = verdict;
    result_.residual_after_m = residual_m;
    result_.correction.sorties.resize(sorties_.size());
    for (std::size_t sortie = 0; sortie < sorties_.size(); ++sortie)
        for (std::size_t knot = knots_.first(sortie); knot < knots_.first(sortie + 1); ++knot)
            result_.correction.sorties[sortie].push_back(
                {knots_.time(sortie, knot), errors[knot].head<3>(),
                 covariances[knot].diagonal().head<3>().cwiseMax(0.0).cwiseSqrt(), errors[knot].w()});
}

std::optional<double> StripAdjustment::residual_m(const std::vector<Overlap>& overlaps) {
    if (overlaps.empty())
        return std::nullopt;
    double sum_m2 = 0.0;
    for (const Overlap& overlap : overlaps) {
        const double counted_m = std::min(std::abs(double(overlap.difference_m)), most_counted_m);
        sum_m2 += counted_m * counted_m;
    }
    return std::sqrt(sum_m2 / double(overlaps.size()));
}

} // namespace usar::mapping
