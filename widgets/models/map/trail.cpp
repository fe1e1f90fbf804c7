#include "widgets/models/map/trail.h"

#include <algorithm>
#include <limits>

namespace usar::widgets {

namespace {

/// A longer straight stretch is split, so that adding a point never costs more than this many comparisons.
constexpr std::size_t longest_stretch = 256;

/// A difference in height counts a quarter.
double lengthOf_m(const Vec3& way) {
    return Vec3(way.x(), way.y(), way.z() / 4.0).norm();
}

double distance_m(const Vec3& point, const Vec3& a, const Vec3& b) {
    const Vec3 along = b - a;
    const double square = along.squaredNorm();
    const double t = square > 0.0 ? std::clamp((point - a).dot(along) / square, 0.0, 1.0) : 0.0;
    return lengthOf_m(point - a - t * along);
}

} // namespace

Vec3 Trail::pointAt(std::size_t index) const {
    return {points_m_[index].x(), points_m_[index].y(), heights_m_[index]};
}

void Trail::keep(const Vec3& point) {
    points_m_.emplace_back(point.head<2>());
    heights_m_.push_back(point.z());
}

bool Trail::pendingFit(const Vec3& end_m) const {
    const Vec3 start = pointAt(points_m_.size() - 2);
    return pending_m_.size() < longest_stretch && std::ranges::all_of(pending_m_, [&](const Vec3& point) {
               return distance_m(point, start, end_m) <= tolerance_m_;
           });
}

void Trail::add(const Vec3& point) {
    if (!point.allFinite())
        return;
    const double step_m = points_m_.empty() ? 0.0 : lengthOf_m(point - pointAt(points_m_.size() - 1));
    if (!points_m_.empty() && step_m < tolerance_m_ / 2.0)
        return;
    if (step_m > longest_step_m) {
        pending_m_.clear();
        keep(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
        keep(point);
        return;
    }
    // The line from a gap passes no point within the tolerance, so the first point after it is kept.
    if (points_m_.size() < 2) {
        keep(point);
        return;
    }
    pending_m_.push_back(pointAt(points_m_.size() - 1));
    if (pendingFit(point)) {
        points_m_.back() = point.head<2>();
        heights_m_.back() = point.z();
        return;
    }
    pending_m_.clear();
    keep(point);
}

void Trail::clear() {
    points_m_.clear();
    heights_m_.clear();
    pending_m_.clear();
}

} // namespace usar::widgets
