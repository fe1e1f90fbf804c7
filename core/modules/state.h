// The robot's state: the newest STA, its mission packages and effecters, and the protocol clock that behaviors live by.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/protocol/info_message.h"

namespace usar::modules {

/// Fed by its owner with every info line; a value otherwise.
class StateModule {
public:
    void take(const protocol::InfoLine& line);

    /// Nothing until the first STA.
    const std::optional<protocol::RobotState>& latest() const { return latest_; }
    LineNumber line() const { return line_; }
    /// Mission packages (camera, arm …) and effecters, newest state of each, in the order in which they first spoke; at
    /// most `most_parts` of each, for more are garbage. Pointers live until the next `take`.
    const std::vector<protocol::PackageState>& packages() const { return packages_; }
    const protocol::PackageState* package(std::string_view name) const;
    const std::vector<protocol::EffecterState>& effecters() const { return effecters_; }
    const protocol::EffecterState* effecter(std::string_view name) const;
    static constexpr std::size_t most_parts = 64;

    /// Time of the newest STA; zero before it. Never runs backward, but for a first time that the next two STA deny. A
    /// jump of more than `jump_limit` is believed when the next STA goes on from it: a damaged time must not stop the
    /// clock until the world has caught up.
    Seconds now() const { return now_; }

    static constexpr Seconds jump_limit{10.0};

private:
    enum class Trust { None, First, Confirmed };
    void takeTime(Seconds time);

    std::optional<protocol::RobotState> latest_;
    std::vector<protocol::PackageState> packages_;
    std::vector<protocol::EffecterState> effecters_;
    LineNumber line_;
    Seconds now_{0.0};
    std::optional<Seconds> doubted_; ///< a far time that nothing has confirmed yet
    Trust trust_ = Trust::None;      ///< in `now_`
};

} // namespace usar::modules
