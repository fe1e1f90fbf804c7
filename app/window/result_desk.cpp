#include "app/window/result_desk.h"

#include <QDesktopServices>
#include <QImageReader>
#include <QUrl>

#include "core/link/across_threads.h"
#include "core/mission/fleet/robot_words.h"
#include "widgets/panels/compare_dialog.h"

namespace usar::app {

namespace {

/// Without what only the files tell.
widgets::MissionOutcome outcomeOf(const Robot& robot) {
    return widgets::outcomeOf(nameOf(robot), robot.coverage_pct(), robot.view().finished, robot.view().status);
}

void addFiles(widgets::MissionOutcome& outcome, const mission::RunSummary& summary) {
    if (outcome.coverage_pct)
        outcome.coverage_pct = summary.score.coverage_pct;
    if (summary.reach && !summary.warnings.empty()) {
        outcome.reachable_pct = summary.reach->coverage_pct;
        outcome.unreachable = summary.warnings.join(u' ');
    }
    outcome.error_m = summary.score.rmse_m;
    if (summary.heights)
        outcome.heights_m = {double(summary.heights->minimum_m), double(summary.heights->maximum_m)};
    if (const auto& adjustment = summary.adjustment; adjustment && adjustment->residual_before_m &&
                                                     adjustment->residual_after_m &&
                                                     adjustment->verdict != mapping::AdjustmentVerdict::Declined)
        outcome.overlaps_m = {*adjustment->residual_before_m, *adjustment->residual_after_m};
    if (summary.adjustment && summary.adjustment->shift)
        outcome.shift_m = {summary.adjustment->shift->mean_m, summary.adjustment->shift->greatest_m};
    outcome.files = summary.files;
}

QImage smallPicture(const QString& path) {
    constexpr QSize most = widgets::ResultCard::picture_px;
    return QImageReader(path).read().scaled(most, Qt::KeepAspectRatio, Qt::SmoothTransformation);
}

} // namespace

void ResultDesk::wire() {
    connect(&control_, &MissionControl::behaviorFinished, this, &ResultDesk::takeEnd);
    connect(&control_, &MissionControl::resultsWritten, this, &ResultDesk::takeResults);
    connect(&control_, &MissionControl::exportFailed, this, [this](RobotId id) { ended_.erase(id); });
    connect(&control_, &MissionControl::robotRemoved, this, [this](RobotId id) {
        ended_.erase(id);
        if (id != shown_)
            return;
        shown_ = {};
        views_.result->setCanFlyAgain(false);
    });
    const auto open = [](const QString& path) { QDesktopServices::openUrl(QUrl::fromLocalFile(path)); };
    connect(views_.result, &widgets::ResultCard::folderRequested, this, open);
    connect(views_.result, &widgets::ResultCard::pictureRequested, this, open);
    connect(views_.result, &widgets::ResultCard::compareRequested, this,
            [this](const QString& path) { widgets::compareRuns(window_, path); });
    connect(views_.result, &widgets::ResultCard::flyAgainRequested, this, &ResultDesk::flyAgain);
}

void ResultDesk::forget(RobotId id) {
    ended_.erase(id);
    if (id == shown_)
        views_.result->hide();
}

void ResultDesk::takeEnd(RobotId id) {
    const Robot* const robot = control_.robot(id);
    if (!robot || robot->view().broke)
        return; // A broken behavior has a notification with a button of its own.
    if (robot->view().tiles.empty())
        show(id, outcomeOf(*robot));
    else
        ended_.insert(id);
}

void ResultDesk::takeResults(RobotId id, const mission::RunSummary& summary, const QString& robot_name) {
    const QString key = "saved/" + robot_name;
    const QString text = mission::savedText(robot_name, summary.files);
    const Robot* const robot = control_.robot(id);
    if (!robot || ended_.erase(id) == 0)
        return notices_.note(key, text);
    notices_.say(Severity::Note, key, text);
    widgets::MissionOutcome outcome = outcomeOf(*robot);
    addFiles(outcome, summary);
    show(id, outcome);
    pool_.start(HandedOver([this, id, map = pictureOf(outcome), relief = reliefPictureOf(outcome)] {
        link::post(this, [this, id, map = smallPicture(map), relief = smallPicture(relief)] {
            if (id == shown_)
                views_.result->setPictures(map, relief);
        });
    }));
}

void ResultDesk::show(RobotId id, const widgets::MissionOutcome& outcome) {
    shown_ = id;
    views_.result->tell(outcome);
}

void ResultDesk::flyAgain() {
    selection_.select(shown_);
    action("mission.start")->trigger();
}

} // namespace usar::app
