#include "app/desks/file_desk.h"

#include <algorithm>

#include <QDesktopServices>
#include <QFileDialog>
#include <QFileInfo>
#include <QUrl>

namespace usar::app {

FileDesk::FileDesk(const DeskContext& context, ServerDesk& server, MissionDesk& mission, PlanWorkshop& workshop)
    : desk_(context)
    , server_(server)
    , mission_(mission)
    , workshop_(workshop) {}

void FileDesk::registerCommands() {
    desk_.commands.add(
        {"file.export",
         tr("Save results now"),
         tr("File"),
         tr("Picture, heights and raw data of the selected robot, at any time"),
         "export",
         {QKeySequence("Ctrl+E")}},
        [this](bool) { desk_.control.exportResults(desk_.selection.id()); },
        [this] { return desk_.selection.id() != 0; });
    desk_.commands.add({"file.folder", tr("Result folder…"), tr("File"), tr("Where results are saved"), "", {}},
                       [this](bool) { chooseResultFolder(); });
    desk_.commands.add({"file.show_folder", tr("Show results"), tr("File"), tr("Opens the result folder"), "", {}},
                       [this](bool) { QDesktopServices::openUrl(QUrl::fromLocalFile(desk_.control.resultFolder())); });
}

void FileDesk::wire() {
    connect(&desk_.control, &MissionControl::resultsWritten, this, [this](int, const QStringList& files) {
        desk_.notices.note("saved", tr("Saved %n file(s): %1", "", static_cast<int>(files.size())).arg(files.value(0)));
    });
}

void FileDesk::restore(const QSettings& settings) {
    desk_.control.setResultFolder(settings.value("result_folder").toString());
}

void FileDesk::save(QSettings& settings) const {
    if (desk_.control.resultFolderChosen())
        settings.setValue("result_folder", desk_.control.resultFolder());
}

QString FileDesk::fileIn(const QMimeData& data) {
    if (data.urls().size() != 1)
        return {};
    const QString path = data.urls().first().toLocalFile();
    const bool known = path.endsWith(".usarrec") || path.endsWith(".usarsnap") || path.endsWith(".json") ||
                       path.endsWith(".sdf") || path.endsWith(".lap") || QFileInfo(path + "/world.sdf").isFile();
    return known ? path : QString();
}

void FileDesk::open(const QString& path) {
    const QFileInfo file(path);
    const bool is_world = file.isDir() || file.fileName() == "world.sdf";
    const auto robots = desk_.control.robots();
    const bool flies = std::ranges::any_of(robots, [](const Robot* robot) { return robot->running(); });
    if (is_world && flies)
        return desk_.notices.say(Severity::Warning, "simulator",
                                 tr("A robot is on its mission. Stop it, then open another world."));
    if (path.endsWith(".usarsnap"))
        server_.openSnapshot(path);
    else if (path.endsWith(".usarrec"))
        desk_.control.openRecording(path);
    else if (is_world)
        server_.openWorld(file.isDir() ? path : file.absolutePath());
    else if (path.endsWith(".sdf"))
        server_.openRobotFile(path);
    else if (path.endsWith(".lap"))
        workshop_.openPlan(path);
    else
        mission_.openMission(path);
}

bool FileDesk::chooseResultFolder() {
    const QString folder =
        QFileDialog::getExistingDirectory(desk_.window, tr("Folder for results"), desk_.control.resultFolder());
    if (folder.isEmpty())
        return false;
    desk_.control.setResultFolder(folder);
    return true;
}

} // namespace usar::app
