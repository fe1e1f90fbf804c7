#include "core/mission/session/hand_hold.h"

#include <algorithm>
#include <utility>

namespace usar::mission {

namespace {

constexpr Seconds shortest_silence{1.0};
constexpr Seconds longest_spacing{3.0}; // Longest time between two STA, at the slowest speed of a simulator.

} // namespace

std::string lettingGo(HandSource source) {
    return "the " + wordOf(source) + (source == HandSource::Keys ? " were" : " was") + " let go";
}

void HandHold::tick(Seconds wall) {
    tick_spacing_ = std::min(wall - last_tick_, longest_spacing);
    last_tick_ = wall;
}

HandHold::Change HandHold::accept(const HandIntent& intent, Seconds wall) {
    using Verdict = HandControl::Verdict;
    const bool held_before = holding();
    const Verdict verdict = driver_.accept(intent, wall);
    if (verdict == Verdict::Released)
        return Change::Ends;
    return verdict == Verdict::Held && !held_before ? Change::Begins : Change::None;
}

std::optional<std::string> HandHold::reasonToStop(Seconds wall, Seconds patience,
                                                  std::optional<Seconds> robot_silent_for,
                                                  const std::string& robot_name) const {
    if (driver_.overdue(wall, patience))
        return "nothing was heard from the input device";
    if (robot_silent_for && *robot_silent_for > std::max(shortest_silence, 4.0 * tick_spacing_))
        return robot_name + " is silent";
    return std::nullopt;
}

HandCommands HandHold::question(Seconds now) {
    HandCommands asked{{}, {"how it is driven"}};
    if (auto question = driver_.question(now))
        asked.commands.push_back(*std::move(question));
    return asked;
}

HandCommands HandHold::advance() {
    HandDriver::Commands commands = driver_.advance(beat);
    return {std::move(commands), {driver_.holderText()}};
}

HandCommands HandHold::repeat(Seconds now) {
    HandDriver::Commands commands = driver_.repeat(now);
    return {std::move(commands), {driver_.holderText()}};
}

HandCommands HandHold::stop(const std::string& reason) {
    return {driver_.stop(reason), {"stop, " + reason}};
}

} // namespace usar::mission
