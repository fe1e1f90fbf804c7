#include "app/desks/test_desk.h"

#include <QDir>

#include "core/link/across_threads.h"
#include "core/mission/fleet/robot_words.h"
#include "widgets/panels/dialogs.h"

namespace usar::app {

namespace {

/// The text as a file's name: anything but letters, digits and a few marks becomes an underscore, and it begins with no
/// dot, because such files are hidden.
QString fileNameOf(const QString& text) {
    QString name;
    for (const QChar letter : text.trimmed())
        name += letter.isLetterOrNumber() || QString(" _-.,()").contains(letter) ? letter : QChar('_');
    return name.startsWith('.') ? '_' + name.mid(1) : name;
}

QString cautionsOf(const mission::FlightMoment& moment) {
    QStringList cautions;
    if (moment.by_hand)
        cautions << TestDesk::tr("The robot was also driven by hand, which a test does not repeat.");
    if (moment.late)
        cautions << TestDesk::tr("The behavior started when the robot had been there for a while, so noise and drift "
                                 "will be others.");
    else if (!moment.flown.seed)
        cautions << TestDesk::tr("The seed of the simulator is not known, so noise and drift will be others.");
    if (mission::isRepeatedRoughly(moment))
        cautions << TestDesk::tr(
                        "So heights have a meter of slack, and what must be seen once may be seen %1 s earlier "
                        "or later.")
                        .arg(mission::rough_slack.count());
    return cautions.join(' ');
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

void TestDesk::makeDialog() {
    dialog_ = new widgets::TestDialog(window_);
    dialog_->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog_, &widgets::TestDialog::spanChanged, this, &TestDesk::offer);
    connect(dialog_, &widgets::TestDialog::heightChanged, this, &TestDesk::setHeight);
    connect(dialog_, &widgets::TestDialog::makeRequested, this, &TestDesk::write);
    connect(dialog_, &widgets::TestDialog::folderRequested, this, &TestDesk::chooseFolder);
    connect(dialog_, &QDialog::finished, this, [this] {
        giveUp();
        dialog_ = nullptr; // It deletes itself.
    });
}

void TestDesk::giveUp() {
    *given_up_ = true;
    ++request_;
    disconnect(gone_);
}

void TestDesk::begin() {
    if (!recorded())
        return;
    giveUp();
    if (!dialog_)
        makeDialog();
    given_up_ = std::make_shared<std::atomic_bool>(false);
    const int request = ++request_;
    moment_.reset();
    robot_name_ = QString::fromStdString(robot()->view().spawn.robot_name);
    now_ = robot()->view().figures.now;
    dialog_->setFolder(folder());
    dialog_->setReading(robot_name_);
    widgets::showInFront(dialog_);
    if (robot()->isReplay())
        return read(request, robot()->view().recording);
    connect(
        robot(), &Robot::recordingFlushed, this, [this, request](const QString& path) { read(request, path); },
        Qt::SingleShotConnection);
    gone_ = connect(robot(), &QObject::destroyed, this, [this] {
        if (dialog_)
            dialog_->complain(tr("%1 has left. Open its recording to make a test of it.").arg(robot_name_));
    });
    robot()->flushRecording();
}

void TestDesk::read(int request, const QString& path) {
    if (request != request_)
        return;
    disconnect(gone_);
    if (path.isEmpty())
        return dialog_->complain(tr("The recording of %1 has ended. Open it to make a test of it.").arg(robot_name_));
    pool_.start([this, request, path, now = now_, given_up = given_up_] {
        link::post(this, [this, request, moment = mission::readFlightMoment(path, now, *given_up)] {
            if (request == request_)
                take(moment);
        });
    });
}

void TestDesk::take(const Result<mission::FlightMoment>& moment) {
    if (!moment)
        return dialog_->complain(QString::fromStdString(moment.error().text()));
    moment_ = *moment;
    const QString mission_name = QString::fromStdString(moment_->flown.mission.name);
    dialog_->setMoment(moment_->at.count(), {moment_->first.count(), moment_->last.count()},
                       fileNameOf(tr("%1 at %2 s").arg(mission_name).arg(moment_->at.count(), 0, 'f', 1)),
                       cautionsOf(*moment_));
    offer();
}

void TestDesk::offer() {
    if (!moment_)
        return;
    const widgets::FlightSpan span = dialog_->span();
    offers_ = mission::claimsToOffer(*moment_, Seconds{span.from_s}, Seconds{span.to_s});
    show();
}

void TestDesk::show() {
    std::vector<widgets::TestOffer> shown;
    for (const mission::Claim& claim : offers_)
        shown.push_back({QString::number(static_cast<int>(claim.kind)) + QString::fromStdString(claim.name),
                         QString::fromStdString(mission::wordsOf(claim)), mission::heldIn(*moment_, claim),
                         isAboutHeight(claim.kind) ? std::optional(claim.height_m) : std::nullopt});
    dialog_->setOffers(shown);
}

void TestDesk::setHeight(double height_m) {
    if (!moment_ || dialog_->chosen() < 0)
        return;
    offers_.at(static_cast<std::size_t>(dialog_->chosen())).height_m = height_m;
    show();
}

void TestDesk::write() {
    if (!moment_ || dialog_->chosen() < 0)
        return;
    const QString name = fileNameOf(dialog_->name());
    const QString path = QDir(folder()).filePath(name + ".json");
    if (QFile::exists(path))
        return dialog_->complain(tr("There is a test of this name already: %1. Choose another name.").arg(path));
    const mission::Claim& claim = offers_.at(static_cast<std::size_t>(dialog_->chosen()));
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
