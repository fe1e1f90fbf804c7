// What a session tells its user: each notice has a topic, and a complaint stands until its topic is over.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "core/base/clock.h"
#include "core/mission/session/session_update.h"

namespace usar::mission {

/// What a notice is about. Topics of which there are several at once (a sensor, a kind of damaged line, an event of a
/// behavior) are told apart by a further word.
enum class Topic {
    Behavior,
    CellSize,
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

/// Notice::topic of this topic; `which` is the further word, empty where there is none.
std::string textOf(Topic topic, std::string_view which = {});

/// "2.5 s", as notices name spans of time.
std::string spanText(Seconds span);

/// Gives notices to its taker at once, in the order of the calls, and keeps which complaints stand. Belongs to one
/// session and its thread.
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
    /// Ends the problems that belong to a connection which is lost: all but its loss itself and a failed spawn.
    void endThoseOfTheConnection();
    /// Ends all problems but a missing connection, which ends only with a new one.
    void endAll();
    /// While muted, nothing is reported, but what stands is still kept.
    void mute(bool on) { muted_ = on; }

private:
    Taker taker_;
    std::map<std::string, Topic> standing_; ///< reported and not over, by the text of the topic
    bool muted_ = false;
};

} // namespace usar::mission
