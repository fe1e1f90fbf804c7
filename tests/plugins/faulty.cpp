// Behaviors of an AirRobot that climb for some ticks and then go wrong, each in its own way.
#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include <sys/socket.h>
#include <unistd.h>

#include <QObject>

#include "core/agent/robot_plugin.h"

namespace {

using namespace usar;

/// For longer than any test looks, and without its output, for whose end a runner of tests would wait.
void liveOn() {
    ::close(STDOUT_FILENO);
    ::close(STDERR_FILENO);
    ::sleep(20);
    ::_exit(0);
}

class FaultyBehavior : public agent::Behavior {
public:
    FaultyBehavior(std::string fault, long long good_ticks) : fault_(std::move(fault)), good_ticks_(good_ticks) {}

    void tick(const agent::Tick& tick, agent::CommandPort& port) override {
        if (++ticks_ > good_ticks_)
            goWrong();
        port.send(protocol::AerialDrive{0.4, {}, {}, {}}, "climbing");
        agent::BehaviorStatus status;
        status.time = tick.now;
        status.state = "climbing for the " + std::to_string(ticks_) + ". tick";
        port.publish(status);
    }
    void order(agent::Order, agent::CommandPort& port) override {
        port.publish(agent::BehaviorFinished{true, "Ordered to end."});
    }
    void setParameters(const agent::ParameterSet& parameters) override { good_ticks_ = parameters.integer("ticks"); }
    protocol::Command safeCommand() const override { return protocol::AerialDrive{0.0, 0.0, 0.0, 0.0}; }

private:
    void goWrong() const {
        if (fault_ == "segfault")
            std::raise(SIGSEGV); // sanitizers would see a null pointer first
        if (fault_ == "abort")
            std::abort();
        if (fault_ == "exit")
            std::_Exit(3);
        if (fault_ == "throw")
            throw std::runtime_error("lost my way");
        if (fault_ == "orphan") // a child that lives on holds the connection to the program
            ::fork() == 0 ? liveOn() : void(::kill(::getpid(), SIGKILL));
        if (fault_ == "hang up") // where usar-behavior-host has the connection
            ::shutdown(3, SHUT_WR);
        while (fault_ == "loop" || fault_ == "hang up")
            ::pause(); // on two cores a busy one would starve the rest
    }

    std::string fault_;
    long long good_ticks_;
    long long ticks_ = 0;
};

} // namespace

class FaultyPlugin : public QObject, public agent::RobotPlugin {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID USAR_ROBOT_PLUGIN_IID FILE "faulty.json")
    Q_INTERFACES(usar::agent::RobotPlugin)
public:
    agent::RobotDescription description() const override {
        agent::RobotDescription robot{"USARBot.AirRobot", "AirRobot", {}, {}};
        for (const char* fault : {"none", "segfault", "abort", "exit", "loop", "throw", "orphan", "hang up"}) {
            agent::BehaviorDescription behavior;
            behavior.id = std::string("faulty/") + fault;
            behavior.name = std::string("Climb, then: ") + fault;
            behavior.parameters = {{"ticks", "Good ticks", "Fault", "", 5LL, 0.0, 1e6, "How long it goes well.", {}}};
            robot.behaviors.push_back(behavior);
        }
        return robot;
    }
    Result<std::unique_ptr<agent::Behavior>> createBehavior(const std::string& id,
                                                            agent::BehaviorContext context) const override {
        return std::make_unique<FaultyBehavior>(id.substr(7), context.parameters.integer("ticks"));
    }
};

#include "faulty.moc"
