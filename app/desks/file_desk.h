// Desk for files: saves results, chooses their folder, and opens files of every kind.
#pragma once

#include <functional>

#include <QMenu>
#include <QMimeData>
#include <QPointer>

#include "app/desks/desk.h"
#include "app/desks/mission_desk.h"
#include "app/desks/plan_workshop.h"
#include "app/desks/server_desk.h"
#include "core/mission/files/recent_files.h"
#include "core/mission/fleet/recording_export.h"
#include "widgets/panels/export_dialog.h"

namespace usar::app {

/// Passes each kind of file to the desk that opens it. The files that were used last are kept in the settings, and so
/// are the folder for results if the user has chosen one, and the formats of exports. GUI thread.
class FileDesk : public Desk {
    Q_OBJECT
public:
    /// `keeps_folder`: the settings hold the folder for results; otherwise the command line names it.
    FileDesk(const DeskContext& context, ServerDesk& server, MissionDesk& mission, PlanWorkshop& workshop,
             bool keeps_folder);

    void registerCommands() override;
    void wire() override;
    void restore(const QSettings& settings) override;
    void save(SettingsSheet& settings) const override;

    /// Path of the file that is dragged, if it is a single one that `open` can open; otherwise empty.
    static QString fileIn(const QMimeData& data);
    /// Opens a mission, plan, recording, snapshot, robot file or world (its folder or its world.sdf). Problems are
    /// notices.
    void open(const QString& path);
    /// Replays a recording, which first carries out this order, and offers it again later.
    void openRecording(const QString& path, const mission::ReplayOrder& first = {});
    /// Lists the files that were used last in `menu`, each time that it is shown.
    void fillRecentMenu(QMenu* menu);
    /// Lets the user choose the folder for results, and calls `then`, if any, when it is chosen.
    void chooseResultFolder(const std::function<void()>& then);

private:
    /// Asks for formats and a folder, and exports the map of the robot that is selected now.
    void askForExport();
    void exportMap(const QStringList& ids);

    /// File with the recording of the selected robot: that of a replay, or that which is being written; empty: none.
    QString selectedRecording() const;
    /// Asks for a file, and exports the recording of the robot that is selected now.
    void askForRecordingExport();
    void recordingExported(const QString& file, const QString& complaint);

    /// For the palette: the missions that come with the program, and the other files that were used last.
    std::vector<widgets::PaletteOffer> files();

    /// Shows what is being written, results or else a recording.
    void showSaving();
    /// Gives up what is shown.
    void cancelSaving();

    ServerDesk& server_;
    MissionDesk& mission_;
    PlanWorkshop& workshop_;
    mission::RecentFiles recent_;
    bool keeps_folder_;
    QPointer<widgets::ExportDialog> export_dialog_; ///< null until it is wanted
    RobotId exported_;                              ///< whose map the dialog is about
    QString export_folder_;                         ///< chosen in the dialog; empty: that of the results
    QStringList export_formats_{"tif"};             ///< ids of those that were exported last
    QString saved_robot_;                           ///< whose results are being written; empty: nobody's
    mission::RecordingExport recording_export_;
};

} // namespace usar::app
