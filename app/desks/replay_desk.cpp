#include "app/desks/replay_desk.h"

#include <algorithm>
#include <cmath>

#include <QClipboard>
#include <QGuiApplication>

#include "core/campaign/plan/shell_word.h"
#include "core/link/recording_parts.h"
#include "core/mission/files/scan_record.h"
#include "widgets/panels/dialogs.h"

namespace usar::app {

namespace {

constexpr int least_limit_mb = static_cast<int>(link::RecordingParts::least_limit_bytes / 1'000'000);

} // namespace

void ReplayDesk::registerCommands() {
    constexpr Seconds leap{10.0};
    const auto shown = [this] { return robot() && robot()->isReplay(); };
    // Relative to the replay's position when it takes the order: at 100 times the pace the bar lags by seconds.
    const auto seekBy = [this](Seconds span) { return [this, span] { order({.seek_by = span}); }; };
    add("file.record", [this](bool on) { setRecording(on); });
    add("file.record_limit", [this] { askForLimit(); });
    add("file.open_recording", [this] {
        widgets::askForFile(window_, tr("Open recording"), control_.resultFolder(), tr("Recordings (*.usarrec)"),
                            [this](const QString& path) { emit recordingChosen(path); });
    });
    add("replay.play", shown, [this] { order({.play = !views_.replay->state().playing}); });
    add("replay.step", shown, [this] { order({.step = true}); });
    add("replay.back", shown, seekBy(-leap));
    add("replay.forward", shown, seekBy(leap));
    add("replay.begin", shown, [this] { order({.seek = Seconds{0.0}}); });
    add("replay.faster", shown, [this] { views_.replay->changeSpeed(1); });
    add("replay.slower", shown, [this] { views_.replay->changeSpeed(-1); });
    add("replay.copy_link", shown, [this] { copyLink(); });
    add("replay.close", shown, [this] { control_.remove(selection_.id()); });
}

void ReplayDesk::wire() {
    auto* const bar = views_.replay;
    views_.record->setAction(action("file.record"));
    bar->setActions(action("replay.play"), action("replay.back"), action("replay.forward"), action("replay.step"),
                    action("replay.close"));
    connect(bar, &widgets::ReplayBar::seekRequested, this, [this](Seconds position) { order({.seek = position}); });
    connect(bar, &widgets::ReplayBar::speedRequested, this, [this](double speed) { order({.speed = speed}); });
    connect(views_.plots, &widgets::PlotView::momentRequested, this,
            [this](Seconds time) { order({.seek_clock = time}); });
    connect(&selection_, &Selection::changed, this, &ReplayDesk::show);
    connectUpdates([this](const auto&) { show(); });
}

void ReplayDesk::show() {
    const bool is_replay = robot() && robot()->isReplay();
    views_.replay->setVisible(is_replay);
    const mission::SessionFigures figures = robot() ? robot()->view().figures : mission::SessionFigures{};
    views_.plots->setMoment(is_replay ? std::optional(figures.now) : std::nullopt);
    if (is_replay)
        views_.replay->setFile(robot()->view().recording);
    if (const auto& replay = figures.replay; is_replay && replay)
        views_.replay->setState({replay->position, replay->span, replay->speed, replay->playing});
    std::optional<widgets::RecordState> recording;
    if (figures.recording)
        recording = {figures.recording->elapsed, figures.recording->bytes,
                     QString::fromStdString(figures.recording->path), figures.recording->limit_bytes};
    views_.record->setState(recording);
}

void ReplayDesk::order(const mission::ReplayOrder& order) {
    if (!robot() || !robot()->isReplay())
        return;
    const bool is_one_of_them = std::ranges::find(together_, selection_.id()) != together_.end();
    for (const RobotId id : is_one_of_them ? together_ : std::vector<RobotId>{selection_.id()})
        if (Robot* const replay = control_.robot(id); replay && replay->isReplay())
            replay->orderReplay(order);
}

void ReplayDesk::copyLink() {
    const mission::RobotView& view = robot()->view();
    if (!view.figures.replay)
        return;
    const double position_s = std::round(view.figures.replay->position.count() * 1000.0) / 1000.0;
    QString link =
        QString("mission-control %1 --at %2").arg(campaign::shellWord(view.recording), mission::numberText(position_s));
    if (!view.recorded_name.empty())
        link += " --select " + campaign::shellWord(QString::fromStdString(view.recorded_name));
    QGuiApplication::clipboard()->setText(link);
    notices_.note("replay-link", tr("On the clipboard: %1").arg(link));
}

void ReplayDesk::keepTogether(const std::vector<RobotId>& replays) {
    together_ = replays;
    if (replays.empty())
        return;
    selection_.select(replays.front());
    order({.play = true, .seek = Seconds{0.0}});
}

void ReplayDesk::restore(const QSettings& settings) {
    setRecording(settings.value("record", true).toBool());
    setLimit(settings.value("record_limit_mb", 0).toInt());
}

void ReplayDesk::save(SettingsSheet& settings) const {
    settings.setValue("record", control_.recording());
    settings.setValue("record_limit_mb", limit_mb_);
}

void ReplayDesk::askForLimit() {
    constexpr int most_mb = 1'000'000;
    widgets::askForNumber(
        window_, tr("Size of recordings"),
        tr("Megabytes that each recording may have: at least %1, or 0 for no limit. Beyond them, its oldest\n"
           "part is deleted while it is being written; finished recordings are never touched.")
            .arg(least_limit_mb),
        limit_mb_, 0, most_mb,
        [this](int limit_mb) {
            setLimit(limit_mb);
            notices_.note("record-limit",
                          limit_mb_ == 0 ? tr("Recordings keep everything.")
                                         : tr("Each recording has at most %1 MB and keeps at least its newest eight "
                                              "tenths of that. What was recorded before the limit was set or lowered "
                                              "goes as a whole.")
                                               .arg(limit_mb_));
        },
        tr("no limit"));
}

void ReplayDesk::setLimit(int limit_mb) {
    limit_mb_ = limit_mb > 0 ? std::max(limit_mb, least_limit_mb) : 0;
    control_.setRecordingLimit(limit_mb_ > 0 ? mission::RecordingLimit(std::uint64_t(limit_mb_) * 1'000'000)
                                             : std::nullopt);
}

void ReplayDesk::setRecording(bool on) {
    control_.setRecording(on);
    action("file.record")->setChecked(on);
    show();
}

} // namespace usar::app
