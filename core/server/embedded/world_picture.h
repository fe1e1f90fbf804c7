// Facts about the embedded world that the window may show before anything is scanned.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <QImage>
#include <QString>
#include <QStringList>

#include "core/base/scenery.h"
#include "core/sim/world/world.h"

namespace usar::server {

/// A value that is passed from the simulator's thread to the GUI. Default-constructed for a real server, whose world is
/// not known.
struct WorldPicture {
    QString name;
    Rectangle extent_in_map;    ///< meters; empty: unknown
    double dry_above_m = 0.0;   ///< map z, see sim::dryAbove_m
    QImage relief;              ///< ground, water and buildings from above; row 0 = highest y
    QStringList robot_classes;  ///< classes that can be spawned there, without package
    QStringList camera_classes; ///< those of them that have a camera
    std::map<QString, std::vector<Outline>> robot_outlines{}; ///< footprints of the classes (sim::footprintOf)
    SceneryPtr scenery{};                                     ///< trees and buildings of `world`
    std::shared_ptr<const sim::World> world{};                ///< as it was at its start
    std::shared_ptr<const sim::Terrain> ground{};             ///< that of `world`
    std::map<QString, QString> objects{}; ///< classes of the objects that the world starts with, by object name

    /// Height of the ground by point, nullopt beside the terrain; an empty function without a terrain.
    std::function<std::optional<double>(const Vec2& point_in_map_m)> terrainHeight() const;
    /// A robot of this class can be spawned from now on; it may have been known before.
    void learn(const QString& class_name, bool has_camera, const std::vector<Outline>& outlines) {
        robot_outlines[class_name] = outlines;
        for (auto [classes, is_one] : {std::pair(&robot_classes, true), std::pair(&camera_classes, has_camera)}) {
            classes->removeAll(class_name);
            if (is_one)
                classes->append(class_name);
        }
    }
};

/// Describes a world and draws its relief, with 512 pixels on the longer side and without trees, which have a layer of
/// their own. The lists of classes stay empty; the caller fills them in.
WorldPicture pictureOf(const sim::World& world);

} // namespace usar::server
