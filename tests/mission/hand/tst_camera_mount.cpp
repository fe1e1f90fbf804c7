#include <QTest>

#include "core/mission/hand/camera_mount.h"
#include "core/protocol/reader.h"
#include "tests/suite/suite.h"

namespace tst_camera_mount {

using namespace usar;
using mission::CameraMount;
using News = CameraMount::News;

namespace {

const std::string two_cameras =
    "CONF {Type Camera} {Name Left} {CameraDefFov 0.8} {CameraMinFov 0.4} {CameraMaxFov 1.6} "
    "{Name Right} {CameraDefFov 1.0} {CameraMinFov 1.0} {CameraMaxFov 1.0}";
const std::string pan_and_tilt = "MISSTA {Time 1.0} {Name CameraPanTilt} {Link 1} {Value 0.1} {Link 2} {Value -0.2}";

News hear(CameraMount& mount, const std::string& line) {
    protocol::Reader reader;
    return mount.take(reader.read(line).message);
}

/// Angles of the mount's two links, as they would be sent.
std::vector<double> wanted(const CameraMount& mount) {
    std::vector<double> values;
    if (const auto drive = mount.drive())
        for (const protocol::LinkTarget& link : drive->links)
            values.push_back(link.value);
    return values;
}

} // namespace

class tst_CameraMount : public QObject {
    Q_OBJECT
private slots:
    void knowsNothingBeforeItIsTold() {
        CameraMount mount;
        QVERIFY(!mount.answered() && !mount.shown() && !mount.canZoom() && !mount.canTurn() && !mount.lightKnown());
        mount.zoomBy(2.0);
        QVERIFY(!mount.next() && !mount.turnBy(1.0, 1.0) && !mount.drive());
        QVERIFY(hear(mount, "CONF {Type Camera}") == News::Cameras);
        QVERIFY(mount.answered() && mount.cameras().empty()); // it has none
    }

    void listsTheCamerasOfAnAnswer() {
        CameraMount mount;
        QVERIFY(hear(mount, "CONF {Type Sonar} {Name F1} {MaxRange 5}") == News::None);
        QVERIFY(!mount.answered());
        QVERIFY(hear(mount, two_cameras) == News::Cameras);
        QCOMPARE(mount.cameras().size(), std::size_t(2));
        QCOMPARE(mount.shown()->configuration.name, std::string("Left"));
        QCOMPARE(mount.shown()->fov_rad, 0.8);
        mount.show("Right");
        QCOMPARE(mount.shown()->configuration.name, std::string("Right"));
        QVERIFY(!mount.canZoom()); // its least angle is its largest
        mount.show("Elsewhere");
        QCOMPARE(mount.shown()->configuration.name, std::string("Right"));
    }

    void zoomsWithinWhatTheCameraCanDo() {
        CameraMount mount;
        hear(mount, two_cameras);
        mount.zoomBy(1.25);
        QCOMPARE(mount.shown()->fov_rad, 0.64);
        mount.zoomTo(0.1);
        QCOMPARE(mount.shown()->fov_rad, 0.4);
        mount.zoomTo(3.0);
        QCOMPARE(mount.shown()->fov_rad, 1.6);
        mount.resetZoom();
        QCOMPARE(mount.shown()->fov_rad, 0.8);
    }

    void onlyTheNewestSetOfAKindWaits() {
        CameraMount mount;
        hear(mount, two_cameras);
        mount.zoomTo(1.0);
        mount.zoomTo(1.2);
        const auto set = mount.next();
        QVERIFY(set && std::holds_alternative<protocol::ZoomCamera>(*set));
        QCOMPARE(std::get<protocol::ZoomCamera>(*set).field_of_view_rad, 1.2);
        QVERIFY(!mount.next());
    }

    void turnsFromWhereTheMountStands() {
        CameraMount mount;
        QVERIFY(hear(mount, pan_and_tilt) == News::Abilities);
        QVERIFY(hear(mount, pan_and_tilt) == News::None);
        QVERIFY(mount.turn(0.3, 0.1));
        const std::vector<double> values = wanted(mount);
        QCOMPARE(values.size(), std::size_t(2));
        QVERIFY(std::abs(std::abs(values[0]) - 0.4) < 1e-9 || std::abs(std::abs(values[0]) - 0.2) < 1e-9);
        mount.center();
        QCOMPARE(wanted(mount), (std::vector{0.0, 0.0}));
    }

    void aSingleLinkTilts() {
        CameraMount mount;
        hear(mount, "MISSTA {Time 1.0} {Name CameraTilt} {Link 1} {Value 0}");
        QVERIFY(mount.turn(1.0, 0.25));
        QCOMPARE(wanted(mount), (std::vector{0.25}));
    }

    void turnsStopAtTheirEnds() {
        CameraMount mount;
        hear(mount, "MISSTA {Time 1.0} {Name CameraPanTilt} {Link 1} {Value 0} {Link 2} {Value 0}");
        for (int i = 0; i < 100; ++i)
            mount.turn(1.0, -1.0);
        QCOMPARE(wanted(mount), (std::vector{pi, -pi / 2.0}));
    }

    void reportsOnTheWayDoNotMoveTheTarget() {
        CameraMount mount;
        hear(mount, "MISSTA {Time 1.0} {Name CameraTilt} {Link 1} {Value 0}");
        mount.turn(0.0, 0.5);
        mount.setTurning(true);
        hear(mount, "MISSTA {Time 1.2} {Name CameraTilt} {Link 1} {Value 0.1}");
        QCOMPARE(wanted(mount), (std::vector{0.5}));
    }

    void hearsWhatAnAnswerSaysOfTheZoom() {
        CameraMount mount;
        hear(mount, two_cameras);
        QVERIFY(!mount.takeAnswered());
        QVERIFY(hear(mount, "RES {Type Camera} {Name Left} {Status OK} {FOV 0.7}") != News::Cameras);
        QVERIFY(mount.takeAnswered());
        QVERIFY(!mount.takeAnswered());
    }

    void hearsTheHeadlight() {
        CameraMount mount;
        QVERIFY(hear(mount, "STA {Type GroundVehicle} {Time 1} {LightToggle True}") == News::Abilities);
        QVERIFY(mount.lightKnown() && mount.lightOn());
        QVERIFY(hear(mount, "STA {Type GroundVehicle} {Time 2} {LightToggle True}") == News::None);
        QVERIFY(hear(mount, "STA {Type GroundVehicle} {Time 3} {LightToggle False}") == News::Abilities);
        QVERIFY(!mount.lightOn());
    }

    void otherPackagesAreNoMounts() {
        CameraMount mount;
        QVERIFY(hear(mount, "MISSTA {Time 1.0} {Name Gripper} {Link 1} {Value 0}") == News::None);
        QVERIFY(!mount.canTurn());
    }
};

USAR_TEST(tst_CameraMount)

} // namespace tst_camera_mount

#include "tst_camera_mount.moc"
