// Desk for files: saves results, chooses their folder, and opens files of every kind.
#pragma once

#include <QMimeData>

#include "app/desks/desk.h"
#include "app/desks/mission_desk.h"
#include "app/desks/plan_workshop.h"
#include "app/desks/server_desk.h"

namespace usar::app {

/// Passes each kind of file to the desk that opens it. The folder for results is kept in the settings if the user has
/// chosen one. GUI thread.
class FileDesk : public Desk {
    Q_OBJECT
public:
    FileDesk(const DeskContext& context, ServerDesk& server, MissionDesk& mission, PlanWorkshop& workshop);

    void registerCommands() override;
    void restore(const QSettings& settings) override;
    void save(SettingsSheet& settings) const override;

    /// Path of the file that is dragged, if it is a single one that `open` can open; otherwise empty.
    static QString fileIn(const QMimeData& data);
    /// Opens a mission, plan, recording, snapshot, robot file or world (its folder or its world.sdf). Problems are
    /// notices.
    void open(const QString& path);
    /// Lets the user choose the folder for results; returns false if the user cancels.
    bool chooseResultFolder();

private:
    ServerDesk& server_;
    MissionDesk& mission_;
    PlanWorkshop& workshop_;
};

} // namespace usar::app
