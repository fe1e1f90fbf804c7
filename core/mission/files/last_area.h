// The area that was drawn last, as the settings keep it.
#pragma once

#include <cmath>

#include <QSettings>

#include "core/base/geometry.h"
#include "core/mission/files/settings_sheet.h"

namespace usar::mission {

/// It is brought back in the world that it was drawn in. A plain value.
struct LastArea {
    QString world;         ///< name of the world
    Rectangle area_in_map; ///< meters; empty: none

    /// An area of which one figure cannot be read is none, because an edge would move.
    static LastArea from(const QSettings& settings) {
        bool all_good = true;
        const auto meters = [&](const char* key) {
            bool good = false;
            const double value_m = settings.value(key).toDouble(&good);
            all_good = all_good && good && std::isfinite(value_m);
            return value_m;
        };
        const Rectangle area{{meters("area/min_x_m"), meters("area/min_y_m")},
                             {meters("area/max_x_m"), meters("area/max_y_m")}};
        return {settings.value("area/world").toString(), all_good ? area : Rectangle{}};
    }
    void save(SettingsSheet& settings) const {
        settings.setValue("area/world", world);
        settings.setValue("area/min_x_m", area_in_map.min_m.x());
        settings.setValue("area/min_y_m", area_in_map.min_m.y());
        settings.setValue("area/max_x_m", area_in_map.max_m.x());
        settings.setValue("area/max_y_m", area_in_map.max_m.y());
    }
};

} // namespace usar::mission
