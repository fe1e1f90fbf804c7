// A robot that is driven by hand, on a fake server that records what it receives.
#pragma once

#include "core/mission/hand/hand_driver.h"
#include "tests/mission/session/session_fixture.h"

namespace usar::test {

inline constexpr const char* stop_line = "DRIVE {AltitudeVelocity 0} {LinearVelocity 0} {LateralVelocity 0} "
                                         "{RotationalVelocity 0}";

inline mission::HandIntent holding(mission::HandSource source, const Stick& stick = {.forward = 1.0}) {
    return {.source = source, .stick = stick};
}

/// The last DRIVE that the server received, without its unit and without the sign of -0.
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

/// A spawned AirRobot under control by hand, with the stick held forward until a DRIVE has been sent.
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
