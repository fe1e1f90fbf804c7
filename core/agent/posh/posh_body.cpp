#include "core/agent/posh/posh_body.h"

#include <utility>

#include "core/posh/run/value_text.h"
#include "core/protocol/command_writer.h"

namespace usar::agent {

const posh::Value& PoshBody::read(const std::string& key) const {
    static const posh::Value nil;
    const auto found = blackboard_.find(key);
    return found == blackboard_.end() ? nil : found->second;
}

void PoshBody::drive(protocol::Command command, std::string_view why) {
    note(posh::TraceEvent::Command, engine_ && engine_->watched() ? protocol::write(command) : std::string());
    drive_ = std::move(command);
    drive_source_ = source(why);
}

void PoshBody::send(protocol::Command command, std::string_view why) {
    note(posh::TraceEvent::Command, engine_ && engine_->watched() ? protocol::write(command) : std::string());
    if (port_)
        port_->send(std::move(command), source(why));
}

void PoshBody::publish(Published value) {
    if (port_)
        port_->publish(std::move(value));
}

void PoshBody::write(const std::string& key, posh::Value value) {
    posh::Value& slot = blackboard_[key];
    if (slot == value)
        return;
    if (engine_ && engine_->watched())
        note(posh::TraceEvent::Blackboard, posh::boardChangeText(key, posh::toText(slot), posh::toText(value)));
    slot = std::move(value);
}

void PoshBody::note(posh::TraceEvent event, std::string_view text) {
    if (engine_)
        engine_->note(event, place_, text);
}

by::Plan PoshBody::source(std::string_view why) const {
    return {{}, engine_ ? posh::namePathOf(*engine_->program(), place_) : std::string("plan"), std::string(why)};
}

void PoshBody::sendDrive() {
    if (drive_ && port_)
        port_->send(*std::move(drive_), std::move(drive_source_));
    drive_.reset();
}

} // namespace usar::agent
