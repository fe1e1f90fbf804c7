#include "core/agent/process/behavior_service.h"

#include <array>
#include <csignal>
#include <cstdlib>
#include <thread>
#include <utility>

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include "core/agent/behavior_host.h"
#include "core/agent/behavior_start.h"
#include "core/agent/process/behavior_frames.h"
#include "core/agent/process/frame_channel.h"
#include "core/protocol/reader.h"

namespace usar::agent {

namespace {

/// Long enough for a busy program; if the program is gone, sending fails at once.
constexpr Seconds patience_to_answer{60.0};
constexpr std::array deadly{SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGSYS, SIGTERM};

/// All data that the signal handler uses, prepared before the first signal can arrive.
struct LastWords {
    int socket = -1;
    std::array<std::array<char, 64>, 65> frames{}; ///< by signal number; each frame is preceded by its length
    std::array<std::size_t, 65> sizes{};
};
LastWords last_words;

/// Sends the prepared frame and closes the connection at once, because writing a core dump may take long.
void sayLastWords(int signal) {
    const auto number = static_cast<std::size_t>(signal);
    (void)::send(last_words.socket, last_words.frames[number].data(), last_words.sizes[number],
                 MSG_NOSIGNAL | MSG_DONTWAIT);
    ::shutdown(last_words.socket, SHUT_WR);
    ::raise(signal); // SA_RESETHAND has restored the default handler
}

void prepareLastWords(int socket) {
    static std::array<char, 1 << 16> stack_of_handlers; // the normal stack may have overflowed
    stack_t stack{};
    stack.ss_sp = stack_of_handlers.data();
    stack.ss_size = stack_of_handlers.size();
    ::sigaltstack(&stack, nullptr);
    last_words.socket = socket;
    for (const int signal : deadly) {
        const QByteArray frame = frames::write(frames::Reply(frames::Dying{signal}));
        auto& bytes = last_words.frames[static_cast<std::size_t>(signal)];
        Q_ASSERT(static_cast<std::size_t>(frame.size()) + 4 <= bytes.size());
        bytes[0] = static_cast<char>(frame.size());
        std::copy(frame.begin(), frame.end(), bytes.begin() + 4);
        last_words.sizes[static_cast<std::size_t>(signal)] = static_cast<std::size_t>(frame.size()) + 4;
        struct sigaction action {};
        action.sa_handler = sayLastWords;
        action.sa_flags = static_cast<int>(SA_RESETHAND | SA_ONSTACK | SA_NODEFER);
        ::sigaction(signal, &action, nullptr);
    }
}

/// Ends the process when the other side closes the connection. A thread waits for this, because a behavior that hangs
/// would not notice.
void endWithTheOtherSide(int socket) {
    std::thread([socket] {
        pollfd watched{socket, POLLRDHUP, 0};
        while (::poll(&watched, 1, -1) < 0) {
        }
        std::_Exit(0);
    }).detach();
}

/// Returns the result of `call` for the plugin, id and context of a job. It is an error if no plugin has the behavior
/// or a parameter is wrong.
template <class Call>
auto answerFor(const frames::Job& job, const PluginLoader& plugins, Call& call)
    -> decltype(call(std::declval<const RobotPlugin&>(), job.behavior_id, BehaviorContext())) {
    const auto plugin = plugins.pluginFor(job.behavior_id);
    if (!plugin)
        return tl::unexpected(plugin.error());
    auto parameters = ParameterSet::make(plugins.behavior(job.behavior_id)->parameters, job.parameters);
    if (!parameters)
        return tl::unexpected(parameters.error());
    return call(**plugin, job.behavior_id, {job.task, *std::move(parameters), job.plan});
}

/// The behavior of the first frame, and what its requests are read with.
struct Service {
    std::unique_ptr<BehaviorHost> host;
    std::vector<ParameterSpec> parameters;
    protocol::Reader reader;

    RunningBehavior::Output answer(const frames::Request& request) {
        if (const auto* const line = std::get_if<frames::Line>(&request)) {
            reader.continueAfter({line->number.value - 1});
            return host->receive(reader.read(line->text));
        }
        if (const auto* const order = std::get_if<Order>(&request))
            return host->order(*order);
        if (const auto* const control = std::get_if<PlanControl>(&request))
            return host->control(*control);
        if (const auto* const values = std::get_if<std::map<std::string, ParameterValue>>(&request))
            if (const auto set = ParameterSet::make(parameters, *values))
                host->setParameters(*set);
        return {};
    }
};

/// The reply to a request that needs no behavior; nullopt for other requests.
std::optional<frames::Reply> answerAboutPlugin(const std::optional<frames::Request>& request, PluginLoader& plugins) {
    if (!request)
        return std::nullopt;
    if (const auto* const describe = std::get_if<frames::Describe>(&*request)) {
        plugins.scan({QString::fromStdString(describe->plugin_file)});
        if (!plugins.robots().empty())
            return plugins.robots().front();
        const QString reason = plugins.records().empty() ? QString("It is gone.") : plugins.records().front().reason;
        return Error{reason.toStdString(), {}, {}};
    }
    const auto* const job = std::get_if<frames::Job>(&*request);
    if (!job)
        return std::nullopt;
    auto preview = answerFor(*job, plugins, previewTask);
    return preview ? frames::Reply(*std::move(preview)) : frames::Reply(preview.error());
}

} // namespace

int serveBehavior(int socket) {
    prepareLastWords(socket);
    endWithTheOtherSide(socket);
    FrameChannel channel(socket);
    const auto reply = [&](const frames::Reply& to_request) {
        channel.send(frames::write(to_request), patience_to_answer);
    };
    PluginLoader plugins;
    std::optional<Service> service;
    QByteArray frame;
    while (channel.receive(frame, std::nullopt) == FrameChannel::Received::Frame) {
        const auto request = frames::readRequest(frame);
        if (const auto about_plugin = answerAboutPlugin(request, plugins)) {
            reply(*about_plugin);
            continue;
        }
        const auto* const start = request ? std::get_if<frames::Start>(&*request) : nullptr;
        if (!request || (start == nullptr) != service.has_value()) {
            reply(Error{"the program and its behavior host do not understand each other", "usar-behavior-host",
                        "Install both from the same version"});
            return 2;
        }
        RunningBehavior::Output output;
        if (start) {
            const std::string& id = start->job.behavior_id;
            plugins.scan({QString::fromStdString(start->plugin_file)});
            auto behavior = answerFor(start->job, plugins, makeBehavior);
            if (!behavior) {
                reply(behavior.error());
                return 1;
            }
            service.emplace().parameters = plugins.behavior(id)->parameters;
            service->host =
                std::make_unique<BehaviorHost>(*std::move(behavior), id, plugins.robotOf(id)->sensors_needed);
            output = service->host->begin();
        } else {
            output = service->answer(*request);
        }
        reply(answerOf(std::move(output), *service->host));
    }
    return 0;
}

} // namespace usar::agent
