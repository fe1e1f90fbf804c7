#include <QDir>
#include <QTest>

#include "core/campaign/plan/campaign.h"
#include "core/campaign/plan/campaign_writer.h"
#include "tests/suite/suite.h"

namespace tst_campaign {

using namespace usar;
using namespace usar::campaign;

namespace {

QByteArray withMissions(const QByteArray& rest) {
    return "{ \"name\": \"A\", \"missions\": [\"m.json\"]" + rest + " }";
}

} // namespace

class tst_Campaign : public QObject {
    Q_OBJECT
private slots:
    void theShortestHasOneRun() {
        const auto campaign = readCampaign(withMissions(""), "/home/me/c.json");
        QVERIFY2(campaign, campaign ? "" : campaign.error().text().c_str());
        QCOMPARE(campaign->missions.size(), std::size_t(1));
        QCOMPARE(campaign->missions[0].file, QString("/home/me/m.json"));
        QCOMPARE(campaign->missions[0].seeds, 1);
        QCOMPARE(campaign->variants.size(), std::size_t(1));
        QVERIFY(campaign->keep == Keep::Failures);
    }

    void everyKeyIsRead() {
        const auto campaign = readCampaign(R"({
            "name": "All of it",
            "missions": ["a.json", { "file": "/b.json", "seeds": { "first": 7, "count": 3 }, "worlds": ["town"],
                          "draw": { "area.x": [-5, 5], "start": ["Hill", "Dale"] } }],
            "variants": [{ "name": "one", "behavior": "airrobot/cpp" },
                         { "name": "two", "plan": "p.lap", "set": { "parameters.x_m": 2.5, "parameters.word": "so" } }],
            "seeds": 20, "faults": ["wind speed=3"],
            "swarm": { "share": 0.2, "from_s": [10, 20], "kinds": ["wind"] },
            "limit_h": 2, "wall_limit_s": 60, "keep": "everything" })",
                                           "/c/c.json");
        QVERIFY2(campaign, campaign ? "" : campaign.error().text().c_str());
        const Campaign expected{
            "All of it",
            {{"/c/a.json", 1, 20, {}, {}},
             {"/b.json", 7, 3, {"town"}, {{"area.x", -5.0, 5.0, {}}, {"start", 0.0, 0.0, {"Hill", "Dale"}}}}},
            {{"one", "airrobot/cpp", {}, {}}, {"two", {}, "/c/p.lap", {"parameters.word=so", "parameters.x_m=2.5"}}},
            {"wind speed=3"},
            Swarm{0.2, 10.0, 20.0, {"wind"}},
            {},
            {},
            2.0,
            60.0,
            Keep::Everything};
        QVERIFY(*campaign == expected);
    }

    void missionsCanBeToldApartByTheirNames_data() {
        QTest::addColumn<QByteArray>("missions");
        QTest::addColumn<QString>("names");
        const auto row = [](const char* title, const char* missions, const char* names) {
            QTest::newRow(title) << QByteArray(missions) << names;
        };
        row("other files", R"("a.json", "x/b.json")", "a; b");
        row("given", R"({"file": "a.json", "name": "Hill"}, {"file": "a.json", "name": "Dale"})", "Hill; Dale");
        row("other areas",
            R"({"file": "a.json", "draw": {"area.x": [-40, 10]}}, {"file": "a.json", "draw": {"area.x": [0, 2.5]}})",
            "a (area.x -40 to 10); a (area.x 0 to 2.5)");
        row("other worlds and starts",
            R"({"file": "a.json", "worlds": ["town", "/w/wood"]},
               {"file": "a.json", "worlds": ["town:seed"], "draw": {"start": ["Hill", "Dale"]}})",
            "a (in town|wood); a (in town:seed, start Hill|Dale)");
        row("other seeds", R"({"file": "a.json", "seeds": {"first": 7, "count": 3}}, "a.json")",
            "a (from seed 7); a (from seed 1)");
        row("other folders", R"("x/a.json", "y/a.json")", "a (of x); a (of y)");
        row("the same twice", R"("a.json", "a.json", "b.json")", "a 1; a 2; b");
        row("one has more", R"("a.json", {"file": "a.json", "worlds": ["town"]})", "a 1; a (in town)");
        row("one is given the other's", R"("a.json", {"file": "b.json", "name": "a"})", "a 1; a");
        row("a number is taken", R"("a.json", "a.json", {"file": "b.json", "name": "a 1"})", "a 2; a 3; a 1");
        row("too much to say",
            R"({"file": "a.json", "draw": {"area.x": [-40, 10], "area.y": [1, 2], "area.width": [1, 2], "start": ["Hill"]}},
               {"file": "a.json", "draw": {"area.x": [-4, 10]}})",
            "a 1; a (area.x -4 to 10)");
    }

    void missionsCanBeToldApartByTheirNames() {
        QFETCH(QByteArray, missions);
        const auto campaign = readCampaign(R"({"name": "A", "missions": [)" + missions + "]}", "/c/c.json");
        QVERIFY2(campaign, campaign ? "" : campaign.error().text().c_str());
        QStringList names;
        for (const CampaignMission& mission : campaign->missions)
            names << nameOf(mission);
        QTEST(names.join("; "), "names");
        const auto again = readCampaign(writeCampaign(*campaign, "/c"), "/c/c.json");
        QVERIFY(again && again->missions == campaign->missions);
    }

    void rejectsTheRestAndSaysWhere_data() {
        QTest::addColumn<QByteArray>("json");
        QTest::addColumn<QString>("place");
        QTest::addColumn<QString>("words");
        QTest::newRow("no JSON") << QByteArray("{,") << "c.json:1:3"
                                 << "not JSON";
        QTest::newRow("a list") << QByteArray("[]") << "c.json:1:1"
                                << "a campaign is an object";
        QTest::newRow("no missions") << QByteArray("{\"name\": \"A\"}") << "c.json:1:1"
                                     << "\"missions\" is missing";
        QTest::newRow("empty missions") << QByteArray("{\"name\": \"A\",\n \"missions\": []}") << "c.json:2:14"
                                        << "not a list of missions";
        QTest::newRow("a number as mission") << QByteArray("{\"name\": \"A\",\n \"missions\": [4]}") << "c.json:2:14"
                                             << "no file";
        QTest::newRow("a key that is misspelled") << withMissions(", \"varants\": []") << "c.json:1:40"
                                                  << "Did you mean \"variants\"";
        QTest::newRow("a key of a mission")
            << QByteArray("{\"name\": \"A\", \"missions\": [{\"fle\": \"a\"}]}") << "c.json:1:29"
            << "\"file\"";
        QTest::newRow("no seeds") << withMissions(", \"seeds\": 0") << "c.json:1:49"
                                  << "out of range";
        QTest::newRow("half a seed") << withMissions(", \"seeds\": 1.5") << "c.json:1:49"
                                     << "whole number";
        QTest::newRow("a name twice") << withMissions(R"(, "variants": [{"name": "a"}, {"name": "a"}])") << "c.json:1"
                                      << "the same name";
        QTest::newRow("a mission's name twice")
            << QByteArray(R"({"name": "A", "missions": [{"file": "a", "name": "M"}, {"file": "b", "name": "M"}]})")
            << "c.json:1"
            << "two missions have the same name";
        QTest::newRow("an upside-down range")
            << QByteArray(R"({"name": "A", "missions": [{"file": "a", "draw": {"area.x": [5, -5]}}]})") << "c.json:1"
            << "neither a range";
        QTest::newRow("a certain swarm") << withMissions(", \"swarm\": {\"share\": 2}") << "c.json:1:59"
                                         << "probability";
        QTest::newRow("no limit") << withMissions(", \"limit_h\": 0") << "c.json:1:51"
                                  << "above 0";
        QTest::newRow("what to keep") << withMissions(", \"keep\": \"some\"") << "c.json:1:48"
                                      << "\"failures\"";
    }

    void rejectsTheRestAndSaysWhere() {
        QFETCH(QByteArray, json);
        QFETCH(QString, place);
        QFETCH(QString, words);
        const auto campaign = readCampaign(json, "c.json");
        QVERIFY(!campaign);
        const QString said = QString::fromStdString(campaign.error().text());
        QVERIFY2(said.startsWith(place) && said.contains(words), qPrintable(said));
    }

    void theShippedCampaignsAreSound() {
        const QDir folder(USAR_SOURCE_DIR "/resources/campaigns");
        const QStringList files = folder.entryList({"*.json"});
        QVERIFY(!files.isEmpty());
        for (const QString& file : files) {
            const auto campaign = readCampaignFile(folder.filePath(file));
            QVERIFY2(campaign, campaign ? "" : campaign.error().text().c_str());
            for (const CampaignMission& mission : campaign->missions)
                QVERIFY2(QFile::exists(mission.file), qPrintable(mission.file));
        }
    }
};

USAR_TEST(tst_Campaign)

} // namespace tst_campaign

#include "tst_campaign.moc"
