#include "core/modules/query.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/protocol/segments.h"
#include "core/protocol/vehicle_words.h"

namespace usar::modules {

namespace {

using protocol::ConfigurationInfo;
using protocol::GeometryInfo;

constexpr int most_tries = 3;
constexpr Seconds patience{1.0};
constexpr const char* robot_type = "robot";

bool isAboutRobot(const std::string& type) {
    return type.empty() || protocol::vehicleKindOf(type) != protocol::VehicleKind::Unknown;
}
bool isAboutRobot(const GeometryInfo& answer) {
    return !answer.robot_class.empty() || isAboutRobot(answer.type);
}
bool isAboutRobot(const ConfigurationInfo& answer) {
    return isAboutRobot(answer.type);
}

bool tellsSomething(const GeometryInfo& answer) {
    return !answer.items.empty() || !answer.robot_class.empty();
}
bool tellsSomething(const ConfigurationInfo& answer) {
    return std::ranges::any_of(answer.items, [](const auto& item) { return !item.settings.empty(); });
}

/// True if the answer has an item with this name (in lower case), or a link of the mission package with this name.
template <class Answer>
bool speaksOf(const Answer& answer, const std::string& lower_name) {
    return std::ranges::any_of(answer.items, [&](const auto& item) {
        const std::string name = lowerCase(item.name);
        return name == lower_name || name.starts_with(lower_name + "_link");
    });
}

} // namespace

template <class Question, class Answer>
auto QueryModule<Question, Answer>::keyOf(const std::string& type, const std::string& name) -> Key {
    const std::string lower_type = lowerCase(type);
    return {lower_type, lower_type == robot_type ? std::string() : lowerCase(name)};
}

template <class Question, class Answer>
void QueryModule<Question, Answer>::query(const std::string& type, const std::string& name) {
    const Key key = keyOf(type, name);
    const QueryState known = state(type, name);
    if (known == QueryState::Pending || known == QueryState::Ready)
        return;
    const auto asked_type = protocol::Token::make(type);
    const auto asked_name = protocol::Name::make(name);
    if (!asked_type || !asked_name) {
        entries_[key] = Entry{.state = QueryState::Failed};
        return;
    }
    entries_[key] = Entry{Question{*asked_type, *asked_name}};
    waiting_.push_back(key);
}

template <class Question, class Answer>
QueryState QueryModule<Question, Answer>::state(const std::string& type, const std::string& name) const {
    const auto entry = entries_.find(keyOf(type, name));
    return entry == entries_.end() ? QueryState::Unknown : entry->second.state;
}

template <class Question, class Answer>
const Answer* QueryModule<Question, Answer>::answer(const std::string& type, const std::string& name) const {
    const auto entry = entries_.find(keyOf(type, name));
    return entry != entries_.end() && entry->second.answer ? &*entry->second.answer : nullptr;
}

template <class Question, class Answer>
void QueryModule<Question, Answer>::take(const protocol::InfoLine& line) {
    const auto* const answer = std::get_if<Answer>(&line.message);
    if (!answer)
        return;
    for (auto& [key, entry] : entries_) {
        const bool asked_now = outstanding_ && outstanding_->first == key;
        if (!answers(key, *answer, asked_now))
            continue;
        if (tellsSomething(*answer)) {
            entry.state = QueryState::Ready;
            entry.answer = *answer;
        } else if (asked_now) {
            fail(key, entry, true);
        }
        if (asked_now)
            outstanding_.reset();
    }
}

template <class Question, class Answer>
bool QueryModule<Question, Answer>::answers(const Key& key, const Answer& answer, bool asked_now) const {
    const auto& [type, name] = key;
    if (type == robot_type)
        return isAboutRobot(answer);
    if (!sameWord(type, answer.type))
        return false;
    return name.empty() || speaksOf(answer, name) || (asked_now && !tellsSomething(answer));
}

template <class Question, class Answer>
std::optional<protocol::Command> QueryModule<Question, Answer>::next(Seconds now) {
    if (outstanding_) {
        const auto& [key, sent_at] = *outstanding_;
        if (now - sent_at < patience)
            return std::nullopt;
        giveUpOrWait(key);
        outstanding_.reset();
    }
    while (!waiting_.empty()) {
        const Key key = waiting_.front();
        waiting_.pop_front();
        Entry& entry = entries_.at(key);
        if (entry.state != QueryState::Pending)
            continue; // another question's answer covered it while it waited
        ++entry.times_sent;
        outstanding_.emplace(key, now);
        return *entry.question;
    }
    return std::nullopt;
}

template <class Question, class Answer>
void QueryModule<Question, Answer>::giveUpOrWait(const Key& key) {
    Entry& entry = entries_.at(key);
    if (entry.times_sent < most_tries)
        waiting_.push_back(key);
    else
        fail(key, entry, false);
}

template <class Question, class Answer>
void QueryModule<Question, Answer>::fail(const Key& key, Entry& entry, bool no_such_thing) {
    entry.state = QueryState::Failed;
    const auto& asked = entry.question;
    failures_.push_back(
        {asked ? asked->type.text() : key.first, asked ? asked->name.text() : key.second, no_such_thing});
}

template class QueryModule<protocol::GetGeometry, GeometryInfo>;
template class QueryModule<protocol::GetConfiguration, ConfigurationInfo>;

} // namespace usar::modules
