// Tests that are made of moments of flights: missions with claims, and folders of them.
#include <QDir>
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
        const auto moment = readFlightMoment(folder_->path("flight.usarrec"), Seconds{40.0});
        QVERIFY2(moment, moment ? "" : moment.error().text().c_str());
        QCOMPARE(moment->flown.mission.faults, std::vector<std::string>{"wind speed=1 from=10"});
        QVERIFY(moment->flown.seed == std::uint64_t(7));
        const auto offers = claimsToOffer(*moment, moment->at, moment->at + Seconds{5.0});
        std::set<ClaimKind> kinds;
        int held = 0;
        for (const ClaimOffer& offer : offers) {
            if (!kinds.insert(offer.claim.kind).second)
                continue; // One of a kind is enough.
            held += offer.held == true ? 1 : 0;
            keep(testOf(*moment, offer.claim, wordsOf(offer.claim)), kinds.size());
        }
        QCOMPARE(kinds.size(), std::size_t(6)); // No contact is among them, which the recording does not tell.
        QCOMPARE(held, 5);
        const auto ended = folder_->run({"campaign", "--tests", "tests", "--junit", "tests.xml"});
        QVERIFY2(ended.exit_code == 0, ended.err);
        QCOMPARE(ended.summary["outcomes"].toObject()["done"].toInt(), 6);
        QCOMPARE(failuresIn("tests.xml"), QStringList());
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
        const auto early = readFlightMoment(folder_->path("flight.usarrec"), Seconds{-100.0});
        QVERIFY(!early);
        QVERIFY2(early.error().text().find("flight.usarrec") != std::string::npos, early.error().text().c_str());
        QVERIFY(!readFlightMoment(folder_->path("none.usarrec"), Seconds{1.0}));
    }

private:
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
