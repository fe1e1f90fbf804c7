#include "app/window/recovery_desk.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include <QFileInfo>

#include "core/base/hand_over.h"
#include "core/link/across_threads.h"

namespace usar::app {

RecoveryDesk::RecoveryDesk(const DeskContext& context, QThreadPool& disk)
    : Desk(context)
    , disk_(disk)
    , folder_(QFileInfo(QSettings().fileName()).path() + "/running")
    , marker_(folder_) {}

void RecoveryDesk::wire() {
    connect(views_.question, &widgets::QuestionStrip::freed, this, &RecoveryDesk::ask);
}

QStringList RecoveryDesk::recordings() const {
    QStringList paths;
    for (const Robot* const robot : control_.robots())
        if (const auto& recording = robot->view().figures.recording; recording && !robot->isReplay())
            paths << QFileInfo(QString::fromStdString(recording->path)).absoluteFilePath();
    return paths;
}

void RecoveryDesk::mark() {
    const QStringList now = recordings();
    if (now == marked_)
        return;
    marked_ = now;
    disk_.start(HandedOver([this, now] { marker_.setRecordings(now); }));
}

void RecoveryDesk::offer() {
    const QStringList found = mission::RunMarker::takeAbandoned(folder_);
    if (found.isEmpty())
        return;
    disk_.start(HandedOver([this, found] {
        QStringList cut_off;
        std::ranges::copy_if(found, std::back_inserter(cut_off), mission::brokeOffInMission);
        link::post(this, [this, found, cut_off] {
            left_ = found;
            cut_off_ = cut_off;
            ask();
        });
    }));
}

void RecoveryDesk::readScans() {
    for (const QString& path : std::exchange(cut_off_, {}))
        disk_.start(HandedOver([this, path] {
            auto read = mission::readRecordedScan(path);
            const auto earlier = read ? std::make_shared<const mission::RecordedScan>(*std::move(read)) : nullptr;
            const Error trouble = read ? Error{} : read.error();
            link::post(this, [this, earlier, trouble] {
                if (!earlier)
                    return notices_.complain("mission", trouble);
                if (!earlier->missing.empty())
                    notices_.note(
                        "recovery",
                        tr("%1 What was scanned there is flown again.").arg(QString::fromStdString(earlier->missing)));
                emit restChosen(earlier);
            });
        }));
}

void RecoveryDesk::ask() {
    constexpr std::chrono::seconds patience{60};
    if (left_.isEmpty() || !views_.question->openQuestion().isEmpty())
        return;
    const bool one = left_.size() == 1;
    const QString question = one ? tr("The program was ended in the middle of its work. The recording %1 goes up to "
                                      "that moment.")
                                       .arg(QFileInfo(left_.front()).fileName())
                                 : tr("The program was ended in the middle of its work. %1 recordings go up to that "
                                      "moment.")
                                       .arg(left_.size());
    const auto open = [this] {
        for (const QString& path : std::exchange(left_, {}))
            emit recordingChosen(path);
    };
    std::vector<widgets::QuestionStrip::Answer> answers{
        {one ? tr("Open the recording") : tr("Open the recordings"), open}};
    if (!cut_off_.isEmpty())
        answers.push_back({tr("Fly the rest"), [this] {
                               left_.clear();
                               readScans();
                           }});
    answers.push_back({tr("Not now"), [this] { left_.clear(); }});
    views_.question->ask("recovery", question, answers, patience);
}

} // namespace usar::app
