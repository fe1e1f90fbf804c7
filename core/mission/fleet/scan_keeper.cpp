#include "core/mission/fleet/scan_keeper.h"

#include <algorithm>
#include <utility>

#include "core/link/across_threads.h"
#include "core/mission/files/result_writer.h"

namespace usar::mission {

namespace {

/// All of the summary but what its record says.
RunSummary summaryOf(const Robot& robot, const SimulatorFacts& facts) {
    const RobotView& view = robot.view();
    RunSummary summary;
    summary.success = view.finished && view.finished->success;
    summary.reason = view.finished ? view.finished->reason : "saved before the end";
    summary.behavior = view.behavior_id;
    if (robot.started() && robot.started()->plan)
        summary.plan = robot.started()->plan->name;
    summary.seed = facts.seed;
    summary.truth = facts.truth;
    summary.wall = robot.wallTime();
    addSession(summary, view.finished ? view.figures_at_end : view.figures);
    judgeDamage(summary);
    return summary;
}

/// Writes the record with its summary, which is returned complete.
Result<RunSummary> saveRecord(const ScanRecord& record, RunSummary summary, const SimulatorFacts& facts,
                              const QString& folder, const mapping::HeightLook& look, const std::stop_token& stop) {
    const std::optional<Truth> truth =
        facts.make_truth && !stop.stop_requested() ? std::optional(facts.make_truth()) : std::nullopt;
    summary.duration = record.status.elapsed;
    addRecord(summary, record, truth ? &*truth : nullptr, facts.flight);
    const Result<QStringList> files = writeResults(record, toJson(summary), folder, look, stop);
    if (!files)
        return tl::unexpected(files.error());
    summary.files = *files;
    return summary;
}

} // namespace

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

void ScanKeeper::watch(Robot& robot, std::function<SimulatorFacts()> facts) {
    facts_[&robot] = std::move(facts);
    connect(&robot, &Robot::recordReady, this, [this, &robot](const auto& record) { write(robot, record); });
    connect(&robot, &Robot::mapReady, this, [this, &robot](const auto& record) { writeMap(robot, record); });
    connect(&robot, &QObject::destroyed, this, [this, gone = &robot] {
        dropExports(gone);
        facts_.erase(gone);
        awaited_.erase(gone);
    });
}

void ScanKeeper::save(Robot& robot) {
    awaited_.insert(&robot);
    robot.requestRecord();
}

void ScanKeeper::takeLeave(std::unique_ptr<Robot> robot) {
    const auto facts = facts_.find(robot.get());
    if (facts != facts_.end()) // its simulator may go before the record comes
        facts->second = [last = facts->second()] { return last; };
    robot->stop();
    if (robot->view().unsaved || robot->running() || awaited_.contains(robot.get()) || exports_.contains(robot.get())) {
        save(*robot);
        robot->close();
        leaving_.push_back(std::move(robot));
    }
}

void ScanKeeper::write(Robot& robot, const std::shared_ptr<const ScanRecord>& record) {
    awaited_.erase(&robot);
    if (record->raster.empty() && release(robot))
        return;
    robot.markSaved(); // what comes from here on is not in the record
    const auto facts = facts_.find(&robot);
    const SimulatorFacts known = facts == facts_.end() ? SimulatorFacts{} : facts->second();
    ++writing_;
    emit writingChanged(nameOf(robot));
    pool_.start(HandedOver([this, who = Writing{robot.view().id, nameOf(robot), &robot, stop_.get_token()}, record,
                            summary = summaryOf(robot, known), known, to = folder(), look = look_] {
        const Result<RunSummary> whole = saveRecord(*record, summary, known, to, look, who.stop);
        link::post(this, [this, who, whole] { written(who, whole); });
    }));
}

void ScanKeeper::written(const Writing& writing, const Result<RunSummary>& summary) {
    const auto& [id, robot_name, robot, stop] = writing;
    if (--writing_ == 0)
        emit writingChanged({});
    if (!summary && robot)
        robot->markUnsaved();
    if (summary && robot && !robot->view().unsaved)
        release(*robot);
    if (summary)
        emit saved(id, *summary, robot_name);
    else if (stop.stop_requested())
        emit cancelled(id, QString::fromStdString(summary.error().text()));
    else
        emit failed(id, QString::fromStdString(summary.error().text()));
}

void ScanKeeper::exportMap(Robot& robot, const FormatList& formats, const QString& folder) {
    exports_.insert({&robot, {formats, folder}});
    robot.requestMap(needPoints(formats));
}

void ScanKeeper::writeMap(Robot& robot, const std::shared_ptr<const ScanRecord>& record) {
    const auto wanted = exports_.find(&robot); // Maps come in the order of the requests.
    if (wanted == exports_.end())
        return;
    ++writing_;
    emit writingChanged(nameOf(robot));
    pool_.start(HandedOver([this, record, wish = wanted->second, stop = stop_.get_token(), robot_name = nameOf(robot)] {
        const auto files = mission::exportMap(*record, wish.formats, wish.folder, {}, stop);
        link::post(this, [this, files, robot_name, stop] { mapWritten(files, robot_name, stop.stop_requested()); });
    }));
    exports_.erase(wanted);
}

void ScanKeeper::mapWritten(const Result<QStringList>& files, const QString& robot_name, bool cancelled) {
    if (--writing_ == 0)
        emit writingChanged({});
    if (files)
        emit exported(*files, robot_name);
    else
        emit exportRefused(QString::fromStdString(files.error().text()), cancelled);
}

void ScanKeeper::dropExports(const Robot* robot) {
    if (exports_.erase(robot) > 0)
        emit exportRefused("The robot is gone, and its map with it. Export from its recording instead.", false);
}

void ScanKeeper::cancel() {
    std::exchange(stop_, std::stop_source()).request_stop();
}

bool ScanKeeper::release(const Robot& robot) {
    const auto found = std::ranges::find(leaving_, &robot, &std::unique_ptr<Robot>::get);
    if (found == leaving_.end())
        return false;
    found->release()->deleteLater(); // later, because the caller may be a signal of this robot
    leaving_.erase(found);
    return true;
}

void ScanKeeper::giveUpWaiting() {
    awaited_.clear();
    exports_.clear();
    std::erase_if(leaving_, [](const auto& robot) { return !robot->view().unsaved; });
}

} // namespace usar::mission
