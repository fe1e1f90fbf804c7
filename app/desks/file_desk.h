// Files of the window: results and where they go, and what is opened by its name.
#pragma once

#include <QMimeData>
#include <QObject>
#include <QSettings>

#include "app/desks/desk.h"
#include "app/desks/mission_desk.h"
#include "app/desks/plan_workshop.h"
#include "app/desks/server_desk.h"

namespace usar::app {

/// Knows which desk opens which kind of file. GUI thread.
class FileDesk : public QObject {
    Q_OBJECT
public:
    FileDesk(const DeskContext& context, ServerDesk& server, MissionDesk& mission, PlanWorkshop& workshop);

    void registerCommands();
    void wire();
    void restore(const QSettings& settings);
    void save(QSettings& settings) const;

    /// The one file of ours that is dragged; empty if it is none, or if there are several.
    static QString fileIn(const QMimeData& data);
    /// A mission, a plan, a recording, a snapshot, a world's folder or a robot file.
    void open(const QString& path);
    /// False if the user chose none.
    bool chooseResultFolder();

private:
    DeskContext desk_;
    ServerDesk& server_;
    MissionDesk& mission_;
    PlanWorkshop& workshop_;
};

} // namespace usar::app
