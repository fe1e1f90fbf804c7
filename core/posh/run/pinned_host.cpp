#include "core/posh/run/pinned_host.h"

#include <utility>

namespace usar::posh {

void PinnedHost::pinSense(const std::string& call, Value answer) {
    senses_[call] = std::move(answer);
    findPins();
}

void PinnedHost::pinAct(const std::string& call, ActResult result) {
    acts_[call] = result;
    findPins();
}

void PinnedHost::release(const std::string& call) {
    senses_.erase(call);
    acts_.erase(call);
    findPins();
}

void PinnedHost::releaseAll() {
    senses_.clear();
    acts_.clear();
    findPins();
}

void PinnedHost::bind(const Program& program) {
    program_ = &program;
    begun_ = false;
    findPins();
    host_.bind(program);
}

void PinnedHost::findPins() {
    pinned_senses_.clear();
    pinned_results_.clear();
    if (!program_)
        return;
    for (const ProgramCall& call : program_->sense_calls) {
        const auto pin = senses_.find(call.text);
        pinned_senses_.push_back(pin == senses_.end() ? nullptr : &pin->second);
    }
    for (const ProgramCall& call : program_->act_calls) {
        const auto pin = acts_.find(call.text);
        pinned_results_.push_back(pin == acts_.end() ? std::nullopt : std::optional(pin->second));
    }
}

void PinnedHost::sense(CallSite site, Value& answer) {
    if (const Value* const pinned = pinned_senses_[site.call])
        answer = *pinned;
    else
        host_.sense(site, answer);
}

void PinnedHost::init(CallSite site) {
    begun_ = !pinned_results_[site.call];
    if (begun_)
        host_.init(site);
}

ActResult PinnedHost::run(CallSite site) {
    if (const auto pinned = pinned_results_[site.call]) {
        acted_ = true;
        return *pinned;
    }
    if (!std::exchange(begun_, true)) // The pin was released while the act was running
        host_.init(site);
    return host_.run(site);
}

void PinnedHost::done(CallSite site, DoneReason reason) {
    if (std::exchange(begun_, false))
        host_.done(site, reason);
}

} // namespace usar::posh
