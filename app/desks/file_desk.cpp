#include "app/desks/file_desk.h"

#include <QDesktopServices>
#include <QFileDialog>
#include <QFileInfo>
#include <QUrl>

namespace usar::app {

FileDesk::FileDesk(const DeskContext& context, ServerDesk& server, MissionDesk& mission, PlanWorkshop& workshop)
    : Desk(context)
    , server_(server)
    , mission_(mission)
    , workshop_(workshop) {}

void FileDesk::registerCommands() {
    add(
        "file.export", [this] { return selection_.id().valid(); }, [this] { control_.exportResults(selection_.id()); });
    add("file.folder", [this] { chooseResultFolder(); });
    add("file.show_folder", [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(control_.resultFolder())); });
}

void FileDesk::restore(const QSettings& settings) {
    control_.setResultFolder(settings.value("result_folder").toString());
}

void FileDesk::save(SettingsSheet& settings) const {
    if (control_.resultFolderChosen())
        settings.setValue("result_folder", control_.resultFolder());
}

QString FileDesk::fileIn(const QMimeData& data) {
    if (data.urls().size() != 1)
        return {};
    const QString path = data.urls().first().toLocalFile();
    static const QStringList known{"usarrec", "usarsnap", "json", "sdf", "lap"};
    return known.contains(QFileInfo(path).suffix()) || QFileInfo(path + "/world.sdf").isFile() ? path : QString();
}

void FileDesk::open(const QString& path) {
    const QFileInfo file(path);
    const bool is_world = file.isDir() || file.fileName() == "world.sdf";
    if (is_world && control_.anyRunning())
        return notices_.say(Severity::Warning, "simulator",
                            tr("A robot is on its mission. Stop it, then open another world."));
    if (path.endsWith(".usarsnap"))
        server_.openSnapshot(path);
    else if (path.endsWith(".usarrec"))
        control_.openRecording(path);
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
        QFileDialog::getExistingDirectory(window_, tr("Folder for results"), control_.resultFolder());
    if (folder.isEmpty())
        return false;
    control_.setResultFolder(folder);
    return true;
}

} // namespace usar::app
