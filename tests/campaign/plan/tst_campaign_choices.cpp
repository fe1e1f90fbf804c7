#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include "core/campaign/plan/campaign_choices.h"
#include "core/campaign/plan/campaign_writer.h"
#include "tests/suite/suite.h"

namespace tst_campaign_choices {

using namespace usar;
using namespace usar::campaign;

/// Campaigns from a few fields, and the files that are made of them.
class tst_CampaignChoices : public QObject {
    Q_OBJECT
private slots:
    void eachBehaviorIsAVariant() {
        CampaignChoices choices{.name = "Town", .mission_file = "/c/mission.json", .first_seed = 5, .seeds = 3};
        choices.behaviors = {{"a/cpp", "C++", {}, {}}, {"a/posh", "POSH", "/p.lap", {"parameters.y=1"}}};
        const Campaign campaign = campaignOf(choices);
        QCOMPARE(campaign.missions, (std::vector<CampaignMission>{{"/c/mission.json", 5, 3, {}, {}}}));
        QCOMPARE(campaign.variants,
                 (std::vector<Variant>{{"C++", "a/cpp", {}, {}}, {"POSH", "a/posh", "/p.lap", {"parameters.y=1"}}}));
    }

    void eachValueIsAVariantOfEachBehavior() {
        CampaignChoices choices{.name = "Town", .mission_file = "/m.json"};
        choices.behaviors = {{"a/cpp", "C++", {}, {"parameters.h_m=9", "parameters.y=1"}}, {"a/posh", "POSH", {}, {}}};
        choices.parameter = "parameters.h_m";
        choices.parameter_title = "Height";
        choices.values = {3.0, 4.5};
        const Campaign campaign = campaignOf(choices);
        std::vector<std::string> names;
        for (const Variant& variant : campaign.variants)
            names.push_back(variant.name);
        QCOMPARE(names,
                 (std::vector<std::string>{"C++, Height 3", "C++, Height 4.5", "POSH, Height 3", "POSH, Height 4.5"}));
        QCOMPARE(campaign.variants[1].values, (std::vector<std::string>{"parameters.y=1", "parameters.h_m=4.5"}));
    }

    void equalTitlesGetTheirIds() {
        CampaignChoices choices{.name = "x", .mission_file = "/m.json"};
        choices.behaviors = {{"a/one", "C++", {}, {}}, {"a/two", "C++", {}, {}}};
        const Campaign campaign = campaignOf(choices);
        QCOMPARE(campaign.variants[0].name, std::string("C++ (a/one)"));
        QCOMPARE(campaign.variants[1].name, std::string("C++ (a/two)"));
    }

    void valuesAreRead_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QList<double>>("values");
        QTest::addColumn<QString>("complaint");
        QTest::newRow("none") << " " << QList<double>{} << "";
        QTest::newRow("with commas") << "3, 4.5,6" << QList<double>{3, 4.5, 6} << "";
        QTest::newRow("with other gaps") << "3;4  -5e-1" << QList<double>{3, 4, -0.5} << "";
        QTest::newRow("with the unit") << "3 m, 4.5m, 6" << QList<double>{3, 4.5, 6} << "";
        QTest::newRow("as the program writes it") << QString("6") + QChar(0x00a0) + "m" << QList<double>{6} << "";
        QTest::newRow("with another unit") << "3 ft" << QList<double>{} << "ft: this is no number";
        QTest::newRow("the unit alone") << "m" << QList<double>{} << "m: this is no number";
        QTest::newRow("words for a value") << "By resolution, 3" << QList<double>{0, 3} << "";
        QTest::newRow("a word") << "3, four" << QList<double>{} << "four: this is no number";
        QTest::newRow("not finite") << "inf" << QList<double>{} << "inf: this is no number";
        QTest::newRow("twice") << "3, 4, 3.0" << QList<double>{} << "3.0: this value is there twice";
    }

    void valuesAreRead() {
        QFETCH(QString, text);
        QFETCH(QList<double>, values);
        QFETCH(QString, complaint);
        const auto read = readValues(text, {"m", "by resolution", 0.0});
        QCOMPARE(read.has_value(), complaint.isEmpty());
        if (read)
            QCOMPARE(QList<double>(read->begin(), read->end()), values);
        else
            QVERIFY2(read.error().text().starts_with(complaint.toStdString()), read.error().text().c_str());
    }

    void whatIsWrittenIsReadBack() {
        Campaign campaign{"All \"of\" it",
                          {{"/c/a.json", 1, 20, {}, {}},
                           {"/b.json", 7, 3, {"town"}, {{"area.x", -5.5, 5.0, {}}, {"start", 0.0, 0.0, {"A", "B"}}}}},
                          {{"one", "a/cpp", {}, {}},
                           {"two",
                            {},
                            "/c/p.lap",
                            {"parameters.on=true", "parameters.v=3, 4", "parameters.w=so", "parameters.x=2.5"}}},
                          {"wind speed=3"},
                          Swarm{0.2, 10.0, 20.0, {"wind"}},
                          "/c/again.jsonl",
                          {},
                          2.5,
                          60.0,
                          Keep::Everything};
        for (const Keep keep : {Keep::Nothing, Keep::Failures, Keep::Everything}) {
            campaign.keep = keep;
            const QByteArray text = writeCampaign(campaign, "/c");
            const auto read = readCampaign(text, "/c/campaign.json");
            QVERIFY2(read, read ? "" : read.error().text().c_str());
            QVERIFY(*read == campaign);
            QVERIFY2(text.contains("\"a.json\"") && text.contains("\"p.lap\"") && text.contains("\"/b.json\""), text);
        }
    }

    void aDeviceIsWrittenToAndNotReplaced() {
        const QTemporaryDir folder;
        const QString pipe = folder.filePath("pipe");
        QCOMPARE(::mkfifo(qPrintable(pipe), 0600), 0);
        const int reader = ::open(qPrintable(pipe), O_RDONLY | O_NONBLOCK);
        QVERIFY(reader >= 0 && writeWhole(pipe, "text"));
        char read[8] = {};
        QCOMPARE(::read(reader, read, sizeof read), ssize_t(4));
        ::close(reader);
        QVERIFY(!QFileInfo(pipe).isFile());
    }

    void aFileIsWrittenWithItsFolderOrNamesWhatIsWrong() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("new/campaign.json");
        QVERIFY(writeWhole(path, "text"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), QByteArray("text"));
        const auto refused = writeWhole(path + "/below/a.json", "text"); // Its folder would be below a file.
        QVERIFY(!refused);
        QCOMPARE(refused.error().where, (path + "/below").toStdString());
        QCOMPARE(refused.error().mend, std::string("Choose another folder"));
    }
};

USAR_TEST(tst_CampaignChoices)

} // namespace tst_campaign_choices

#include "tst_campaign_choices.moc"
