// A robot that a person drives, at a fake server that writes down what it hears.
#pragma once

#include "core/mission/hand/hand_control.h"
#include "tests/mission/session/session_fixture.h"

namespace usar::test {

inline constexpr const char* stop_line = "DRIVE {AltitudeVelocity 0} {LinearVelocity 0} {LateralVelocity 0} "
                                         "{RotationalVelocity 0}";

inline mission::HandIntent holding(mission::HandSource source, const Stick& stick = {.forward = 1.0}) {
    return {.source = source, .stick = stick};
}

/// Without the unit, and without the sign of nothing.
inline QByteArray lastDrive(const SessionFixture& f) {
    const QList<QByteArray> drives = f.server.heardOf("DRIVE");
    return drives.isEmpty() ? QByteArray()
                            : QByteArray(drives.last())
                                  .replace(" {Normalized false}", "")
                                  .replace(" {Normalized true}", "")
                                  .replace(" -0}", " 0}");
}

inline bool stopped(const SessionFixture& f) {
    return lastDrive(f) == stop_line;
}

/// A spawned AirRobot that the person has taken, with the stick held forward until it is on the wire.
struct HeldRobot : SessionFixture {
    explicit HeldRobot(const mission::SessionLimits& limits = patientLimits()) : SessionFixture(limits) {
        ready = spawnNow();
        session.takeControl();
        session.drive(holding(mission::HandSource::Keys));
        ready = ready &&
                QTest::qWaitFor([this] { return lastDrive(*this).contains("{LinearVelocity") && !stopped(*this); });
    }
    bool ready = false;
};

} // namespace usar::test
