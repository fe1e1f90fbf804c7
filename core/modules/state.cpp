#include "core/modules/state.h"

#include <algorithm>

#include "core/base/text.h"

namespace usar::modules {

namespace {

template <class Part>
const Part* partOf(const std::vector<Part>& parts, std::string_view name) {
    const auto part = std::ranges::find_if(parts, [name](const Part& one) { return sameWord(one.name, name); });
    return part == parts.end() ? nullptr : &*part;
}

template <class Part>
void replace(std::vector<Part>& parts, const Part& newest) {
    if (const Part* const known = partOf(parts, newest.name))
        parts[static_cast<std::size_t>(known - parts.data())] = newest;
    else if (parts.size() < StateModule::most_parts)
        parts.push_back(newest);
}

} // namespace

const protocol::PackageState* StateModule::package(std::string_view name) const {
    return partOf(packages_, name);
}

const protocol::EffecterState* StateModule::effecter(std::string_view name) const {
    return partOf(effecters_, name);
}

void StateModule::take(const protocol::InfoLine& line) {
    if (const auto* const package = std::get_if<protocol::PackageState>(&line.message))
        replace(packages_, *package);
    else if (const auto* const effecter = std::get_if<protocol::EffecterState>(&line.message))
        replace(effecters_, *effecter);
    const auto* const state = std::get_if<protocol::RobotState>(&line.message);
    if (!state)
        return;
    latest_ = *state;
    line_ = line.number;
    if (state->time)
        takeTime(*state->time);
}

void StateModule::takeTime(Seconds time) {
    const auto follows = [time](Seconds earlier) { return time >= earlier && time - earlier <= jump_limit; };
    if (trust_ == Trust::None) {
        now_ = time;
        trust_ = Trust::First;
    } else if (follows(now_) || (doubted_ && follows(*doubted_))) {
        now_ = time;
        trust_ = Trust::Confirmed;
        doubted_.reset();
    } else if (time > now_ || (trust_ == Trust::First && now_ - time > jump_limit)) {
        doubted_ = time;
    } else {
        doubted_.reset();
    }
}

} // namespace usar::modules
