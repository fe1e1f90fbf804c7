#include "core/mission/session/incoming.h"

#include <variant>

namespace usar::mission {

void Incoming::beginConnection() {
    state_.emplace();
    complaints_before_ = complaints_.count();
    unknown_ = 0;
}

void Incoming::rewind() {
    complaints_ = {};
    complaints_before_ = 0;
    lines_ = 0;
}

void Incoming::continueAfter(LineNumber line) {
    reader_.continueAfter(line);
    lines_ = line.value;
}

const protocol::InfoLine& Incoming::take(std::string_view text) {
    const protocol::InfoLine& line = reader_.read(text);
    ++lines_;
    state_->take(line);
    unknown_ += std::holds_alternative<protocol::GenericMessage>(line.message);
    return line;
}

std::optional<Complaint> Incoming::judge(const protocol::InfoLine& line) {
    return complaints_.take(line);
}

protocol::VehicleKind Incoming::kind() const {
    const auto& latest = state_->latest();
    return latest ? latest->kind : protocol::VehicleKind::Unknown;
}

bool Incoming::batteryIsEmpty() const {
    const auto& latest = state_->latest();
    return latest && latest->battery_left && latest->battery_left->count() <= 0.0;
}

void Incoming::describe(SessionFigures& figures) const {
    figures.now = now();
    figures.lines_received = lines_;
    figures.lines_malformed = complaints_.count();
    figures.traffic.unknown = unknown_;
    figures.traffic.malformed = complaints_.count() - complaints_before_;
}

} // namespace usar::mission
