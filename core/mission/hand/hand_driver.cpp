#include "core/mission/hand/hand_driver.h"

#include <algorithm>
#include <utility>

#include "core/protocol/silence.h"

namespace usar::mission {

namespace {

const std::string robot_type = "Robot";
constexpr Seconds longest_spacing{3.0}; // Longest time between two STA, at the slowest speed of a simulator.

} // namespace

std::string wordOf(HandSource source) {
    constexpr std::array words{"keys", "pad", "gamepad"};
    return words[static_cast<std::size_t>(source)];
}

std::string lettingGo(HandSource source) {
    return "the " + wordOf(source) + (source == HandSource::Keys ? " were" : " was") + " let go";
}

void HandControl::setOn(bool on) {
    letGo();
    on_ = on;
}

HandControl::Verdict HandControl::accept(const HandIntent& intent, Seconds wall) {
    Hand& hand = hands_[static_cast<std::size_t>(intent.source)];
    const bool holds = holder_ && holder_->source == intent.source;
    hand.moved = !clamped(intent.stick).centered();
    if (!hand.moved) {
        hand.spent = false;
        if (!holds)
            return Verdict::Ignored;
        holder_.reset();
        return Verdict::Released;
    }
    if (!on_ || (holder_ && !holds))
        hand.spent = true;
    if (hand.spent)
        return Verdict::Ignored;
    holder_ = intent;
    last_word_ = wall;
    return Verdict::Held;
}

void HandControl::letGo() {
    holder_.reset();
    for (Hand& hand : hands_)
        hand.spent = hand.moved;
}

void HandDriver::beginConnection() {
    const Ticks ticks = ticks_;
    *this = {};
    ticks_ = ticks;
}

void HandDriver::take(const protocol::InfoLine& line) {
    limits_.take(line.message);
    configuration_.take(line);
    geometry_.take(line);
    for ([[maybe_unused]] const auto& failure : configuration_.takeFailures())
        limits_.giveUpAsking();
    (void)geometry_.takeFailures(); // Without geometry, turns are cautious.
}

void HandDriver::tick(Seconds wall) {
    ticks_ = {wall, std::min(wall - ticks_.last, longest_spacing)};
}

HandCommands HandDriver::question(Seconds now) {
    HandCommands asked{{}, {"how it is driven"}};
    if (!on())
        return asked;
    auto question = configuration_.next(now);
    if (!question)
        question = geometry_.next(now);
    if (question)
        asked.commands.push_back(*std::move(question));
    return asked;
}

void HandDriver::setOn(bool on) {
    hands_.setOn(on);
    shaper_.reset();
    gait_.reset(); // A behavior may have put the legs anywhere.
    walked_ = false;
    last_stop_.clear();
    if (!on)
        return;
    configuration_.query(robot_type);
    geometry_.query(robot_type);
}

HandDriver::Change HandDriver::accept(const HandIntent& intent, Seconds wall) {
    using Verdict = HandControl::Verdict;
    HandIntent followed = intent;
    followed.stick = limits_.known() ? masked(intent.stick, limits_.axes()) : intent.stick;
    const bool held_before = holding();
    const Verdict verdict = hands_.accept(followed, wall);
    if (verdict == Verdict::Released)
        return Change::Ends;
    return verdict == Verdict::Held && !held_before ? Change::Begins : Change::None;
}

std::optional<std::string> HandDriver::reasonToStop(Seconds wall, Seconds patience,
                                                    std::optional<Seconds> robot_silent_for,
                                                    const std::string& robot_name) const {
    if (hands_.overdue(wall, patience))
        return "nothing was heard from the input device";
    if (robot_silent_for && *robot_silent_for > std::max(protocol::silence::driven_robot, 4.0 * ticks_.spacing))
        return robot_name + " is silent";
    return std::nullopt;
}

HandCommands HandDriver::byHolder(std::vector<protocol::Command> commands) const {
    const auto& holder = hands_.holder();
    const std::string name =
        !holder ? "nobody" : wordOf(holder->source) + (holder->device.empty() ? "" : ' ' + holder->device);
    return {std::move(commands), {name}};
}

HandCommands HandDriver::driveNow() const {
    if (auto drive = driveOf(limits_, shaper_.now(), said_share_))
        return byHolder({*std::move(drive)});
    return byHolder();
}

HandCommands HandDriver::advance() {
    if (!holding() || !limits_.known())
        return byHolder();
    const Stick before = shaper_.now();
    const Stick now = shaper_.follow(hands_.holder()->stick, beat);
    if (now == before && speedShare() == said_share_)
        return byHolder();
    said_share_ = speedShare();
    return driveNow();
}

HandCommands HandDriver::repeat(Seconds now) {
    if (!holding())
        return byHolder();
    if (limits_.style != DriveStyle::Walker)
        return shaper_.now().centered() ? byHolder() : driveNow();
    auto step = gait_.step(shaper_.now(), said_share_, now);
    if (!step)
        return byHolder();
    walked_ = true;
    return byHolder({*std::move(step)});
}

HandCommands HandDriver::stop(const std::string& reason) {
    hands_.letGo();
    shaper_.reset();
    last_stop_ = reason;
    HandCommands rest{{}, {"stop, " + reason}};
    if (limits_.style == DriveStyle::Walker) {
        if (std::exchange(walked_, false))
            rest.commands.push_back(gait_.stand());
    } else if (auto drive = driveOf(limits_, {}, 1.0)) {
        rest.commands.push_back(*std::move(drive));
    }
    return rest;
}

ControlState HandDriver::state() const {
    ControlState state;
    state.reins = on() ? Reins::Hand : Reins::Nobody;
    state.style = limits_.style;
    state.axes = limits_.axes();
    state.learning = on() && !limits_.known() && limits_.hindrance.empty();
    state.hindrance = limits_.hindrance;
    state.top_speed_m_s = limits_.topSpeed_m_s();
    if (const auto& holder = hands_.holder()) {
        state.held = holder->source;
        state.device = holder->device;
        state.asked = holder->stick;
    }
    state.sent = shaper_.now();
    state.last_stop = last_stop_;
    return state;
}

} // namespace usar::mission
