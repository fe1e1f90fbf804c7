// Hit tests: the map's content under a point on the screen, and the tooltip for it.
#pragma once

#include <optional>

#include "widgets/map/map_content.h"
#include "widgets/models/map/map_transform.h"

namespace usar::widgets {

/// Answers for one moment; content and transform must outlive it. Points are in pixels of the screen.
class MapHits {
public:
    MapHits(const MapContent& content, const MapTransform& transform) : content_(content), transform_(transform) {}

    /// Index of the nearest start pose within reach of the point; nullopt also if their layer is hidden.
    std::optional<std::size_t> startPoseAt(const QPointF& point_px) const;
    /// True near the pose that was drawn for a robot to spawn.
    bool draftAt(const QPointF& point_px) const;
    /// Name of the nearest robot within reach; empty: none.
    QString robotAt(const QPointF& point_px) const;
    /// Name of the topmost object there, with a tolerance of a few pixels for small ones; empty: none, or their layer
    /// is hidden.
    QString objectAt(const QPointF& point_px) const;
    /// The handle or middle of the area; nullopt: neither, or there is no area.
    std::optional<AreaGrip> gripAt(const QPointF& point_px) const;
    /// A tree whose crown covers the point; nullptr: none, or their layer is hidden.
    const SceneryTree* treeAt(const QPointF& point_px) const;
    /// Describes the robot, start pose, object or tree there for the user, in this order; empty: none of them.
    QString toolTipAt(const QPointF& point_px) const;

private:
    const MapContent& content_;
    const MapTransform& transform_;
};

} // namespace usar::widgets
