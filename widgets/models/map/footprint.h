// The ground that a robot covers, true to scale, as the map draws it.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <QPainterPath>
#include <QString>

#include "core/base/outline.h"

namespace usar::widgets {

/// The outline of a robot seen from above, made once and shared by all robots of a class.
struct Footprint {
    /// In meters around the origin of the base, which points up: x to the right, y down, as on a screen.
    QPainterPath shape;
    double length_m = 0.0; ///< longer side of its bounding box; above 0
    double reach_m = 0.0;  ///< distance from the origin to its farthest point
};
using FootprintPtr = std::shared_ptr<const Footprint>;

/// The union of these outlines, in the frame of the base; nullptr if they cover nothing.
FootprintPtr footprintOf(const std::vector<Outline>& outlines_in_base);

/// The footprints of all robots that were asked for. A plain value.
class Footprints {
public:
    /// The outlines of its robot file, if `known` has the class, whose package does not matter; else a rectangle of the
    /// dimensions that it told by GEO (length, width, height in meters); else nullptr, because nothing is known.
    FootprintPtr of(const QString& class_name, const std::map<QString, std::vector<Outline>>& known,
                    const std::optional<Vec3>& told_dimensions_m);

private:
    struct Made {
        std::vector<Outline> from;
        FootprintPtr footprint;
    };
    std::map<QString, Made> made_; ///< by class and, where it was told, by size
};

} // namespace usar::widgets
