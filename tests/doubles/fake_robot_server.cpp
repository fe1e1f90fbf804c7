#include "tests/doubles/fake_robot_server.h"

namespace usar::test {

FakeRobotServer::FakeRobotServer(QObject* parent) : FakeServer(parent) {
    on_connect = [this] {
        if (greets)
            say("NFO {Gametype BotDeathMatch} {Level tall_test} {TimeLimit 0}\r\n");
    };
    on_line = [this](const QByteArray& line) { obey(line); };
}

void FakeRobotServer::obey(const QByteArray& line) {
    if (line == "GETSTARTPOSES" && greets)
        say("NFO {StartPoses 2} {PlayerStart 1.00,-2.00,-0.50 0.00,0.00,0.00 robot1 3.00,4.00,-0.50 "
            "0.00,0.00,1.57}\r\n");
    else if (line == "LOCKSTEP {On true}" && answers_lockstep)
        say("NFO {Lockstep True}\r\n");
    else if (line.startsWith("INIT") && answers_init)
        tick();
    else if (line == "STEP" && ticks_on_step)
        tick();
    if (on_command)
        on_command(line);
}

void FakeRobotServer::tick() {
    ++ticks_;
    const QByteArray time = QByteArray::number(time_s(), 'f', 2);
    QByteArray lines;
    if (sonar)
        lines += "SEN {Time " + time + "} {Type Sonar} {Name F1 Range 5.0000} {Name F2 Range 4.5604}\r\n";
    if (scans)
        lines += "SEN {Time " + time +
                 "} {Type RangeScanner} {Name Scanner1} {Resolution 0.1000} {FOV 0.2000} "
                 "{Range 2.0000,2.0000,2.0000}\r\n";
    lines += "SEN {Type INS} {Name INS} {Location 1.00,-2.00,-3.00} {Orientation 0.00,0.00,0.00}\r\n";
    lines += "SEN {Time " + time +
             "} {Type GroundTruth} {Name GroundTruth} {Location 1.00,-2.00,-3.00} {Orientation 0.00,0.00,0.00}\r\n";
    lines += "STA {Type AerialVehicle} {Time " + time +
             "} {LightToggle False} {LightIntensity 0} {Battery 1200} {View -1}\r\n";
    say(lines);
}

} // namespace usar::test
