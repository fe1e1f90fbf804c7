#include <QTest>

#include "core/mission/session/notices.h"
#include "tests/suite/suite.h"

namespace tst_notices {

using namespace usar;
using namespace usar::mission;

namespace {

/// What was said, in order: "topic: text", with "over " before the end of a complaint.
struct Heard {
    QStringList said;
    Notices notices{[this](const Notice& notice) {
        said << QString::fromStdString((notice.over ? "over " : "") + notice.topic + " | " + notice.text);
    }};
};

} // namespace

class tst_Notices : public QObject {
    Q_OBJECT
private slots:
    void topicsAreNamedAsEver_data() {
        QTest::addColumn<int>("topic");
        QTest::addColumn<QString>("which");
        QTest::addColumn<QString>("text");
        const auto row = [](Topic topic, const char* which, const char* text) {
            QTest::newRow(text) << int(topic) << QString(which) << QString(text);
        };
        row(Topic::Adjustment, "", "adjustment");
        row(Topic::Behavior, "it rains", "behavior: it rains");
        row(Topic::CellSize, "", "cell size");
        row(Topic::Control, "", "control");
        row(Topic::DamagedLine, "STA: no brace", "lines: STA: no brace");
        row(Topic::FarParts, "", "far parts");
        row(Topic::Fault, "", "fault");
        row(Topic::Link, "", "link");
        row(Topic::NoConnection, "", "no connection");
        row(Topic::NoRobot, "", "no robot");
        row(Topic::Overlong, "", "overlong");
        row(Topic::Placement, "", "placement");
        row(Topic::Queue, "", "queue");
        row(Topic::Recording, "", "recording");
        row(Topic::Replay, "", "replay");
        row(Topic::SecondRobot, "", "second robot");
        row(Topic::Sensor, "Sonar F1", "sensor: Sonar F1");
        row(Topic::Silence, "", "silence");
        row(Topic::Spawn, "", "spawn");
        row(Topic::StartPoses, "", "start poses");
    }

    void topicsAreNamedAsEver() {
        QFETCH(int, topic);
        QFETCH(QString, which);
        QFETCH(QString, text);
        QCOMPARE(QString::fromStdString(textOf(static_cast<Topic>(topic), which.toStdString())), text);
    }

    void spansAreNamedAsShortAsTheyAre() {
        QCOMPARE(spanText(Seconds{5.0}), std::string("5 s"));
        QCOMPARE(spanText(Seconds{0.2}), std::string("0.2 s"));
    }

    void aComplaintStandsUntilItIsOver() {
        Heard heard;
        heard.notices.trouble(Severity::Warning, Topic::Queue, "it waits");
        QVERIFY(heard.notices.stands(Topic::Queue));
        heard.notices.over(Topic::Queue, "it goes on");
        QVERIFY(!heard.notices.stands(Topic::Queue));
        QCOMPARE(heard.said, (QStringList{"queue | it waits", "over queue | it goes on"}));
    }

    void theEndOfNothingIsNotSaid() {
        Heard heard;
        heard.notices.say(Severity::Warning, Topic::Control, "not now");
        QVERIFY(!heard.notices.stands(Topic::Control));
        heard.notices.over(Topic::Control);
        heard.notices.over(Topic::Link, "it is back");
        QCOMPARE(heard.said, QStringList{"control | not now"});
    }

    void complaintsOfOneTopicAreToldApart() {
        Heard heard;
        heard.notices.trouble(Severity::Warning, Topic::Sensor, "INS is silent", "INS");
        heard.notices.trouble(Severity::Warning, Topic::Sensor, "F1 is silent", "Sonar F1");
        heard.notices.over(Topic::Sensor, "INS speaks", "INS");
        heard.notices.endAll();
        QCOMPARE(heard.said, (QStringList{"sensor: INS | INS is silent", "sensor: Sonar F1 | F1 is silent",
                                          "over sensor: INS | INS speaks", "over sensor: Sonar F1 | "}));
    }

    void aLostConnectionEndsWhatBelongsToIt() {
        Heard heard;
        for (const Topic topic : {Topic::Silence, Topic::NoConnection, Topic::Link, Topic::Queue, Topic::Spawn})
            heard.notices.trouble(Severity::Warning, topic, "bad");
        heard.said.clear();
        heard.notices.endThoseOfTheConnection();
        QCOMPARE(heard.said, (QStringList{"over queue | ", "over silence | "})); // in the order of their texts
    }

    void allButAMissingConnectionEnds() {
        Heard heard;
        for (const Topic topic : {Topic::NoConnection, Topic::Spawn, Topic::Link})
            heard.notices.trouble(Severity::Warning, topic, "bad");
        heard.said.clear();
        heard.notices.endAll();
        QCOMPARE(heard.said, (QStringList{"over link | ", "over spawn | "}));
        QVERIFY(heard.notices.stands(Topic::NoConnection));
    }

    void whatIsSaidWhileMutedIsNotHeardButStands() {
        Heard heard;
        heard.notices.trouble(Severity::Warning, Topic::Link, "lost");
        heard.notices.mute(true);
        heard.notices.trouble(Severity::Warning, Topic::Silence, "silent");
        heard.notices.say(Severity::Warning, Topic::Fault, "wind");
        heard.notices.over(Topic::Link, "back");
        heard.notices.mute(false);
        QVERIFY(heard.notices.stands(Topic::Silence) && !heard.notices.stands(Topic::Link));
        QCOMPARE(heard.said, QStringList{"link | lost"});
    }

    void whatIsForgottenEndsWithoutAWord() {
        Heard heard;
        heard.notices.trouble(Severity::Warning, Topic::Replay, "a replay");
        heard.notices.forget(Topic::Replay);
        QVERIFY(!heard.notices.stands(Topic::Replay));
        QCOMPARE(heard.said.size(), 1);
    }
};

USAR_TEST(tst_Notices)

} // namespace tst_notices

#include "tst_notices.moc"
