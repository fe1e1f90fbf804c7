// Detection of what is missing in a session: an answer, a robot, a sensor.
#include "core/mission/session/robot_session_private.h"

#include <utility>

#include "core/base/numbers.h"

namespace usar::mission {

namespace {

std::string inWords(Seconds span) {
    std::string text;
    appendShortest(text, span.count());
    return text + " s";
}

} // namespace

void RobotSession::Private::watch() {
    watchSilence();
    watchSensors();
    watchQueue();
    if (!figures.lockstep && !congested()) // Nothing else releases drives while the protocol clock stands still.
        sendDrive(true);
    if (const auto overlong = link.overlongCount(); overlong != figures.lines_overlong) {
        figures.lines_overlong = overlong;
        say(Severity::Warning, "overlong",
            "The server sent a line longer than 4 MiB. It was left out; reading goes on behind it.");
    }
    touched();
}

void RobotSession::Private::watchSilence() {
    const auto passed = [](QElapsedTimer& since, Seconds limit) {
        return since.hasExpired(toMilliseconds(limit).count());
    };
    if (!start_poses_settled && passed(since_opened, limits.greeting)) {
        start_poses_settled = true;
        trouble(Severity::Warning, "start poses",
                "No start poses from the server for " + inWords(limits.greeting) +
                    ". Is it USARSim, and is its game running? A robot can still be spawned at "
                    "a typed pose.");
    }
    if (figures.spawn == SpawnState::Asked && passed(since_init, limits.spawn))
        failSpawn(SpawnState::Failed,
                  "Nothing from " + request.robot_name + " for " + inWords(limits.spawn) +
                      " after INIT. Does the server know " + request.class_name +
                      ", is the start pose free and above the ground, and is the simulation not paused? Spawn "
                      "again to try once more.");
    const bool silent_by_nature = protocol::isStation(request.class_name) || step_held || silence_expected;
    if (figures.spawn == SpawnState::Done && !silence_said && !silent_by_nature && passed(since_data, limits.stale)) {
        silence_said = true;
        trouble(Severity::Warning, "silence",
                "Nothing from " + request.robot_name + " for " + inWords(limits.stale) +
                    ": its values are stale. Is the simulation paused, or the network down?");
    }
}

void RobotSession::Private::watchQueue() {
    if (congested() && !troubles.contains("queue"))
        trouble(Severity::Warning, "queue",
                "The server at " + placeOf(link.status()) +
                    " reads slower than commands are sent: " + fixed(static_cast<double>(link.unsentBytes()) / 1e3, 0) +
                    " kB wait. Until it reads on, the newest drive replaces older ones. Is it busy or stopped?");
    else if (link.unsentBytes() == 0)
        over("queue", "The server reads commands again.");
}

void RobotSession::Private::watchSensors() {
    for (const std::string& name : sensors.newlySilent(figures.now)) {
        const auto& latest = state->latest();
        const bool flat = latest && latest->battery_left && latest->battery_left->count() <= 0.0;
        trouble(Severity::Warning, "sensor: " + name,
                "No reading from " + name + " for " + inWords(limits.sensor_silence) +
                    " of the robot's time; the last value stays, marked as old. " +
                    (flat ? "The battery is empty." : "Stop the robot if it needs this sensor."));
    }
}

} // namespace usar::mission
