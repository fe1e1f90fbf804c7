// Fixed overlay of the map that does not move with it: scale bar, axes, legends, probe, focus ring.
#pragma once

#include <optional>

#include <QPainter>

#include "core/base/clock.h"
#include "widgets/map/height_layer.h"
#include "widgets/map/map_content.h"

namespace usar::widgets {

/// State that only the view has; neither content nor transform contain it.
struct MapOverlay {
    QString probe;        ///< as probeText() words it; empty while the cursor is not on the map
    QString following;    ///< name of the robot that the view follows; empty: none
    bool focused = false; ///< the map has the keyboard focus
};

/// "x 31.2   y −8.0   z 4.31 m   hits 7   12 s ago   by R1, R2": the ground at a point, in meters of the map frame;
/// nullopt: unknown height. `scanned_by` names the robots that know it, `age` is that of its newest scan on the
/// protocol clock; empty and nullopt: not told.
QString probeText(const Vec2& point_in_map_m, const std::optional<mapping::HeightProbe>& ground,
                  const QStringList& scanned_by = {}, std::optional<Seconds> age = std::nullopt);

/// Area around the axes that is dimmed, in pixels; labels stay out of it.
QRectF axesGlass_px(const MapTransform& transform);

/// Which legends are on the map.
struct Legends {
    bool heights = false;
    std::size_t mark_kinds = 0;  ///< number of rows
    bool corrected_path = false; ///< another row
    bool operator==(const Legends&) const = default;
};
Legends legendsOf(const MapContent& content, const HeightLayer& heights);
/// What a mission that begins will bring, as far as its layers are shown.
Legends legendsOfAMission(const MapContent& content);
/// The places of axes, scale bar and these legends in pixels, each in a corner. A legend that has no room in a small
/// view has an empty place and is not painted; the layers panel has it, too.
struct OverlayPlaces {
    QRectF axes;
    QRectF scale_bar;
    QRectF heights;
    QRectF marks;

    OverlayPlaces(const Legends& legends, const MapTransform& transform);
    /// Those that are not empty.
    std::vector<QRectF> all() const;
};

/// Where the chip with the probe is painted, in pixels.
QRectF probePlace(const QString& probe, const OverlayPlaces& places, const MapTransform& transform);

/// Paints what of the overlay lies in this part of the view, over all layers; leaves antialiasing on. GUI thread.
void paintOverlay(QPainter& painter, const MapOverlay& overlay, const MapContent& content, const HeightLayer& heights,
                  const MapTransform& transform, const QRectF& part_px);

} // namespace usar::widgets
