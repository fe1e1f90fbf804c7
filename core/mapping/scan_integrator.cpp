#include "core/mapping/scan_integrator.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace usar::mapping {

namespace {

/// Fills cells between the hits of one scan.
class Filler {
public:
    Filler(HeightMap& map, LineNumber line, double gap_limit_m)
        : map_(map)
        , line_(line)
        , height_limit_m_(gap_limit_m)
        , ground_limit_m_(std::max(gap_limit_m, 2.0 * map.cellSize_m()))
        , step_m_(0.5 * map.cellSize_m())
        , surely_one_step_m2_(step_m_ * step_m_ * (1.0 - 1e-9)) {}

    /// True if two hits are near enough to be joined; false if one of them is NaN.
    bool near(const Vec3& a_m, const Vec3& b_m) const {
        const Vec3 step_m = b_m - a_m;
        return std::abs(step_m.z()) <= height_limit_m_ &&
               step_m.head<2>().squaredNorm() <= ground_limit_m_ * ground_limit_m_;
    }

    /// Number of steps of at most half a cell, so that only cells can be skipped that the line hardly touches.
    int stepsBetween(const Vec3& a_m, const Vec3& b_m) const { return stepsFor((b_m - a_m).head<2>().squaredNorm()); }

    /// Fills the cells between a and b, each with the height of the line at the point nearest to the cell's center.
    void join(const Vec3& a_m, const Vec3& b_m) const {
        const Vec2 along_m = (b_m - a_m).head<2>();
        const double along_m2 = along_m.squaredNorm();
        const int steps = stepsFor(along_m2);
        std::optional<GridIndex> last;
        for (int i = 1; i < steps; ++i) {
            const GridIndex cell = map_.cellAt(a_m.head<2>() + along_m * (double(i) / steps));
            if (cell == last)
                continue;
            last = cell;
            const Vec2 from_a_m = map_.center_m(cell) - a_m.head<2>();
            const double part = std::clamp(from_a_m.dot(along_m) / along_m2, 0.0, 1.0);
            map_.fill(cell, static_cast<float>(a_m.z() + part * (b_m.z() - a_m.z())), line_);
        }
    }

    /// Fills the cells inside the quadrangle of the hits of two neighboring beams in two consecutive scans.
    void joinInside(const Vec3& old_a_m, const Vec3& old_b_m, const Vec3& new_a_m, const Vec3& new_b_m) const {
        const int steps = std::max(stepsBetween(old_a_m, old_b_m), stepsBetween(new_a_m, new_b_m));
        for (int i = 1; i < steps; ++i) {
            const double part = double(i) / steps;
            join(old_a_m + part * (old_b_m - old_a_m), new_a_m + part * (new_b_m - new_a_m));
        }
    }

private:
    /// Most neighbors are so near that no root is needed.
    int stepsFor(double length_m2) const {
        return length_m2 < surely_one_step_m2_ ? 1 : static_cast<int>(std::ceil(std::sqrt(length_m2) / step_m_));
    }

    HeightMap& map_;
    LineNumber line_;
    double height_limit_m_;
    double ground_limit_m_;
    double step_m_;
    double surely_one_step_m2_;
};

} // namespace

void ScanIntegrator::integrate(const Beams& beams, const Pose& scanner_in_map, LineNumber line, HeightMap& map) {
    std::swap(hits_, previous_hits_);
    if (strip_broken_)
        previous_hits_.clear();
    strip_broken_ = false;
    finder_.find(beams, scanner_in_map, hits_);
    for (const Vec3& hit_m : hits_)
        if (hit_m.allFinite())
            map.write(map.cellAt(hit_m.head<2>()), static_cast<float>(hit_m.z()), line);

    const Filler filler(map, line, gap_limit_m_);
    const bool continues = previous_hits_.size() == hits_.size();
    bool joined_scans_at_k = continues && !hits_.empty() && filler.near(previous_hits_[0], hits_[0]);
    if (joined_scans_at_k)
        filler.join(previous_hits_[0], hits_[0]);
    for (std::size_t k = 0; k + 1 < hits_.size(); ++k) {
        const bool joined_beams = filler.near(hits_[k], hits_[k + 1]);
        if (joined_beams)
            filler.join(hits_[k], hits_[k + 1]);
        if (!continues)
            continue;
        const bool joined_scans_at_next = filler.near(previous_hits_[k + 1], hits_[k + 1]);
        if (joined_scans_at_next)
            filler.join(previous_hits_[k + 1], hits_[k + 1]);
        if (joined_beams && joined_scans_at_k && joined_scans_at_next &&
            filler.near(previous_hits_[k], previous_hits_[k + 1]))
            filler.joinInside(previous_hits_[k], previous_hits_[k + 1], hits_[k], hits_[k + 1]);
        joined_scans_at_k = joined_scans_at_next;
    }
}

} // namespace usar::mapping
