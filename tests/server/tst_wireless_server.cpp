#include <QByteArray>
#include <QObject>
#include <QString>
#include <QTcpSocket>
#include <QTest>

#include "tests/server/radio_world.h"
#include "tests/suite/suite.h"

namespace tst_wireless_server {

using namespace usar;
using namespace usar::server;

class tst_WirelessServer : public QObject {
    Q_OBJECT

private slots:
    void everyRequestHasItsReply_data() {
        QTest::addColumn<QByteArray>("request");
        QTest::addColumn<QByteArray>("reply");
        const auto row = [](const char* name, const char* request, const char* reply) {
            QTest::newRow(name) << QByteArray(request) << QByteArray(reply);
        };
        row("a strength: 20 m, no wall", "GETSS {Robot R2}", "SS {Robot R2} {Strength -59.6700}");
        row("a strength to oneself", "GETSS {Robot R1}", "SS {Robot R1} {Strength INF} {Error SS.To.Self}");
        row("a strength to nobody", "GETSS {Robot R9}", "SS {Robot R9} {Strength NaN} {Error Robot.Does.Not.Exist}");
        row("a strength to one who is not in the world", "GETSS {Robot Ghost}",
            "SS {Robot Ghost} {Strength NaN} {Error Model.Returned.NaN}");
        row("a strength to no name", "GETSS", "ERROR {Reason Robot.Name.Must.Not.Be.Empty}");
        row("a strength between two others", "GETSS {Robot R2} {From Base}",
            "SS {Robot R2} {From Base} {Strength -59.6700}");
        row("a strength between others of whom one is not there", "GETSS {Robot R9} {From Base}",
            "SS {Robot R9} {From Base} {Strength NaN} {Error Robot.Does.Not.Exist}");
        row("a strength from another to itself", "GETSS {Robot R2} {From R2}",
            "SS {Robot R2} {From R2} {Strength INF} {Error SS.To.Self}");
        row("a port of nobody", "DNS {Robot R9}", "DNSREPLY {Robot R9} {Port -1} {Error NoSuchRobot}");
        row("a port of oneself", "DNS {Robot R1}", "DNSREPLY {Robot R1} {Port -1} {Error NoSuchRobot}");
        row("a port that nobody listens on", "DNS {Robot R2} {Port 7777}",
            "DNSREPLY {Robot R2} {Port -1} {Error RobotDoesNotListenOnThisPort}");
        row("any port of one who does not listen", "DNS {Robot Deaf}",
            "DNSREPLY {Robot Deaf} {Port -1} {Error RobotDoesNotListenOnThisPort}");
        row("a port that is a word", "DNS {Robot R2} {Port five}", "ERROR {Reason Port.Must.Be.Integer}");
        row("a port beyond all ports", "DNS {Robot R2} {Port 65536}", "ERROR {Reason Port.Must.Be.Integer}");
        row("a port of no name", "DNS {Port 5000}", "ERROR {Reason Robot.Name.Must.Not.Be.Empty}");
        row("a caller that does not call", "REVERSEDNS {Port 4711}",
            "REVERSEDNSREPLY {Port 4711} {Error UnknownOrIllegalPort}");
        row("a caller by a word", "REVERSEDNS {Port who}", "ERROR {Reason Port.Must.Be.Integer}");
        row("a caller by nothing", "REVERSEDNS", "ERROR {Reason Port.Must.Be.Integer}");
        row("a second INIT", "INIT {Robot R7} {Port 1}", "ERROR {Reason Method.Unknown.Or.Can.INIT.only.once}");
        row("an unknown word", "HELLO {Robot R2}", "ERROR {Reason Method.Unknown.Or.Can.INIT.only.once}");
        row("words in any case", "getss {robot R2}", "SS {Robot R2} {Strength -59.6700}");
    }

    void everyRequestHasItsReply() {
        QFETCH(QByteArray, request);
        QFETCH(QByteArray, reply);
        RadioWorld world;
        world.place("R1", 0.0);
        world.place("R2", 20.0);
        world.place("Base", 20.0, 20.0);
        Peer r1(world.wireless_port), r2(world.wireless_port), ghost(world.wireless_port), deaf(world.wireless_port);
        QCOMPARE(r1.ask("INIT {Robot R1} {Port 5000}\r\n"), QByteArray("INITREPLY {Status OK}"));
        QCOMPARE(r2.ask("INIT {Robot R2} {Port 6000,6001}\r\n"), QByteArray("INITREPLY {Status OK}"));
        QCOMPARE(ghost.ask("INIT {Robot Ghost} {Port 7000}\r\n"), QByteArray("INITREPLY {Status OK}"));
        QCOMPARE(deaf.ask("INIT {Robot Deaf}\n"), QByteArray("INITREPLY {Status OK}"));
        QCOMPARE(r1.ask(request + "\r\n"), reply);
    }

    void whoHasNotSaidInitHearsWhy_data() {
        QTest::addColumn<QByteArray>("request");
        QTest::addColumn<QByteArray>("reason");
        QTest::newRow("a question first") << QByteArray("GETSS {Robot R2}") << QByteArray("Must.Use.INIT.Method.First");
        QTest::newRow("garbage first") << QByteArray("\x01\xff{{}}{") << QByteArray("Must.Use.INIT.Method.First");
        QTest::newRow("a port that is a word")
            << QByteArray("INIT {Robot R1} {Port 1,two}") << QByteArray("Ports.List.Must.Be.Integer");
        QTest::newRow("no name") << QByteArray("INIT {Port 5000}") << QByteArray("Robot.Name.Must.Not.Be.Empty");
        QTest::newRow("a name that is taken")
            << QByteArray("INIT {Robot Taken} {Port 1}") << QByteArray("Robot.Alread.Exists");
    }

    void whoHasNotSaidInitHearsWhy() {
        QFETCH(QByteArray, request);
        QFETCH(QByteArray, reason);
        RadioWorld world;
        Peer other(world.wireless_port), own(world.wireless_port);
        QCOMPARE(other.ask("INIT {Robot Taken} {Port 1}\r\n"), QByteArray("INITREPLY {Status OK}"));
        QCOMPARE(own.ask(request + "\r\n"), "ERROR {Reason " + reason + "}");
        QCOMPARE(own.ask("INIT {Robot R1} {Port 5000}\r\n"), QByteArray("INITREPLY {Status OK}"));
    }

    void aNameIsFreeAgainWhenItsConnectionCloses() {
        RadioWorld world;
        auto first = std::make_unique<Peer>(world.wireless_port);
        QCOMPARE(first->ask("INIT {Robot R1} {Port 1}\r\n"), QByteArray("INITREPLY {Status OK}"));
        first.reset();
        Peer second(world.wireless_port);
        QByteArray reply;
        QTRY_VERIFY(reply == "INITREPLY {Status OK}" || (reply = second.ask("INIT {Robot R1}\r\n"), false));
    }

    void strengthFollowsWhoMoves() {
        RadioWorld world(3);
        world.place("R1", -10.0);
        world.place("R2", -8.0);
        Peer r1(world.wireless_port), r2(world.wireless_port);
        r1.ask("INIT {Robot R1}\r\n");
        r2.ask("INIT {Robot R2}\r\n");
        QCOMPARE(r1.ask("GETSS {Robot R2}\r\n"), QByteArray("SS {Robot R2} {Strength -49.6700}"));
        world.place("R2", 10.0); // 20 m and three walls: 10 + 3 x 6.325 dB
        QCOMPARE(r1.ask("GETSS {Robot R2}\r\n"), QByteArray("SS {Robot R2} {Strength -78.6450}"));
        world.takeAway("R2");
        QCOMPARE(r1.ask("GETSS {Robot R2}\r\n"), QByteArray("SS {Robot R2} {Strength NaN} {Error Model.Returned.NaN}"));
    }

    void aCallReachesTheOtherAndTellsWhoCalls() {
        RadioWorld world;
        world.place("R1", 0.0);
        world.place("R2", 20.0);
        Listener listener;
        Peer r1(world.wireless_port), r2(world.wireless_port);
        r1.ask("INIT {Robot R1}\r\n");
        r2.ask("INIT {Robot R2} {Port " + listener.portText() + "}\r\n");
        const QByteArray reply = r1.ask("DNS {Robot R2}\r\n");
        QVERIFY2(reply.startsWith("DNSREPLY {Robot R2} {Port "), reply);
        QCOMPARE(r1.ask("DNS {Robot R2} {Port " + listener.portText() + "}\r\n"), reply); // the same door
        Peer call(static_cast<quint16>(reply.mid(25).chopped(1).toInt()));
        call.say("hello");
        QTRY_COMPARE(listener.peer.heard(), QByteArray("hello"));
        listener.peer.say("good day");
        QTRY_COMPARE(call.heard(), QByteArray("good day"));
        const QByteArray from = QByteArray::number(listener.peer.socket().peerPort());
        QCOMPARE(r2.ask("REVERSEDNS {Port " + from + "}\r\n"), "REVERSEDNSREPLY {Port " + from + "} {Robot R1}");
        QCOMPARE(r1.ask("REVERSEDNS {Port " + from + "}\r\n"),
                 "REVERSEDNSREPLY {Port " + from + "} {Error UnknownOrIllegalPort}"); // it is not R1 that is called
    }

    void listensOnLoopbackOnly() {
        RadioWorld world;
        QTcpSocket elsewhere;
        elsewhere.connectToHost("127.0.0.2", world.wireless_port);
        QVERIFY(!elsewhere.waitForConnected(2000));
    }

    void aPortInUseIsSaidWithTheMend() {
        RadioWorld world;
        WirelessServer second(world.relay);
        const auto result = second.listen(world.wireless_port);
        QVERIFY(!result);
        QVERIFY(QString::fromStdString(result.error().text()).contains("in use"));
        QVERIFY(QString::fromStdString(result.error().text()).contains("--wireless-port"));
    }

    void aFloodAndAnEndlessLineHarmNobody() {
        RadioWorld world;
        world.place("R1", 0.0);
        world.place("R2", 20.0);
        Peer r1(world.wireless_port), r2(world.wireless_port), flood(world.wireless_port), endless(world.wireless_port);
        r1.ask("INIT {Robot R1}\r\n");
        r2.ask("INIT {Robot R2}\r\n");
        flood.socket().setReadBufferSize(1024); // and it does not read
        flood.say("INIT {Robot Flood}\r\n" + QByteArray("GETSS {Robot R2}\r\n").repeated(200000));
        endless.say(QByteArray(8 << 20, 'x'));
        for (int i = 0; i < 20; ++i)
            QCOMPARE(r1.ask("GETSS {Robot R2}\r\n"), QByteArray("SS {Robot R2} {Strength -59.6700}"));
        QTRY_COMPARE(endless.socket().bytesToWrite(), 0);
        QCOMPARE(endless.ask("\r\nINIT {Robot Endless}\r\n"), QByteArray("INITREPLY {Status OK}"));
    }

    void silentConnectionsMakeRoom() {
        RadioWorld world;
        world.wireless.setMostClients(4);
        Peer r1(world.wireless_port);
        r1.ask("INIT {Robot R1}\r\n");
        std::vector<std::unique_ptr<Peer>> silent;
        for (int i = 0; i < 12; ++i)
            silent.push_back(std::make_unique<Peer>(world.wireless_port));
        Peer late(world.wireless_port);
        QCOMPARE(late.ask("INIT {Robot R2}\r\n"), QByteArray("INITREPLY {Status OK}"));
        QCOMPARE(r1.ask("GETSS {Robot R1}\r\n"), QByteArray("SS {Robot R1} {Strength INF} {Error SS.To.Self}"));
    }

    void whatIsSaidBeforeHangingUpIsHeard() {
        RadioWorld world;
        Peer hasty(world.wireless_port);
        hasty.say("INIT {Robot R1}\r\n");
        hasty.socket().disconnectFromHost();
        Peer later(world.wireless_port);
        QByteArray reply;
        QTRY_VERIFY(reply == "INITREPLY {Status OK}" || (reply = later.ask("INIT {Robot R1}\r\n"), false));
    }
};

USAR_TEST(tst_WirelessServer)

} // namespace tst_wireless_server

#include "tst_wireless_server.moc"
