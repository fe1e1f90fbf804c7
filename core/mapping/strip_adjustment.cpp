#include "core/mapping/strip_adjustment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/base/numbers.h"
#include "core/mapping/strip_hold.h"

namespace usar::mapping {

namespace {

constexpr std::array<StripLevel, 9> levels{
    {{2.0, 0.5}, {2.0, 0.5}, {1.0, 0.4}, {1.0, 0.25}, {1.0, 0.25}, {0.5, 0.15}, {0.5, 0.1}, {0.5, 0.1}, {0.5, 0.1}}};
/// The correction must explain differences of so much (root mean square). A path without any drift has smaller ones,
/// because of the noise of the ranges and because two looks at a cell hit different places in it.
constexpr double least_gain_m = 0.08;

} // namespace

StripAdjustment::StripAdjustment(const ScanStore& store, std::size_t scan_count, std::vector<Sortie> sorties)
    : store_(&store)
    , sorties_(std::move(sorties))
    , scan_count_(scan_count)
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
    if (store_->exact())
        return decline("The robot knew where it was, so its path has no errors.");
    std::vector<const KeptScan*> scans;
    for (std::size_t i = 0; i < scan_count_; ++i)
        if (const KeptScan& scan = store_->scans()[i];
            Vec3(scan.scanner_in_map.position_m).allFinite() && scan.scanner_in_map.rotation().coeffs().allFinite())
            scans.push_back(&scan);
    hits_ = StripHits(scans, knots_);
    solver_.emplace(sorties_, scans, knots_);
}

StripResidual StripAdjustment::residualWith(const KnotErrors& errors) const {
    return StripResidual(hits_.overlaps(finest_m_, errors));
}

void StripAdjustment::look() {
    const KnotErrors none(knots_.count(), KnotError::Zero());
    finest_m_ = hits_.finest_m();
    residual_ = residualWith(none);
    result_.overlaps = residual_.overlaps();
    result_.residual_before_m = residual_.all_m();
    errors_ = bridged_ = solver_->solve({}, none, finest_m_, finest_m_);
    bridged_covariances_ = solver_->covariances();
    residual_bridged_ = residualWith(bridged_);
    if (std::max(residual_.overlaps(), residual_bridged_.overlaps()) < fewest_overlaps)
        bridgeOrDecline("Hardly any ground was seen twice, half a minute apart.");
}

void StripAdjustment::refine() {
    const StripLevel& level = levels[next_ - 3];
    const double cell_size_m = std::max(level.cell_size_m, finest_m_);
    errors_ = solver_->solve(hits_.overlaps(cell_size_m, errors_), errors_, cell_size_m, level.width_m);
}

void StripAdjustment::judge() {
    const std::vector<Eigen::Matrix4d> covariances = solver_->covariances();
    const Eigen::Vector2d held = holdOf(covariances, bridged_covariances_);
    if (held.x() < least_hold)
        return bridgeOrDecline("The ground is too flat to tell where a strip lies.");
    const StripResidual residual = residualWith(errors_);
    const bool overlapped = residual_.overlaps() >= fewest_overlaps; // Else only the bridged path has overlaps.
    const auto compared_m = StripResidual::compared_m(overlapped ? residual_ : residual_bridged_, residual);
    const auto with_bridged_m = StripResidual::compared_m(residual_bridged_, residual);
    if (!compared_m || !(std::hypot(compared_m->second, least_gain_m) <= compared_m->first) ||
        (with_bridged_m && with_bridged_m->second > with_bridged_m->first))
        return bridgeOrDecline("The heights where strips overlap do not agree much better with a corrected path.");
    accept(AdjustmentVerdict::Adjusted, errors_, residual, covariances);
    std::tie(result_.residual_before_m, result_.residual_after_m) = *compared_m;
    result_.reason = "The heights where strips overlap differ by " + fixed(compared_m->second, 2) + " m instead of " +
                     fixed(compared_m->first, 2) + (overlapped ? " m." : " m with the landings alone.");
    if (held.y() < least_hold)
        result_.reason += " The ground holds one horizontal direction only.";
}

void StripAdjustment::bridgeOrDecline(const std::string& reason) {
    bool known = false; // An end of a flight without scans would correct nothing.
    for (std::size_t i = 0; i < std::min(scan_count_, store_->scans().size()); ++i)
        known = known || sorties_[store_->scans()[i].sortie].closing_error_m.has_value();
    decline(reason);
    const auto compared_m = StripResidual::compared_m(residual_, residual_bridged_);
    if (!known || (compared_m && compared_m->second > compared_m->first))
        return;
    accept(AdjustmentVerdict::Bridged, bridged_, residual_bridged_, bridged_covariances_);
    result_.reason = reason + " The path was corrected only by what the settings of the INS have shown.";
}

void StripAdjustment::accept(AdjustmentVerdict verdict, const KnotErrors& errors, const StripResidual& residual,
                             const std::vector<Eigen::Matrix4d>& covariances) {
    result_.verdict = verdict;
    result_.residual_after_m = residual.all_m();
    if (const auto compared_m = StripResidual::compared_m(residual_, residual))
        std::tie(result_.residual_before_m, result_.residual_after_m) = *compared_m;
    result_.correction.sorties.resize(sorties_.size());
    for (std::size_t sortie = 0; sortie < sorties_.size(); ++sortie)
        for (std::size_t knot = knots_.first(sortie); knot < knots_.first(sortie + 1); ++knot)
            result_.correction.sorties[sortie].push_back(
                {knots_.time(sortie, knot), errors[knot].head<3>(),
                 covariances[knot].diagonal().head<3>().cwiseMax(0.0).cwiseSqrt(), errors[knot].w()});
}

} // namespace usar::mapping
