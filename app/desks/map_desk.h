// Desk of the map: its commands and its layers.
#pragma once

#include <QObject>
#include <QSettings>

#include "app/desks/desk.h"

namespace usar::app {

/// Handles what concerns only the view of the map: fitting, following the robot, zooming, and the visibility of layers.
/// GUI thread.
class MapDesk : public QObject {
    Q_OBJECT
public:
    explicit MapDesk(const DeskContext& context) : desk_(context) {}

    void registerCommands();
    /// To be called after all commands are registered.
    void wire();
    void restore(const QSettings& settings);
    void save(QSettings& settings) const;

private:
    DeskContext desk_;
};

} // namespace usar::app
