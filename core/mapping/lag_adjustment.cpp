#include "core/mapping/lag_adjustment.h"

#include <algorithm>
#include <array>
#include <functional>

#include "core/mapping/strip_hold.h"
#include "core/mapping/strip_residual.h"

namespace usar::mapping {

namespace {

/// The errors have grown only a little since the last pass, so it begins with smaller cells than an adjustment of all
/// strips.
constexpr std::array<StripLevel, 4> lag_levels{{{1.0, 0.4}, {1.0, 0.25}, {0.5, 0.15}, {0.5, 0.1}}};
/// More than StripAdjustment asks for, because earlier scans that are taken as placed rightly although they were not
/// make slopes on flat ground.
constexpr double least_hold_in_flight = 0.6;
/// Nearer in time, two scans have the same error, so that their overlap says nothing (StripHits).
constexpr Seconds apart{25.0};
/// More earlier scans would make a pass longer than it is worth; those that are taken are spread over all.
constexpr std::size_t most_earlier_scans = 1500;
/// Two scanners that look 25 m to the side see the same ground up to twice as far from each other.
constexpr double near_m = 50.0;
/// The time of the earlier scans, which is as good as any; their sortie is so long that no look spans two.
constexpr Sortie earlier{.begin = Seconds{0.0}, .end = Seconds{30.0}};

bool isFinite(const KeptScan& scan) {
    return Vec3(scan.scanner_in_map.position_m).allFinite() && scan.scanner_in_map.rotation().coeffs().allFinite();
}

} // namespace

void LagAdjustment::take(const PathCorrection& correction) {
    correction_ = correction;
    pass_.reset();
}

PathKnot LagAdjustment::newest() const {
    if (store_->sorties().empty())
        return {};
    const Sortie& flown = store_->sorties().back();
    return correction_.at(store_->sorties().size() - 1, flown.end);
}

bool LagAdjustment::step() {
    if (store_->overfull()) // The scans are gone, and with them the numbers of the sorties.
        *this = LagAdjustment(*store_);
    if (!pass_ && !begin())
        return false;
    const std::size_t now = pass_->next++;
    if (now == 0) {
        gather();
    } else if (now == 1) {
        prepare();
    } else if (now - 2 < lag_levels.size()) {
        const StripLevel& level = lag_levels[now - 2];
        const double cell_size_m = std::max(level.cell_size_m, pass_->hits.finest_m());
        pass_->errors = pass_->solver->solve(pass_->hits.overlaps(cell_size_m, pass_->errors), pass_->errors,
                                             cell_size_m, level.width_m);
    } else {
        conclude();
        pass_.reset();
    }
    return true;
}

bool LagAdjustment::begin() {
    if (store_->overfull() || store_->exact() || store_->sorties().empty())
        return false;
    const Sortie& flown = store_->sorties().back();
    if (last_ && flown.end >= *last_ && flown.end - *last_ < interval)
        return false;
    last_ = flown.end;
    if (store_->scans().empty() || store_->scans().back().sortie + 1 != store_->sorties().size())
        return false; // Nothing was scanned since the INS was set.
    pass_.emplace();
    pass_->sortie = store_->sorties().size() - 1;
    pass_->from = std::max(flown.begin, flown.end - lag);
    pass_->known = correction_.at(pass_->sortie, pass_->from);
    return true;
}

void LagAdjustment::gather() {
    const auto& scans = store_->scans();
    const auto inside = [&](const KeptScan& scan) { return scan.sortie == pass_->sortie && scan.time >= pass_->from; };
    const auto first = std::ranges::find_if(scans.rbegin(), scans.rend(), std::not_fn(inside)).base();
    Rectangle path{Vec2::Constant(1e9), Vec2::Constant(-1e9)};
    for (auto scan = first; scan != scans.end(); ++scan) {
        const Vec2 at_m = scan->scanner_in_map.position_m.head<2>();
        path.min_m = path.min_m.cwiseMin(at_m - Vec2::Constant(near_m));
        path.max_m = path.max_m.cwiseMax(at_m + Vec2::Constant(near_m));
    }
    const auto counts = [&](const KeptScan& scan) {
        return path.contains(scan.scanner_in_map.position_m.head<2>()) &&
               (scan.sortie != pass_->sortie || scan.time < pass_->from - apart) && isFinite(scan);
    };
    const auto count = static_cast<std::size_t>(std::count_if(scans.begin(), first, counts));
    const std::size_t stride = count / most_earlier_scans + 1;
    std::size_t at = 0;
    for (auto scan = scans.begin(); scan != first; ++scan)
        if (counts(*scan) && at++ % stride == 0) {
            pass_->scans.push_back(*scan);
            pass_->scans.back().scanner_in_map = correction_.corrected(*scan);
            pass_->scans.back().sortie = 0;
            pass_->scans.back().time = earlier.begin;
            pass_->scans.back().walk_m2 = 0.0;
        }
    const double walk_m2 = first == scans.end() ? 0.0 : first->walk_m2;
    for (auto scan = first; scan != scans.end(); ++scan)
        if (isFinite(*scan)) {
            pass_->scans.push_back(*scan);
            pass_->scans.back().scanner_in_map = pass_->known.corrected(scan->scanner_in_map);
            pass_->scans.back().sortie = 1;
            pass_->scans.back().walk_m2 -= walk_m2;
        }
    const Sortie& flown = store_->sorties()[pass_->sortie];
    pass_->sorties = {earlier, {.begin = pass_->from, .end = flown.end, .walk_m2 = flown.walk_m2 - walk_m2}};
}

void LagAdjustment::prepare() {
    std::vector<const KeptScan*> scans;
    for (const KeptScan& scan : pass_->scans)
        scans.push_back(&scan);
    const KnotTimes& knots = pass_->knots.emplace(pass_->sorties);
    pass_->hits = StripHits(scans, knots);
    StripSolver& solver = pass_->solver.emplace(pass_->sorties, scans, knots);
    pass_->before.assign(knots.count(), KnotError::Zero());
    for (std::size_t knot = knots.first(1); knot < knots.count(); ++knot) {
        const PathKnot was = correction_.at(pass_->sortie, knots.time(1, knot));
        pass_->before[knot].head<3>() = was.error_m - pass_->known.error_m;
        pass_->before[knot].w() = was.yaw_error_rad - pass_->known.yaw_error_rad;
    }
    const double finest_m = pass_->hits.finest_m();
    solver.solve({}, pass_->before, finest_m, finest_m);
    pass_->free_covariances = solver.covariances();
    pass_->errors = pass_->before;
}

bool LagAdjustment::isBetter() const {
    const double finest_m = pass_->hits.finest_m();
    const StripResidual before(pass_->hits.overlaps(finest_m, pass_->before));
    const StripResidual after(pass_->hits.overlaps(finest_m, pass_->errors));
    if (std::min(before.overlaps(), after.overlaps()) < fewest_overlaps)
        return false;
    const auto compared_m = StripResidual::compared_m(before, after);
    return compared_m && compared_m->second <= compared_m->first &&
           holdOf(pass_->solver->covariances(), pass_->free_covariances).x() >= least_hold_in_flight;
}

void LagAdjustment::conclude() {
    if (pass_->sortie + 1 != store_->sorties().size() || !isBetter()) // It may have landed meanwhile.
        return;
    const std::vector<Eigen::Matrix4d> covariances = pass_->solver->covariances();
    correction_.sorties.resize(std::max(correction_.sorties.size(), pass_->sortie + 1));
    std::vector<PathKnot>& path = correction_.sorties[pass_->sortie];
    std::erase_if(path, [&](const PathKnot& knot) { return knot.time >= pass_->from; });
    for (std::size_t knot = pass_->knots->first(1); knot < pass_->knots->count(); ++knot) {
        const KnotError& error = pass_->errors[knot];
        path.push_back({pass_->knots->time(1, knot), pass_->known.error_m + error.head<3>(),
                        covariances[knot].diagonal().head<3>().cwiseMax(0.0).cwiseSqrt(),
                        pass_->known.yaw_error_rad + error.w()});
    }
}

} // namespace usar::mapping
