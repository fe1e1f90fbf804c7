#include "core/campaign/runs/campaign_process.h"

#include <csignal>
#include <cstring>

#include <sys/prctl.h>

#include <QJsonDocument>
#include <QJsonObject>

#include "core/mission/runs/mission_runner.h"

namespace usar::campaign {

CampaignProcess::CampaignProcess(QObject* parent) : QObject(parent) {
    connect(&process_, &QProcess::finished, this,
            [this](int exit_code, QProcess::ExitStatus status) { emit ended(troubleOf(exit_code, status)); });
    connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart)
            emit ended(QString::fromStdString(
                Error{"the program cannot be started: " + process_.errorString().toStdString(),
                      process_.program().toStdString(), "Build or install it again, beside this program"}
                    .text()));
    });
    process_.setStandardInputFile(QProcess::nullDevice());
    process_.setChildProcessModifier([] { ::prctl(PR_SET_PDEATHSIG, SIGTERM); });
}

CampaignProcess::~CampaignProcess() {
    process_.disconnect(this);
    if (!running())
        return;
    process_.kill(); // Its missions die with it, and each result is written before the next mission begins.
    process_.waitForFinished();
}

void CampaignProcess::start(const QString& program, const QString& file, const QString& folder, int jobs) {
    stopped_ = false;
    process_.start(program, {"campaign", file, "--out", folder, "--resume", "--jobs", QString::number(jobs)});
}

void CampaignProcess::stop() {
    stopped_ = true;
    process_.terminate();
}

QString CampaignProcess::troubleOf(int exit_code, QProcess::ExitStatus status) {
    const QByteArray output = process_.readAllStandardOutput().trimmed();
    process_.readAllStandardError(); // What it says of single runs is in their result lines, too.
    if (stopped_)
        return {};
    if (status == QProcess::CrashExit)
        return tr("Something ended the campaign's program (%1). The results so far are kept; press Resume to fly the "
                  "rest.")
            .arg(QString::fromLocal8Bit(::strsignal(exit_code)));
    const QJsonObject summary = QJsonDocument::fromJson(output.mid(output.lastIndexOf('\n') + 1)).object();
    if (summary.isEmpty())
        return tr("The campaign's program ended without a result (exit code %1). Press Resume to fly the rest.")
            .arg(exit_code);
    return exit_code == mission::BadInput ? summary["reason"].toString() : QString();
}

} // namespace usar::campaign
