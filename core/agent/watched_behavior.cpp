#include "core/agent/watched_behavior.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>
#include <utility>
#include <vector>

#include "core/agent/doorbell.h"
#include "core/base/numbers.h"
#include "core/protocol/reader.h"

namespace usar::agent {

namespace {

using Clock = std::chrono::steady_clock;

/// For the thread, which waits for its owner as long as it takes.
constexpr Seconds a_day{86400.0};

} // namespace

/// The data shared by both threads. What is not atomic belongs to the thread whose turn it is: the worker's while fewer
/// calls are answered than asked, except for the answers that are there already; otherwise the owner's.
struct WatchedBehavior::Worker {
    explicit Worker(std::unique_ptr<BehaviorHost> watched) : host(std::move(watched)) {}

    /// The thread.
    void work() {
        for (std::uint64_t done = 0;;) {
            while (!at_work.wait([&] { return left || asked > done; }, a_day)) {
            }
            if (left)
                return;
            done = call ? answerCall(done) : answerLines(done);
            at_owner.ring();
        }
    }

    /// Hands over `calls` calls.
    void ask(std::uint64_t calls) {
        asked += calls;
        at_work.ring();
    }

    /// Waits until so many calls are answered; false if one takes longer than `patience`.
    bool await(std::uint64_t calls, Seconds patience) {
        while (answered < calls) {
            const bool is_under_way = begun_call == answered; // Looked at before `begun`, which is then as new.
            const Seconds since = Clock::now() - Clock::time_point(Clock::duration(begun));
            const Seconds rest = is_under_way ? Seconds(patience - since) : patience;
            if (rest <= Seconds{0.0})
                return answered >= calls;
            at_owner.wait([&] { return answered >= calls; }, rest);
        }
        return true;
    }
    bool isIdle() const { return answered == asked; }

    std::unique_ptr<BehaviorHost> host;
    protocol::InfoLine line; ///< a copy, because the caller may overwrite its own while the behavior still uses it
    std::function<Output(BehaviorHost&)> call; ///< empty: it has lines to take
    BehaviorAnswer answer;                     ///< to the call
    LineNumber first_line;
    std::string texts;                   ///< It holds the lines, one after the other.
    std::vector<std::size_t> ends;       ///< Each line ends there in `texts`.
    std::vector<BehaviorAnswer> answers; ///< one for each line

    std::atomic<std::uint64_t> asked = 0;
    std::atomic<std::uint64_t> answered = 0;
    std::atomic<bool> left = false; ///< the owner is gone, and the thread must end

private:
    std::uint64_t answerCall(std::uint64_t done) {
        begin(done);
        answer = answerOf(call(*host), *host);
        answered = done + 1;
        return done + 1;
    }

    /// Reads the lines for itself, while the owner does so, too: what a line says is then in memory of this thread.
    std::uint64_t answerLines(std::uint64_t done) {
        const std::size_t count = ends.size(); // Nothing of the owner's may be looked at after the last answer.
        reader.continueAfter({first_line.value - 1});
        for (std::size_t i = 0, from = 0; i < count; ++i) {
            begin(done);
            const std::size_t end = ends[i];
            const protocol::InfoLine& read = reader.read(std::string_view(texts).substr(from, end - from));
            from = end;
            answers[i] = answerOf(host->receive(read), *host);
            answered = ++done;
        }
        return done;
    }

    void begin(std::uint64_t call_number) {
        begun = Clock::now().time_since_epoch().count();
        begun_call = call_number;
    }

    protocol::Reader reader;
    Doorbell at_work;
    Doorbell at_owner;
    std::atomic<Clock::rep> begun = 0;            ///< when the newest call began
    std::atomic<std::uint64_t> begun_call = none; ///< its number; it is under way if as many are answered
    static constexpr std::uint64_t none = ~std::uint64_t(0);
};

WatchedBehavior::WatchedBehavior(std::unique_ptr<BehaviorHost> host)
    : RemoteBehavior(host->behaviorId())
    , worker_(std::make_shared<Worker>(std::move(host))) {
    std::thread thread([worker = worker_] { worker->work(); });
    processor_.emplace(thread.native_handle());
    thread.detach();
}

WatchedBehavior::~WatchedBehavior() {
    processor_.reset();
    worker_->left = true;
    worker_->ask(0);
}

RunningBehavior::Output WatchedBehavior::run(std::function<Output(BehaviorHost&)> call, const std::string& what) {
    if (finished_)
        return std::exchange(owed_, {});
    if (!worker_->await(worker_->asked, patience_)) // What it was told before.
        return giveUp(what);
    worker_->call = std::move(call);
    worker_->ask(1);
    if (!worker_->await(worker_->asked, patience_))
        return giveUp(what);
    return take(std::move(worker_->answer));
}

RunningBehavior::Output WatchedBehavior::giveUp(const std::string& what) {
    broke_ = true;
    processor_.reset();
    return finish("stopped because it hangs",
                  "The behavior " + behavior_id_ + " hangs: it has not come back from " + what + " for " +
                      fixed(patience_.count(), 1) +
                      " s. Fix it, or let it run in a separate process, which can be ended; then start it again.");
}

RunningBehavior::Output WatchedBehavior::begin() {
    return run([](BehaviorHost& host) { return host.begin(); }, "its start");
}

void WatchedBehavior::expect(LineNumber first, std::span<const std::string_view> lines) {
    if (finished_ || !worker_->isIdle())
        return;
    processor_->turn();
    Worker& worker = *worker_;
    worker.call = nullptr;
    worker.first_line = first;
    worker.texts.clear();
    worker.ends.clear();
    for (const std::string_view line : lines) {
        worker.texts += line;
        worker.ends.push_back(worker.texts.size());
    }
    worker.answers.resize(lines.size());
    next_expected_ = first;
    end_of_expected_ = {first.value + lines.size()};
    calls_before_ = worker.asked;
    worker.ask(lines.size());
}

RunningBehavior::Output WatchedBehavior::receive(const protocol::InfoLine& line) {
    last_line_ = line.number;
    if (finished_)
        return {};
    const std::string what = "line " + std::to_string(line.number.value);
    const bool is_expected = line.number >= next_expected_ && line.number < end_of_expected_;
    const std::uint64_t place = line.number.value - worker_->first_line.value;
    if (!worker_->await(is_expected ? calls_before_ + place + 1 : worker_->asked.load(), patience_))
        return giveUp(what);
    if (is_expected) {
        next_expected_.value = line.number.value + 1;
        return take(std::move(worker_->answers[place]));
    }
    worker_->line = line;
    return run([worker = worker_.get()](BehaviorHost& host) { return host.receive(worker->line); }, what);
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
