// The map's own commands and its layers.
#pragma once

#include <QObject>
#include <QSettings>

#include "app/desks/desk.h"

namespace usar::app {

/// What can be done with the map itself: fit, follow, zoom, and show or hide layers. GUI thread.
class MapDesk : public QObject {
    Q_OBJECT
public:
    explicit MapDesk(const DeskContext& context) : desk_(context) {}

    void registerCommands();
    /// Once commands are registered.
    void wire();
    void restore(const QSettings& settings);
    void save(QSettings& settings) const;

private:
    DeskContext desk_;
};

} // namespace usar::app
