#include <QByteArray>
#include <QObject>
#include <QTest>

#include "core/server/com_server.h"
#include "tests/server/radio_world.h"
#include "tests/suite/suite.h"

namespace tst_com_interface {

using namespace usar;
using namespace usar::server;

class tst_ComInterface : public QObject {
    Q_OBJECT

private slots:
    void everyRequestHasItsReply_data() {
        QTest::addColumn<QByteArray>("request");
        QTest::addColumn<QByteArray>("reply");
        const auto row = [](const char* name, const char* request, const char* reply) {
            QTest::newRow(name) << QByteArray(request) << QByteArray(reply);
        };
        row("open ground", "GETOBS {From -30,0,-1} {To -20,0,-1}",
            "NUMOBS {From -30,0,-1} {To -20,0,-1} {ObstCount 0}");
        row("all seven walls, more than a radio counts", "GETOBS {From -30,0,-1} {To 30,0,-1}",
            "NUMOBS {From -30,0,-1} {To 30,0,-1} {ObstCount 7}");
        row("start and end", "GETOBS {Start -30,0,-1} {End 30,0,-1}",
            "NUMOBS {From -30,0,-1} {To 30,0,-1} {ObstCount 7}");
        row("the wire's z is down: below ground", "GETOBS {From -30,0,1} {To -29,0,1}",
            "NUMOBS {From -30,0,1} {To -29,0,1} {ObstCount 1}");
        row("by name, as the original wireless server asks", "GETOBS {From R1} {To R2}",
            "NUMOBS {From R1} {To R2} {ObstCount 7}");
        row("to one who is not there", "GETOBS {From R1} {To R9}", "NUMOBS {From R1} {To R9} {ObstCount -1}");
        row("to nowhere", "GETOBS {From 1,2} {To nan,0,0}", "NUMOBS {From 1,2} {To nan,0,0} {ObstCount -1}");
        row("positions", "GETPOS",
            "POSITIONS {Robots 2} {Name R1 Location -30.00,0.00,-0.70 BatteryEmpty False} "
            "{Name R2 Location 20.00,-5.00,-0.70 BatteryEmpty False}");
        row("what is unknown has no answer, and nothing breaks", "HELLO\r\nGETOBS {From 0,50,-1} {To 1,50,-1}",
            "NUMOBS {From 0,50,-1} {To 1,50,-1} {ObstCount 0}");
    }

    void everyRequestHasItsReply() {
        QFETCH(QByteArray, request);
        QFETCH(QByteArray, reply);
        RadioWorld world(7);
        world.place("R1", -30.0);
        world.place("R2", 20.0, 5.0);
        ComInterface server(*world.simulation, world.relay.field());
        Peer peer(*server.listen(0));
        QCOMPARE(peer.ask(request + "\r\n"), reply);
    }
};

USAR_TEST(tst_ComInterface)

} // namespace tst_com_interface

#include "tst_com_interface.moc"
