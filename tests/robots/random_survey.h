// Surveys that nobody chose: world, start, area and weather are drawn from a number, so that a change to the AirRobot
// can be tried where it was not made.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/agent/behavior.h"
#include "core/base/geometry.h"
#include "core/sim/world/world.h"
#include "tests/robots/random_fault.h"

namespace usar::test {

/// A mission, complete: the same one flies the same way each time.
struct RandomSurvey {
    int number = 0;
    std::string world; ///< as makeWorld takes it
    std::uint64_t world_seed = 1;
    std::uint64_t noise_seed = 1;
    std::string behavior; ///< "airrobot/cpp" or "airrobot/posh"
    Pose start_in_map;
    Rectangle area_in_map;
    double wind_m_s = 0.0;
    double wind_toward_rad = 0.0; ///< counterclockwise from the map's x axis
    std::string preset{};         ///< names one of the behavior, such as "balanced"; if it is empty, the defaults hold
    std::optional<RandomFault> fault{};

    /// One line for a log.
    std::string text() const;
};

/// How it went.
struct SurveyOutcome {
    bool ended = false;   ///< by itself, within ten hours of simulated time
    bool success = false; ///< never with a broken robot, see mission::judgeDamage
    bool broken = false;  ///< or crashed, by its own account
    int collisions = 0;
    double elapsed_s = 0.0;
    double coverage_pct = 0.0;
    /// Of what can be reached from the start; nullopt if that is nothing, or nothing is on the map.
    std::optional<double> reachable_coverage_pct{};
    double height_m = 0.0; ///< the base is so far above what lies under it when the flight is over
    std::string reason;

    /// It says that the area is scanned, and of nothing that it left out, but much of what can be reached is not on the
    /// map.
    bool isFalseSuccess() const;
    std::string text() const;
};

/// Draws a mission in which nothing breaks. Equal numbers give equal missions.
RandomSurvey drawSurvey(int number);
/// The same mission with a fault.
RandomSurvey drawFaultySurvey(int number);

/// If the environment variable USAR_TRACE is set, it writes to the console what the robot does at each tick.
SurveyOutcome fly(const RandomSurvey& survey);

/// Rows of a Qt test with the column `number`, from `first` to before `last`.
void surveyRows(int first, int last);
/// The same, or the numbers that the environment variable USAR_SURVEYS asks for, "3100-3159".
void surveyRowsOrAsked(int first, int last);
/// Flies it, says how it went, and demands that the mission ended by itself and that the robot is whole.
void tryRandomSurvey(int number, const std::string& preset = {});
/// Flies it with its fault, says how it went, and demands that the mission ended by itself and is no false success.
/// Returns true if the robot broke although the fault left it able to fly.
bool tryFaultySurvey(int number);

} // namespace usar::test
