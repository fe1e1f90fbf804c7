#include <cmath>

#include <QByteArray>
#include <QHostAddress>
#include <QMap>
#include <QObject>
#include <QSignalSpy>
#include <QString>
#include <QStringList>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTest>

#include "core/link/wireless_client.h"
#include "tests/server/radio_world.h"
#include "tests/suite/suite.h"
#include "tests/suite/waiting.h"

namespace tst_wireless_client {

using namespace usar;
using namespace usar::link;
using namespace usar::server;

namespace {

/// Answers as the original does: for the asking robot only, and it hangs up on names that are not in its world.
class OriginalServer {
public:
    OriginalServer() {
        QObject::connect(&server_, &QTcpServer::newConnection, &server_, [this] {
            QTcpSocket* const socket = server_.nextPendingConnection();
            QObject::connect(socket, &QTcpSocket::readyRead, socket, [this, socket] {
                while (socket->canReadLine())
                    answer(*socket, socket->readLine().trimmed());
            });
            QObject::connect(socket, &QTcpSocket::disconnected, socket, [this, socket] {
                names_.remove(socket);
                socket->deleteLater();
            });
        });
        server_.listen(QHostAddress::LocalHost, 0);
    }
    quint16 port() const { return server_.serverPort(); }
    QStringList world{"R1", "R2", "R3"};
    QStringList taken; ///< by programs of their own
    int observers = 0;

private:
    void answer(QTcpSocket& socket, const QByteArray& line) {
        const QString robot = line.mid(line.indexOf("{Robot ") + 7).split('}').front();
        if (line.startsWith("INIT")) {
            if (taken.contains(robot) || names_.values().contains(robot)) {
                socket.write("ERROR {Reason Robot.Alread.Exists}\r\n");
                return;
            }
            names_[&socket] = robot;
            observers += world.contains(robot) ? 0 : 1;
            socket.write("INITREPLY {Status OK}\r\n");
        } else if (line.startsWith("GETSS")) {
            const bool known = world.contains(names_[&socket]) && world.contains(robot);
            socket.write("SS {Robot " + robot.toUtf8() + "} {Strength " +
                         (known ? QByteArray("-60.5}") : QByteArray("NaN} {Error Robot.Does.Not.Exist}")) + "\r\n");
            if (!world.contains(names_[&socket]))
                socket.disconnectFromHost(); // kicked out, as the original does within a second
        }
    }

    QMap<QTcpSocket*, QString> names_; // before the server, whose end closes sockets
    QTcpServer server_;
};

/// Quick for tests, and keeps what was said last.
struct Asking {
    WirelessClient client;
    RadioStrengths last;
    LinkStatus status;
    int reports = 0;

    explicit Asking(quint16 port, const QStringList& robots) {
        LinkLimits limits;
        limits.first_retry = Seconds{0.05};
        client.setLimits(limits);
        client.setInterval(std::chrono::milliseconds(20));
        QObject::connect(&client, &WirelessClient::reported, &client, [this](const RadioStrengths& strengths) {
            last = strengths;
            ++reports;
        });
        QObject::connect(&client, &WirelessClient::statusChanged, &client,
                         [this](const LinkStatus& now) { status = now; });
        client.setRobots(robots);
        client.open("127.0.0.1", port);
    }
    std::optional<double> between(const QString& a, const QString& b) const {
        for (const RadioStrength& one : last)
            if (one.a == a && one.b == b)
                return one.strength_dbm;
        return std::nullopt;
    }
};

bool near(std::optional<double> value, double expected) {
    return value && std::abs(*value - expected) < 1e-3;
}

} // namespace

class tst_WirelessClient : public QObject {
    Q_OBJECT

private slots:
    void tellsTheStrengthOfEveryPair() {
        RadioWorld world;
        world.place("R1", 0.0);
        world.place("R2", 20.0);
        world.place("Base", 0.0, 2.0);
        Asking asking(world.wireless_port, {"R1", "R2", "Base"});
        QTRY_COMPARE(asking.last.size(), std::size_t(3));
        QVERIFY(near(asking.between("R1", "R2"), -59.67));
        QVERIFY(near(asking.between("Base", "R1"), -49.67));
        QCOMPARE(asking.status.state, LinkState::Connected);
        world.place("R2", 2.0);
        QTRY_VERIFY(near(asking.between("R1", "R2"), -49.67));
    }

    void takesNoRobotsName() {
        RadioWorld world;
        world.place("R1", 0.0);
        world.place("R2", 20.0);
        Peer own(world.wireless_port), other(world.wireless_port);
        QCOMPARE(other.ask("INIT {Robot MissionControl} {Port 1}\r\n"), QByteArray("INITREPLY {Status OK}"));
        Asking asking(world.wireless_port, {"R1", "R2"});
        QTRY_VERIFY(near(asking.between("R1", "R2"), -59.67)); // under another name, because the first is taken
        QCOMPARE(own.ask("INIT {Robot R1} {Port 5000}\r\n"), QByteArray("INITREPLY {Status OK}"));
    }

    void aRobotThatIsNotThereHasNoStrength() {
        RadioWorld world;
        world.place("R1", 0.0);
        Asking asking(world.wireless_port, {"R1", "R2"});
        QTRY_COMPARE(asking.last, (RadioStrengths{{"R1", "R2", std::nullopt}}));
    }

    void fewerThanTwoRobotsNeedNoServer() {
        RadioWorld world;
        Asking asking(world.wireless_port, {"R1"});
        Peer other(world.wireless_port); // who comes after it is answered, and it has not come
        QCOMPARE(other.ask("INIT {Robot R1} {Port 5000}\r\n"), QByteArray("INITREPLY {Status OK}"));
        QCOMPARE(asking.status.state, LinkState::Disconnected);
        QVERIFY(asking.last.empty());
        asking.client.setRobots({"R1", "R2"});
        QTRY_COMPARE(asking.status.state, LinkState::Connected);
        asking.client.setRobots({});
        QTRY_COMPARE(asking.status.state, LinkState::Disconnected);
    }

    void anOriginalServerIsAskedAsTheRobotsThemselves() {
        OriginalServer server;
        Asking asking(server.port(), {"R1", "R2", "R3"});
        QTRY_COMPARE(asking.last.size(), std::size_t(3));
        QTRY_VERIFY(near(asking.between("R1", "R2"), -60.5) && near(asking.between("R2", "R3"), -60.5));
        QCOMPARE(server.observers, 1); // and not again
    }

    void aRobotWhoseNameIsTakenIsAskedForFromTheOtherSide() {
        OriginalServer server;
        server.taken << "R1";
        Asking asking(server.port(), {"R1", "R2"});
        QTRY_VERIFY(near(asking.between("R1", "R2"), -60.5));
    }

    void noServerIsSaidWithTheMend() {
        quint16 closed = 0;
        {
            const Listener gone;
            closed = gone.port();
        }
        Asking asking(closed, {"R1", "R2"});
        QTRY_COMPARE(asking.status.state, LinkState::Waiting);
        QCOMPARE(asking.status.trouble,
                 QString("Nothing listens at 127.0.0.1:%1. Start WSS there, or check the port (usually 50000).")
                     .arg(closed));
        QVERIFY(asking.last.empty());
    }

    void comesBackWhenTheServerDoes() {
        auto world = std::make_unique<RadioWorld>();
        world->place("R1", 0.0);
        world->place("R2", 20.0);
        const quint16 port = world->wireless_port;
        Asking asking(port, {"R1", "R2"});
        QTRY_VERIFY(near(asking.between("R1", "R2"), -59.67));
        world.reset();
        QTRY_VERIFY(asking.last.empty());
        RadioWorld again;
        again.place("R1", 0.0);
        again.place("R2", 2.0);
        WirelessServer same_place(again.relay);
        QVERIFY(same_place.listen(port));
        QTRY_VERIFY(near(asking.between("R1", "R2"), -49.67));
    }

    void garbageHarmsNothing() {
        Listener server;
        Asking asking(server.port(), {"R1", "R2"});
        QTRY_COMPARE(server.calls(), 1);
        server.peer.say("INITREPLY\r\nSS\r\nSS {Robot} {From} {Strength x}\r\nERROR\r\nERROR {Reason }\r\n{{{}\r\n"
                        "SS {Robot R2} {From R1} {Strength -1.#IND}\r\n");
        QTRY_VERIFY(asking.reports > 3);
        QVERIFY(!asking.between("R1", "R2"));
    }
};

USAR_TEST(tst_WirelessClient)

} // namespace tst_wireless_client

#include "tst_wireless_client.moc"
