// What a recording holds of a mission that was cut off: what was to be flown, and what was scanned.
#pragma once

#include <optional>
#include <string>

#include <QString>

#include "core/base/result.h"
#include "core/link/recording_reader.h"
#include "core/mission/files/flown_mission.h"
#include "core/mission/session/earlier_scan.h"

namespace usar::mission {

/// A plain value that crosses threads.
struct RecordedScan {
    FlownMission flown;
    std::string robot_name;
    std::optional<Pose> start_in_map; ///< pose at which the robot was spawned; absent: unknown
    bool finished = false;            ///< the behavior has ended, by itself or by an order
    EarlierScan scan;
    Rectangle rest_in_map; ///< what the map lacks of the area (remainingArea); empty: nothing
    std::string missing;   ///< sentences: which parts of which recordings the map lacks; empty: none
};

/// A recording's whole map.
struct RecordedMap {
    ScanRecord record;
    std::string missing; ///< as in RecordedScan
};

/// Edge of the height map's cells as the recording's facts tell it; that of a new mission where they do not.
double cellSizeOf(const link::RecordingSurvey& survey);

/// Plays the recording through the code of a session, without its pace, and returns its newest mission; a recording
/// that continues others includes what they scanned. An error names the file: it cannot be read, no mission is noted in
/// it, or the mission has no area of which something could be left. Takes a second for an hour of flight, so do not
/// call it in the GUI thread.
/// `with_scans`: its record also has the scans.
Result<RecordedScan> readRecordedScan(const QString& path, bool with_scans = false);

/// Plays the recording in the same way and returns its whole map with what is known about it, also of a flight without
/// a mission or an area. A robot that scanned nothing has an empty raster. `with_scans`: also the scans, those of the
/// recordings that it continues included.
Result<RecordedMap> readRecordedMap(const QString& path, bool with_scans = false);

/// Returns true if a behavior was in the midst of a mission when the recording broke off. Reads the whole file, without
/// playing it; false if it cannot be read.
bool brokeOffInMission(const QString& path);

/// The mission that flies the rest: that of the recording with the smaller area.
Mission missionOfRest(const RecordedScan& recorded);

} // namespace usar::mission
