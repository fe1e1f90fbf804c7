// A moment of a recorded flight, and the test that is made of it.
#pragma once

#include <atomic>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QString>

#include "core/base/result.h"
#include "core/mission/files/claim.h"
#include "core/mission/files/flown_mission.h"

namespace usar::mission {

/// A value and the time at which it was told.
template <class Value>
struct ToldAt {
    Seconds time{0.0};
    Value value{};
    bool operator==(const ToldAt&) const = default;
};

/// What a recording tells about a moment and the time around it. A plain value that crosses threads; times count from
/// the start of the behavior, on the protocol clock.
struct FlightMoment {
    FlownMission flown;   ///< It was being flown; its faults are those that had begun, and its own that were to come.
    Seconds at{0.0};      ///< This is the moment itself.
    Seconds first{0.0};   ///< What is told begins here
    Seconds last{0.0};    ///< and ends here.
    bool by_hand = false; ///< Somebody drove before the moment, which no test repeats.
    bool late = false;    ///< The robot had been there for a while when the behavior started.
    std::vector<ToldAt<double>> heights_m;   ///< They are above the robot's place when the behavior started.
    std::vector<ToldAt<std::string>> states; ///< The behavior published them, the same one at many ticks.
    std::map<std::string, std::vector<Seconds>> element_runs; ///< These are the times at which each element ran.
};

/// Reads a recording up to `reach` after the moment, `now` on the protocol clock. An error names the file: it cannot be
/// read, or no mission is noted in it before the moment. Reads the whole recording up to there, so do not call it in
/// the GUI thread; it gives up with an error once `given_up` is true.
Result<FlightMoment> readFlightMoment(const QString& path, Seconds now, const std::atomic_bool& given_up,
                                      Seconds reach = Seconds{60.0});

/// Whether the claim held in the flight; nullopt if the recording does not tell, or not all of it.
std::optional<bool> heldIn(const FlightMoment& moment, const Claim& claim);

/// True if a test has other noise and drift than the flight, so that it comes to the same only roughly.
bool isRepeatedRoughly(const FlightMoment& moment);

/// A claim about what must be seen once begins so much earlier and ends so much later if the flight is repeated
/// roughly.
inline constexpr Seconds rough_slack{10.0};

/// Claims about the time from `from` to `to`: those that held, then those that the recording does not tell, then those
/// that did not hold, though they should. Heights are rounded to half a meter beyond what was flown. If the flight is
/// repeated roughly, heights get a meter more, what must be seen once gets `rough_slack`, and the first claim is that
/// there is no contact, because it asks for the least.
std::vector<Claim> claimsToOffer(const FlightMoment& moment, Seconds from, Seconds to);

/// The mission that flies up to the claim and checks it.
Mission testOf(const FlightMoment& moment, const Claim& claim, const std::string& name);

} // namespace usar::mission
