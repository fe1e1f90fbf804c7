// A moment of a recorded flight, and the test that is made of it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QString>

#include "core/base/result.h"
#include "core/mission/files/claim.h"
#include "core/mission/files/flown_mission.h"

namespace usar::mission {

/// A value and the time since the robot appeared at which it began.
template <class Value>
struct Since {
    Seconds time{0.0};
    Value value{};
    bool operator==(const Since&) const = default;
};

/// What a recording tells about a moment and the time around it. A plain value that crosses threads; times count from
/// the robot's first message, on the protocol clock.
struct FlightMoment {
    FlownMission flown;                     ///< mission that was being flown; its faults are those that had begun
    Seconds at{0.0};                        ///< the moment itself
    Seconds first{0.0};                     ///< what is told begins here
    Seconds last{0.0};                      ///< and ends here
    bool by_hand = false;                   ///< Somebody drove before the moment, which no test repeats.
    std::vector<Since<double>> heights_m;   ///< above the place where the robot appeared; see ClaimWatch
    std::vector<Since<std::string>> states; ///< each until the next one
    std::map<std::string, std::vector<Seconds>> element_runs; ///< when each element of the plan ran
};

/// A claim that may be made, with what the recording says about it.
struct ClaimOffer {
    Claim claim;
    std::optional<bool> held{}; ///< It is absent if the recording does not tell.
    bool operator==(const ClaimOffer&) const = default;
};

/// Reads a recording up to `reach` after the moment, `now` on the protocol clock. An error names the file: it cannot be
/// read, or no mission is noted in it. Takes a second for an hour of flight, so do not call it in the GUI thread.
Result<FlightMoment> readFlightMoment(const QString& path, Seconds now, Seconds reach = Seconds{60.0});

/// Claims about the time from `from` to `to`: first those that held, then those that the recording does not tell, then
/// elements of the plan that rested. Heights are rounded to half a meter beyond what was flown.
std::vector<ClaimOffer> claimsToOffer(const FlightMoment& moment, Seconds from, Seconds to);

/// The mission that flies up to the claim and checks it.
Mission testOf(const FlightMoment& moment, const Claim& claim, const std::string& name);

} // namespace usar::mission
