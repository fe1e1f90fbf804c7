#include "app/window/recovery_desk.h"

#include <utility>

#include <QFileInfo>

#include "core/base/hand_over.h"

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
    left_ = mission::RunMarker::takeAbandoned(folder_);
    ask();
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
    views_.question->ask("recovery", question,
                         {{one ? tr("Open the recording") : tr("Open the recordings"), open},
                          {tr("Not now"), [this] { left_.clear(); }}},
                         patience);
}

} // namespace usar::app
