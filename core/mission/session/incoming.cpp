#include "core/mission/session/incoming.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "core/base/text.h"
#include "core/mission/session/stream_name.h"

namespace usar::mission {

namespace {

/// Returns the message without its numbers and quoted words.
std::string kindOf(std::string_view message) {
    std::string kind;
    bool quoted = false;
    for (const char c : message) {
        if (c == '"' || c == '\'')
            quoted = !quoted;
        else if (!quoted && !isDigit(c) && c != '.' && c != '-')
            kind += c;
    }
    return kind;
}

bool isNoMessage(const protocol::InfoMessage& message) {
    const auto* generic = std::get_if<protocol::GenericMessage>(&message);
    return generic && (generic->type_word.empty() || !std::ranges::all_of(generic->type_word, isWordByte));
}

/// Describes what is wrong with the line; nullopt if nothing is.
std::optional<std::string> wrongIn(const protocol::InfoLine& line) {
    if (isNoMessage(line.message))
        return "this is not a message of the protocol";
    const auto bad = std::ranges::find_if(
        line.diagnostics, [](const Diagnostic& diagnostic) { return diagnostic.severity != Severity::Note; });
    if (bad != line.diagnostics.end())
        return bad->message;
    return std::nullopt;
}

/// Returns enough of the line to recognize it; bytes that are not plain text become '?', as they would spoil a notice.
std::string excerpt(std::string_view text) {
    constexpr std::size_t length = 60;
    std::string plain(text.substr(0, length));
    std::ranges::replace_if(
        plain, [](char c) { return c < ' ' || c > '~'; }, '?');
    return text.size() > length ? plain + "..." : plain;
}

} // namespace

std::optional<Complaint> ComplaintBook::take(const protocol::InfoLine& line) {
    const auto wrong = wrongIn(line);
    if (!wrong)
        return std::nullopt;
    ++count_;
    const std::string stream = isNoMessage(line.message) ? "" : streamName(line.message);
    const std::string kind = (stream.empty() ? "" : stream + ": ") + kindOf(*wrong);
    if (kinds_.size() >= kind_limit || !kinds_.insert(kind).second)
        return std::nullopt;
    std::string text = "Line " + std::to_string(line.number.value) + " from the server is damaged: " + *wrong + " (\"" +
                       excerpt(line.text) +
                       "\"). What could be read of it is used; more of this kind are only counted.";
    return Complaint{kind, std::move(text)};
}

void Incoming::beginConnection() {
    state_.emplace();
    fullest_battery_ = Seconds{0.0};
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
    if (const auto* state = std::get_if<protocol::RobotState>(&line.message); state && state->battery_left)
        fullest_battery_ = std::max(fullest_battery_, *state->battery_left);
    unknown_ += std::holds_alternative<protocol::GenericMessage>(line.message);
    return line;
}

protocol::VehicleKind Incoming::kind() const {
    const auto& latest = state_->latest();
    return latest ? latest->kind : protocol::VehicleKind::Unknown;
}

bool Incoming::batteryIsEmpty() const {
    const auto& latest = state_->latest();
    return latest && latest->battery_left && latest->battery_left->count() <= 0.0;
}

std::optional<double> Incoming::batteryLeft_pct() const {
    const auto& latest = state_->latest();
    if (!latest || !latest->battery_left)
        return std::nullopt;
    // A battery of a week passes that figure, too.
    if (*latest->battery_left == protocol::no_battery && fullest_battery_ <= protocol::no_battery)
        return std::nullopt;
    return fullest_battery_ > Seconds{0.0} ? std::max(100.0 * (*latest->battery_left / fullest_battery_), 0.0) : 0.0;
}

void Incoming::describe(SessionFigures& figures) const {
    figures.now = now();
    figures.battery_left_pct = batteryLeft_pct();
    figures.lines_received = lines_;
    figures.lines_malformed = complaints_.count();
    figures.traffic.unknown = unknown_;
    figures.traffic.malformed = complaints_.count() - complaints_before_;
}

} // namespace usar::mission
