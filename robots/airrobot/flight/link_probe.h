// Measures how late the link is by questions whose answers the robot does not need.
#pragma once

#include <array>
#include <optional>

#include "core/agent/command_port.h"
#include "core/protocol/info_message.h"

namespace usar::airrobot {

/// A question and its answer go the way of commands and readings, and the readings bear the time of the server, so what
/// passes between the two is the delay both ways. Where questions stay open, the link is at least as late as the oldest
/// one is old: what is read then is an old backlog, and no command has arrived since. Owned by one robot.
class LinkProbe {
public:
    /// Takes every info line.
    void hear(const protocol::InfoMessage& message);
    /// Judges the answers that came since the last tick, and asks again when it is time. Call it once per tick while
    /// nobody else asks questions.
    void step(Seconds now, agent::CommandPort& port);
    /// How much later than usual answers come; nullopt as long as none has come.
    std::optional<Seconds> late() const { return late_; }

private:
    /// There are as many questions as can be told apart by their answers.
    static constexpr std::size_t kinds = 4;
    struct Asked {
        Seconds at{0.0};
        bool open = false;
    };

    void take(std::size_t kind, Seconds now);
    void ask(Seconds now, agent::CommandPort& port);
    /// How late the link is at least, because of the open questions; 0 if that is not sure.
    Seconds openFor(Seconds now) const;

    std::array<Asked, kinds> asked_{};
    std::array<bool, kinds> heard_{}; ///< answers since the last tick
    std::size_t next_ = 0;
    std::optional<Seconds> asked_at_;
    std::optional<Seconds> measured_; ///< by the newest question that was answered
    std::optional<Seconds> late_;
};

} // namespace usar::airrobot
