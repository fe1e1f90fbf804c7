// Who may connect to a server: this machine, and networks that were named; others are hung up on unread.
#include <QNetworkInterface>
#include <QTcpSocket>
#include <QTest>

#include "core/server/access.h"
#include "tests/suite/suite.h"

namespace tst_access {

using namespace usar;
using namespace usar::server;

namespace {

/// An IPv4 address of this machine other than loopback; null if it has none.
QHostAddress ownAddress() {
    for (const QHostAddress& address : QNetworkInterface::allAddresses())
        if (!address.isLoopback() && address.protocol() == QAbstractSocket::IPv4Protocol)
            return address;
    return {};
}

} // namespace

class tst_Access : public QObject {
    Q_OBJECT
private slots:
    void admitsThisMachineAndTheNetworks_data() {
        QTest::addColumn<QStringList>("networks");
        QTest::addColumn<QString>("peer");
        QTest::addColumn<bool>("admitted");
        const QStringList two{"10.1.0.0/16", "fd00:1::/32"};
        QTest::newRow("this machine") << QStringList{} << "127.0.0.1" << true;
        QTest::newRow("this machine by IPv6") << QStringList{} << "::1" << true;
        QTest::newRow("this machine, mapped") << QStringList{} << "::ffff:127.0.0.1" << true;
        QTest::newRow("another") << QStringList{} << "10.1.2.3" << false;
        QTest::newRow("this machine always") << two << "127.0.0.1" << true;
        QTest::newRow("in the network") << two << "10.1.2.3" << true;
        QTest::newRow("in the network, mapped") << two << "::ffff:10.1.2.3" << true;
        QTest::newRow("beside the network") << two << "10.2.2.3" << false;
        QTest::newRow("in the second network") << two << "fd00:1::7" << true;
        QTest::newRow("beside the second network") << two << "fd00:2::7" << false;
        QTest::newRow("a single machine") << QStringList{"10.1.2.3"} << "10.1.2.3" << true;
        QTest::newRow("its neighbor") << QStringList{"10.1.2.3"} << "10.1.2.4" << false;
    }
    void admitsThisMachineAndTheNetworks() {
        QFETCH(const QStringList, networks);
        QFETCH(const QString, peer);
        QFETCH(const bool, admitted);
        const auto access = Access::make(networks.isEmpty() ? "" : "0.0.0.0", networks);
        QVERIFY2(access.has_value(), access ? "" : access.error().text().c_str());
        QCOMPARE(access->admits(QHostAddress(peer)), admitted);
        QCOMPARE(access->isOpen(), !networks.isEmpty());
    }

    void hangsUpOnOthersUnread_data() {
        QTest::addColumn<bool>("allowed");
        QTest::newRow("its own network") << true;
        QTest::newRow("another network") << false;
    }
    void hangsUpOnOthersUnread() {
        QFETCH(const bool, allowed);
        const QHostAddress own = ownAddress();
        if (own.isNull())
            QSKIP("This machine has no address but loopback.");
        GuardedServer server;
        const QString other = own.isInSubnet(QHostAddress("192.0.2.0"), 24) ? "198.51.100.0/24" : "192.0.2.0/24";
        server.setAccess(*Access::make("0.0.0.0", {allowed ? own.toString() : other}));
        QStringList turned_away;
        connect(&server, &GuardedServer::turnedAway, this, [&](const QString& one) { turned_away << one; });
        const quint16 port = *server.open(0, "--port");
        QTcpSocket caller;
        caller.connectToHost(own, port);
        caller.write("INIT {ClassName USARBot.P2DX}\r\n");
        QVERIFY(QTest::qWaitFor([&] { return server.hasPendingConnections() || !turned_away.isEmpty(); }));
        QCOMPARE(server.hasPendingConnections(), allowed);
        QCOMPARE(turned_away.size(), allowed ? 0 : 1);
        if (!allowed) {
            QVERIFY(turned_away.front().contains(own.toString()));
            QVERIFY(QTest::qWaitFor([&] { return caller.state() == QAbstractSocket::UnconnectedState; }));
        }
    }

    void anAddressOfAnotherMachineIsAnError() {
        GuardedServer server;
        server.setAccess(*Access::make("192.0.2.7", {"192.0.2.0/24"}));
        const auto port = server.open(0, "--port");
        QVERIFY(!port);
        QVERIFY2(QString::fromStdString(port.error().text()).contains("--bind"), port.error().text().c_str());
    }
};

USAR_TEST(tst_Access)

} // namespace tst_access

#include "tst_access.moc"
