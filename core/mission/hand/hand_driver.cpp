#include "core/mission/hand/hand_driver.h"

#include <utility>

namespace usar::mission {

namespace {

const std::string robot_type = "Robot";

} // namespace

std::string wordOf(HandSource source) {
    constexpr std::array words{"keys", "pad", "gamepad"};
    return words[static_cast<std::size_t>(source)];
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

bool HandControl::overdue(Seconds wall, Seconds patience) const {
    return holder_ && wall - last_word_ > patience;
}

void HandDriver::take(const protocol::InfoLine& line) {
    limits_.take(line.message);
    configuration_.take(line);
    geometry_.take(line);
    for ([[maybe_unused]] const auto& failure : configuration_.takeFailures())
        limits_.giveUpAsking();
    (void)geometry_.takeFailures(); // Without geometry, turns are cautious.
}

std::optional<protocol::Command> HandDriver::question(Seconds now) {
    if (!on())
        return std::nullopt;
    if (auto asked = configuration_.next(now))
        return asked;
    return geometry_.next(now);
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

std::string HandDriver::holderText() const {
    const auto& holder = hands_.holder();
    if (!holder)
        return "nobody";
    return wordOf(holder->source) + (holder->device.empty() ? "" : ' ' + holder->device);
}

HandControl::Verdict HandDriver::accept(const HandIntent& intent, Seconds wall) {
    HandIntent followed = intent;
    followed.stick = limits_.known() ? masked(intent.stick, limits_.axes()) : intent.stick;
    return hands_.accept(followed, wall);
}

HandDriver::Commands HandDriver::advance(Seconds dt) {
    if (!holding() || !limits_.known())
        return {};
    const Stick before = shaper_.now();
    const Stick now = shaper_.follow(hands_.holder()->stick, dt);
    if (now == before && speedShare() == said_share_)
        return {};
    said_share_ = speedShare();
    return driveNow();
}

HandDriver::Commands HandDriver::driveNow() const {
    if (auto drive = driveOf(limits_, shaper_.now(), said_share_))
        return {*std::move(drive)};
    return {};
}

HandDriver::Commands HandDriver::repeat(Seconds now) {
    if (!holding())
        return {};
    if (limits_.style != DriveStyle::Walker)
        return shaper_.now().centered() ? Commands{} : driveNow();
    auto step = gait_.step(shaper_.now(), said_share_, now);
    if (!step)
        return {};
    walked_ = true;
    return {*std::move(step)};
}

HandDriver::Commands HandDriver::stop(const std::string& reason) {
    hands_.letGo();
    shaper_.reset();
    last_stop_ = reason;
    if (limits_.style != DriveStyle::Walker) {
        const auto rest = driveOf(limits_, {}, 1.0);
        return rest ? Commands{*rest} : Commands{};
    }
    return std::exchange(walked_, false) ? Commands{gait_.stand()} : Commands{};
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
