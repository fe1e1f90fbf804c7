#include <QTest>

#include "core/modules/response.h"
#include "core/protocol/reader.h"
#include "tests/suite/suite.h"

namespace tst_response {

using namespace usar;

class tst_Response : public QObject {
    Q_OBJECT
private slots:
    void queuesInOrderAndEmptiesWhenRead();
    void otherLinesAreNoResponses();
    void pastItsCapacityTheOldestGoesAndIsCounted();
};

void tst_Response::queuesInOrderAndEmptiesWhenRead() {
    protocol::Reader reader;
    modules::ResponseModule responses;
    responses.take(reader.read("RES {Time 1} {Type INS} {Name INS} {Status OK}"));
    responses.take(reader.read("RES {Time 2} {Type RFID} {Name R} {status Failed}"));
    const std::vector<protocol::Response> all = responses.takeAll();
    QCOMPARE(all.size(), std::size_t(2));
    QVERIFY(all[0].ok && all[0].name == "INS" && all[0].time == Seconds(1));
    QVERIFY(!all[1].ok && all[1].type == "RFID" && all[1].name == "R");
    QVERIFY(responses.takeAll().empty());
}

void tst_Response::otherLinesAreNoResponses() {
    protocol::Reader reader;
    modules::ResponseModule responses;
    responses.take(reader.read("RES {Type INS} {Name INS}"));
    responses.take(reader.read("STA {Time 1} {Battery 5}"));
    QVERIFY(responses.takeAll().empty());
}

void tst_Response::pastItsCapacityTheOldestGoesAndIsCounted() {
    modules::ResponseModule responses;
    protocol::InfoLine line;
    for (std::size_t i = 0; i < modules::ResponseModule::capacity + 3; ++i) {
        line.message =
            protocol::Response{.time = Seconds(static_cast<double>(i)), .type = "INS", .name = "INS", .ok = true};
        responses.take(line);
    }
    QCOMPARE(responses.overflowCount(), std::size_t(3));
    const std::vector<protocol::Response> all = responses.takeAll();
    QCOMPARE(all.size(), modules::ResponseModule::capacity);
    QCOMPARE(all.front().time->count(), 3.0);
}

USAR_TEST(tst_Response)

} // namespace tst_response

#include "tst_response.moc"
