// What crosses the border between the program and a behavior in a process of its own.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <variant>

#include <QByteArray>

#include "core/agent/plan_control.h"
#include "core/agent/robot_plugin.h"
#include "core/agent/running_behavior.h"

namespace usar::agent::frames {

/// Raised with every change of what follows. A host of another version is refused.
inline constexpr quint32 version = 3;

/// The first frame to the host: which behavior of which plugin, and what it is to do.
struct Start {
    std::string plugin_file;
    std::string behavior_id;
    Task task;
    std::map<std::string, ParameterValue> parameters;
    std::optional<PlanText> plan;
};

/// A line as it came, for the reader on the other side: no second way to write forty kinds of message.
struct Line {
    LineNumber number;
    std::string text;
};

/// In place of Start: what the plugin says of itself is wanted, and then previews.
struct Describe {
    std::string plugin_file;
};
struct Preview {
    std::string behavior_id;
    Task task;
    std::map<std::string, ParameterValue> parameters;
    std::optional<PlanText> plan;
};

using Request = std::variant<Start, Line, Order, PlanControl, std::map<std::string, ParameterValue>, Describe, Preview>;

/// To each request one, in the same order.
struct Answer {
    RunningBehavior::Output output;
    protocol::Command safe; ///< what the behavior would say if it had to stop now
    bool halted = false;
    bool finished = false;
    bool broke = false;
};
/// To Describe. A preview is answered by one.
struct Description {
    RobotDescription robot;
};
/// In place of the answer to Start, Describe or Preview.
struct Refusal {
    Error error;
};
/// The last word of a host, said in the handler of a signal.
struct Dying {
    int signal = 0;
};

using Reply = std::variant<Answer, Refusal, Dying, Description, TaskPreview>;

QByteArray write(const Request& request);
QByteArray write(const Reply& reply);
/// Nothing where the bytes are no such frame, or of another version.
std::optional<Request> readRequest(const QByteArray& frame);
std::optional<Reply> readReply(const QByteArray& frame);

} // namespace usar::agent::frames
