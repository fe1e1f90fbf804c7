// The robots: which can be spawned where, the list of those that are there, and what the selected one says.
#pragma once

#include <QObject>

#include "app/desks/desk.h"
#include "app/views/robot_presenter.h"

namespace usar::app {

/// Spawns robots from the map's start poses, lists them, and brings updates to the views by way of its presenter. GUI
/// thread.
class RobotDesk : public QObject {
    Q_OBJECT
public:
    explicit RobotDesk(const DeskContext& context);

    void registerCommands();
    void wire();
    /// Lists the classes that can be spawned now.
    void listClasses();
    /// The row in the list and the arrow on the map, as they stand.
    void showRow(int id) { presenter_.showRow(id); }
    /// Sends TRACE for the selected robot, in the color that the palette shows.
    void trace(bool on);

private:
    void registerTraceCommands();
    void wireRobots();
    void wireSpawning();
    void wireMarks();
    void welcome(int id);
    void dismiss(int id, const QString& name, int instead);
    void spawn(const widgets::SpawnChoice& choice);
    void show(int id, const mission::SessionUpdate& update);
    void showTrace();
    void select(const QString& name);

    DeskContext desk_;
    RobotPresenter presenter_;
};

} // namespace usar::app
