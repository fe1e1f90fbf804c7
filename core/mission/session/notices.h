// Notices from a session to its user: each has a topic, and a reported problem stands until its topic is over.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "core/base/clock.h"
#include "core/mission/session/session_update.h"

namespace usar::mission {

/// Subject of a notice. Topics that can occur several times at once (a sensor, a kind of damaged line, an event of a
/// behavior) are distinguished by a further word.
enum class Topic {
    Adjustment,
    Behavior,
    CellSize,
    Clock,
    Control,
    DamagedLine,
    FarParts,
    Fault,
    Link,
    NoConnection,
    NoRobot,
    Overlong,
    Placement,
    Queue,
    Recording,
    Replay,
    SecondRobot,
    Sensor,
    Silence,
    Spawn,
    StartPoses
};

/// Returns the text of the topic for Notice::topic; `which` is the further word, empty if there is none.
std::string textOf(Topic topic, std::string_view which = {});

/// Formats a time span as notices show it: "2.5 s".
std::string spanText(Seconds span);

/// Passes notices to its taker immediately, in the order of the calls, and remembers which problems stand. Belongs to
/// one session and its thread.
class Notices {
public:
    using Taker = std::function<void(const Notice& notice)>;
    explicit Notices(Taker taker) : taker_(std::move(taker)) {}

    /// Reports something that needs no later `over`.
    void say(Severity severity, Topic topic, std::string text, std::string_view which = {});
    /// Reports a problem that lasts until `over` is called with the same topic.
    void trouble(Severity severity, Topic topic, std::string text, std::string_view which = {});
    /// Reports the end of a problem; does nothing if there was no such problem.
    void over(Topic topic, std::string text = {}, std::string_view which = {});
    bool stands(Topic topic) const { return standing_.contains(textOf(topic)); }
    /// Ends a problem without a notice.
    void forget(Topic topic) { standing_.erase(textOf(topic)); }
    /// Ends the problems of a lost connection: all except the loss itself and a failed spawn.
    void endThoseOfTheConnection();
    /// Ends all problems except a missing connection, which ends only with a new one.
    void endAll();
    /// While muted, nothing is reported, but standing problems are still tracked.
    void mute(bool on) { muted_ = on; }

private:
    Taker taker_;
    std::map<std::string, Topic> standing_; ///< reported and not over, by the text of the topic
    bool muted_ = false;
};

} // namespace usar::mission
