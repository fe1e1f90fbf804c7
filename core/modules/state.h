// The robot's state: the newest STA, its mission packages and effecters, and the protocol's clock, which behaviors use.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/protocol/info_message.h"

namespace usar::modules {

/// Plain data, which its owner feeds with every info line of the connection.
class StateModule {
public:
    void take(const protocol::InfoLine& line);

    /// The newest STA; nullopt before the first.
    const std::optional<protocol::RobotState>& latest() const { return latest_; }
    /// The line number of that STA; 0 before the first.
    LineNumber line() const { return line_; }
    /// The newest state of each mission package (camera, arm …) and each effecter, in the order in which they first
    /// reported; at most `most_parts` of each, because more are garbage. Names are compared ignoring case. Pointers are
    /// nullptr for unknown names and valid until the next `take`.
    const std::vector<protocol::PackageState>& packages() const { return packages_; }
    const protocol::PackageState* package(std::string_view name) const;
    const std::vector<protocol::EffecterState>& effecters() const { return effecters_; }
    const protocol::EffecterState* effecter(std::string_view name) const;
    static constexpr std::size_t most_parts = 64;

    /// The time of the newest STA; zero before the first. Never runs backward, unless the very first time is
    /// contradicted by the next two STA. A jump ahead by more than `jump_limit` is believed only if the next STA
    /// continues from it: otherwise a damaged time would stop the clock until the world has caught up.
    Seconds now() const { return now_; }

    static constexpr Seconds jump_limit{10.0};

private:
    /// None: no time yet. First: only one STA has given a time. Confirmed: another one continued from it.
    enum class Trust { None, First, Confirmed };
    void takeTime(Seconds time);

    std::optional<protocol::RobotState> latest_;
    std::vector<protocol::PackageState> packages_;
    std::vector<protocol::EffecterState> effecters_;
    LineNumber line_;
    Seconds now_{0.0};
    std::optional<Seconds> doubted_; ///< a distant time that no other STA has confirmed yet
    Trust trust_ = Trust::None;      ///< in `now_`
};

} // namespace usar::modules
