// Short texts of the window about a robot: its state, who drives it, and why it cannot be driven by hand.
#pragma once

#include <optional>

#include <QStringList>

#include "core/mission/fleet/robot.h"
#include "core/mission/world/world_session.h"

namespace usar::mission {

/// True if what is known of the robot may be out of date: it has no link to its server, is not (or no longer) in the
/// world, or is silent. A replay that has not begun has nothing to lose.
bool isStale(const RobotView& view);
/// The robot's state, as the list of robots shows it: "idle", "no link", or the behavior's own word. A replay is marked
/// as one.
QString stateText(const RobotView& view);

/// Tells in a title what the running behavior has done: "42 % · scanning lane 4 of 9 · 37 % covered · 120 m traveled ·
/// 0:45 elapsed · 1:03 left · 310 m range left", without what is not known; empty before its first status. Times are on
/// the protocol clock. `coverage_pct`: see Robot.
QString titleText(const RobotView& view, std::optional<double> coverage_pct);

/// "R1", "R1 and R2", "R1, R2 and R3", "4 robots"; empty without a robot.
QString robotsText(QStringList names);

/// "R1 replay": what the robot of a recording with these facts is called.
QString replayNameOf(const RecordingFacts& facts);

/// Says that the robot's scan was saved, and in which folder. `files`: their full paths, at least one.
QString savedText(const QString& robot_name, const QStringList& files);
/// Says into which folder the robot's map was exported, and into which files of it.
QString exportedText(const QString& robot_name, const QStringList& files);

/// Name of the device by which the user drives the robot now; empty if none is held.
QString deviceText(const ControlState& state);
/// A sentence for the user who drives the robot or could take it: what is missing, why it stopped, or what to do. Empty
/// if there is nothing to say. `taken`: the user has control, or has requested it.
QString driveNote(const ControlState& state, bool taken);

/// Says why something cannot be shown, and what to do.
struct Absence {
    QString title; ///< empty: nothing is missing
    QString hint;
};
/// Why the robot cannot be driven by hand. `view` null: no robot is selected.
Absence whyNotDriven(const RobotView* view);
/// The known facts about the pictures of a robot's camera.
struct PictureFacts {
    bool live = false;               ///< the robot is spawned and connected, and no replay
    bool has_camera = true;          ///< false: it is known to have none
    bool has_server = true;          ///< false: the embedded simulator has no image server
    QStringList classes_with_camera; ///< without package; empty: unknown
};
/// Why there can be no picture of the robot's camera. `view` null: no robot is selected.
Absence whyNoPicture(const RobotView* view, const PictureFacts& facts);
/// Why the recording of the running robot cannot be looked at; empty if it can. `view` null: no robot is selected.
QString whyNoLookBack(const RobotView* view);

/// Why no objects of the world can be edited. `connected`: to a server of robots.
Absence whyNoObjects(bool connected, const WorldView& world);

} // namespace usar::mission
