// Queries about geometry and configuration, with one outstanding at a time.
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

/// Unknown: never asked. Pending: waiting to be sent or answered.
enum class QueryState { Unknown, Pending, Ready, Failed };

/// Geometry and configuration module of the thesis (3.3). The server remembers one pending question of each kind and
/// forgets the earlier one, so questions wait in a queue: the next one is sent after the answer has arrived or 1 s has
/// passed. A question is sent up to three times before it fails. An answer is recognized by its type and, if one was
/// asked for, its name, both in any case; the answer about the type Robot has the word for a kind of vehicle instead,
/// and its name is ignored. An empty answer, which UT2004 sends, means that there is no such thing: the question fails
/// at once. UDK sends no answer then, so three seconds pass. `Answer` is GeometryInfo or ConfigurationInfo, `Question`
/// GetGeometry or GetConfiguration. Plain data without a thread or clock of its own.
template <class Question, class Answer>
class QueryModule {
public:
    /// Queues a question, again if it has failed before. Has no effect if it is already pending or answered. A type or
    /// name that no line can hold (with spaces or braces) fails at once. An empty name means all items of the type.
    void query(const std::string& type, const std::string& name = {});
    QueryState state(const std::string& type, const std::string& name = {}) const;
    /// The answer if the state is Ready, else nullptr. Valid until the next call of `query` or `take`.
    const Answer* answer(const std::string& type, const std::string& name = {}) const;

    /// Call it with every info line of the connection.
    void take(const protocol::InfoLine& line);
    /// A question that was sent and has failed.
    struct Failure {
        std::string type;
        std::string name;
        bool no_such_thing = false; ///< the server said so; otherwise it did not answer
    };
    /// The failures since the last call.
    std::vector<Failure> takeFailures() { return std::exchange(failures_, {}); }
    /// The question to send now, which counts as sent at `now` (on the protocol's clock); nullopt if none waits or the
    /// answer to another one may still arrive.
    std::optional<protocol::Command> next(Seconds now);

private:
    using Key = std::pair<std::string, std::string>; // type and name in lower case
    struct Entry {
        std::optional<Question> question{}; ///< absent if no line can hold it
        QueryState state = QueryState::Pending;
        int times_sent = 0;
        std::optional<Answer> answer{};
    };

    /// The name is ignored for the type Robot.
    static Key keyOf(const std::string& type, const std::string& name);
    /// True if `answer` answers the question `key`, which may have been asked earlier.
    bool answers(const Key& key, const Answer& answer, bool asked_now) const;
    /// Handles a missing answer.
    void giveUpOrWait(const Key& key);
    void fail(const Key& key, Entry& entry, bool no_such_thing);

    std::map<Key, Entry> entries_;
    std::deque<Key> waiting_;
    std::optional<std::pair<Key, Seconds>> outstanding_; ///< the question sent last, and when
    std::vector<Failure> failures_;
};

using GeometryModule = QueryModule<protocol::GetGeometry, protocol::GeometryInfo>;
using ConfigurationModule = QueryModule<protocol::GetConfiguration, protocol::ConfigurationInfo>;
extern template class QueryModule<protocol::GetGeometry, protocol::GeometryInfo>;
extern template class QueryModule<protocol::GetConfiguration, protocol::ConfigurationInfo>;

} // namespace usar::modules
