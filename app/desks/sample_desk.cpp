#include "app/desks/sample_desk.h"

#include <utility>

#include <QDesktopServices>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QUrl>

#include "core/server/embedded/program_files.h"
#include "widgets/panels/compare_dialog.h"

namespace usar::app {

void SampleDesk::registerCommands() {
    addSample("sample.flight", "flight.usarrec", [this](const QString& path) { files_.openRecording(path); });
    addSample("sample.scan", "scan/USAR_Scan_tall-test_R1_001.json",
              [this](const QString& path) { widgets::compareRuns(window_, path); });
    addSample("sample.campaign", "campaign", [this](const QString& path) { openCampaign(path); });
    addSample("sample.report", "campaign/report.html",
              [](const QString& path) { QDesktopServices::openUrl(QUrl::fromLocalFile(path)); });
}

void SampleDesk::addSample(const char* id, const char* name, const std::function<void(const QString& path)>& open) {
    add(id, [this, open, path = server::samplesFolder() + '/' + name] {
        if (QFileInfo::exists(path))
            open(path);
        else
            notices_.say(Severity::Error, "sample",
                         tr("%1: the sample is not there. Build or install the program again.").arg(path));
    });
}

void SampleDesk::openCampaign(const QString& sample) {
    const QString place = QDir(control_.resultFolder()).filePath("Sample");
    // The campaign's commands name the mission from their own folder.
    for (const auto& [folder, name] : {std::pair("..", "sample.mission.json"), std::pair(".", "manifest.jsonl"),
                                       std::pair(".", "shard-000.jsonl"), std::pair(".", "report.html")}) {
        const QDir to(QDir::cleanPath(place + "/campaign/" + folder));
        const bool there = to.exists(name) || (QDir().mkpath(to.path()) &&
                                               QFile::copy(sample + '/' + folder + '/' + name, to.filePath(name)));
        if (!there)
            return notices_.say(
                Severity::Error, "sample",
                tr("%1: the sample cannot be copied there. Choose another folder for results.").arg(to.filePath(name)));
    }
    campaigns_.openResults(place + "/campaign");
    notices_.note("sample", tr("The sample is a copy in %1; what you do with it stays there.").arg(place));
}

void SampleDesk::wire() {
    views_.robots->emptyState()->setAction(action("sample.flight"), "");
    views_.campaign->runs()->emptyState()->setAction(action("sample.campaign"), "");
}

} // namespace usar::app
