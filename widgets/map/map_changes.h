// Which part of the map must be painted again while the view stands still: where what moves was, and where it is now.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include <QRegion>

#include "widgets/map/height_layer.h"
#include "widgets/map/map_content.h"
#include "widgets/map/map_labels.h"
#include "widgets/map/map_overlay.h"

namespace usar::widgets {

/// Remembers where robots, their names, goals, hits, trails and marks were painted, and figures of the overlay. Whoever
/// changes anything else repaints the whole view. GUI thread.
class MapChanges {
public:
    /// A part of the ground looks different, in meters of the map frame.
    void touch(const Rectangle& ground_in_map) { touched_in_map_.push_back(ground_in_map); }
    /// Takes the content as painted. Returns the pixels that look different since the last call, or
    /// nullopt where all may.
    std::optional<QRegion> take(const MapContent& content, const HeightLayer& heights, const MapOverlay& overlay,
                                const MapTransform& transform);
    /// Where the names of the content that was taken last are painted.
    const MapLabels& labels() const { return painted_.labels; }

private:
    /// Something that moves, or whose picture changes.
    struct Sprite {
        QRectF place_px;
        std::vector<double> state; ///< all that its picture depends on
        bool operator==(const Sprite&) const = default;
    };
    struct Frame {
        MapTransform transform;
        Legends legends;
        MapLabels labels;
        std::vector<Sprite> sprites;
        std::map<QString, std::size_t> trail_points; ///< by robot
        std::map<QString, std::size_t> marks;        ///< by robot

        void add(const QRectF& place_px, std::vector<double> state);
        void addRobot(const RobotOnMap& on_map, bool selected, const Frame& before);
        void addMarks(const MapContent& content, const Frame& before);
        void addLabels(const MapContent& content);
        void addRadio(const MapContent& content);
        void addOverlay(const MapContent& content, const HeightLayer& heights, const MapOverlay& overlay);
    };

    Frame painted_;
    std::vector<Rectangle> touched_in_map_;
};

/// The region as rectangles that are apart from each other; where two would touch, one rectangle stands around both.
std::vector<QRect> apart(const QRegion& region);

} // namespace usar::widgets
