// Where notifications lead.
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/models/notice_place.h"

namespace tst_notice_place {

using namespace usar;
using namespace usar::widgets;

class tst_NoticePlace : public QObject {
    Q_OBJECT
private slots:
    void eachKeyLeadsSomewhere_data();
    void eachKeyLeadsSomewhere();
};

void tst_NoticePlace::eachKeyLeadsSomewhere_data() {
    QTest::addColumn<QString>("key");
    QTest::addColumn<NoticePlace>("place");
    const auto row = [](const char* key, const NoticePlace& place) { QTest::newRow(key) << QString(key) << place; };
    row("R2/sensor: GPS", {"R2", {}, "sensors", {}});
    row("R1/silence", {"R1", {}, "robots", {}});
    row("R1/lines: SEN", {"R1", {}, "messages", {}});
    row("Link/no connection", {"Link", {}, "messages", {}});
    row("my radio/queue", {"my radio", {}, "messages", {}});
    row("mission-3", {{}, {3}, "behavior", {}});
    row("start-12", {{}, {12}, "behavior", {}});
    row("mission-ready", {{}, {}, "behavior", {}});
    row("mission-faults", {{}, {}, "faults", {}});
    row("saved/R4", {"R4", {}, "robots", {}});
    row("world/placing", {{}, {}, "world", {}});
    row("plot", {{}, {}, "plots", {}});
    row("plugin/libx.so", {{}, {}, {}, "plugins.show"});
    row("/some/folder/libx.so", {{}, {}, {}, "plugins.show"});
    row("closing", {});
}

void tst_NoticePlace::eachKeyLeadsSomewhere() {
    QFETCH(QString, key);
    QFETCH(NoticePlace, place);
    const NoticePlace found = placeOf(key);
    QCOMPARE(found.robot_name, place.robot_name);
    QCOMPARE(found.robot_id, place.robot_id);
    QCOMPARE(found.dock, place.dock);
    QCOMPARE(found.command, place.command);
}

USAR_TEST(tst_NoticePlace)

} // namespace tst_notice_place

#include "tst_notice_place.moc"
