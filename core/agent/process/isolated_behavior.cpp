#include "core/agent/process/isolated_behavior.h"

#include <utility>

#include "core/base/numbers.h"

namespace usar::agent {

IsolatedBehavior::IsolatedBehavior(QString program, frames::Start start)
    : RemoteBehavior(start.job.behavior_id)
    , program_(std::move(program))
    , start_(std::move(start)) {}

RunningBehavior::Output IsolatedBehavior::begin() {
    auto started = HostProcess::start(program_, "behavior " + behavior_id_);
    if (!started)
        return end(started.error().text());
    host_ = *std::move(started);
    return ask(start_, Patience().making, "it was being made");
}

RunningBehavior::Output IsolatedBehavior::receive(const protocol::InfoLine& line) {
    last_line_ = line.number;
    last_text_ = line.text.substr(0, 60); // enough for a message
    if (last_text_.size() < line.text.size())
        last_text_ += "…";
    return ask(frames::Line{line.number, line.text}, patience_, "it worked on line");
}

RunningBehavior::Output IsolatedBehavior::order(Order order) {
    return ask(order, patience_, "it took an order after line");
}

RunningBehavior::Output IsolatedBehavior::control(const PlanControl& control) {
    return ask(control, patience_, "its plan was being changed after line");
}

void IsolatedBehavior::setParameters(const ParameterSet& parameters) {
    owed_ = ask(parameters.values(), patience_, "it took new parameters after line");
}

RunningBehavior::Output IsolatedBehavior::ask(const frames::Request& request, Seconds patience,
                                              const std::string& at_work) {
    if (finished_ || ending_ || !host_)
        return std::exchange(owed_, {});
    std::optional<frames::Reply> reply;
    if (host_->ask(request, patience, reply) == FrameChannel::Received::TimedOut) {
        host_->kill();
        return die("hangs: it has not answered for " + fixed(patience.count(), 1) + " s and was ended", at_work);
    }
    if (reply && std::holds_alternative<frames::Answer>(*reply))
        return note(std::get<frames::Answer>(*reply));
    if (reply && std::holds_alternative<Error>(*reply))
        return end(std::get<Error>(*reply).text());
    return lose(reply, at_work);
}

RunningBehavior::Output IsolatedBehavior::note(frames::Answer& answer) {
    if (!answer.output.commands.empty())
        last_decision_ = toText(answer.output.commands.back().cause.source);
    for (const Published& value : answer.output.published)
        if (const auto* const status = std::get_if<BehaviorStatus>(&value))
            last_state_ = status->state;
    return take(std::move(answer));
}

RunningBehavior::Output IsolatedBehavior::takeEnd() {
    if (ending_)
        return die(host_->howItEnded(std::nullopt), lost_at_work_);
    if (finished_ || !host_)
        return {};
    std::optional<frames::Reply> reply;
    if (host_->listen(reply) == FrameChannel::Received::TimedOut)
        return {}; // nothing has arrived after all
    return lose(reply, "it waited after line");
}

RunningBehavior::Output IsolatedBehavior::lose(const std::optional<frames::Reply>& reply, const std::string& at_work) {
    if (const auto* const dying = reply ? std::get_if<frames::Dying>(&*reply) : nullptr)
        return die(host_->howItEnded(dying->signal), at_work);
    ending_ = true;
    halted_ = false;
    lost_at_work_ = at_work;
    host_->becomeDeaf(); // otherwise its handle would stay readable forever
    owed_.commands = {safeCommand(by::Behavior{behavior_id_, "its process has ended"})};
    return std::exchange(owed_, {});
}

RunningBehavior::Output IsolatedBehavior::die(const std::string& how, const std::string& at_work) {
    std::string reason = "The behavior " + behavior_id_ + " " + how + ", while " + at_work;
    if (last_line_.value > 0)
        reason += " " + std::to_string(last_line_.value) + " (" + last_text_ + ")";
    if (!last_state_.empty())
        reason += "; its state was “" + last_state_ + "”";
    if (!last_decision_.empty())
        reason += "; its last command came from “" + last_decision_ + "”";
    broke_ = true;
    return end(reason + ". The robot was stopped; the behavior can be started again.");
}

RunningBehavior::Output IsolatedBehavior::end(const std::string& reason) {
    ending_ = false;
    if (host_)
        host_->leave();
    host_.reset();
    return finish("its process has ended", reason);
}

} // namespace usar::agent
