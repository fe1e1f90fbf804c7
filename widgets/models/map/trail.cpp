#include "widgets/models/map/trail.h"

#include <algorithm>
#include <limits>

namespace usar::widgets {

namespace {

/// A longer straight stretch is split, so that adding a point never costs more than this many comparisons.
constexpr std::size_t longest_stretch = 256;

double distance_m(const Vec2& point, const Vec2& a, const Vec2& b) {
    const Vec2 along = b - a;
    const double square = along.squaredNorm();
    const double t = square > 0.0 ? std::clamp((point - a).dot(along) / square, 0.0, 1.0) : 0.0;
    return (point - a - t * along).norm();
}

} // namespace

bool Trail::pendingFit(const Vec2& end_m) const {
    const Vec2& start = points_m_[points_m_.size() - 2];
    return pending_m_.size() < longest_stretch && std::ranges::all_of(pending_m_, [&](const Vec2& point) {
               return distance_m(point, start, end_m) <= tolerance_m_;
           });
}

void Trail::add(const Vec2& point) {
    if (!point.allFinite() || (!points_m_.empty() && (point - points_m_.back()).norm() < tolerance_m_ / 2.0))
        return;
    if (!points_m_.empty() && (point - points_m_.back()).norm() > longest_step_m) {
        pending_m_.clear();
        points_m_.push_back(Vec2::Constant(std::numeric_limits<double>::quiet_NaN()));
        points_m_.push_back(point);
        return;
    }
    // The line from a gap passes no point within the tolerance, so the first point after it is kept.
    if (points_m_.size() < 2) {
        points_m_.push_back(point);
        return;
    }
    pending_m_.push_back(points_m_.back());
    if (pendingFit(point)) {
        points_m_.back() = point;
        return;
    }
    pending_m_.clear();
    points_m_.push_back(point);
}

void Trail::clear() {
    points_m_.clear();
    pending_m_.clear();
}

} // namespace usar::widgets
