#include "core/agent/watched_behavior.h"

#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include "core/base/numbers.h"

namespace usar::agent {

/// The data shared by both threads. Everything except `mutex`, `turned` and `turn` belongs to the thread whose turn it
/// is. Uses no semaphores, because those of the standard library yield before they wait, which costs milliseconds on a
/// busy machine.
struct WatchedBehavior::Worker {
    explicit Worker(std::unique_ptr<BehaviorHost> watched) : host(std::move(watched)) {}

    /// The thread.
    void work() {
        for (;;) {
            {
                std::unique_lock lock(mutex);
                turned.wait(lock, [this] { return turn != Turn::Owners; });
                if (turn == Turn::Nobodys)
                    return;
            }
            answer = answerOf(call(*host), *host);
            pass(Turn::Owners);
        }
    }

    std::unique_ptr<BehaviorHost> host;
    protocol::InfoLine line; ///< a copy, because the caller may overwrite its own while the behavior still uses it
    std::function<Output(BehaviorHost&)> call;
    BehaviorAnswer answer;

    enum class Turn { Owners, Workers, Nobodys };
    void pass(Turn to) {
        {
            const std::lock_guard lock(mutex);
            if (turn != Turn::Nobodys)
                turn = to;
        }
        turned.notify_all();
    }

    std::mutex mutex;
    std::condition_variable turned;
    Turn turn = Turn::Owners; ///< Nobodys: the owner is gone, and the thread must end
};

WatchedBehavior::WatchedBehavior(std::unique_ptr<BehaviorHost> host)
    : RemoteBehavior(host->behaviorId())
    , worker_(std::make_shared<Worker>(std::move(host))) {
    std::thread([worker = worker_] { worker->work(); }).detach();
}

WatchedBehavior::~WatchedBehavior() {
    worker_->pass(Worker::Turn::Nobodys);
}

RunningBehavior::Output WatchedBehavior::run(std::function<Output(BehaviorHost&)> call, const std::string& what) {
    if (finished_)
        return std::exchange(owed_, {});
    worker_->call = std::move(call);
    worker_->pass(Worker::Turn::Workers);
    {
        std::unique_lock lock(worker_->mutex);
        if (!worker_->turned.wait_for(lock, patience_, [this] { return worker_->turn == Worker::Turn::Owners; }))
            return giveUp(what);
    }
    return take(std::move(worker_->answer));
}

RunningBehavior::Output WatchedBehavior::giveUp(const std::string& what) {
    broke_ = true;
    return finish("stopped because it hangs",
                  "The behavior " + behavior_id_ + " hangs: it has not come back from " + what + " for " +
                      fixed(patience_.count(), 1) +
                      " s. Fix it, or let it run in a separate process, which can be ended; then start it again.");
}

RunningBehavior::Output WatchedBehavior::begin() {
    return run([](BehaviorHost& host) { return host.begin(); }, "its start");
}

RunningBehavior::Output WatchedBehavior::receive(const protocol::InfoLine& line) {
    last_line_ = line.number;
    if (finished_)
        return {};
    worker_->line = line;
    return run([worker = worker_.get()](BehaviorHost& host) { return host.receive(worker->line); },
               "line " + std::to_string(line.number.value));
}

RunningBehavior::Output WatchedBehavior::order(Order order) {
    return run([order](BehaviorHost& host) { return host.order(order); }, "an order");
}

RunningBehavior::Output WatchedBehavior::control(const PlanControl& control) {
    return run([control](BehaviorHost& host) { return host.control(control); }, "a change of its plan");
}

void WatchedBehavior::setParameters(const ParameterSet& parameters) {
    owed_ = run(
        [parameters](BehaviorHost& host) {
            host.setParameters(parameters);
            return Output{};
        },
        "new parameters");
}

} // namespace usar::agent
