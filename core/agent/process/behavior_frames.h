// The frames that the program and a behavior in a process of its own exchange.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <variant>

#include <QByteArray>

#include "core/agent/plan_control.h"
#include "core/agent/remote_behavior.h"
#include "core/agent/robot_plugin.h"

namespace usar::agent::frames {

/// Version of the format, which increases with every change of the frames below. Hosts of another version are refused.
inline constexpr quint32 version = 6;

/// A behavior and what it is created with. As a request of its own, it asks for the preview of the task.
struct Job {
    std::string behavior_id;
    Task task;
    std::map<std::string, ParameterValue> parameters;
    std::optional<PlanText> plan; ///< replaces the plan that comes with the robot
};

/// The first frame to the host of a behavior: the plugin, the behavior and its task.
struct Start {
    std::string plugin_file;
    Job job;
};

/// An info line as received, to be read by the other side, so that forty kinds of messages need no second format.
struct Line {
    LineNumber number;
    std::string text;
};

/// Sent instead of Start: asks for the plugin's description. Jobs, which ask for previews, may follow.
struct Describe {
    std::string plugin_file;
};

/// From the program to the host. The map contains new values of all parameters.
using Request = std::variant<Start, Line, Order, PlanControl, std::map<std::string, ParameterValue>, Describe, Job>;

/// The reply to a request; the host sends one reply for each request, in the same order.
using Answer = BehaviorAnswer;
/// The last frame of a host, sent by its signal handler.
struct Dying {
    int signal = 0; ///< number of the signal
};

/// From the host to the program. The reply to Describe is a RobotDescription, that to Job a TaskPreview; an Error is
/// the reply to Start, Describe or Job if they fail.
using Reply = std::variant<Answer, Error, Dying, RobotDescription, TaskPreview>;

/// The bytes of one frame, without the length that FrameChannel adds.
QByteArray write(const Request& request);
QByteArray write(const Reply& reply);
/// Returns nullopt if the bytes are not such a frame or have another version.
std::optional<Request> readRequest(const QByteArray& frame);
std::optional<Reply> readReply(const QByteArray& frame);

} // namespace usar::agent::frames
