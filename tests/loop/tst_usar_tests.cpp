// Tests that are made of moments of flights: missions with claims, and folders of them.
#include <algorithm>
#include <atomic>
#include <set>

#include <QDir>
#include <QJsonArray>
#include <QTest>
#include <QXmlStreamReader>

#include "core/mission/runs/flight_moment.h"
#include "tests/loop/program_folder.h"
#include "tests/suite/suite.h"

namespace tst_usar_tests {

using namespace usar;
using namespace usar::mission;
using test::ProgramFolder;

class tst_UsarTests : public QObject {
    Q_OBJECT
private slots:
    void init() {
        folder_ = std::make_unique<ProgramFolder>();
        QVERIFY(QDir(folder_->path()).mkdir("tests"));
    }

    /// Every claim that held in a flight holds in the test that is made of it: the same mission, seed and fault.
    void whatHeldInAFlightHoldsInItsTests() {
        folder_->write("small.json", test::small_mission);
        QCOMPARE(folder_
                     ->run({"run", "small.json", "--behavior", "airrobot/posh", "--seed", "7", "--fault",
                            "wind speed=1 from=10", "--record", "flight.usarrec"})
                     .exit_code,
                 0);
        const auto moment = momentOf("flight.usarrec", 40.0);
        QVERIFY2(moment, moment ? "" : moment.error().text().c_str());
        QCOMPARE(moment->flown.mission.faults, std::vector<std::string>{"wind speed=1 from=10"});
        QVERIFY(moment->flown.seed == std::uint64_t(7));
        const auto offers = claimsToOffer(*moment, moment->at, moment->at + Seconds{5.0});
        std::set<ClaimKind> kinds;
        int held = 0;
        for (const Claim& claim : offers) {
            const auto known = heldIn(*moment, claim);
            if (known == false || !kinds.insert(claim.kind).second)
                continue; // One of a kind is enough.
            held += known ? 1 : 0;
            keep(testOf(*moment, claim, wordsOf(claim)), kinds.size());
        }
        QCOMPARE(kinds.size(), std::size_t(6)); // No contact is among them, which the recording does not tell.
        QCOMPARE(held, 5);
        const auto ended = folder_->run({"campaign", "--tests", "tests", "--junit", "tests.xml"});
        QVERIFY2(ended.exit_code == 0, ended.err);
        QCOMPARE(ended.summary["outcomes"].toObject()["done"].toInt(), 6);
        QCOMPARE(failuresIn("tests.xml"), QStringList());
    }

    /// What did not hold, though it should, can be claimed as well: that is how a defect becomes a test.
    void whatDidNotHoldFailsInItsTest() {
        folder_->write("small.json", test::small_mission);
        const QStringList flight{"run", "small.json", "--behavior", "airrobot/posh", "--record", "flight.usarrec"};
        QCOMPARE(folder_->run(flight).exit_code, 0);
        const auto moment = momentOf("flight.usarrec", 40.0);
        QVERIFY(moment);
        const auto offers = claimsToOffer(*moment, moment->at, moment->at + Seconds{5.0});
        const auto broken = std::ranges::find_if(offers, [&](const Claim& claim) {
            return claim.kind == ClaimKind::ElementRests && heldIn(*moment, claim) == false;
        });
        QVERIFY(broken != offers.end());
        keep(testOf(*moment, *broken, "rests"), 1);
        const auto ended = folder_->run({"campaign", "--tests", "tests", "--junit", "tests.xml"});
        QCOMPARE(ended.exit_code, 1);
        QCOMPARE(failuresIn("tests.xml").size(), 1);
    }

    void aMissionThatNeverFliesHoldsNothing() {
        folder_->write("tests/one.json", with(R"({"claim": "no contact", "from_s": 1, "to_s": 2})"));
        const auto ended = folder_->run({"run", "tests/one.json", "--connect", "127.0.0.1:1"});
        QVERIFY(ended.exit_code != 0);
        QVERIFY(!ended.summary["success"].toBool());
        QVERIFY(!ended.summary["claims"].toArray().at(0).toObject()["holds"].toBool());
    }

    void aBrokenClaimIsAFailure() {
        folder_->write("tests/high.json",
                       with(R"({"claim": "altitude above", "height_m": 50, "from_s": 20, "to_s": 30})"));
        folder_->write("tests/low.json",
                       with(R"({"claim": "altitude below", "height_m": 50, "from_s": 20, "to_s": 30})"));
        const auto ended = folder_->run({"campaign", "--tests", "tests", "--junit", "tests.xml", "--out", "results"});
        QCOMPARE(ended.exit_code, 1);
        const QStringList failures = failuresIn("tests.xml");
        QCOMPARE(failures.size(), 1);
        QVERIFY2(failures.front().startsWith("high: The claim is broken: altitude above 50.00 m"),
                 qPrintable(failures.front()));
        QVERIFY(QFile::exists(folder_->path("results/manifest.jsonl")));
        const auto alone = folder_->run({"run", "tests/low.json", "--out", "one"});
        QCOMPARE(alone.exit_code, 0);
        QVERIFY(alone.summary["success"].toBool());
        QVERIFY2(alone.summary["duration_s"].toDouble() < 31.0, "The mission must end with its claims.");
        QVERIFY(alone.summary["claims"].toArray().at(0).toObject()["holds"].toBool());
    }

    void aFileThatIsNoTestIsSaidBeforeAnythingIsFlown_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("words");
        QTest::newRow("no claim") << test::small_mission << "claims nothing";
        QTest::newRow("no mission") << QByteArray("{}") << "name";
        QTest::newRow("none") << QByteArray() << "there is no test in the folder";
        QTest::newRow("a campaign") << QByteArray("{\"name\": \"C\", \"missions\": []}") << "this is no test";
    }

    void aFileThatIsNoTestIsSaidBeforeAnythingIsFlown() {
        QFETCH(QByteArray, text);
        QFETCH(QString, words);
        if (!text.isEmpty())
            folder_->write("tests/one.json", text);
        const auto ended = folder_->run({"campaign", "--tests", "tests"});
        QCOMPARE(ended.exit_code, 2);
        QVERIFY2(ended.err.contains(words.toUtf8()), ended.err);
    }

    void aMomentWithoutAMissionIsRefused() {
        folder_->write("small.json", test::small_mission);
        QCOMPARE(folder_->run({"run", "small.json", "--record", "flight.usarrec"}).exit_code, 0);
        const auto early = momentOf("flight.usarrec", -100.0);
        QVERIFY(!early);
        QVERIFY2(early.error().text().find("flight.usarrec") != std::string::npos, early.error().text().c_str());
        QVERIFY(!momentOf("none.usarrec", 1.0));
    }

private:
    Result<FlightMoment> momentOf(const QString& recording, double now_s) const {
        return readFlightMoment(folder_->path(recording), Seconds{now_s}, std::atomic_bool(false));
    }

    static QByteArray with(const QByteArray& claim) {
        QByteArray text = test::small_mission;
        return text.insert(text.lastIndexOf('}'), ", \"seed\": 3, \"claims\": [" + claim + "] ");
    }

    void keep(const Mission& mission, std::size_t number) const {
        folder_->write(QString("tests/%1.json").arg(number), writeMission(mission, {}));
    }

    /// "CLASS: MESSAGE" of each failure.
    QStringList failuresIn(const QString& name) const {
        QFile file(folder_->path(name));
        if (!file.open(QIODevice::ReadOnly))
            return {"no file"};
        QXmlStreamReader xml(&file);
        QString test;
        QStringList failures;
        while (!xml.atEnd()) {
            xml.readNext();
            if (xml.isStartElement() && xml.name() == QLatin1String("testcase"))
                test = xml.attributes().value("classname").toString();
            else if (xml.isStartElement() &&
                     (xml.name() == QLatin1String("failure") || xml.name() == QLatin1String("error")))
                failures << test + ": " + xml.attributes().value("message").toString();
        }
        return xml.hasError() ? QStringList(xml.errorString()) : failures;
    }

    std::unique_ptr<ProgramFolder> folder_;
};

USAR_TEST(tst_UsarTests)

} // namespace tst_usar_tests

#include "tst_usar_tests.moc"
