// The lowest layers of the map as one picture: the world with its relief, the grid, and the trees and buildings. They
// change only when the view moves, so frames in between copy pixels.
#pragma once

#include <optional>

#include <QImage>
#include <QPainter>

#include "widgets/map/map_content.h"
#include "widgets/models/map/map_transform.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

/// Keeps the picture of the last frame. GUI thread.
class GroundPicture {
public:
    /// Paints the background of the whole viewport, and those of the layers that are visible. Makes the picture again
    /// if anything that it shows has changed since the last call. Trees and buildings lie below the height map, which
    /// shows what was scanned of them; objects that can be moved are painted above it, by MapPainter.
    void paint(QPainter& painter, const MapContent& content, const MapTransform& transform);
    /// How often the picture was made.
    int times_made() const { return times_made_; }

private:
    /// All that the picture depends on.
    struct Shown {
        MapTransform transform;
        std::optional<Rectangle> world_in_map;
        QString world_name;
        qint64 background = 0; ///< QImage::cacheKey
        Rectangle background_in_map;
        LayerState world;
        LayerState grid;
        SceneryPtr scenery;
        LayerState objects;
        Theme theme;
        double pixel_ratio;
        bool operator==(const Shown&) const = default;
    };

    std::optional<Shown> shown_;
    QImage picture_;
    int times_made_ = 0;
};

} // namespace usar::widgets
