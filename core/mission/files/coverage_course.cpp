#include "core/mission/files/coverage_course.h"

namespace usar::mission {

void CoverageCourse::add(const CoveragePoint& point) {
    points_.push_back(point);
    if (points_.size() > most) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < points_.size(); i += 2)
            points_[kept++] = points_[i];
        points_.resize(kept);
        pause_ *= 2.0;
    }
    next_ = point.elapsed + pause_;
}

} // namespace usar::mission
