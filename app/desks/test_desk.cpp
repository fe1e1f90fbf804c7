#include "app/desks/test_desk.h"

#include <QDir>

#include "core/link/across_threads.h"
#include "core/mission/fleet/robot_words.h"
#include "widgets/panels/dialogs.h"

namespace usar::app {

namespace {

/// The text as a file's name: what no system allows in one is left out.
QString fileNameOf(const QString& text) {
    QString name;
    for (const QChar letter : text)
        name += letter.isLetterOrNumber() || QString(" _-.,()").contains(letter) ? letter : QChar('_');
    return name.trimmed();
}

} // namespace

void TestDesk::registerCommands() {
    add(
        "replay.make_test", [this] { return recorded(); }, [this] { begin(); });
}

void TestDesk::wire() {
    connectUpdates([this](const auto&) {
        if (action("replay.make_test")->isEnabled() != recorded())
            commands_.refresh();
    });
    pool_.setMaxThreadCount(1);
}

bool TestDesk::recorded() const {
    return robot() && (robot()->isReplay() || robot()->view().figures.recording) &&
           !robot()->view().behavior_id.empty();
}

void TestDesk::begin() {
    if (!recorded())
        return;
    if (!dialog_) {
        dialog_ = new widgets::TestDialog(window_);
        dialog_->setAttribute(Qt::WA_DeleteOnClose);
        connect(dialog_, &widgets::TestDialog::spanChanged, this, &TestDesk::offer);
        connect(dialog_, &widgets::TestDialog::makeRequested, this, &TestDesk::write);
        connect(dialog_, &widgets::TestDialog::folderRequested, this, &TestDesk::chooseFolder);
    }
    moment_.reset();
    now_ = robot()->view().figures.now;
    dialog_->setFolder(folder());
    dialog_->setReading(QString::fromStdString(robot()->view().spawn.robot_name));
    widgets::showInFront(dialog_);
    if (robot()->isReplay())
        return read(robot()->view().recording);
    awaited_ = robot();
    connect(awaited_, &Robot::recordingFlushed, this, &TestDesk::read, Qt::SingleShotConnection);
    awaited_->flushRecording();
}

void TestDesk::read(const QString& path) {
    pool_.start([this, path, now = now_] {
        link::post(this, [this, now, moment = mission::readFlightMoment(path, now)] {
            if (now == now_) // Otherwise another moment was chosen in the meantime.
                take(moment);
        });
    });
}

void TestDesk::take(const Result<mission::FlightMoment>& moment) {
    if (!dialog_)
        return;
    if (!moment)
        return dialog_->complain(QString::fromStdString(moment.error().text()));
    moment_ = *moment;
    const auto& flown = moment_->flown;
    const QString caution = moment_->by_hand ? tr("The robot was also driven by hand, which a test does not repeat.")
                            : flown.seed
                                ? QString()
                                : tr("The seed of the simulator is not known, so noise and drift will be others.");
    dialog_->setMoment(
        moment_->at.count(), {moment_->first.count(), moment_->last.count()},
        fileNameOf(
            tr("%1 at %2 s").arg(QString::fromStdString(flown.mission.name)).arg(moment_->at.count(), 0, 'f', 1)),
        caution);
    offer();
}

void TestDesk::offer() {
    if (!dialog_ || !moment_)
        return;
    const widgets::FlightSpan span = dialog_->span();
    offers_ = mission::claimsToOffer(*moment_, Seconds{span.from_s}, Seconds{span.to_s});
    std::vector<widgets::TestOffer> shown;
    for (const mission::ClaimOffer& offer : offers_)
        shown.push_back({QString::fromStdString(mission::wordsOf(offer.claim)), offer.held});
    dialog_->setOffers(shown);
}

void TestDesk::write() {
    if (!dialog_ || !moment_ || dialog_->chosen() < 0)
        return;
    const QString name = fileNameOf(dialog_->name());
    const QString path = QDir(folder()).filePath(name + ".json");
    if (QFile::exists(path))
        return dialog_->complain(tr("There is a test of this name already: %1. Choose another name.").arg(path));
    const auto& claim = offers_.at(static_cast<std::size_t>(dialog_->chosen())).claim;
    const auto written = QDir().mkpath(folder())
                             ? mission::writeMissionFile(mission::testOf(*moment_, claim, name.toStdString()), {}, path)
                             : failure("the folder cannot be made", folder().toStdString(), "Choose another folder");
    if (!written)
        return dialog_->complain(QString::fromStdString(written.error().text()));
    dialog_->close();
    notices_.note(
        "test",
        tr("The test is in %1. usar-mission campaign --tests \"%2\" flies all tests there.").arg(path, folder()));
}

void TestDesk::chooseFolder() {
    widgets::askForFolder(window_, tr("Folder for tests"), folder(), [this](const QString& path) {
        folder_ = path;
        if (dialog_)
            dialog_->setFolder(path);
    });
}

QString TestDesk::folder() const {
    return folder_.isEmpty() ? QDir(control_.resultFolder()).filePath("tests") : folder_;
}

} // namespace usar::app
