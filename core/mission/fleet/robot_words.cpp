#include "core/mission/fleet/robot_words.h"

#include <cmath>

#include <QFileInfo>

#include "core/base/time_range.h"
#include "core/protocol/commands/spawn.h"

namespace usar::mission {

namespace {

/// True for a replay of which nothing has been played.
bool hasNotBegun(const RobotView& view) {
    return !view.recording.isEmpty() && view.figures.lines_received == 0;
}

QString liveStateText(const RobotView& view) {
    const auto tr = [](const char* text) { return QObject::tr(text); };
    if (hasNotBegun(view))
        return tr("not begun");
    if (view.link.state != link::LinkState::Connected)
        return tr("no link");
    if (view.figures.silent)
        return tr("silent");
    if (view.finished)
        return view.finished->success ? tr("done") : tr("ended early");
    if (view.figures.behavior_running && view.status)
        return QString::fromStdString(view.status->state);
    if (view.figures.spawned)
        return protocol::isStation(view.spawn.class_name) ? tr("listens") : tr("idle");
    return view.figures.spawn == SpawnState::Asked ? tr("spawning…") : tr("not spawned");
}

} // namespace

QString replayNameOf(const RecordingFacts& facts) {
    const auto name = facts.find("robot");
    return name == facts.end() || name->second.empty()
               ? QObject::tr("Replay")
               : QObject::tr("%1 replay").arg(QString::fromStdString(name->second));
}

QString titleText(const RobotView& view, std::optional<double> coverage_pct) {
    if (!view.status)
        return {};
    const auto tr = [](const char* text) { return QObject::tr(text); };
    const agent::BehaviorStatus& status = *view.status;
    QStringList words;
    const auto add = [&](const QString& text, std::optional<double> value) {
        if (value && std::isfinite(*value)) // Adding 0 takes the minus from -0.
            words << text.arg(std::round(*value) + 0.0, 0, 'f', 0);
    };
    const auto addTime = [&](const QString& text, Seconds span) {
        if (std::isfinite(span.count()))
            words << text.arg(QString::fromStdString(countdownText(span)));
    };
    add(tr("%1 %"), status.progress_pct);
    words << QString::fromStdString(status.state);
    add(tr("%1 % covered"), coverage_pct);
    add(tr("%1 m traveled"), status.distance_flown_m);
    addTime(tr("%1 elapsed"), Seconds(std::floor(status.elapsed.count())));
    if (status.time_left)
        addTime(tr("%1 left"), *status.time_left);
    add(tr("%1 m range left"), status.range_left_m);
    return words.join(QStringLiteral(" · "));
}

QString robotsText(QStringList names) {
    constexpr int most_names = 3;
    if (names.size() > most_names)
        return QObject::tr("%1 robots").arg(names.size());
    const QString last = names.isEmpty() ? QString() : names.takeLast();
    return names.isEmpty() ? last : QObject::tr("%1 and %2").arg(names.join(QStringLiteral(", ")), last);
}

QString savedText(const QString& robot_name, const QStringList& files) {
    const QString count = files.size() == 1 ? QObject::tr("1 file") : QObject::tr("%1 files").arg(files.size());
    return QObject::tr("Saved the scan of %1: %2 in %3.").arg(robot_name, count, QFileInfo(files.value(0)).path());
}

QString exportedText(const QString& robot_name, const QStringList& files) {
    QStringList names;
    for (const QString& file : files)
        names << QFileInfo(file).fileName();
    return QObject::tr("Exported the map of %1 to %2: %3.")
        .arg(robot_name, QFileInfo(files.value(0)).path(), names.join(QStringLiteral(", ")));
}

bool isStale(const RobotView& view) {
    if (hasNotBegun(view))
        return false;
    const bool is_there = view.figures.spawned || !view.recording.isEmpty();
    return view.link.state != link::LinkState::Connected || !is_there || view.figures.silent;
}

QString stateText(const RobotView& view) {
    return view.recording.isEmpty() ? liveStateText(view) : QObject::tr("replay · %1").arg(liveStateText(view));
}

QString deviceText(const ControlState& state) {
    if (!state.held)
        return {};
    const bool named = *state.held == HandSource::Gamepad && !state.device.empty();
    return QString::fromStdString(named ? state.device : wordOf(*state.held));
}

QString driveNote(const ControlState& state, bool taken) {
    if (!taken)
        return state.reins == Reins::Behavior ? QObject::tr("Taking control pauses the behavior.") : QString();
    if (!state.hindrance.empty())
        return QString::fromStdString(state.hindrance);
    if (state.learning)
        return QObject::tr("Asking the server how it is driven…");
    if (state.held)
        return {};
    return state.last_stop.empty()
               ? QObject::tr("Hold a key, the pad or a gamepad's stick. Space stops, Shift drives slower.")
               : QObject::tr("Stopped: %1.").arg(QString::fromStdString(state.last_stop));
}

Absence whyNotDriven(const RobotView* view) {
    const auto tr = [](const char* text) { return QObject::tr(text); };
    if (!view)
        return {tr("No robot yet"), tr("Double-click a start pose on the map; then drive it from here.")};
    const QString name = QString::fromStdString(view->spawn.robot_name);
    if (!view->recording.isEmpty())
        return {tr("A recording cannot be driven"), tr("What it shows has happened already.")};
    if (protocol::isStation(view->spawn.class_name))
        return {tr("%1 does not move").arg(name), tr("It is a base station.")};
    if (view->link.state != link::LinkState::Connected)
        return {tr("No link to %1").arg(name),
                tr("The server removes a robot with its connection. Spawn it again when connected.")};
    if (!view->figures.spawned)
        return {tr("%1 is not there").arg(name), tr("It can be driven once it is spawned.")};
    return {};
}

Absence whyNoPicture(const RobotView* view, const PictureFacts& facts) {
    const auto tr = [](const char* text) { return QObject::tr(text); };
    const QString remedy = facts.classes_with_camera.isEmpty()
                               ? tr("Spawn a robot that has a camera.")
                               : tr("Spawn a robot that has one: %1.").arg(facts.classes_with_camera.join(", "));
    if (!view)
        return {tr("No robot yet"), tr("Pictures of the selected robot's camera appear here. %1").arg(remedy)};
    const QString name = QString::fromStdString(view->spawn.robot_name);
    if (!view->recording.isEmpty())
        return {tr("A recording has no pictures"), tr("Pictures come from a server while a robot runs.")};
    if (!facts.live)
        return {tr("%1 is not there").arg(name), tr("Its pictures appear here once it is spawned.")};
    if (!facts.has_camera)
        return {tr("%1 has no camera").arg(name),
                tr("%1 carries none. %2").arg(QString::fromStdString(view->spawn.class_name).section('.', -1), remedy)};
    if (!facts.has_server)
        return {tr("No image server"),
                tr("The embedded simulator could not open a port for pictures. Disconnect, then connect again.")};
    return {};
}

Absence whyNoObjects(bool connected, const WorldView& world) {
    const QString trouble = QString::fromStdString(world.trouble);
    if (!connected)
        return {QObject::tr("No world yet"),
                QObject::tr("Connect to a server; then things can be put into its world from here.")};
    if (world.state == WorldState::Refused)
        return {QObject::tr("No world controller"), trouble};
    if (world.state != WorldState::Ready && world.things.empty())
        return {QObject::tr("Asking the server…"), trouble};
    return {};
}

QString whyNoLookBack(const RobotView* view) {
    if (!view)
        return QObject::tr("No robot is selected");
    if (!view->recording.isEmpty())
        return QObject::tr("This is a replay: its slider moves map and sensors, too");
    return view->figures.recording ? QString()
                                   : QObject::tr("This robot is not being recorded; Ctrl+Alt+R starts recording");
}

} // namespace usar::mission
