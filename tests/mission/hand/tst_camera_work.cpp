// The camera of a robot is asked, turned and zoomed at the pace that servers take commands.
#include <algorithm>

#include <QSignalSpy>
#include <QTest>

#include "core/mission/hand/camera_work.h"
#include "core/protocol/reader.h"
#include "tests/suite/suite.h"

namespace tst_camera_work {

using namespace usar;
using namespace usar::mission;

namespace {

/// A robot that keeps what it is sent.
struct Desk {
    bool live = true;
    std::vector<protocol::Command> sent;
    CameraWork work{[this] { return live; }, [this](const protocol::Command& command) { sent.push_back(command); }};
    protocol::Reader reader;

    void hear(const std::string& line) { work.take(reader.read(line).message); }
    /// The server's answer to the question for its cameras.
    void hearCamera() {
        hear("CONF {Type Camera} {Name Camera} {CameraDefFov 0.8} {CameraMinFov 0.4} {CameraMaxFov 1.6}");
    }
    template <class Command>
    std::size_t count() const {
        return static_cast<std::size_t>(std::ranges::count_if(
            sent, [](const protocol::Command& command) { return std::holds_alternative<Command>(command); }));
    }
};

} // namespace

class tst_CameraWork : public QObject {
    Q_OBJECT
private slots:
    void itAsksOnceUntilItIsAnswered();
    void theNextSetWaitsForTheAnswer();
    void nothingIsSentToARobotThatIsGone();
    void aViewerAttachesOnce();
};

void tst_CameraWork::itAsksOnceUntilItIsAnswered() {
    Desk desk;
    desk.work.ask();
    desk.work.ask();
    QCOMPARE(desk.count<protocol::GetConfiguration>(), 1u);
    QSignalSpy known(&desk.work, &CameraWork::camerasKnown);
    desk.hearCamera();
    QCOMPARE(known.size(), 1);
    desk.work.ask();
    QCOMPARE(desk.count<protocol::GetConfiguration>(), 1u);
    desk.work.restart();
    desk.work.ask();
    QCOMPARE(desk.count<protocol::GetConfiguration>(), 2u);
}

void tst_CameraWork::theNextSetWaitsForTheAnswer() {
    Desk desk;
    desk.hearCamera();
    desk.work.zoomTo(1.0);
    desk.work.zoomTo(1.2);
    desk.work.zoomTo(1.4);
    QCOMPARE(desk.count<protocol::ZoomCamera>(), 1u);
    desk.hear("RES {Type Camera} {Name Left} {Status OK} {FOV 0.7}");
    QCOMPARE(desk.count<protocol::ZoomCamera>(), 2u); // only the newest of those that waited
    QCOMPARE(std::get<protocol::ZoomCamera>(desk.sent.back()).field_of_view_rad, 1.4);
}

void tst_CameraWork::nothingIsSentToARobotThatIsGone() {
    Desk desk;
    desk.hearCamera();
    desk.live = false;
    desk.work.zoomTo(1.0);
    desk.work.center();
    QVERIFY(desk.sent.empty());
}

void tst_CameraWork::aViewerAttachesOnce() {
    Desk desk;
    desk.work.attach("R1", "127.0.0.1"); // no camera is known yet
    desk.hearCamera();
    desk.work.attach("R1", "");
    QVERIFY(desk.sent.empty());
    desk.work.attach("R1", "127.0.0.1");
    desk.work.attach("R1", "127.0.0.1");
    QCOMPARE(desk.count<protocol::AttachCamera>(), 1u);
    desk.work.detach();
    desk.hear("RES {Type Camera} {Name Left} {Status OK} {FOV 0.7}");
    desk.work.attach("R1", "127.0.0.1");
    QCOMPARE(desk.count<protocol::AttachCamera>(), 2u);
}

USAR_TEST(tst_CameraWork)

} // namespace tst_camera_work

#include "tst_camera_work.moc"
