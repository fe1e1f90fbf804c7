// Asks a robot for what its instruments must know: where its sensors are, how far they reach, how its joints move.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/modules/query.h"

namespace usar::mission {

/// Asks GETGEO and GETCONF for the robot itself and for the kinds of sensors and parts that it was heard to have, once
/// for each kind. To be fed with every line of one robot. Of two questions of a kind a server answers only the newest,
/// so `next` must not be called while a behavior or a hand asks its own. A value with no clock of its own.
class EquipmentQuestions {
public:
    /// Protocol clock. Nothing is asked before: until then a behavior that starts at once asks its own, and after it
    /// every sensor that sends regularly has been heard.
    static constexpr Seconds patience{1.0};

    /// `now` is the protocol clock at this line.
    void take(const protocol::InfoLine& line, Seconds now);
    /// The questions to send now; at most one of each kind waits for its answer.
    std::vector<protocol::Command> next(Seconds now);

private:
    void wonder(const std::string& type, bool where, bool what);

    modules::GeometryModule geometry_;
    modules::ConfigurationModule configuration_;
    std::set<std::string> wondered_; ///< the types that were asked for
    std::optional<Seconds> first_heard_;
};

} // namespace usar::mission
