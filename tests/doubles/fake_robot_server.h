// A FakeServer that knows the manners of USARSim: greeting, start poses, and a robot that speaks when it is told to.
#pragma once

#include <QByteArray>

#include "tests/doubles/fake_server.h"

namespace usar::test {

/// Answers GETSTARTPOSES, LOCKSTEP and INIT as the embedded server does; the clock moves by `tick` only. `on_line` of
/// the base is taken; use `on_command` for what is left.
class FakeRobotServer : public FakeServer {
    Q_OBJECT
public:
    explicit FakeRobotServer(QObject* parent = nullptr);

    bool greets = true;
    bool answers_lockstep = true;
    bool answers_init = true;   ///< the first tick follows INIT at once
    bool ticks_on_step = false; ///< each STEP brings the next tick
    bool scans = true;          ///< ticks bring a range scan
    bool sonar = true;          ///< ticks bring sonars
    std::function<void(const QByteArray& line)> on_command;

    /// One UT2004 tick of an AirRobot 0.2 s later: sonars, scan, INS, ground truth, STA.
    void tick();
    double time_s() const { return static_cast<double>(ticks_) * 0.2; }
    int tickCount() const { return ticks_; }

private:
    void obey(const QByteArray& line);

    int ticks_ = 0;
};

} // namespace usar::test
