#include "core/server/embedded/world_picture.h"

#include <algorithm>
#include <cmath>

#include <QPainter>

namespace usar::server {

namespace {

constexpr int longer_side_px = 512;
const QColor floor_color(150, 150, 150);
const QColor water_color(40, 90, 140);
const QColor building_color(105, 95, 88);
const QColor building_edge(60, 54, 50);

/// Brightness of the ground, 0..255, under a light from +x and +y (upper right in the picture), 45 degrees high.
int reliefShade(const sim::Terrain& terrain, const Vec2& point_m, double step_m) {
    const double slope_x = (terrain.height_m(point_m + Vec2(step_m, 0)) - terrain.height_m(point_m)) / step_m;
    const double slope_y = (terrain.height_m(point_m + Vec2(0, step_m)) - terrain.height_m(point_m)) / step_m;
    const Vec3 normal = Vec3(-slope_x, -slope_y, 1.0).normalized();
    const Vec3 light = Vec3(1.0, 1.0, 1.4).normalized();
    return static_cast<int>(std::lround(255.0 * std::max(0.0, normal.dot(light))));
}

/// Color of water of this depth; the bed, with brightness `shade`, shines through shallow water.
QRgb underWater(int shade, double depth_m) {
    const double clear = 0.55 * std::exp(-depth_m / 6.0);
    const auto mixed = [&](int color) { return static_cast<int>(clear * shade + (1.0 - clear) * color); };
    return qRgb(mixed(water_color.red()), mixed(water_color.green()), mixed(water_color.blue()));
}

void paintGround(QImage& image, const sim::World& world, const Rectangle& extent) {
    const Vec2 cell_m(extent.width_m() / image.width(), extent.height_m() / image.height());
    for (int row = 0; row < image.height(); ++row) {
        auto* const line = reinterpret_cast<QRgb*>(image.scanLine(row));
        for (int column = 0; column < image.width(); ++column) {
            const Vec2 point_m(extent.min_m.x() + (column + 0.5) * cell_m.x(),
                               extent.max_m.y() - (row + 0.5) * cell_m.y());
            const int shade = reliefShade(world.terrain, point_m, cell_m.x());
            const double depth_m = world.water ? world.water->surface_z_m - world.terrain.height_m(point_m) : -1.0;
            line[column] = depth_m > 0.0 ? underWater(shade, depth_m) : qRgb(shade, shade, shade);
        }
    }
}

/// Floors and ceilings cover most of the world and would hide everything in it.
bool isBuilding(const sim::Box& box, const Rectangle& extent) {
    return box.size_m.x() * box.size_m.y() <= 0.5 * extent.area_m2();
}

SceneryPtr sceneryOf(const sim::World& world, const Rectangle& extent) {
    auto scenery = std::make_shared<Scenery>();
    for (const sim::Plant& plant : world.plants)
        scenery->trees.push_back({plant.base_in_map_m.head<2>(),
                                  plant.trunk_height_m > 0.0 ? plant.trunk_radius_m : 0.0, plant.crown_radius_m});
    for (const sim::Box& box : world.boxes)
        if (isBuilding(box, extent))
            scenery->buildings.push_back(outlineOfBox(box.center_in_map, box.size_m));
    return scenery;
}

void paintBuildings(QImage& image, const sim::World& world, const Rectangle& extent) {
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(image.width() / extent.width_m(), -image.height() / extent.height_m());
    painter.translate(-extent.min_m.x(), -extent.max_m.y());
    QPen edge(building_edge, 1.0);
    edge.setCosmetic(true);
    painter.setPen(edge);
    painter.setBrush(building_color);
    for (const sim::Box& box : world.boxes) {
        if (!isBuilding(box, extent))
            continue;
        painter.save();
        painter.translate(box.center_in_map.position_m.x(), box.center_in_map.position_m.y());
        painter.rotate(degrees(box.center_in_map.yaw_rad));
        painter.drawRect(QRectF(-box.size_m.x() / 2.0, -box.size_m.y() / 2.0, box.size_m.x(), box.size_m.y()));
        painter.restore();
    }
}

} // namespace

std::function<std::optional<double>(const Vec2&)> WorldPicture::terrainHeight() const {
    if (!ground || ground->empty())
        return {};
    return [terrain = ground](const Vec2& point_m) {
        return terrain->extent().contains(point_m) ? std::optional(terrain->height_m(point_m)) : std::nullopt;
    };
}

WorldPicture pictureOf(const sim::World& world) {
    WorldPicture picture;
    picture.name = QString::fromStdString(world.name);
    picture.extent_in_map = sim::extentOf(world);
    picture.dry_above_m = sim::dryAbove_m(world);
    picture.world = std::make_shared<const sim::World>(world);
    picture.ground = {picture.world, &picture.world->terrain};
    for (const sim::WorldObject& object : world.objects)
        picture.objects[QString::fromStdString(object.name)] = QString::fromStdString(object.class_name);
    const Rectangle& extent = picture.extent_in_map;
    picture.scenery = sceneryOf(world, extent);
    if (extent.empty())
        return picture;
    const double pixels_per_m = longer_side_px / std::max(extent.width_m(), extent.height_m());
    const auto pixels = [&](double length_m) {
        return std::max(1, static_cast<int>(std::lround(length_m * pixels_per_m)));
    };
    picture.relief = QImage(pixels(extent.width_m()), pixels(extent.height_m()), QImage::Format_RGB32);
    picture.relief.fill(floor_color);
    if (!world.terrain.empty())
        paintGround(picture.relief, world, extent);
    paintBuildings(picture.relief, world, extent);
    return picture;
}

} // namespace usar::server
