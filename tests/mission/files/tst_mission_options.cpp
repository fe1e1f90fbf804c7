#include <QDir>
#include <QTest>

#include "core/base/time_range.h"
#include "core/mission/files/mission_options.h"
#include "core/mission/reports/progress_bar.h"
#include "tests/suite/suite.h"

namespace tst_mission_options {

using namespace usar;
using namespace usar::mission;

class tst_MissionOptions : public QObject {
    Q_OBJECT
private slots:
    void readsTheCommandLine_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<MissionOptions>("expected");
        MissionOptions plain;
        plain.mission_file = "a.json";
        QTest::newRow("a file is enough") << QStringList{"run", "a.json"} << plain;
        QTest::newRow("full speed is the default") << QStringList{"run", "a.json", "--speed", "max"} << plain;
        MissionOptions full = plain;
        full.behavior = "airrobot/posh";
        full.plan = "own.lap";
        full.seed = 7;
        full.seed_chosen = true;
        full.speed_x = 2.5;
        full.server = ServerAddress{"10.0.0.5", 3001};
        full.result_folder = "/data/scans";
        full.recording = "r.usarrec";
        full.formats = *readFormatList("tif,asc", "--export");
        full.faults = QStringList{"wind speed=4", "link_delay by=0.2"};
        QTest::newRow("all options") << QStringList{"run",       "a.json",        "--behavior", "airrobot/posh",
                                                    "--plan",    "own.lap",       "--seed",     "7",
                                                    "--speed",   "2.5",           "--out",      "/data/scans",
                                                    "--connect", "10.0.0.5:3001", "--record",   "r.usarrec",
                                                    "--fault",   "wind speed=4",  "--fault",    "link_delay by=0.2",
                                                    "--export",  "tif,asc"}
                                     << full;
        QTest::newRow("equals signs, options first") << QStringList{"--behavior=airrobot/posh",
                                                                    "--plan=own.lap",
                                                                    "--seed=7",
                                                                    "--speed=2.5",
                                                                    "--out=/data/scans",
                                                                    "--connect=10.0.0.5:3001",
                                                                    "--record=r.usarrec",
                                                                    "--export=tif,asc",
                                                                    "--fault=wind speed=4",
                                                                    "--fault=link_delay by=0.2",
                                                                    "run",
                                                                    "a.json"}
                                                     << full;
        MissionOptions apart = plain;
        apart.isolate = true;
        apart.plugin_folders = QStringList{"mine", "yours"};
        QTest::newRow("a process and plugins of one's own")
            << QStringList{"run", "--isolate", "a.json", "--plugins", "mine", "--plugins=yours"} << apart;
        MissionOptions of_campaign = plain;
        of_campaign.one_thread = true;
        of_campaign.course = true;
        of_campaign.files = ResultFiles::IfFailed;
        QTest::newRow("as a campaign flies")
            << QStringList{"run", "a.json", "--course", "--one-thread", "--files", "failed"} << of_campaign;
        MissionOptions without_files = plain;
        without_files.files = ResultFiles::Never;
        QTest::newRow("without files") << QStringList{"run", "a.json", "--files=never"} << without_files;
        for (const auto& [text, on] : {std::pair("on", true), {"off", false}}) {
            MissionOptions told = plain;
            told.adjust = on;
            QTest::addRow("the map adjusted: %s", text) << QStringList{"run", "a.json", "--adjust", text} << told;
        }
        MissionOptions rest;
        rest.continued = "r.usarrec";
        QTest::newRow("the rest of a mission") << QStringList{"run", "--continue", "r.usarrec"} << rest;
        MissionOptions short_lived = plain;
        short_lived.battery_life_s = 90.5;
        for (const auto& [text, limit_s] :
             {std::pair("20h", 72000.0), {"90min", 5400.0}, {"1.5s", 1.5}, {"30", 30.0}}) {
            MissionOptions limited = plain;
            limited.limit = Seconds{limit_s};
            QTest::addRow("a limit of %s", text) << QStringList{"run", "a.json", "--limit", text} << limited;
        }
        MissionOptions bounded = plain;
        bounded.recording = "r.usarrec";
        bounded.recording_limit_bytes = 12'500'000;
        QTest::newRow("a limit of the recording")
            << QStringList{"run", "a.json", "--record", "r.usarrec", "--record-limit", "12.5"} << bounded;
        QTest::newRow("the battery's life") << QStringList{"run", "a.json", "--battery", "90.5"} << short_lived;
        MissionOptions odd = plain;
        odd.behavior = "--speed";
        odd.result_folder = "-3";
        QTest::newRow("values that look like options")
            << QStringList{"run", "a.json", "--behavior", "--speed", "--out=-3"} << odd;
    }

    void readsTheCommandLine() {
        QFETCH(QStringList, arguments);
        QFETCH(MissionOptions, expected);
        const auto options = readMissionOptions(arguments);
        QVERIFY2(options, options ? "" : options.error().text().c_str());
        QVERIFY(*options == expected);
    }

    void rejectsTheRestAndSaysWhere_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("words");
        QTest::newRow("nothing") << QStringList{} << "usar-mission run MISSION.json";
        QTest::newRow("no file") << QStringList{"run"} << "usar-mission run MISSION.json";
        QTest::newRow("two files") << QStringList{"run", "a.json", "b.json"} << "usar-mission run MISSION.json";
        QTest::newRow("another verb") << QStringList{"fly", "a.json"} << "usar-mission run MISSION.json";
        QTest::newRow("unknown option") << QStringList{"run", "a.json", "--sped", "3"}
                                        << "--sped: there is no such option";
        QTest::newRow("value missing") << QStringList{"run", "a.json", "--seed"} << "--seed: the value is missing";
        QTest::newRow("an option for a value")
            << QStringList{"run", "a.json", "--out", "x", "--speed"} << "--speed: the value is missing";
        QTest::newRow("a value for a flag")
            << QStringList{"run", "a.json", "--isolate=no"} << "--isolate: this option takes no value";
        QTest::newRow("joined value empty") << QStringList{"run", "a.json", "--seed="} << "the seed is not";
        QTest::newRow("seed no number") << QStringList{"run", "a.json", "--seed", "x"} << "--seed x: the seed is not";
        QTest::newRow("seed negative") << QStringList{"run", "a.json", "--seed", "-1"} << "--seed -1: the seed is not";
        QTest::newRow("files now and then") << QStringList{"run", "a.json", "--files", "sometimes"}
                                            << "--files sometimes: files are left always, failed or never";
        QTest::newRow("files to export, but none")
            << QStringList{"--files", "never", "run", "a.json", "--export", "tif"}
            << "--export tif: no files are wanted, but some to export";
        QTest::newRow("adjust a little") << QStringList{"run", "a.json", "--adjust", "little"}
                                         << "--adjust little: whether to adjust the map is neither on nor off";
        QTest::newRow("speed zero") << QStringList{"run", "a.json", "--speed", "0"}
                                    << "--speed 0: the speed is neither";
        QTest::newRow("speed with a comma") << QStringList{"run", "a.json", "--speed", "1,5"} << "the speed is neither";
        QTest::newRow("port too large") << QStringList{"run", "a.json", "--connect", "h:70000"} << "from 1 to 65535";
        QTest::newRow("no host") << QStringList{"run", "a.json", "--connect", ":3000"} << "the host is missing";
        QTest::newRow("IPv6 without brackets")
            << QStringList{"run", "a.json", "--connect", "::1:3000"} << "an IPv6 address needs brackets";
        for (const char* text : {"0h", "-1h", "h", "soon", "5 days"})
            QTest::addRow("limit %s", text) << QStringList{"run", "a.json", "--limit", text}
                                            << QString("--limit %1: the limit is no time").arg(text);
        QTest::newRow("an unknown format")
            << QStringList{"run", "a.json", "--export", "tif,shp"} << "--export tif,shp: there is no format named shp";
        QTest::newRow("a limit without a recording")
            << QStringList{"run", "a.json", "--record-limit", "20"} << "a limit needs a recording";
        for (const char* limit : {"9.9", "-1", "20MB", "nan", "1e300"})
            QTest::addRow("a recording's limit of %s", limit)
                << QStringList{"run", "a.json", "--record", "r", "--record-limit", limit}
                << "is no number of megabytes from 10 up";
        QTest::newRow("battery") << QStringList{"run", "a.json", "--battery", "0"} << "--battery 0: the life of";
    }

    void rejectsTheRestAndSaysWhere() {
        QFETCH(QStringList, arguments);
        QFETCH(QString, words);
        const auto options = readMissionOptions(arguments);
        QVERIFY(!options);
        QVERIFY2(QString::fromStdString(options.error().text()).contains(words), options.error().text().c_str());
        QVERIFY(!options.error().mend.empty());
    }

    void readsServerAddresses_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("host");
        QTest::addColumn<int>("port");
        QTest::newRow("host and port") << "usarsim.local:3001"
                                       << "usarsim.local" << 3001;
        QTest::newRow("host alone") << "usarsim.local"
                                    << "usarsim.local" << 3000;
        QTest::newRow("IPv6 with port") << "[::1]:3001"
                                        << "::1" << 3001;
        QTest::newRow("IPv6 in brackets") << "[::1]"
                                          << "::1" << 3000;
    }

    void readsServerAddresses() {
        QFETCH(QString, text);
        QFETCH(QString, host);
        QFETCH(int, port);
        const auto address = readServerAddress(text);
        QVERIFY(address);
        QCOMPARE(address->host, host);
        QCOMPARE(int(address->port), port);
    }

    void valuesGoOverTheFile() {
        Mission mission;
        mission.name = "A";
        mission.area_in_map = {{0.0, 0.0}, {10.0, 20.0}};
        mission.places = {{"area.x", {}}, {"area.y", {}}};
        MissionOptions options;
        options.values = {"area.x=-5",       "area.height=8.5",          "world = town",       "limit_h=2",
                          "cell_size_m=0.5", "parameters.lanes=3",       "parameters.on=true", "parameters.high_m=2.5",
                          "start=a=b",       "parameters.word=two words"};
        const auto applied = applyTo(mission, options);
        QVERIFY2(applied, applied ? "" : applied.error().text().c_str());
        QVERIFY((mission.area_in_map == Rectangle{{-5.0, 0.0}, {5.0, 8.5}}));
        QCOMPARE(mission.world, std::string("town"));
        QCOMPARE(mission.start, std::string("a=b"));
        QCOMPARE(mission.limit_h, std::optional(2.0));
        QCOMPARE(mission.cell_size_m, 0.5);
        const std::map<std::string, agent::ParameterValue> expected{
            {"lanes", 3LL}, {"on", true}, {"high_m", 2.5}, {"word", std::string("two words")}};
        QVERIFY(mission.parameters == expected);
        QVERIFY(!mission.places.contains("area.x") && mission.places.contains("area.y"));
    }

    void valuesThatDoNotFitAreRefused_data() {
        QTest::addColumn<QString>("value");
        QTest::addColumn<QString>("words");
        QTest::newRow("no value") << "area.x"
                                  << "this is no KEY=VALUE";
        QTest::newRow("no key") << "=4"
                                << "this is no KEY=VALUE";
        QTest::newRow("an unknown key") << "area.with=4"
                                        << "did you mean \"area.width\"";
        QTest::newRow("an option of its own") << "behavior=x"
                                              << "unknown key \"behavior\"";
        QTest::newRow("no number") << "area.x=far"
                                   << "does not fit \"area.x\"";
        QTest::newRow("no size") << "area.width=0"
                                 << "does not fit";
        QTest::newRow("an endless area") << "area.width=inf"
                                         << "does not fit";
        QTest::newRow("a tiny cell") << "cell_size_m=0.001"
                                     << "does not fit";
        QTest::newRow("an empty text") << "world="
                                       << "does not fit";
    }

    void valuesThatDoNotFitAreRefused() {
        QFETCH(QString, value);
        QFETCH(QString, words);
        Mission mission;
        MissionOptions options;
        options.values = {value};
        const auto applied = applyTo(mission, options);
        QVERIFY(!applied);
        const QString said = QString::fromStdString(applied.error().text());
        QVERIFY2(said.contains(words, Qt::CaseInsensitive) && said.contains("--set " + value), qPrintable(said));
    }

    void theCommandLineGoesBeforeTheFile() {
        Mission mission;
        mission.behavior = "p2dx/cpp";
        mission.places = {{"behavior", {"m.json:1:2", "m.json:1:9"}}, {"plan", {}}, {"world", {}}};
        MissionOptions options;
        options.behavior = "airrobot/posh";
        options.plan = "own.lap";
        options.isolate = true;
        QVERIFY(applyTo(mission, options));
        QCOMPARE(mission.behavior, std::string("airrobot/posh"));
        QCOMPARE(QString::fromStdString(mission.plan), QDir::current().filePath("own.lap"));
        QVERIFY(mission.isolate);
        QCOMPARE(mission.places.size(), std::size_t(1)); // no error blames the file for what was typed
        QVERIFY(mission.places.contains("world"));
    }

    void whatIsNotTypedIsTheFiles() {
        Mission mission;
        mission.behavior = "p2dx/cpp";
        mission.plan = "/plans/a.lap";
        mission.isolate = true;
        mission.places = {{"behavior", {}}, {"plan", {}}};
        QVERIFY(applyTo(mission, {}));
        QCOMPARE(mission.behavior, std::string("p2dx/cpp"));
        QCOMPARE(mission.plan, std::string("/plans/a.lap"));
        QVERIFY(mission.isolate);
        QCOMPARE(mission.places.size(), std::size_t(2));
    }

    void theTypedLimitGoesBeforeTheFiles_data() {
        QTest::addColumn<std::optional<Seconds>>("typed");
        QTest::addColumn<std::optional<double>>("in_file_h");
        QTest::addColumn<double>("limit_s");
        const auto add = [](const char* row, std::optional<Seconds> typed, std::optional<double> in_file_h,
                            double limit_s) { QTest::newRow(row) << typed << in_file_h << limit_s; };
        add("neither", {}, {}, std::numeric_limits<double>::infinity());
        add("in the file", {}, 1.5, 5400.0);
        add("typed", Seconds{90.0}, {}, 90.0);
        add("both", Seconds{90.0}, 1.5, 90.0);
    }

    void theTypedLimitGoesBeforeTheFiles() {
        QFETCH(std::optional<Seconds>, typed);
        QFETCH(std::optional<double>, in_file_h);
        QFETCH(double, limit_s);
        Mission mission;
        mission.limit_h = in_file_h;
        MissionOptions options;
        options.limit = typed;
        QCOMPARE(limitOf(options, mission).count(), limit_s);
    }

    void faultsNeedTheEmbeddedSimulator_data() {
        QTest::addColumn<bool>("server");
        QTest::addColumn<bool>("typed");
        QTest::addColumn<bool>("in_file");
        QTest::addColumn<bool>("possible");
        QTest::newRow("embedded, both") << false << true << true << true;
        QTest::newRow("a server, none") << true << false << false << true;
        QTest::newRow("a server, typed") << true << true << false << false;
        QTest::newRow("a server, in the file") << true << false << true << false;
    }

    void faultsNeedTheEmbeddedSimulator() {
        QFETCH(bool, server);
        QFETCH(bool, typed);
        QFETCH(bool, in_file);
        QFETCH(bool, possible);
        MissionOptions options;
        if (server)
            options.server = ServerAddress{"10.0.0.5", 3000};
        if (typed)
            options.faults << "wind";
        Mission mission;
        if (in_file)
            mission.faults = {"wind"};
        const auto checked = checkFaultsArePossible(options, mission);
        QCOMPARE(checked.has_value(), possible);
        if (!checked)
            QVERIFY(checked.error().text().starts_with("10.0.0.5: faults are possible only in the embedded simulator"));
    }

    void progressLinesTellStateSpeedAndTimeLeft() {
        Progress progress;
        progress.percent = 40.0;
        progress.speed_x = 120.0;
        progress.time_left = Seconds{1440.0};
        progress.state = "scanning lane 4 of 9";
        QCOMPARE(progressLine(progress, Seconds{8.0}),
                 std::string("[########------------]  40 %  scanning lane 4 of 9  120x  ETA 0:12"));
        progress.time_left_range = TimeRange{Seconds{1200.0}, Seconds{1680.0}};
        QCOMPARE(progressLine(progress, Seconds{8.0}),
                 std::string("[########------------]  40 %  scanning lane 4 of 9  120x  ETA 0:12 (0:10 to 0:14)"));
        progress = {};
        progress.percent = 250.0;
        progress.state = "done";
        QCOMPARE(progressLine(progress, Seconds{1.0}).substr(0, 28), std::string("[####################] 100 %"));
    }

    void timeLeftComesFromTheBehaviorElseFromThePercentage() {
        Progress progress;
        QVERIFY(!wallTimeLeft(progress, Seconds{10.0}));
        progress.percent = 25.0;
        QCOMPARE(wallTimeLeft(progress, Seconds{10.0})->count(), 30.0);
        progress.time_left = Seconds{100.0};
        progress.speed_x = 10.0;
        QCOMPARE(wallTimeLeft(progress, Seconds{10.0})->count(), 10.0);
    }

    void clocksReadAsClocks_data() {
        QTest::addColumn<double>("span_s");
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("nothing") << 0.0 << QByteArray("0:00");
        QTest::newRow("part of a second is one") << 0.2 << QByteArray("0:01");
        QTest::newRow("minutes") << 754.0 << QByteArray("12:34");
        QTest::newRow("hours") << 3723.0 << QByteArray("1:02:03");
        QTest::newRow("never negative") << -5.0 << QByteArray("0:00");
    }

    void clocksReadAsClocks() {
        QFETCH(double, span_s);
        QFETCH(QByteArray, text);
        QCOMPARE(QByteArray::fromStdString(countdownText(Seconds{span_s})), text);
    }
};

USAR_TEST(tst_MissionOptions)

} // namespace tst_mission_options

#include "tst_mission_options.moc"
