// Desk of the map: its commands and its layers.
#pragma once

#include "app/desks/desk.h"

namespace usar::app {

/// Handles what concerns only the view of the map: fitting, following the robot, zooming, and the visibility of layers.
/// GUI thread.
class MapDesk : public Desk {
    Q_OBJECT
public:
    using Desk::Desk;

    void registerCommands() override;
    void wire() override;
    void restore(const QSettings& settings) override;
    void save(QSettings& settings) const override;

private:
};

} // namespace usar::app
