// Claims as a mission file has them.
#include <QTest>

#include "core/mission/files/mission_file.h"
#include "tests/suite/suite.h"

namespace tst_claims {

using namespace usar;
using namespace usar::mission;

class tst_Claims : public QObject {
    Q_OBJECT
private slots:
    void everyKindComesBackAsItWasWritten_data() {
        QTest::addColumn<Claim>("claim");
        QTest::addColumn<QString>("words");
        const Claim about{.from = Seconds{1.5}, .to = Seconds{12.0}};
        const auto row = [&](const char* name, ClaimKind kind, double height_m, const char* text, const char* words) {
            QTest::newRow(name) << Claim{kind, about.from, about.to, height_m, text} << QString(words);
        };
        row("contact", ClaimKind::NoContact, 0.0, "", "no contact from 1.5 s to 12.0 s");
        row("above", ClaimKind::AltitudeAbove, 2.5, "", "altitude above 2.50 m from 1.5 s to 12.0 s");
        row("below", ClaimKind::AltitudeBelow, -3.0, "", "altitude below -3.00 m from 1.5 s to 12.0 s");
        row("state", ClaimKind::State, 0.0, "lane 2", "state \"lane 2\" from 1.5 s to 12.0 s");
        row("runs", ClaimKind::ElementRuns, 0.0, "evade", "plan element evade runs from 1.5 s to 12.0 s");
        row("rests", ClaimKind::ElementRests, 0.0, "evade", "plan element evade does not run from 1.5 s to 12.0 s");
    }

    void everyKindComesBackAsItWasWritten() {
        QFETCH(Claim, claim);
        QFETCH(QString, words);
        Mission mission;
        mission.name = "Test";
        mission.claims = {claim, {.to = Seconds{1.0}}};
        mission.seed = 18446744073709551615ULL;
        const auto read = readMission(writeMission(mission, {}), "test.json");
        QVERIFY2(read, read ? "" : read.error().text().c_str());
        QVERIFY(read->claims == mission.claims);
        QVERIFY(read->seed == mission.seed);
        QCOMPARE(QString::fromStdString(sentenceOf(claim)), words);
    }

    void aSmallSeedIsANumber() {
        Mission mission;
        mission.name = "Test";
        mission.seed = 7;
        const QByteArray text = writeMission(mission, {});
        QVERIFY2(text.contains("\"seed\": 7"), text);
        QVERIFY(readMission(text, "test.json")->seed == std::uint64_t(7));
    }

    void aWrongOneNamesItsPlace_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("place");
        QTest::addColumn<QString>("word");
        const auto row = [](const char* name, const char* text, const char* place, const char* word) {
            QTest::newRow(name) << QByteArray(text) << QString(place) << QString(word);
        };
        row("no list", "{\"name\":\"T\",\"claims\":{}}", "t.json:1:22", "list of objects");
        row("no object", "{\"name\":\"T\",\"claims\":[3]}", "t.json:1:22", "list of objects");
        row("unknown claim", "{\"name\":\"T\",\"claims\":[{\"claim\":\"flies\",\"from_s\":0,\"to_s\":1}]}",
            "t.json:1:32", "flies");
        row("unknown key", "{\"name\":\"T\",\"claims\":[{\"claim\":\"no contact\",\"form_s\":0,\"to_s\":1}]}",
            "t.json:1:45", "from_s");
        row("no time", "{\"name\":\"T\",\"claims\":[{\"claim\":\"no contact\",\"to_s\":1}]}", "t.json:1:22", "from_s");
        row("backward", "{\"name\":\"T\",\"claims\":[{\"claim\":\"no contact\",\"from_s\":5,\"to_s\":1}]}",
            "t.json:1:63", "span");
        row("before the robot", "{\"name\":\"T\",\"claims\":[{\"claim\":\"no contact\",\"from_s\":-5,\"to_s\":1}]}",
            "t.json:1:64", "span");
        row("no height", "{\"name\":\"T\",\"claims\":[{\"claim\":\"altitude above\",\"from_s\":0,\"to_s\":1}]}",
            "t.json:1:22", "height_m");
        row("no element", "{\"name\":\"T\",\"claims\":[{\"claim\":\"element runs\",\"from_s\":0,\"to_s\":1}]}",
            "t.json:1:22", "element");
        row("seed", "{\"name\":\"T\",\"seed\":1.5}", "t.json:1:20", "seed");
        row("negative seed", "{\"name\":\"T\",\"seed\":-1}", "t.json:1:20", "seed");
        row("seed in words", "{\"name\":\"T\",\"seed\":\"seven\"}", "t.json:1:20", "seed");
    }

    void aWrongOneNamesItsPlace() {
        QFETCH(QByteArray, text);
        QFETCH(QString, place);
        QFETCH(QString, word);
        const auto read = readMission(text, "t.json");
        QVERIFY(!read);
        const QString error = QString::fromStdString(read.error().text());
        QVERIFY2(error.contains(place) && error.contains(word), qPrintable(error));
    }
};

USAR_TEST(tst_Claims)

} // namespace tst_claims

#include "tst_claims.moc"
