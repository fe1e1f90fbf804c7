// What the window may show of the embedded world before anything is scanned.
#pragma once

#include <map>
#include <memory>

#include <QImage>
#include <QString>
#include <QStringList>

#include "core/base/geometry.h"
#include "core/sim/world/world.h"

namespace usar::server {

struct WorldPicture {
    QString name;
    Rectangle extent_in_map;
    QImage relief;              ///< ground, water and buildings from above; row 0 = highest y
    QStringList robot_classes;  ///< that can be spawned there, without package
    QStringList camera_classes; ///< those that have a camera
    std::shared_ptr<const sim::Terrain> ground{};
    std::map<QString, QString> objects{}; ///< that it begins with: their classes, by name
};

/// Without trees, for they are what a robot should find. Classes are left to whoever knows them.
WorldPicture pictureOf(const sim::World& world);

} // namespace usar::server
