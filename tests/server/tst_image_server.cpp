// The image server over TCP: what the protocol says, and clients that do not keep to it.
#include <QAbstractSocket>
#include <QByteArray>
#include <QObject>
#include <QSignalSpy>
#include <QSize>
#include <QString>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTest>
#include <QtEndian>

#include "core/link/image_client.h"
#include "core/server/image_server.h"
#include "core/sim/camera/scene_capture.h"
#include "tests/suite/suite.h"
#include "tests/suite/waiting.h"

namespace tst_image_server {

using namespace usar;
using namespace usar::link;
using namespace usar::server;

namespace {

sim::CameraScene roomWithBall(std::uint64_t tick) {
    static const auto still = [] {
        sim::World world;
        world.terrain = sim::Terrain(33, 33, 1.0, {-16.0, -16.0}, std::vector<float>(33 * 33, 0.0f));
        return std::make_shared<const sim::StillWorld>(std::move(world));
    }();
    sim::CameraScene scene;
    scene.still = still;
    scene.tick = tick;
    scene.solids.push_back(sim::seenSolid(sim::SphereShape{0.5}, Pose{.position_m = {4.0, 0.0, 1.0}}.isometry(),
                                          sim::Color{1.0f, 0.0f, 0.0f}));
    sim::SeenFrom camera;
    camera.robot = "R1";
    camera.camera = "Camera";
    camera.camera_in_map = Pose{.position_m = {0.0, 0.0, 1.0}}.isometry();
    camera.width_px = 62; // a raw row of it needs filling
    camera.height_px = 48;
    scene.cameras = {camera};
    return scene;
}

/// A server on a free port; each look is another tick.
struct Served {
    explicit Served(const ImageServerOptions& options = {})
        : server([this] { return roomWithBall(++ticks); }, options) {}

    std::uint64_t ticks = 0;
    ImageServer server;
    quint16 port = *server.listen(0);
};

/// A client that cuts what it has read into frames.
class Viewer {
public:
    explicit Viewer(quint16 port) {
        QObject::connect(&socket_, &QTcpSocket::readyRead, [this] { heard_ += socket_.readAll(); });
        socket_.connectToHost("127.0.0.1", port);
        socket_.waitForConnected(2000);
    }
    void say(const QByteArray& bytes) { socket_.write(bytes); }
    /// One byte a time, each in a packet of its own as far as this machine lets it.
    void trickle(const QByteArray& bytes) {
        for (const char byte : bytes) {
            socket_.write(&byte, 1);
            socket_.flush();
            test::turnEventLoop();
        }
    }
    struct Frame {
        int type;
        QByteArray data;
    };
    std::vector<Frame> frames() const {
        std::vector<Frame> frames;
        qsizetype at = 0;
        while (at + 5 <= heard_.size()) {
            const auto size = static_cast<qsizetype>(qFromBigEndian<quint32>(heard_.constData() + at + 1));
            if (at + 5 + size > heard_.size())
                break;
            frames.push_back({heard_[at], heard_.mid(at + 5, size)});
            at += 5 + size;
        }
        return frames;
    }
    std::size_t count() const { return frames().size(); }
    QTcpSocket& socket() { return socket_; }

private:
    QTcpSocket socket_;
    QByteArray heard_;
};

QByteArray part(quint32 x, quint32 y, quint32 width, quint32 height) {
    return bytesOf({ImageRequest::Part{x, y, width, height}});
}

bool isJpeg(const QByteArray& data) {
    return data.startsWith("\xFF\xD8") && data.endsWith("\xFF\xD9");
}

} // namespace

class tst_ImageServer : public QObject {
    Q_OBJECT

private slots:
    void eachOkBringsOneFrame() {
        Served served;
        Viewer viewer(served.port);
        Viewer other(served.port);
        other.say("OK");
        QTRY_COMPARE(other.count(), 1u);
        QCOMPARE(viewer.count(), 0u); // nothing without a request
        viewer.say("OK");
        QTRY_COMPARE(viewer.count(), 1u);
        QCOMPARE(viewer.frames()[0].type, 2);
        QVERIFY(isJpeg(viewer.frames()[0].data));
        viewer.say("OKOK");
        QTRY_COMPARE(viewer.count(), 3u);
        other.say("OK");
        QTRY_COMPARE(other.count(), 2u);
        QCOMPARE(viewer.count(), 3u);
    }

    void theLegacyServerSendsTheFirstFrameUnasked() {
        Served served({.frame_on_connect = true});
        Viewer viewer(served.port);
        QTRY_COMPARE(viewer.count(), 1u);
        viewer.say("OK");
        QTRY_COMPARE(viewer.count(), 2u);
    }

    void requestsAreFoundInAnyBytes_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<int>("requests");
        QTest::newRow("with a line end") << QByteArray("OK\r\n") << 1;
        QTest::newRow("two with line ends") << QByteArray("OK\r\nOK\r\n") << 2;
        QTest::newRow("after an O of its own") << QByteArray("OOOK") << 1;
        QTest::newRow("after words of another protocol") << QByteArray("GET / HTTP/1.1\r\n\r\nOK") << 1;
        QTest::newRow("small letters are none") << QByteArray("ok") << 0;
        QTest::newRow("a part") << part(0, 0, 8, 8) << 1;
        QTest::newRow("a part whose numbers look like requests") << QByteArray("UOKOKOKOKOKOKOKOK") << 1;
        QTest::newRow("a part and a whole") << part(1, 2, 3, 4) + "OK" << 2;
        QTest::newRow("an O, then a part") << "O" + part(1, 2, 3, 4) << 1;
        QTest::newRow("zeros") << QByteArray(64, '\0') << 0;
    }

    void requestsAreFoundInAnyBytes() {
        QFETCH(QByteArray, bytes);
        QFETCH(int, requests);
        ImageRequestReader at_once;
        std::deque<ImageRequest> found;
        at_once.feed({bytes.constData(), static_cast<std::size_t>(bytes.size())}, found);
        QCOMPARE(static_cast<int>(found.size()), requests);
        ImageRequestReader by_bytes;
        std::deque<ImageRequest> again;
        for (const char byte : bytes)
            by_bytes.feed({&byte, 1}, again);
        QVERIFY(found == again);
    }

    void requestsMayComeInChunks() {
        Served served;
        Viewer viewer(served.port);
        viewer.trickle("OK\r\n" + part(0, 0, 10, 10) + "OK");
        QTRY_COMPARE(viewer.count(), 3u);
    }

    void rawFramesAreBlueGreenRedWithFilledRows() {
        Served served({.type = ImageType::Raw});
        Viewer viewer(served.port);
        viewer.say("OK");
        QTRY_COMPARE(viewer.count(), 1u);
        const QByteArray data = viewer.frames()[0].data;
        QCOMPARE(viewer.frames()[0].type, 0);
        QCOMPARE(qFromBigEndian<quint16>(data.constData()), quint16(62));
        QCOMPARE(qFromBigEndian<quint16>(data.constData() + 2), quint16(48));
        constexpr int row_bytes = 188; // 62 pixels and two bytes of filling
        QCOMPARE(data.size(), 4 + 48 * row_bytes);
        const auto* const ball = reinterpret_cast<const uchar*>(data.constData()) + 4 + 24 * row_bytes + 31 * 3;
        QVERIFY(ball[2] > 2 * ball[0] && ball[2] > 2 * ball[1]);
        QCOMPARE(data[4 + row_bytes - 1], '\0');
    }

    void aPartIsThatPartOfThePicture() {
        Served served({.type = ImageType::Raw});
        Viewer viewer(served.port);
        viewer.say(part(20, 10, 30, 7) + part(50, 40, 1000, 1000) + part(9999, 9999, 1, 1));
        QTRY_COMPARE(viewer.count(), 3u);
        const auto size = [&](std::size_t frame) {
            const QByteArray data = viewer.frames()[frame].data;
            return QSize(qFromBigEndian<quint16>(data.constData()), qFromBigEndian<quint16>(data.constData() + 2));
        };
        QCOMPARE(size(0), QSize(30, 7));
        QCOMPARE(size(1), QSize(12, 8)); // what there is of it
        QCOMPARE(size(2), QSize(1, 1));  // an answer in any case
    }

    void qualitiesDifferInSize() {
        qsizetype last = 1 << 20;
        for (const ImageType type :
             {ImageType::Superb, ImageType::Good, ImageType::Normal, ImageType::Fair, ImageType::Bad}) {
            Served served({.type = type});
            Viewer viewer(served.port);
            viewer.say("OK");
            QTRY_COMPARE(viewer.count(), 1u);
            QCOMPARE(viewer.frames()[0].type, static_cast<int>(type));
            QVERIFY(viewer.frames()[0].data.size() < last);
            last = viewer.frames()[0].data.size();
        }
    }

    void severalClientsOfOneTickCostOnePicture() {
        ImageServer server([] { return roomWithBall(7); });
        const quint16 port = *server.listen(0);
        Viewer first(port);
        Viewer second(port);
        first.say("OKOK");
        second.say("OKOK");
        QTRY_COMPARE(first.count() + second.count(), 4u);
        QCOMPARE(server.picturesMade(), 1u);
        QCOMPARE(first.frames()[0].data, second.frames()[1].data);
    }

    void garbageAndSilentAndHalfOpenClientsHarmNobody() {
        Served served;
        Viewer silent(served.port);
        Viewer garbage(served.port);
        QByteArray noise;
        for (int i = 0; i < 100000; ++i)
            noise.append(static_cast<char>((i * 7919) >> 3));
        garbage.say(noise);
        Viewer half_open(served.port);
        half_open.say(part(0, 0, 10, 10).left(9));
        Viewer gone(served.port);
        gone.say("OK");
        gone.socket().abort();
        Viewer viewer(served.port);
        for (std::size_t i = 1; i <= 5; ++i) {
            viewer.say("OK");
            QTRY_COMPARE(viewer.count(), i);
        }
        QTRY_COMPARE(served.server.clientCount(), 4u);
    }

    void aClientThatDoesNotReadCostsNoFurtherPictures() {
        Served served({.type = ImageType::Raw});
        QTcpSocket deaf;
        deaf.setReadBufferSize(1);
        deaf.connectToHost("127.0.0.1", served.port);
        QVERIFY(deaf.waitForConnected(2000));
        for (int i = 0; i < 2000; ++i)
            deaf.write("OK");
        Viewer viewer(served.port);
        viewer.say("OK");
        QTRY_COMPARE(viewer.count(), 1u);
        for (std::size_t i = 2; i <= 20; ++i) { // it has had its turn as often
            viewer.say("OK");
            QTRY_COMPARE(viewer.count(), i);
        }
        QVERIFY(served.server.picturesMade() < 40); // at most those that may wait, and this one's twenty
    }

    void tooManyClientsAreRefused() {
        Served served;
        std::vector<std::unique_ptr<Viewer>> viewers;
        for (int i = 0; i < 40; ++i)
            viewers.push_back(std::make_unique<Viewer>(served.port));
        QTRY_COMPARE(viewers.back()->socket().state(), QAbstractSocket::UnconnectedState);
        QCOMPARE(served.server.clientCount(), 32u);
    }

    void listensOnLoopbackOnly() {
        Served served;
        QTcpSocket elsewhere;
        elsewhere.connectToHost("127.0.0.2", served.port); // loopback net, but not our address
        QVERIFY(!elsewhere.waitForConnected(2000));
    }

    void aPortInUseIsSaidWithTheMend() {
        Served served;
        ImageServer second([] { return roomWithBall(1); });
        const auto result = second.listen(served.port);
        QVERIFY(!result);
        const QString text = QString::fromStdString(result.error().text());
        QVERIFY2(text.contains("in use") && text.contains("--image-port"), qPrintable(text));
    }

    void aViewersAddressChoosesItsCamera() {
        ImageServer server(
            [] {
                sim::CameraScene scene = roomWithBall(1);
                scene.cameras.push_back(scene.cameras.front());
                scene.cameras.back().robot = "R2";
                scene.cameras.back().width_px = 24;
                scene.attached["127.0.0.1"] = {"R2", "Camera"};
                return scene;
            },
            {.type = ImageType::Raw});
        Viewer viewer(*server.listen(0));
        viewer.say("OK");
        QTRY_COMPARE(viewer.count(), 1u);
        QCOMPARE(qFromBigEndian<quint16>(viewer.frames()[0].data.constData()), quint16(24));
    }
};

USAR_TEST(tst_ImageServer)

} // namespace tst_image_server

#include "tst_image_server.moc"
