// Questions about geometry and configuration, one outstanding at a time.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/clock.h"
#include "core/protocol/command.h"
#include "core/protocol/info_message.h"

namespace usar::modules {

enum class QueryState { Unknown, Pending, Ready, Failed };

/// Geometry and configuration module of the thesis (3.3). The server holds one pending question of each kind and loses
/// the earlier one, so questions wait in line: the next is sent when the answer came or 1 s has passed; a question is
/// sent three times before it fails. An answer is known by its type and, where one was asked for, its name, both in any
/// case; the answer about the type Robot has the word of a vehicle kind instead, and its name is not looked at. An
/// answer that tells nothing (UT2004's bare head) means that there is no such thing: Failed at once. UDK answers
/// nothing then, so three seconds pass. `Answer` is GeometryInfo or ConfigurationInfo, `Question` GetGeometry or
/// GetConfiguration.
template <class Question, class Answer>
class QueryModule {
public:
    /// Asks (again, if it failed). Asking twice for the same thing changes nothing. A name that no line can hold (with
    /// spaces or braces) fails at once.
    void query(const std::string& type, const std::string& name = {});
    QueryState state(const std::string& type, const std::string& name = {}) const;
    /// The answer once the state is Ready, else nullptr.
    const Answer* answer(const std::string& type, const std::string& name = {}) const;

    void take(const protocol::InfoLine& line);
    /// Questions that have failed since the last call, each with the reason.
    struct Failure {
        std::string type;
        std::string name;
        bool no_such_thing = false; ///< the server said so; else there was no answer
    };
    std::vector<Failure> takeFailures() { return std::exchange(failures_, {}); }
    /// The question to send now, if the line is free; marks it as sent at `now` (the protocol's clock).
    std::optional<protocol::Command> next(Seconds now);

private:
    using Key = std::pair<std::string, std::string>; // type and name in lower case
    struct Entry {
        std::optional<Question> question{}; ///< absent for what no line can ask
        QueryState state = QueryState::Pending;
        int times_sent = 0;
        std::optional<Answer> answer{};
    };

    static Key keyOf(const std::string& type, const std::string& name);
    bool answers(const Key& key, const Answer& answer, bool asked_now) const;
    void giveUpOrWait(const Key& key);
    void fail(const Key& key, Entry& entry, bool no_such_thing);

    std::map<Key, Entry> entries_;
    std::deque<Key> waiting_;
    std::optional<std::pair<Key, Seconds>> outstanding_;
    std::vector<Failure> failures_;
};

using GeometryModule = QueryModule<protocol::GetGeometry, protocol::GeometryInfo>;
using ConfigurationModule = QueryModule<protocol::GetConfiguration, protocol::ConfigurationInfo>;
extern template class QueryModule<protocol::GetGeometry, protocol::GeometryInfo>;
extern template class QueryModule<protocol::GetConfiguration, protocol::ConfigurationInfo>;

} // namespace usar::modules
