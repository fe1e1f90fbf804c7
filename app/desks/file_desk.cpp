#include "app/desks/file_desk.h"

#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QUrl>

#include "core/mission/files/map_formats.h"
#include "core/mission/fleet/robot_words.h"
#include "core/server/embedded/program_files.h"
#include "widgets/panels/compare_dialog.h"
#include "widgets/panels/dialogs.h"

namespace usar::app {

FileDesk::FileDesk(const DeskContext& context, ServerDesk& server, MissionDesk& mission, PlanWorkshop& workshop,
                   bool keeps_folder)
    : Desk(context)
    , server_(server)
    , mission_(mission)
    , workshop_(workshop)
    , keeps_folder_(keeps_folder) {}

void FileDesk::registerCommands() {
    add(
        "file.export", [this] { return selection_.id().valid(); }, [this] { control_.exportResults(selection_.id()); });
    add(
        "file.export_map", [this] { return selection_.id().valid(); }, [this] { askForExport(); });
    add(
        "file.export_recording", [this] { return !selectedRecording().isEmpty(); },
        [this] { askForRecordingExport(); });
    add(
        "file.cancel_saving", [this] { return !saved_robot_.isEmpty() || recording_export_.busy(); },
        [this] { cancelSaving(); });
    commands_.offer([this] { return files(); });
    add("file.folder", [this] { chooseResultFolder({}); });
    add("file.compare", [this] { widgets::compareRuns(window_, control_.resultFolder()); });
    add("file.show_folder", [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(control_.resultFolder())); });
}

std::vector<widgets::PaletteOffer> FileDesk::files() {
    std::vector<widgets::PaletteOffer> offers;
    const QDir shipped(server::missionsFolder());
    for (const QFileInfo& file : shipped.entryInfoList({"*.json"}, QDir::Files, QDir::Name)) {
        QString name = file.completeBaseName();
        offers.push_back({tr("Open mission %1").arg(name.replace('_', ' ')),
                          tr("File"),
                          {file.completeBaseName(), "load", "example", "shipped"},
                          [this, path = file.absoluteFilePath()] { open(path); }});
    }
    for (const QString& path : recent_.existing())
        if (const QFileInfo file(path); file.dir() != shipped)
            offers.push_back({tr("Open %1").arg(file.fileName()), tr("File"), {"recent", "last", "load"}, [this, path] {
                                  open(path);
                              }});
    return offers;
}

void FileDesk::wire() {
    const auto remember = [this](const QString& path) { recent_.add(path); };
    connect(&mission_, &MissionDesk::fileUsed, this, remember);
    connect(&workshop_, &PlanWorkshop::fileUsed, this, remember);
    connect(&server_, &ServerDesk::snapshotUsed, this, remember);
    connect(&control_, &MissionControl::savingChanged, this, [this](const QString& robot_name) {
        saved_robot_ = robot_name;
        showSaving();
    });
    connect(&control_, &MissionControl::mapExported, this, [this](const QStringList& files, const QString& name) {
        notices_.note("map_exported/" + name, mission::exportedText(name, files));
    });
    connect(views_.saving, &widgets::ProgressStrip::cancelRequested, this, &FileDesk::cancelSaving);
    connect(&recording_export_, &mission::RecordingExport::done, this, &FileDesk::recordingExported);
    connect(&recording_export_, &mission::RecordingExport::refused, this,
            [this](const QString& reason, bool cancelled) {
                notices_.say(cancelled ? Severity::Note : Severity::Error, "recording_export", reason);
                showSaving();
            });
    connect(&recording_export_, &mission::RecordingExport::progressed, this, [this](Seconds done, Seconds whole) {
        if (saved_robot_.isEmpty())
            views_.saving->setProgress(done, whole);
    });
}

void FileDesk::showSaving() {
    if (!saved_robot_.isEmpty())
        views_.saving->begin(tr("Saving what %1 has scanned").arg(saved_robot_));
    else if (recording_export_.busy())
        views_.saving->begin(tr("Exporting the recording"));
    else
        views_.saving->end();
    commands_.refresh();
}

void FileDesk::cancelSaving() {
    if (!saved_robot_.isEmpty())
        control_.cancelSaving();
    else
        recording_export_.cancel();
}

void FileDesk::restore(const QSettings& settings) {
    recent_.restore(settings.value("recent_files").toStringList());
    export_formats_ = settings.value("export_formats", export_formats_).toStringList();
    if (keeps_folder_)
        control_.setResultFolder(settings.value("result_folder").toString());
}

void FileDesk::save(SettingsSheet& settings) const {
    settings.setValue("recent_files", recent_.all());
    settings.setValue("export_formats", export_formats_);
    if (keeps_folder_ && control_.resultFolderChosen())
        settings.setValue("result_folder", control_.resultFolder());
}

QString FileDesk::fileIn(const QMimeData& data) {
    if (data.urls().size() != 1)
        return {};
    const QString path = data.urls().first().toLocalFile();
    static const QStringList known{"usarrec", "usarsnap", "json", "sdf", "lap", "posh"};
    return known.contains(QFileInfo(path).suffix()) || QFileInfo(path + "/world.sdf").isFile() ? path : QString();
}

void FileDesk::open(const QString& path) {
    const QFileInfo file(path);
    const bool is_world = file.isDir() || file.fileName() == "world.sdf";
    if (path.endsWith(".usarsnap"))
        server_.openSnapshot(path);
    else if (path.endsWith(".usarrec"))
        openRecording(path);
    else if (is_world)
        server_.openWorld(file.isDir() ? path : file.absolutePath());
    else if (path.endsWith(".sdf"))
        server_.openRobotFile(path);
    else if (path.endsWith(".lap") || path.endsWith(".posh"))
        workshop_.openPlan(path);
    else
        mission_.openMission(path);
}

void FileDesk::openRecording(const QString& path, const mission::ReplayOrder& first) {
    recent_.add(path);
    control_.openRecording(path, first);
}

void FileDesk::fillRecentMenu(QMenu* menu) {
    menu->setToolTipsVisible(true);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] {
        menu->clear();
        for (const QString& path : recent_.existing()) {
            const QString words = tr("%1 in %2").arg(QFileInfo(path).fileName(), QFileInfo(path).dir().dirName());
            menu->addAction(QString(words).replace("&", "&&"), this, [this, path] { open(path); })->setToolTip(path);
        }
        if (menu->isEmpty())
            menu->addAction(tr("No files yet"))->setEnabled(false);
    });
}

void FileDesk::askForExport() {
    if (!export_dialog_) {
        std::vector<widgets::ExportOffer> offers;
        for (const mission::MapFormat& format : mission::mapFormats())
            offers.push_back({format.id, format.title, format.use});
        export_dialog_ = new widgets::ExportDialog(offers, window_);
        connect(export_dialog_, &widgets::ExportDialog::folderRequested, this, [this] {
            widgets::askForFolder(window_, tr("Folder for exports"), export_dialog_->folder(),
                                  [this](const QString& folder) {
                                      export_folder_ = folder;
                                      export_dialog_->setFolder(folder);
                                  });
        });
        connect(export_dialog_, &widgets::ExportDialog::exportRequested, this, &FileDesk::exportMap);
    }
    exported_ = selection_.id();
    export_dialog_->setRobot(nameOf(*robot()));
    export_dialog_->setFolder(export_folder_.isEmpty() ? control_.resultFolder() : export_folder_);
    export_dialog_->setChosen(export_formats_);
    widgets::showInFront(export_dialog_);
}

void FileDesk::exportMap(const QStringList& ids) {
    const auto formats = mission::readFormatList(ids.join(','), {});
    if (!formats)
        return; // The dialog offers no others.
    export_formats_ = ids;
    if (control_.robot(exported_))
        control_.exportMap(exported_, *formats, export_dialog_->folder());
    else
        notices_.say(Severity::Error, "map_export",
                     tr("The robot is gone, and its map with it. Export from its recording instead."));
}

QString FileDesk::selectedRecording() const {
    if (!robot())
        return {};
    const mission::RobotView& view = robot()->view();
    const auto& written = view.figures.recording;
    return robot()->isReplay() || !written ? view.recording : QString::fromStdString(written->path);
}

void FileDesk::askForRecordingExport() {
    const QFileInfo recording(selectedRecording());
    widgets::askWhereToSave(window_, tr("Export recording"),
                            recording.dir().filePath(recording.completeBaseName() + ".mcap"), tr("MCAP files (*.mcap)"),
                            [this, path = recording.filePath()](const QString& file) {
                                recording_export_.begin(path, file);
                                showSaving();
                            });
}

void FileDesk::recordingExported(const QString& file, const QString& complaint) {
    notices_.cure("recording_export");
    const QString text = tr("Exported the recording to %1.").arg(QDir::toNativeSeparators(file));
    if (complaint.isEmpty())
        notices_.note("recording_exported/" + file, text);
    else
        notices_.say(Severity::Warning, "recording_exported/" + file, text + ' ' + complaint);
    showSaving();
}

void FileDesk::chooseResultFolder(const std::function<void()>& then) {
    widgets::askForFolder(window_, tr("Folder for results"), control_.resultFolder(),
                          [this, then](const QString& folder) {
                              control_.setResultFolder(folder);
                              if (then)
                                  then();
                          });
}

} // namespace usar::app
