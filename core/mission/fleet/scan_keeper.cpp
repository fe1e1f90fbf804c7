#include "core/mission/fleet/scan_keeper.h"

#include <algorithm>
#include <utility>

#include "core/link/across_threads.h"
#include "core/mission/files/result_writer.h"

namespace usar::mission {

namespace {

/// Makes the summary that is written beside the pictures.
QJsonObject summaryOf(const RobotView& view, const std::optional<TrueFigures>& truth) {
    QJsonObject summary{
        {"behavior", QString::fromStdString(view.behavior_id)},
        {"lines_received", static_cast<qint64>(view.figures.lines_received)},
        {"protocol_time_s", view.figures.now.count()},
        {"success", view.finished && view.finished->success},
        {"reason", view.finished ? QString::fromStdString(view.finished->reason) : QString("saved before the end")}};
    if (view.status) {
        summary["duration_s"] = view.status->elapsed.count();
        summary["distance_m"] = view.status->distance_flown_m;
        summary["charges"] = view.status->charges;
    }
    const QJsonObject known = toJson(truth);
    for (auto one = known.begin(); one != known.end(); ++one)
        summary[one.key()] = one.value();
    return summary;
}

} // namespace

ScanKeeper::ScanKeeper(QObject* parent) : QObject(parent) {
    pool_.setMaxThreadCount(1);
}

ScanKeeper::~ScanKeeper() {
    pool_.waitForDone();
}

void ScanKeeper::setFolder(const QString& folder) {
    folder_ = folder;
    retry();
}

void ScanKeeper::retry() {
    for (const auto& robot : leaving_)
        if (robot->view().unsaved && !awaited_.contains(robot.get()))
            save(*robot);
}

QString ScanKeeper::folder() const {
    return folder_.isEmpty() ? defaultResultFolder() : folder_;
}

void ScanKeeper::watch(Robot& robot, std::function<std::optional<TrueFigures>()> truth) {
    truths_[&robot] = std::move(truth);
    connect(&robot, &Robot::recordReady, this, [this, &robot](const auto& record) { write(robot, record); });
    connect(&robot, &QObject::destroyed, this, [this, gone = &robot] {
        truths_.erase(gone);
        awaited_.erase(gone);
    });
}

void ScanKeeper::save(Robot& robot) {
    awaited_.insert(&robot);
    robot.requestRecord();
}

void ScanKeeper::takeLeave(std::unique_ptr<Robot> robot) {
    const auto truth = truths_.find(robot.get());
    if (truth != truths_.end()) // The simulator may be gone before the record arrives.
        truth->second = [last = truth->second()] { return last; };
    robot->stop();
    if (robot->view().unsaved || robot->running() || awaited_.contains(robot.get())) {
        save(*robot);
        robot->close();
        leaving_.push_back(std::move(robot));
    }
}

void ScanKeeper::write(Robot& robot, const std::shared_ptr<const ScanRecord>& record) {
    awaited_.erase(&robot);
    if (record->raster.empty() && leaves(robot))
        return release(robot);
    robot.markSaved(); // Now, because what is scanned from here on is not in the record.
    const auto truth = truths_.find(&robot);
    const QJsonObject summary = summaryOf(robot.view(), truth == truths_.end() ? std::nullopt : truth->second());
    ++writing_;
    pool_.start(HandedOver([this, id = robot.view().id, who = QPointer<Robot>(&robot), record, summary, to = folder()] {
        const Result<QStringList> files = writeResults(*record, summary, to);
        link::post(this, [this, id, who, files] { written(id, who, files); });
    }));
}

void ScanKeeper::written(int id, const QPointer<Robot>& robot, const Result<QStringList>& files) {
    --writing_;
    if (!files && robot)
        robot->markUnsaved();
    if (files && robot && !robot->view().unsaved)
        release(*robot);
    if (files)
        emit saved(id, *files);
    else
        emit failed(id, QString::fromStdString(files.error().text()));
}

bool ScanKeeper::leaves(const Robot& robot) const {
    return std::ranges::find(leaving_, &robot, &std::unique_ptr<Robot>::get) != leaving_.end();
}

/// Destroys the robot later, because it may be the sender of the current signal.
void ScanKeeper::release(Robot& robot) {
    const auto found = std::ranges::find(leaving_, &robot, &std::unique_ptr<Robot>::get);
    if (found == leaving_.end())
        return;
    found->release()->deleteLater();
    leaving_.erase(found);
}

void ScanKeeper::giveUpWaiting() {
    awaited_.clear();
    std::erase_if(leaving_, [](const auto& robot) { return !robot->view().unsaved; });
}

void ScanKeeper::forgetLeaving() {
    leaving_.clear();
}

} // namespace usar::mission
