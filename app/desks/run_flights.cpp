#include "app/desks/run_flights.h"

#include <utility>

#include <QDir>
#include <QFile>
#include <QJsonArray>

#include "core/campaign/plan/shell_word.h"
#include "core/campaign/plan/shell_words.h"
#include "core/mission/files/mission_check.h"
#include "core/server/embedded/program_files.h"
#include "core/server/embedded/simulator_files.h"
#include "widgets/panels/compare_dialog.h"

namespace usar::app {

namespace {

/// Arguments of usar-mission, without the program's name. A mission that is not found from here is looked for from the
/// campaign's folder, which may have come from another place with its missions.
Result<QStringList> argumentsOf(const campaign::RunResult& run, const QString& folder) {
    auto words = campaign::shellWords(run.command);
    if (!words)
        return words;
    if (words->value(1) != "run" || words->size() < 3)
        return failure("this result does not say how its run is flown", "run " + std::to_string(run.number),
                       "Fly the campaign anew");
    if (QString& file = (*words)[2]; QDir::isRelativePath(file) && !QFile::exists(file))
        file = QDir::cleanPath(QDir(folder).filePath(file));
    return words->mid(1);
}

QString nameOf(const campaign::RunResult& run) {
    return RunFlights::tr("run %1 (%2, seed %3)")
        .arg(run.number)
        .arg(QString::fromStdString(run.variant))
        .arg(run.seed);
}

} // namespace

Result<QString> wholeCommandOf(const campaign::RunResult& run, const QString& folder) {
    return argumentsOf(run, folder).map([](const QStringList& arguments) {
        QString command = "usar-mission";
        for (const QString& argument : arguments)
            command += ' ' + campaign::shellWord(argument);
        return command;
    });
}

Result<RunOrder> orderOf(const campaign::RunResult& run, const QString& folder) {
    const auto arguments = argumentsOf(run, folder);
    if (!arguments)
        return tl::unexpected(arguments.error());
    const auto options = mission::readMissionOptions(*arguments);
    if (!options)
        return tl::unexpected(options.error());
    auto mission = mission::readMissionFile(options->mission_file);
    if (!mission)
        return tl::unexpected(mission.error());
    if (const auto applied = mission::applyTo(*mission, *options); !applied)
        return tl::unexpected(applied.error());
    auto faults = server::readFaults(server::textsOf(mission->faults) + options->faults);
    if (!faults)
        return tl::unexpected(faults.error());
    mission->faults.clear();
    return RunOrder{*std::move(mission), options->seed, *std::move(faults)};
}

RunFlights::~RunFlights() = default;

void RunFlights::wire() {
    connect(&control_, &MissionControl::startPosesKnown, this, &RunFlights::begin);
    connect(&server_, &ServerDesk::loadingEnded, this, [this] { awaited_.reset(); });
    connect(&control_, &MissionControl::replayAdded, this, &RunFlights::takeReplay);
}

void RunFlights::fly(const campaign::RunResult& run, const QString& folder) {
    auto order = orderOf(run, folder);
    if (!order)
        return notices_.complain("campaign-run", order.error());
    if (!server_.openRun(QString::fromStdString(order->mission.world), order->seed, order->faults))
        return;
    awaited_ = *std::move(order);
    awaited_name_ = nameOf(run);
}

void RunFlights::begin(const protocol::StartPoses& poses) {
    if (!awaited_ || !control_.server().simulator.time_begins_with_robots)
        return;
    const RunOrder order = *std::exchange(awaited_, std::nullopt);
    const mission::Mission& mission = order.mission;
    const auto pose = mission::startPoseOf(mission, poses);
    if (!pose)
        return notices_.complain("campaign-run", pose.error());
    const auto values = control_.prepareMission(mission);
    if (!values)
        return notices_.complain("campaign-run", values.error());
    const auto id = control_.spawn({mission.robot_class, {}, *pose});
    if (!id)
        return notices_.complain("campaign-run", id.error());
    control_.robot(*id)->setTaskOptions(mission);
    // At once, and not when the robot has been heard: the behavior must not miss a line.
    const auto started = control_.startBehavior(*id, mission.behavior, mission.area_in_map, *values,
                                                QString::fromStdString(mission.plan), mission.isolate);
    if (!started)
        return notices_.complain("campaign-run", started.error());
    selection_.select(*id);
    views_.behavior->chooseBehavior(mission.behavior);
    task_.setUp(mission, *values);
    task_.takeBegun(*id);
    notices_.cure("campaign-run");
    notices_.note("campaign-flies", tr("R%1 flies %2 again.").arg(id->value).arg(awaited_name_));
}

void RunFlights::flyPair(const campaign::RunResult& first, const campaign::RunResult& second, const QString& folder) {
    if (pair_)
        return;
    const campaign::RunResult* const runs[] = {&first, &second};
    QStringList arguments[2];
    for (std::size_t i = 0; i < 2; ++i) {
        const auto words = argumentsOf(*runs[i], folder);
        if (!words)
            return notices_.complain("campaign-run", words.error());
        arguments[i] = *words;
    }
    pair_ = std::make_unique<Pair>();
    for (std::size_t i = 0; i < 2; ++i) {
        Side& side = pair_->sides[i];
        side.variant = QString::fromStdString(runs[i]->variant);
        side.title = tr("%1, seed %2").arg(side.variant).arg(runs[i]->seed);
        start(side, arguments[i], QDir(folder).filePath(QStringLiteral("again/%1").arg(runs[i]->number)));
    }
    notices_.note(
        "campaign-pair",
        tr("%1 and %2 are flown again in the background, for a comparison.").arg(nameOf(first), nameOf(second)));
    emit pairChanged();
}

void RunFlights::start(Side& side, const QStringList& arguments, const QString& folder) {
    QDir(folder).removeRecursively(); // The last comparison may have left files there.
    QDir().mkpath(folder);
    side.recording = QDir(folder).filePath(QStringLiteral("run.usarrec"));
    connect(&side.process, &campaign::RunProcess::ended, this,
            [this, &side](const campaign::ProcessEnd& end) { takeEnd(side, end); });
    side.process.start(server::missionProgram(), arguments + QStringList{"--out", folder, "--record", side.recording},
                       Seconds{campaign::Campaign{}.wall_limit_s});
}

void RunFlights::takeEnd(Side& side, const campaign::ProcessEnd& end) {
    campaign::RunResult run;
    campaign::judge(run, end);
    for (const QJsonValue file : run.summary["files"].toArray())
        if (file.toString().endsWith(".json"))
            side.summary = file.toString();
    if (side.summary.isEmpty())
        notices_.complain("campaign-run", {"the run left no results: " + run.reason, side.variant.toStdString(),
                                           "Fly it alone to see why"});
    if (--pair_->under_way == 0)
        QMetaObject::invokeMethod(this, &RunFlights::showPair, Qt::QueuedConnection); // It deletes the processes.
}

void RunFlights::showPair() {
    const std::unique_ptr<Pair> pair = std::exchange(pair_, nullptr);
    emit pairChanged();
    awaited_replays_.clear();
    replay_words_.clear();
    for (const RobotId id : std::exchange(replays_, {})) // One pair at a time; there is not room for many robots.
        if (const Robot* const robot = control_.robot(id); robot && robot->isReplay())
            control_.remove(id);
    for (const Side& side : pair->sides)
        if (QFile::exists(side.recording))
            awaited_replays_[side.recording] = side.variant;
    for (const Side& side : pair->sides)
        if (awaited_replays_.contains(side.recording))
            control_.openRecording(side.recording, {}, side.variant);
    if (auto* const dialog = window_->findChild<widgets::CompareDialog*>())
        dialog->clear();
    for (const Side& side : pair->sides)
        if (!side.summary.isEmpty())
            widgets::compareRuns(window_, side.summary, side.title);
}

void RunFlights::takeReplay(RobotId id) {
    const Robot* const replay = control_.robot(id);
    const auto awaited =
        replay ? awaited_replays_.extract(replay->view().recording) : decltype(awaited_replays_)::node_type();
    if (awaited.empty())
        return;
    replays_.push_back(id);
    replay_words_ << tr("%1 is %2").arg(mission::nameOf(*replay), awaited.mapped());
    if (!awaited_replays_.empty())
        return;
    notices_.note("campaign-pair",
                  replay_words_.join(", ") + tr(". They show the same time; the replay bar moves both."));
    emit togetherWanted(replays_);
}

} // namespace usar::app
