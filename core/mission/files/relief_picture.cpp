#include "core/mission/files/relief_picture.h"

#include <cstring>
#include <limits>
#include <span>
#include <vector>

#include "core/agent/mark_style.h"
#include "core/mapping/relief/relief_scene.h"
#include "core/mission/files/map_picture.h"

namespace usar::mission {

namespace {

constexpr int relief_width_px = 1600;
constexpr int relief_height_px = 1000;
constexpr std::uint32_t sky_color = 0xff5b6779;
constexpr std::uint32_t area_color = 0xff78dcff;
constexpr std::uint32_t edge_color = 0xff101418;

std::uint32_t colorOf(agent::MarkKind kind) {
    return 0xff000000u | agent::styleOf(kind).rgb;
}

/// The path with a point of NaN wherever it jumps.
std::vector<Vec3> pathWithGaps(const std::vector<Vec3>& path_m) {
    std::vector<Vec3> with_gaps_m;
    with_gaps_m.reserve(path_m.size());
    for (const Vec3& point_m : path_m) {
        if (!with_gaps_m.empty() && (point_m - with_gaps_m.back()).norm() > mapping::longest_trail_step_m)
            with_gaps_m.push_back(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
        with_gaps_m.push_back(point_m);
    }
    return with_gaps_m;
}

/// A request to stop leaves the rest out.
mapping::ReliefScene sceneOf(const ScanRecord& record, const mapping::HeightLook& look, const std::stop_token& stop) {
    mapping::ReliefScene scene;
    const mapping::ReliefStyle style{colorRange(record.raster, look), look.color_map, 0.0};
    scene.surface = mapping::reliefOf(record.raster, style, mapping::most_relief_cells, stop);
    if (stop.stop_requested())
        return scene;
    scene.sky = sky_color;
    scene.ground = unknown_color;
    scene.camera.yaw_rad = radians(135.0);
    scene.lines.push_back({mapping::aboveSurface(scene.surface, pathWithGaps(record.path_m)),
                           colorOf(agent::MarkKind::Path), edge_color, 2});
    scene.camera = scene.camera.showing(mapping::pointsToShow(scene, std::span(&record.area_in_map, 1)),
                                        double(relief_width_px) / relief_height_px);
    scene.lines.insert(scene.lines.begin(), {mapping::outlineOnSurface(scene.surface, record.area_in_map), area_color,
                                             edge_color, 2}); // The path is drawn over it.
    for (const agent::MapMark& mark : record.marks)
        if (mark.kind != agent::MarkKind::Path && mark.position_in_map_m.allFinite())
            scene.bodies.push_back(mapping::markBody(mark.position_in_map_m, colorOf(mark.kind), 16));
    return scene;
}

} // namespace

QImage reliefPicture(const ScanRecord& record, const mapping::HeightLook& look, const std::stop_token& stop) {
    if (record.raster.empty())
        return {};
    const mapping::ReliefPicture drawn =
        mapping::drawnRelief(sceneOf(record, look, stop), relief_width_px, relief_height_px, stop);
    if (drawn.empty())
        return {};
    QImage image(drawn.width_px, drawn.height_px, QImage::Format_RGB32);
    for (int row = 0; row < drawn.height_px; ++row)
        std::memcpy(image.scanLine(row), &drawn.argb[drawn.indexOf(0, row)], std::size_t(drawn.width_px) * 4);
    for (const auto& [key, value] : metadataOf(record))
        image.setText(key, value);
    image.setText("seen_from", "south-east");
    return image;
}

} // namespace usar::mission
